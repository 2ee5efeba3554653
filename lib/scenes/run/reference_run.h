// SPDX-License-Identifier: MIT
// The sequential method of the thesis, taken literally, on a scene, from the same initial complex.
#pragma once

#include "dsc/complex/complex.h"
#include "measures/mesh_quality.h"
#include "scenes/run/run.h"

#include "reference/algorithm/dsc.h"

namespace dsc::scenes {

/// The arrays of a complex as the reference takes them.
[[nodiscard]] reference::Complex to_reference(const Complex<double>& complex);
/// The reverse. O(n log n).
[[nodiscard]] Complex<double> from_reference(const reference::Complex& complex);
/// The options that match `scene_options`.
[[nodiscard]] reference::Options reference_options(const Parameters& parameters);

/// Of a setup, which must outlive it.
class ReferenceMethod {
public:
    ReferenceMethod(const Setup& setup, const Parameters& parameters, const RunOptions& run,
                    InputReport* report = nullptr);

    void step(double begin, double end, RunResult& result);
    /// Converted anew after each step, on the first request.
    [[nodiscard]] const Complex<double>& complex();
    [[nodiscard]] std::uint64_t interface_vertices();
    [[nodiscard]] MeshQuality worst() { return measure_worst(complex()); }
    void before_step() {}
    void after_step() {}
    [[nodiscard]] std::uint32_t threads_used() const { return 1; }

private:
    const Setup& setup_;
    reference::Complex method_;
    reference::Options options_;
    Complex<double> converted_;
    bool stale_ = true;
};

} // namespace dsc::scenes
