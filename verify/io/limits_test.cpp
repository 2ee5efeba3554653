// SPDX-License-Identifier: MIT
// Files at the limits of what is allowed: nothing in an array, narrow views and lines, names that
// are taken, kinds of eight bytes.
#include "dsc/base/error.h"
#include "dsc/io/appended_data.h"
#include "dsc/io/pictures.h"
#include "replay/sealed_file.h"

#include "support/small_meshes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace dsc::limits_test {
namespace {

namespace fs = std::filesystem;

class FileLimits : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    [[nodiscard]] std::string path(const std::string& name) const { return folder / name; }
    [[nodiscard]] std::string picture(const SvgOptions& options) const {
        write_svg(test::grid<double>(4, 0, 1, 1.5), path("a.svg"), options);
        return text_of("a.svg");
    }
    [[nodiscard]] std::string text_of(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    }

    fs::path folder = fs::temp_directory_path() / ("dsc_file_limits_" + std::to_string(getpid()));
};

TEST_F(FileLimits, AnEmptyArrayIsAHeaderWithoutBlocks) {
    AppendedData data;
    EXPECT_EQ(data.add(std::vector<float>{}), 0U);
    EXPECT_EQ(data.text().size(), 32U); // three numbers of eight bytes in base64
}

TEST_F(FileLimits, AViewMayBeNarrowerThanTheUnit) {
    EXPECT_NO_THROW((void)picture({.view = Rectangle{{0, 0}, {0.5, 0.5}}}));
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW((void)picture({.view = Rectangle{{0, 0}, {bad, 0.5}}}), InputError);
        EXPECT_THROW((void)picture({.view = Rectangle{{0, 0}, {0.5, bad}}}), InputError);
    }
}

TEST_F(FileLimits, AnAttributeDoesNotTakeTheNameOfAnArrayThatIsThere) {
    auto complex = test::grid<double>(2);
    complex.attributes.add<Triangle>("phase", 7.0);
    complex.attributes.add<Triangle>("heat", 7.0);
    write_vtu(complex, path("a.vtu"));
    const std::string text = text_of("a.vtu");
    const auto count = [&](const std::string& words) {
        std::size_t found = 0;
        for (std::size_t at = text.find(words); at != std::string::npos;
             at = text.find(words, at + 1)) {
            ++found;
        }
        return found;
    };
    EXPECT_EQ(count("Name=\"phase\""), 1U);
    EXPECT_EQ(count("Name=\"heat\""), 1U);
}

TEST_F(FileLimits, ASealedFileReadsBackAndTellsWhatIsWrong) {
    const SealedKind kind{.name = "eight ch", .version = 3};
    write_sealed(path("a"), kind, "some bytes");
    EXPECT_EQ(read_sealed(path("a"), kind), "some bytes");
    EXPECT_THROW(write_sealed(path("b"), {.name = "nine char"}, ""), InputError);
    EXPECT_THROW(write_sealed(path("b"), {.name = ""}, ""), InputError);
    EXPECT_THROW((void)read_sealed(path("a"), {.name = "eight ch", .version = 2}), FileError);
    EXPECT_THROW((void)read_sealed(path("a"), {.name = "another", .version = 3}), FileError);
    EXPECT_THROW((void)read_sealed(path("none"), kind), FileError);
    const std::string whole = text_of("a");
    for (std::size_t at = 0; at < whole.size(); ++at) { // any byte: the reserved ones as well
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 1);
        std::ofstream(path("b"), std::ios::binary) << damaged;
        EXPECT_THROW((void)read_sealed(path("b"), kind), FileError) << at;
        std::ofstream(path("b"), std::ios::binary) << whole.substr(0, at);
        EXPECT_THROW((void)read_sealed(path("b"), kind), FileError) << at;
    }
}

} // namespace
} // namespace dsc::limits_test
