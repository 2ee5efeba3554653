// SPDX-License-Identifier: MIT
#include "dsc/initial/initial_complex.h"

#include "dsc/base/error.h"
#include "dsc/complex/numbering.h"
#include "dsc/complex/ranges.h"
#include "dsc/initial/build/insertion.h"
#include "dsc/initial/build/interface.h"
#include "dsc/initial/improve/improvement.h"
#include "dsc/initial/input/input_check.h"
#include "dsc/initial/input/line.h"
#include "dsc/queries/phases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dsc {

namespace {

// Lattice vertices closer to an outline than this share of its pieces are removed. A larger share
// leaves gaps, a smaller one short edges; half keeps the circles about the pieces empty.
constexpr double clearance = 0.5;
// Room for the vertices of the outlines and for those that grade down to short pieces, so that
// arrays of a large complex need not be copied to grow.
constexpr std::size_t spare_per_piece = 4;

// The triangles that are not outside the domain. The chains get the new numbers of their vertices.
template <class Real>
Complex<Real> without_outside(const Complex<Real>& complex, initial::Chains& chains) {
    std::vector<std::uint32_t> number(complex.vertex_bound(), no_id);
    std::vector<Point<Real>> points;
    std::vector<std::array<std::uint32_t, 3>> kept;
    std::vector<Phase> phases;
    for (const Triangle t : triangles(complex)) {
        if (complex.phase(t) == border_phase) {
            continue;
        }
        std::array<std::uint32_t, 3>& corners = kept.emplace_back(complex.triangles[t.id].v);
        phases.push_back(complex.phase(t));
        for (std::uint32_t& v : corners) {
            if (number[v] == no_id) {
                number[v] = static_cast<std::uint32_t>(points.size());
                points.push_back(complex.position(Vertex{v}));
            }
            v = number[v];
        }
    }
    for (initial::Chain& chain : chains) {
        for (std::uint32_t& v : chain) {
            v = number[v];
        }
    }
    try {
        return make_complex<Real>(points, kept, phases);
    } catch (const InputError& error) { // such rings do not bound a domain by the even-odd rule
        throw InputError({.what = "rings of the domain touch each other",
                          .where = "domain",
                          .value = error.value(),
                          .allowed = "rings that lie apart"});
    }
}

// Marks the vertices at the given points of the boundary that are not sharp turns, so that the
// improvement leaves them: sides may end there. Returns them.
template <class Real>
std::vector<Vertex> hold(Complex<Real>& complex, const Polygon& domain) {
    const auto less = [](const Point<Real>& a, const Point<Real>& b) {
        return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
    };
    std::vector<Point<Real>> given;
    const auto add = [&](const std::vector<Point<double>>& ring) {
        for (const Point<double>& p : ring) {
            given.push_back(p.cast<Real>());
        }
    };
    add(domain.outline);
    std::ranges::for_each(domain.holes, add);
    std::ranges::sort(given, less);
    std::vector<Vertex> held;
    for (const Vertex v : vertices(complex)) {
        if (is_boundary(complex, v) && !complex.is_boundary_feature(v) &&
            std::ranges::binary_search(given, complex.position(v), less)) {
            complex.set_boundary_feature(v, true);
            held.push_back(v);
        }
    }
    return held;
}

// A complex with these paths as its interface. `domain` is null for a rectangle.
template <class Real>
Complex<Real> build(const initial::CheckedInput& input, const InitialOptions& options,
                    initial::Protection protection, const Polygon* domain = nullptr) {
    using namespace initial;
    const std::span<const CheckedPath> paths = input.paths;
    std::size_t pieces = 0;
    for (const CheckedPath& path : paths) {
        pieces += path.points.size() - 1;
    }
    Complex<Real> complex;
    write_lattice(input.lattice, spare_per_piece * pieces, complex);
    if (paths.empty()) {
        for (const Triangle t : triangles(complex)) {
            complex.triangles[t.id].phase = input.background;
        }
    }
    clear_lattice(complex, input.lattice, paths, clearance);
    Chains chains = insert_paths(complex, input.lattice, paths);
    const std::vector<std::uint32_t> touched = recover_segments(complex, chains);
    fill_phases(complex, paths, chains);
    std::vector<Corner> stack;
    for (const std::uint32_t v : touched) {
        legalise_star(complex, v, stack);
    }
    if (input.has_outside) {
        complex = without_outside(complex, chains);
    }
    const std::vector<Vertex> held =
        domain == nullptr ? std::vector<Vertex>() : hold(complex, *domain);
    const auto interface_vertices = vertices_on(chains);
    if (options.sizes.is_uniform()) {
        improve(complex, std::span<const std::uint32_t>(interface_vertices), options.edge_length,
                options.improve_rounds, protection);
    } else {
        grade(complex, sizes_in<Real>(options.sizes), static_cast<Real>(options.edge_length),
              options.improve_rounds, protection);
    }
    for (const Vertex v : held) {
        complex.set_boundary_feature(v, false);
    }
    if (options.renumber) {
        renumber(complex);
    }
    return complex;
}

} // namespace

