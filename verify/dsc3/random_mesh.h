// SPDX-License-Identifier: MIT
// Random small complexes in three dimensions, and the invariants of operations.
#pragma once

#include "support/random/complex.h"

#include "dsc3/dsc3.h"
#include "dsc3/initial/lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace dsc3::test {

using dsc::test::Random;

/// A lattice of 4 x 4 x 4 cubes of side 1 with randomly moved vertices, on the sides within these,
/// and up to three blobs of phases 1 and 2, which may touch and reach the sides.
inline Complex random_mesh(std::uint64_t seed) {
    Random random(seed);
    Complex lattice = initial::lattice({{0, 0, 0}, {4, 4, 4}});
    Workspace work;
    for (std::uint32_t v = 0; v < lattice.vertex_bound(); ++v) {
        const Point by(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5);
        nudge(lattice, work, Vertex{v}, lattice.at(v) + 0.8 * by, 1e-3);
    }
    const std::uint32_t blobs = random.below(4);
    for (std::uint32_t blob = 0; blob < blobs; ++blob) {
        const Point centre(1 + 2 * random.unit(), 1 + 2 * random.unit(), 1 + 2 * random.unit());
        const double radius = 0.5 + random.unit();
        const Phase phase = 1 + random.below(2);
        for (std::uint32_t t = 1; t < lattice.tet_bound(); ++t) {
            const auto p = lattice.positions_of(Tet{t});
            if ((0.25 * (p[0] + p[1] + p[2] + p[3]) - centre).norm() < radius) {
                lattice.set_phase(Tet{t}, phase);
            }
        }
    }
    return lattice;
}

/// The volume and the Euler number of the surface of each phase.
struct PhaseFigures {
    std::map<Phase, double> volumes;
    std::map<Phase, std::int64_t> euler;
};

inline PhaseFigures figures(const Complex& complex, const ValidationReport& report) {
    PhaseFigures result;
    for (const PhaseSurface& surface : report.surfaces) {
        result.volumes[surface.phase] = phase_volume(complex, surface.phase);
        result.euler[surface.phase] = surface.euler_characteristic;
    }
    return result;
}

/// The change that an operation may make.
enum class Change : std::uint8_t {
    nothing,  ///< it was refused
    mesh,     ///< only tets: every phase fills the same region
    interface ///< also the interface, but not its topology
};

/// Validates the complex and compares it with its earlier state.
class Watch {
public:
    explicit Watch(const Complex& complex) : complex_(complex) { look(); }

    void expect(Change change, const char* what) {
        const PhaseFigures before = figures_;
        const std::uint64_t hash = hash_;
        look();
        ASSERT_TRUE(report_.ok()) << what << ": " << report_.problem;
        EXPECT_EQ(hash == hash_, change == Change::nothing) << what;
        EXPECT_EQ(before.euler, figures_.euler) << what;
        double total = 0;
        for (const auto& [phase, volume] : figures_.volumes) {
            total += volume;
            if (change != Change::interface) {
                EXPECT_NEAR(volume, before.volumes.at(phase), 1e-12) << what;
            }
        }
        EXPECT_NEAR(total, 64, 1e-11) << what;
    }
    [[nodiscard]] const ValidationReport& report() const { return report_; }

private:
    void look() {
        report_ = validate(complex_);
        figures_ = figures(complex_, report_);
        hash_ = mesh_hash(complex_);
    }

    const Complex& complex_;
    ValidationReport report_;
    PhaseFigures figures_;
    std::uint64_t hash_ = 0;
};

} // namespace dsc3::test
