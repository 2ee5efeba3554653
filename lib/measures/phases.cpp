// SPDX-License-Identifier: MIT
#include "measures/phases.h"

#include "dsc/queries/phases.h"
#include "measures/compensated_sum.h"

#include <map>
#include <utility>

namespace dsc::scenes {

template <class Real>
PhaseReport measure_phases(const Complex<Real>& complex) {
    std::map<Phase, std::pair<PhaseFigures, CompensatedSum>> phases; // with the area
    for (const Component& component : components(complex).list) {
        auto& [figures, area] = phases[component.phase];
        figures.phase = component.phase;
        area.add(component.area);
        ++figures.components;
        figures.holes += component.holes();
    }
    std::map<std::pair<Phase, Phase>, CompensatedSum> lengths;
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            const Phase one = complex.phase_at(c);
            const Phase other = complex.phase_at(complex.twin(c));
            // The border's phase is the largest number, so its edges pass this test as well.
            if (one < other) {
                const auto [a, b] = complex.vertices_of(complex.edge(c));
                lengths[{one, other}].add(
                    (complex.position(a) - complex.position(b)).template cast<double>().norm());
            }
        }
    }
    PhaseReport report;
    for (const auto& [pair, sum] : lengths) {
        const auto [one, other] = pair;
        const double length = sum.value();
        if (other == border_phase) {
            phases[one].first.boundary = length;
        } else {
            phases[one].first.perimeter += length;
            phases[other].first.perimeter += length;
            report.pairs.push_back({one, other, length});
        }
    }
    for (auto& [phase, entry] : phases) {
        entry.first.area = entry.second.value();
        report.phases.push_back(entry.first);
    }
    return report;
}

template PhaseReport measure_phases(const Complex<double>&);
template PhaseReport measure_phases(const Complex<float>&);

} // namespace dsc::scenes
