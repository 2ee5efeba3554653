// SPDX-License-Identifier: MIT
#include "dsc3/passes/repair.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/operations/edge_collapse.h"
#include "dsc3/operations/edge_removal.h"
#include "dsc3/operations/edge_split.h"
#include "dsc3/operations/interface_flip.h"
#include "dsc3/operations/smoothing.h"
#include "dsc3/passes/worst_tets.h"

#include <algorithm>

namespace dsc3 {

namespace {

// An edge removal must raise the quality by this factor.
constexpr Real removal_gain = 1.02;
// An edge shorter than this, in edge lengths, is collapsed even if it is not the shortest of its
// tet.
constexpr Real short_edge = 0.6;
// A split must raise the quality by this factor.
constexpr Real split_gain = 1.05;
// The number of treated tets is at most this factor times the number of initially unfit ones, so
// that the repair ends.
constexpr std::size_t bound_factor = 6;
constexpr std::size_t min_bound = 100;

bool is_unfit(const Complex& complex, std::uint32_t t, Real quality) {
    return complex.is_alive(Tet{t}) && quality_of(complex, t) < quality;
}

// The lists of a repair: of the whole mesh, or of a submesh.
struct RepairLists {
    std::vector<std::uint32_t>& unfit;
    std::vector<std::uint32_t>& unimproved;
};

class Repair {
public:
    Repair(PassState& state, Workspace& work, Real quality, Effort effort)
        : complex_(state.complex), options_(state.options), work_(work), quality_(quality),
          more_(effort == Effort::more), edits_sides_(state.ends_on_sides) {}

    void run(const RepairLists& lists) {
        auto& unfit = lists.unfit;
        const OpenStars opened(work_.rewiring.stars);
        work_.rewiring.changed.clear();
        const std::size_t bound = bound_factor * unfit.size() + min_bound;
        for (std::size_t k = 0; k < unfit.size() && k < bound; ++k) {
            if (is_unfit(complex_, unfit[k], quality_)) {
                treat(unfit[k], lists);
            }
        }
        unfit.clear();
    }

    // Treats the tets of a submesh; those that it may not treat stay in its list.
    void run(SubmeshWorker& worker) {
        auto& unfit = worker.unfit;
        const Submesh& submesh = worker.submesh;
        const OpenStars opened(work_.rewiring.stars);
        work_.rewiring.changed.clear();
        const std::size_t bound = bound_factor * unfit.size() + min_bound;
        std::size_t deferred = 0;
        for (std::size_t k = 0; k < unfit.size() && k < bound; ++k) {
            const std::uint32_t t = unfit[k];
            if (!is_unfit(complex_, t, quality_)) {
                continue;
            }
            const TetRecord& tet = complex_.tets[t];
            if (submesh.free_tets.size() < Submeshes::min_free_tets ||
                submesh.free_vertices.empty() ||
                work_.rewiring.ownership->owner(tet.v, submesh.colour) != submesh.index) {
                unfit[deferred++] = t;
                continue;
            }
            worker.places.push_back(complex_.at(tet.v[0]));
            treat(t, {unfit, worker.unimproved});
        }
        unfit.resize(deferred);
    }

private:
    struct EdgeOfTet {
        Real square;
        std::uint32_t a;
        std::uint32_t b;
    };
    using Edges = std::array<EdgeOfTet, 6>;

    void treat(std::uint32_t t, const RepairLists& lists) {
        ++work_.treated;
        if (!improve(t) && is_unfit(complex_, t, worst_tet_quality)) {
            lists.unimproved.push_back(t);
        }
        for (const std::uint32_t changed : work_.rewiring.changed) {
            if (is_unfit(complex_, changed, quality_)) {
                lists.unfit.push_back(changed);
            }
        }
        work_.rewiring.changed.clear();
    }

