// SPDX-License-Identifier: MIT
#include "scenes/run/fluid_run.h"

#include "dsc/base/error.h"
#include "dsc/queries/phases.h"
#include "fluid/solve/solve_report.h"
#include "scenes/run/start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dsc::scenes {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

FluidMotion with_threads(FluidMotion motion, std::uint32_t threads) {
    motion.options.threads = threads;
    return motion;
}

Phase measured_phase(const Setup& setup) { return setup.measured.value_or(1); }

bool is_at_boundary(const Complex<double>& complex, Phase phase) {
    const auto all = triangles(complex, phase);
    return all.empty() ||
           std::ranges::any_of(all, [&](Triangle t) { return is_boundary(complex, t); });
}

double centre_of(const FluidField& field, Phase phase) {
    double moment = 0;
    double sum = 0;
    for (const SnapshotTriangle& t : field.mesh.triangles) {
        if (t.phase == phase) {
            const double share = area(field.mesh, t);
            for (std::size_t i = 0; i < 3; ++i) {
                moment += share / 3 * field.mesh.nodes[t.nodes[i]].y();
            }
            sum += share;
        }
    }
    return moment / sum;
}

// The height of the wave: a constant and the wave are fitted to the interface vertices by least
// squares, each weighted by half the length of its edges.
double amplitude_of(const FluidField& field, const SmallWave& wave) {
    double weights = 0;
    double shapes = 0;
    double squares = 0;
    double heights = 0;
    double products = 0;
    const auto add = [&](const Point<double>& at, double weight) {
        const Point<double> way = at - wave.middle;
        const double height = wave.is_on_circle ? way.norm() : way.y();
        const double along = wave.is_on_circle ? std::atan2(way.y(), way.x()) : way.x();
        const double shape = std::cos(wave.number * along);
        weights += weight;
        shapes += weight * shape;
        squares += weight * shape * shape;
        heights += weight * height;
        products += weight * shape * height;
    };
    for (const SnapshotEdge& edge : field.mesh.interface) {
        const Point<double>& from = field.mesh.nodes[edge.from];
        const Point<double>& to = field.mesh.nodes[edge.to];
        const double weight = (to - from).norm() / 2;
        add(from, weight);
        add(to, weight);
    }
    return (weights * products - shapes * heights) / (weights * squares - shapes * shapes);
}

// The distance from the left side at which the interface ends on the lower side.
double neck_of(const FluidField& field) {
    double farthest = unknown;
    for (const SnapshotEdge& edge : field.mesh.interface) {
        for (const std::uint32_t end : {edge.from, edge.to}) {
            const Point<double> way = field.mesh.nodes[end] - field.mesh.domain.low;
            if (way.y() == 0) {
                farthest = std::fmax(farthest, way.x());
            }
        }
    }
    return farthest;
}

struct Peak {
    double value = unknown;
    double time = unknown;
};

// The largest value over time, by a parabola through the maximum and its neighbours. NaN if the
// quantity could not be measured.
template <class Quantity>
Peak largest(const std::vector<FluidMoment>& moments, Quantity quantity) {
    const auto at = std::ranges::max_element(moments, {}, quantity);
    if (std::isnan(quantity(*at))) {
        return {};
    }
    if (at == moments.begin() || at == moments.end() - 1) {
        return {quantity(*at), at->time};
    }
    const double before = quantity(at[-1]) - quantity(*at);
    const double after = quantity(at[1]) - quantity(*at);
    const double dt = at->time - at[-1].time;
    if (before + after == 0) { // a plateau
        return {quantity(*at), at->time};
    }
    const double place = (before - after) / 2 / (before + after);
    return {quantity(*at) - (before - after) / 4 * place, at->time + dt * place};
}

// The root-mean-square error of the wave's height, relative to the first height.
double amplitude_error(const std::vector<FluidMoment>& moments) {
    double sum = 0;
    for (const FluidMoment& moment : moments) {
        sum += std::pow(moment.amplitude - moment.exact_amplitude, 2);
    }
    return std::sqrt(sum / static_cast<double>(moments.size())) /
           std::abs(moments.front().exact_amplitude);
}

// Largest relative error of the neck; NaN if it could not be measured at some time.
double neck_error(const std::vector<FluidMoment>& moments) {
    double largest = 0;
    for (const FluidMoment& moment : moments) {
        const double error = std::abs(moment.neck / moment.exact_neck - 1);
        largest = error > largest || std::isnan(error) ? error : largest;
    }
    return largest;
}

