// SPDX-License-Identifier: MIT
// The hard cases that take minutes.
#include "hard/expect_case.h"

namespace dsc::hard_long_test {
namespace {

class HardLong : public testing::TestWithParam<hard::HardCase> {};

TEST_P(HardLong, Holds) { hard::expect_case(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Cases, HardLong, testing::ValuesIn(hard::cases_that_are(true)),
                         hard::test_name);

} // namespace
} // namespace dsc::hard_long_test
