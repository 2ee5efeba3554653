// SPDX-License-Identifier: MIT
#include "geometric_flows/curvature_flow.h"

#include "dsc/base/error.h"
#include "geometric_flows/curve_network.h"
#include "geometric_flows/kept_areas.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace dsc {

namespace {

std::pair<Phase, Phase> key_of(const PairCurvature& pair) {
    return std::minmax(pair.one, pair.other);
}

[[noreturn]] void refuse_forces(const std::string& what, const std::string& value,
                                const std::string& allowed) {
    throw InputError({.what = what, .where = "curvature_flow", .value = value, .allowed = allowed});
}

std::string name_of(const PairCurvature& pair) {
    return std::to_string(pair.one) + " and " + std::to_string(pair.other);
}

void check_forces(double tension, double mobility, const std::string& whose) {
    if (!std::isfinite(tension) || tension < 0) {
        refuse_forces("tension of " + whose + " is out of range", to_text(tension),
                      "finite and 0 or more");
    }
    if (!std::isfinite(mobility) || !(mobility > 0)) {
        refuse_forces("mobility of " + whose + " is out of range", to_text(mobility),
                      "finite and above 0");
    }
}

/// Checks the options, and sorts the lists.
CurvatureFlowOptions checked(CurvatureFlowOptions options) {
    check_forces(options.tension, options.mobility, "all pairs");
    for (const PairCurvature& pair : options.pairs) {
        check_forces(pair.tension, pair.mobility, "phases " + name_of(pair));
        if (pair.one == pair.other || pair.one == border_phase || pair.other == border_phase) {
            refuse_forces("there is no interface between these phases", name_of(pair),
                          "two different phases of the domain");
        }
    }
    std::ranges::sort(options.pairs, {}, key_of);
    const auto twice = std::ranges::adjacent_find(options.pairs, {}, key_of);
    if (twice != options.pairs.end()) {
        refuse_forces("a pair of phases is given twice", name_of(*twice), "each pair once");
    }
    std::ranges::sort(options.boundary_energies, {}, &BoundaryEnergy::phase);
    for (const BoundaryEnergy& one : options.boundary_energies) {
        if (one.phase == border_phase || !std::isfinite(one.energy)) {
            refuse_forces("invalid energy of the domain boundary under phase " +
                              std::to_string(one.phase),
                          to_text(one.energy), "a finite energy under a phase of the domain");
        }
    }
    const auto boundary_twice =
        std::ranges::adjacent_find(options.boundary_energies, {}, &BoundaryEnergy::phase);
    if (boundary_twice != options.boundary_energies.end()) {
        refuse_forces("a phase has two energies of the domain boundary",
                      std::to_string(boundary_twice->phase), "each phase once");
    }
    std::ranges::sort(options.kept_areas, {}, &KeptArea::phase);
    for (const KeptArea& kept : options.kept_areas) {
        if (kept.phase == exterior_phase || kept.phase == border_phase) {
            refuse_forces("the area of this phase cannot be kept", std::to_string(kept.phase),
                          "a phase of the domain other than the exterior");
        }
        if (!std::isfinite(kept.area) || !(kept.area > 0)) {
            refuse_forces("the area to be kept is out of range", to_text(kept.area),
                          "finite and above 0");
        }
    }
    const auto same = std::ranges::adjacent_find(options.kept_areas, {}, &KeptArea::phase);
    if (same != options.kept_areas.end()) {
        refuse_forces("an area is kept twice", std::to_string(same->phase), "each phase once");
    }
    return options;
}

EdgeForces forces_between(const CurvatureFlowOptions& options, Phase left, Phase right) {
    const std::pair<Phase, Phase> key = std::minmax(left, right);
    const auto found = std::ranges::lower_bound(options.pairs, key, {}, key_of);
    return found != options.pairs.end() && key_of(*found) == key
               ? EdgeForces{.tension = found->tension, .drag = 1 / found->mobility}
               : EdgeForces{.tension = options.tension, .drag = 1 / options.mobility};
}

double boundary_energy(const CurvatureFlowOptions& options, Phase phase) {
    const auto found =
        std::ranges::lower_bound(options.boundary_energies, phase, {}, &BoundaryEnergy::phase);
    return found != options.boundary_energies.end() && found->phase == phase ? found->energy : 0.0;
}

} // namespace

