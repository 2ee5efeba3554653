// SPDX-License-Identifier: MIT
// Files that exist as a whole or not at all: written as ".part" beside their place, then renamed. A
// sealed file can also tell whether it is whole: it has a header of 32 bytes (kind, version,
// length, checksum; little endian), and then the bytes. A simulation and what belongs to it:
//
//     Archive archive;
//     simulation.archive(archive);
//     archive(step);
//     write_sealed("run.checkpoint", {"my-run", 1}, archive.bytes());
//     ...
//     Archive again(read_sealed("run.checkpoint", {"my-run", 1}), "run.checkpoint");
//     simulation.archive(again);
//     again(step);
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

/// What a file holds, and in which form.
struct SealedKind {
    std::string name;          ///< at most 8 bytes, the rest of which are 0 in the file
    std::uint32_t version = 1; ///< of the layout of the bytes; other versions are refused
};

/// Writes the file beside its place, syncs it to the disk and renames it, so that an existing file
/// stays whole whatever happens. Throws FileError; InputError if `kind.name` has not 1 to 8 bytes.
void write_sealed(const std::string& path, const SealedKind& kind, const std::string& bytes);

/// The bytes of such a file, for what is kept elsewhere. Throws InputError as `write_sealed`.
[[nodiscard]] std::string sealed(const SealedKind& kind, const std::string& bytes);

/// What was sealed. `name` is what errors call it; throws FileError as `read_sealed`.
[[nodiscard]] std::string unsealed(std::string bytes, const SealedKind& kind,
                                   const std::string& name);

/// Reads the bytes back. Throws FileError if the file cannot be read, is of another kind or
/// version, is too short or too long, or its bytes have changed.
[[nodiscard]] std::string read_sealed(const std::string& path, const SealedKind& kind);

} // namespace dsc
