// SPDX-License-Identifier: MIT
// Files that a scene file names: outlines and label images, found beside it or refused.
#include "scenes/file/scene_file.h"

#include "dsc/base/error.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace dsc::scenes::files_beside_test {
namespace {

const std::string options = "[options]\nh = 0.1\ndt = 0.01\nsteps = 2\n";
const std::string disc = "[[shape]]\ncircle = { centre = [0.5, 0.5], radius = 0.2 }\n";

class FilesBeside : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("scene_files_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_ / "data");
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }

    std::filesystem::path folder_;
};

TEST_F(FilesBeside, AreFoundFromTheSceneFile) {
    write("mine.toml", options + "[[shape]]\nfile = 'data/outline.txt'\n[[shape]]\n"
                                 "file = 'data/map'\nphase = 3\nhole_phase = 2\n");
    write("data/outline.txt", "0.1 0.1\n0.3 0.1\n0.3 0.3\n");
    write("data/map", "0.5 0.1\n0.9 0.1\n0.9 0.9\n\n0.7 0.3\n0.8 0.3\n0.8 0.5\n");
    const Scene scene = read_scene_file(folder_ / "mine.toml").scene;
    EXPECT_EQ(scene.name, "mine");
    const scenes::Setup setup = scene.prepare(scene.defaults);
    ASSERT_EQ(setup.outlines.size(), 3U);
    EXPECT_EQ(setup.phases, (std::vector<Phase>{1, 3, 2}));
}

TEST_F(FilesBeside, AreRefusedWhereTheyCannotBeRead) {
    EXPECT_THROW((void)read_scene_file(folder_ / "none.toml"), FileError);
    EXPECT_THROW((void)read_scene_file(folder_), FileError);
    try {
        (void)read_scene_file("/dev/zero");
        ADD_FAILURE() << "accepted";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("not a regular file"), std::string::npos);
    }
    write("a.toml", options + "[[shape]]\nfile = 'none.txt'\n");
    EXPECT_THROW((void)read_scene_file(folder_ / "a.toml"), FileError);
    write("b.toml", options + "[[shape]]\nfile = 'bad.txt'\n");
    write("bad.txt", "0 0\n1 0\nx\n");
    try {
        (void)read_scene_file(folder_ / "b.toml");
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        EXPECT_NE(error.where().find("bad.txt:3"), std::string::npos) << error.what();
    }
    std::filesystem::create_directory(folder_ / "folder.txt");
    write("c.toml", options + "[[shape]]\nfile = 'folder.txt'\n");
    EXPECT_THROW((void)read_scene_file(folder_ / "c.toml"), FileError);
}

// The same image as a text, as .pgm and as .npy: one row of 1 above two of 2 and 3.
TEST_F(FilesBeside, LabelImagesOfEveryKind) {
    const auto npy = [](const std::string& descr, const std::string& fortran,
                        const std::string& data) {
        const std::string header =
            "{'descr': '" + descr + "', 'fortran_order': " + fortran + ", 'shape': (3, 2), }\n";
        return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + '\0' +
               header + data;
    };
    using namespace std::string_literals;
    const std::string by_rows{1, 1, 2, 3, 2, 3};
    write("text", "# a comment\n1 1\n\n2, 3\n2 3 # another\n");
    write("plain.pgm", "P2\n# by hand\n2 3\n9\n1 1 2 3 2 3\n");
    write("raw.pgm", "P5 2 3 255\n" + by_rows);
    write("wide.pgm", "P5 2 3 256\n"s + "\0\1\0\1\0\2\0\3\0\2\0\3"s);
    write("bytes.npy", npy("|u1", "False", by_rows));
    write("columns.npy", npy("|i1", "True", {1, 2, 2, 1, 3, 3}));
    write("little.npy", npy("<i2", "False", "\1\0\1\0\2\0\3\0\2\0\3\0"s));
    for (const char* name :
         {"text", "plain.pgm", "raw.pgm", "wide.pgm", "bytes.npy", "columns.npy", "little.npy"}) {
        write("a.toml", options + "[domain]\nhigh = [2, 3]\n[shape]\nlabels = '" + name + "'\n");
        const SceneFile file = read_scene_file(folder_ / "a.toml");
        EXPECT_EQ(file.outlines, std::vector{(folder_ / name).string()});
        const RunResult result = run_scene(file.scene, file.scene.defaults, {});
        EXPECT_TRUE(result.holds());
        ASSERT_EQ(result.phases.phases.size(), 3U) << name;
        for (const PhaseFigures& phase : result.phases.phases) {
            EXPECT_NEAR(phase.area, 2, 1e-5) << name;
        }
    }
    // The grain of phase 3 has only two pixels, so it is dropped.
    write("b.toml", options + "[domain]\nhigh = [2, 3]\n[shape]\nlabels = 'text'\n"
                              "min_pixels = 3\n");
    const SceneFile file = read_scene_file(folder_ / "b.toml");
    EXPECT_GE(run_scene(file.scene, file.scene.defaults, {}).input.dropped, 1U);
    const std::vector<std::pair<std::string, std::string>> bad{
        {"1 1\n2\n", "rows have different lengths"},
        {"1 -1\n", "not a phase"},
        {"1 1.5\n", "not a phase"},
        {"", "the image has no pixels"},
        {"P2 2 3 9 1 1 2 3 2", "does not match the size"},
        {"P5 2 3 255\n123", "does not match the size"},
        {"P5 2", "not a phase"},
        {npy("<f8", "False", by_rows), "not an array of whole numbers"},
        {npy("|u1", "False", "123"), "does not match the size"},
        {npy("|i1", "False", {1, 1, 2, -3, 2, 3}), "not a phase"},
        {"\x93NUMPY", "not an array of whole numbers"}};
    for (const auto& [content, what] : bad) {
        write("text", content);
        try {
            (void)read_scene_file(folder_ / "b.toml");
            ADD_FAILURE() << "accepted: " << content;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW((void)read_scene_text(options + disc + "[[shape]]\nlabels = 'text'\n", "s.toml"),
                 InputError);
}

} // namespace
} // namespace dsc::scenes::files_beside_test