namespace detail {

/// One implicit step, including the areas that are kept.
struct CurvatureStep {
    CurveSystem system;
    AreaKeeper keeper;
    std::vector<Vector2> displacements;

    void begin(const CurveGraph& graph, std::span<const KeptArea> kept) {
        system.begin(graph);
        keeper.begin(graph, kept);
    }
    void make(std::span<const Vector2> start, double dt, const InShares& in_shares) {
        system.step(start, dt, in_shares, displacements, keeper.rows(start, in_shares));
        if (!keeper.look(start, displacements, in_shares)) {
            system.step(start, dt, in_shares, displacements);
            (void)keeper.look(start, displacements, in_shares);
        }
        keeper.shift(displacements, in_shares);
    }
};

/// The workspace of a call. Later calls reuse its memory.
struct CurvatureWork {
    CurveNetwork network;
    CurveGraph graph;
    CurvatureStep whole;
    CurvatureStep half;
    std::vector<Vector2> first;
    std::vector<Vector2> middle;

    /// The displacements of the network in dt, in `first`. One step and two of half the length;
    /// their errors of first order cancel in twice the second result minus the first, which still
    /// damps stiff modes. The step and the first half do not depend on each other.
    void extrapolate(std::span<const KeptArea> kept, double dt, const InShares& in_shares) {
        constexpr std::size_t few = 128; // vertices: fewer are done before another thread has begun
        const std::span<const Vector2> start = network.positions;
        const InShares& shares = start.size() < few ? one_by_one : in_shares;
        graph.begin(network);
        const auto make = [&](std::size_t i) {
            CurvatureStep& step = i == 0 ? whole : half;
            step.begin(graph, kept);
            step.make(start, i == 0 ? dt : dt / 2, one_by_one);
        };
        shares(2, std::cref(make));
        std::swap(first, half.displacements);
        middle.resize(start.size());
        for (std::size_t i = 0; i < middle.size(); ++i) {
            middle[i] = start[i] + first[i];
        }
        half.make(middle, dt / 2, shares);
        for (std::size_t i = 0; i < first.size(); ++i) {
            first[i] = 2 * (first[i] + half.displacements[i]) - whole.displacements[i];
        }
        (void)whole.keeper.look(start, first, shares);
        whole.keeper.shift(first, shares);
    }
};

/// A workspace left by an earlier call. Each call uses it, or makes a new one while another thread
/// uses it, so that simulations in different threads can share a flow.
class SpareWork {
public:
    SpareWork() = default;
    ~SpareWork() { delete kept_.load(); }
    SpareWork(const SpareWork&) = delete;
    SpareWork& operator=(const SpareWork&) = delete;
    SpareWork(SpareWork&&) = delete;
    SpareWork& operator=(SpareWork&&) = delete;

    std::unique_ptr<CurvatureWork> take() {
        std::unique_ptr<CurvatureWork> taken(kept_.exchange(nullptr));
        return taken ? std::move(taken) : std::make_unique<CurvatureWork>();
    }
    void give(std::unique_ptr<CurvatureWork> work) { delete kept_.exchange(work.release()); }

private:
    std::atomic<CurvatureWork*> kept_{nullptr};
};

} // namespace detail

template <class Real>
InterfaceMotion<Real> curvature_flow(const CurvatureFlowOptions& options) {
    return
        [options = checked(options), spare = std::make_shared<detail::SpareWork>()](
            const InterfaceView<Real>& view, Real, Real dt, std::span<Point<Real>> displacements) {
            std::unique_ptr<detail::CurvatureWork> work = spare->take();
            find_network(
                view, [&](Phase left, Phase right) { return forces_between(options, left, right); },
                [&](Phase phase) { return boundary_energy(options, phase); }, work->network);
            work->extrapolate(options.kept_areas, static_cast<double>(dt), view.in_shares);
            for (std::size_t i = 0; i < displacements.size(); ++i) {
                displacements[i] = {static_cast<Real>(work->first[i].x),
                                    static_cast<Real>(work->first[i].y)};
            }
            spare->give(std::move(work));
        };
}

template InterfaceMotion<double> curvature_flow(const CurvatureFlowOptions&);
template InterfaceMotion<float> curvature_flow(const CurvatureFlowOptions&);

} // namespace dsc
