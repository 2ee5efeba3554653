// SPDX-License-Identifier: MIT
#include "dsc/passes/mesh/size_upkeep.h"

#include "dsc/complex/gather.h"
#include "dsc/complex/ranges.h"

namespace dsc {

template <class Real>
std::vector<std::uint32_t> out_of_size(Complex<Real>& complex, const Options<Real>& options) {
    const SizeField<Real>* field = options.sizes.is_uniform() ? nullptr : &size_field(complex);
    std::vector<std::uint32_t> found;
    Ring<Real> ring;
    for (const Vertex v : vertices(complex)) {
        if (gather(complex, Region{}, v.id, ring)) {
            const Real length = field != nullptr ? (*field)[v].length : options.edge_length;
            if (is_out_of_size(examine(ring), star_limits(options, ring.phase[0], length))) {
                found.push_back(v.id);
            }
        }
    }
    return found;
}

template std::vector<std::uint32_t> out_of_size(Complex<double>&, const Options<double>&);
template std::vector<std::uint32_t> out_of_size(Complex<float>&, const Options<float>&);

} // namespace dsc
