// SPDX-License-Identifier: MIT
#include "scenes/run/run.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/parallel/executors.h"
#include "dsc/quality/measures.h"
#include "measures/interface_outlines.h"
#include "measures/mesh_quality.h"
#include "replay/mesh_hash.h"
#include "scenes/file/excerpt.h"
#include "scenes/output/progress.h"
#include "scenes/run/clock.h"
#include "scenes/run/dsc_method.h"
#include "scenes/run/reference_run.h"
#include "scenes/run/standard_archive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dsc::scenes {

namespace {

/// Every triangle is checked after each step only in meshes with fewer triangles.
constexpr std::uint64_t few_triangles = 60000;
constexpr int seldom = 16;

/// The scene, its parameters and the division as a text: a checkpoint can only be resumed by a run
/// with the same text.
std::string identity_of(const RunResult& result) {
    return result.scene + text_of(result.parameters) + " strategy=" + to_string(result.strategy) +
           " submeshes=" + std::to_string(result.submeshes);
}

template <class Method>
class Runner {
public:
    Runner(const Setup& setup, const RunOptions& options, Method& method, RunResult& result)
        : setup_(setup), options_(options), method_(method), result_(result),
          frames_(options.frames, result.scene + "_" + to_string(options.strategy), setup),
          identity_(identity_of(result)),
          hash_first_(options.checkpoint.path.empty() && options.resume == nullptr
                          ? 0
                          : mesh_hash(method.complex())) {}

    void run() {
        if (options_.resume != nullptr) {
            go_on();
        } else {
            first();
            frame(0);
        }
        Progress progress(options_.progress, result_.steps, setup_.steps);
        for (int step = result_.steps + 1; step <= setup_.steps && result_.gave_up.empty();
             ++step) {
            if (is_interrupted()) {
                result_.interrupted = true;
                break;
            }
            // Multiplied, not summed, so that the last step ends exactly with the scene.
            const double begin = (step - 1) * setup_.dt;
            const double end = step * setup_.dt;
            begin_frame(step);
            method_.before_step();
            const Stopwatch watch;
            method_.step(begin, end, result_);
            const double wall_s = watch.wall();
            const double cpu_s = watch.cpu();
            if (setup_.fluid && !result_.gave_up.empty()) {
                frame(step); // shows the restored state, if a fluid's step failed
                break;
            }
            step_us_.push_back(wall_s * 1e6);
            result_.wall_s += wall_s;
            result_.cpu_s += cpu_s;
            method_.after_step();
            result_.threads_used = std::max(result_.threads_used, method_.threads_used());
            result_.steps = step;
            time_ = end;
            after(step);
            frame(step);
            const int every = options_.checkpoint.every;
            if (every > 0 && step % every == 0 && step < setup_.steps) {
                save();
            }
            progress.show(result_.scene, step, complex().triangle_count());
        }
        save();
        frames_.finish(result_.events);
        if constexpr (!std::is_same_v<Method, ReferenceMethod>) {
            if (!setup_.fluid || result_.gave_up.empty()) { // else the log contains an undone step
                method_.finish();
            }
        }
        last(step_us_);
    }

private:
    const auto& complex() { return method_.complex(); }

    [[nodiscard]] bool is_interrupted() const {
        return (options_.interrupted != nullptr && options_.interrupted->load()) ||
               (options_.stop_after > 0 && result_.steps >= options_.stop_after);
    }

    void observe(int step) {
        if constexpr (std::is_same_v<Method, DscMethod<double>>) {
            if (options_.observer) {
                options_.observer(step, method_.complex());
            }
        }
    }

    void begin_frame(int step) {
        if constexpr (!std::is_same_v<Method, ReferenceMethod>) {
            if (frames_.is_due(step)) {
                method_.begin_frame();
            }
        }
    }

    void frame(int step) {
        if (!frames_.is_due(step)) {
            return;
        }
        if constexpr (std::is_same_v<Method, ReferenceMethod>) {
            frames_.write(step, time_, complex(), {});
        } else {
            const std::string path = frames_.write(step, time_, complex(), method_.end_frame(step));
            if (step > 0) { // there are no submeshes before the first step
                method_.map_submeshes(path);
            }
        }
    }

    // Writes or reads the whole state of the run, its figures and its frames.
    void archive([[maybe_unused]] Archive& archive) {
        if constexpr (!std::is_same_v<Method, ReferenceMethod>) {
            expect_the_same(archive);
            archive(result_, step_us_, told_);
            expect_figures(archive);
            frames_.archive(archive);
            time_ = result_.steps * setup_.dt;
            method_.archive(archive, result_.steps);
        }
    }

