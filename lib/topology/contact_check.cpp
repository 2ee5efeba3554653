// SPDX-License-Identifier: MIT
#include "topology/contact_check.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "topology/region.h"

#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

namespace dsc {

namespace {

std::string in_words(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

} // namespace

template <class Real>
void check_contact(const Complex<Real>& complex, const TopologyOptions<Real>& options,
                   Real edge_length) {
    if (!is_wide(largest_contact(options, edge_length), edge_length)) {
        return;
    }
    std::map<Phase, double> areas;
    for (const Triangle t : triangles(complex)) {
        areas[complex.phase(t)] += static_cast<double>(doubled_area(complex, t)) / 2;
    }
    const auto check = [&](Phase phase, Real contact, const std::string& where) {
        const double widest = std::sqrt(4 * areas.at(phase) / std::numbers::pi);
        if (is_wide(contact, edge_length) && static_cast<double>(contact) > widest) {
            throw InputError(
                {.what = "a contact distance wider than phase " + std::to_string(phase),
                 .where = where,
                 .value = in_words(static_cast<double>(contact)),
                 .allowed = "up to " + in_words(widest) +
                            ", the diameter of a disc of that phase's area"});
        }
    };
    // For each phase, the number of other phases with which it has a pair rule.
    std::map<Phase, std::size_t> own_rules;
    for (const PairTopology<Real>& pair : options.pairs) {
        if (!areas.contains(pair.one) || !areas.contains(pair.other)) {
            continue;
        }
        for (const Phase phase : {pair.one, pair.other}) {
            ++own_rules[phase];
            if (pair.rule == Topology::change) {
                check(phase, pair.contact,
                      "topology.contact of phases " + std::to_string(pair.one) + " and " +
                          std::to_string(pair.other));
            }
        }
    }
    for (const auto& [phase, area] : areas) {
        if (options.rule == Topology::change && own_rules[phase] + 1 < areas.size()) {
            check(phase, options.contact, "topology.contact");
        }
    }
}

template <class Real>
bool differ_in_contact(const TopologyOptions<Real>& one, const TopologyOptions<Real>& other) {
    return one.rule != other.rule || one.contact != other.contact || one.pairs != other.pairs;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void check_contact(const Complex<Real>&, const TopologyOptions<Real>&, Real);         \
    template bool differ_in_contact(const TopologyOptions<Real>&, const TopologyOptions<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
