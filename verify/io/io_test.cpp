// SPDX-License-Identifier: MIT
// Pictures and ParaView files: well-formed, complete, exact, and there whole or not at all.
#include "dsc/io/appended_data.h"
#include "dsc/io/part_file.h"
#include "dsc/io/pictures.h"

#include "support/small_meshes.h"
#include "support/vtu_testing.h"

#include "dsc/base/error.h"
#include "dsc/quality/measures.h"
#include "thesis/sets/algebra.h"
#include "thesis/sets/insertion_removal.h"
#include "thesis/sets/mesh_functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <regex>
#include <sstream>

#include <sys/resource.h>

namespace dsc::io_test {
namespace {

namespace fs = std::filesystem;
using test::grid;

template <class Real>
class Io : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = std::string("dsc_io_") + info->test_suite_name() + "_" + info->name();
        std::replace(name.begin(), name.end(), '/', '_');
        folder = fs::temp_directory_path() / (name + "_" + std::to_string(getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    [[nodiscard]] std::string path(const std::string& name) const { return folder / name; }
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }

    fs::path folder;
};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Io, Reals);

std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
        ++found;
    }
    return found;
}

// Tags open and close in order, attributes are quoted: enough of XML for what is written here.
void expect_well_formed(const std::string& text) {
    static const std::regex tag(
        R"re(<(/?)([A-Za-z:]+)((?:\s+[A-Za-z_:-]+="[^"<]*")*)\s*(/?)>|<\?xml[^?]*\?>)re");
    std::vector<std::string> open;
    std::size_t angles = 0;
    for (std::sregex_iterator i(text.begin(), text.end(), tag), end; i != end; ++i) {
        ++angles;
        const std::smatch& m = *i;
        if (!m[2].matched) {
            continue;
        }
        if (m[1].length() > 0) {
            ASSERT_FALSE(open.empty());
            EXPECT_EQ(open.back(), m[2].str());
            open.pop_back();
        } else if (m[4].length() == 0) {
            open.push_back(m[2].str());
        }
    }
    EXPECT_TRUE(open.empty());
    EXPECT_EQ(angles, count(text, "<")) << "something in angle brackets is no tag";
}

template <class Real>
Complex<Real> scene() {
    auto complex = grid<Real>(6, 0.15, 2, 2);
    remove(complex, SimplexSet({}, {}, {Triangle{40}})); // free ids: numbers differ from ids
    remove(complex, SimplexSet({Vertex{8}}, {}, {}));
    return complex;
}

