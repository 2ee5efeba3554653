// SPDX-License-Identifier: MIT
// The log as the message: what a submesh did to the mesh, in a few bytes for each edit, and done
// again on the other ranks with the same ids. Nothing is searched for or decided there, so it takes
// a small part of the time of the submesh itself; attributes are told of each edit as they were in
// the submesh.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/parallel/ranks/message.h"

#include <span>

namespace dsc {

/// Appends the edits. Throws InvariantError for an edit that no pass of a submesh may make.
template <class Real>
void write_edits(MessageWriter& message, std::span<const Edit> edits);

/// Makes the edits again. Ids that become free are left to the caller, who knows whose they are;
/// ids of new simplices must exist. `log` gets the records if it has a reader. Throws
/// InvariantError if the complex is not the one that they were made in.
template <class Real>
void repeat_edits(MessageReader& message, Complex<Real>& complex, EditLog& log);

} // namespace dsc
