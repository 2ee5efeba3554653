// SPDX-License-Identifier: MIT
// The end of every program: whether standard output has taken what was printed.
#pragma once

#include "dsc/base/error.h"

#include <cerrno>
#include <cstdio>
#include <iostream>
#include <string>

namespace dsc::scenes {

/// The exit code of `main`: `code`; or 1 in place of 0 where not all that was printed could be
/// written, which a sentence on stderr says.
inline int with_output_written(const std::string& program, int code) {
    errno = 0;
    if (std::cout.flush() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0) {
        return code;
    }
    const FileError error("not all could be written", "standard output", errno);
    std::cerr << program << ": " << error.what() << '\n';
    return code == 0 ? 1 : code;
}

} // namespace dsc::scenes
