// SPDX-License-Identifier: MIT
#include "scenes/output/frame_pieces.h"

#include <exception>
#include <filesystem>
#include <vector>

namespace dsc::scenes {

template <class Real>
void write_in_pieces(const std::string& path, const Complex<Real>& complex,
                     std::span<const VtuArray> more, Ranks& ranks) {
    const std::filesystem::path list(path);
    std::vector<std::string> names;
    for (std::uint32_t rank = 1; rank <= ranks.size(); ++rank) {
        // Their number is in the name, so that those of another run are never taken for these.
        names.push_back(list.stem().string() + "." + std::to_string(rank) + "of" +
                        std::to_string(ranks.size()) + ".vtu");
    }
    ranks.begin();
    std::exception_ptr failure;
    try {
        write_vtu(complex, (list.parent_path() / names[ranks.rank()]).string(), more,
                  {.number = ranks.rank(), .of = ranks.size()});
    } catch (...) { // NOLINT: told to all ranks, and thrown by all
        failure = std::current_exception();
    }
    (void)ranks.exchange(failure);
    if (ranks.failed_with()) {
        std::rethrow_exception(ranks.failed_with());
    }
    if (ranks.rank() == 0) {
        write_pvtu(complex, path, names, more);
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void write_in_pieces(const std::string&, const Complex<Real>&,                        \
                                  std::span<const VtuArray>, Ranks&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::scenes
