// SPDX-License-Identifier: MIT
// The life of a simulation between its steps: options, stages, listeners, edits of the application,
// archives. A step itself is in step.cpp.
#include "dsc/algorithm/simulation.h"

#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/stage.h"
#include "dsc/base/error.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/interface/list.h"
#include "dsc/passes/mesh/size_update.h"
#include "dsc/passes/readers.h"
#include "dsc/sizes/sizes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <utility>

namespace dsc {

namespace {

// O(vertices).
template <class Real>
void check_for(const Complex<Real>& complex, const Options<Real>& options) {
    check_options(options);
    const auto extent = static_cast<double>(extent_of(complex));
    require(complex.vertex_count() == 0 || static_cast<double>(options.edge_length) <= extent,
            "edge_length", static_cast<double>(options.edge_length),
            "up to " + to_text(extent) + ", the larger side of the mesh");
}

} // namespace

template <class Real>
Simulation<Real>::Simulation(Complex<Real>& complex, const Options<Real>& options)
    : Simulation(complex, options, nullptr) {}

template <class Real>
Simulation<Real>::Simulation(Complex<Real>& complex, const Options<Real>& options,
                             std::unique_ptr<Executor<Real>> executor)
    : complex_(complex), claim_(complex.in_use), options_(options), executor_(std::move(executor)),
      reading_(complex.journal), absorbed_(complex.journal.records.size()) {
    check_for(complex, options);
    begin_integrator();
    if (executor_) {
        if (&executor_->complex() != &complex) {
            throw InputError({.what = "the executor belongs to another complex",
                              .where = "Simulation",
                              .value = "an executor made for another complex",
                              .allowed = "one made by make_executor for this complex"});
        }
        executor_->set_options(completed());
        // Edits of the application since the executor was made are in no journal.
        executor_->absorb(std::array{Edit{.kind = EditKind::rebuild}});
    } else {
        executor_ =
            std::make_unique<Executor<Real>>(complex, completed(), default_algorithm<Real>());
    }
    mark_features(complex, interface(), options.interface.feature_degrees,
                  static_cast<Real>(feature_arc) *
                      finest_on_interface(options.sizes, options.edge_length));
    measure(0);
}

template <class Real>
Simulation<Real>::~Simulation() {
    for (const auto& stage : stages_) {
        stage->has_simulation_ = false;
    }
}

template <class Real>
void Simulation<Real>::set_options(const Options<Real>& options) {
    expect_between_steps("Simulation::set_options");
    check_for(complex_, options);
    for (const auto& stage : stages_) {
        stage->check(complex_, options);
    }
    const Options<Real> before = std::exchange(options_, options);
    try {
        begin_options(before);
    } catch (...) { // a function of the new options threw, or returned no length
        options_ = before;
        begin_options(options);
        throw;
    }
    if (options.integrator != before.integrator ||
        options.custom_integrator != before.custom_integrator) {
        forget();
    }
}

// Adapts the integrator, executor, stages and edge lengths to new options.
template <class Real>
void Simulation<Real>::begin_options(const Options<Real>& before) {
    begin_integrator();
    executor_->set_options(completed());
    for (const auto& stage : stages_) {
        stage->begin(complex_, options_);
    }
    if (!before.sizes.is_uniform()) {
        executor_->resize(out_of_size(complex_, options_)); // sizes may have become uniform
    }
    measure(0);
}

// While a step runs, calls are refused that replace its data or add to its lists.
template <class Real>
void Simulation<Real>::expect_between_steps(const char* where) const {
    if (is_in_step_) {
        throw InputError({.what = "a step of this simulation is running",
                          .where = where,
                          .value = "a call by its flow, a stage or a listener",
                          .allowed = "calls between two steps"});
    }
}

template <class Real>
void Simulation<Real>::begin_integrator() {
    if (options_.custom_integrator) {
        options_.custom_integrator->begin(complex_);
    }
}

// Without `sizes.longest`, the extent of the mesh is the bound: in a mesh without an interface,
// targets would grow for ever.
template <class Real>
Options<Real> Simulation<Real>::completed() const {
    Options<Real> options = options_;
    if (!options.sizes.is_uniform() && options.sizes.longest == 0) {
        options.sizes.longest = std::max(extent_of(complex_), options.edge_length);
    }
    return options;
}

// Measures the targets of all edges, unless sizes are uniform. O(mesh).
template <class Real>
void Simulation<Real>::measure(Real time) {
    if (!options_.sizes.is_uniform()) {
        measure_sizes(complex_, completed().sizes, options_.edge_length, time);
        executor_->resize(out_of_size(complex_, options_));
    }
}

// The slow sweep: visits all vertices in turn, a few in each step. Flips and smoothing nearby may
// change the target of a vertex that no pass visits; without the sweep, a single stale target would
// limit all those around it. Most vertices of a graded mesh are near the interface and visited
// anyway.
template <class Real>
void Simulation<Real>::sweep() {
    constexpr std::uint32_t steps = 32; // for the whole mesh
    const std::uint32_t bound = complex_.vertex_bound();
    to_sweep_.clear();
    for (std::uint32_t i = 0; i < bound / steps + 1; ++i, ++swept_) {
        swept_ = swept_ < bound ? swept_ : 0;
        if (complex_.is_alive(Vertex{swept_})) {
            to_sweep_.push_back(swept_);
        }
    }
    executor_->resize(to_sweep_);
}

template <class Real>
void Simulation<Real>::add_listener(EditListener listener) {
    expect_between_steps("Simulation::add_listener");
    listeners_.push_back(std::move(listener));
    executor_->keep_edits(true);
}

template <class Real>
void Simulation<Real>::add_stage(std::shared_ptr<Stage<Real>> stage) {
    expect_between_steps("Simulation::add_stage");
    if (stage == nullptr) {
        throw InputError({.what = "null stage",
                          .where = "Simulation::add_stage",
                          .value = "null",
                          .allowed = "an object of a class derived from Stage"});
    }
    if (stage->has_simulation_) {
        throw InputError({.what = "this stage already belongs to a simulation",
                          .where = "Simulation::add_stage",
                          .value = "a stage added before",
                          .allowed = "a separate stage for each simulation"});
    }
    stage->check(complex_, options_);
    stage->begin(complex_, options_);
    if (const auto pass = stage->pass()) {
        executor_->add_remeshing(*pass);
    }
    stages_.push_back(std::move(stage));
    stages_.back()->has_simulation_ = true;
}

// Calls all listeners, also those after one that throws, because a log of edits must have no gaps.
template <class Real>
void Simulation<Real>::tell(std::span<const Edit> edits) {
    if (edits.empty()) {
        return;
    }
    std::exception_ptr thrown;
    for (const EditListener& listener : listeners_) {
        try {
            listener(edits);
        } catch (...) {
            thrown = thrown ? thrown : std::current_exception();
        }
    }
    if (thrown) {
        std::rethrow_exception(thrown);
    }
}

template <class Real>
void Simulation<Real>::tell_what_was_done() {
    if (!listeners_.empty()) {
        tell(executor_->take_edits());
    }
}

// Absorbs the edits of the application since the last step, or of the stage that has just run.
// O(edits).
template <class Real>
void Simulation<Real>::absorb(By by, Real time) {
    EditLog& journal = complex_.journal;
    if (absorbed_ == journal.records.size()) {
        return;
    }
    // Copies the edits, because listeners and stages may edit the complex.
    const std::size_t seen = journal.records.size();
    const auto first = journal.records.begin();
    absorbing_.assign(first + static_cast<std::ptrdiff_t>(absorbed_), journal.records.end());
    const std::span<const Edit> edits(absorbing_);
    executor_->absorb(edits);
    const auto after = edits_after_renumbering(edits);
    if (after.size() != edits.size()) { // attributes may be others
        begin_integrator();
        for (const auto& stage : stages_) {
            stage->begin(complex_, options_);
        }
        measure(time);
    }
    // A sharp turn in a new interface edge of the application is a feature from now on. The sharp
    // turn at the end of a seam, which a stage makes, is not.
    if (by == By::application) {
        mark_features(complex_, on_interface(complex_, interface_changes(after)),
                      options_.interface.feature_degrees,
                      static_cast<Real>(feature_arc) *
                          finest_on_interface(options_.sizes, options_.edge_length));
    }
    // A vertex that now lies between other phases moves differently, so an integrator must forget
    // its past.
    if (options_.custom_integrator) {
        forget_past(interface_changes(after));
    }
    for (const Edit& edit : after) {
        if (edit.kind == EditKind::move && complex_.is_alive(edit.vertex)) {
            // The targets that the vertex missed no longer count either.
            complex_.vertices[edit.vertex.id].flags &= ~static_cast<std::uint32_t>(vertex_contact);
            forget_past(std::span(&edit.vertex.id, 1));
        }
    }
    absorbed_ = seen;
    if (journal.readers == 1) {
        journal.records.erase(journal.records.begin(),
                              journal.records.begin() + static_cast<std::ptrdiff_t>(seen));
        absorbed_ = 0;
    }
    tell(
        edits); // last, because a listener may throw; edits are then not absorbed or reported twice
}

template <class Real>
void Simulation<Real>::forget_past(std::span<const std::uint32_t> vertices) {
    if (options_.custom_integrator) {
        options_.custom_integrator->forget(complex_, vertices);
    }
}

template <class Real>
std::vector<std::uint32_t> Simulation<Real>::interface() const {
    return options_.advected_phases.empty() ? moved() : on_interface(complex_, moved());
}

template <class Real>
std::size_t Simulation<Real>::interface_size() const {
    return options_.advected_phases.empty() ? executor_->interface_size() : interface().size();
}

template <class Real>
void Simulation<Real>::watch_quality(double quality) {
    executor_->watch_quality(quality);
}

template <class Real>
std::span<const std::uint32_t> Simulation<Real>::take_poor() {
    return executor_->take_poor();
}

// Lists the vertices that the flow moves.
template <class Real>
std::vector<std::uint32_t> Simulation<Real>::moved() const {
    std::vector<std::uint32_t> list;
    list.reserve(executor_->interface_size());
    executor_->append_interface(list);
    return list;
}

template <class Real>
void Simulation<Real>::forget() {
    max_dt_ = std::numeric_limits<Real>::infinity();
    if (options_.custom_integrator) {
        forget_past(moved());
    }
}

template <class Real>
void Simulation<Real>::archive(Archive& archive) {
    expect_between_steps("Simulation::archive");
    as_a_whole(archive, [this](Archive& each) { transfer(each); });
}

template <class Real>
void Simulation<Real>::transfer(Archive& archive) {
    archive(complex_, fastest_, max_dt_, swept_);
    std::uint64_t absorbed = absorbed_;
    archive(absorbed);
    archive.expect(absorbed <= complex_.journal.records.size(),
                   "more edits read than the journal holds");
    absorbed_ = static_cast<std::size_t>(absorbed);
    executor_->archive(archive);
    for (const auto& stage : stages_) {
        stage->archive(archive);
    }
}

template class Simulation<double>;
template class Simulation<float>;

} // namespace dsc
