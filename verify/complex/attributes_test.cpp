// SPDX-License-Identifier: MIT
// Attributes are found by name, kind and type; writing an edge's value updates both of its corners.
#include "support/refusal.h"
#include "support/small_meshes.h"

#include "dsc/complex/complex.h"

#include <gtest/gtest.h>

namespace dsc::test::attributes_test {
namespace {

TEST(Attributes, AreFoundByNameKindAndType) {
    auto complex = hexagon<double>();
    auto& heat = complex.attributes.add<Vertex>("heat", 20.0);
    complex.attributes.add<Triangle, int>("load");
    const auto& constant = complex;
    EXPECT_EQ(&complex.attributes.get<VertexAttribute<double>>("heat"), &heat);
    EXPECT_EQ(&(complex.attributes.get<Vertex, double>("heat")), &heat);
    EXPECT_EQ((constant.attributes.get<Vertex, double>("heat")[Vertex{3}]), 20.0);
    EXPECT_TRUE(complex.attributes.contains("load"));
    EXPECT_FALSE(complex.attributes.empty(SimplexKind::triangle));
    EXPECT_TRUE(complex.attributes.empty(SimplexKind::edge));

    const auto expect_refused = [](const auto& act, const std::string& why) {
        const std::string text = refusal(act);
        EXPECT_NE(text.find(why), std::string::npos) << text;
    };
    auto& all = complex.attributes;
    expect_refused([&] { (void)all.get<Vertex, double>("cold"); }, "no such attribute");
    expect_refused([&] { (void)all.get<Vertex, float>("heat"); }, "another type");
    expect_refused([&] { (void)all.get<Triangle, double>("heat"); }, "another kind of simplex");
    expect_refused([&] { (void)all.get<VertexAttribute<int>>("heat"); }, "another type");
    expect_refused([&] { all.add<Edge, double>("heat"); }, "of that name exists");
    expect_refused([&] { all.add(std::unique_ptr<VertexAttribute<int>>()); }, "null pointer");
    expect_refused([&] { all.remove("cold"); }, "no such attribute");
    all.remove("load");
    EXPECT_TRUE(all.empty(SimplexKind::triangle));
    EXPECT_FALSE(all.empty());
}

TEST(Attributes, HaveTheRoomThatWasReservedBefore) {
    auto complex = hexagon<double>();
    complex.reserve(1000, 2000);
    EXPECT_GE((complex.attributes.add<Vertex, double>("heat").data().capacity()), 1000U);
    EXPECT_GE((complex.attributes.add<Triangle, double>("load").data().capacity()), 2000U);
}

TEST(Attributes, AreFieldsInACopyAsWell) {
    auto complex = hexagon<double>();
    complex.attributes.add<Vertex, double>("kept");
    complex.attributes.add<Vertex, double>("heat").set_field(true, OnInterface::advected);
    const Complex<double> copy = complex;
    Complex<double> assigned;
    assigned = complex;
    for (const AttributeSet* set :
         std::initializer_list<const AttributeSet*>{&copy.attributes, &assigned.attributes}) {
        EXPECT_TRUE(set->has_fields());
        ASSERT_EQ(set->list().size(), 2U);
        EXPECT_FALSE(set->list()[0]->is_field());
        EXPECT_TRUE(set->list()[1]->is_field());
        EXPECT_EQ(set->list()[1]->on_interface(), OnInterface::advected);
    }
}

TEST(EdgeAttributes, AreSetAtBothCorners) {
    auto complex = hexagon<double>();
    auto& weight = complex.attributes.add<Edge>("weight", 5);
    const Edge inner = complex.find_edge(Vertex{0}, Vertex{2});
    const Edge outer = complex.find_edge(Vertex{1}, Vertex{2});
    weight.set(complex, inner, 7);
    weight.set(complex, outer, 8);
    EXPECT_EQ(weight[inner], 7);
    EXPECT_EQ(weight.at_corner(inner.id), 7);
    EXPECT_EQ(weight.at_corner(complex.twin(inner.id)), 7);
    EXPECT_EQ(weight[outer], 8);
    EXPECT_EQ(weight.data()[border_corner], 5) << "the border is nobody's entry";
    EXPECT_EQ(weight[complex.find_edge(Vertex{0}, Vertex{3})], 5);
}

} // namespace
} // namespace dsc::test::attributes_test
