// SPDX-License-Identifier: MIT
// Options are checked where they come in, one sentence each.
#pragma once

#include "dsc/base/error.h"

#include <sstream>

namespace dsc {

/// Throws InputError where `good` is false: the option `name` has this value.
inline void require(bool good, const char* name, double value, const char* allowed) {
    if (!good) {
        std::ostringstream text;
        text << value;
        throw InputError("value out of range", name, text.str(), allowed);
    }
}

} // namespace dsc
