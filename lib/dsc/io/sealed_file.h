// SPDX-License-Identifier: MIT
// Bytes in a file that can tell whether it is whole: a header of 32 bytes (kind, version, length,
// checksum; little endian), then the bytes. A simulation and what belongs to it:
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
    std::uint32_t version = 1; ///< of the form of the bytes; files of another one are refused
};

/// Written beside its place, brought to the disk and renamed: whatever happens in between, the file
/// that was there before stays whole. Throws FileError; InputError for a name of another length.
void write_sealed(const std::string& path, const SealedKind& kind, const std::string& bytes);

/// Throws FileError where the file cannot be read, is of another kind or version, is cut off or
/// continued, or its bytes have changed.
[[nodiscard]] std::string read_sealed(const std::string& path, const SealedKind& kind);

/// The checksum: FNV-1a over words of eight bytes and what remains. O(size).
[[nodiscard]] std::uint64_t checksum(const std::string& bytes);

} // namespace dsc
