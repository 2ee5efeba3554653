// SPDX-License-Identifier: MIT
// Atomic file writes: several writers of one path, links, streams, and refusals.
// `AFullDiskLeavesTheOldFile` in io_test.cpp tests errors during writing.
#include "dsc/io/part_file.h"

#include "dsc/base/error.h"
#include "replay/sealed_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

std::vector<std::string>* synced = nullptr; // receives the paths passed to fsync, if not null

} // namespace

// Replaces fsync of the C library, to record its calls.
extern "C" int fsync(int descriptor) {
    if (synced != nullptr) {
        synced->push_back(
            std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor)));
    }
    return static_cast<int>(syscall(SYS_fsync, descriptor));
}

namespace dsc::io_test {
namespace {

namespace fs = std::filesystem;

class PartFiles : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder / "sub"); }
    void TearDown() override { fs::remove_all(folder); }

    [[nodiscard]] std::string path(const std::string& name) const { return folder / name; }
    [[nodiscard]] std::string read(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    static void write(const std::string& path, const std::string& text) {
        PartFile file(path);
        file << text;
        file.commit();
    }
    // The files of all folders, as paths relative to `folder`.
    [[nodiscard]] std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (!entry.is_directory()) {
                names.push_back(fs::relative(entry.path().parent_path(), folder) /
                                entry.path().filename());
            }
        }
        std::ranges::sort(names);
        return names;
    }
    using Names = std::vector<std::string>;

    fs::path folder =
        fs::canonical(fs::temp_directory_path()) / ("dsc_part_file_" + std::to_string(getpid()));
};

TEST_F(PartFiles, OfTwoWritersOfOnePathTheLastToCommitWins) {
    PartFile a(path("one"));
    PartFile b(path("one"));
    a << "AAAAAAAA";
    b << "BB";
    b.commit();
    EXPECT_EQ(read("one"), "BB");
    a.commit();
    EXPECT_EQ(read("one"), "AAAAAAAA");
    EXPECT_EQ(files(), Names{"./one"});
}

TEST_F(PartFiles, ManyWritersAtOnce) {
    std::vector<std::jthread> writers;
    for (int i = 0; i < 8; ++i) {
        writers.emplace_back([&, i] {
            for (int k = 0; k < 50; ++k) {
                write(path("one"), std::string(100, static_cast<char>('a' + i)));
            }
        });
    }
    writers.clear();
    const std::string text = read("one");
    EXPECT_EQ(text, std::string(100, text.front()));
    EXPECT_EQ(files(), Names{"./one"});
}

TEST_F(PartFiles, AForeignPartFileIsLeftAlone) {
    std::ofstream(path("one.part")) << "of somebody else";
    write(path("one"), "text");
    EXPECT_EQ(read("one.part"), "of somebody else");
}

TEST_F(PartFiles, NamesOfAnyLengthThatTheFileSystemAllows) {
    const std::string longest(255, 'n');
    write(path(longest), "text");
    EXPECT_EQ(read(longest), "text");
    EXPECT_EQ(files().size(), 1U);
    EXPECT_THROW(PartFile(path(longest + 'n')), FileError);
}

TEST_F(PartFiles, LinksStayAndTheirTargetIsReplaced) {
    std::ofstream(path("sub/target")) << "old";
    fs::create_symlink("sub/target", path("link"));
    fs::create_symlink("../link", path("sub/link-to-link"));
    fs::create_symlink("sub/new", path("dangling"));
    write(path("link"), "1");
    EXPECT_EQ(read("sub/target"), "1");
    write(path("sub/link-to-link"), "2");
    EXPECT_EQ(read("sub/target"), "2");
    write(path("dangling"), "3");
    EXPECT_EQ(read("sub/new"), "3");
    for (const char* link : {"link", "sub/link-to-link", "dangling"}) {
        EXPECT_TRUE(fs::is_symlink(path(link))) << link;
    }
    EXPECT_EQ(files().size(), 5U);
    fs::create_symlink("circle", path("circle"));
    EXPECT_THROW(PartFile(path("circle")), FileError);
    EXPECT_TRUE(fs::is_symlink(path("circle")));
}

TEST_F(PartFiles, TheFolderIsSyncedInWhichTheFileIs) {
    fs::create_symlink("sub/target", path("link"));
    std::vector<std::string> paths;
    synced = &paths;
    write_sealed(path("link"), {"test"}, "bytes");
    synced = nullptr;
    ASSERT_EQ(paths.size(), 2U);
    EXPECT_EQ(fs::path(paths[0]).parent_path(), path("sub"));
    EXPECT_EQ(paths[1], path("sub"));
}

TEST_F(PartFiles, APipeIsWrittenTo) {
    const std::string pipe = path("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    // Opened for reading and writing, so that this test does not block if the writer wrongly
    // replaces the pipe.
    const int reader = open(pipe.c_str(), O_RDWR);
    write(pipe, "text");
    EXPECT_TRUE(fs::is_fifo(pipe));
    fs::create_symlink("pipe", path("link"));
    write(path("link"), "more");
    if (fs::is_fifo(pipe)) {
        std::string got(8, ' ');
        EXPECT_EQ(::read(reader, got.data(), 8), 8);
        EXPECT_EQ(got, "textmore");
    }
    close(reader);
    EXPECT_EQ(files().size(), 2U);
}

TEST_F(PartFiles, AnOpenDescriptorIsWrittenToWhereItStands) {
    const int descriptor = open(path("one").c_str(), O_WRONLY | O_CREAT, 0600);
    const std::string name = "/proc/self/fd/" + std::to_string(descriptor);
    fs::create_symlink(name, path("link"));
    EXPECT_EQ(::write(descriptor, "1", 1), 1);
    write(name, "2");
    write(path("link"), "3");
    EXPECT_EQ(::write(descriptor, "4", 1), 1);
    close(descriptor);
    EXPECT_EQ(read("one"), "1234");
    const int full = open("/dev/full", O_WRONLY);
    EXPECT_THROW(write("/proc/self/fd/" + std::to_string(full), "text"), FileError);
    close(full);
}

TEST_F(PartFiles, WhatIsNoFileIsRefusedAtOnce) {
    for (const std::string& name :
         {path("sub"), path("sub/"), path("sub/."), path("none/file"), path("new/"), std::string(),
          path(std::string("a\0b", 3)), std::string("/proc/self/fd/x")}) {
        EXPECT_THROW(PartFile{name}, FileError) << name;
    }
    EXPECT_EQ(files(), Names{});
    if (geteuid() != 0) { // whom permissions stop
        std::ofstream(path("kept")) << "old";
        fs::permissions(path("kept"), fs::perms::owner_read);
        EXPECT_THROW(PartFile(path("kept")), FileError);
    }
}

} // namespace
} // namespace dsc::io_test
