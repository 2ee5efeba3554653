// SPDX-License-Identifier: MIT
#include "measures/interface_outlines.h"

#include "dsc/complex/gather.h"
#include "dsc/passes/interface/curve.h"
#include "dsc/queries/phases.h"

namespace dsc::scenes {

namespace {

/// Whether a cubic passes through this vertex of a loop, between its neighbours. At the domain
/// boundary the curve ends.
template <class Real>
bool is_smooth_at(const Complex<Real>& complex, Vertex before, Vertex at, Vertex after,
                  Star<Real>& star) {
    return gather(complex, dsc::Region{}, at.id, star) && star.closed &&
           interface_edges_of(star).count == 2 &&
           is_smooth<Real>(complex, at.id, complex.position(before), complex.position(at),
                           complex.position(after));
}

} // namespace

template <class Real>
std::vector<Outline> interface_outlines(const Complex<Real>& complex,
                                        const OutlineOptions& options) {
    const int pieces = options.reading == Reading::chords ? 1 : options.samples;
    std::vector<Outline> outlines;
    Star<Real> star;
    const auto is_inside = [&](Phase phase) {
        return options.phase ? phase == *options.phase : phase != exterior_phase;
    };
    for (const VertexLoop& loop : outlines_where(complex, is_inside)) {
        const std::size_t n = loop.size();
        std::vector<std::uint8_t> smooth(n, 0);
        for (std::size_t i = 0; i < n && pieces > 1; ++i) {
            smooth[i] =
                is_smooth_at(complex, loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n], star) ? 1
                                                                                               : 0;
        }
        const auto at = [&](std::size_t i) {
            return Point<double>(complex.position(loop[i % n]).template cast<double>());
        };
        Outline outline;
        outline.reserve(n * static_cast<std::size_t>(pieces));
        for (std::size_t i = 0; i < n; ++i) {
            const CurveNeighbours<double> curve{at(i + n - 1),  at(i),
                                                at(i + 1),      at(i + 2),
                                                smooth[i] != 0, smooth[(i + 1) % n] != 0};
            outline.push_back(curve.p1);
            for (int k = 1; k < pieces; ++k) {
                outline.push_back(curve_point(curve, static_cast<double>(k) / pieces));
            }
        }
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

template std::vector<Outline> interface_outlines(const Complex<double>&, const OutlineOptions&);
template std::vector<Outline> interface_outlines(const Complex<float>&, const OutlineOptions&);

} // namespace dsc::scenes
