// SPDX-License-Identifier: MIT
// Bytes with a checksum: a header of 32 bytes (kind, version, length, checksum; little endian), and
// then the bytes. A simulation and the state of its program, as a file:
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

#include <cstdint>
#include <string>

namespace dsc {

/// The kind of a file and the version of its layout.
struct SealedKind {
    std::string name;          ///< at most 8 bytes, padded with 0 in the file
    std::uint32_t version = 1; ///< version of the layout of the bytes; others are refused
};

/// Writes a part file, syncs it to the disk and renames it, so that an existing file is never
/// damaged. Throws FileError; InputError if `kind.name` does not have 1 to 8 bytes.
void write_sealed(const std::string& path, const SealedKind& kind, const std::string& bytes);

/// The bytes of such a file, to be stored elsewhere. Throws InputError as `write_sealed`.
[[nodiscard]] std::string sealed(const SealedKind& kind, const std::string& bytes);

/// The bytes that were sealed. Errors call them `name`. Throws FileError like `read_sealed`.
[[nodiscard]] std::string unsealed(std::string bytes, const SealedKind& kind,
                                   const std::string& name);

/// Reads the bytes back. Throws FileError if the file cannot be read, is of another kind or
/// version, is too short or too long, or its bytes have changed.
[[nodiscard]] std::string read_sealed(const std::string& path, const SealedKind& kind);

} // namespace dsc
