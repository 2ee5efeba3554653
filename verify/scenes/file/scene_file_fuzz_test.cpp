// SPDX-License-Identifier: MIT
// Whatever is in a scene file, reading it ends with a scene or an error that says what is wrong,
// and so does making the first complex of it, if that is small. The files are those of the examples
// with bytes, numbers and lines changed, doubled, swapped or lost.
//
// The seeds are fixed; DSC_FUZZ_FILES=N tries N files, and DSC_FUZZ_FIRST says where to begin.
#include "scenes/file/scene_file.h"

#include "dsc/base/error.h"
#include "dsc/queries/validate.h"
#include "scenes/file/formula/formula_flow.h"
#include "scenes/file/grid/grid_files.h"
#include "scenes/file/outlines/pieces.h"
#include "scenes/file/text_file.h"
#include "scenes/run/start.h"
#include "support/environment.h"
#include "support/small_setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <random>

namespace dsc::scenes::scene_file_fuzz_test {
namespace {

/// First complexes are made of scenes up to this size.
constexpr double most_triangles_of_fuzz = 20'000;
constexpr std::size_t most_outline_points = 5'000;

std::vector<std::filesystem::path> example_files() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(DSC_EXAMPLES)) {
        if (entry.path().extension() == ".toml" || entry.path().extension() == ".geojson") {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

class Mutator {
public:
    explicit Mutator(std::uint64_t seed) : random_(seed) {}

    std::string mutated(std::string text) {
        const std::size_t count = 1 + below(3);
        for (std::size_t i = 0; i < count && !text.empty(); ++i) {
            switch (below(9)) {
            case 0: text[below(text.size())] = static_cast<char>(below(256)); break;
            case 1: text.erase(below(text.size()), 1 + below(8)); break;
            case 2: text.insert(below(text.size()), token()); break;
            case 3: replace_number(text); break;
            case 4:
            case 5:
            case 6:
            case 7: replace_digit(text); break;
            default: move_line(text);
            }
        }
        return text;
    }

private:
    std::size_t below(std::size_t end) {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
    }

    std::string token() {
        static const std::array<std::string, 31> tokens{
            "[",      "]",     "{",    "}",       "\"",    "=",         ",",   "\n",
            "-",      ".",     "e",    "nan",     "inf",   "1e308",     "0",   "-1",
            "999999", "1e-12", "true", "[[",      "shape", "[curve]\n", "Z",   "A 1 1 0 0 1 ",
            "sin(",   "^",     "x",    "\\u0000", "'",     "#",         "1e-5"};
        return tokens[below(tokens.size())];
    }

    void replace_digit(std::string& text) {
        const std::size_t at = text.find_first_of("0123456789", below(text.size()));
        if (at != std::string::npos) {
            text[at] = static_cast<char>('0' + below(10));
        }
    }

    void replace_number(std::string& text) {
        static constexpr std::string_view digits = "0123456789.";
        std::size_t begin = text.find_first_of(digits, below(text.size()));
        if (begin == std::string::npos) {
            return;
        }
        const std::size_t end = std::min(text.find_first_not_of(digits, begin), text.size());
        text.replace(begin, end - begin, token());
    }

    // A line is doubled somewhere else, or lost.
    void move_line(std::string& text) {
        const std::size_t begin = text.rfind('\n', below(text.size()));
        const std::size_t from = begin == std::string::npos ? 0 : begin;
        const std::size_t to = std::min(text.find('\n', from + 1), text.size());
        const std::string line = text.substr(from, to - from);
        if (below(2) == 0) {
            text.erase(from, to - from);
        } else {
            text.insert(std::min(text.find('\n', below(text.size())), text.size()), line);
        }
    }

    std::mt19937_64 random_;
};

/// How many files were scenes, and how many of these became a complex.
struct Outcome {
    int scenes = 0;
    int complexes = 0;
};

void read_and_prepare(const std::string& text, const std::filesystem::path& path,
                      Outcome& outcome) {
    const Scene scene = read_scene_text(text, path).scene;
    ++outcome.scenes;
    const scenes::Setup setup = scene.prepare(scene.defaults);
    if (!setup.flow.empty()) {
        std::vector<Point<double>> velocities(1);
        setup.flow[0].velocity(std::array{Point<double>(0.3, 0.4)}, 0.1, velocities);
    }
    if (test::is_small(setup, scene.defaults.h, most_triangles_of_fuzz, most_outline_points)) {
        const auto complex = first_complex<double>(setup, scene.defaults);
        ASSERT_EQ(validate(complex).problem, "");
        ++outcome.complexes;
    }
}

TEST(SceneFileFuzz, EndsWithASceneOrAnError) {
    const auto files = example_files();
    ASSERT_GE(files.size(), 4U);
    const std::uint64_t first = test::from_environment("DSC_FUZZ_FIRST", 1);
    const std::uint64_t count = test::from_environment("DSC_FUZZ_FILES", 300);
    Outcome outcome;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const auto& path = files[seed % files.size()];
        const std::string text = Mutator(seed).mutated(read_text_file(path));
        SCOPED_TRACE("DSC_FUZZ_FIRST=" + std::to_string(seed));
        try {
            if (path.extension() == ".geojson") {
                (void)read_geojson(text, path.string());
            } else {
                read_and_prepare(text, path, outcome);
            }
        } catch (const InputError& error) {
            EXPECT_FALSE(error.where().empty());
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "one line";
            EXPECT_FALSE(error.allowed().empty()) << error.what();
        } catch (const FileError& error) {
            EXPECT_FALSE(error.path().empty());
        } catch (const std::exception& error) {
            ADD_FAILURE() << "neither InputError nor FileError: " << error.what();
        }
    }
    // Otherwise the changes are so wild that hardly anything is tried.
    EXPECT_GT(outcome.scenes, static_cast<int>(count / 10));
    EXPECT_GT(outcome.complexes, static_cast<int>(count / 20));
}

// The files that a scene names, each in a few lines.
struct NamedText {
    std::string text;
    std::function<void(const std::string& text)> read;
};

std::string npy_of_four_points() {
    const std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2, 2)}";
    std::string bytes = "\x93NUMPY\x01";
    bytes += '\0';
    bytes += static_cast<char>(header.size());
    bytes += '\0';
    return bytes + header + std::string(8 * sizeof(double), '\x3f');
}

