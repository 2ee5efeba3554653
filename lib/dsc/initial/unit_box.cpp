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

template <class Real>
Complex<Real> initial_complex(const UnitMap& map, const Rectangle& domain,
                              std::span<const Shape> shapes, const InitialOptions& options) {
    std::vector<Shape> unit_shapes;
    unit_shapes.reserve(shapes.size());
    for (const Shape& shape : shapes) {
        unit_shapes.push_back(to_unit(map, shape));
    }
    InitialOptions unit_options = options;
    unit_options.edge_length = length_to_unit(map, options.edge_length);
    return initial_complex<Real>(to_unit(map, domain), unit_shapes, unit_options);
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
template Complex<double> to_world(const UnitMap&, Complex<double>);
template Complex<float> to_world(const UnitMap&, Complex<float>);

} // namespace dsc
