// SPDX-License-Identifier: MIT
#include "dsc/initial/initial_complex.h"

#include "dsc/complex/numbering.h"
#include "dsc/initial/build/delaunay.h"
#include "dsc/initial/build/insertion.h"
#include "dsc/initial/build/phases.h"
#include "dsc/initial/build/segments.h"
#include "dsc/initial/improve/improvement.h"
#include "dsc/initial/input/input_check.h"

namespace dsc {

namespace {

// Lattice vertices closer to an outline than this share of its pieces are removed. A larger share
// leaves gaps, a smaller one short edges; half keeps the circles about the pieces empty.
constexpr double clearance = 0.5;
// Room for the vertices of the outlines and for those that grade down to short pieces, so that
// arrays of a large complex need not be copied to grow.
constexpr std::size_t spare_per_piece = 4;

} // namespace

template <class Real>
Complex<Real> initial_complex(const Rectangle& domain, std::span<const Shape> shapes,
                              const InitialOptions& options) {
    using namespace initial;
    const CheckedInput input = check_input<Real>(domain, shapes, options);
    const std::span<const Outline> outlines = input.outlines;
    std::size_t pieces = 0;
    for (const Outline& outline : outlines) {
        pieces += outline.points.size();
    }
    Complex<Real> complex;
    write_lattice(input.lattice, spare_per_piece * pieces, complex);
    clear_lattice(complex, input.lattice, outlines, clearance);
    Chains chains = insert_outlines(complex, input.lattice, outlines);
    const std::vector<std::uint32_t> touched = recover_segments(complex, chains);
    fill_phases(complex, outlines, chains);
    std::vector<Corner> stack;
    for (const std::uint32_t v : touched) {
        legalise_star(complex, v, stack);
    }
    std::vector<std::uint32_t> interface_vertices;
    interface_vertices.reserve(pieces);
    for (const auto& chain : chains) {
        interface_vertices.insert(interface_vertices.end(), chain.begin(), chain.end());
    }
    improve(complex, std::span<const std::uint32_t>(interface_vertices), options.edge_length,
            options.improve_rounds);
    if (options.renumber) {
        renumber(complex);
    }
    return complex;
}

template Complex<double> initial_complex(const Rectangle&, std::span<const Shape>,
                                         const InitialOptions&);
template Complex<float> initial_complex(const Rectangle&, std::span<const Shape>,
                                        const InitialOptions&);

} // namespace dsc
