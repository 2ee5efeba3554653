// SPDX-License-Identifier: MIT
#include "dsc3/queries/phases.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc3 {

Real phase_volume(const Complex& complex, Phase phase) {
    Real sum = 0;
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        if (complex.phases[t] == phase && complex.is_alive(Tet{t})) {
            const auto p = complex.positions_of(Tet{t});
            sum += volume(p[0], p[1], p[2], p[3]);
        }
    }
    return sum;
}

std::vector<InterfaceFace> interface_faces(const Complex& complex) {
    std::vector<InterfaceFace> faces;
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        if (!complex.is_alive(Tet{t})) {
            continue;
        }
        for (std::uint32_t i = 0; i < 4; ++i) {
            const Phase beyond = complex.phase_at(complex.tets[t].n[i]);
            if (beyond < complex.phases[t]) { // the border's phase is the largest
                faces.push_back({complex.face(corner_of(t, i)), complex.phases[t], beyond});
            }
        }
    }
    return faces;
}

namespace {

// An angle is computed only if it may be an extreme: arc tangents cost more than all the rest.
// Sines decide, with this factor for rounding.
constexpr Real slack_of_sines = 1.002;

// A bound of the squared sines of angles that are below `smallest` or, where that is above a right
// angle, beyond `largest`; so large that nothing is beyond it, as long as they are not known.
Real square_of_sine(Real smallest, Real largest = 180) {
    constexpr Real degree = std::numbers::pi / 180;
    const Real sine = std::max(std::sin(smallest * degree), std::sin(largest * degree));
    return smallest <= 90 && largest >= 90 ? slack_of_sines * sine * sine : 2;
}

class Extremes {
public:
    void add_tet(const std::array<Point, 4>& p) {
        const Real here = quality(p[0], p[1], p[2], p[3]);
        found_.worst = std::min(found_.worst, here);
        if (here < relevant_ && may_have_extreme(p)) {
            const DihedralAngles angles = dihedral_angles(p);
            found_.min_dihedral = std::min(found_.min_dihedral, angles.smallest);
            found_.max_dihedral = std::max(found_.max_dihedral, angles.largest);
            dihedral_ = square_of_sine(found_.min_dihedral, found_.max_dihedral);
            relevant_ = std::sqrt(2 * dihedral_);
        }
    }
    // The smallest angle is opposite to the shortest side, between the two others.
    void add_face(const Point& a, const Point& b, const Point& c) {
        const Real ab = squared_distance(a, b);
        const Real bc = squared_distance(b, c);
        const Real ca = squared_distance(c, a);
        const Real square = (b - a).cross(c - a).squaredNorm();
        if (square * std::min({ab, bc, ca}) <= face_ * (ab * bc * ca)) {
            found_.min_face_angle = std::min(found_.min_face_angle, min_angle_degrees(a, b, c));
            face_ = square_of_sine(found_.min_face_angle);
        }
    }
    [[nodiscard]] const MeshQuality& found() const { return found_; }

private:
    // The sine of a dihedral angle is det * l / (n m): l is the length of its edge; n = l g and
    // m = l h are twice the areas of its faces, with heights g and h over the edge. The two other
    // edges of a face have squares that sum to at least l^2 / 2 + 2 g^2, so the sum S of all six is
    // at least 2 (l^2 + g^2 + h^2), and l g h is at most (S / 6)^1.5. So the sine is at least
    // quality / sqrt(2), and no tet of the quality `relevant_` has a more extreme angle. Those of
    // less are asked one by one.
    [[nodiscard]] bool may_have_extreme(const std::array<Point, 4>& p) const {
        std::array<Real, 4> areas{}; // twice, squared, of the faces opposite to the points
        for (std::uint32_t i = 0; i < 4; ++i) {
            const auto& [a, b, c] = face_indices[i];
            areas[i] = (p[b] - p[a]).cross(p[c] - p[a]).squaredNorm();
        }
        const Real det = determinant(p[0], p[1], p[2], p[3]);
        for (std::uint32_t i = 0; i < 4; ++i) {
            for (std::uint32_t j = i + 1; j < 4; ++j) {
                const std::uint32_t k = j == i + 1 ? (j + 1) % 4 : i + 1;
                if (det * det * squared_distance(p[i], p[j]) <=
                    dihedral_ * areas[k] * areas[6 - i - j - k]) {
                    return true;
                }
            }
        }
        return false;
    }

    MeshQuality found_;
    Real relevant_ = 2;
    Real dihedral_ = 2; ///< squares of sines
    Real face_ = 2;
};

} // namespace

MeshQuality& MeshQuality::operator+=(const MeshQuality& other) {
    worst = std::min(worst, other.worst);
    min_dihedral = std::min(min_dihedral, other.min_dihedral);
    max_dihedral = std::max(max_dihedral, other.max_dihedral);
    min_face_angle = std::min(min_face_angle, other.min_face_angle);
    return *this;
}

MeshQuality mesh_quality(const Complex& complex, std::uint32_t first, std::uint32_t last) {
    Extremes extremes;
    for (std::uint32_t t = std::max(first, 1U); t < std::min(last, complex.tet_bound()); ++t) {
        if (!complex.is_alive(Tet{t})) {
            continue;
        }
        extremes.add_tet(complex.positions_of(Tet{t}));
        for (std::uint32_t i = 0; i < 4; ++i) {
            if (complex.phase_at(complex.tets[t].n[i]) < complex.phases[t]) {
                const auto [a, b, c] = complex.face(corner_of(t, i));
                extremes.add_face(complex.at(a), complex.at(b), complex.at(c));
            }
        }
    }
    return extremes.found();
}

MeshQuality mesh_quality(const Complex& complex) {
    return mesh_quality(complex, 1, complex.tet_bound());
}

} // namespace dsc3
