// SPDX-License-Identifier: MIT
// Logs of edits: repeated on the complex that they began with, and as text files. Complex and log
// together reproduce a run.
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

/// How many records were repeated.
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
/// so that handles in later records stay valid. A record whose simplices do not exist, or differ
/// from what the record says, is skipped; in an unbroken log none is. Vertex attributes are blended
/// as in the run. Marks of vertices (`Complex::set_locked`, `set_feature`, `set_boundary_feature`)
/// are no edits: they stay as they are in the complex that is given, and what was marked or
/// unmarked during the run, such as the ends of a fluid's sides in its first step, has to be marked
/// again. Readers of the journal find one `rebuild`. O(edits); O(mesh) for each `renumber`, and
/// once at the end for the pool of free ids. Throws InputError, and does nothing, if a log has a
/// `rebuild`, because it does not contain the other mesh, or has a record that needs `others` and
/// there is no such function.
template <class Real>
ReplayReport replay(Complex<Real>& complex, std::span<const Edit> edits,
                    const RepeatEdit<Real>& others = {});

/// A text file to which edits are written as they are reported: one record a line, and at the end
/// their number.
///
///     EditFile file("run.edits");
///     simulation.add_listener([&](std::span<const Edit> edits) { file.write(edits); });
///     ...
///     file.commit();
///
/// Until `commit` it is a part file beside its destination. Throws FileError.
class EditFile {
public:
    /// Opens the part file.
    explicit EditFile(std::string path);
    /// Appends records.
    void write(std::span<const Edit> edits);
    /// Writes the number of records, and renames the part file. Nothing may be written afterwards.
    void commit();

private:
    PartFile file_;
    std::uint64_t count_ = 0;
};

/// Writes a whole log at once, atomically. Throws FileError.
void write_edits(const std::string& path, std::span<const Edit> edits);

/// Reads a whole log. Throws FileError if the file is missing, is not a log of edits, has a line
/// that is not a record (the error names its number), or is cut off.
[[nodiscard]] std::vector<Edit> read_edits(const std::string& path);

} // namespace dsc
