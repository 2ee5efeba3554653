// SPDX-License-Identifier: MIT
#include "scenes/run.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "dsc/complex/hash.h"
#include "scenes/clock.h"
#include "scenes/frames.h"
#include "measures/measure.h"
#include "scenes/progress.h"
#include "scenes/reference_run.h"
#include "scenes/submesh_map.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

namespace dsc::scenes {

namespace {

/// Looking at every triangle after each step is fine for small meshes only.
constexpr std::uint64_t few_triangles = 60000;
constexpr int seldom = 16;

template <class Real>
dsc::Velocity<Real> velocity_in(const Velocity& velocity) {
    if constexpr (std::is_same_v<Real, double>) {
        return velocity;
    } else {
        // The fields are evaluated in double, whatever the mesh is in.
        return [&velocity](std::span<const Point<Real>> positions, Real time,
                           std::span<Point<Real>> velocities) {
            std::vector<Point<double>> in(positions.size());
            std::vector<Point<double>> out(positions.size());
            for (std::size_t i = 0; i < in.size(); ++i) {
                in[i] = positions[i].template cast<double>();
            }
            velocity(in, static_cast<double>(time), out);
            for (std::size_t i = 0; i < in.size(); ++i) {
                velocities[i] = out[i].template cast<Real>();
            }
        };
    }
}

void add_operations(RunResult& result, const OperationCounts& counts) {
    auto& o = result.operations;
    o["moves"] += counts.moves;
    o["flips"] += counts.flips;
    o["interface_splits"] += counts.interface_splits;
    o["interface_collapses"] += counts.interface_collapses;
    o["splits"] += counts.splits;
    o["collapses"] += counts.collapses;
    o["smoothed"] += counts.smoothed;
    o["subdivisions"] += counts.subdivisions;
    o["retriangulations"] += counts.retriangulations;
    o["examined"] += counts.examined;
}

// The mesh under way, in either precision.
template <class Real>
class DscMethod {
public:
    DscMethod(const Setup& setup, const Parameters& parameters, const RunOptions& run)
        : complex_(first_complex<Real>(setup, parameters)),
          options_(scene_options<Real>(parameters)) {
        Submeshing submeshing = run.submeshing;
        submeshing.profile = !run.frames.empty(); // the submeshes are drawn by their work
        auto executor = make_executor(complex_, options_, run.strategy, submeshing);
        submeshes_ = dynamic_cast<const SubmeshExecutor<Real>*>(executor.get());
        simulation_ = std::make_unique<Simulation<Real>>(complex_, options_, std::move(executor));
    }

    void step(const Velocity& velocity, double time, double dt, RunResult& result) {
        if (&velocity != leg_) {
            simulation_->forget();
            leg_ = &velocity;
        }
        const StepReport report = simulation_->step(velocity_in<Real>(velocity),
                                                    static_cast<Real>(time), static_cast<Real>(dt));
        result.unreached += report.unreached;
        result.held += report.held;
        result.sub_steps += report.sub_steps;
        if (report.gave_up == GiveUp::too_many_sub_steps) {
            result.gave_up = "a step at time " + std::to_string(time) + " asks for more than " +
                             std::to_string(options_.max_sub_steps) + " sub-steps: vertex " +
                             std::to_string(report.where.id) + " moves at " +
                             std::to_string(report.speed);
        }
        vertex_steps_ += report.interface_vertices;
        add_operations(result, report.operations);
    }
    [[nodiscard]] const Complex<Real>& complex() const { return complex_; }
    [[nodiscard]] std::uint64_t interface_vertices() const { return simulation_->interface_size(); }
    [[nodiscard]] std::uint64_t vertex_steps() const { return vertex_steps_; }
    /// The submeshes beside a frame, where there are any.
    void map_submeshes(const std::string& frame) const {
        if (submeshes_ != nullptr && !submeshes_->partition().colours.empty() && !frame.empty()) {
            write_submesh_map(*submeshes_,
                              std::filesystem::path(frame).replace_extension("submeshes.json"));
        }
    }

private:
    Complex<Real> complex_;
    Options<Real> options_;
    std::unique_ptr<Simulation<Real>> simulation_;
    const SubmeshExecutor<Real>* submeshes_ = nullptr;
    const Velocity* leg_ = nullptr; ///< the velocity of the step before
    std::uint64_t vertex_steps_ = 0;
};

template <class Method>
class Runner {
public:
    Runner(const Setup& setup, const RunOptions& options, Method& method, RunResult& result)
        : setup_(setup), options_(options), method_(method), result_(result) {}

