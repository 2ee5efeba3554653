// SPDX-License-Identifier: MIT
// State as bytes: everything reads back unchanged, and impossible values are refused.
#include "dsc/base/archive.h"
#include "scenes/run/standard_archive.h"

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <limits>

namespace dsc::archive_test {
namespace {

enum class Colour : std::uint8_t { red, green, blue };

struct Ball {
    Point<float> place{0, 0};
    Vertex vertex{};
    Colour colour = Colour::red;
    std::optional<double> weight{};
    std::vector<Ball> inside{};
};

void archive(Archive& archive, Ball& ball) {
    archive(ball.place, ball.vertex);
    archive.choice(ball.colour, 3);
    archive(ball.weight, ball.inside);
}

struct Everything {
    bool flag = false;
    std::int8_t small = 0;
    double number = 0;
    std::string text{};
    std::array<std::uint16_t, 3> triple{};
    std::map<std::string, std::uint64_t> counts{};
    std::variant<double, std::string> either{};
    std::vector<float> list{};
    Ball ball{};
};

void archive(Archive& archive, Everything& all) {
    archive(all.flag, all.small, all.number, all.text, all.triple, all.counts, all.either, all.list,
            all.ball);
}

Everything example() {
    return {.flag = true,
            .small = -5,
            .number = -std::numeric_limits<double>::denorm_min(),
            .text = std::string("a\0b", 3),
            .triple = {1, 2, 65535},
            .counts = {{"flips", 7}, {"splits", UINT64_MAX}},
            .either = "word",
            .list = {0.1F, -0.0F},
            .ball = {.place = {1, 2},
                     .vertex = Vertex{3},
                     .colour = Colour::blue,
                     .weight = 0.3,
                     .inside = {Ball{}, Ball{.vertex = Vertex{9}}}}};
}

std::string bytes_of(Everything value) {
    Archive archive;
    archive(value);
    return archive.bytes();
}

TEST(Archives, ReadBackWhatWasWritten) {
    const std::string bytes = bytes_of(example());
    Archive archive(bytes, "here");
    Everything read;
    archive(read);
    archive.expect_end();
    EXPECT_EQ(bytes_of(read), bytes);
    EXPECT_NE(bytes_of({}), bytes);
}

TEST(Archives, RefuseWhatIsCutOff) {
    const std::string bytes = bytes_of(example());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        Archive archive(bytes.substr(0, size), "here");
        Everything read;
        EXPECT_THROW(archive(read), FileError) << size;
    }
    Archive longer(bytes + 'x', "here");
    Everything read;
    longer(read);
    EXPECT_THROW(longer.expect_end(), FileError);
}

template <class Value>
std::string refusal_of(Value written, auto read_as) {
    Archive out;
    out(written);
    Archive in(out.bytes(), "here");
    try {
        in(read_as);
    } catch (const FileError& error) {
        return error.what();
    }
    return "nothing was refused";
}

TEST(Archives, RefuseWhatCannotBe) {
    EXPECT_EQ(refusal_of(std::uint32_t{2}, bool{}), "here: number outside its enum");
    EXPECT_EQ(refusal_of(std::uint64_t{1} << 60U, std::vector<double>{}),
              "here: unexpected end of data");
    EXPECT_EQ(refusal_of(std::uint64_t{1} << 60U, std::string{}), "here: unexpected end of data");
    EXPECT_EQ(refusal_of(std::uint32_t{2}, std::variant<double, std::string>{}),
              "here: number outside its enum");
    // Nested archives.
    Ball ball;
    for (int depth = 0; depth < 100; ++depth) {
        ball = Ball{.inside = {ball}};
    }
    Archive archive;
    EXPECT_THROW(archive(ball), FileError);
}

TEST(Archives, WhatIsNotThereReplacesWhatIs) {
    Archive out;
    std::optional<double> nothing;
    std::vector<double> none;
    out(nothing, none);
    Archive in(out.bytes(), "here");
    std::optional<double> weight = 3;
    std::vector<double> list{1, 2};
    in(weight, list);
    EXPECT_FALSE(weight.has_value());
    EXPECT_TRUE(list.empty());
}

} // namespace
} // namespace dsc::archive_test
