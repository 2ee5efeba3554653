// SPDX-License-Identifier: MIT
// Logs of edits: repeated on the complex that they began with, and as text files. With that
// complex, such a file is the run.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/complex/edit_log.h"
#include "dsc/complex/submesh.h"
#include "dsc/io/part_file.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace dsc {

/// What became of the records.
struct ReplayReport {
    std::uint64_t done = 0;    ///< records that were repeated
    std::uint64_t skipped = 0; ///< records that name simplices that do not exist
};

/// Repeats a record of an operation that the core does not have: a `retriangulate`, an
/// `insert_triangle` or a `remove_triangle`. Returns false, and changes nothing, if its simplices
/// do not exist. The pool and the log are not read afterwards; the next triangle that the complex
/// gives out is the one that an `insert_triangle` names.
template <class Real>
using RepeatEdit = std::function<bool(const Submesh<Real>& submesh, const Edit& edit)>;

/// Repeats the edits without testing whether they are legal: the same simplices with the same ids,
/// so that handles in later records mean what they meant. A record whose simplices do not exist, or
/// differ from what the record says, is skipped; in an unbroken log none is. Vertex attributes are
/// blended as in the run. Whatever reads the journal learns of one `rebuild`. O(edits); O(mesh) for
/// each `renumber`, and once at the end for the pool of free ids. Throws InputError, and does
/// nothing, if a log has a `rebuild`, because it does not contain how the other mesh came about, or
/// a record that `others` would have to repeat, and there is none.
template <class Real>
ReplayReport replay(Complex<Real>& complex, std::span<const Edit> edits,
                    const RepeatEdit<Real>& others = {});

/// A text file that edits are written to as they are heard: one record a line,
/// and at the end how many there are.
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
