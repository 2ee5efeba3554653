// SPDX-License-Identifier: MIT
// What a work carries from one step to the next, as bytes.
#pragma once

#include "dsc/complex/complex_archive.h"
#include "dsc/passes/work.h"

namespace dsc {

/// The interface, the active set and what else waits for the next step; everything else of a work
/// is scratch, or empty between two steps. To be called after the complex has been read: throws
/// FileError for an id that it does not have.
template <class Real>
void archive(Archive& archive, Work<Real>& work) {
    archive(work.interface, work.active, work.resized, work.epoch, work.time, work.dt);
    for (const auto* list : {&work.interface, &work.active, &work.resized}) {
        expect_vertices<Real>(archive, work.complex, *list);
    }
    for (const std::uint32_t v : work.interface) {
        archive.expect(work.complex.is_alive(Vertex{v}), "lists a vertex that does not live");
    }
}

} // namespace dsc
