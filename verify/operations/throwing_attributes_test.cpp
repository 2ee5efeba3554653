// SPDX-License-Identifier: MIT
// Attributes whose copies and blends throw: the edit is completed all the same, and all other data
// with it.
#include "support/conserved.h"
#include "support/operations_testing.h"
#include "support/random/complex.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/ranges.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "dsc/queries/validate.h"
#include "replay/mesh_hash.h"
#include "thesis/operations/local_retriangulation.h"
#include "thesis/operations/loop_subdivision.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

namespace dsc::test::throwing_attributes_test {
namespace {

// A type whose copies and blends throw when a countdown ends.
struct Fragile {
    static inline int countdown = -1;
    static void touch() {
        if (countdown >= 0 && countdown-- == 0) {
            throw std::domain_error("as seeded");
        }
    }
    double value = 0;

    Fragile() = default;
    Fragile(double number) : value(number) {} // NOLINT(google-explicit-constructor)
    Fragile(const Fragile&) = default;
    Fragile& operator=(const Fragile& other) {
        touch();
        value = other.value;
        return *this;
    }
    ~Fragile() = default;
};

Complex<double> with_fragile() {
    auto complex = random_complex<double>(11, {.points = 60, .phases = 1, .holes = 0, .locked = 0});
    complex.attributes.add<Vertex>("sturdy", 1.0).data()[0] = 5;
    complex.attributes.add<Vertex>(
        "fragile", Fragile(1),
        [](const Fragile& a, const Fragile&, double) { return Fragile(a.value); });
    complex.attributes.add<Edge>("fragile edges", Fragile(2));
    complex.attributes.add<Edge>("edges", 3);
    complex.attributes.add<Triangle>("fragile triangles", Fragile(3));
    complex.attributes.add(std::make_unique<Conserved>("triangles"));
    return complex;
}

// Checks that the operation is completed: only the data that threw differ from a run without the
// exception.
template <class Operate>
int expect_whole(Operate operate) {
    Fragile::countdown = -1;
    const Complex<double> start = with_fragile();
    Complex<double> expected = start;
    expected.journal.readers = 1;
    operate(expected);
    int thrown = 0;
    for (bool throws = true; throws; thrown += throws ? 1 : 0) {
        Fragile::countdown = -1;
        Complex<double> complex = start;
        complex.journal.readers = 1;
        Fragile::countdown = thrown;
        throws = false;
        try {
            operate(complex);
        } catch (const std::domain_error&) {
            throws = true;
        }
        Fragile::countdown = -1;
        EXPECT_EQ(validate(complex).problem, "");
        EXPECT_EQ(mesh_hash(complex), mesh_hash(expected));
        EXPECT_EQ(complex.journal.records.size(), expected.journal.records.size());
        EXPECT_EQ((complex.attributes.get<Vertex, double>("sturdy").data()),
                  (expected.attributes.get<Vertex, double>("sturdy").data()));
        EXPECT_EQ((complex.attributes.get<Edge, int>("edges").data()),
                  (expected.attributes.get<Edge, int>("edges").data()));
    }
    return thrown;
}

// Applies the operation to the first simplex for which it is legal.
template <class Simplices, class Operate>
void on_first(const Simplices& simplices, Operate operate) {
    for (const auto simplex : simplices) {
        if (operate(simplex) == Verdict::legal) {
            return;
        }
    }
    ADD_FAILURE() << "nothing was legal";
}

TEST(AttributesThatThrow, LeaveEachEditWhole) {
    EXPECT_GE(expect_whole([](auto& K) {
                  on_first(edges(K), [&](Edge e) { return edge_split(K, e).verdict; });
              }),
              4);
    EXPECT_GE(
        expect_whole([](auto& K) { on_first(edges(K), [&](Edge e) { return edge_flip(K, e); }); }),
        3);
    EXPECT_GE(expect_whole(
                  [](auto& K) { on_first(edges(K), [&](Edge e) { return edge_collapse(K, e); }); }),
              1);
    EXPECT_GE(expect_whole([](auto& K) {
                  on_first(triangles(K),
                           [&](Triangle t) { return local_retriangulation(K, t).verdict; });
              }),
              3);
    EXPECT_GE(expect_whole([](auto& K) {
                  on_first(triangles(K),
                           [&](Triangle t) { return loop_subdivision(K, t).verdict; });
              }),
              10);
}

} // namespace
} // namespace dsc::test::throwing_attributes_test