// The time of the last zero of a height, and the number of zeros.
std::pair<int, double> last_zero(const std::vector<FluidMoment>& moments,
                                 double FluidMoment::*height) {
    std::pair<int, double> last{0, unknown};
    for (std::size_t i = 1; i < moments.size(); ++i) {
        const double before = moments[i - 1].*height;
        const double now = moments[i].*height;
        if ((before > 0) != (now > 0)) {
            const double share = before / (before - now);
            last = {last.first + 1,
                    moments[i - 1].time + share * (moments[i].time - moments[i - 1].time)};
        }
    }
    return last;
}

// The relative error of the wave's frequency, from the time of its last zero; NaN if the number of
// zeros is 0 or wrong.
double frequency_error(const std::vector<FluidMoment>& moments) {
    const auto own = last_zero(moments, &FluidMoment::amplitude);
    const auto exact = last_zero(moments, &FluidMoment::exact_amplitude);
    return own.first == exact.first && own.first > 0 ? std::abs(exact.second / own.second - 1)
                                                     : unknown;
}

// The force on each side that has a name.
void add_forces(const Fluid& fluid, const std::string& ending, Figures& figures) {
    for (const FluidSide& side : fluid.options().sides) {
        const Point<double> force = fluid.force_on(side.name);
        figures.push_back({"force_x_" + side.name + ending, force.x()});
        figures.push_back({"force_y_" + side.name + ending, force.y()});
    }
}

} // namespace

void archive(Archive& archive, FluidMoment& m) {
    archive(m.time, m.circularity, m.centre, m.rise_velocity, m.area, m.largest_velocity,
            m.pressure_jump, m.energy, m.amplitude, m.exact_amplitude, m.neck, m.exact_neck);
}

bool has_circularity(const Setup& setup, const Parameters& parameters) {
    return !is_at_boundary(first_complex<double>(setup, parameters), measured_phase(setup));
}

FluidRun::FluidRun(const Complex<double>& complex, const Setup& setup, std::uint32_t threads)
    : complex_(complex), motion_(with_threads(*setup.fluid, threads)),
      phase_(measured_phase(setup)), fluid_(complex, motion_.options) {
    look();
}

void FluidRun::check_pairs_meet() const {
    const std::vector<SnapshotEdge>& interface = fluid_.field().mesh.interface;
    for (const FluidTension& pair : motion_.options.tensions) {
        const bool meet = std::ranges::any_of(interface, [&](const SnapshotEdge& edge) {
            return &pair_of(motion_.options, edge.left, edge.right) == &pair;
        });
        if (!meet) {
            throw InputError(
                {.what = "a tension is given for two phases that cannot meet",
                 .where = "FluidOptions::tensions",
                 .value = "phases " + to_text(pair.one) + " and " + to_text(pair.other),
                 .allowed = "pairs that meet at the start, unless topology = change"});
        }
    }
}

void FluidRun::before_step(Simulation<double>& simulation) {
    before_ = {};
    simulation.archive(before_);
    fluid_.archive(before_);
}

StepReport FluidRun::step(Simulation<double>& simulation, double dt) {
    const auto go_back = [&] {
        Archive state(before_.bytes(), "the state before the step");
        simulation.archive(state);
        fluid_.archive(state);
    };
    const auto fail = [&](const std::exception& error) {
        go_back();
        failure_ = "after time " + std::to_string(fluid_.time()) + ": " + error.what();
        return StepReport{};
    };
    try {
        const FluidStep report = fluid_.advance(simulation, dt);
        if (report.moved.gave_up != GiveUp::none) {
            go_back();
            StepReport undone;
            undone.gave_up = report.moved.gave_up;
            undone.where = report.moved.where;
            undone.speed = report.moved.speed;
            return undone;
        }
        solve_s_ += report.solve_s;
        assembly_s_ += report.assembly_s;
        dsc_s_ += report.move_s;
        return report.moved;
    } catch (const SolveError& error) {
        return fail(error);
    } catch (const InputError& error) { // two phases without a tension have met
        return fail(error);
    }
}

