// SPDX-License-Identifier: MIT
// Pictures, ParaView files and sealed files are complete, exact, and written atomically. Python
// tests check that other programs can read them.
#include "dsc/io/appended_data.h"
#include "dsc/io/pictures.h"

#include "support/small_meshes.h"

#include "dsc/base/error.h"
#include "replay/sealed_file.h"
#include "thesis/sets/algebra.h"
#include "thesis/sets/insertion_removal.h"
#include "thesis/sets/mesh_functions.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <utility>

#include <sys/resource.h>

namespace dsc::io_test {
namespace {

namespace fs = std::filesystem;
using test::grid;

class Io : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    [[nodiscard]] std::string path(const std::string& name) const { return folder / name; }
    [[nodiscard]] std::string read(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }

    fs::path folder = fs::temp_directory_path() / ("dsc_io_" + std::to_string(getpid()));
};

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
        ++found;
    }
    return found;
}

Complex<double> scene() {
    auto complex = grid<double>(6, 0.15, 2, 2);
    remove(complex, SimplexSet({}, {}, {Triangle{40}})); // free ids: numbers in files are not ids
    remove(complex, SimplexSet({Vertex{8}}, {}, {}));
    return complex;
}

TEST_F(Io, SvgHasEveryTriangleAndTheInterface) {
    const auto complex = scene();
    const std::string file = path("mesh.svg");
    write_svg(complex, file, {.title = "a < b & \"c\""});
    const std::string text = read(file);
    EXPECT_EQ(files(), 1U) << "nothing else is left behind";
    EXPECT_NE(text.find("<title>a &lt; b &amp; &quot;c&quot;</title>"), std::string::npos);
    EXPECT_NE(text.find("class=\"phase-0\" fill=\"#ffffff\""), std::string::npos);
    EXPECT_NE(text.find("class=\"phase-1\" fill=\"#56b4e9\""), std::string::npos);
    EXPECT_EQ(count(text, "Z\n"), complex.triangle_count());
    const SimplexSet interface = interface_of(complex);
    EXPECT_EQ(count(text, "M"), complex.triangle_count() + interface.edges().size());
    EXPECT_NE(text.find("class=\"interface\""), std::string::npos);
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_NE(text.find("viewBox=\"0 0 820.000 820.000\""), std::string::npos);
    // y upwards: the vertex at (0, 0) is at the lower left.
    EXPECT_NE(text.find("M10.000 810.000"), std::string::npos);
}

TEST_F(Io, SvgOptions) {
    const auto complex = scene();
    const std::string file = path("mesh.svg");
    SvgOptions options;
    options.interface_width_px = 0;
    options.edge_width_px = 0;
    options.size_px = 100;
    options.margin_px = 0;
    options.view = Rectangle{{0, 0}, {3, 1.5}};
    options.phase_colours = {"white", "red", "blue"};
    write_svg(complex, file, options);
    const std::string text = read(file);
    EXPECT_EQ(text.find("class=\"interface\""), std::string::npos);
    EXPECT_NE(text.find("width=\"100.000\" height=\"50.000\""), std::string::npos);
    EXPECT_NE(text.find("class=\"phase-1\" fill=\"red\""), std::string::npos);
    // Phases beyond the list go around, but never get the exterior's colour.
    auto many = complex;
    const auto triangles = all_simplices(many).triangles();
    many.set_phase(triangles[1], 3);
    many.set_phase(triangles[2], 4);
    many.set_phase(triangles[3], border_phase - 1);
    write_svg(many, file, options);
    const std::string cycled = read(file);
    EXPECT_NE(cycled.find("class=\"phase-3\" fill=\"red\""), std::string::npos);
    EXPECT_NE(cycled.find("class=\"phase-4\" fill=\"blue\""), std::string::npos);
    EXPECT_NE(cycled.find("class=\"phase-4294967294\" fill=\"blue\""), std::string::npos);
    write_svg(Complex<double>(), file);
    const auto refused = [&](auto change) {
        SvgOptions bad;
        change(bad);
        EXPECT_THROW(write_svg(complex, path("never.svg"), bad), InputError);
    };
    refused([](SvgOptions& o) { o.size_px = 0; });
    refused([](SvgOptions& o) { o.size_px = std::nan(""); });
    refused([](SvgOptions& o) { o.margin_px = -1; });
    refused([](SvgOptions& o) { o.interface_width_px = -1; });
    refused([](SvgOptions& o) { o.phase_colours.clear(); });
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
        refused([=](SvgOptions& o) { o.view = Rectangle{{0, 0}, {bad, 0.5}}; });
        refused([=](SvgOptions& o) { o.view = Rectangle{{0, 0}, {0.5, bad}}; });
    }
    EXPECT_NO_THROW(write_svg(complex, file, {.view = Rectangle{{0, 0}, {0.5, 0.5}}}));
    EXPECT_EQ(files(), 1U);
}

