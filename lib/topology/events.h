// SPDX-License-Identifier: MIT
// Events: the changes of topology that happened. Each is reported with the area that changed its
// phase, so that no area vanishes unreported.
#pragma once

#include "dsc/base/archive.h"
#include "dsc/base/names.h"
#include "dsc/base/types.h"

#include <functional>
#include <span>

namespace dsc {

/// The kind of a change.
enum class EventKind : std::uint8_t {
    merge, ///< a film opened: two pieces of the phase beyond it became one
    split, ///< a neck closed: the phase fell into two pieces there
    /// A film opened between two different phases, or between a phase and the domain boundary
    /// (`Event::taken` then has the same phase twice); they now border on each other.
    meet,
    widen,  ///< the film of an earlier event opened farther: along its seam, or elsewhere
    t1,     ///< an unstable junction split: some phases met, others separated
    fill,   ///< a small piece of the exterior vanished
    remove, ///< a small piece of another phase vanished (the T2 of foams and grains)
};

inline constexpr std::array event_names{
    Named{EventKind::merge, "merge"},   Named{EventKind::split, "split"},
    Named{EventKind::meet, "meet"},     Named{EventKind::widen, "widen"},
    Named{EventKind::t1, "t1"},         Named{EventKind::fill, "fill"},
    Named{EventKind::remove, "remove"},
};

[[nodiscard]] constexpr std::string_view to_string(EventKind kind) {
    return name_in(event_names, kind);
}

/// One change of topology.
struct Event {
    EventKind kind = EventKind::merge; ///< what happened
    double time = 0;                   ///< at the end of the sub-step
    double x = 0;                      ///< position, in units of the domain
    double y = 0;
    Phase lost = exterior_phase; ///< the phase whose area it was
    /// The phases that took the area; the same twice unless different ones took it. Of a
    /// small piece that several share: twice the one that it bordered on most.
    std::array<Phase, 2> taken = {};
    double area = 0; ///< that changed its phase
};

inline void archive(Archive& archive, Event& event) {
    archive.choice(event.kind, event_names.size());
    archive(event.time, event.x, event.y, event.lost, event.taken, event.area);
}

/// How much area was given back to the phases that lost it, if the options ask for that.
struct AreaAccount {
    double given_back = 0; ///< in squared units of the domain
    double owed = 0;       ///< could not be given back: the two phases no longer have a common
                           ///< interface nearby

    AreaAccount& operator+=(const AreaAccount& other) {
        given_back += other.given_back;
        owed += other.owed;
        return *this;
    }
};

inline void archive(Archive& archive, AreaAccount& account) {
    archive(account.given_back, account.owed);
}

/// Receives events in the order in which they happened, which does not depend on threads. Called by
/// the thread that calls `Simulation::step`, between sub-steps.
using EventListener = std::function<void(std::span<const Event> events)>;

} // namespace dsc