    // Refuses the checkpoint of another run, or of one that began with another mesh.
    void expect_the_same(Archive& archive) const {
        std::string identity = identity_;
        std::uint64_t hash_first = hash_first_;
        archive(identity);
        if (identity != identity_) {
            archive.refuse("was written by another run: " + identity + "; this one is " +
                           identity_);
        }
        archive(hash_first);
        archive.expect(hash_first == hash_first_,
                       "began with another mesh: a file of the scene or the program has changed");
    }

    // Checks values that are used without further checks.
    void expect_figures(const Archive& archive) const {
        archive.expect(result_.steps >= 0 && result_.steps <= setup_.steps,
                       "has more steps than this run");
        archive.expect(result_.quality_sampled_every >= 1,
                       "has a bad sampling interval of the quality");
        bool are_complete = !result_.half || result_.half->size() == options_.measures.size();
        const std::size_t figures = series_measures_.size() + method_.fluid_now().size();
        for (const SeriesRow& row : result_.series) {
            are_complete = are_complete && row.figures.size() == figures;
        }
        archive.expect(are_complete, "contains other figures than this run");
    }

    void save() {
        if (options_.checkpoint.path.empty()) {
            return;
        }
        Archive state;
        archive(state);
        write_checkpoint(options_.checkpoint, state.bytes());
    }

    void go_on() {
        Archive state(options_.resume->state, options_.resume->path);
        archive(state);
        state.expect_end();
    }

    // The outlines, read as the scene's parameters say.
    std::vector<Outline> outlines() {
        return interface_outlines(
            complex(), {.reading = result_.parameters.interface.reading, .phase = setup_.measured});
    }

    Figures figures(const std::vector<Measure>& measures) {
        const auto read = outlines();
        const auto polygons = interface_outlines(complex(), {.phase = setup_.measured});
        std::optional<ExactShape> exact;
        if (options_.measure_shape && setup_.exact) {
            exact = setup_.exact(time_);
            if (std::isnan(exact->area)) {
                exact.reset();
            }
        }
        return measure(measures, {.mesh = &complex(),
                                  .outlines = read,
                                  .polygons = polygons,
                                  .exact = exact ? &*exact : nullptr,
                                  .area_exact_first = result_.area_exact_first});
    }

    void first() {
        result_.triangles_first = complex().triangle_count();
        result_.area_first = signed_area(outlines());
        result_.area_exact_first =
            setup_.exact ? setup_.exact(0.0).area : std::numeric_limits<double>::quiet_NaN();
        result_.min_quality_ever = 1;
        look_at_the_worst();
        result_.quality_sampled_every = result_.triangles_first <= few_triangles ? 1 : seldom;
        observe(0);
        add_to_series(0);
    }

    // Adds a row with the counts since the previous row.
    void add_to_series(int step) {
        const int every = options_.series_every;
        if (every <= 0 || (step % every != 0 && step != setup_.steps)) {
            return;
        }
        const PhaseReport phases = measure_phases(complex());
        SeriesRow row{.step = step,
                      .time = time_,
                      .triangles = complex().triangle_count(),
                      .interface_vertices = method_.interface_vertices(),
                      .phases = phases.phases.size(),
                      .figures = figures(series_measures_),
                      .operations = result_.operations,
                      .events = result_.events.size(),
                      .unreached = result_.unreached,
                      .wall_s = result_.wall_s};
        for (const PairFigures& pair : phases.pairs) {
            row.interface_length += pair.length;
        }
        if constexpr (!std::is_same_v<Method, ReferenceMethod>) {
            const Figures fluid = method_.fluid_now();
            row.figures.insert(row.figures.end(), fluid.begin(), fluid.end());
        }
        const SeriesRow so_far = row;
        for (auto& [name, count] : row.operations) {
            count -= told_.operations[name];
        }
        row.events -= told_.events;
        row.unreached -= told_.unreached;
        row.wall_s -= told_.wall_s;
        told_ = so_far;
        result_.series.push_back(std::move(row));
    }

    void look_at_the_worst() {
        const MeshQuality quality = method_.worst();
        result_.min_quality_ever = std::min(result_.min_quality_ever, quality.min_quality);
        result_.inverted += quality.inverted;
    }

    void after(int step) {
        if (step % result_.quality_sampled_every == 0) {
            look_at_the_worst();
        }
        if (setup_.half_step == step) {
            result_.half = figures(options_.measures);
        }
        observe(step);
        add_to_series(step);
    }

