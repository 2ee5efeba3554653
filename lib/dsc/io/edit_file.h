// SPDX-License-Identifier: MIT
// Logs of edits as text files: one record a line, and at the end how many there are. With the
// complex that a run began with, such a file is the run (operations/replay.h).
#pragma once

#include "dsc/complex/edit_log.h"
#include "dsc/io/part_file.h"

#include <span>
#include <string>
#include <vector>

namespace dsc {

/// A file that edits are written to as they are heard:
///
///     EditFile file("run.edits");
///     simulation.add_listener([&](std::span<const Edit> edits) { file.write(edits); });
///     ...
///     file.commit();
///
/// Until `commit` the file stands beside its place. Throws FileError.
class EditFile {
public:
    /// Opens the file beside its place.
    explicit EditFile(std::string path);
    /// Appends records.
    void write(std::span<const Edit> edits);
    /// Writes the number of records, and puts the file in its place. Nothing may be written
    /// afterwards.
    void commit();

private:
    PartFile file_;
    std::uint64_t count_ = 0;
};

/// Writes a whole log at once. The file exists as a whole or not at all. Throws FileError.
void write_edits(const std::string& path, std::span<const Edit> edits);

/// Reads a whole log. Throws FileError if the file is missing, is no log of edits, has a line that
/// is not a record (the error has the number of the line), or is cut off.
[[nodiscard]] std::vector<Edit> read_edits(const std::string& path);

} // namespace dsc
