// SPDX-License-Identifier: MIT
// The search for contacts of lines, compared with a test of all pairs.
#include "dsc/geometry/contacts.h"
#include "dsc/geometry/predicates.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace dsc::contacts_test {
namespace {

struct Lines {
    std::vector<Point<double>> points;
    std::vector<NetworkLine> lines;
};

// Lines between points of a coarse lattice; some points coincide, and some lines share an end.
Lines random_lines(std::mt19937& random) {
    const auto below = [&](std::size_t end) { return static_cast<std::uint32_t>(random() % end); };
    Lines result;
    const std::size_t count = 2 + below(5);
    while (result.points.size() < 2 * count) {
        const std::uint32_t x = below(12);
        result.points.emplace_back(x, below(12));
    }
    while (result.lines.size() < count) {
        const std::uint32_t from = below(2 * count);
        const std::uint32_t to = below(2 * count);
        if (result.points[from] != result.points[to]) {
            result.lines.push_back({from, to});
        }
    }
    return result;
}

// Two lines are in contact if they have a common point other than a shared end (by number).
bool touch(const Lines& lines, const NetworkLine& s, const NetworkLine& t) {
    const auto& p = lines.points;
    const auto is_end = [](std::uint32_t v, const NetworkLine& e) {
        return v == e.from || v == e.to;
    };
    const auto lies_on = [&](std::uint32_t v, const NetworkLine& e) {
        return !is_end(v, e) && segments_meet<double>(p[v], p[v], p[e.from], p[e.to]);
    };
    if (is_end(s.from, t) == is_end(s.to, t)) { // the lines share no end, or both ends
        return segments_meet<double>(p[s.from], p[s.to], p[t.from], p[t.to]);
    }
    return lies_on(s.from, t) || lies_on(s.to, t) || lies_on(t.from, s) || lies_on(t.to, s);
}

TEST(Contacts, AgreeWithAllPairs) {
    std::mt19937 random(5);
    std::size_t with = 0;
    constexpr std::size_t cases = 20000;
    for (std::size_t i = 0; i < cases && !HasFailure(); ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        const Lines some = random_lines(random);
        bool expected = false;
        for (auto e = some.lines.begin(); e != some.lines.end(); ++e) {
            for (auto f = some.lines.begin(); f != e; ++f) {
                expected = expected || touch(some, *e, *f);
            }
        }
        const auto contact = find_contact(some.points, some.lines);
        EXPECT_EQ(contact.has_value(), expected);
        if (contact) {
            EXPECT_LT(contact->line, contact->other);
            EXPECT_TRUE(touch(some, some.lines[contact->line], some.lines[contact->other]));
        }
        with += expected ? 1 : 0;
    }
    EXPECT_GT(with, cases / 5);
    EXPECT_LT(with, cases - cases / 5);
}

TEST(Contacts, OfALongOutlineAreFoundInOneSweep) {
    Lines comb; // every edge overlaps all others in y
    const std::uint32_t teeth = 50000;
    for (std::uint32_t i = 0; i < teeth; ++i) {
        comb.points.emplace_back(2.0 * i, 0.0);
        comb.points.emplace_back(2.0 * i + 1, 1.0);
    }
    comb.points.emplace_back(2.0 * teeth, -1.0);
    comb.points.emplace_back(-1.0, -1.0);
    const auto count = static_cast<std::uint32_t>(comb.points.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        comb.lines.push_back({i, (i + 1) % count});
    }
    EXPECT_FALSE(find_contact(comb.points, comb.lines));
    comb.points[70001].y() = -2;
    EXPECT_TRUE(find_contact(comb.points, comb.lines));
}

} // namespace
} // namespace dsc::contacts_test
