// SPDX-License-Identifier: MIT
// The loop has no branches and no calls, so that it can be vectorised.
#include "flows/sine_cosine.h"

#include "fluid/solve/instruction_sets.h"

#include <bit>
#include <cstdint>
#include <numbers>

namespace dsc::scenes {

namespace {

/// 1.5 2^52: adding it leaves the nearest integer in the low bits of the sum.
constexpr double rounding_magic = 6755399441055744.0;
using std::numbers::pi;

/// Near-minimax (Chebyshev) fits in z = r^2 for |r| <= 1/4, computed with 60 digits:
/// sin(pi r) = pi r + r z S(z) to 1e-17 and cos(pi r) = 1 + z C(z) to 2e-19.
inline double sine_tail(double z) {
    double sum = 0.00046221110224187623;
    sum = sum * z - 0.0073701436435937495;
    sum = sum * z + 0.082145877306416246;
    sum = sum * z - 0.59926452918453854;
    sum = sum * z + 2.5501640398766154;
    return sum * z - 5.1677127800499694;
}

inline double cosine_tail(double z) {
    double sum = -0.00010370082971594627;
    sum = sum * z + 0.001929493874894941;
    sum = sum * z - 0.025806887964701878;
    sum = sum * z + 0.23533063028399223;
    sum = sum * z - 1.3352627688538095;
    sum = sum * z + 4.0587121264167649;
    return sum * z - 4.934802200544679;
}

} // namespace

DSC_EACH_INSTRUCTION_SET
void sine_cosine_pi(const double* __restrict x, std::size_t count, double* __restrict sine,
                    double* __restrict cosine) {
    for (std::size_t i = 0; i < count; ++i) {
        // x = quadrant/2 + r with |r| <= 1/4; the subtraction is exact.
        const double shifted = 2.0 * x[i] + rounding_magic;
        const auto quadrant = std::bit_cast<std::uint64_t>(shifted);
        const double r = x[i] - 0.5 * (shifted - rounding_magic);
        const double z = r * r;
        const auto s = std::bit_cast<std::uint64_t>(pi * r + r * z * sine_tail(z));
        const auto c = std::bit_cast<std::uint64_t>(1.0 + z * cosine_tail(z));
        const std::uint64_t swap = (0U - (quadrant & 1U)) & (s ^ c);
        sine[i] = std::bit_cast<double>((s ^ swap) ^ ((quadrant & 2U) << 62U));
        cosine[i] = std::bit_cast<double>((c ^ swap) ^ (((quadrant + 1U) & 2U) << 62U));
    }
}

} // namespace dsc::scenes
