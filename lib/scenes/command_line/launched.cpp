// SPDX-License-Identifier: MIT
#include "scenes/command_line/launched.h"

#include "dsc/base/error.h"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <span>
#include <string_view>

namespace dsc::scenes {

namespace {

// Of Open MPI; of MPICH and Intel's, also under srun.
constexpr std::array sizes{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"};
constexpr std::array numbers{"OMPI_COMM_WORLD_RANK", "PMI_RANK"};

// The value of the first of these variables that is set; empty if none is.
std::string_view first_of(std::span<const char* const> names) {
    for (const char* name : names) {
        if (const char* value = std::getenv(name)) { // NOLINT: nobody here sets variables
            return value;
        }
    }
    return {};
}

} // namespace

bool is_launched() { return !first_of(sizes).empty(); }

void become(const std::string& name, char** arguments) {
    std::error_code error;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
    if (!error) {
        execv((self.parent_path() / name).c_str(), arguments);
    }
}

bool is_alone(const std::string& program) {
    const std::string_view size = first_of(sizes);
    if (size == "1") {
        return true;
    }
    if (first_of(numbers) == "0") {
        const InputError error({.what = "this program was built without MPI",
                                .where = "mpirun",
                                .value = std::string(size) + " processes",
                                .allowed = "1, or a build where MPI is installed"});
        std::cerr << program << ": " << error.what() << '\n';
    }
    return false;
}

} // namespace dsc::scenes