std::vector<NamedText> named_texts() {
    const auto points = [](const std::string& text) { (void)read_points(text, true, "file"); };
    const auto path = [](const std::string& text) { (void)read_svg_path(text, 1e-3, 0.1, "file"); };
    const auto grid = [](const std::string& text) { (void)read_grid_csv(text, "file"); };
    const auto array = [](const std::string& text) { (void)read_npy(text, {}, "file"); };
    const auto formula = [](const std::string& text) {
        const FormulaFlow flow({.u = text, .v = "x", .where_u = "file"});
        std::vector<Point<double>> velocities(3, {0.25, 4});
        flow(velocities, 0.5, velocities);
    };
    return {
        {"# points\n0 0\n1e0, 0.5\n\n 3 4\n5 6 # end\n3 4\n", points},
        {"M 10 20 l 5,5 h-3 V 7 C 1 2 3 4 5 6 s 1 1 2 2 q 1 1 2 0 T 9 9 a 3 2 30 0 1 4 4 z", path},
        {"t,x,y,u,v\n0,0,0,1,2\n0,1,0,1,2\n0,0,1,1,2\n0,1,1,1,2\n", grid},
        {npy_of_four_points(), array},
        {"2*sin(pi*x)^2*cos(-y/3) + (x < t ? min(x, y, 1e-3) : atan2(y, exp(x))) - sqrt(abs(x))",
         formula},
    };
}

TEST(NamedFileFuzz, EndsWithAResultOrAnError) {
    const std::vector<NamedText> texts = named_texts();
    const std::uint64_t first = test::from_environment("DSC_FUZZ_FIRST", 1);
    const std::uint64_t count = 10 * test::from_environment("DSC_FUZZ_FILES", 300);
    std::vector<int> read(texts.size(), 0);
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const std::size_t which = seed % texts.size();
        const std::string text = Mutator(seed).mutated(texts[which].text);
        SCOPED_TRACE("DSC_FUZZ_FIRST=" + std::to_string(seed));
        try {
            texts[which].read(text);
            ++read[which];
        } catch (const InputError& error) {
            EXPECT_TRUE(error.where().starts_with("file")) << error.what();
        } catch (const std::exception& error) {
            ADD_FAILURE() << "no InputError: " << error.what();
        }
    }
    for (std::size_t i = 0; i < texts.size(); ++i) {
        EXPECT_GT(read[i], 0) << texts[i].text;
    }
}

} // namespace
} // namespace dsc::scenes::scene_file_fuzz_test