TYPED_TEST(Io, SvgHasEveryTriangleAndTheInterface) {
    const auto complex = scene<TypeParam>();
    const std::string file = this->path("mesh.svg");
    write_svg(complex, file, {.title = "a < b & \"c\""});
    const std::string text = read(file);
    expect_well_formed(text);
    EXPECT_EQ(this->files(), 1U) << "nothing else is left behind";
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

TYPED_TEST(Io, SvgOptions) {
    const auto complex = scene<TypeParam>();
    const std::string file = this->path("mesh.svg");
    SvgOptions options;
    options.interface_width_px = 0;
    options.edge_width_px = 0;
    options.size_px = 100;
    options.margin_px = 0;
    options.view = Rectangle{{0, 0}, {3, 1.5}};
    options.phase_colours = {"white", "red", "blue"};
    write_svg(complex, file, options);
    const std::string text = read(file);
    expect_well_formed(text);
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
    write_svg(Complex<TypeParam>(), file);
    expect_well_formed(read(file));
    const auto refused = [&](auto change) {
        SvgOptions bad;
        change(bad);
        EXPECT_THROW(write_svg(complex, this->path("never.svg"), bad), InputError);
    };
    refused([](SvgOptions& o) { o.size_px = 0; });
    refused([](SvgOptions& o) { o.size_px = std::nan(""); });
    refused([](SvgOptions& o) { o.margin_px = -1; });
    refused([](SvgOptions& o) { o.interface_width_px = -1; });
    refused([](SvgOptions& o) { o.phase_colours.clear(); });
    refused([](SvgOptions& o) { o.view = Rectangle{{1, 0}, {1, 1}}; });
    EXPECT_EQ(this->files(), 1U);
}

TYPED_TEST(Io, VtuReadsBackBitByBit) {
    using Real = TypeParam;
    auto complex = grid<Real>(60, 0.15, 2, 2); // its arrays take several blocks
    // Free ids: numbers differ from ids.
    remove(complex, star(complex, Vertex{5}));
    ASSERT_FALSE(complex.is_alive(Vertex{5}));
    auto& attributes = complex.attributes;
    auto& heat = attributes.template add<Vertex, double>("heat <K>");
    auto& wind = attributes.template add<Vertex>("wind", Point<float>(0, 0));
    auto& count = attributes.template add<Vertex, std::int64_t>("count");
    auto& load = attributes.template add<Triangle, float>("load");
    auto& small = attributes.template add<Triangle, std::uint8_t>("small");
    attributes.template add<Edge, double>("side");
    attributes.template add<Vertex, std::string>("word");
    for (std::uint32_t i = 0; i < complex.vertex_bound(); ++i) {
        heat.data()[i] = 1.0 / (1.0 + i);
        wind.data()[i] = {1.0F / (2.0F + static_cast<float>(i)), -static_cast<float>(i)};
        count.data()[i] = -(std::int64_t{1} << 40U) - i;
    }
    for (std::uint32_t i = 0; i < complex.triangle_bound(); ++i) {
        load.data()[i] = -1e-30F * static_cast<float>(i);
        small.data()[i] = static_cast<std::uint8_t>(i);
    }
    std::vector<std::int32_t> owners(complex.triangle_bound());
    std::iota(owners.begin(), owners.end(), -1);
    std::vector<double> ways(2 * std::size_t{complex.vertex_bound()});
    std::iota(ways.begin(), ways.end(), 0.1);
    const std::vector<VtuArray> more{{"owner", SimplexKind::triangle, 1, owners},
                                     {"way", SimplexKind::vertex, 2, ways}};
    const std::string file = this->path("mesh.vtu");
    write_vtu(complex, file, more);
    EXPECT_EQ(this->files(), 1U);
    const test::VtuText vtu{read(file)};
    expect_well_formed(vtu.text);
    EXPECT_NE(vtu.text.find("NumberOfPoints=\"" + std::to_string(complex.vertex_count()) + "\""),
              std::string::npos);
    EXPECT_NE(vtu.text.find("NumberOfCells=\"" + std::to_string(complex.triangle_count()) + "\""),
              std::string::npos);
    EXPECT_EQ(vtu.tag("side"), "");
    EXPECT_EQ(vtu.tag("word"), "");
    const std::string real = sizeof(Real) == 8 ? "Float64" : "Float32";
    const auto points = vtu.numbers<Real>("Points", real);
    EXPECT_EQ(points, vtu.numbers<Real>("position", real));
    const auto cells = vtu.numbers<std::int64_t>("connectivity", "Int64");
    const auto offsets = vtu.numbers<std::int64_t>("offsets", "Int64");
    const auto types = vtu.numbers<std::uint8_t>("types", "UInt8");
    const auto phase = vtu.numbers<Phase>("phase", "UInt32");
    const auto good = vtu.numbers<Real>("quality", real);
    const auto heats = vtu.numbers<double>("heat &lt;K&gt;", "Float64");
    const auto winds = vtu.numbers<float>("wind", "Float32");
    const auto counts = vtu.numbers<std::int64_t>("count", "Int64");
    const auto loads = vtu.numbers<float>("load", "Float32");
    const auto smalls = vtu.numbers<std::uint8_t>("small", "UInt8");
    const auto owner = vtu.numbers<std::int32_t>("owner", "Int32");
    const auto way = vtu.numbers<double>("way", "Float64");
    const SimplexSet all = all_simplices(complex);
    for (const std::size_t size : {points.size(), winds.size(), way.size()}) {
        ASSERT_EQ(size, 3 * all.vertices().size());
    }
    ASSERT_EQ(heats.size(), all.vertices().size());
    ASSERT_EQ(counts.size(), all.vertices().size());
    for (const std::size_t size : {cells.size() / 3, offsets.size(), types.size(), phase.size(),
                                   good.size(), loads.size(), smalls.size(), owner.size()}) {
        ASSERT_EQ(size, all.triangles().size());
    }
    for (std::size_t i = 0; i < all.vertices().size(); ++i) {
        const Vertex v = all.vertices()[i];
        EXPECT_EQ(Point<Real>(points[3 * i], points[3 * i + 1]), complex.position(v));
        EXPECT_EQ(Point<float>(winds[3 * i], winds[3 * i + 1]), wind[v]);
        EXPECT_EQ(way[3 * i], ways[2 * v.id]);
        EXPECT_EQ(way[3 * i + 1], ways[2 * v.id + 1]);
        EXPECT_EQ(points[3 * i + 2], 0);
        EXPECT_EQ(winds[3 * i + 2], 0);
        EXPECT_EQ(way[3 * i + 2], 0);
        EXPECT_EQ(heats[i], heat[v]);
        EXPECT_EQ(counts[i], count[v]);
    }
    for (std::size_t i = 0; i < all.triangles().size(); ++i) {
        const Triangle t = all.triangles()[i];
        EXPECT_EQ(phase[i], complex.phase(t));
        EXPECT_EQ(good[i], quality(complex, t));
        EXPECT_EQ(loads[i], load[t]);
        EXPECT_EQ(smalls[i], small[t]);
        EXPECT_EQ(owner[i], owners[t.id]);
        EXPECT_EQ(types[i], 5);
        EXPECT_EQ(offsets[i], static_cast<std::int64_t>(3 * (i + 1)));
        for (std::size_t k = 0; k < 3; ++k) {
            const auto number = static_cast<std::size_t>(cells[3 * i + k]);
            ASSERT_LT(number, all.vertices().size());
            EXPECT_EQ(all.vertices()[number], complex.vertices_of(t)[k]);
        }
    }
    write_vtu(Complex<Real>(), file);
    expect_well_formed(read(file));
    const std::vector<VtuArray> short_one{{"way", SimplexKind::vertex, 2, std::vector<double>(7)}};
    EXPECT_THROW(write_vtu(complex, file, short_one), InputError);
}

TYPED_TEST(Io, NoFolderNoFile) {
    const auto complex = scene<TypeParam>();
    const std::string file = this->path("missing/mesh.svg");
    try {
        write_svg(complex, file);
        FAIL() << "wrote into a folder that is not there";
    } catch (const FileError& error) {
        EXPECT_EQ(error.path(), file);
        EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos);
    }
    EXPECT_THROW(write_vtu(complex, this->path("missing/mesh.vtu")), FileError);
    // The place is a folder that is not empty: nothing can be renamed onto it.
    fs::create_directories(this->folder / "full.vtu" / "more");
    EXPECT_THROW(write_vtu(complex, this->path("full.vtu")), FileError);
    EXPECT_FALSE(fs::exists(this->path("full.vtu.part")));
    EXPECT_EQ(this->files(), 1U);
}

