// SPDX-License-Identifier: MIT
#include "thesis/sets/simplex_set.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace dsc {

namespace {

template <class Simplex>
void sort_unique(std::vector<Simplex>& list) {
    if (!std::is_sorted(list.begin(), list.end())) {
        std::sort(list.begin(), list.end());
    }
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

template <class Simplex>
bool insert_sorted(std::vector<Simplex>& list, Simplex simplex) {
    if (list.empty() || list.back() < simplex) {
        list.push_back(simplex);
        return true;
    }
    const auto place = std::lower_bound(list.begin(), list.end(), simplex);
    if (place != list.end() && *place == simplex) {
        return false;
    }
    list.insert(place, simplex);
    return true;
}

template <class Simplex>
std::vector<Simplex> unite(const std::vector<Simplex>& a, const std::vector<Simplex>& b) {
    std::vector<Simplex> result;
    result.reserve(a.size() + b.size());
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
}

template <class Simplex>
std::vector<Simplex> subtract(const std::vector<Simplex>& a, const std::vector<Simplex>& b) {
    std::vector<Simplex> result;
    result.reserve(a.size());
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
}

template <class Simplex>
std::vector<Simplex> intersect(const std::vector<Simplex>& a, const std::vector<Simplex>& b) {
    std::vector<Simplex> result;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
}

void check_dimension(int k, const char* where) {
    if (k < 0 || k > 2) {
        throw InputError({.what = "no such dimension",
                          .where = where,
                          .value = std::to_string(k),
                          .allowed = "0, 1 or 2"});
    }
}

} // namespace

SimplexSet::SimplexSet(std::vector<Vertex> vertices, std::vector<Edge> edges,
                       std::vector<Triangle> triangles)
    : vertices_(std::move(vertices)), edges_(std::move(edges)), triangles_(std::move(triangles)) {
    sort_unique(vertices_);
    sort_unique(edges_);
    sort_unique(triangles_);
}

bool SimplexSet::contains(Vertex v) const {
    return std::binary_search(vertices_.begin(), vertices_.end(), v);
}

bool SimplexSet::contains(Edge e) const {
    return std::binary_search(edges_.begin(), edges_.end(), e);
}

bool SimplexSet::contains(Triangle t) const {
    return std::binary_search(triangles_.begin(), triangles_.end(), t);
}

bool SimplexSet::contains(const SimplexSet& other) const {
    const auto holds = [](const auto& a, const auto& b) {
        return std::includes(a.begin(), a.end(), b.begin(), b.end());
    };
    return holds(vertices_, other.vertices_) && holds(edges_, other.edges_) &&
           holds(triangles_, other.triangles_);
}

bool SimplexSet::insert(Vertex v) { return insert_sorted(vertices_, v); }
bool SimplexSet::insert(Edge e) { return insert_sorted(edges_, e); }
bool SimplexSet::insert(Triangle t) { return insert_sorted(triangles_, t); }
void SimplexSet::insert(const SimplexSet& other) { *this = *this | other; }

void SimplexSet::clear() {
    vertices_.clear();
    edges_.clear();
    triangles_.clear();
}

SimplexSet operator|(const SimplexSet& a, const SimplexSet& b) {
    SimplexSet result;
    result.vertices_ = unite(a.vertices_, b.vertices_);
    result.edges_ = unite(a.edges_, b.edges_);
    result.triangles_ = unite(a.triangles_, b.triangles_);
    return result;
}

SimplexSet operator-(const SimplexSet& a, const SimplexSet& b) {
    SimplexSet result;
    result.vertices_ = subtract(a.vertices_, b.vertices_);
    result.edges_ = subtract(a.edges_, b.edges_);
    result.triangles_ = subtract(a.triangles_, b.triangles_);
    return result;
}

SimplexSet operator&(const SimplexSet& a, const SimplexSet& b) {
    SimplexSet result;
    result.vertices_ = intersect(a.vertices_, b.vertices_);
    result.edges_ = intersect(a.edges_, b.edges_);
    result.triangles_ = intersect(a.triangles_, b.triangles_);
    return result;
}

SimplexSet skeleton(const SimplexSet& set, int k) {
    check_dimension(k, "skeleton");
    return {set.vertices(), k >= 1 ? set.edges() : std::vector<Edge>{},
            k >= 2 ? set.triangles() : std::vector<Triangle>{}};
}

SimplexSet filter(const SimplexSet& set, int k) {
    check_dimension(k, "filter");
    return {k == 0 ? set.vertices() : std::vector<Vertex>{},
            k == 1 ? set.edges() : std::vector<Edge>{},
            k == 2 ? set.triangles() : std::vector<Triangle>{}};
}

} // namespace dsc
