// SPDX-License-Identifier: MIT
#include "scenes/space/run.h"

#include "dsc/base/names.h"
#include "dsc3/dsc3.h"
#include "scenes/keys.h"
#include "scenes/output/progress.h"
#include "scenes/run/clock.h"
#include "scenes/run/standard_archive.h"
#include "scenes/space/measure.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace dsc::scenes::space {

namespace {

void add(dsc3::StepReport& sum, const dsc3::StepReport& step) {
    sum.sub_steps += step.sub_steps;
    sum.passes += step.passes;
    sum.unreached += step.unreached;
    sum.held += step.held;
    sum.unjammed += step.unjammed;
    sum.moves += step.moves;
    sum.treated += step.treated;
    sum.treated_together += step.treated_together;
    sum.gave_up = step.gave_up;
    sum.operations += step.operations;
}

dsc3::Options options_of(const Parameters& parameters) {
    dsc3::Options options;
    options.edge_length = parameters.h;
    const auto integrator = value_in(integrator_names, to_string(parameters.integrator));
    if (!integrator) {
        throw InputError({.what = "no such integrator in three dimensions",
                          .where = "integrator",
                          .value = std::string(to_string(parameters.integrator)),
                          .allowed = names_in(integrator_names)});
    }
    options.integrator = *integrator;
    return options;
}

std::unique_ptr<dsc3::Simulation> make_simulation(dsc3::Complex& complex,
                                                  const dsc3::Options& options,
                                                  const std::optional<dsc3::Parallel>& parallel) {
    return parallel ? std::make_unique<dsc3::Simulation>(complex, options, *parallel)
                    : std::make_unique<dsc3::Simulation>(complex, options);
}

scenes::Setup times_of(const Setup& setup) {
    scenes::Setup times;
    times.steps = setup.steps;
    times.dt = setup.dt;
    times.half_step = setup.half_step;
    return times;
}

void archive_report(Archive& archive, dsc3::StepReport& sum) {
    dsc3::OperationCounts& done = sum.operations;
    archive(sum.sub_steps, sum.passes, sum.unreached, sum.held, sum.unjammed, sum.moves,
            sum.treated, sum.treated_together, done.splits, done.collapses, done.edge_removals,
            done.face_flips, done.smoothings, done.interface_splits, done.interface_collapses,
            done.interface_flips, done.reassigned);
}

void archive_quality(Archive& archive, dsc3::MeshQuality& quality) {
    archive(quality.worst, quality.min_dihedral, quality.max_dihedral, quality.min_face_angle);
}

class Run {
public:
    Run(const Scene& scene, const Parameters& parameters, const RunOptions& options)
        : setup_(scene.prepare(parameters)), times_(times_of(setup_)),
          frames_(options.frames, scene.name, times_), options_(options),
          complex_(
              dsc3::initial_complex(setup_.domain, setup_.shapes, {.edge_length = parameters.h})),
          simulation_(make_simulation(complex_, options_of(parameters), options.parallel)),
          hash_first_(dsc3::mesh_hash(complex_)) {
        result_.scene = scene.name;
        result_.euler_exact_first = setup_.euler_first;
        result_.parameters = parameters;
        result_.keys = scene.keys;
        result_.parallel = options.parallel;
    }

    RunResult run() {
        if (options_.resume != nullptr) {
            Archive state(options_.resume->state, options_.resume->path);
            archive(state);
            state.expect_end();
        } else {
            result_.tets_first = complex_.tet_count();
            result_.volume_first = volume();
            if (setup_.euler_first) {
                result_.euler_first = euler_characteristic();
            }
            write_frame();
        }
        if (ends_on_sides()) { // the shape is cut off there: its exact figures are not known
            setup_.volume_last = setup_.last ? result_.volume_first : 0;
            result_.euler_first.reset();
            result_.euler_exact_first.reset();
        }
        Progress progress(options_.progress, result_.steps, setup_.steps);
        while (result_.steps < setup_.steps && result_.sum.gave_up == dsc3::GiveUp::none) {
            if (is_interrupted()) {
                result_.interrupted = true;
                break;
            }
            step();
            write_frame();
            const int every = options_.checkpoint.every;
            if (every > 0 && result_.steps % every == 0 && result_.steps < setup_.steps) {
                save();
            }
            progress.show(result_.scene, result_.steps, complex_.tet_count(), "tets");
        }
        save();
        frames_.finish({});
        measure_end();
        return std::move(result_);
    }

private:
    [[nodiscard]] bool ends_on_sides() const {
        const auto interface = simulation_->interface();
        return std::any_of(interface.begin(), interface.end(),
                           [&](std::uint32_t v) { return complex_.is_boundary(dsc3::Vertex{v}); });
    }
    // Of an interface between two phases, each edge of which has two faces.
    [[nodiscard]] std::int64_t euler_characteristic() const {
        return static_cast<std::int64_t>(simulation_->interface().size()) -
               static_cast<std::int64_t>(dsc3::interface_faces(complex_).size() / 2);
    }
    [[nodiscard]] double volume() const {
        return dsc3::phase_volume(complex_, setup_.shapes.front().phase);
    }
    [[nodiscard]] bool is_interrupted() const {
        return (options_.interrupted != nullptr && options_.interrupted->load()) ||
               (options_.stop_after > 0 && result_.steps >= options_.stop_after);
    }