Frame choose_frame(const Point<double>& low, const Point<double>& high) {
    const Point<double> sides = high - low;
    const double size = sides.maxCoeff();
    constexpr double smallest = 1e-290;
    if (!low.allFinite() || !(sides.minCoeff() > 0) ||
        !(size >= smallest && size <= 1 / smallest)) {
        throw InputError(
            {.what = "the box is empty or out of range",
             .where = "choose_frame",
             .value = "a larger side of " + to_text(size),
             .allowed = "low below high, finite, and a larger side of 1e-290 to 1e290"});
    }
    Frame frame;
    frame.unit = std::ldexp(1.0, std::ilogb(size));
    for (int axis = 0; axis < 2; ++axis) {
        if (low[axis] >= size) {
            frame.origin[axis] = low[axis];
        } else if (high[axis] <= -size) {
            frame.origin[axis] = high[axis];
        }
    }
    return frame;
}

std::vector<std::string> sentences(const InputReport& report) {
    const auto counted = [](std::size_t count, const std::string& one, const std::string& many) {
        return std::to_string(count) + ' ' + (count == 1 ? one + " was " : many + " were ");
    };
    std::vector<std::string> all;
    if (report.thinned > 0) {
        all.push_back(counted(report.thinned, "point", "points") + "left out of " +
                      std::to_string(report.points) +
                      ", at edges too short for the mesh: at most " + to_text(report.deviation) +
                      " from the interface, which changes areas by " +
                      to_text(report.area_changed));
    }
    if (report.dropped > 0) {
        all.push_back(counted(report.dropped, "shape", "shapes") +
                      "left out as too small, with an area of " + to_text(report.area_dropped));
    }
    if (report.clipped > 0) {
        all.push_back(counted(report.clipped, "outline", "outlines") +
                      "cut off at the sides of the domain");
    }
    return all;
}

namespace {

void check_phases(std::span<const Shape> shapes) {
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        require(shapes[k].phase != border_phase, initial::name_of(shapes, k), shapes[k].phase,
                "phases from 0 to 4294967294; the next one is reserved");
    }
}

// The surroundings of a domain, as a shape in the rectangle around it.
Shape outside_of(const Polygon& domain, double edge_length, Rectangle& around) {
    require(domain.outline.size() >= 3, "points of the outline of the domain",
            static_cast<double>(domain.outline.size()), "3 or more");
    around = {domain.outline.front(), domain.outline.front()};
    Shape outside{.outline = {}, .phase = border_phase, .holes = domain.holes};
    outside.holes.insert(outside.holes.begin(), domain.outline);
    for (const auto& ring : outside.holes) {
        for (const Point<double>& p : ring) {
            if (!p.allFinite()) {
                throw InputError({.what = "a coordinate is not finite",
                                  .where = "domain",
                                  .value = to_text(p),
                                  .allowed = "finite coordinates"});
            }
            around = {around.low.cwiseMin(p), around.high.cwiseMax(p)};
        }
    }
    const Point<double> size = around.high - around.low;
    require(edge_length > 0 && edge_length <= size.minCoeff(), "edge_length", edge_length,
            "above 0, and at most " + to_text(size.minCoeff()) +
                ", the smaller side of the box around the domain");
    constexpr double margin = 2; // in edge lengths: room for triangles outside
    around.low.array() -= margin * edge_length;
    around.high.array() += margin * edge_length;
    outside.outline = {around.low,
                       {around.high.x(), around.low.y()},
                       around.high,
                       {around.low.x(), around.high.y()}};
    return outside;
}

} // namespace

template <class Real>
Complex<Real> initial_complex(const Polygon& domain, std::span<const Shape> shapes,
                              const InitialOptions& options, InputReport* report) {
    check_phases(shapes);
    Rectangle around;
    std::vector<Shape> all(shapes.begin(), shapes.end());
    all.push_back(outside_of(domain, options.edge_length, around));
    InputReport found;
    const auto input =
        initial::check_input<Real>(around, std::span<const Shape>(all), options, found);
    if (report != nullptr) {
        *report = found;
    }
    return build<Real>(input, options, initial::Protection::lens, &domain);
}

template <class Real>
Complex<Real> initial_complex(const Rectangle& domain, std::span<const Shape> shapes,
                              const InitialOptions& options, InputReport* report) {
    check_phases(shapes);
    InputReport found;
    const auto input = initial::check_input<Real>(domain, shapes, options, found);
    if (report != nullptr) {
        *report = found;
    }
    return build<Real>(input, options, initial::Protection::circle);
}

template <class Real>
Complex<Real> initial_complex(const Rectangle& domain, std::span<const Curve> curves,
                              const InitialOptions& options, InputReport* report) {
    InputReport found;
    const auto input = initial::check_input<Real>(domain, curves, options, found);
    if (report != nullptr) {
        *report = found;
    }
    return build<Real>(input, options, initial::Protection::lens);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Complex<Real> initial_complex(const Polygon&, std::span<const Shape>,                 \
                                           const InitialOptions&, InputReport*);                   \
    template Complex<Real> initial_complex(const Rectangle&, std::span<const Shape>,               \
                                           const InitialOptions&, InputReport*);                   \
    template Complex<Real> initial_complex(const Rectangle&, std::span<const Curve>,               \
                                           const InitialOptions&, InputReport*);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
