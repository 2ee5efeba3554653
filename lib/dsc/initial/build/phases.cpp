// SPDX-License-Identifier: MIT
#include "dsc/initial/build/phases.h"

#include "dsc/base/error.h"

namespace dsc::initial {

namespace {

// A piece of the interface by the corners opposite to it, in the triangles on the left and on the
// right of its way. It stops a flood, while the phases do not tell.
struct Wall {
    Corner left;
    Corner right;
    std::uint32_t path; // of which it is a piece
};

// Which path named a region first.
struct Named {
    Phase phase;
    std::uint32_t path;
    const char* side;
};

template <class Real>
class Filling {
public:
    Filling(Complex<Real>& complex, std::span<const CheckedPath> paths)
        : complex_(complex), paths_(paths), region_of_(complex.triangle_bound(), no_id) {}

    void run(const Chains& chains) {
        raise_walls(chains);
        for (const Wall& wall : walls_) {
            const CheckedPath& path = paths_[wall.path];
            name(triangle_of(wall.left), {path.left, wall.path, "left"});
            if (path.right) {
                name(triangle_of(wall.right), {*path.right, wall.path, "right"});
            }
        }
        for (const Wall& wall : walls_) {
            check_sides(wall);
            complex_.triangles[triangle_of(wall.left)].mark = 0;
            complex_.triangles[triangle_of(wall.right)].mark = 0;
        }
    }

private:
    // Bit i of a triangle's mark: the edge opposite to its corner i is a wall.
    void raise_walls(const Chains& chains) {
        for (std::uint32_t k = 0; k < chains.size(); ++k) {
            for (std::size_t i = 0; i + 1 < chains[k].size(); ++i) {
                const Corner left =
                    complex_.find_half_edge(Vertex{chains[k][i]}, Vertex{chains[k][i + 1]});
                if (left == no_id || is_border(complex_.twin(left))) {
                    throw InvariantError("fill_phases: a piece of the interface is no inner edge");
                }
                walls_.push_back({left, complex_.twin(left), k});
                for (const Corner c : {walls_.back().left, walls_.back().right}) {
                    complex_.triangles[triangle_of(c)].mark |= 1U << index_of(c);
                }
            }
        }
    }

    // Floods the region of this triangle, or compares its phase if that is done.
    void name(std::uint32_t triangle, const Named& region) {
        const std::uint32_t known = region_of_[triangle];
        if (known == no_id) {
            regions_.push_back(region);
            flood(triangle);
        } else if (regions_[known].phase != region.phase) {
            throw InputError({.what = "curves name two phases for one region",
                              .where = paths_[region.path].name,
                              .value = described(region) + ", " + described(regions_[known]),
                              .allowed = "the same phase from all curves around a region"});
        }
    }

    // Gives the last region to all triangles that can be reached without crossing a wall.
    void flood(std::uint32_t first) {
        enter(first);
        while (!stack_.empty()) {
            const std::uint32_t from = stack_.back();
            stack_.pop_back();
            for (std::uint32_t i = 0; i < 3; ++i) {
                const Corner across = complex_.twin(corner_of(from, i));
                const bool is_wall = (complex_.triangles[from].mark >> i & 1U) != 0;
                if (!is_wall && !is_border(across) && region_of_[triangle_of(across)] == no_id) {
                    enter(triangle_of(across));
                }
            }
        }
    }

    void enter(std::uint32_t triangle) {
        region_of_[triangle] = static_cast<std::uint32_t>(regions_.size() - 1);
        complex_.triangles[triangle].phase = regions_.back().phase;
        stack_.push_back(triangle);
    }

    // An outline names no phase outside: what is there is known only now.
    void check_sides(const Wall& wall) const {
        if (complex_.phase_at(wall.left) == complex_.phase_at(wall.right)) {
            throw InputError({.what = "the shape has the phase of what is around it",
                              .where = paths_[wall.path].name,
                              .value = std::to_string(complex_.phase_at(wall.left)),
                              .allowed = "any other; phase 0 only in a shape of another phase"});
        }
    }

    [[nodiscard]] std::string described(const Named& region) const {
        return "phase " + std::to_string(region.phase) + " on the " + region.side + " of " +
               paths_[region.path].name;
    }

    Complex<Real>& complex_;
    std::span<const CheckedPath> paths_;
    std::vector<Wall> walls_;
    std::vector<std::uint32_t> region_of_; // by triangle
    std::vector<Named> regions_;
    std::vector<std::uint32_t> stack_;
};

} // namespace

template <class Real>
void fill_phases(Complex<Real>& complex, std::span<const CheckedPath> paths, const Chains& chains) {
    Filling<Real>(complex, paths).run(chains);
}

template void fill_phases(Complex<double>&, std::span<const CheckedPath>, const Chains&);
template void fill_phases(Complex<float>&, std::span<const CheckedPath>, const Chains&);

} // namespace dsc::initial
