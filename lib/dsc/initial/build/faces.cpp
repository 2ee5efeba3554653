// SPDX-License-Identifier: MIT
#include "dsc/initial/build/faces.h"

#include "dsc/base/error.h"
#include "dsc/initial/build/walls.h"

#include <string>

namespace dsc::initial {

namespace {

enum class Side : std::uint8_t { left, right };

// Which curve named a face first.
struct Face {
    Phase phase;
    std::uint32_t curve;
    Side side;
};

std::string described(const Face& face) {
    return "phase " + std::to_string(face.phase) + " on the " +
           (face.side == Side::left ? "left" : "right") + " of curve " + std::to_string(face.curve);
}

template <class Real>
class Faces {
public:
    explicit Faces(Complex<Real>& complex)
        : complex_(complex), face_of_(complex.triangle_bound(), no_id) {}

    // Floods the face that begins at this triangle, or compares its phase if that is done.
    void name(std::uint32_t triangle, const Face& face) {
        const std::uint32_t known = face_of_[triangle];
        if (known == no_id) {
            const auto id = static_cast<std::uint32_t>(faces_.size());
            faces_.push_back(face);
            enter(triangle, id);
            stack_.push_back(triangle);
            flood(complex_, stack_, [&](std::uint32_t t) { return enter(t, id); });
        } else if (faces_[known].phase != face.phase) {
            throw InputError({.what = "curves name two phases for one region",
                              .where = "curve " + std::to_string(face.curve),
                              .value = described(face) + ", " + described(faces_[known]),
                              .allowed = "the same phase from all curves around a region"});
        }
    }

private:
    bool enter(std::uint32_t triangle, std::uint32_t face) {
        if (face_of_[triangle] != no_id) {
            return false;
        }
        face_of_[triangle] = face;
        complex_.triangles[triangle].phase = faces_[face].phase;
        return true;
    }

    Complex<Real>& complex_;
    std::vector<std::uint32_t> face_of_; // by triangle
    std::vector<Face> faces_;
    std::vector<std::uint32_t> stack_;
};

} // namespace

template <class Real>
void fill_faces(Complex<Real>& complex, std::span<const CheckedCurve> curves,
                const Chains& chains) {
    const std::vector<Wall> walls = raise_walls(complex, chains);
    Faces<Real> faces(complex);
    for (const Wall& wall : walls) {
        const CheckedCurve& curve = curves[wall.chain];
        faces.name(triangle_of(wall.left), {curve.left, wall.chain, Side::left});
        faces.name(triangle_of(wall.right), {curve.right, wall.chain, Side::right});
    }
    remove_walls(complex, walls);
}

template void fill_faces(Complex<double>&, std::span<const CheckedCurve>, const Chains&);
template void fill_faces(Complex<float>&, std::span<const CheckedCurve>, const Chains&);

} // namespace dsc::initial