TYPED_TEST(Io, AFullDiskLeavesTheOldFile) {
    const auto big = grid<TypeParam>(60);
    const std::string svg = this->path("mesh.svg");
    const std::string vtu = this->path("mesh.vtu");
    write_svg(scene<TypeParam>(), svg);
    const std::string before = read(svg);
    // The process may write files of at most 20 kB: the disk is "full" after that.
    struct Limit {
        Limit() {
            old_handler = std::signal(SIGXFSZ, SIG_IGN);
            getrlimit(RLIMIT_FSIZE, &old_limit);
            rlimit limit = old_limit;
            limit.rlim_cur = 20000;
            setrlimit(RLIMIT_FSIZE, &limit);
        }
        ~Limit() {
            setrlimit(RLIMIT_FSIZE, &old_limit);
            std::signal(SIGXFSZ, old_handler);
        }
        void (*old_handler)(int) = nullptr;
        rlimit old_limit{};
    };
    std::string said;
    bool vtu_threw = false;
    {
        const Limit limit;
        try {
            write_svg(big, svg);
        } catch (const FileError& error) {
            said = error.what();
        }
        try {
            write_vtu(big, vtu);
        } catch (const FileError&) {
            vtu_threw = true;
        }
    }
    EXPECT_NE(said.find("writing failed"), std::string::npos) << said;
    EXPECT_TRUE(vtu_threw);
    EXPECT_EQ(read(svg), before);
    EXPECT_FALSE(fs::exists(vtu));
    EXPECT_EQ(this->files(), 1U) << "the partial files are gone";
    write_vtu(big, vtu);
    EXPECT_EQ(this->files(), 2U);
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

} // namespace
} // namespace dsc::io_test
