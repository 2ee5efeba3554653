// SPDX-License-Identifier: MIT
#include "fuzz/target.h"

namespace dsc::fuzz {

const std::vector<Target>& targets() {
    static const std::vector<Target> all{
        {"operations", run_operations}, {"steps", run_steps},
        {"scene_file", run_scene_file}, {"outlines", run_outlines},
        {"formulas", run_formulas},     {"command_line", run_command_line},
        {"archives", run_archives},
    };
    return all;
}

} // namespace dsc::fuzz
