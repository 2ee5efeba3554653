// SPDX-License-Identifier: MIT
// Fields on grids: read from CSV and NumPy's files, exact where they should be, and continuous.
#include "scenes/file/grid/grid_files.h"

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace dsc::scenes::grid_test {
namespace {

Point<double> linear_field(double x, double y, double t) {
    return {1 + 2 * x - 3 * y + t, (1 - t) * x * y};
}

GridValues grid_of(std::size_t columns, std::size_t rows, const std::vector<double>& times) {
    GridValues grid;
    grid.box = {{-1, 0}, {1, 3}};
    grid.columns = columns;
    grid.rows = rows;
    grid.times = times;
    for (const double t : times) {
        for (std::size_t j = 0; j < rows; ++j) {
            for (std::size_t i = 0; i < columns; ++i) {
                grid.velocities.push_back(linear_field(
                    -1 + 2.0 * static_cast<double>(i) / static_cast<double>(columns - 1),
                    3.0 * static_cast<double>(j) / static_cast<double>(rows - 1), t));
            }
        }
    }
    return grid;
}

Point<double> at(const GridField& field, const Point<double>& p, double time) {
    Point<double> result;
    field({&p, 1}, time, {&result, 1});
    return result;
}

TEST(GridField, HasTheLinearFieldItIsMadeOf) {
    for (const auto interpolation : {GridInterpolation::linear, GridInterpolation::cubic}) {
        const GridField field(grid_of(9, 13, {0, 1, 4}), interpolation, "there");
        for (const Point<double>& p :
             {Point<double>(-0.7, 0.3), {0.1, 1.9}, {0.6, 2.7}, {0, 1.5}, {-0.74, 2.74}}) {
            for (const double t : {0.0, 0.25, 1.0, 3.0, 4.0}) {
                const Point<double> right = linear_field(p.x(), p.y(), t);
                EXPECT_NEAR((at(field, p, t) - right).norm(), 0, 1e-13);
            }
        }
    }
}

TEST(GridField, TakesTheNearestValueBeyondTheGrid) {
    const GridField field(grid_of(3, 3, {1, 2}), GridInterpolation::linear, "there");
    EXPECT_NEAR((at(field, {-9, 5}, 0) - linear_field(-1, 3, 1)).norm(), 0, 1e-13);
    EXPECT_NEAR((at(field, {9, -5}, 7) - linear_field(1, 0, 2)).norm(), 0, 1e-13);
    EXPECT_TRUE(std::isnan(at(field, {NAN, 1}, 1).x()));
    EXPECT_NO_THROW((void)at(field, {1e300, -1e300}, NAN));
}

// Halving the steps divides the error by 4 and by 8 or more.
TEST(GridField, ConvergesByItsOrder) {
    const auto error = [](std::size_t n, GridInterpolation interpolation) {
        GridValues grid;
        grid.columns = n + 1;
        grid.rows = n + 1;
        for (std::size_t j = 0; j <= n; ++j) {
            for (std::size_t i = 0; i <= n; ++i) {
                const double x = static_cast<double>(i) / static_cast<double>(n);
                const double y = static_cast<double>(j) / static_cast<double>(n);
                grid.velocities.emplace_back(std::sin(3 * x + y), std::cos(2 * y));
            }
        }
        const GridField field(grid, interpolation, "there");
        double worst = 0;
        for (double x = 0.3; x < 0.7; x += 0.013) {
            const Point<double> right(std::sin(3 * x + 0.4), std::cos(0.8));
            worst = std::max(worst, (at(field, {x, 0.4}, 0) - right).norm());
        }
        return worst;
    };
    for (const auto& [interpolation, factor] :
         {std::pair(GridInterpolation::linear, 3.5), {GridInterpolation::cubic, 7.0}}) {
        EXPECT_GT(error(16, interpolation) / error(32, interpolation), factor);
    }
}

TEST(GridField, RefusesPartsThatDoNotFit) {
    const auto make = [](GridValues grid) {
        (void)GridField(std::move(grid), GridInterpolation::linear, "there");
    };
    EXPECT_NO_THROW(make(grid_of(2, 2, {0})));
    EXPECT_THROW(make(grid_of(2, 2, {1, 0})), InputError);
    EXPECT_THROW(make(grid_of(2, 2, {1, 1})), InputError);
    EXPECT_THROW(make({}), InputError);
    GridValues short_of_one = grid_of(2, 2, {0});
    short_of_one.velocities.pop_back();
    EXPECT_THROW(make(short_of_one), InputError);
    GridValues flat = grid_of(2, 2, {0});
    flat.box.high.y() = 0;
    EXPECT_THROW(make(flat), InputError);
}

TEST(GridCsv, IsReadInAnyOrder) {
    const GridValues grid = read_grid_csv("t,x,y,u,v\n# two times\n1, 1, 0, 12, 2\n0,0,0,1,0\n"
                                          "0,1,0,2,0\r\n0,0,5,3,0\n0,1,5,4,-1e-3 # last\n\n"
                                          "1,0,0,11,0\n1,0,5,13,0\n1,1,5,14,0",
                                          "file");
    EXPECT_EQ(grid.times, (std::vector<double>{0, 1}));
    EXPECT_EQ(grid.columns, 2U);
    EXPECT_EQ(grid.rows, 2U);
    EXPECT_EQ(grid.box.high, Point<double>(1, 5));
    ASSERT_EQ(grid.velocities.size(), 8U);
    EXPECT_EQ(grid.velocities[3], Point<double>(4, -1e-3));
    EXPECT_EQ(grid.velocities[5], Point<double>(12, 2));
    EXPECT_EQ(read_grid_csv("0 0 1 1\n1 0 2 2\n0 1 3 3\n1 1 4 4", "file").velocities[2],
              Point<double>(3, 3));
}

TEST(GridCsv, ErrorsNameTheLineOrWhatIsMissing) {
    const std::string square = "0,0,1,1\n1,0,2,2\n0,1,3,3\n";
    for (const auto& [text, where] : {
             std::pair<std::string, std::string>{"", "file"},
             {square, "file"},
             {square + "1,1,x,4", "file:4"},
             {square + "1,1,4", "file:4"},
             {square + "1,1,4,4,4", "file:4"},
             {square + "1,1,nan,4", "file:4"},
             {square + "0,1,3,3", "file"},
             {square + "1,1,4,4\n1,1,4,4", "file"},
             {square + "1,1,4,4\n5,0,1,1\n5,1,1,1", "file"},
         }) {
        try {
            (void)read_grid_csv(text, "file");
            ADD_FAILURE() << "accepted: " << text;
        } catch (const InputError& error) {
            EXPECT_EQ(error.where(), where) << error.what();
        }
    }
}

template <class Number>
std::string npy(const std::string& type, const std::string& shape, std::size_t numbers) {
    const std::string header =
        "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }\n";
    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += static_cast<char>(header.size() % 256);
    bytes += static_cast<char>(header.size() / 256);
    bytes += header;
    for (std::size_t i = 0; i < numbers; ++i) {
        const auto number = static_cast<Number>(i);
        char raw[sizeof number];
        std::memcpy(raw, &number, sizeof number);
        bytes.append(raw, sizeof number);
    }
    return bytes;
}

TEST(GridNpy, IsReadInBothPrecisions) {
    const GridValues steady = read_npy(npy<double>("<f8", "(2, 3, 2)", 12), {}, "file");
    EXPECT_EQ(steady.rows, 2U);
    EXPECT_EQ(steady.columns, 3U);
    EXPECT_EQ(steady.velocities.at(5), Point<double>(10, 11));
    const GridValues moving = read_npy(npy<float>("<f4", "(2, 2, 2, 2)", 16), {0, 3}, "file");
    EXPECT_EQ(moving.times, (std::vector<double>{0, 3}));
    EXPECT_EQ(moving.velocities.at(7), Point<double>(14, 15));
}

TEST(GridNpy, RefusesWhatItIsNot) {
    const std::string good = npy<double>("<f8", "(2, 3, 2)", 12);
    std::vector<std::string> bad{"",
                                 "abc",
                                 good.substr(0, 11),
                                 good.substr(0, 30),
                                 good.substr(0, good.size() - 1),
                                 good + "x",
                                 npy<double>(">f8", "(2, 3, 2)", 12),
                                 npy<double>("<i8", "(2, 3, 2)", 12),
                                 npy<double>("<f8", "(2, 3, 3)", 18),
                                 npy<double>("<f8", "(12,)", 12),
                                 npy<double>("<f8", "(0, 3, 2)", 0),
                                 npy<double>("<f8", "()", 1),
                                 npy<double>("<f8", "(4294967296, 4294967296, 2)", 0),
                                 npy<double>("<f8", "(99999999999999999999, 3, 2)", 12),
                                 npy<double>("<f8", "(2, 2, 2, 2)", 16)};
    std::string fortran = good;
    fortran.replace(fortran.find("False"), 5, "True ");
    bad.push_back(fortran);
    for (std::size_t i = 0; i < bad.size(); ++i) {
        EXPECT_THROW((void)read_npy(bad[i], {}, "file"), InputError) << i;
    }
    EXPECT_THROW((void)read_npy(good, {0, 1}, "file"), InputError);
}

} // namespace
} // namespace dsc::scenes::grid_test
