// SPDX-License-Identifier: MIT
// The hard cases: see hard/result.h.
#include "hard/expect_case.h"

#include <gtest/gtest.h>

namespace dsc::hard_test {
namespace {

class Hard : public testing::TestWithParam<hard::HardCase> {};

TEST_P(Hard, Holds) { hard::expect_case(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Cases, Hard, testing::ValuesIn(hard::cases_that_are(false)),
                         hard::test_name);

} // namespace
} // namespace dsc::hard_test
