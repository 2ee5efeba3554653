// SPDX-License-Identifier: MIT
// Files that exist as a whole or not at all: written as ".part" beside their place, then renamed.
#pragma once

#include "dsc/base/types.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace dsc {

/// Collects text and writes it in blocks. Numbers are written the same way under every locale.
/// Throws FileError where the folder is missing or unwritable, or the disk is full; a file that is
/// not committed is removed.
class PartFile : public Unmovable {
public:
    /// Opens `path` with ".part" added. Throws FileError.
    explicit PartFile(std::string path);
    ~PartFile();

    /// Appends a text as it is.
    PartFile& operator<<(std::string_view text);
    /// Appends a character.
    PartFile& operator<<(char c);
    /// The shortest text that reads back as the same number.
    template <class Number>
    requires std::is_arithmetic_v<Number> PartFile& operator<<(Number value) {
        return append(value);
    }
    /// With so many digits after the point.
    PartFile& fixed(double value, int digits) {
        return append(value, std::chars_format::fixed, digits);
    }

    /// How safe the content is before the file takes its place.
    enum class Until : std::uint8_t {
        written, ///< it survives the end of the program
        on_disk, ///< and a crash of the machine; takes milliseconds
    };
    /// Flushes, closes and renames. Nothing may be written afterwards.
    void commit(Until until = Until::written);

private:
    template <class... Arguments>
    PartFile& append(Arguments... arguments) {
        std::array<char, 512> text{}; // the largest double in fixed notation has 309 digits
        const auto end = std::to_chars(text.data(), text.data() + text.size(), arguments...).ptr;
        return *this << std::string_view(text.data(), static_cast<std::size_t>(end - text.data()));
    }
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
