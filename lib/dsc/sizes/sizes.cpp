// SPDX-License-Identifier: MIT
#include "dsc/sizes/sizes.h"

#include "dsc/base/error.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/ranges.h"
#include "dsc/sizes/rule.h"

#include <cmath>
#include <queue>
#include <string>

namespace dsc {

template <class Real>
void check_sizes(const SizeOptions<Real>& sizes, Real edge_length) {
    require(sizes.growth == 0 || (sizes.growth > 1 && sizes.growth <= 2), "sizes.growth",
            sizes.growth, "0 (edges of one length), or above 1, up to 2");
    const auto longest = static_cast<double>(sizes.longest);
    require(longest == 0 || (std::isfinite(longest) && sizes.longest >= edge_length),
            "sizes.longest", longest, "0 (no bound), or a length of at least the edge length");
    const auto shortest = static_cast<double>(sizes.shortest);
    require(shortest == 0 || (shortest > 0 && sizes.shortest <= edge_length), "sizes.shortest",
            shortest, "0 (the edge length), or a length of at most the edge length");
    const bool asks = longest != 0 || shortest != 0 || sizes.by_place || sizes.on_interface ||
                      sizes.by_distance || sizes.changes_in_time;
    require(!sizes.is_uniform() || !asks, "sizes.growth", sizes.growth,
            "above 1, up to 2, if any other size option is set");
    require(!sizes.changes_in_time || sizes.by_place || sizes.on_interface, "sizes.changes_in_time",
            1, "false, or set sizes.by_place or sizes.on_interface");
}

namespace {

/// A vertex with its value when it was pushed on the heap.
template <class Real>
struct Reached {
    Real value;
    std::uint32_t vertex;

    // The smallest value on top; equal values by id, so that the order is unique.
    friend bool operator<(const Reached& a, const Reached& b) {
        return a.value != b.value ? a.value > b.value : a.vertex > b.vertex;
    }
};

/// Dijkstra's algorithm in which values also propagate across triangles. With obtuse triangles the
/// value of a vertex may decrease after the vertex was popped; it is then pushed again.
template <class Real>
class March {
public:
    March(const Complex<Real>& complex, std::vector<Real>& values, Real slope)
        : complex_(complex), values_(values), slope_(slope) {}

    void run() {
        for (const Vertex v : vertices(complex_)) {
            if (std::isfinite(values_[v.id])) {
                queue_.push({values_[v.id], v.id});
            }
        }
        while (!queue_.empty()) {
            const Reached<Real> lowest = queue_.top();
            queue_.pop();
            if (lowest.value == values_[lowest.vertex]) {
                reach_from(lowest.vertex);
            }
        }
    }

private:
    void reach_from(std::uint32_t v) {
        if (!gather(complex_, Region{}, v, star_)) {
            return;
        }
        const std::uint32_t n = star_.link_size();
        for (std::uint32_t i = 0; i < n; ++i) {
            const Real ax = star_.x0 - star_.link_x(i);
            const Real ay = star_.y0 - star_.link_y(i);
            Real value = values_[v] + slope_ * std::sqrt(star_.squared_edge(i));
            const auto across = [&](std::uint32_t j) {
                value = std::min(value, min_between<Real>(ax, ay, values_[v],
                                                          star_.link_x(j) - star_.link_x(i),
                                                          star_.link_y(j) - star_.link_y(i),
                                                          values_[star_.link[j]], slope_));
            };
            if (i > 0 || star_.closed) {
                across(i > 0 ? i - 1 : n - 1);
            }
            if (i + 1 < n || star_.closed) {
                across(i + 1 < n ? i + 1 : 0);
            }
            lower(star_.link[i], value);
        }
    }

    void lower(std::uint32_t v, Real value) {
        constexpr Real worth = Real(1e-3); // relative: smaller decreases of the value are ignored
        if (value < values_[v] && !(values_[v] - value < worth * value)) {
            values_[v] = value;
            queue_.push({value, v});
        }
    }

    const Complex<Real>& complex_;
    std::vector<Real>& values_;
    Real slope_;
    std::priority_queue<Reached<Real>> queue_;
    Star<Real> star_;
};

} // namespace

template <class Real>
SizeField<Real>& size_field(Complex<Real>& complex) {
    static const std::string name = "dsc.size";
    if (complex.attributes.contains(name)) {
        return complex.attributes.template get<Vertex, VertexSize<Real>>(name);
    }
    using Size = VertexSize<Real>;
    return complex.attributes.template add<Vertex>(
        name, Size{}, [](const Size& a, const Size& b, double fraction) {
            const auto between = [share = static_cast<Real>(fraction)](Real from, Real to) {
                return std::isfinite(from) && std::isfinite(to) ? from + share * (to - from)
                                                                : std::min(from, to);
            };
            return Size{between(a.length, b.length), between(a.distance, b.distance)};
        });
}

template <class Real>
Real extent_of(const Complex<Real>& complex) {
    const auto [low, high] = bounds_of(complex);
    return std::max((high - low).maxCoeff(), Real(0));
}

template <class Real>
void measure_sizes(Complex<Real>& complex, const SizeOptions<Real>& sizes, Real edge_length,
                   Real time) {
    const SizeRule<Real> rule(sizes, edge_length);
    std::vector<Real> distances;
    std::vector<Real> values(complex.vertex_bound(), std::numeric_limits<Real>::infinity());
    Star<Real> star;
    if (rule.needs_distance()) {
        distances = values;
        for (const Vertex v : vertices(complex)) {
            if (gather(complex, Region{}, v.id, star) && is_on_interface(star)) {
                distances[v.id] = 0;
            }
        }
        March<Real>(complex, distances, Real(1)).run();
    }
    const auto distance = [&](Vertex v) { return distances.empty() ? Real(0) : distances[v.id]; };
    for (const Vertex v : vertices(complex)) {
        if (gather(complex, Region{}, v.id, star)) {
            values[v.id] = rule.own(star, distance(v), time);
        }
    }
    March<Real>(complex, values, rule.slope()).run();
    SizeField<Real>& field = size_field(complex);
    for (const Vertex v : vertices(complex)) {
        field[v] = {values[v.id], distance(v)};
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void check_sizes(const SizeOptions<Real>&, Real);                                     \
    template SizeField<Real>& size_field(Complex<Real>&);                                          \
    template Real extent_of(const Complex<Real>&);                                                 \
    template void measure_sizes(Complex<Real>&, const SizeOptions<Real>&, Real, Real);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
