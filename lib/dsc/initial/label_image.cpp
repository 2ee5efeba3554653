// SPDX-License-Identifier: MIT
#include "dsc/initial/label_image.h"

#include "dsc/base/error.h"
#include "dsc/initial/input/label_curves.h"
#include "dsc/initial/input/label_regions.h"
#include "dsc/initial/input/thinning.h"

#include <algorithm>

namespace dsc {

namespace {

void check(const LabelImage& image) {
    constexpr std::size_t max_pixels = 400'000'000;
    const auto shape = std::to_string(image.rows) + " rows of " + std::to_string(image.columns);
    if (image.rows == 0 || image.columns == 0 || image.rows > max_pixels / image.columns) {
        throw InputError({.what = "the image has no pixels, or too many",
                          .where = "labels",
                          .value = shape,
                          .allowed = "1 to " + std::to_string(max_pixels) + " pixels"});
    }
    if (image.labels.size() != image.rows * image.columns) {
        throw InputError({.what = "the number of labels does not fit the image",
                          .where = "labels",
                          .value = std::to_string(image.labels.size()) + " for " + shape,
                          .allowed = "one for each pixel"});
    }
    if (const auto at = std::ranges::find(image.labels, border_phase); at != image.labels.end()) {
        const auto i = static_cast<std::size_t>(at - image.labels.begin());
        throw InputError({.what = "the phase is reserved",
                          .where = "labels, row " + std::to_string(i / image.columns) +
                                   ", column " + std::to_string(i % image.columns),
                          .value = std::to_string(border_phase),
                          .allowed = "phases from 0 to " + std::to_string(border_phase - 1)});
    }
}

} // namespace

template <class Real>
Complex<Real> initial_complex(const Rectangle& domain, const LabelImage& image,
                              const InitialOptions& options, InputReport* report) {
    check(image);
    LabelImage left = image;
    const Point<double> size(static_cast<double>(image.columns), static_cast<double>(image.rows));
    const Point<double> pixel = (domain.high - domain.low).cwiseQuotient(size);
    InputReport dropped;
    const bool is_thinned = options.detail == Detail::thin;
    initial::drop_small_grains(
        left, pixel, is_thinned ? initial::finest_edge * options.edge_length : 0, dropped);
    const std::vector<Curve> curves = initial::curves_of(left, image, domain);
    InputReport found;
    Complex<Real> complex;
    if (curves.empty() && left.labels.front() != exterior_phase) {
        const std::vector<Point<double>> sides{domain.low,
                                               {domain.high.x(), domain.low.y()},
                                               domain.high,
                                               {domain.low.x(), domain.high.y()}};
        complex =
            initial_complex<Real>(domain, {Shape{sides, left.labels.front()}}, options, &found);
    } else {
        complex = initial_complex<Real>(domain, std::span<const Curve>(curves), options, &found);
    }
    if (report != nullptr) {
        found.dropped += dropped.dropped;
        found.area_dropped += dropped.area_dropped;
        *report = found;
    }
    return complex;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Complex<Real> initial_complex(const Rectangle&, const LabelImage&,                    \
                                           const InitialOptions&, InputReport*);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
