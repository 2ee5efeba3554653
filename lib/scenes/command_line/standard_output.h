// SPDX-License-Identifier: MIT
// The end of every program: checks that standard output was written.
#pragma once

#include "dsc/base/error.h"

#include <cerrno>
#include <cstdio>
#include <iostream>
#include <string>

namespace dsc::scenes {

/// The exit code of `main`: `code`; but 1 in place of 0, with a sentence on stderr, if standard
/// output could not be written completely.
inline int with_output_written(const std::string& program, int code) {
    errno = 0;
    if (std::cout.flush() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0) {
        return code;
    }
    const FileError error("could not be written completely", "standard output", errno);
    std::cerr << program << ": " << error.what() << '\n';
    return code == 0 ? 1 : code;
}

} // namespace dsc::scenes