    void step() {
        const Stopwatch watch;
        const dsc3::StepReport step =
            simulation_->step(setup_.velocity, result_.steps * setup_.dt, setup_.dt);
        const double wall = watch.wall();
        result_.step_us.push_back(1e6 * wall);
        result_.wall_s += wall;
        result_.cpu_s += watch.cpu();
        if (options_.after_step) {
            options_.after_step(*simulation_, wall);
        }
        ++result_.steps;
        add(result_.sum, step);
        result_.tet_steps += complex_.tet_count();
        result_.interface_vertices_max =
            std::max(result_.interface_vertices_max, step.interface_vertices);
        result_.quality_last = simulation_->mesh_quality();
        result_.quality_ever += result_.quality_last;
        result_.inverted += result_.quality_last.worst > 0 ? 0U : 1U;
        if (setup_.half_step == result_.steps && setup_.last) {
            const std::uint32_t threads = options_.parallel ? options_.parallel->threads : 1;
            result_.sd_rel_half =
                volume_between(complex_, setup_, result_.steps * setup_.dt, threads) /
                setup_.volume_last;
        }
    }

    void write_frame() {
        if (frames_.is_due(result_.steps)) {
            const std::string path = frames_.enter(result_.steps, result_.steps * setup_.dt);
            dsc3::write_vtu(complex_, path + ".vtu");
            dsc3::write_ply(complex_, path + ".ply");
        }
    }

    // Writes or reads the whole state and the figures.
    void archive(Archive& archive) {
        std::string identity = result_.scene + ", " + std::to_string(setup_.steps) + " steps of " +
                               to_text(setup_.dt) + ", h = " + to_text(result_.parameters.h) +
                               (result_.parallel ? ", " + strategy_of(result_) : "");
        const std::string mine = identity;
        std::uint64_t hash_first = hash_first_;
        archive(identity, hash_first);
        if (identity != mine) {
            archive.refuse("was written by another run: " + identity + "; this one is " + mine);
        }
        archive.expect(hash_first == hash_first_,
                       "began with another mesh: a file of the scene or the program has changed");
        RunResult& r = result_;
        archive(r.steps, r.tets_first, r.interface_vertices_max, r.volume_first, r.euler_first,
                r.sd_rel_half, r.inverted, r.tet_steps, r.step_us, r.cpu_s, r.wall_s);
        archive.expect(r.steps >= 0 && r.steps <= setup_.steps, "has more steps than this run");
        archive_report(archive, r.sum);
        archive_quality(archive, r.quality_last);
        archive_quality(archive, r.quality_ever);
        frames_.archive(archive);
        simulation_->archive(archive);
    }

    void save() {
        if (!options_.checkpoint.path.empty()) {
            Archive state;
            archive(state);
            write_checkpoint(options_.checkpoint, state.bytes());
        }
    }

    void measure_end() {
        RunResult& r = result_;
        r.tets_last = complex_.tet_count();
        r.strata_last = dsc3::count_strata(complex_);
        r.volume_last = volume();
        r.volume_exact_last = setup_.volume_last;
        r.interface_vertices_last = static_cast<std::uint32_t>(simulation_->interface().size());
        if (setup_.last && r.steps == setup_.steps) {
            r.sd_rel_last = volume_between(complex_, setup_.last) / setup_.volume_last;
            const VertexErrors errors = vertex_errors(complex_, setup_.last);
            r.vertex_error_rms = errors.rms;
            r.vertex_error_max = errors.largest;
        }
        r.problem = dsc3::validate(complex_).problem;
        r.mesh_hash = dsc3::mesh_hash(complex_);
        if (!r.step_us.empty()) {
            r.first_step_us = r.step_us.front();
            std::vector<double> sorted = r.step_us;
            std::sort(sorted.begin(), sorted.end());
            r.step_us_median = sorted[sorted.size() / 2];
        }
    }

    Setup setup_;
    scenes::Setup times_;
    Frames frames_;
    const RunOptions& options_;
    dsc3::Complex complex_;
    std::unique_ptr<dsc3::Simulation> simulation_;
    std::uint64_t hash_first_;
    RunResult result_;
};

} // namespace

std::optional<dsc3::Parallel> parallel_of(Strategy strategy, const Submeshing& submeshing) {
    if (strategy == Strategy::sequential) {
        return std::nullopt;
    }
    const auto division = value_in(dsc3::division_names, to_string(strategy));
    if (!division) {
        throw InputError({.what = "no such strategy in three dimensions",
                          .where = "--strategy",
                          .value = to_string(strategy),
                          .allowed = "sequential, " + names_in(dsc3::division_names)});
    }
    return dsc3::Parallel{.threads = submeshing.threads,
                          .submeshes = submeshing.submeshes,
                          .division = *division,
                          .profile = submeshing.profile};
}

RunResult run_scene(const Scene& scene, const Parameters& parameters, const RunOptions& options) {
    return Run(scene, parameters, options).run();
}

} // namespace dsc::scenes::space
