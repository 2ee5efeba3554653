// SPDX-License-Identifier: MIT
// Contacts of an interface with another one, or with the domain boundary.
#include "scene.h"
#include "watch.h"

#include "dsc/complex/ranges.h"
#include "dsc/queries/phases.h"
#include "flows/exact.h"
#include "flows/velocity.h"
#include "measures/interface_outlines.h"
#include "shapes/shapes.h"
#include "support/pointwise.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace dsc::hard {

namespace {

using scenes::Outline;

constexpr double disc_h = 0.05;

// Two discs of phases 1 and 2, side by side with a gap of 1.2 edges between them.
Scene<double> two_discs() {
    const std::vector<Shape> shapes{{scenes::circle({0.28, 0.5}, 0.19, disc_h), 1},
                                    {scenes::circle({0.72, 0.5}, 0.19, disc_h), 2}};
    Scene<double> scene{
        unit_square, initial_complex<double>(unit_square, shapes, {.edge_length = disc_h}), {}};
    scene.options.edge_length = disc_h;
    return scene;
}

// The current vertices of both discs: a velocity at a point is that of the disc with the nearest
// vertex.
struct DiscVertices {
    std::vector<Point<double>> positions;
    std::vector<Phase> phases;

    void update(const Complex<double>& complex) {
        positions.clear();
        phases.clear();
        for (const Triangle t : triangles(complex)) {
            if (complex.phase(t) == exterior_phase) {
                continue;
            }
            for (std::uint32_t i = 0; i < 3; ++i) {
                const Corner c = corner_of(t.id, i);
                if (complex.phase_at(complex.twin(c)) == exterior_phase) {
                    positions.push_back(complex.position(Vertex{complex.vertex(next(c))}));
                    phases.push_back(complex.phase(t));
                }
            }
        }
    }
    [[nodiscard]] Phase phase_near(const Point<double>& p) const {
        Phase phase = exterior_phase;
        double nearest = std::numeric_limits<double>::max();
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const double squared = (positions[i] - p).squaredNorm();
            if (squared < nearest) {
                nearest = squared;
                phase = phases[i];
            }
        }
        return phase;
    }
};

// Each disc is driven towards the other; the speed vanishes nowhere.
HardResult pressed_case(double edges_a_step, int steps, const std::string& how) {
    HardResult result;
    result.asked =
        "two discs pressed together for " + std::to_string(steps) + " steps, topology kept, " + how;
    auto scene = two_discs();
    Watch<double> watch(scene.complex, scene.options,
                        {.domain = unit_square, .thorough_every = 100}, result);
    const double speed = edges_a_step * disc_h;
    DiscVertices vertices;
    // The disc of each point is found only at the beginning of a step: in later Runge-Kutta stages
    // the other disc may be nearer, but the discs must still be driven at each other.
    double begin = 0;
    std::vector<Phase> asking;
    const Velocity<double> press = [&](std::span<const Point<double>> positions, double time,
                                       std::span<Point<double>> velocities) {
        asking.resize(positions.size());
        for (std::size_t i = 0; i < positions.size(); ++i) {
            if (time == begin) {
                asking[i] = vertices.phase_near(positions[i]);
            }
            velocities[i] = {asking[i] == 1 ? speed : -speed, 0};
        }
    };
    bool going = true;
    std::uint64_t passes_late = 0; // in the second half of the run
    for (int i = 0; i < steps && going; ++i) {
        vertices.update(scene.complex);
        begin = i;
        going = watch.step(press, i, 1);
        if (2 * i > steps) {
            passes_late += watch.last().passes;
        }
    }
    std::uint64_t in_contact = 0;
    for (const Vertex v : dsc::vertices(scene.complex)) {
        in_contact += is_in_contact(scene.complex.vertices[v.id]) ? 1U : 0U;
    }
    const double mean_passes = static_cast<double>(passes_late) / (steps - steps / 2 - 1);
    result.happened = std::to_string(in_contact) + " vertices end in contact, at " +
                      text(mean_passes) + " passes a step; " + std::to_string(result.unreached) +
                      " misses over all steps, each of them counted";
    expect(result, result.unreached > 0, "nothing was in the way");
    expect(result, in_contact > 0, "nobody is in contact");
    expect(result, result.held == 0, "vertices were held though all velocities are finite");
    expect(result, mean_passes <= 4, "vertices in contact are tried again and again");
    for (Phase phase = 1; phase <= 2; ++phase) {
        expect(result, scenes::interface_outlines(scene.complex, {.phase = phase}).size() == 1,
               "the topology of phase " + std::to_string(phase) + " was not kept");
    }
    expect(result, scene.complex.triangle_count() < 20000, "the mesh grows without bound");
    expect_sound(result, Targets::may_be_missed);
    return result;
}

