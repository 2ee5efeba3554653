// SPDX-License-Identifier: MIT
#include "scenes/space/measure.h"

#include "dsc3/dsc3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <unordered_map>
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
std::size_t number(int i, int j) {
    return static_cast<std::size_t>(i * (pieces + 1) - i * (i - 1) / 2 + j);
}

// The vertices of all pieces. Those on an edge belong to several faces, but are there once.
struct Pieces {
    std::vector<Point> points;
    std::vector<std::array<std::uint32_t, points_of_face>> faces; // their points, by `number`
};

Pieces cut_faces(const dsc3::Complex& complex) {
    Pieces result;
    auto& points = result.points;
    std::vector<std::uint32_t> places(complex.vertex_bound(), dsc3::no_id);
    std::unordered_map<std::uint64_t, std::uint32_t> edges; // the first point inside each
    const auto add = [&](const Point& p) {
        points.push_back(p);
        return static_cast<std::uint32_t>(points.size() - 1);
    };
    const auto at_vertex = [&](std::uint32_t v) {
        return places[v] == dsc3::no_id ? places[v] = add(complex.at(v)) : places[v];
    };
    const auto on_edge = [&](std::uint32_t a, std::uint32_t b, int k) {
        const auto [low, high] = std::minmax(a, b);
        const auto [edge, is_new] = edges.try_emplace(std::uint64_t{low} << 32U | high,
                                                      static_cast<std::uint32_t>(points.size()));
        for (int i = 1; is_new && i < pieces; ++i) {
            add(complex.at(low) + i * ((complex.at(high) - complex.at(low)) / pieces));
        }
        return edge->second + static_cast<std::uint32_t>((a < b ? k : pieces - k) - 1);
    };
    for (const dsc3::InterfaceFace& face : dsc3::interface_faces(complex)) {
        const auto [a, b, c] = face.v;
        const Point to_b = (complex.at(b) - complex.at(a)) / pieces;
        const Point to_c = (complex.at(c) - complex.at(a)) / pieces;
        auto& its = result.faces.emplace_back();
        for (int i = 0; i <= pieces; ++i) {
            for (int j = 0; i + j <= pieces; ++j) {
                const int k = pieces - i - j;
                its[number(i, j)] = k == pieces   ? at_vertex(a)
                                    : i == pieces ? at_vertex(b)
                                    : j == pieces ? at_vertex(c)
                                    : j == 0      ? on_edge(a, b, i)
                                    : i == 0      ? on_edge(a, c, j)
                                    : k == 0      ? on_edge(b, c, j)
                                                  : add(complex.at(a) + i * to_b + j * to_c);
            }
        }
    }
    return result;
}

// Moves points back from a time to time 0.
void move_back(std::span<Point> points, const dsc3::Velocity& velocity, double time) {
    std::vector<Point> earlier(points.size());
    dsc3::IntegratorScratch scratch;
    scratch.first.resize(points.size());
    for (int k = 0; k < steps_back; ++k) {
        const double from = time * (steps_back - k) / steps_back;
        velocity(points, from, scratch.first);
        dsc3::integrate(dsc3::Integrator::rk4, velocity, points, from, -time / steps_back, earlier,
                        scratch);
        std::copy(earlier.begin(), earlier.end(), points.begin());
    }
}

} // namespace

double volume_between(const dsc3::Complex& complex, const dsc3::Distance& shape) {
    double sum = 0;
    for (const dsc3::InterfaceFace& face : dsc3::interface_faces(complex)) {
        const auto& [a, b, c] = face.v;
        sum += between(shape, complex.at(a), complex.at(b), complex.at(c));
    }
    return sum;
}

double volume_between(const dsc3::Complex& complex, const Setup& setup, double time,
                      std::uint32_t threads) {
    Pieces cut = cut_faces(complex);
    std::vector<double> off(cut.points.size());
    dsc3::Team team(threads, false);
    constexpr std::size_t grain = 256;
    team.chunks(
        off.size(), grain, [&](std::uint32_t, std::size_t begin, std::size_t end, std::uint32_t) {
            move_back(std::span(cut.points).subspan(begin, end - begin), setup.velocity, time);
            for (std::size_t k = begin; k < end; ++k) {
                off[k] = std::abs(setup.shapes.front().distance(cut.points[k]));
            }
        });
    double sum = 0;
    for (const auto& face : cut.faces) {
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            sum +=
                area(cut.points[a], cut.points[b], cut.points[c]) * (off[a] + off[b] + off[c]) / 3;
        };
        for (int i = 0; i < pieces; ++i) {
            for (int j = 0; i + j < pieces; ++j) {
                const std::uint32_t b = face[number(i + 1, j)];
                const std::uint32_t c = face[number(i, j + 1)];
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
