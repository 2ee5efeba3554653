// SPDX-License-Identifier: MIT
#include "thesis/operations/replay.h"

#include "thesis/operations/local_retriangulation.h"
#include "thesis/sets/insertion_removal.h"

#include "dsc/base/error.h"
#include "dsc/base/verdict.h"

#include <algorithm>
#include <array>

namespace dsc {

namespace {

// By ear clipping alone: flips after it have their own records. Locks are not edits, so the log
// does not record that a vertex was unlocked before it vanished.
template <class Real>
bool retriangulate(const Submesh<Real>& submesh, Triangle t) {
    Complex<Real>& complex = submesh.complex;
    if (!complex.is_alive(t)) {
        return false;
    }
    const auto v = complex.vertices_of(t);
    std::array<bool, 3> locked{};
    for (std::size_t i = 0; i < 3; ++i) {
        locked[i] = complex.is_locked(v[i]);
        complex.set_locked(v[i], false);
    }
    const bool done = local_retriangulation(submesh, t).verdict == Verdict::legal;
    for (std::size_t i = 0; i < 3; ++i) {
        if (complex.is_alive(v[i])) {
            complex.set_locked(v[i], locked[i]);
        }
    }
    return done;
}

} // namespace

template <class Real>
bool repeat_edit(const Submesh<Real>& submesh, const Edit& edit) {
    Complex<Real>& complex = submesh.complex;
    const Triangle t{triangle_of(edit.corner)};
    const std::array v{edit.ends[0], edit.ends[1], edit.apexes[0]};
    switch (edit.kind) {
    case EditKind::retriangulate: return retriangulate(submesh, t);
    case EditKind::insert_triangle:
        if (!std::ranges::all_of(v, [&](Vertex one) { return complex.is_alive(one); })) {
            return false;
        }
        try {
            insert_triangle(complex, v[0], v[1], v[2], edit.made[0]);
        } catch (const InputError&) {
            return false; // skipped records leave no room for it
        }
        return true;
    case EditKind::remove_triangle:
        if (!complex.is_alive(t) || complex.vertices_of(t) != v) {
            return false;
        }
        remove(complex, SimplexSet({}, {}, {t}));
        return true;
    default: return false;
    }
}

template bool repeat_edit(const Submesh<double>&, const Edit&);
template bool repeat_edit(const Submesh<float>&, const Edit&);

} // namespace dsc
