// SPDX-License-Identifier: MIT
// Reads arbitrary texts as scene files, outlines and formulas: each gives what it describes, or an
// error of one line that says where it is wrong and what is allowed.
#include "fuzz/bytes.h"
#include "fuzz/target.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "dsc/queries/validate.h"
#include "scenes/file/formula/formula_flow.h"
#include "scenes/file/outlines/pieces.h"
#include "scenes/file/scene_file.h"
#include "scenes/run/start.h"

namespace dsc::fuzz {

namespace {

// For scenes up to this size the complex is made and a step is run.
constexpr double max_triangles = 2'000;
constexpr std::size_t max_points = 1'000;

template <class Read>
std::uint64_t end_or_explain(Read read) {
    try {
        return end_or_refuse(read);
    } catch (const InputError& error) {
        expect(!error.where().empty() && !error.problem().empty() && !error.allowed().empty(),
               std::string("an error without where, what or allowed: ") + error.what());
        expect(std::string(error.what()).find('\n') == std::string::npos,
               std::string("an error of several lines: ") + error.what());
        return 0;
    }
}

void check_finite_or_closed(const std::vector<scenes::Piece>& pieces) {
    for (const scenes::Piece& piece : pieces) {
        for (const Point<double>& p : piece.points) {
            expect(p.allFinite(), "a point that was read is not finite");
        }
    }
    if (pieces.size() < 20) {
        expect(scenes::nesting(pieces).size() == pieces.size(), "pieces without a nesting");
    }
}

// Whether a scene of edges of length `h` is small enough to be made here: by its triangles, the
// points of its outlines and curves, and the edges along them.
bool is_small(const scenes::Setup& setup, double h) {
    const Point<double> size = setup.domain.high - setup.domain.low;
    std::size_t points = 0;
    double length = 0;
    for (const scenes::Outline& outline : setup.outlines) {
        points += outline.size();
        length += scenes::perimeter(outline);
    }
    for (const Curve& curve : setup.curves) {
        points += curve.points.size();
        length += scenes::perimeter(curve.points);
    }
    return size.prod() / (h * h) < max_triangles && points < max_points &&
           length / h < static_cast<double>(max_points);
}

void run_steps_of(const scenes::Scene& scene, const scenes::Setup& setup) {
    Complex<double> complex = scenes::first_complex<double>(setup, scene.defaults);
    expect(validate(complex).ok(), "the first complex: " + validate(complex).problem);
    if (setup.flow.empty()) {
        return;
    }
    auto options = scenes::scene_options<double>(setup, scene.defaults);
    options.max_sub_steps = 3; // a text may ask for any speed
    Simulation<double> simulation(complex, options);
    simulation.step(setup.flow[0].velocity, 0, setup.dt);
    expect(validate(complex).ok(), "after a step: " + validate(complex).problem);
}

} // namespace

std::uint64_t run_scene_file(std::span<const std::uint8_t> bytes) {
    const std::string text = Bytes(bytes).text();
    return end_or_explain([&] {
        // The path is in the folder of the examples, so that a text may name their files.
        const auto file = scenes::read_scene_text(text, DSC_EXAMPLES "/fuzzed.toml");
        const scenes::Setup setup = file.scene.prepare(file.scene.defaults);
        if (is_small(setup, file.scene.defaults.h)) {
            run_steps_of(file.scene, setup);
        }
    });
}

std::uint64_t run_outlines(std::span<const std::uint8_t> bytes) {
    Bytes decoder(bytes);
    const std::uint32_t kind = decoder.below(2);
    const std::string text = decoder.text();
    return end_or_explain([&] {
        switch (kind) {
        case 0: check_finite_or_closed(scenes::read_points(text, true, "file")); break;
        default: check_finite_or_closed(scenes::read_points(text, false, "file")); break;
        }
    });
}

std::uint64_t run_formulas(std::span<const std::uint8_t> bytes) {
    const std::string text = Bytes(bytes).text();
    return end_or_explain([&] {
        const scenes::FormulaFlow flow({.u = text, .v = "x", .where_u = "file"});
        std::vector<Point<double>> velocities(3, {0.25, 4});
        flow(velocities, 0.5, velocities);
        // The result for a position does not depend on the batch.
        std::vector<Point<double>> alone(1, {0.25, 4});
        flow(alone, 0.5, alone);
        const double one = alone[0].x();
        const double three = velocities[2].x();
        expect(one == three || (one != one && three != three), "depends on the batch");
    });
}

} // namespace dsc::fuzz
