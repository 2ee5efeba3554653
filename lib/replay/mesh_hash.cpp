// SPDX-License-Identifier: MIT
#include "replay/mesh_hash.h"

#include "dsc/complex/ranges.h"

#include <algorithm>
#include <array>
#include <bit>

namespace dsc {

namespace {

// The finaliser of SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number
// generators", 2014, with Stafford's constants): a bijection of 64 bits in which each bit of the
// input flips half the bits of the output.
std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

std::uint64_t bits_of(double value) {
    return std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value); // -0.0 == 0
}

} // namespace

template <class Real>
std::uint64_t mesh_hash(const Complex<Real>& complex) {
    std::uint64_t sum = 0; // commutative, so that the order of triangles does not matter
    for (const Triangle t : triangles(complex)) {
        std::array<std::array<double, 2>, 3> p{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& vertex = complex.vertices[complex.triangles[t.id].v[i]];
            p[i] = {static_cast<double>(vertex.x), static_cast<double>(vertex.y)};
        }
        std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
        std::uint64_t hash = mix(complex.phase(t));
        for (const auto& corner : p) {
            hash = mix(hash ^ bits_of(corner[0]));
            hash = mix(hash ^ bits_of(corner[1]));
        }
        sum += hash;
    }
    return mix(sum);
}

template std::uint64_t mesh_hash(const Complex<double>&);
template std::uint64_t mesh_hash(const Complex<float>&);

} // namespace dsc
