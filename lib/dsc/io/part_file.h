// SPDX-License-Identifier: MIT
// Atomic file writes: into a part file beside the destination, which is then renamed.
#pragma once

#include "dsc/base/types.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace dsc {

/// The destination of bytes that are written to a path.
struct Destination {
    std::string path;       ///< after all symbolic links, also of a file that is yet to be made
    bool is_stream = false; ///< a device, a pipe or an open descriptor: written to, never replaced
    int descriptor = -1;    ///< of this process, to which for instance /dev/stdout leads
};

/// Throws FileError for a folder, or a cycle of links.
[[nodiscard]] Destination destination_of(const std::string& path);

/// Collects text and writes it in blocks. Numbers are written the same way under every locale. The
/// file appears at `commit`; without it, no file remains. Of several writers of one path, the last
/// to commit wins. Streams are written to block by block. Throws FileError where the folder is
/// missing or unwritable, or the disk is full.
class PartFile : public Unmovable {
public:
    /// Makes the part file. Throws FileError.
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
    /// Appends a number with this many digits after the point.
    PartFile& fixed(double value, int digits) {
        return append(value, std::chars_format::fixed, digits);
    }

    /// The safety of the content before the file is renamed.
    enum class Until : std::uint8_t {
        written, ///< it survives the end of the program
        on_disk, ///< it also survives a crash of the machine; takes milliseconds
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
    void make_part();
    void write_block();
    [[noreturn]] void fail(const std::string& what, int error);

    std::string path_;
    Destination place_;
    std::string part_; ///< empty for a stream
    std::string buffer_;
    int descriptor_ = -1;
};

/// The text with &, <, > and quotes replaced, for XML.
[[nodiscard]] std::string escape_xml(std::string_view text);

} // namespace dsc
