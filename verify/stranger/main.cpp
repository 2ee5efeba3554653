// SPDX-License-Identifier: MIT
// A program that knows the library only through find_package(dsc).
#include "dsc/base/predicates.h"

#include <iostream>

int main() {
    // Collinear in decimals; the third point's double lies a hair to the left of the line.
    const int sign = dsc::exact::orientation(0.0, 0.0, 0.1, 0.1, 0.3, 0.1 + 0.2);
    std::cout << "orientation " << sign << '\n';
    return sign == 1 && dsc::orientation(0.0, 0.0, 0.1, 0.1, 0.3, 0.1 + 0.2) == 1 ? 0 : 1;
}
