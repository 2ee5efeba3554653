// SPDX-License-Identifier: MIT
// The inputs that are kept, one file each in the folder of their target: what searches began with,
// and what they found and has been mended. Each is run once, so that it stays mended.
#include "fuzz/target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace dsc::fuzz::corpus_test {
namespace {

std::vector<std::filesystem::path> inputs_of(const Target& target) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(DSC_CORPUS) / target.name)) {
        files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

class FuzzCorpus : public testing::TestWithParam<Target> {};

TEST_P(FuzzCorpus, HasNoFindings) {
    const Target& target = GetParam();
    const auto files = inputs_of(target);
    EXPECT_FALSE(files.empty());
    std::uint64_t operations = 0;
    for (const auto& path : files) {
        std::ifstream file(path, std::ios::binary);
        const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
        try {
            operations += target.run(bytes);
        } catch (const std::exception& error) {
            ADD_FAILURE() << path << ": " << error.what();
        }
    }
    EXPECT_GT(operations, 0U) << "none of them does anything";
}

INSTANTIATE_TEST_SUITE_P(Targets, FuzzCorpus, testing::ValuesIn(targets()),
                         [](const auto& one) { return one.param.name; });

} // namespace
} // namespace dsc::fuzz::corpus_test
