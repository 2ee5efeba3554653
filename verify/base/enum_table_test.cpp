// SPDX-License-Identifier: MIT
// The table of each enum has all of its values: what is listed, parsed or drawn at random from a
// table then misses none. An enumerator without an entry does not compile here.
#include "dsc/base/verdict.h"

#include "support/enumerators.h"
#include "support/random/complex.h"
#include "support/random/scene.h"
#include "support/random/submeshes.h"

#include "dsc/base/names.h"
#include "dsc/passes/options.h"

#include <gtest/gtest.h>

namespace dsc::enum_table_test {
namespace {

using test::is_complete;

static_assert(is_complete(verdict_names));
static_assert(is_complete(integrator_names));
static_assert(is_complete(insertion_names));
static_assert(is_complete(reading_names));
static_assert(is_complete(coarsening_names));
static_assert(is_complete(assignment_names));
static_assert(is_complete(test::phase_pattern_names));
static_assert(is_complete(test::wildness_names));
static_assert(is_complete(test::partition_families));

// The check itself: what it must find.
enum class Fruit : std::uint8_t { apple, pear, plum };
static_assert(is_complete(std::array{Named{Fruit::apple, "apple"}, Named{Fruit::pear, "pear"},
                                     Named{Fruit::plum, "plum"}}));
static_assert(!is_complete(std::array{Named{Fruit::apple, "apple"}, Named{Fruit::plum, "plum"}}));
static_assert(!is_complete(std::array{Named{Fruit::apple, "apple"}, Named{Fruit::pear, "pear"},
                                      Named{Fruit::pear, "plum"}}));
static_assert(!is_complete(std::array{Named{Fruit::apple, "apple"}, Named{Fruit::pear, "plum"},
                                      Named{Fruit::plum, "plum"}}));
static_assert(test::identifier<Fruit::pear>() == "pear");
static_assert(test::identifier<static_cast<Fruit>(7)>().empty());

constexpr std::array fruit_names{Named{Fruit::apple, "apple"}, Named{Fruit::pear, "a pear"},
                                 Named{Fruit::plum, "plum"}};

TEST(EnumTable, LeadsFromValuesToNamesAndBack) {
    EXPECT_EQ(name_in(fruit_names, Fruit::pear), "a pear");
    EXPECT_EQ(name_in(fruit_names, static_cast<Fruit>(3)), "unknown");
    EXPECT_EQ(value_in(fruit_names, "plum"), Fruit::plum);
    EXPECT_EQ(value_in(fruit_names, "pear"), std::nullopt);
    EXPECT_EQ(value_in(fruit_names, ""), std::nullopt);
    EXPECT_EQ(names_in(fruit_names), "apple, a pear, plum");
}

} // namespace
} // namespace dsc::enum_table_test
