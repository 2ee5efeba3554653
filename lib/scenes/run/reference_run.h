// SPDX-License-Identifier: MIT
// Runs the literal sequential method of the thesis on a scene, from the same initial complex.
#pragma once

#include "dsc/complex/complex.h"
#include "measures/mesh_quality.h"
#include "scenes/run/run.h"

#include "reference/algorithm/dsc.h"

namespace dsc::scenes {

/// Converts a complex to one of the reference.
[[nodiscard]] reference::Complex to_reference(const Complex<double>& complex);
/// The reverse. O(n log n).
[[nodiscard]] Complex<double> from_reference(const reference::Complex& complex);
/// The options that match `scene_options`.
[[nodiscard]] reference::Options reference_options(const Parameters& parameters);

/// A run by the reference; the setup must outlive it.
class ReferenceMethod {
public:
    ReferenceMethod(const Setup& setup, const Parameters& parameters, const RunOptions& run,
                    InputReport* report = nullptr);

    void step(double begin, double end, RunResult& result);
    /// Converted on the first call after each step.
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
