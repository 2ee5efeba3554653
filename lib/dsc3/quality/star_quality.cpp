// SPDX-License-Identifier: MIT
#include "dsc3/quality/star_quality.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace dsc3 {

// Repeats the last corner, which changes no minimum.
void StarQuality::fill_block() {
    while (corners_.size() % lanes != 0) {
        corners_.push_back(corners_.back());
    }
}

// The arithmetic is that of `quality`, in the order of Eigen's functions.
void StarQuality::put_faces(const Complex& complex) {
    blocks_.resize(corners_.size() / lanes);
    const Corner* corner = corners_.data();
    for (Block& block : blocks_) {
        std::array<std::array<Lane, 3>, 3> face; // by vertex and coordinate
        for (std::uint32_t i = 0; i < lanes; ++i) {
            const auto v = complex.face(*corner++);
            for (std::uint32_t j = 0; j < 3; ++j) {
                const Point& p = complex.at(v[j]);
                face[j][0][i] = p.x();
                face[j][1][i] = p.y();
                face[j][2][i] = p.z();
            }
        }
        const Real x = origin_.x();
        const Real y = origin_.y();
        const Real z = origin_.z();
        const auto square = [](Real u, Real v, Real w) { return u * u + v * v + w * w; };
#pragma omp simd
        for (std::uint32_t i = 0; i < lanes; ++i) {
            const Real ax = face[0][0][i] - x;
            const Real ay = face[0][1][i] - y;
            const Real az = face[0][2][i] - z;
            const Real bx = face[1][0][i] - x;
            const Real by = face[1][1][i] - y;
            const Real bz = face[1][2][i] - z;
            const Real cx = face[2][0][i] - x;
            const Real cy = face[2][1][i] - y;
            const Real cz = face[2][2][i] - z;
            const Real ux = bx - ax;
            const Real uy = by - ay;
            const Real uz = bz - az;
            const Real vx = cx - ax;
            const Real vy = cy - ay;
            const Real vz = cz - az;
            const Real plane_x = uy * vz - uz * vy;
            const Real plane_y = uz * vx - ux * vz;
            const Real plane_z = ux * vy - uy * vx;
            block.plane_x[i] = plane_x;
            block.plane_y[i] = plane_y;
            block.plane_z[i] = plane_z;
            block.offset[i] = plane_x * ax + plane_y * ay + plane_z * az;
            block.sum_x[i] = ax + bx + cx;
            block.sum_y[i] = ay + by + cy;
            block.sum_z[i] = az + bz + cz;
            block.squares[i] = square(ax, ay, az) + square(bx, by, bz) + square(cx, cy, cz) +
                               square(ux, uy, uz) + square(vx, vy, vz) +
                               square(cx - bx, cy - by, cz - bz);
        }
    }
}

void StarQuality::gather(const Complex& complex, const Star& star, std::uint32_t without) {
    origin_ = complex.at(star.centre);
    size_ = static_cast<std::uint32_t>(star.corners.size());
    const auto is_left_out = [&](Corner corner) {
        return has_vertex(complex.tets[tet_of(corner)], without);
    };
    corners_ = star.corners;
    if (without != no_id) {
        std::erase_if(corners_, is_left_out);
    }
    const bool leaves_out = corners_.size() < size_;
    fill_block();
    other_blocks_ = corners_.size() / lanes;
    if (leaves_out) {
        std::copy_if(star.corners.begin(), star.corners.end(), std::back_inserter(corners_),
                     is_left_out);
        fill_block();
    }
    put_faces(complex);
}

void StarQuality::gather(const Complex& complex, const EdgeAt& edge, const Ring& ring,
                         const Point& place) {
    origin_ = place;
    size_ = 2 * ring.size;
    corners_.clear();
    for (std::uint32_t i = 0; i < ring.size; ++i) {
        for (const std::uint32_t v : {edge.a, edge.b}) {
            const std::uint32_t t = ring.tets[i];
            corners_.push_back(corner_of(t, index_in(complex.tets[t], v)));
        }
    }
    fill_block();
    other_blocks_ = corners_.size() / lanes;
    put_faces(complex);
}

template <bool stores>
Real StarQuality::evaluate(const Point& p, std::size_t blocks, Real bound) {
    const Real x = p.x() - origin_.x();
    const Real y = p.y() - origin_.y();
    const Real z = p.z() - origin_.z();
    const Real square = 3 * (x * x + y * y + z * z);
    Real worst = std::numeric_limits<Real>::max();
    for (std::size_t k = 0; k < blocks; ++k) {
        Block& block = blocks_[k];
        Real least = std::numeric_limits<Real>::max();
#pragma omp simd reduction(min : least)
        for (std::uint32_t i = 0; i < lanes; ++i) {
            const Real det = block.offset[i] - block.plane_x[i] * x - block.plane_y[i] * y -
                             block.plane_z[i] * z;
            const Real length2 =
                square - 2 * (block.sum_x[i] * x + block.sum_y[i] * y + block.sum_z[i] * z) +
                block.squares[i];
            const Real q = quality_scale * det / (length2 * std::sqrt(length2));
            if constexpr (stores) {
                block.quality[i] = q;
            }
            least = std::min(least, q);
        }
        worst = std::min(worst, least);
        if (worst <= bound) {
            break;
        }
    }
    return worst;
}

template Real StarQuality::evaluate<true>(const Point&, std::size_t, Real);
template Real StarQuality::evaluate<false>(const Point&, std::size_t, Real);

std::uint32_t StarQuality::worst_tet() const {
    Real least = std::numeric_limits<Real>::max();
    std::uint32_t tet = 0;
    for (std::uint32_t i = 0; i < size_; ++i) {
        const Real q = blocks_[i / lanes].quality[i % lanes];
        if (q < least) {
            least = q;
            tet = i;
        }
    }
    return tet;
}

Point StarQuality::gradient(std::uint32_t tet, const Point& p) const {
    const Block& block = blocks_[tet / lanes];
    const std::uint32_t i = tet % lanes;
    const Point r = p - origin_;
    const Point plane(block.plane_x[i], block.plane_y[i], block.plane_z[i]);
    const Point sum(block.sum_x[i], block.sum_y[i], block.sum_z[i]);
    const Real det = block.offset[i] - plane.dot(r);
    const Real length2 = 3 * r.squaredNorm() - 2 * sum.dot(r) + block.squares[i];
    const Real factor = quality_scale / (length2 * std::sqrt(length2));
    return -factor * plane - (1.5 * factor * det / length2) * (6 * r - 2 * sum);
}

Point StarQuality::mean() const {
    Real x = 0;
    Real y = 0;
    Real z = 0;
    for (std::uint32_t i = 0; i < size_; ++i) {
        const Block& block = blocks_[i / lanes];
        x += block.sum_x[i % lanes];
        y += block.sum_y[i % lanes];
        z += block.sum_z[i % lanes];
    }
    return origin_ + Point(x, y, z) / (3.0 * size_);
}

Real StarQuality::length() const { return std::sqrt(blocks_[0].squares[0] / 6); }

} // namespace dsc3
