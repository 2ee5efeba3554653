// SPDX-License-Identifier: MIT
// Simplices as sets of vertices, and sets of simplices as sets of those: the notation of the thesis
// (section 3.1), in which ids do not matter. Also random subsets.
#pragma once

#include "dsc/complex/complex.h"
#include "thesis/sets/simplex_set.h"

#include <algorithm>
#include <iterator>
#include <random>
#include <set>
#include <vector>

namespace dsc::test {

using Vert = std::vector<std::uint32_t>; // sorted
using Family = std::set<Vert>;

template <class Real>
Vert vert(const Complex<Real>&, Vertex v) {
    return {v.id};
}
template <class Real, class Simplex>
Vert vert(const Complex<Real>& complex, Simplex simplex) {
    Vert result;
    for (const Vertex v : complex.vertices_of(simplex)) {
        result.push_back(v.id);
    }
    std::sort(result.begin(), result.end());
    return result;
}

template <class Real>
Family family(const Complex<Real>& complex, const SimplexSet& set) {
    Family result;
    for (const Vertex v : set.vertices()) {
        result.insert(vert(complex, v));
    }
    for (const Edge e : set.edges()) {
        result.insert(vert(complex, e));
    }
    for (const Triangle t : set.triangles()) {
        result.insert(vert(complex, t));
    }
    return result;
}

// K, computed from the triangles alone, without any of the code under test.
template <class Real>
Family everything(const Complex<Real>& complex) {
    Family result;
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        auto v = complex.triangles[t].v;
        if (v[0] == no_id) {
            continue;
        }
        std::sort(v.begin(), v.end());
        for (unsigned bits = 1; bits < 8; ++bits) {
            Vert face;
            for (unsigned i = 0; i < 3; ++i) {
                if ((bits >> i & 1U) != 0) {
                    face.push_back(v[i]);
                }
            }
            result.insert(face);
        }
    }
    return result;
}

template <class Simplex>
std::vector<Simplex> some_of(const std::vector<Simplex>& list, std::mt19937& random) {
    std::vector<Simplex> result;
    std::copy_if(list.begin(), list.end(), std::back_inserter(result),
                 [&](Simplex) { return random() % 3 == 0; });
    std::shuffle(result.begin(), result.end(), random);
    return result;
}

inline SimplexSet some_of(const SimplexSet& set, std::mt19937& random) {
    return {some_of(set.vertices(), random), some_of(set.edges(), random),
            some_of(set.triangles(), random)};
}

} // namespace dsc::test
