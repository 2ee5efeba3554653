// SPDX-License-Identifier: MIT
#include "topology/options.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dsc {

namespace {

// Of a rule: 0 stands for the default.
template <class Real>
Real length_of(Real contact, Real edge_length) {
    return contact > 0 ? contact : static_cast<Real>(default_contact) * edge_length;
}

} // namespace

template <class Real>
TopologyRule<Real> rule_of(const TopologyOptions<Real>& options, Real edge_length, Phase one,
                           Phase other) {
    for (const auto& pair : options.pairs) {
        if (std::minmax(pair.one, pair.other) == std::minmax(one, other)) {
            return {pair.rule, length_of(pair.contact, edge_length)};
        }
    }
    return {options.rule, length_of(options.contact, edge_length)};
}

template <class Real>
Real largest_contact(const TopologyOptions<Real>& options, Real edge_length) {
    const auto length = [&](Topology rule, Real contact) {
        return rule == Topology::change ? length_of(contact, edge_length) : Real(0);
    };
    Real largest = length(options.rule, options.contact);
    for (const auto& pair : options.pairs) {
        largest = std::max(largest, length(pair.rule, pair.contact));
    }
    return largest;
}

template <class Real>
void check_topology(const TopologyOptions<Real>& options) {
    const auto check_contact = [&](Real contact, const char* name) {
        require(std::isfinite(contact) && contact >= 0, name, static_cast<double>(contact),
                "a length of 0 or more");
    };
    check_contact(options.contact, "topology.contact");
    require(std::isfinite(options.min_area) && options.min_area >= 0, "topology.min_area",
            static_cast<double>(options.min_area), "an area of 0 or more");
    for (std::size_t i = 0; i < options.pairs.size(); ++i) {
        const auto& pair = options.pairs[i];
        check_contact(pair.contact, "topology.pairs.contact");
        const std::string words = std::to_string(pair.one) + " and " + std::to_string(pair.other);
        if (pair.one == pair.other || pair.one == border_phase || pair.other == border_phase) {
            throw InputError({.what = "not a pair of phases",
                              .where = "topology.pairs",
                              .value = words,
                              .allowed = "two different phases of the complex"});
        }
        for (std::size_t j = 0; j < i; ++j) {
            if (std::minmax(options.pairs[j].one, options.pairs[j].other) ==
                std::minmax(pair.one, pair.other)) {
                throw InputError({.what = "two rules for one pair of phases",
                                  .where = "topology.pairs",
                                  .value = words,
                                  .allowed = "one rule for each pair"});
            }
        }
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template TopologyRule<Real> rule_of(const TopologyOptions<Real>&, Real, Phase, Phase);         \
    template Real largest_contact(const TopologyOptions<Real>&, Real);                             \
    template void check_topology(const TopologyOptions<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
