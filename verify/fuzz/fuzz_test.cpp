// SPDX-License-Identifier: MIT
// Runs the fuzz targets in any build: over the corpus (initial inputs, and findings that have been
// fixed), and over inputs drawn from fixed seeds.
#include "fuzz/target.h"
#include "support/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace dsc::fuzz::fuzz_test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> inputs_of(const Target& target) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(fs::path(DSC_CORPUS) / target.name)) {
        paths.push_back(entry.path());
    }
    if (target.name == "scene_file") {
        for (const auto& entry : fs::directory_iterator(DSC_EXAMPLES)) {
            if (entry.path().extension() == ".toml") {
                paths.push_back(entry.path());
            }
        }
    }
    std::ranges::sort(paths);
    std::vector<std::string> inputs;
    for (const fs::path& path : paths) {
        std::ifstream file(path, std::ios::binary);
        inputs.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return inputs;
}

class Draw {
public:
    explicit Draw(std::uint64_t seed) : random_(seed) {}

    std::string bytes(std::size_t count) {
        std::string all(count, '\0');
        std::ranges::generate(all, [&] { return static_cast<char>(below(256)); });
        return all;
    }

    /// Changes, duplicates, swaps or drops bytes, numbers and lines of an input.
    std::string mutated(std::string text) {
        const std::size_t count = 1 + below(3);
        for (std::size_t i = 0; i < count && !text.empty(); ++i) {
            switch (below(8)) {
            case 0: text[below(text.size())] = static_cast<char>(below(256)); break;
            case 1: text.erase(below(text.size()), 1 + below(8)); break;
            case 2: text.insert(below(text.size()), token()); break;
            case 3: move_line(text); break;
            default: change_number(text);
            }
        }
        return text;
    }

private:
    std::size_t below(std::size_t end) { return random_() % end; }

    std::string_view token() {
        static constexpr std::array<std::string_view, 29> tokens{
            "[",     "]",         "{",    "}",     "\"", "=",       ",",      "\n",    "-",    ".",
            "e",     "nan",       "inf",  "1e308", "0",  "-1",      "999999", "1e-12", "true", "[[",
            "shape", "[curve]\n", "sin(", "^",     "x",  "\\u0000", "'",      "#",     "1e-5"};
        return tokens[below(tokens.size())];
    }

    // Replaces a digit, or the whole number.
    void change_number(std::string& text) {
        static constexpr std::string_view digits = "0123456789.";
        const std::size_t begin = text.find_first_of(digits, below(text.size()));
        if (begin == std::string::npos) {
            return;
        }
        if (below(5) > 0) {
            text[begin] = static_cast<char>('0' + below(10));
        } else {
            const std::size_t end = std::min(text.find_first_not_of(digits, begin), text.size());
            text.replace(begin, end - begin, token());
        }
    }

    // Copies a line to another place, or drops it.
    void move_line(std::string& text) {
        const std::size_t at = text.rfind('\n', below(text.size()));
        const std::size_t begin = at == std::string::npos ? 0 : at;
        const std::size_t end = std::min(text.find('\n', begin + 1), text.size());
        const std::string line = text.substr(begin, end - begin);
        if (below(2) == 0) {
            text.erase(begin, end - begin);
        } else {
            text.insert(std::min(text.find('\n', below(text.size())), text.size()), line);
        }
    }

    std::mt19937_64 random_;
};

std::uint64_t run(const Target& target, std::string_view input) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(input.data());
    return target.run({bytes, input.size()});
}

class Fuzz : public testing::TestWithParam<Target> {};

TEST_P(Fuzz, HasNoFindingsInTheCorpus) {
    const auto inputs = inputs_of(GetParam());
    EXPECT_FALSE(inputs.empty());
    std::uint64_t operations = 0;
    for (const std::string& input : inputs) {
        SCOPED_TRACE(input.substr(0, 200));
        EXPECT_NO_THROW(operations += run(GetParam(), input));
    }
    EXPECT_GT(operations, 0U) << "none of them does anything";
}

// Meshes and flows can be drawn from arbitrary bytes. Texts and files are valid ones with small
// changes, because arbitrary bytes are refused at once.
TEST_P(Fuzz, HasNoFindingsAtRandom) {
    const Target& target = GetParam();
    const bool is_drawn = target.name == "operations" || target.name == "steps";
    const auto inputs = inputs_of(target);
    const bool are_long = test::are_asked_for("long");
    const std::uint64_t first = are_long ? 1000 : 1;
    const std::uint64_t seeds = are_long ? 2000 : test::are_asked_for("few") ? 40 : 300;
    const std::uint64_t count = is_drawn ? seeds : 5 * seeds; // most are refused, in no time
    std::uint64_t operations = 0;
    for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Draw draw(seed);
        const std::string input =
            is_drawn ? draw.bytes(1000) : draw.mutated(inputs[seed % inputs.size()]);
        EXPECT_NO_THROW(operations += run(target, input));
    }
    // With fewer operations hardly anything would be tested.
    EXPECT_GT(operations, is_drawn ? 100 * count : count / 10);
}

INSTANTIATE_TEST_SUITE_P(Targets, Fuzz, testing::ValuesIn(targets()),
                         [](const auto& one) { return one.param.name; });

} // namespace
} // namespace dsc::fuzz::fuzz_test
