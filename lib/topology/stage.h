// SPDX-License-Identifier: MIT
// Changes of topology as a stage of a simulation.
#pragma once

#include "dsc/algorithm/simulation.h"
#include "dsc/algorithm/stage.h"
#include "dsc/passes/algorithm.h"
#include "topology/candidates.h"
#include "topology/events.h"
#include "topology/notes.h"
#include "topology/options.h"
#include "topology/region.h"

#include <utility>
#include <vector>

namespace dsc {

/// Phases that meet, merge and split:
/// `simulation.add_stage(std::make_shared<TopologyStage<double>>( TopologyOptions<double>{.rule =
/// Topology::change}))`. A stage belongs to one simulation at a time and is not thread-safe.
template <class Real>
class TopologyStage final : public Stage<Real> {
public:
    /// Throws InputError if an option is out of range.
    explicit TopologyStage(TopologyOptions<Real> options);

    /// The options, valid from the next sub-step on.
    [[nodiscard]] const TopologyOptions<Real>& options() const { return options_; }
    /// Replaces the options between two steps. Throws InputError if one is out of range, or a new
    /// contact distance wider than a phase (contact_check.h), and then keeps the old ones.
    void set_options(TopologyOptions<Real> options);

    /// Reports events to the listener from now on, after the sub-step in which they happen.
    void add_listener(EventListener listener) { listeners_.push_back(std::move(listener)); }
    /// The events since the last call, in the order in which they happened. Events are kept until
    /// they are taken.
    [[nodiscard]] std::vector<Event> take_events();
    /// The area of these events that was given back, and that is owed, since the last call: see
    /// `TopologyOptions::gives_back_area`.
    [[nodiscard]] AreaAccount take_area();

    // --- called by the simulation
    void check(const Complex<Real>& complex, const Options<Real>& options) const override;
    void begin(Complex<Real>& complex, const Options<Real>& options) override;
    [[nodiscard]] std::optional<Pass<Real>> pass() override;
    void run(const Between<Real>& between) override;
    void run_again(const Between<Real>& between) override;
    void tell() override;
    void archive(Archive& archive) override;

private:
    void find_curvature();
    void run_round(const Between<Real>& between, std::uint32_t round, bool is_again);

    TopologyOptions<Real> options_;
    Complex<Real>* complex_ = nullptr; ///< of the simulation; null before there is one
    VertexAttribute<Note>* notes_ = nullptr;
    VertexAttribute<NotedPlace<Real>>* places_ = nullptr;
    Real edge_length_ = 0;
    Real curvature_ = 0;                ///< from which on a star is noted; 0: no topology changes
    std::uint32_t round_ = 2;           ///< of the next notes; 0: a vertex without a note
    std::vector<Candidate> candidates_; ///< scratch of run
    std::vector<Missed<Real>> missed_;  ///< of this sub-step
    std::vector<Event> events_;
    std::size_t told_ = 0; ///< of these
    AreaAccount area_;
    std::vector<EventListener> listeners_;
};

} // namespace dsc