    void run() {
        first();
        Frames frames(options_.frames, result_.scene + "_" + to_string(options_.strategy),
                      options_.frame_count, setup_.steps, setup_.half_step);
        Progress progress(options_.progress, result_.scene, setup_.steps);
        frames.write(0, 0.0, complex());
        std::vector<double> step_us;
        for (int step = 1; step <= setup_.steps; ++step) {
            if (options_.interrupted != nullptr && options_.interrupted->load()) {
                result_.interrupted = true;
                break;
            }
            // Multiplied, not summed: the last step ends where the scene ends.
            const double begin = (step - 1) * setup_.dt;
            const double end = step * setup_.dt;
            const Velocity& velocity = velocity_of_step(setup_.flow, begin, end);
            const Stopwatch watch;
            method_.step(velocity, begin, setup_.dt, result_);
            step_us.push_back(watch.wall() * 1e6);
            result_.wall_s += watch.wall();
            result_.cpu_s += watch.cpu();
            result_.steps = step;
            time_ = end;
            after(step);
            map_submeshes(frames.write(step, time_, complex()));
            progress.show(step, complex().triangle_count());
            if (!result_.gave_up.empty()) {
                break;
            }
        }
        frames.finish();
        last(step_us);
    }

private:
    const auto& complex() { return method_.complex(); }

    void observe(int step) {
        if constexpr (std::is_same_v<Method, DscMethod<double>>) {
            if (options_.observer) {
                options_.observer(step, method_.complex());
            }
        }
    }

    void map_submeshes(const std::string& frame) {
        if constexpr (!std::is_same_v<Method, ReferenceMethod>) {
            method_.map_submeshes(frame);
        }
    }

    ShapeErrors shape_errors() {
        // Shape is measured as the scene reads its interface, jaggedness at the vertices.
        const Reading reading = result_.parameters.interface.reading;
        const auto polygons = interface_outlines(complex());
        if (!options_.measure_shape) {
            ShapeErrors errors;
            errors.area = signed_area(polygons);
            errors.symmetric_difference = std::numeric_limits<double>::quiet_NaN();
            return errors;
        }
        return measure_shape(reading == Reading::chords ? polygons
                                                        : interface_outlines(complex(), reading),
                             polygons, setup_.exact(time_));
    }

    void first() {
        result_.triangles_first = complex().triangle_count();
        result_.interface_vertices_first = method_.interface_vertices();
        result_.area_first =
            signed_area(interface_outlines(complex(), result_.parameters.interface.reading));
        const ExactShape exact = setup_.exact(0.0);
        result_.area_exact_first = exact.area;
        const MeshQuality quality = measure_worst(complex());
        result_.min_quality_ever = quality.min_quality;
        result_.inverted = quality.inverted;
        result_.quality_sampled_every = result_.triangles_first <= few_triangles ? 1 : seldom;
        observe(0);
    }

    void after(int step) {
        if (step % result_.quality_sampled_every == 0) {
            const MeshQuality quality = measure_worst(complex());
            result_.min_quality_ever = std::min(result_.min_quality_ever, quality.min_quality);
            result_.inverted += quality.inverted;
        }
        if (setup_.half_step == step) {
            result_.half = shape_errors();
            result_.sd_rel_half = result_.half->symmetric_difference / result_.area_exact_first;
        }
        observe(step);
    }