    // Returns whether tets were changed.
    bool improve(std::uint32_t t) {
        const TetRecord tet = complex_.tets[t];
        for (const std::uint32_t v : tet.v) {
            if (is_free(v)) {
                smooth(complex_, work_, Vertex{v}, more_ ? 8 : 5);
            }
        }
        if (quality_of(complex_, t) > quality_) {
            return true;
        }
        Edges edges{};
        std::size_t n = 0;
        for (std::uint32_t i = 0; i < 4; ++i) {
            for (std::uint32_t j = i + 1; j < 4; ++j) {
                edges[n++] = {squared_distance(complex_.at(tet.v[i]), complex_.at(tet.v[j])),
                              tet.v[i], tet.v[j]};
            }
        }
        for (const EdgeOfTet& edge : edges) {
            if ((edits_sides_ || complex_.fixed_along(edge.a, edge.b) == 0) &&
                edge_removal(complex_, work_, {t, edge.a, edge.b}, removal_gain) ==
                    Verdict::legal) {
                return true;
            }
        }
        for (std::uint32_t i = 0; i < 4; ++i) {
            if (face_flip(complex_, work_, corner_of(t, i)) == Verdict::legal) {
                return true;
            }
        }
        std::sort(edges.begin(), edges.end(), [](const EdgeOfTet& x, const EdgeOfTet& y) {
            return x.square != y.square ? x.square < y.square
                                        : std::pair(x.a, x.b) < std::pair(y.a, y.b);
        });
        return collapse(edges) || reassign(t, edges) || split(t, edges);
    }

    // Sides keep their mesh unless an interface ends on one of them: nothing moves along them.
    [[nodiscard]] bool is_free(std::uint32_t v) const {
        const std::uint32_t flags = complex_.vertices[v].flags;
        return (flags & vertex_interface) == 0 && (edits_sides_ || (flags & vertex_boundary) == 0);
    }

    bool collapse(const Edges& edges) {
        const Real length = short_edge * options_.edge_length;
        const CollapseRules rules{.enough = quality_};
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (i > 2 && !more_ && edges[i].square > length * length) {
                break;
            }
            for (const auto& [a, b] :
                 {std::pair(edges[i].a, edges[i].b), std::pair(edges[i].b, edges[i].a)}) {
                if (is_free(a) &&
                    edge_collapse(complex_, work_, Vertex{a}, Vertex{b}, rules) == Verdict::legal) {
                    return true;
                }
            }
        }
        return false;
    }

    bool reassign(std::uint32_t t, const Edges& edges) {
        return std::any_of(edges.begin(), edges.end(), [&](const EdgeOfTet& edge) {
            return complex_.is_interface(Vertex{edge.a}) && complex_.is_interface(Vertex{edge.b}) &&
                   reassign_sliver(complex_, work_, {t, edge.a, edge.b}) == Verdict::legal;
        });
    }

    // Splits one of the longest edges.
    bool split(std::uint32_t t, const Edges& edges) {
        if (quality_of(complex_, t) >= (more_ ? 1.0 : 0.7) * quality_) {
            return false;
        }
        for (std::size_t i = 6; i-- > (more_ ? 4U : 5U);) {
            const Verdict verdict =
                improving_split(complex_, work_, {t, edges[i].a, edges[i].b}, split_gain);
            if (verdict == Verdict::legal || verdict == Verdict::no_gain) {
                return verdict == Verdict::legal;
            }
        }
        return false;
    }

    Complex& complex_;
    const Options& options_;
    Workspace& work_;
    Real quality_;
    bool more_;
    bool edits_sides_;
};

} // namespace

void repair_mesh(PassState& state, Real quality, Effort effort) {
    Complex& complex = state.complex;
    if (state.submeshes != nullptr && state.unfit.size() >= Submeshes::min_items) {
        const auto owner = [&](std::uint32_t t, std::uint32_t colour) {
            return is_unfit(complex, t, quality)
                       ? state.work.rewiring.ownership->owner(complex.tets[t].v, colour)
                       : Submeshes::done;
        };
        state.submeshes->in_colours(state.unfit, colour_count, &SubmeshWorker::unfit, owner,
                                    [&](SubmeshWorker& worker, Workspace& work) {
                                        Repair(state, work, quality, effort).run(worker);
                                    });
        state.collect_from_submeshes();
    }
    Repair(state, state.work, quality, effort).run({state.unfit, state.unimproved});
    state.grow();
}

} // namespace dsc3
