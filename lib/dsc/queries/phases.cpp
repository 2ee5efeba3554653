// SPDX-License-Identifier: MIT
#include "dsc/queries/phases.h"

#include "dsc/base/types.h"
#include "dsc/geometry/triangle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dsc {

template <class Real>
std::vector<Phase> phases(const Complex<Real>& complex) {
    std::vector<Phase> found;
    for (const Triangle t : triangles(complex)) {
        const Phase phase = complex.phase(t);
        const auto place = std::lower_bound(found.begin(), found.end(), phase);
        if (place == found.end() || *place != phase) {
            found.insert(place, phase);
        }
    }
    return found;
}

namespace {

// Uses plain numbers, because Eigen's vectors would be stored and loaded again.
template <class Real>
double area_in_double(const Complex<Real>& complex, Triangle t) {
    const auto& v = complex.triangles[t.id].v;
    const auto x = [&](std::size_t i) { return static_cast<double>(complex.vertices[v[i]].x); };
    const auto y = [&](std::size_t i) { return static_cast<double>(complex.vertices[v[i]].y); };
    return ((x(1) - x(0)) * (y(2) - y(0)) - (y(1) - y(0)) * (x(2) - x(0))) / 2;
}

} // namespace

template <class Real>
double phase_area(const Complex<Real>& complex, Phase phase) {
    // Neumaier's sum: the rounding error of each addition is accumulated separately.
    double sum = 0;
    double lost = 0;
    for (const Triangle t : triangles(complex, phase)) {
        const double area = area_in_double(complex, t);
        const double next_sum = sum + area;
        lost += std::abs(sum) >= std::abs(area) ? (sum - next_sum) + area : (area - next_sum) + sum;
        sum = next_sum;
    }
    return sum + lost;
}

namespace {

// The interface as half-edges that have the larger phase on their left.
template <class Real>
class Interface {
public:
    explicit Interface(const Complex<Real>& complex)
        : complex_(complex), half_edges_(complex, [&](Corner c) {
              const Phase inside = complex.phase_at(c);
              const Phase across = complex.phase_at(complex.twin(c));
              return across == border_phase ? inside != exterior_phase : inside > across;
          }) {}

    std::vector<InterfaceCurve> curves() {
        std::vector<InterfaceCurve> list;
        for (Corner c = half_edges_.first_left(); c != no_id; c = half_edges_.first_left()) {
            list.push_back(take_curve(c));
        }
        return list;
    }

private:
    InterfaceCurve take_curve(Corner c) {
        InterfaceCurve curve;
        const Corner begin = find_begin(c, curve.is_closed);
        curve.left = complex_.phase_at(begin);
        curve.right = complex_.phase_at(complex_.twin(begin));
        for (Corner at = begin; at != no_id; at = following(at)) {
            if (!half_edges_.take(at)) {
                return curve; // closed
            }
            curve.vertices.push_back(Vertex{complex_.vertex(next(at))});
            c = at;
        }
        curve.vertices.push_back(Vertex{complex_.vertex(prev(c))});
        return curve;
    }
    // The test for edges of the phase on the left, with any phase on their other side.
    [[nodiscard]] auto around(Phase left) const {
        return [this, left](Corner c) { return complex_.phase_at(complex_.twin(c)) != left; };
    }

    // Walks back to the first half-edge of the curve, or all the way around to `c`.
    [[nodiscard]] Corner find_begin(Corner c, bool& is_closed) const {
        Corner begin = c;
        while (true) {
            const Corner before = previous_along(complex_, begin, around(complex_.phase_at(begin)));
            if (!goes_on(before, begin)) {
                return begin;
            }
            if (before == c) {
                is_closed = true;
                return c;
            }
            begin = before;
        }
    }
    [[nodiscard]] Corner following(Corner c) const {
        const Corner after = next_along(complex_, c, around(complex_.phase_at(c)));
        return goes_on(c, after) ? after : no_id;
    }
    // Whether these two are the only interface edges at the vertex at which the first one ends and
    // the second one starts. On the left there is no interface edge between them. So either
    // both are edges of the domain boundary, or turning from the other side of the second edge
    // leads to the first one without meeting another phase or the border.
    [[nodiscard]] bool goes_on(Corner before, Corner after) const {
        Corner beyond = complex_.twin(after);
        const Corner wanted = complex_.twin(before);
        if (is_border(beyond) || is_border(wanted)) {
            return is_border(beyond) && is_border(wanted);
        }
        const Phase right = complex_.phase_at(beyond);
        while (true) {
            // The half-edge of `beyond` ends at the vertex; the next one of its triangle starts
            // there.
            beyond = next(beyond);
            if (beyond == wanted) {
                return true;
            }
            beyond = complex_.twin(beyond);
            if (complex_.phase_at(beyond) != right) {
                return false;
            }
        }
    }

    const Complex<Real>& complex_;
    HalfEdges half_edges_;
};

} // namespace

template <class Real>
std::vector<InterfaceCurve> interface_curves(const Complex<Real>& complex) {
    return Interface<Real>(complex).curves();
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::vector<Phase> phases(const Complex<Real>&);                                      \
    template double phase_area(const Complex<Real>&, Phase);                                       \
    template std::vector<InterfaceCurve> interface_curves(const Complex<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