    void last(std::vector<double>& step_us) {
        result_.peak_memory_mb = peak_memory_mb();
        result_.triangles_last = complex().triangle_count();
        result_.mesh_hash = mesh_hash(complex());
        result_.interface_vertices_last = method_.interface_vertices();
        result_.last = figures(options_.measures);
        result_.area_ratio = signed_area(outlines()) / result_.area_first;
        if (setup_.growth && setup_.growth->discs) {
            const DiagramError error = diagram_error(complex(), *setup_.growth->discs, time_);
            result_.diagram = {{"wrong_area_last", error.wrong_area},
                               {"phase_error_last", error.phase_error},
                               {"seam_error_last", error.seam_max},
                               {"seam_error_rms_last", error.seam_rms},
                               {"junction_error_last", error.triple_max}};
        }
        if constexpr (!std::is_same_v<Method, ReferenceMethod>) {
            result_.attribute_error = method_.value_error();
            result_.fluid = method_.fluid_figures();
        }
        result_.phases = measure_phases(complex());
        result_.junctions = summarise(measure_junctions(complex()));
        look_at_the_worst();
        const double h = result_.parameters.h;
        const auto histogram = [&](double high, std::size_t bins, auto measure) {
            std::vector<double> values;
            for (const Triangle t : triangles(complex())) {
                values.push_back(static_cast<double>(measure(t)));
            }
            return make_histogram(values, 0, high, bins);
        };
        result_.area_histogram = histogram(3 * std::sqrt(3.0) / 4 * h * h, RunResult::area_bins,
                                           [&](Triangle t) { return area(complex(), t); });
        result_.quality_histogram = histogram(1, RunResult::quality_bins,
                                              [&](Triangle t) { return quality(complex(), t); });
        result_.angle_histogram = histogram(
            60, RunResult::angle_bins, [&](Triangle t) { return min_angle_deg(complex(), t); });
        if (!step_us.empty()) {
            result_.first_step_us = step_us.front();
            const auto half = step_us.begin() + static_cast<std::ptrdiff_t>(step_us.size() / 2);
            std::nth_element(step_us.begin(), half, step_us.end());
            result_.step_us_median = *half;
        }
    }

    const Setup& setup_;
    const RunOptions& options_;
    Method& method_;
    RunResult& result_;
    Frames frames_;
    double time_ = 0;
    std::vector<double> step_us_;
    std::string identity_;
    std::uint64_t hash_first_; ///< of the mesh before the first step
    std::vector<Measure> series_measures_ = series_measures();
    SeriesRow told_; ///< sums over all rows
};

template <class Method>
void run_method(const Setup& setup, const Parameters& parameters, const RunOptions& options,
                RunResult& result) {
    Method method(setup, parameters, options, &result.input);
    Runner<Method>(setup, options, method, result).run();
}

} // namespace

void check_usage(const Scene& scene, const Setup& setup, const Parameters& parameters,
                 const RunOptions& options) {
    const auto refuse = [](const char* what, const char* where, const std::string& value,
                           const std::string& allowed) {
        throw InputError({.what = what, .where = where, .value = value, .allowed = allowed});
    };
    const bool is_reference = options.strategy == Strategy::reference;
    const bool is_float = parameters.real != RealType::double_precision;
    if (!is_parallel(options.strategy) && options.submeshing.threads > 1) {
        const auto name = [](Strategy one) { return to_string(one); };
        refuse("this strategy runs on one thread", "--threads", to_text(options.submeshing.threads),
               "1, or one of the strategies " + name_list(parallel_strategies(), name));
    }
    if (setup.fluid && is_float) {
        refuse("fluids need double precision", "--set real", "'float'",
               "double for the scene " + scene.name);
    }
    if (is_reference && is_float) {
        refuse("the reference needs double precision", "--set real", "'float'", "double");
    }
    if (is_reference && (!options.checkpoint.path.empty() || options.resume != nullptr)) {
        refuse("the reference cannot write checkpoints", "--strategy", "'reference'",
               "another strategy");
    }
    if (is_reference && (setup.sees_interface() || !setup.advected.empty())) {
        refuse("the reference supports only interfaces that move by a velocity", "--strategy",
               "'reference'", "another strategy for the scene " + scene.name);
    }
}

RunResult run_scene(const Scene& scene, const Parameters& parameters, const RunOptions& options) {
    const Setup setup = scene.prepare(parameters);
    check_usage(scene, setup, parameters, options);
    RunResult result;
    result.scene = scene.name;
    result.parameters = parameters;
    result.parameters.dt = setup.dt;
    result.parameters.steps = scene.counts_steps_each_way ? setup.steps / 2 : setup.steps;
    result.strategy = options.strategy;
    result.submeshes = submeshes_of(options.strategy, options.submeshing);
    result.threads = options.submeshing.threads;
    if (options.strategy == Strategy::reference) {
        run_method<ReferenceMethod>(setup, parameters, options, result);
    } else if (parameters.real == RealType::double_precision) {
        run_method<DscMethod<double>>(setup, parameters, options, result);
    } else {
        run_method<DscMethod<float>>(setup, parameters, options, result);
    }
    return result;
}

} // namespace dsc::scenes
