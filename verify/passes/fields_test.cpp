// SPDX-License-Identifier: MIT
// Vertex attributes that are samples of a field: after a step they have the value at the new
// position.
#include "support/courses.h"
#include "support/simulation_testing.h"

#include "dsc/complex/ranges.h"
#include "dsc/queries/phases.h"

#include <gtest/gtest.h>

namespace dsc::fields_test {
namespace {

double plane_at(const Point<double>& p) { return 3 + p.x() - 2 * p.y(); }

// A linear field stays exact when the flow moves the interface, smoothing moves inner vertices, and
// remeshing inserts new ones; for each kind of insertion, and in submeshes.
TEST(Fields, AreThoseOfThePlaceWhereTheFlowMovesTheInterface) {
    const Velocity<double> strain = test::pointwise<double>(
        [](const Point<double>& p, double) { return Point<double>(p.x() - 0.5, 0.7 - p.y()); });
    for (const Insertion insertion : {Insertion::linear, Insertion::cubic}) {
        for (const test::Course& way : test::all_courses) {
            Complex<double> complex = test::disc();
            auto& field = complex.attributes.add<Vertex, double>("field");
            auto& advected = complex.attributes.add<Vertex, double>("advected");
            auto& label = complex.attributes.add<Vertex>(
                "label", 0.0, [](double a, double, double) { return a; });
            field.set_field(true);
            advected.set_field(true, OnInterface::advected);
            Options<double> options{.edge_length = test::disc_h};
            options.insertion = insertion;
            options.interface.coarsening = Coarsening::length;
            const auto simulation = test::make_simulation(complex, options, way);
            for (const Vertex v : vertices(complex)) {
                field[v] = plane_at(complex.position(v));
                advected[v] = is_interface(complex, v) ? -1 : plane_at(complex.position(v));
                label[v] = is_interface(complex, v) ? 1 : 0;
            }
            OperationCounts counts;
            for (int step = 0; step < 20; ++step) {
                counts += simulation->step(strain, 0.02 * step, 0.02).operations;
            }
            EXPECT_GT(counts.interface_splits, 10U) << way.name;
            EXPECT_GT(counts.smoothed, 10U) << way.name;
            for (const Vertex v : vertices(complex)) {
                ASSERT_NEAR(field[v], plane_at(complex.position(v)), 1e-12)
                    << way.name << ", vertex " << v.id;
                if (is_interface(complex, v)) {
                    ASSERT_EQ(advected[v], -1) << way.name;
                    ASSERT_EQ(label[v], 1) << way.name;
                }
            }
        }
    }
}

// If the application moves a vertex, the field's value is kept.
TEST(Fields, KeepTheirValuesWhereTheApplicationMovesAVertex) {
    Complex<double> complex = test::disc();
    auto& field = complex.attributes.add<Vertex, double>("field");
    field.set_field(true);
    for (const Vertex v : vertices(complex)) {
        field[v] = plane_at(complex.position(v));
    }
    const Vertex v{complex.vertex_bound() / 2};
    const double before = field[v];
    complex.set_position(v, complex.position(v) + Point<double>(0.1 * test::disc_h, 0));
    EXPECT_EQ(field[v], before);
}

} // namespace
} // namespace dsc::fields_test
