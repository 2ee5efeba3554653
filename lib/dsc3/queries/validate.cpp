// SPDX-License-Identifier: MIT
#include "dsc3/queries/validate.h"

#include "dsc3/complex/star.h"
#include "dsc3/geometry/predicates.h"
#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <map>

namespace dsc3 {

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

Pair ordered(std::uint32_t a, std::uint32_t b) { return a < b ? Pair(a, b) : Pair(b, a); }

std::uint64_t count_distinct(std::vector<Pair>& pairs) {
    std::sort(pairs.begin(), pairs.end());
    return static_cast<std::uint64_t>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

class Validation {
public:
    explicit Validation(const Complex& complex) : complex_(complex) {}

    ValidationReport run() {
        check_border() && check_vertices() && check_tets() && check_free_ids() && check_flags() &&
            check_stars() && check_domain();
        if (report_.ok()) {
            measure_surfaces();
        }
        return std::move(report_);
    }

private:
    bool fail(const std::string& problem) {
        report_.problem = problem;
        return false;
    }
    bool fail(const char* kind, std::uint32_t id, const std::string& problem) {
        return fail(std::string(kind) + ' ' + std::to_string(id) + ": " + problem);
    }
    template <class Do>
    bool for_tets(Do act) {
        for (std::uint32_t t = 1; t < complex_.tet_bound(); ++t) {
            if (complex_.is_alive(Tet{t}) && !act(t)) {
                return false;
            }
        }
        return true;
    }

    bool check_border() {
        if (complex_.tets.empty() || complex_.phases.size() != complex_.tets.size()) {
            return fail(
                "tet 0, the border, is missing, or the number of phases differs from that of tets");
        }
        return complex_.phases[border_tet] == border_phase ||
               fail("tet 0, the border, does not have the border's phase");
    }

    bool check_vertices() {
        for (std::uint32_t v = 0; v < complex_.vertex_bound(); ++v) {
            const VertexRecord& vertex = complex_.vertices[v];
            if ((vertex.flags & vertex_dead) != 0) {
                continue;
            }
            ++report_.vertices;
            if (!vertex.position.allFinite()) {
                return fail("vertex", v, "is not at a finite position");
            }
            const std::uint32_t t = tet_of(vertex.corner);
            if (!complex_.is_alive(Tet{t}) || complex_.vertex(vertex.corner) != v) {
                return fail("vertex", v, "its corner belongs to another vertex");
            }
        }
        return true;
    }

    bool check_tets() {
        return for_tets([&](std::uint32_t t) {
            ++report_.tets;
            const TetRecord& tet = complex_.tets[t];
            for (std::uint32_t i = 0; i < 4; ++i) {
                if (!complex_.is_alive(Vertex{tet.v[i]})) {
                    return fail("tet", t, "has a vertex that is not alive");
                }
                for (std::uint32_t j = 0; j < i; ++j) {
                    if (tet.v[i] == tet.v[j]) {
                        return fail("tet", t, "has a vertex twice");
                    }
                }
            }
            if (complex_.phases[t] == border_phase) {
                return fail("tet", t, "has the border's phase");
            }
            const auto p = complex_.positions_of(Tet{t});
            if (orientation(p[0], p[1], p[2], p[3]) <= 0) {
                return fail("tet", t, "is inverted or has no volume");
            }
            return check_links(t);
        });
    }

    bool check_links(std::uint32_t t) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            const Corner corner = corner_of(t, i);
            const Corner other = complex_.tets[t].n[i];
            if (is_border(other)) {
                report_.faces += 2;
                continue;
            }
            ++report_.faces;
            if (!complex_.is_alive(Tet{tet_of(other)}) || complex_.twin(other) != corner) {
                return fail("tet", t, "its neighbour does not link back to it");
            }
            auto one = complex_.face(corner);
            auto two = complex_.face(other);
            std::sort(one.begin(), one.end());
            std::sort(two.begin(), two.end());
            if (one != two) {
                return fail("tet", t, "its neighbour does not have the same face");
            }
        }
        return true;
    }

    bool check_free_ids() {
        report_.faces /= 2;
        if (complex_.vertex_count() != report_.vertices || complex_.tet_count() != report_.tets) {
            return fail("the list of free ids differs from the ids that are not in use");
        }
        return true;
    }

    bool check_flags() {
        std::vector<std::uint32_t> flags(complex_.vertex_bound(), 0);
        for_tets([&](std::uint32_t t) {
            for (std::uint32_t i = 0; i < 4; ++i) {
                const Corner other = complex_.tets[t].n[i];
                if (complex_.phase_at(other) != complex_.phases[t]) {
                    const Corner corner = corner_of(t, i);
                    for (const std::uint32_t v : complex_.face(corner)) {
                        flags[v] |= is_border(other) ? fixed_at(complex_, corner)
                                                     : std::uint32_t{vertex_interface};
                    }
                }
            }
            return true;
        });
        for (std::uint32_t v = 0; v < complex_.vertex_bound(); ++v) {
            constexpr std::uint32_t both = vertex_boundary | vertex_interface;
            if (complex_.is_alive(Vertex{v}) && (complex_.vertices[v].flags & both) != flags[v]) {
                return fail("vertex", v, "has wrong interface or boundary flags");
            }
        }
        return true;
    }

