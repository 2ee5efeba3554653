// SPDX-License-Identifier: MIT
#include "scenes/space/measure.h"

#include "dsc3/dsc3.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dsc::scenes::space {

namespace {

using dsc3::Point;

double area(const Point& a, const Point& b, const Point& c) {
    return (b - a).cross(c - a).norm() / 2;
}

// Integrates the distance over a face in 64 pieces.
double between(const dsc3::Distance& distance, const Point& a, const Point& b, const Point& c) {
    constexpr int n = 8;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; i + j < n; ++j) {
            for (int k = 1; k <= (i + j + 1 < n ? 2 : 1); ++k) {
                sum += std::abs(
                    distance(a + (i + k / 3.0) / n * (b - a) + (j + k / 3.0) / n * (c - a)));
            }
        }
    }
    return area(a, b, c) * sum / (n * n);
}

// The number of pieces of each edge of a face that is moved back by the flow.
constexpr int pieces = 4;
constexpr int points_of_face = (pieces + 1) * (pieces + 2) / 2;
// The error of RK4 with this number of steps is far below that of the interface.
constexpr int steps_back = 48;

// The index of the point that is i pieces from a towards b and j towards c.
int number(int i, int j) { return i * (pieces + 1) - i * (i - 1) / 2 + j; }

} // namespace

double volume_between(const dsc3::Complex& complex, const dsc3::Distance& shape) {
    double sum = 0;
    for (const dsc3::InterfaceFace& face : dsc3::interface_faces(complex)) {
        const auto& [a, b, c] = face.v;
        sum += between(shape, complex.at(a), complex.at(b), complex.at(c));
    }
    return sum;
}

double volume_between(const dsc3::Complex& complex, const Setup& setup, double time) {
    std::vector<Point> points;
    for (const dsc3::InterfaceFace& face : dsc3::interface_faces(complex)) {
        const Point& a = complex.at(face.v[0]);
        const Point b = (complex.at(face.v[1]) - a) / pieces;
        const Point c = (complex.at(face.v[2]) - a) / pieces;
        for (int i = 0; i <= pieces; ++i) {
            for (int j = 0; i + j <= pieces; ++j) {
                points.emplace_back(a + i * b + j * c);
            }
        }
    }
    std::vector<Point> earlier(points.size());
    dsc3::IntegratorScratch scratch;
    scratch.first.resize(points.size());
    for (int k = 0; k < steps_back; ++k) {
        const double from = time * (steps_back - k) / steps_back;
        setup.velocity(points, from, scratch.first);
        dsc3::integrate(dsc3::Integrator::rk4, setup.velocity, points, from, -time / steps_back,
                        earlier, scratch);
        points.swap(earlier);
    }
    double sum = 0;
    const auto add = [&](const Point& a, const Point& b, const Point& c) {
        const auto off = [&](const Point& p) { return std::abs(setup.shapes.front().distance(p)); };
        sum += area(a, b, c) * (off(a) + off(b) + off(c)) / 3;
    };
    for (const Point* face = points.data(); face != points.data() + points.size();
         face += points_of_face) {
        for (int i = 0; i < pieces; ++i) {
            for (int j = 0; i + j < pieces; ++j) {
                const Point& b = face[number(i + 1, j)];
                const Point& c = face[number(i, j + 1)];
                add(face[number(i, j)], b, c);
                if (i + j + 1 < pieces) {
                    add(b, face[number(i + 1, j + 1)], c);
                }
            }
        }
    }
    return sum;
}

VertexErrors vertex_errors(const dsc3::Complex& complex, const dsc3::Distance& shape) {
    VertexErrors errors;
    double squares = 0;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        if (complex.is_interface(dsc3::Vertex{v})) {
            const double off = std::abs(shape(complex.at(v)));
            squares += off * off;
            errors.largest = std::max(errors.largest, off);
            ++errors.vertices;
        }
    }
    errors.rms = std::sqrt(squares / errors.vertices);
    return errors;
}

} // namespace dsc::scenes::space
