// SPDX-License-Identifier: MIT
// The shape that an exact method would have at a time; all others are measured against it.
#pragma once

#include "shapes/outline.h"

#include <string>
#include <vector>

namespace dsc::scenes {

struct ExactShape {
    std::vector<Outline> outlines;
    double area = 0.0;       ///< exact, of the true shape rather than of its outlines
    std::string description; ///< how it was found
    double own_error = 0.0;  ///< estimate of the area between the outlines and the true shape
};

} // namespace dsc::scenes
