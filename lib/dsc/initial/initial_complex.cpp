// SPDX-License-Identifier: MIT
#include "dsc/initial/initial_complex.h"

#include "dsc/complex/numbering.h"
#include "dsc/initial/build/clearing.h"
#include "dsc/initial/build/delaunay.h"
#include "dsc/initial/build/faces.h"
#include "dsc/initial/build/insertion.h"
#include "dsc/initial/build/phases.h"
#include "dsc/initial/build/segments.h"
#include "dsc/initial/improve/grading.h"
#include "dsc/initial/improve/improvement.h"
#include "dsc/initial/input/curve_check.h"
#include "dsc/initial/input/input_check.h"

namespace dsc {

namespace {

// Lattice vertices closer to an outline than this share of its pieces are removed. A larger share
// leaves gaps, a smaller one short edges; half keeps the circles about the pieces empty.
constexpr double clearance = 0.5;
// Room for the vertices of the outlines and for those that grade down to short pieces, so that
// arrays of a large complex need not be copied to grow.
constexpr std::size_t spare_per_piece = 4;

// A complex with these paths as its interface. `fill` gives the phases.
template <class Real, class Fill>
Complex<Real> build(const initial::Lattice& lattice, std::span<const initial::Path> paths,
                    const InitialOptions& options, initial::Protection protection, Fill fill) {
    using namespace initial;
    std::size_t pieces = 0;
    for (const Path& path : paths) {
        pieces += path.size() - 1;
    }
    Complex<Real> complex;
    write_lattice(lattice, spare_per_piece * pieces, complex);
    clear_lattice(complex, lattice, paths, clearance);
    Chains chains = insert_paths(complex, lattice, paths);
    const std::vector<std::uint32_t> touched = recover_segments(complex, chains);
    fill(complex, chains);
    std::vector<Corner> stack;
    for (const std::uint32_t v : touched) {
        legalise_star(complex, v, stack);
    }
    const auto interface_vertices = vertices_on(chains);
    if (options.sizes.is_uniform()) {
        improve(complex, std::span<const std::uint32_t>(interface_vertices), options.edge_length,
                options.improve_rounds, protection);
    } else {
        grade(complex, sizes_in<Real>(options.sizes), static_cast<Real>(options.edge_length),
              options.improve_rounds, protection);
    }
    if (options.renumber) {
        renumber(complex);
    }
    return complex;
}

template <class Checked>
std::vector<initial::Path> paths_of(const std::vector<Checked>& lines) {
    std::vector<initial::Path> paths;
    paths.reserve(lines.size());
    for (const Checked& line : lines) {
        paths.emplace_back(line.points);
    }
    return paths;
}

} // namespace

template <class Real>
Complex<Real> initial_complex(const Rectangle& domain, std::span<const Shape> shapes,
                              const InitialOptions& options) {
    const initial::CheckedInput input = initial::check_input<Real>(domain, shapes, options);
    return build<Real>(input.lattice, paths_of(input.outlines), options,
                       initial::Protection::circle,
                       [&](Complex<Real>& complex, const initial::Chains& chains) {
                           initial::fill_phases(complex, std::span(input.outlines), chains);
                       });
}

template <class Real>
Complex<Real> initial_complex(const Rectangle& domain, std::span<const Curve> curves,
                              const InitialOptions& options) {
    const initial::CheckedCurves input = initial::check_curves<Real>(domain, curves, options);
    return build<Real>(input.lattice, paths_of(input.curves), options, initial::Protection::lens,
                       [&](Complex<Real>& complex, const initial::Chains& chains) {
                           initial::fill_faces(complex, std::span(input.curves), chains);
                       });
}

template Complex<double> initial_complex(const Rectangle&, std::span<const Shape>,
                                         const InitialOptions&);
template Complex<float> initial_complex(const Rectangle&, std::span<const Shape>,
                                        const InitialOptions&);
template Complex<double> initial_complex(const Rectangle&, std::span<const Curve>,
                                         const InitialOptions&);
template Complex<float> initial_complex(const Rectangle&, std::span<const Curve>,
                                        const InitialOptions&);

} // namespace dsc
