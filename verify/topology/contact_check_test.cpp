// SPDX-License-Identifier: MIT
// Contact distances of phases that are not there.
#include "dsc/base/error.h"
#include "topology/contact_check.h"

#include "support/small_meshes.h"

#include <gtest/gtest.h>

namespace dsc::contact_check_test {
namespace {

TEST(ContactCheck, PairsWithAPhaseThatIsNotThereDoNotCount) {
    const auto complex = test::grid<double>(8, 0, 1, 2.5);
    const auto between = [](Phase one, Phase other) {
        return TopologyOptions<double>{
            .pairs = {{.one = one, .other = other, .rule = Topology::change, .contact = 100}}};
    };
    EXPECT_THROW(check_contact(complex, between(0, 1), 1.0), InputError);
    for (const auto& options : {between(1, 77), between(77, 1), between(77, 78)}) {
        EXPECT_NO_THROW(check_contact(complex, options, 1.0));
    }
}

} // namespace
} // namespace dsc::contact_check_test