// vtu_readers_test.py reads such files with other programs.
TEST_F(Io, VtuTakesWhatAttributesItCanAndNamesEachOnce) {
    auto complex = grid<double>(2);
    complex.attributes.add<Triangle>("phase", 7.0);
    complex.attributes.add<Triangle>("heat <K>", 7.0);
    complex.attributes.add<Edge, double>("side");
    complex.attributes.add<Vertex, std::string>("word");
    write_vtu(complex, path("a.vtu"));
    const std::string text = read("a.vtu");
    EXPECT_EQ(count(text, "Name=\"phase\""), 1U);
    EXPECT_EQ(count(text, "Name=\"heat &lt;K&gt;\""), 1U);
    EXPECT_EQ(count(text, "Name=\"side\"") + count(text, "Name=\"word\""), 0U);
    write_vtu(Complex<float>(), path("a.vtu"));
    const std::vector<VtuArray> short_one{{"way", SimplexKind::vertex, 2, std::vector<double>(7)}};
    EXPECT_THROW(write_vtu(complex, path("a.vtu"), short_one), InputError);
}

TEST_F(Io, NoFolderNoFile) {
    const auto complex = scene();
    const std::string file = path("missing/mesh.svg");
    try {
        write_svg(complex, file);
        FAIL() << "wrote into a folder that is not there";
    } catch (const FileError& error) {
        EXPECT_EQ(error.path(), file);
        EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos);
    }
    EXPECT_THROW(write_vtu(complex, path("missing/mesh.vtu")), FileError);
    // The target is a folder that is not empty, so no file can be renamed to it.
    fs::create_directories(folder / "full.vtu" / "more");
    EXPECT_THROW(write_vtu(complex, path("full.vtu")), FileError);
    EXPECT_FALSE(fs::exists(path("full.vtu.part")));
    EXPECT_EQ(files(), 1U);
}

TEST_F(Io, AFullDiskLeavesTheOldFile) {
    const auto big = grid<double>(60);
    const std::string svg = path("mesh.svg");
    const std::string vtu = path("mesh.vtu");
    write_svg(scene(), svg);
    const std::string before = read(svg);
    // The process may write files of at most 20 kB: the disk is "full" after that.
    auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlim_t usual = std::exchange(limit.rlim_cur, 20000);
    setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_THROW(write_svg(big, svg), FileError);
    EXPECT_THROW(write_vtu(big, vtu), FileError);
    limit.rlim_cur = usual;
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(read(svg), before);
    EXPECT_FALSE(fs::exists(vtu));
    EXPECT_EQ(files(), 1U) << "the partial files are gone";
    write_vtu(big, vtu);
    EXPECT_EQ(files(), 2U);
}

// The examples of RFC 4648, section 10.
TEST(Base64, IsPaddedToFourDigits) {
    const std::vector<std::pair<const char*, const char*>> known{{"", ""},
                                                                 {"f", "Zg=="},
                                                                 {"fo", "Zm8="},
                                                                 {"foo", "Zm9v"},
                                                                 {"foob", "Zm9vYg=="},
                                                                 {"fooba", "Zm9vYmE="},
                                                                 {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, digits] : known) {
        std::string text;
        append_base64(text, bytes);
        EXPECT_EQ(text, digits);
    }
}

TEST_F(Io, AnEmptyArrayIsAHeaderWithoutBlocks) {
    AppendedData data;
    EXPECT_EQ(data.add(std::vector<float>{}), 0U);
    EXPECT_EQ(data.text().size(), 32U); // three numbers of eight bytes in base64
}

TEST_F(Io, ASealedFileReadsBackAndTellsWhatIsWrong) {
    const SealedKind kind{.name = "eight ch", .version = 3};
    write_sealed(path("a"), kind, "some bytes");
    EXPECT_EQ(read_sealed(path("a"), kind), "some bytes");
    EXPECT_THROW(write_sealed(path("b"), {.name = "nine char"}, ""), InputError);
    EXPECT_THROW(write_sealed(path("b"), {.name = ""}, ""), InputError);
    EXPECT_THROW((void)read_sealed(path("a"), {.name = "eight ch", .version = 2}), FileError);
    EXPECT_THROW((void)read_sealed(path("a"), {.name = "another", .version = 3}), FileError);
    EXPECT_THROW((void)read_sealed(path("none"), kind), FileError);
    const std::string whole = read("a");
    for (std::size_t at = 0; at < whole.size(); ++at) { // every byte, including the reserved ones
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 1);
        std::ofstream(path("b"), std::ios::binary) << damaged;
        EXPECT_THROW((void)read_sealed(path("b"), kind), FileError) << at;
        std::ofstream(path("b"), std::ios::binary) << whole.substr(0, at);
        EXPECT_THROW((void)read_sealed(path("b"), kind), FileError) << at;
    }
}

} // namespace
} // namespace dsc::io_test
