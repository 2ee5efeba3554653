// SPDX-License-Identifier: MIT
#include "dsc/initial/build/interface.h"

#include "dsc/base/error.h"
#include "dsc/base/names.h"
#include "dsc/queries/phases.h"

namespace dsc::initial {

namespace {

// A piece of the interface, given by the corners opposite to it in the triangles on its left and
// right. It bounds the regions while their phases are unknown.
struct Barrier {
    Corner left;
    Corner right;
    std::uint32_t path; // the path that it is a piece of
};

// The path that named a region first.
struct Named {
    Phase phase = exterior_phase;
    std::uint32_t path = no_id; // none has
    const char* side = "";
};

template <class Real>
class Filling {
public:
    Filling(Complex<Real>& complex, std::span<const CheckedPath> paths, const Chains& chains)
        : complex_(complex), paths_(paths) {
        place_barriers(chains);
        Parts parts = label_parts(complex, [&](Triangle t) {
            const auto is_open = [&](std::uint32_t i) { return !is_barrier(corner_of(t.id, i)); };
            return std::array{is_open(0), is_open(1), is_open(2)};
        });
        regions_.resize(parts.count);
        region_of_ = std::move(parts.of);
    }

    void run() {
        for (const Barrier& barrier : barriers_) {
            const CheckedPath& path = paths_[barrier.path];
            name(barrier.left, {path.left, barrier.path, "left"});
            if (path.right) {
                name(barrier.right, {*path.right, barrier.path, "right"});
            }
        }
        for (const Triangle t : triangles(complex_)) {
            if (const Named& region = regions_[region_of_[t.id]]; region.path != no_id) {
                complex_.triangles[t.id].phase = region.phase;
            }
        }
        for (const Barrier& barrier : barriers_) {
            check_sides(barrier);
            complex_.triangles[triangle_of(barrier.left)].mark = 0;
            complex_.triangles[triangle_of(barrier.right)].mark = 0;
        }
    }

private:
    // Bit i of a triangle's mark: the edge opposite to its corner i is a barrier.
    [[nodiscard]] bool is_barrier(Corner c) const {
        return (complex_.triangles[triangle_of(c)].mark >> index_of(c) & 1U) != 0;
    }

    void place_barriers(const Chains& chains) {
        for (std::uint32_t k = 0; k < chains.size(); ++k) {
            for (std::size_t i = 0; i + 1 < chains[k].size(); ++i) {
                const Corner left =
                    complex_.find_half_edge(Vertex{chains[k][i]}, Vertex{chains[k][i + 1]});
                if (left == no_id || is_border(complex_.twin(left))) {
                    throw InvariantError(
                        "initial_complex: a segment of the interface is no edge inside the mesh");
                }
                barriers_.push_back({left, complex_.twin(left), k});
                for (const Corner c : {barriers_.back().left, barriers_.back().right}) {
                    complex_.triangles[triangle_of(c)].mark |= 1U << index_of(c);
                }
            }
        }
    }

    // Gives the region at this corner its phase, or compares the phases if it has one.
    void name(Corner c, const Named& named) {
        Named& region = regions_[region_of_[triangle_of(c)]];
        if (region.path == no_id) {
            region = named;
        } else if (region.phase != named.phase) {
            throw InputError({.what = "curves name two phases for one region",
                              .where = paths_[named.path].name,
                              .value = described(named) + ", " + described(region),
                              .allowed = "the same phase from all curves around a region"});
        }
    }

    // An outline does not name the phase outside it, which is only known now.
    void check_sides(const Barrier& barrier) const {
        if (complex_.phase_at(barrier.left) == complex_.phase_at(barrier.right)) {
            throw InputError(
                {.what = "the shape has the same phase as its surroundings",
                 .where = paths_[barrier.path].name,
                 .value = std::to_string(complex_.phase_at(barrier.left)),
                 .allowed = "a different phase; phase 0 only inside a shape of another phase"});
        }
    }

    [[nodiscard]] std::string described(const Named& named) const {
        return "phase " + std::to_string(named.phase) + " on the " + named.side + " of " +
               paths_[named.path].name;
    }

    Complex<Real>& complex_;
    std::span<const CheckedPath> paths_;
    std::vector<Barrier> barriers_;
    std::vector<std::uint32_t> region_of_; // by triangle
    std::vector<Named> regions_;
};

} // namespace

template <class Real>
void fill_phases(Complex<Real>& complex, std::span<const CheckedPath> paths, const Chains& chains) {
    Filling<Real>(complex, paths, chains).run();
}

template void fill_phases(Complex<double>&, std::span<const CheckedPath>, const Chains&);
template void fill_phases(Complex<float>&, std::span<const CheckedPath>, const Chains&);

} // namespace dsc::initial
