// SPDX-License-Identifier: MIT
// Attributes: found by name, kind and type; an edge is written at both its corners; and a class
// defined by the application, a quantity that no operation may lose, is carried through every
// operation.
#include "support/copy_testing.h"
#include "support/operations_testing.h"
#include "support/random/complex.h"
#include "support/refusal.h"
#include "support/simulation_testing.h"
#include "support/small_meshes.h"

#include "dsc/base/error.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/ranges.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "dsc/quality/measures.h"
#include "thesis/operations/local_retriangulation.h"
#include "thesis/operations/loop_subdivision.h"

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
    expect_refused([&] { all.add(std::unique_ptr<VertexAttribute<int>>()); }, "no attribute");
    expect_refused([&] { all.remove("cold"); }, "no such attribute");
    all.remove("load");
    EXPECT_TRUE(all.empty(SimplexKind::triangle));
    EXPECT_FALSE(all.empty());
}

TEST(Attributes, AreFieldsInACopyAsWell) {
    auto complex = hexagon<double>();
    complex.attributes.add<Vertex, double>("kept");
    complex.attributes.add<Vertex, double>("heat").set_field(true, OnInterface::carried);
    const Complex<double> copy = complex;
    Complex<double> assigned;
    assigned = complex;
    for (const AttributeSet* set :
         std::initializer_list<const AttributeSet*>{&copy.attributes, &assigned.attributes}) {
        EXPECT_TRUE(set->has_fields());
        ASSERT_EQ(set->list().size(), 2U);
        EXPECT_FALSE(set->list()[0]->is_field());
        EXPECT_TRUE(set->list()[1]->is_field());
        EXPECT_EQ(set->list()[1]->on_interface(), OnInterface::carried);
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

/// A quantity of the triangles that moves with the area: divided where a triangle is cut or two are
/// flipped, handed over where one vanishes.
class Conserved final : public AttributeBase {
public:
    explicit Conserved(std::string name) : AttributeBase(std::move(name), SimplexKind::triangle) {}

    double& operator[](Triangle t) { return values_[t.id]; }

    [[nodiscard]] std::size_t size() const override { return values_.size(); }
    void resize(std::size_t size) override { values_.resize(size, 0); }
    [[nodiscard]] std::unique_ptr<AttributeBase> clone_empty() const override {
        return std::make_unique<Conserved>(name());
    }
    void append(const AttributeBase& from, const std::vector<std::uint32_t>& order) override {
        for (const std::uint32_t entry : order) {
            values_.push_back(entry == no_id ? 0
                                             : static_cast<const Conserved&>(from).values_[entry]);
        }
    }
    void swap_entries(AttributeBase& other) noexcept override {
        values_.swap(static_cast<Conserved&>(other).values_);
    }
    void copy(std::uint32_t to, std::uint32_t from) override { values_[to] = values_[from]; }
    void reset(std::uint32_t to) override { values_[to] = 0; }

    void split(std::uint32_t to, std::uint32_t from, double share) override {
        values_[to] = share * values_[from];
        values_[from] -= values_[to];
    }
    void merge(std::uint32_t into, std::uint32_t gone) override { values_[into] += values_[gone]; }
    void flip(std::uint32_t one, std::uint32_t other, double share) override {
        const double both = values_[one] + values_[other];
        values_[one] = share * both;
        values_[other] = both - values_[one];
    }

private:
    std::vector<double> values_;
};

template <class Real>
Conserved& with_density_one(Complex<Real>& complex) {
    auto& mass = complex.attributes.add(std::make_unique<Conserved>("mass"));
    for (const Triangle t : triangles(complex)) {
        mass[t] = static_cast<double>(area(complex, t));
    }
    return mass;
}

template <class Real>
double total(const Complex<Real>& complex, Conserved& mass) {
    double sum = 0;
    for (const Triangle t : triangles(complex)) {
        sum += mass[t];
    }
    return sum;
}

// Cuts and flips keep a density of one exactly: each triangle has its area. Where vertices go, the
// total stays.
TEST(OwnAttributes, AreSharedOutByAreaAndConserved) {
    std::array<int, 5> done{};
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Random random(seed);
        RandomComplexOptions options = random_options(seed, 40);
        options.scramble = 0;
        options.at_resolution = false; // rounded places do not keep the area
        auto complex = random_complex<double>(seed, options);
        auto& mass = with_density_one(complex);
        const double whole = total(complex, mass);
        const std::uint32_t kinds = seed % 2 == 0 ? 3 : 5;
        for (int step = 0; step < 60; ++step) {
            const Triangle t{random.below(complex.triangle_bound())};
            if (!complex.is_alive(t)) {
                continue;
            }
            const Edge e = complex.edge(corner_of(t.id, random.below(3)));
            const auto [a, b] = complex.vertices_of(e);
            const Point<double> third = (2 * complex.position(a) + complex.position(b)) / 3;
            const std::uint32_t what = random.below(kinds);
            const Verdict verdict =
                what == 0   ? edge_flip(complex, e)
                : what == 1 ? edge_split(complex, e, third).verdict
                : what == 2 ? loop_subdivision(complex, t).verdict
                : what == 3
                    ? edge_collapse(complex, e)
                    : local_retriangulation(Submesh(complex), t, RetriangulationMethod::delaunay)
                          .verdict;
            done[what] += verdict == Verdict::legal ? 1 : 0;
            ASSERT_NEAR(total(complex, mass), whole, 1e-11 * std::abs(whole))
                << "operation " << what << ", seed " << seed;
        }
        for (const Triangle t : triangles(complex)) {
            if (kinds == 3) {
                ASSERT_NEAR(mass[t], area(complex, t), 1e-11 * whole) << "seed " << seed;
            }
        }
    }
    for (const int count : done) {
        EXPECT_GT(count, 20);
    }
}

// The reference stays valid in steps, in place and through copies; and in a copy of the complex,
// and through a renumbering.
TEST(OwnAttributes, FollowASimulation) {
    constexpr double h = 0.05;
    for (const bool by_copies : {false, true}) {
        auto complex = disc_complex<double>(h);
        auto& mass = with_density_one(complex);
        const double whole = total(complex, mass);
        const Options<double> options = options_for<double>(h);
        auto simulation = by_copies ? in_copies(complex, options, {.submeshes = 3, .threads = 2})
                                    : Simulation<double>(complex, options);
        std::uint64_t edits = 0;
        for (int step = 0; step < 6; ++step) {
            const auto report = simulation.step(constant<double>(0.4 * h, 0.3 * h), 0, 1);
            edits += report.operations.splits + report.operations.collapses;
        }
        EXPECT_GT(edits, 10U);
        EXPECT_NEAR(total(complex, mass), whole, 1e-11);
        Complex<double> copy = complex;
        auto& copied = copy.attributes.get<Conserved>("mass");
        EXPECT_NE(&copied, &mass);
        renumber(copy);
        EXPECT_NEAR(total(copy, copied), whole, 1e-11);
        EXPECT_NEAR(total(complex, mass), whole, 1e-11);
    }
}

} // namespace
} // namespace dsc::test::attributes_test
