// SPDX-License-Identifier: MIT
// Checks of options, for the functions that receive them.
#pragma once

#include "dsc/base/error.h"

#include <sstream>

namespace dsc {

/// Throws InputError if `good` is false for this value of the option `name`.
inline void require(bool good, const char* name, double value, const char* allowed) {
    if (!good) {
        std::ostringstream text;
        text << value;
        throw InputError(
            {.what = "value out of range", .where = name, .value = text.str(), .allowed = allowed});
    }
}

} // namespace dsc
