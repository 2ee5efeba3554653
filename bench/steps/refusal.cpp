// SPDX-License-Identifier: MIT
#include "steps/refusal.h"

namespace dsc::bench {

namespace {

std::size_t& count() {
    static std::size_t refused = 0;
    return refused;
}

} // namespace

void refuse(benchmark::State& state, const std::string& reason) {
    ++count();
    state.SkipWithError(reason.c_str());
}

std::size_t refusals() { return count(); }

} // namespace dsc::bench
