// SPDX-License-Identifier: MIT
// One binary for all x86-64 processors, with wide vectors on those that have them.
#pragma once

#include <cstddef> // defines __GLIBC__ with glibc

/// An attribute of a function: the function, and the functions of its file that it calls, are
/// compiled for each instruction set, and the loader chooses the widest one that the machine
/// supports. No version contracts a product and a sum (-ffp-contract=off), so all give bitwise
/// identical results. The choice needs a resolver, which C libraries other than glibc do not call
/// and sanitizers do not support.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__) &&       \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define DSC_EACH_INSTRUCTION_SET                                                                   \
    __attribute__((flatten, target_clones("default", "avx2", "avx512f")))
#else
#define DSC_EACH_INSTRUCTION_SET
#endif
