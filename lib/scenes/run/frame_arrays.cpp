// SPDX-License-Identifier: MIT
#include "scenes/run/frame_arrays.h"

#include "dsc/complex/ranges.h"
#include "dsc/sizes/sizes.h"

#include <algorithm>

namespace dsc::scenes {

namespace {

const std::string before_name = "scene.before";

template <class Real>
std::vector<double> displacements(const Complex<Real>& complex) {
    std::vector<double> numbers(2 * std::size_t{complex.vertex_bound()}, 0);
    if (!complex.attributes.contains(before_name)) {
        return numbers;
    }
    const auto& before = complex.attributes.template get<Vertex, Point<Real>>(before_name);
    for (const Vertex v : vertices(complex)) {
        const Point<Real> way = complex.position(v) - before[v];
        numbers[2 * v.id] = static_cast<double>(way.x());
        numbers[2 * v.id + 1] = static_cast<double>(way.y());
    }
    return numbers;
}

template <class Real>
std::vector<double> velocities(const Complex<Real>& complex, const FrameView<Real>& view,
                               std::vector<double> ways) {
    if (view.velocity == nullptr) {
        const double rate = view.dt > 0 ? 1 / static_cast<double>(view.dt) : 0;
        std::ranges::for_each(ways, [rate](double& way) { way *= rate; });
        return ways;
    }
    std::vector<Point<Real>> positions;
    for (const Vertex v : vertices(complex)) {
        positions.push_back(complex.position(v));
    }
    std::vector<Point<Real>> found(positions.size(), Point<Real>(0, 0));
    (*view.velocity)(positions, view.time, found);
    std::size_t i = 0;
    for (const Vertex v : vertices(complex)) {
        ways[2 * v.id] = static_cast<double>(found[i].x());
        ways[2 * v.id + 1] = static_cast<double>(found[i].y());
        ++i;
    }
    return ways;
}

template <class Real>
std::vector<double> sizes(Complex<Real>& complex, const FrameView<Real>& view) {
    std::vector<double> numbers(complex.triangle_bound(), static_cast<double>(view.edge_length));
    if (view.is_uniform) {
        return numbers;
    }
    const SizeField<Real>& field = size_field(complex);
    for (const Triangle t : triangles(complex)) {
        double sum = 0;
        for (const Vertex v : complex.vertices_of(t)) {
            sum += static_cast<double>(field[v].length);
        }
        numbers[t.id] = sum / 3;
    }
    return numbers;
}

template <class Real>
std::vector<std::int32_t> submeshes(const Complex<Real>& complex, const Partition* partition) {
    const bool is_divided = partition != nullptr && !partition->colours.empty();
    std::vector<std::int32_t> numbers(complex.triangle_bound(), is_divided ? -1 : 0);
    if (!is_divided) {
        return numbers;
    }
    const Colour& colour = partition->colours.front();
    std::vector<std::size_t> owners(complex.vertex_bound(), 0);
    std::size_t hint = 0;
    for (const Vertex v : vertices(complex)) {
        const Point<double> p = complex.position(v).template cast<double>();
        hint = colour.locate(v.id, p.x(), p.y(), hint);
        owners[v.id] = hint;
    }
    for (const Triangle t : triangles(complex)) {
        const auto v = complex.vertices_of(t);
        const std::size_t owner = owners[v[0].id];
        if (owner == owners[v[1].id] && owner == owners[v[2].id] && owner < colour.regions.size()) {
            numbers[t.id] = static_cast<std::int32_t>(owner);
        }
    }
    return numbers;
}

} // namespace

template <class Real>
void begin_displacements(Complex<Real>& complex) {
    auto& before = complex.attributes.template add<Vertex>(before_name, Point<Real>(0, 0));
    for (const Vertex v : vertices(complex)) {
        before[v] = complex.position(v);
    }
}

template <class Real>
void end_displacements(Complex<Real>& complex) {
    if (complex.attributes.contains(before_name)) {
        complex.attributes.remove(before_name);
    }
}

template <class Real>
std::vector<VtuArray> frame_arrays(Complex<Real>& complex, const FrameView<Real>& view) {
    std::vector<double> ways = displacements(complex);
    std::vector<double> rates = velocities(complex, view, ways);
    return {{"velocity", SimplexKind::vertex, 2, std::move(rates)},
            {"displacement", SimplexKind::vertex, 2, std::move(ways)},
            {"size", SimplexKind::triangle, 1, sizes(complex, view)},
            {"submesh", SimplexKind::triangle, 1, submeshes(complex, view.partition)}};
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void begin_displacements(Complex<Real>&);                                             \
    template void end_displacements(Complex<Real>&);                                               \
    template std::vector<VtuArray> frame_arrays(Complex<Real>&, const FrameView<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::scenes