void FluidRun::look() {
    const FluidField& field = fluid_.field();
    const bool is_closed = !is_at_boundary(complex_, phase_);
    const CubicOutline outline = is_closed ? cubic_outline(complex_, phase_) : CubicOutline{};
    moments_.push_back(
        {.time = fluid_.time(),
         .circularity = is_closed ? outline.circularity() : unknown,
         .centre = is_closed ? outline.centroid.y() : centre_of(field, phase_),
         .rise_velocity = mean_velocity(field, phase_).y(),
         .area = phase_area(complex_, phase_),
         .largest_velocity = largest_speed(field, motion_.options),
         .pressure_jump = mean_pressure(field, phase_) - mean_pressure(field, exterior_phase),
         .energy = energy(field, motion_.options).sum(),
         .amplitude = motion_.wave ? amplitude_of(field, *motion_.wave) : unknown,
         .exact_amplitude = motion_.wave ? motion_.wave->exact(fluid_.time()) : unknown,
         .neck = motion_.neck ? neck_of(field) : unknown,
         .exact_neck = motion_.neck ? motion_.neck(fluid_.time()) : unknown});
}

Figures FluidRun::now() const {
    const FluidMoment& m = moments_.back();
    Figures figures{{"circularity", m.circularity},
                    {"centre", m.centre},
                    {"rise_velocity", m.rise_velocity},
                    {"largest_velocity", m.largest_velocity},
                    {"pressure_jump", m.pressure_jump},
                    {"energy", m.energy},
                    {"amplitude", m.amplitude},
                    {"amplitude_exact", m.exact_amplitude},
                    {"neck", m.neck},
                    {"neck_exact", m.exact_neck}};
    add_forces(fluid_, "", figures);
    return figures;
}

Figures FluidRun::figures() const {
    const FluidMoment& last = moments_.back();
    const Peak flattest = largest(moments_, [](const FluidMoment& m) { return -m.circularity; });
    const Peak fastest = largest(moments_, [](const FluidMoment& m) { return m.rise_velocity; });
    Figures figures{{"circularity_min", -flattest.value},
                    {"circularity_min_t", flattest.time},
                    {"circularity_last", last.circularity},
                    {"rise_velocity_max", fastest.value},
                    {"rise_velocity_max_t", fastest.time},
                    {"centre_last", last.centre},
                    {"area_drift_last", std::abs(last.area / moments_.front().area - 1)},
                    {"largest_velocity_last", last.largest_velocity},
                    {"pressure_jump_last", last.pressure_jump},
                    {"energy_last", last.energy}};
    add_forces(fluid_, "_last", figures);
    if (motion_.wave) {
        figures.push_back({"amplitude_error", amplitude_error(moments_)});
        figures.push_back({"frequency_error", frequency_error(moments_)});
    }
    if (motion_.neck) {
        figures.push_back({"neck_error", neck_error(moments_)});
        figures.push_back({"neck_last", last.neck});
    }
    figures.insert(figures.end(),
                   {{"solve_s", solve_s_}, {"assembly_s", assembly_s_}, {"dsc_s", dsc_s_}});
    return figures;
}

void FluidRun::put_into(std::vector<VtuArray>& arrays) const {
    const FluidField& field = fluid_.field();
    const std::uint32_t count = field.mesh.vertex_bound;
    std::vector<double> velocity(2 * std::size_t{count}, 0);
    for (std::uint32_t v = 0; v < count; ++v) {
        velocity[2 * v] = field.velocity[v].x();
        velocity[2 * v + 1] = field.velocity[v].y();
    }
    std::vector<double> below(count, 0);
    std::vector<double> beyond(count, 0);
    std::vector<std::pair<Phase, Phase>> seen(count, {std::numeric_limits<Phase>::max(), 0});
    for (std::size_t t = 0; t < field.mesh.triangles.size(); ++t) {
        const SnapshotTriangle& triangle = field.mesh.triangles[t];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t v = triangle.nodes[i];
            if (triangle.phase <= seen[v].first) {
                seen[v].first = triangle.phase;
                below[v] = field.pressure[t][i];
            }
            if (triangle.phase >= seen[v].second) {
                seen[v].second = triangle.phase;
                beyond[v] = field.pressure[t][i];
            }
        }
    }
    const auto found = std::ranges::find(arrays, "velocity", &VtuArray::name);
    found->values = std::move(velocity);
    arrays.push_back({"pressure", SimplexKind::vertex, 1, std::move(below)});
    arrays.push_back({"pressure_beyond", SimplexKind::vertex, 1, std::move(beyond)});
}

void FluidRun::archive(Archive& archive) {
    fluid_.archive(archive);
    archive(failure_, moments_, solve_s_, assembly_s_, dsc_s_);
    archive.expect(!moments_.empty(), "contains no fluid measurements");
}

} // namespace dsc::scenes
