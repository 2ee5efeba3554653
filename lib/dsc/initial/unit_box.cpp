// SPDX-License-Identifier: MIT
#include "dsc/initial/unit_box.h"

#include "dsc/complex/ranges.h"

namespace dsc {

Rectangle to_unit(const UnitMap& map, const Rectangle& world) {
    return {to_unit(map, world.low), to_unit(map, world.high)};
}

Shape to_unit(const UnitMap& map, const Shape& world) {
    Shape unit = world;
    for (Point<double>& point : unit.outline) {
        point = to_unit(map, point);
    }
    return unit;
}

Curve to_unit(const UnitMap& map, const Curve& world) {
    Curve unit = world;
    for (Point<double>& point : unit.points) {
        point = to_unit(map, point);
    }
    return unit;
}

namespace {

// Lengths and places of the options are those of the world.
InitialOptions to_unit(const UnitMap& map, const InitialOptions& world) {
    InitialOptions unit = world;
    unit.edge_length = length_to_unit(map, world.edge_length);
    unit.sizes.longest = length_to_unit(map, world.sizes.longest);
    if (world.sizes.by_place) {
        unit.sizes.by_place = [map, by_place = world.sizes.by_place](const Point<double>& p,
                                                                     double time, Phase phase) {
            return length_to_unit(map, by_place(to_world(map, p), time, phase));
        };
    }
    if (world.sizes.on_interface) {
        unit.sizes.on_interface =
            [map, on_interface = world.sizes.on_interface](const Point<double>& p, double time) {
                return length_to_unit(map, on_interface(to_world(map, p), time));
            };
    }
    if (world.sizes.by_distance) {
        unit.sizes.by_distance = [map, by_distance = world.sizes.by_distance](double distance) {
            return length_to_unit(map, by_distance(length_to_world(map, distance)));
        };
    }
    return unit;
}

// `lines` are shapes or curves.
template <class Real, class Line>
Complex<Real> initial_complex_in_unit_box(const UnitMap& map, const Rectangle& domain,
                                          std::span<const Line> lines,
                                          const InitialOptions& options) {
    std::vector<Line> unit_lines;
    unit_lines.reserve(lines.size());
    for (const Line& line : lines) {
        unit_lines.push_back(to_unit(map, line));
    }
    return initial_complex<Real>(to_unit(map, domain), std::span<const Line>(unit_lines),
                                 to_unit(map, options));
}

} // namespace

template <class Real>
Complex<Real> initial_complex(const UnitMap& map, const Rectangle& domain,
                              std::span<const Shape> shapes, const InitialOptions& options) {
    return initial_complex_in_unit_box<Real>(map, domain, shapes, options);
}

template <class Real>
Complex<Real> initial_complex(const UnitMap& map, const Rectangle& domain,
                              std::span<const Curve> curves, const InitialOptions& options) {
    return initial_complex_in_unit_box<Real>(map, domain, curves, options);
}

template <class Real>
Complex<Real> to_world(const UnitMap& map, Complex<Real> complex) {
    for (const Vertex v : vertices(complex)) {
        const Point<double> unit = complex.position(v).template cast<double>();
        complex.set_position(v, to_world(map, unit).template cast<Real>());
    }
    return complex;
}

template Complex<double> initial_complex(const UnitMap&, const Rectangle&, std::span<const Shape>,
                                         const InitialOptions&);
template Complex<float> initial_complex(const UnitMap&, const Rectangle&, std::span<const Shape>,
                                        const InitialOptions&);
template Complex<double> initial_complex(const UnitMap&, const Rectangle&, std::span<const Curve>,
                                         const InitialOptions&);
template Complex<float> initial_complex(const UnitMap&, const Rectangle&, std::span<const Curve>,
                                        const InitialOptions&);
template Complex<double> to_world(const UnitMap&, Complex<double>);
template Complex<float> to_world(const UnitMap&, Complex<float>);

} // namespace dsc