    // A walk from the vertex's corner must reach all its tets, and its link must be a sphere, or a
    // disc whose rim is on the domain boundary.
    bool check_stars() {
        std::vector<std::uint32_t> tets(complex_.vertex_bound(), 0);
        for_tets([&](std::uint32_t t) {
            for (const std::uint32_t v : complex_.tets[t].v) {
                ++tets[v];
            }
            return true;
        });
        std::vector<Pair> edges;
        std::vector<std::uint32_t> vertices;
        for (std::uint32_t v = 0; v < complex_.vertex_bound(); ++v) {
            if (!complex_.is_alive(Vertex{v})) {
                continue;
            }
            gather(complex_, v, star_);
            if (star_.corners.size() != tets[v]) {
                return fail("vertex", v, "its star is not connected");
            }
            edges.clear();
            vertices.clear();
            for (const Corner corner : star_.corners) {
                const auto [a, b, c] = complex_.face(corner);
                vertices.insert(vertices.end(), {a, b, c});
                for (const Pair& edge : {ordered(a, b), ordered(b, c), ordered(c, a)}) {
                    edges.push_back(edge);
                }
            }
            std::sort(vertices.begin(), vertices.end());
            const auto distinct = static_cast<std::int64_t>(
                std::unique(vertices.begin(), vertices.end()) - vertices.begin());
            edge_ends_ += static_cast<std::uint64_t>(distinct);
            const std::int64_t euler = distinct - static_cast<std::int64_t>(count_distinct(edges)) +
                                       static_cast<std::int64_t>(star_.corners.size());
            if (euler != (complex_.is_boundary(Vertex{v}) ? 1 : 2)) {
                return fail("vertex", v, "its link is neither a sphere nor a disc");
            }
        }
        report_.edges = edge_ends_ / 2;
        const auto number = [](std::uint64_t n) { return static_cast<std::int64_t>(n); };
        report_.euler_characteristic = number(report_.vertices) - number(report_.edges) +
                                       number(report_.faces) - number(report_.tets);
        return true;
    }

    // The whole boundary must lie on the sides of its bounding box, and the volume must be that of
    // the box: then the complex covers the box once.
    bool check_domain() {
        if (report_.tets == 0) {
            return true;
        }
        if (report_.euler_characteristic != 1) {
            return fail("the domain is not a topological ball");
        }
        Point low = Point::Constant(std::numeric_limits<Real>::max());
        Point high = -low;
        for (const VertexRecord& vertex : complex_.vertices) {
            if ((vertex.flags & vertex_dead) == 0) {
                low = low.cwiseMin(vertex.position);
                high = high.cwiseMax(vertex.position);
            }
        }
        Real sum = 0;
        const bool is_on_sides = for_tets([&](std::uint32_t t) {
            const auto p = complex_.positions_of(Tet{t});
            sum += volume(p[0], p[1], p[2], p[3]);
            for (std::uint32_t i = 0; i < 4; ++i) {
                if (!is_border(complex_.tets[t].n[i])) {
                    continue;
                }
                const auto [a, b, c] = complex_.face(corner_of(t, i));
                bool is_on_side = false;
                for (int k = 0; k < 3; ++k) {
                    for (const Real side : {low[k], high[k]}) {
                        is_on_side |= complex_.at(a)[k] == side && complex_.at(b)[k] == side &&
                                      complex_.at(c)[k] == side;
                    }
                }
                if (!is_on_side) {
                    return fail("tet", t, "a boundary face does not lie on a side of the domain");
                }
            }
            return true;
        });
        const Real box = (high - low).prod();
        return is_on_sides && (std::abs(sum - box) < 1e-6 * box ||
                               fail("the volume of the tets differs from that of the domain"));
    }

    void measure_surfaces() {
        struct Parts {
            std::vector<Pair> vertices;
            std::vector<Pair> edges;
            std::uint64_t faces = 0;
        };
        std::map<Phase, Parts> parts;
        for_tets([&](std::uint32_t t) {
            for (std::uint32_t i = 0; i < 4; ++i) {
                if (complex_.phase_at(complex_.tets[t].n[i]) != complex_.phases[t]) {
                    Parts& of = parts[complex_.phases[t]];
                    const auto [a, b, c] = complex_.face(corner_of(t, i));
                    for (const Pair& pair : {Pair(a, a), Pair(b, b), Pair(c, c)}) {
                        of.vertices.push_back(pair);
                    }
                    for (const Pair& pair : {ordered(a, b), ordered(b, c), ordered(c, a)}) {
                        of.edges.push_back(pair);
                    }
                    ++of.faces;
                }
            }
            return true;
        });
        for (auto& [phase, of] : parts) {
            const auto number = [](std::uint64_t n) { return static_cast<std::int64_t>(n); };
            report_.surfaces.push_back({phase, of.faces,
                                        number(count_distinct(of.vertices)) -
                                            number(count_distinct(of.edges)) + number(of.faces)});
        }
    }

    const Complex& complex_;
    ValidationReport report_;
    Star star_;
    std::uint64_t edge_ends_ = 0;
};

} // namespace

ValidationReport validate(const Complex& complex) { return Validation(complex).run(); }

void validate_or_throw(const Complex& complex) {
    if (const ValidationReport report = validate(complex); !report.ok()) {
        throw InvariantError(report.problem);
    }
}

} // namespace dsc3
