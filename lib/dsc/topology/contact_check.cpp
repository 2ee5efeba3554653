// SPDX-License-Identifier: MIT
#include "dsc/topology/contact_check.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/topology/region.h"

#include <algorithm>
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
    for (const auto& [one, its_area] : areas) {
        for (const auto& [other, other_area] : areas) {
            const auto rule = rule_of(options, edge_length, one, other);
            if (one == other || rule.rule != Topology::change ||
                !is_wide(rule.contact, edge_length)) {
                continue;
            }
            const double widest = std::sqrt(4 * its_area / std::numbers::pi);
            if (static_cast<double>(rule.contact) > widest) {
                throw InputError(
                    {.what = "a contact distance wider than phase " + std::to_string(one),
                     .where = "topology.contact of phases " + std::to_string(one) + " and " +
                              std::to_string(other),
                     .value = in_words(static_cast<double>(rule.contact)),
                     .allowed = "up to " + in_words(widest) +
                                ", the diameter of a disc of that phase's area"});
            }
        }
    }
}

template <class Real>
bool differ_in_contact(const TopologyOptions<Real>& one, const TopologyOptions<Real>& other) {
    const auto is_same = [](const PairTopology<Real>& a, const PairTopology<Real>& b) {
        return a.one == b.one && a.other == b.other && a.rule == b.rule && a.contact == b.contact;
    };
    return one.rule != other.rule || one.contact != other.contact ||
           !std::ranges::equal(one.pairs, other.pairs, is_same);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void check_contact(const Complex<Real>&, const TopologyOptions<Real>&, Real);         \
    template bool differ_in_contact(const TopologyOptions<Real>&, const TopologyOptions<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
