// SPDX-License-Identifier: MIT
// The sequential method of the thesis, taken literally, on a scene, from the same initial complex.
#pragma once

#include "dsc/complex/complex.h"
#include "scenes/run/run.h"

#include "reference/algorithm/dsc.h"

namespace dsc::scenes {

/// The arrays of a complex as the reference takes them.
[[nodiscard]] reference::Complex to_reference(const Complex<double>& complex);
/// The reverse. O(n log n).
[[nodiscard]] Complex<double> from_reference(const reference::Complex& complex);
/// The options that match `scene_options`.
[[nodiscard]] reference::Options reference_options(const Parameters& parameters);

class ReferenceMethod {
public:
    ReferenceMethod(const Setup& setup, const Parameters& parameters, const RunOptions& run);

    void step(const Velocity& velocity, double time, double dt, RunResult& result);
    /// Converted anew after each step, on the first request.
    [[nodiscard]] const Complex<double>& complex();
    [[nodiscard]] std::uint64_t interface_vertices();
    [[nodiscard]] std::uint64_t vertex_steps() const { return vertex_steps_; }
    [[nodiscard]] std::uint32_t threads_used() const { return 1; }
    [[nodiscard]] std::optional<double> busy_beyond_one() const { return 0; }

private:
    reference::Complex method_;
    reference::Options options_;
    Complex<double> converted_;
    bool stale_ = true;
    std::uint64_t vertex_steps_ = 0;
};

} // namespace dsc::scenes
