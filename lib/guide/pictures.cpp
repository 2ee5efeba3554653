// SPDX-License-Identifier: MIT
// Draws the pictures of the guide: `dsc_guide_pictures FOLDER`. The files are the same on every
// machine, so that a test can compare them with those in lib/guide/pictures.
#include "dsc/dsc.h"
#include "geometric_flows/geometric_flows.h"
#include "thesis/sets/algebra.h"

#include <cmath>
#include <iostream>
#include <numbers>

using namespace dsc;

namespace {

constexpr double size_px = 220;

std::string folder;

// The whole domain, or a part of it with bolder edges.
void draw(const Complex<double>& complex, const std::string& name, const Rectangle& view = {},
          double edge_width_px = 0.6) {
    write_svg(complex, folder + "/" + name + ".svg",
              {.size_px = size_px,
               .margin_px = 3,
               .edge_width_px = edge_width_px,
               .interface_width_px = 2,
               .edge_colour = "#666666",
               .view = view});
}

void draw_detail(const Complex<double>& complex, const std::string& name) {
    draw(complex, name, {{0.22, 0.1}, {0.82, 0.7}}, 1.2);
}

std::vector<Point<double>> circle(const Point<double>& centre, double radius) {
    std::vector<Point<double>> points;
    for (int i = 0; i < 48; ++i) {
        const double angle = 2 * std::numbers::pi * i / 48;
        points.emplace_back(centre + radius * Point<double>(std::cos(angle), std::sin(angle)));
    }
    return points;
}

// A few large triangles, all of the exterior.
Complex<double> few_triangles() {
    return initial_complex<double>({}, std::initializer_list<Shape>{}, {.edge_length = 0.26});
}

Vertex nearest_vertex(const Complex<double>& complex, const Point<double>& place) {
    return std::ranges::min(vertices(complex), {},
                            [&](Vertex v) { return squared_distance(complex.position(v), place); });
}

void colour_star(Complex<double>& complex, Vertex v) {
    for (const Triangle t : star_triangles(complex, v)) {
        complex.set_phase(t, 1);
    }
}

// Three operations, each before and after; the triangles that change are coloured.
void draw_operations() {
    auto complex = few_triangles();
    const Vertex centre = nearest_vertex(complex, {0.5, 0.5});
    colour_star(complex, centre);
    draw_detail(complex, "star");
    const Vertex neighbour = *link_vertices(complex, centre).begin();

    auto collapsed = complex;
    edge_collapse(collapsed, collapsed.find_edge(centre, neighbour), centre);
    draw_detail(collapsed, "collapse");

    auto pair = few_triangles();
    const Edge edge = pair.find_edge(centre, neighbour);
    for (const Triangle t : star(pair, edge).triangles()) {
        pair.set_phase(t, 1);
    }
    draw_detail(pair, "edge");
    auto split = pair;
    edge_split(split, edge);
    draw_detail(split, "split");
    edge_flip(pair, edge);
    draw_detail(pair, "flip");
}

// A disc, and its shape after sixty steps in a swirl.
void draw_swirl() {
    constexpr double h = 0.06;
    const std::vector<Shape> shapes{{circle({0.5, 0.72}, 0.18), 1}};
    auto complex = initial_complex<double>({}, shapes, {.edge_length = h});
    draw(complex, "disc");
    const Velocity<double> swirl = [](auto positions, double, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Point<double> p = std::numbers::pi * positions[i];
            velocities[i] = {std::pow(std::sin(p.x()), 2) * std::sin(2 * p.y()),
                             -std::pow(std::sin(p.y()), 2) * std::sin(2 * p.x())};
        }
    };
    Simulation<double> simulation(complex, {.edge_length = h});
    for (int step = 0; step < 60; ++step) {
        simulation.step(swirl, 0.02 * step, 0.02);
    }
    draw(complex, "swirl");
}

// Three phases that meet at junctions, before and after relaxation.
void draw_junctions() {
    const std::vector<Curve> curves{
        {.points = {{0, 0.5}, {0.25, 0.5}}, .left = 2, .right = 0},
        {.points = {{0.75, 0.5}, {1, 0.5}}, .left = 2, .right = 0},
        {.points = {{0.75, 0.5}, {0.75, 0.7}, {0.25, 0.7}, {0.25, 0.5}}, .left = 1, .right = 2},
        {.points = {{0.25, 0.5}, {0.25, 0.3}, {0.75, 0.3}, {0.75, 0.5}}, .left = 1, .right = 0}};
    auto complex = initial_complex<double>({}, curves, {.edge_length = 0.06});
    draw(complex, "block");
    Options<double> options{.edge_length = 0.06};
    options.interface.feature_degrees = 180; // curvature smooths every feature
    Simulation<double> simulation(complex, options);
    const auto flow = curvature_flow<double>({.kept_areas = {{1, phase_area(complex, 1)}}});
    for (int step = 0; step < 100; ++step) {
        simulation.step(flow, 0.001 * step, 0.001);
    }
    draw(complex, "lens");
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: dsc_guide_pictures FOLDER\n";
        return 2;
    }
    folder = argv[1];
    try {
        draw_operations();
        draw_swirl();
        draw_junctions();
    } catch (const std::exception& error) {
        std::cerr << "dsc_guide_pictures: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
