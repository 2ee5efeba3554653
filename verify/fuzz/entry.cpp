// SPDX-License-Identifier: MIT
// What libFuzzer calls. The environment says which target runs (DSC_FUZZ_TARGET), and names a file
// that gets a line when the program ends (DSC_FUZZ_TALLY): inputs, operations.
#include "fuzz/target.h"

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace {

struct Tally {
    std::uint64_t inputs = 0;
    std::uint64_t operations = 0;
};
Tally tally;

void write_tally() {
    if (const char* path = std::getenv("DSC_FUZZ_TALLY")) {
        std::ofstream(path, std::ios::app) << tally.inputs << ' ' << tally.operations << '\n';
    }
}

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

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
    std::atexit(write_tally);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const dsc::fuzz::Run run = chosen_target();
    ++tally.inputs;
    try {
        tally.operations += run({data, size});
    } catch (const std::exception& error) {
        std::cerr << "finding: " << error.what() << '\n';
        write_tally();
        std::abort();
    }
    return 0;
}
