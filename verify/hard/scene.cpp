// SPDX-License-Identifier: MIT
#include "scene.h"

#include "dsc/complex/ranges.h"
#include "dsc/quality/measures.h"
#include "measures/interface_outlines.h"
#include "measures/symmetric_difference.h"
#include "support/frame_testing.h"

#include <array>
#include <cstdio>

namespace dsc::hard {

namespace {

std::vector<Shape> shapes_of(std::span<const scenes::Outline> outlines) {
    std::vector<Shape> shapes;
    for (const auto& outline : outlines) {
        shapes.push_back({outline, 1});
    }
    return shapes;
}

} // namespace

template <class Real>
Scene<Real> scene_of(const Rectangle& domain, std::span<const scenes::Outline> outlines, double h) {
    Scene<Real> scene{
        domain, initial_complex<Real>(domain, shapes_of(outlines), {.edge_length = h}), {}};
    scene.options.edge_length = static_cast<Real>(h);
    return scene;
}

template <class Real>
Scene<Real> scene_of(const Frame& frame, const Rectangle& domain,
                     std::span<const scenes::Outline> outlines, double h) {
    const auto in_frame = [&](const Point<double>& p) { return test::to_frame(frame, p); };
    return scene_of<Real>({in_frame(domain.low), in_frame(domain.high)}, mapped(outlines, in_frame),
                          h / frame.unit);
}

Scene<double> grid_scene(const Rectangle& domain, int columns, int rows,
                         const std::function<Phase(const Point<double>&)>& phase_at,
                         const std::function<Point<double>(const Point<double>&)>& place) {
    const Point<double> sides = domain.high - domain.low;
    const Point<double> step(sides.x() / columns, sides.y() / rows);
    std::vector<Point<double>> points;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            const Point<double> p(i == columns ? domain.high.x() : domain.low.x() + i * step.x(),
                                  j == rows ? domain.high.y() : domain.low.y() + j * step.y());
            points.push_back(place ? place(p) : p);
        }
    }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Phase> phases;
    const auto id = [&](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const std::uint32_t a = id(i, j);
            const std::uint32_t b = id(i + 1, j);
            const std::uint32_t c = id(i + 1, j + 1);
            const std::uint32_t d = id(i, j + 1);
            if ((i + j) % 2 == 0) {
                triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
            } else {
                triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
            }
        }
    }
    for (const auto& t : triangles) {
        phases.push_back(phase_at((points[t[0]] + points[t[1]] + points[t[2]]) / 3));
    }
    Scene<double> scene{domain, make_complex<double>(points, triangles, phases), {}};
    scene.options.edge_length = step.maxCoeff();
    return scene;
}

template <class Real>
double shape_error(const Complex<Real>& complex, std::span<const scenes::Outline> exact) {
    return scenes::symmetric_difference(scenes::interface_outlines(complex), exact) /
           scenes::signed_area(exact);
}

std::vector<scenes::Outline> mapped(std::span<const scenes::Outline> outlines,
                                    const std::function<Point<double>(const Point<double>&)>& map) {
    std::vector<scenes::Outline> result(outlines.begin(), outlines.end());
    for (auto& outline : result) {
        for (auto& point : outline) {
            point = map(point);
        }
    }
    return result;
}

double domain_area(const Complex<double>& complex) {
    double sum = 0;
    for (const Triangle t : triangles(complex)) {
        sum += area(complex, t);
    }
    return sum;
}

std::string text(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g", value);
    return buffer;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Scene<Real> scene_of(const Rectangle&, std::span<const scenes::Outline>, double);     \
    template Scene<Real> scene_of(const Frame&, const Rectangle&,                                  \
                                  std::span<const scenes::Outline>, double);                       \
    template double shape_error(const Complex<Real>&, std::span<const scenes::Outline>);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::hard
