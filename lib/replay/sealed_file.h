// SPDX-License-Identifier: MIT
// Bytes that tell whether they are whole: a header of 32 bytes (kind, version, length, checksum;
// little endian), and then the bytes. A simulation and what belongs to it, as a file:
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
