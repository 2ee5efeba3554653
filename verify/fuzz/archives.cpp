// SPDX-License-Identifier: MIT
// Reads arbitrary bytes as if the library had written them: reading ends with a result or a
// FileError. Whenever damaged bytes of a simulation are accepted, the complex is valid.
#include "fuzz/bytes.h"
#include "fuzz/target.h"
#include "support/pointwise.h"
#include "support/random/scene.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/archive.h"
#include "dsc/base/error.h"
#include "dsc/io/part_file.h"
#include "dsc/parallel/parallel.h"
#include "dsc/queries/validate.h"
#include "replay/replay.h"
#include "scenes/run/checkpoint.h"
#include "scenes/run/standard_archive.h"
#include "thesis/operations/replay.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace dsc::fuzz {

namespace {

// A temporary file that only this process uses.
const std::filesystem::path& scratch() {
    static const auto path =
        std::filesystem::temp_directory_path() / ("dsc_fuzz_" + std::to_string(getpid()));
    return path;
}

std::string in_file(const std::string& bytes) {
    std::ofstream(scratch(), std::ios::binary) << bytes;
    return scratch();
}

Velocity<double> steady_flow() {
    return test::pointwise([](const Point<double>& p) { return Point<double>(0.3, p.x() - 0.5); });
}

// The disc whose simulation's bytes are in the corpus, and are read back here.
std::unique_ptr<Simulation<double>> small_simulation(Complex<double>& complex, bool in_cells) {
    Options<double> options;
    options.edge_length = 0.2;
    options.max_sub_steps = 3;
    complex = test::disc_complex<double>(0.2);
    return in_cells
               ? std::make_unique<Simulation<double>>(complex, options, Parallel{.submeshes = 2})
               : std::make_unique<Simulation<double>>(complex, options);
}

const std::string& written_simulation(bool in_cells) {
    static const auto write = [](bool cells) {
        Complex<double> complex;
        const auto simulation = small_simulation(complex, cells);
        simulation->step(steady_flow(), 0, 0.05);
        Archive archive;
        simulation->archive(archive);
        return archive.bytes();
    };
    static const std::string sequential = write(false);
    static const std::string of_cells = write(true);
    return in_cells ? of_cells : sequential;
}

// Each change of the bytes takes four bytes of the decoder.
std::string damaged(std::string bytes, Bytes& decoder) {
    while (!decoder.empty() && !bytes.empty()) {
        const std::size_t at = decoder.below(65536) % bytes.size();
        const std::uint32_t how = decoder.below(8);
        const std::uint8_t value = decoder.byte();
        if (how < 4) {
            bytes[at] = static_cast<char>(value);
        } else if (how < 6) {
            bytes[at] = static_cast<char>(bytes[at] + 1 - 2 * (value % 2));
        } else if (how == 6) {
            bytes.erase(at, 1U + value);
        } else {
            bytes.insert(at, 1 + value % 16, static_cast<char>(value));
        }
    }
    return bytes;
}

void read_simulation(Bytes& decoder, bool in_cells) {
    const std::string bytes = damaged(written_simulation(in_cells), decoder);
    Complex<double> complex;
    const auto simulation = small_simulation(complex, in_cells);
    Archive archive(bytes, "simulation");
    simulation->archive(archive);
    archive.expect_end();
    std::string problem = validate(complex).problem;
    expect(problem.empty(), "an archive that was read: " + problem);
    simulation->step(steady_flow(), 0.05, 0.05);
    problem = validate(complex).problem;
    expect(problem.empty(), "a step after an archive that was read: " + problem);
}

// Records that do not fit the complex are skipped; records that fit may still make an invalid
// complex.
void replay_edits(const std::vector<Edit>& edits) {
    if (std::ranges::find(edits, EditKind::rebuild, &Edit::kind) == edits.end()) {
        Complex<double> complex = test::disc_complex<double>(0.2);
        const ReplayReport report = replay<double>(complex, edits, repeat_edit<double>);
        expect(report.done + report.skipped == edits.size(), "records that were lost");
    }
}

} // namespace

std::uint64_t run_archives(std::span<const std::uint8_t> bytes) {
    Bytes decoder(bytes);
    const std::uint32_t kind = decoder.below(6);
    if (kind < 2) {
        return end_or_refuse([&] { read_simulation(decoder, kind == 1); });
    }
    const std::string text = decoder.text();
    const std::uint64_t read = end_or_refuse([&] {
        switch (kind) {
        case 2: (void)read_sealed(in_file(text), {"dsc-run", 1}); break;
        case 3: // sealed, so that the checksum does not stop it
            (void)scenes::read_checkpoint(in_file(sealed(scenes::checkpoint_kind, text)));
            break;
        case 4: replay_edits(read_edits(in_file(text))); break;
        default: {
            Archive archive(text, "archive");
            std::map<std::string, std::vector<std::optional<std::pair<bool, std::string>>>> map;
            std::variant<double, int, std::uint64_t, std::string> value;
            archive(map, value);
            archive.expect_end();
        }
        }
    });
    std::filesystem::remove(scratch());
    return read;
}

} // namespace dsc::fuzz
