// SPDX-License-Identifier: MIT
// A restore happens whole or not at all: bytes that are truncated, damaged or of another kind leave
// a complex and a simulation as they were, and further steps are bitwise identical.
#include "support/courses.h"
#include "support/topology/growing_discs.h"

#include "dsc/base/error.h"
#include "dsc/queries/validate.h"
#include "replay/mesh_hash.h"
#include "topology/topology.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>
#include <vector>

namespace dsc::restore_test {
namespace {

using test::disc_h;

template <class Value>
std::string bytes_of(Value& value) {
    Archive archive;
    archive(value);
    return archive.bytes();
}

std::string bytes_of(Simulation<double>& simulation) {
    Archive archive;
    simulation.archive(archive);
    return archive.bytes();
}

// Cut at many lengths, and with one bit changed at many places.
std::vector<std::string> damaged(const std::string& bytes) {
    std::vector<std::string> list{"", bytes.substr(0, bytes.size() - 1)};
    std::mt19937 lot(3);
    for (std::size_t i = 1; i < 40; ++i) {
        list.push_back(bytes.substr(0, i * bytes.size() / 40));
        list.push_back(bytes.substr(0, lot() % 400));
        std::string flipped = bytes;
        // Lengths stand at the beginning, and of the lists of the executor near the end.
        const std::size_t ends = i % 4 < 2 ? 400 : bytes.size();
        const std::size_t from_end = i % 4 == 1 ? bytes.size() - ends : 0;
        char& byte = flipped[from_end + lot() % ends];
        byte = static_cast<char>(byte ^ static_cast<char>(1U << (lot() % 8U)));
        list.push_back(flipped);
    }
    return list;
}

class Restore : public testing::TestWithParam<test::Course> {};
INSTANTIATE_TEST_SUITE_P(Ways, Restore, testing::ValuesIn(test::all_courses), test::course_name);

TEST_P(Restore, OfASimulationHappensWholeOrNotAtAll) {
    const Options<double> options{.edge_length = disc_h};
    Complex<double> undisturbed = test::disc();
    Complex<double> complex = test::disc();
    const auto alone = test::make_simulation(undisturbed, options, GetParam());
    const auto simulation = test::make_simulation(complex, options, GetParam());
    const auto step = [&](int number) {
        (void)alone->step(test::swirl, 0.02 * number, 0.02);
        (void)simulation->step(test::swirl, 0.02 * number, 0.02);
    };
    step(0);
    const std::string earlier = bytes_of(*simulation);
    step(1);
    const std::string before = bytes_of(*simulation);
    int refused = 0;
    for (const std::string& bytes : damaged(earlier)) {
        Archive archive(bytes, "a file");
        try {
            simulation->archive(archive);
            Archive back(before, "before");
            simulation->archive(back);
        } catch (const FileError&) {
            ++refused;
        }
        ASSERT_EQ(bytes_of(*simulation), before);
        ASSERT_EQ(mesh_hash(complex), mesh_hash(undisturbed));
    }
    EXPECT_GT(refused, 80);
    for (int number = 2; number < 8; ++number) {
        step(number);
        test::expect_sound(complex, *simulation);
    }
    EXPECT_EQ(mesh_hash(complex), mesh_hash(undisturbed));
    Archive whole(earlier, "a file");
    simulation->archive(whole);
    EXPECT_EQ(bytes_of(*simulation), earlier);
}

TEST(RestoreOfAComplex, HappensWholeOrNotAtAll) {
    Complex<double> complex = test::disc();
    auto& heat = complex.attributes.add<Vertex, double>("heat", 7);
    complex.attributes.add<Edge, int>("edges", 3);
    const std::string other = bytes_of(complex);
    heat.data()[5] = 8;
    complex.set_phase(Triangle{9}, 4);
    const std::string before = bytes_of(complex);
    for (const std::string& bytes : damaged(other)) {
        Archive archive(bytes, "a file");
        try {
            archive(complex);
            EXPECT_EQ(validate(complex).problem, "");
            Archive back(before, "before");
            archive = back;
            archive(complex);
        } catch (const FileError&) {
        }
        ASSERT_EQ(bytes_of(complex), before);
        ASSERT_EQ(heat.data()[5], 8); // the attribute itself stays
    }
}

TEST(RestoreOfAComplex, RefusesCountsThatDisagree) {
    Complex<double> complex = test::disc();
    complex.attributes.add<Vertex, double>("heat", 7);
    const std::string before = bytes_of(complex);
    const auto expect_refused = [&](auto damage) {
        Complex<double> other = complex;
        damage(other);
        Archive archive(bytes_of(other), "a file");
        EXPECT_THROW(archive(complex), FileError);
        EXPECT_EQ(bytes_of(complex), before);
    };
    expect_refused([](auto& other) {
        other.attributes.template get<Vertex, double>("heat").data().pop_back();
    });
    expect_refused([](auto& other) { other.ids.vertices.push_back(3); });
    expect_refused([](auto& other) { other.triangles.pop_back(); });
    expect_refused([](auto& other) { other.attributes.remove("heat"); });
    expect_refused([](auto& other) {
        other.attributes.remove("heat");
        other.attributes.template add<Edge, double>("heat", 7);
    });
}

// The stage's events have not been taken yet.
TEST(RestoreOfAStage, BringsItsEventsBack) {
    const auto make = [](Complex<double>& complex) {
        const std::vector<Shape> shapes{{test::circle_points({0.35, 0.5}, 0.12, 40), 1},
                                        {test::circle_points({0.65, 0.5}, 0.12, 40), 1}};
        complex = initial_complex<double>({}, shapes, {.edge_length = disc_h});
        return std::make_unique<Simulation<double>>(complex,
                                                    Options<double>{.edge_length = disc_h});
    };
    const auto stage_of = [] {
        return std::make_shared<TopologyStage<double>>(
            TopologyOptions<double>{.rule = Topology::change, .gives_back_area = true});
    };
    const auto grow = test::pointwise<double>([](const Point<double>& p) {
        const Point<double> middle(p.x() < 0.5 ? 0.35 : 0.65, 0.5);
        return Point<double>((p - middle).normalized());
    });
    Complex<double> one;
    Complex<double> other;
    const auto first = make(one);
    const auto second = make(other);
    const auto stage = stage_of();
    const auto again = stage_of();
    first->add_stage(stage);
    second->add_stage(again);
    for (int step = 0; step < 8; ++step) {
        (void)first->step(grow, 0, 0.01);
    }
    Archive archive(bytes_of(*first), "a file");
    second->archive(archive);
    const std::vector<Event> events = stage->take_events();
    const std::vector<Event> restored = again->take_events();
    ASSERT_GE(events.size(), 1U);
    ASSERT_EQ(restored.size(), events.size());
    for (std::size_t i = 0; i < events.size(); ++i) {
        EXPECT_EQ(restored[i].kind, events[i].kind);
        EXPECT_EQ(restored[i].time, events[i].time);
        EXPECT_EQ(restored[i].area, events[i].area);
    }
    EXPECT_EQ(again->take_area().given_back, stage->take_area().given_back);
}

} // namespace
} // namespace dsc::restore_test