struct BoundaryEdges {
    double shortest = std::numeric_limits<double>::max();
    double longest = 0;
    double off_boundary = 0; ///< largest distance of a boundary vertex from the sides of the domain
};

BoundaryEdges boundary_edges(const Scene<double>& scene) {
    BoundaryEdges boundary;
    const auto& complex = scene.complex;
    for (const Triangle t : triangles(complex)) {
        for (const Edge e : complex.edges_of(t)) {
            if (!is_boundary(complex, e)) {
                continue;
            }
            const auto v = complex.vertices_of(e);
            const Point<double> p = complex.position(v[0]);
            const Point<double> q = complex.position(v[1]);
            boundary.shortest = std::min(boundary.shortest, (q - p).norm());
            boundary.longest = std::max(boundary.longest, (q - p).norm());
            for (const Point<double>& a : {p, q}) {
                const double off = std::min((a - scene.domain.low).cwiseAbs().minCoeff(),
                                            (a - scene.domain.high).cwiseAbs().minCoeff());
                boundary.off_boundary = std::max(boundary.off_boundary, off);
            }
        }
    }
    return boundary;
}

// The motion of a strip from side to side, per unit of time: x goes to middle + stretch (x -
// middle) + shear (y - 1/2) + shift.
struct BoundaryMotion {
    double shear = 0;
    double shift = 0;
    double stretch = 1;
};

constexpr double boundary_middle = 1.0;

// A phase that fills a strip from side to side; the outline lies on the sides of the domain.
HardResult boundary_case(const std::string& asked, double width, const BoundaryMotion& motion) {
    HardResult result;
    result.asked = asked;
    const Rectangle domain{{0, 0}, {2, 1}};
    constexpr int columns = 40;
    constexpr double h = 2.0 / columns;
    const double left = boundary_middle - width / 2;
    const double right = boundary_middle + width / 2;
    auto scene = grid_scene(domain, columns, columns / 2, [&](const Point<double>& p) {
        return p.x() > left && p.x() < right ? Phase{1} : exterior_phase;
    });
    Watch<double> watch(scene.complex, scene.options, {.domain = domain}, result);
    const double rate = std::log(motion.stretch);
    const auto velocity = test::pointwise([&](const Point<double>& p) {
        return Point<double>(
            motion.shift + motion.shear * (p.y() - 0.5) + rate * (p.x() - boundary_middle), 0);
    });
    const std::vector<Outline> outlines{{{left, 0}, {right, 0}, {right, 1}, {left, 1}}};
    constexpr int steps = 50;
    watch.run(velocity, 0, 1.0 / steps, steps);
    const auto exact = mapped(outlines, [&](const Point<double>& p) {
        return Point<double>(boundary_middle + motion.stretch * (p.x() - boundary_middle) +
                                 motion.shift + motion.shear * (p.y() - 0.5),
                             p.y());
    });
    const double area_error = std::abs(domain_area(scene.complex) - 2.0) / 2;
    const BoundaryEdges boundary = boundary_edges(scene);
    result.happened = "its ends slide; boundary edges end between " + text(boundary.shortest / h) +
                      " and " + text(boundary.longest / h) + " edge lengths";
    // Bounds RK4's own error for exp(0.02) to the power of 50.
    note_error(result, shape_error<double>(scene.complex, exact), rate == 0 ? 1e-12 : 1e-8);
    expect(result, boundary.off_boundary == 0, "a boundary vertex left the domain boundary");
    expect(result, area_error < 1e-13, "the domain's area changed");
    expect(result, boundary.longest < 1.7 * h, "the domain boundary was not refined");
    expect(result, boundary.shortest > 0.35 * h, "the domain boundary was not coarsened");
    expect_sound(result, Targets::reachable);
    return result;
}

