// SPDX-License-Identifier: MIT
// One binary for every x86-64, with wide vectors where the machine has them.
#pragma once

#include <cstddef> // tells whether this is glibc

/// Before a function: it is compiled for each set of instructions, with all that it calls in its
/// file, and the loader takes the widest that the machine can run. No version contracts a product
/// and a sum (-ffp-contract=off), hence all give the same bits. The choice is made by a resolver,
/// which other C libraries than glibc do not call and sanitizers do not work with.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__) &&       \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define DSC_EACH_INSTRUCTION_SET                                                                   \
    __attribute__((flatten, target_clones("default", "avx2", "avx512f")))
#else
#define DSC_EACH_INSTRUCTION_SET
#endif
