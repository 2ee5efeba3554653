// SPDX-License-Identifier: MIT
// A text file that exists as a whole or not at all: written as ".part" beside its place, then
// renamed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace dsc {

/// Collects text and writes it in blocks. Numbers are written the same way under every locale.
/// Throws FileError where the folder is missing or unwritable, or the disk is full; a file that is
/// not committed is removed.
class PartFile {
public:
    /// Opens `path` with ".part" added. Throws FileError.
    explicit PartFile(std::string path);
    ~PartFile();
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    /// Appends a text as it is.
    PartFile& operator<<(std::string_view text);
    /// Appends a character.
    PartFile& operator<<(char c);
    /// The shortest text that reads back as the same number.
    PartFile& operator<<(double value);
    /// The shortest text that reads back as the same number.
    PartFile& operator<<(float value);
    /// Decimal digits.
    PartFile& operator<<(std::uint64_t value);
    /// Decimal digits.
    PartFile& operator<<(std::uint32_t value);
    /// With so many digits after the point.
    PartFile& fixed(double value, int digits);

    /// How safe the content is before the file takes its place.
    enum class Until : std::uint8_t {
        written, ///< it survives the end of the program
        on_disk, ///< and a crash of the machine; takes milliseconds
    };
    /// Flushes, closes and renames. Nothing may be written afterwards.
    void commit(Until until = Until::written);

private:
    void write_block();
    [[noreturn]] void fail(const std::string& what, int error);

    std::string path_;
    std::string part_;
    std::string buffer_;
    int descriptor_ = -1;
};

/// The text with &, <, > and quotes replaced, for XML.
[[nodiscard]] std::string escape_xml(std::string_view text);

} // namespace dsc