// A disc and a strip that are driven against a side of the domain, which they cannot cross.
HardResult pressed_boundary_case() {
    HardResult result;
    result.asked = "a disc and a strip from side to side are driven against a side of the domain "
                   "for 2,000 steps";
    constexpr int columns = 20;
    constexpr double h = 1.0 / columns;
    auto scene = grid_scene(unit_square, columns, columns, [](const Point<double>& p) {
        const bool in_disc = (p - Point<double>(0.75, 0.5)).norm() < 0.15;
        return in_disc ? Phase{2} : (p.x() > 0.3 && p.x() < 0.5 ? Phase{1} : exterior_phase);
    });
    Watch<double> watch(scene.complex, scene.options, {.domain = unit_square, .thorough_every = 20},
                        result);
    watch.run(scenes::Translation{{1, 0}}, 0, 0.1 * h, 2000);
    const double area_error = std::abs(domain_area(scene.complex) - 1);
    const BoundaryEdges boundary = boundary_edges(scene);
    result.happened = "both are stopped, " + std::to_string(watch.last().unreached) +
                      " vertices counted in the last step; the domain keeps its shape";
    expect(result, boundary.off_boundary == 0, "a boundary vertex left the domain boundary");
    expect(result, area_error < 1e-13, "the domain's area changed");
    expect(result, watch.last().unreached > 0, "nothing was in the way");
    for (Phase phase = 1; phase <= 2; ++phase) {
        expect(result, !scenes::interface_outlines(scene.complex, {.phase = phase}).empty(),
               "phase " + std::to_string(phase) + " has vanished");
    }
    expect_sound(result, Targets::may_be_missed);
    return result;
}

// The strip's end on the domain boundary is an interface as well, and meets the strip's side at a
// turn of only 35 degrees: a cubic through both would bulge at the domain boundary. The sign of the
// slope decides at which end of an edge the bulge would be.
HardResult slanted_boundary_case(double slope) {
    HardResult result;
    result.asked = "a strip that meets the sides of the domain at a slope of " + text(slope) +
                   ", whose edges are all split";
    const auto lean = [slope](const Point<double>& p) {
        return Point<double>(p.x() + slope * (p.y() - 0.5), p.y());
    };
    constexpr int columns = 40;
    auto scene = grid_scene(
        {{0, 0}, {2, 1}}, columns, columns / 2,
        [slope](const Point<double>& p) {
            const double x = p.x() - slope * (p.y() - 0.5);
            return x > 0.8 && x < 1.1 ? Phase{1} : exterior_phase;
        },
        lean);
    scene.options.edge_length = 1.0 / columns;
    Watch<double> watch(scene.complex, scene.options, {.domain = {{-9, 0}, {9, 1}}}, result);
    watch.run(scenes::Translation{{0.01, 0}}, 0, 0.01, 3);
    const std::vector<Outline> exact{
        {lean({0.8003, 0}), lean({1.1003, 0}), lean({1.1003, 1}), lean({0.8003, 1})}};
    note_error(result, shape_error<double>(scene.complex, exact), 1e-13);
    result.happened = "the interface is not interpolated along the domain boundary";
    expect_sound(result, Targets::reachable);
    return result;
}

} // namespace

void append_contacts(std::vector<HardCase>& cases) {
    cases.push_back({"pressed-slowly", [] {
                         return pressed_case(4e-4, 10000, "by four edge lengths in all, each");
                     }});
    cases.push_back({"pressed-flat", [] {
                         return pressed_case(0.3, 10000, "by 0.3 edge lengths a step, for ever");
                     }});
    const auto add_boundary = [&](const std::string& name, const std::string& asked, double width,
                                  const BoundaryMotion& motion) {
        cases.push_back({name, [=] { return boundary_case(asked, width, motion); }});
    };
    add_boundary("boundary-translation",
                 "a strip from side to side goes six edge lengths along the sides of the domain",
                 0.3, {.shift = 0.3});
    add_boundary("boundary-shear",
                 "a strip from side to side is sheared: its ends slide along the sides of the "
                 "domain by seven edge "
                 "lengths either way",
                 0.3, {.shear = 0.7});
    add_boundary("boundary-stretch", "a strip from side to side becomes three times as wide", 0.3,
                 {.stretch = 3});
    add_boundary("boundary-squeeze", "a strip from side to side becomes a third as wide", 0.9,
                 {.stretch = 1.0 / 3});
    cases.push_back({"boundary-pressed", pressed_boundary_case});
    cases.push_back({"boundary-slanted", [] { return slanted_boundary_case(1.4); }});
    cases.push_back({"boundary-slanted-back", [] { return slanted_boundary_case(-1.4); }});
}

} // namespace dsc::hard
