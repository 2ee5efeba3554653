// SPDX-License-Identifier: MIT
// Errors store their fields separately, and their message has all of them in one sentence.
#include "dsc/base/error.h"

#include <gtest/gtest.h>

namespace dsc::error_test {
namespace {

TEST(InputErrors, KeepTheirFieldsApart) {
    const InputError error(
        {.what = "no bins", .where = "histogram", .value = "0", .allowed = "1 or more"});
    EXPECT_EQ(error.problem(), "no bins");
    EXPECT_EQ(error.where(), "histogram");
    EXPECT_EQ(error.value(), "0");
    EXPECT_EQ(error.allowed(), "1 or more");
    EXPECT_STREQ(error.what(), "histogram: no bins: got 0; allowed: 1 or more");
}

TEST(FileErrors, GiveTheReasonOfTheSystem) {
    const FileError error("cannot be written", "frames/a.svg", ENOENT);
    EXPECT_STREQ(error.what(), "frames/a.svg: cannot be written: No such file or directory");
    EXPECT_EQ(error.path(), "frames/a.svg");
    EXPECT_EQ(error.error(), ENOENT);
    const FileError plain("is not whole", "a.json");
    EXPECT_STREQ(plain.what(), "a.json: is not whole");
    EXPECT_EQ(plain.error(), 0);
}

} // namespace
} // namespace dsc::error_test
