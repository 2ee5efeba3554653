// SPDX-License-Identifier: MIT
// What libFuzzer calls. DSC_FUZZ_TARGET in the environment says which target runs.
#include "fuzz/target.h"

#include <cstdlib>
#include <exception>
#include <iostream>

namespace {

dsc::fuzz::Run chosen_target() {
    const char* name = std::getenv("DSC_FUZZ_TARGET");
    std::string allowed;
    for (const dsc::fuzz::Target& target : dsc::fuzz::targets()) {
        if (name != nullptr && target.name == name) {
            return target.run;
        }
        allowed += ' ' + target.name;
    }
    std::cerr << "DSC_FUZZ_TARGET: got " << (name != nullptr ? name : "nothing")
              << "; allowed:" << allowed << '\n';
    std::_Exit(2);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const dsc::fuzz::Run run = chosen_target();
    try {
        run({data, size});
    } catch (const std::exception& error) {
        std::cerr << "finding: " << error.what() << '\n';
        std::abort();
    }
    return 0;
}
