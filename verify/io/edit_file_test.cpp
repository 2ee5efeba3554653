// SPDX-License-Identifier: MIT
// Logs of edits as files: written and read back, and the errors for files that are not logs.
#include "replay/replay.h"

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace dsc::edit_file_test {
namespace {

// A path in the folder of temporary files; a file of an earlier run may be there.
std::string path_of(const std::string& name) {
    std::string path = testing::TempDir() + "dsc_" + name;
    std::filesystem::remove(path);
    return path;
}

std::string read(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

std::vector<Edit> some_edits() {
    std::vector<Edit> edits;
    for (int kind = 0; kind < edit_kind_count; ++kind) {
        const auto id = static_cast<std::uint32_t>(kind);
        edits.push_back({.kind = static_cast<EditKind>(kind),
                         .reason = MoveReason::smoothing,
                         .on_interface = kind % 2 == 0,
                         .corner = 5 * id,
                         .vertex = Vertex{id},
                         .ends = {Vertex{id + 1}, Vertex{}},
                         .apexes = {Vertex{}, Vertex{id + 2}},
                         .made = {7, 4294967294U},
                         .x = 0.1 / 3,
                         .y = -1e-300 * kind});
    }
    return edits;
}

TEST(EditFile, IsReadBackAsItWasWritten) {
    const std::string path = path_of("there_and_back.edits");
    const std::vector<Edit> written = some_edits();
    EditFile file(path);
    file.write(std::span<const Edit>(written).first(4));
    EXPECT_TRUE(read(path).empty()) << "there before it is whole";
    file.write(std::span<const Edit>(written).subspan(4));
    file.commit();
    const std::vector<Edit> back = read_edits(path);
    ASSERT_EQ(back.size(), written.size());
    for (std::size_t i = 0; i < back.size(); ++i) {
        const Edit& a = back[i];
        const Edit& b = written[i];
        EXPECT_EQ(a.kind, b.kind);
        EXPECT_EQ(a.reason, b.reason);
        EXPECT_EQ(a.on_interface, b.on_interface);
        EXPECT_EQ(a.corner, b.corner);
        EXPECT_EQ(a.vertex, b.vertex);
        EXPECT_EQ(a.ends, b.ends);
        EXPECT_EQ(a.apexes, b.apexes);
        EXPECT_EQ(a.made, b.made);
        EXPECT_EQ(a.x, b.x);
        EXPECT_EQ(a.y, b.y);
    }
    write_edits(path, {});
    EXPECT_TRUE(read_edits(path).empty());
}

std::string problem_of(const std::string& path) {
    try {
        (void)read_edits(path);
    } catch (const FileError& error) {
        return error.what();
    }
    return "read without a word";
}

TEST(EditFile, SaysWhatIsWrong) {
    const std::string path = path_of("wrong.edits");
    EXPECT_NE(problem_of(path_of("is_not_there.edits")).find("cannot be opened"),
              std::string::npos);
    write(path, "solid dsc\n");
    EXPECT_NE(problem_of(path).find("not a log of edits"), std::string::npos);
    write_edits(path, some_edits());
    const std::string whole = read(path);
    // Logs truncated at any place, at the end of a line or within one, are refused; only the last
    // line break may be missing.
    for (std::size_t length = 0; length + 1 < whole.size(); length += 7) {
        write(path, whole.substr(0, length));
        EXPECT_NE(problem_of(path), "read without a word") << length << " bytes";
    }
    const auto with = [&](const std::string& line) {
        write(path, "dsc edits 1\n" + line + "\nend 1\n");
        return problem_of(path);
    };
    const std::string good = "flip 0 0 4 1 2 3 4 5 6 7 0.5 -1e-3";
    EXPECT_EQ(with(good), "read without a word");
    for (const std::string& bad :
         {std::string("flop") + good.substr(4), good + " 8", good.substr(0, good.size() - 6),
          std::string("flip 9") + good.substr(6), std::string("flip 0 2") + good.substr(8),
          good.substr(0, good.size() - 5) + "nan", std::string()}) {
        EXPECT_NE(with(bad).find("line 2 is not a record"), std::string::npos) << bad;
    }
    write(path, "dsc edits 1\n" + good + "\nend 2\n");
    EXPECT_NE(problem_of(path).find("after 1 records"), std::string::npos);
}

TEST(EditFile, IsNotThereUntilItIsCommitted) {
    const std::string path = path_of("never.edits");
    {
        EditFile file(path);
        file.write(some_edits());
    }
    EXPECT_FALSE(std::ifstream(path).good());
    EXPECT_THROW(EditFile("/no/such/folder/run.edits"), FileError);
}

} // namespace
} // namespace dsc::edit_file_test
