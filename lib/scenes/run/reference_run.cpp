// SPDX-License-Identifier: MIT
#include "scenes/run/reference_run.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "measures/interface_outlines.h"
#include "scenes/run/start.h"

#include <string>

namespace dsc::scenes {

reference::Complex to_reference(const Complex<double>& complex) {
    std::vector<Point<double>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Phase> phases;
    std::vector<std::uint32_t> number(complex.vertex_bound(), no_id);
    for (const Vertex v : vertices(complex)) {
        if (complex.vertices[v.id].corner != no_id) {
            number[v.id] = static_cast<std::uint32_t>(points.size());
            points.push_back(complex.position(v));
        }
    }
    for (const Triangle t : dsc::triangles(complex)) {
        const auto& v = complex.triangles[t.id].v;
        triangles.push_back({number[v[0]], number[v[1]], number[v[2]]});
        phases.push_back(complex.phase(t));
    }
    return reference::make_complex(points, triangles, phases);
}

Complex<double> from_reference(const reference::Complex& complex) {
    std::vector<Point<double>> points;
    std::vector<std::uint32_t> number(complex.vertex_bound(), no_id);
    for (const Vertex v : complex.vertices()) {
        number[v.id] = static_cast<std::uint32_t>(points.size());
        points.push_back(complex.coord(v));
    }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Phase> phases;
    for (const auto& [key, oriented] : complex.triangles()) {
        triangles.push_back(
            {number[oriented[0].id], number[oriented[1].id], number[oriented[2].id]});
        phases.push_back(complex.phase(key));
    }
    return make_complex<double>(points, triangles, phases);
}

namespace {

InputError not_in_reference(const char* key, std::string_view value) {
    return InputError({.what = "the reference does not support this",
                       .where = key,
                       .value = std::string(value),
                       .allowed = "options of the thesis; see reference/README.md"});
}

} // namespace

reference::Options reference_options(const Parameters& parameters) {
    reference::Options options;
    options.passes.edge_length = parameters.h;
    options.passes.interface_point = parameters.insertion == Insertion::cubic
                                         ? &reference::cubic_point
                                         : &reference::linear_point;
    switch (parameters.integrator) {
    case IntegratorChoice::euler: options.integrator = reference::Integrator::euler; break;
    case IntegratorChoice::midpoint: options.integrator = reference::Integrator::midpoint; break;
    case IntegratorChoice::rk4: options.integrator = reference::Integrator::rk4; break;
    case IntegratorChoice::centred:
    case IntegratorChoice::adaptive:
        throw not_in_reference("--set integrator", to_string(parameters.integrator));
    }
    if (parameters.interface.reading != Reading::chords) {
        throw not_in_reference("--set reading", to_string(parameters.interface.reading));
    }
    if (parameters.grade != 0) {
        throw not_in_reference("--set grade", std::to_string(parameters.grade));
    }
    return options;
}

ReferenceMethod::ReferenceMethod(const Setup& setup, const Parameters& parameters,
                                 const RunOptions&, InputReport* report)
    : setup_(setup), method_(to_reference(first_complex<double>(setup, parameters, report))),
      options_(reference_options(parameters)) {
    if (setup.insertion) {
        const OnCircle on_circle = *setup.insertion;
        options_.passes.interface_point =
            [on_circle](const Point<double>& p0, const Point<double>& p1, const Point<double>& p2,
                        const Point<double>& p3) {
                return on_circle(CurveNeighbours<double>{.p0 = p0, .p1 = p1, .p2 = p2, .p3 = p3});
            };
    }
}

void ReferenceMethod::step(double begin, double end, RunResult& result) {
    const Velocity& velocity = velocity_of_step(setup_.flow, begin, end);
    const reference::Velocity one = [&velocity](const Point<double>& p, double at) {
        Point<double> v;
        velocity({&p, 1}, at, {&v, 1});
        return v;
    };
    const reference::StepCounts counts = reference::step(method_, one, begin, setup_.dt, options_);
    stale_ = true;
    result.unreached += counts.unreached;
    result.sub_steps += counts.substeps;
    auto& o = result.operations;
    o["moves"] += counts.moved;
    o["flips"] += counts.flips;
    o["splits"] += counts.splits;
    o["collapses"] += counts.collapses;
    o["smoothed"] += counts.smoothed;
    o["subdivisions"] += counts.subdivisions;
    o["retriangulations"] += counts.retriangulations;
}

const Complex<double>& ReferenceMethod::complex() {
    if (stale_) {
        converted_ = from_reference(method_);
        stale_ = false;
    }
    return converted_;
}

std::uint64_t ReferenceMethod::interface_vertices() {
    std::uint64_t count = 0;
    for (const Outline& outline : interface_outlines(complex())) {
        count += outline.size();
    }
    return count;
}

} // namespace dsc::scenes