    void last(std::vector<double>& step_us) {
        result_.peak_memory_mb = peak_memory_mb();
        result_.triangles_last = complex().triangle_count();
        result_.interface_vertices_last = method_.interface_vertices();
        result_.last = shape_errors();
        result_.area_ratio = result_.last.area / result_.area_first;
        result_.sd_rel_last = result_.last.symmetric_difference / result_.area_exact_first;
        const MeshQuality quality = measure_quality(complex());
        result_.min_quality_last = quality.min_quality;
        result_.min_quality_ever = std::min(result_.min_quality_ever, quality.min_quality);
        result_.min_angle_deg_last = quality.min_angle_deg;
        result_.median_angle_deg_last = quality.median_angle_deg;
        result_.inverted += quality.inverted;
        result_.mesh_hash = mesh_hash(complex());
        const double h = result_.parameters.h;
        result_.area_histogram = area_histogram(
            complex(), {.bins = 60, .low = 0, .high = 3 * std::sqrt(3.0) / 4 * h * h});
        result_.quality_histogram = quality_histogram(complex(), {.bins = 50});
        result_.angle_histogram = min_angle_histogram(complex(), {.bins = 60});
        if (!step_us.empty()) {
            const auto half = step_us.begin() + static_cast<std::ptrdiff_t>(step_us.size() / 2);
            std::nth_element(step_us.begin(), half, step_us.end());
            result_.step_us_median = *half;
        }
        if (method_.vertex_steps() > 0) {
            result_.us_per_vertex_step =
                result_.cpu_s * 1e6 / static_cast<double>(method_.vertex_steps());
        }
    }

    const Setup& setup_;
    const RunOptions& options_;
    Method& method_;
    RunResult& result_;
    double time_ = 0;
};

template <class Method>
void run_method(const Setup& setup, const Parameters& parameters, const RunOptions& options,
                RunResult& result) {
    Method method(setup, parameters, options);
    Runner<Method>(setup, options, method, result).run();
}

} // namespace

template <class Real>
Complex<Real> first_complex(const Setup& setup, const Parameters& parameters) {
    std::vector<Shape> shapes;
    for (const Outline& outline : setup.outlines) {
        shapes.push_back({outline, 1});
    }
    InitialOptions options;
    options.edge_length = parameters.h;
    return initial_complex<Real>(setup.domain, shapes, options);
}

template <class Real>
Options<Real> scene_options(const Parameters& parameters) {
    Options<Real> options;
    options.edge_length = static_cast<Real>(parameters.h);
    options.integrator = parameters.integrator;
    options.tolerance = parameters.tolerance;
    options.insertion = parameters.insertion;
    options.interface = parameters.interface;
    options.shuffle_seed = parameters.seed;
    return options;
}

template <class Real>
std::unique_ptr<Simulation<Real>>
make_simulation(Complex<Real>& complex, const Options<Real>& options, const RunOptions& run) {
    return std::make_unique<Simulation<Real>>(
        complex, options, make_executor(complex, options, run.strategy, run.submeshing));
}

RunResult run_scene(const Scene& scene, const Parameters& parameters, const RunOptions& options) {
    const Setup setup = scene.prepare(parameters);
    const Submeshing& submeshing = options.submeshing;
    if (!is_parallel(options.strategy) && submeshing.threads > 1) {
        throw InputError("this strategy runs on one thread", "--threads",
                         std::to_string(submeshing.threads),
                         "1, or one of the strategies " + parallel_strategies());
    }
    RunResult result;
    result.scene = scene.name;
    result.parameters = parameters;
    result.parameters.dt = setup.dt;
    result.parameters.steps =
        setup.half_step && scene.defaults.steps > 0 ? *setup.half_step : setup.steps;
    result.strategy = options.strategy;
    result.submeshes = submeshes_of(options.strategy, submeshing);
    result.threads = submeshing.threads;
    if (options.strategy == Strategy::reference) {
        if (parameters.real != RealType::double_precision) {
            throw InputError("the reference is written for double", "--set real", "'float'",
                             "double");
        }
        run_method<ReferenceMethod>(setup, parameters, options, result);
    } else if (parameters.real == RealType::double_precision) {
        run_method<DscMethod<double>>(setup, parameters, options, result);
    } else {
        run_method<DscMethod<float>>(setup, parameters, options, result);
    }
    return result;
}

template Complex<double> first_complex(const Setup&, const Parameters&);
template Complex<float> first_complex(const Setup&, const Parameters&);
template Options<double> scene_options(const Parameters&);
template Options<float> scene_options(const Parameters&);
template std::unique_ptr<Simulation<double>>
make_simulation(Complex<double>&, const Options<double>&, const RunOptions&);
template std::unique_ptr<Simulation<float>> make_simulation(Complex<float>&, const Options<float>&,
                                                            const RunOptions&);

} // namespace dsc::scenes
