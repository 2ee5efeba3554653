// SPDX-License-Identifier: MIT
#include "dsc/initial/input/domain_check.h"

#include "dsc/base/error.h"
#include "dsc/initial/input/text.h"
#include "dsc/initial/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace dsc::initial {

namespace {

// Of the lattice. Where edges grow, it is as coarse as they may become: an eighth of the smaller
// side of the domain is small enough for triangles of good quality, and costs nothing.
double spacing_of(const InitialOptions& options, double side) {
    if (options.sizes.is_uniform()) {
        return options.edge_length;
    }
    const double coarse = std::max(options.edge_length, side / 8);
    return options.sizes.longest > 0 ? std::min(coarse, options.sizes.longest) : coarse;
}

} // namespace

template <class Real>
Lattice check_domain(const Rectangle& domain, const InitialOptions& options) {
    const double h = options.edge_length;
    if (!std::isfinite(h) || h <= 0) {
        throw InputError({.what = "edge length",
                          .where = "options",
                          .value = text(h),
                          .allowed = "a finite number above 0"});
    }
    if (options.improve_rounds < 0) {
        throw InputError({.what = "rounds of improvement",
                          .where = "options",
                          .value = std::to_string(options.improve_rounds),
                          .allowed = "0 or more"});
    }
    const Point<double> low = rounded<Real>(domain.low);
    const Point<double> high = rounded<Real>(domain.high);
    if (!is_finite(low) || !is_finite(high)) {
        throw InputError({.what = "a coordinate is not finite",
                          .where = "domain",
                          .value = text(domain.low) + " to " + text(domain.high),
                          .allowed = "finite coordinates"});
    }
    const double width = high.x() - low.x();
    const double height = high.y() - low.y();
    if (!(width > 0) || !(height > 0) || !std::isfinite(width * height)) {
        throw InputError({.what = "the rectangle is empty or out of range",
                          .where = "domain",
                          .value = text(domain.low) + " to " + text(domain.high),
                          .allowed = "low below high in x and y, and an area that is finite"});
    }
    if (h < least_initial_edge_length || h > 1 / least_initial_edge_length) {
        throw InputError({.what = "edge length is out of range",
                          .where = "options",
                          .value = text(h),
                          .allowed = text(least_initial_edge_length) + " to " +
                                     text(1 / least_initial_edge_length) +
                                     "; choose_frame brings any scene there"});
    }
    if (h > std::min(width, height)) {
        throw InputError({.what = "edge length is larger than the domain",
                          .where = "options",
                          .value = text(h),
                          .allowed = "at most " + text(std::min(width, height))});
    }
    const double resolution = std::max(largest(low), largest(high)) *
                              static_cast<double>(std::numeric_limits<Real>::epsilon());
    if (h < least_steps * resolution) {
        throw InputError({.what = "edge length is below what coordinates of this size resolve",
                          .where = "options",
                          .value = text(h),
                          .allowed = "at least " + text(least_steps * resolution) +
                                     "; choose_frame brings a scene near the origin"});
    }
    check_sizes(options.sizes, h);
    const double spacing = spacing_of(options, std::min(width, height));
    // An equilateral triangle has the area sqrt(3)/4 h^2.
    const double triangles = width / spacing * (height / spacing) / 0.43301270189221933;
    if (!(triangles <= most_triangles)) {
        throw InputError(
            {.what = "the complex would be absurdly large",
             .where = "options",
             .value = "edge length " + text(h) + ", about " + text(triangles) + " triangles",
             .allowed = "at most " + text(most_triangles) + " triangles"});
    }
    return fit_lattice(low, high, spacing);
}

template Lattice check_domain<double>(const Rectangle&, const InitialOptions&);
template Lattice check_domain<float>(const Rectangle&, const InitialOptions&);

} // namespace dsc::initial
