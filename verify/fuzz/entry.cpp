// SPDX-License-Identifier: MIT
// The entry points of libFuzzer. The argument --target=NAME, which libFuzzer ignores, chooses the
// target.
#include "fuzz/target.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>

namespace {

dsc::fuzz::Run run = nullptr; // libFuzzer offers no other place

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    std::string allowed;
    for (const dsc::fuzz::Target& target : dsc::fuzz::targets()) {
        if (std::find(*argv, *argv + *argc, "--target=" + target.name) != *argv + *argc) {
            run = target.run;
        }
        allowed += " --target=" + target.name;
    }
    if (run == nullptr) {
        std::cerr << "no such target; allowed:" << allowed << '\n';
        std::_Exit(2);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        run({data, size});
    } catch (const std::exception& error) {
        std::cerr << "finding: " << error.what() << '\n';
        std::abort();
    }
    return 0;
}
