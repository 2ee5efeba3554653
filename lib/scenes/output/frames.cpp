// SPDX-License-Identifier: MIT
#include "scenes/output/frames.h"

#include "dsc/base/error.h"
#include "dsc/io/part_file.h"
#include "scenes/file/text_file.h"
#include "scenes/run/json.h"
#include "scenes/run/standard_archive.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

namespace dsc::scenes {

namespace {

/// Tolerance for comparing the times of steps, which are products, with given times, which are
/// rounded.
constexpr double time_slack = 1e-9; // of a step

int step_that_reaches(double time, double dt) {
    return static_cast<int>(std::ceil(std::max(time, 0.0) / dt - time_slack));
}

// A collection file (Kitware, "VTK file formats"), which gives each frame a time.
void write_collection(const std::vector<std::pair<double, std::string>>& frames,
                      const std::string& path) {
    PartFile file(path);
    file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
         << "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const auto& [time, name] : frames) {
        file << "<DataSet timestep=\"" << time << "\" part=\"0\" file=\"" << escape_xml(name)
             << "\"/>\n";
    }
    file << "</Collection>\n</VTKFile>\n";
    file.commit();
}

} // namespace

void check_times(const FramePlan& plan, const Setup& setup) {
    const double end = setup.steps * setup.dt;
    for (const double time : plan.times) {
        require(time >= 0 && step_that_reaches(time, setup.dt) <= setup.steps, "--at", time,
                "0 to " + to_text(end));
    }
}

bool is_frame_due(const FramePlan& plan, const Setup& setup, int step) {
    if (plan.folder.empty()) {
        return false;
    }
    const bool is_asked_for = std::ranges::any_of(
        plan.times, [&](double time) { return step_that_reaches(time, setup.dt) == step; });
    if (is_asked_for || (plan.every <= 0 && !plan.times.empty())) {
        return is_asked_for;
    }
    if (step == 0 || step == setup.steps) {
        return true;
    }
    if (plan.every > 0) {
        return step % plan.every == 0;
    }
    const auto slot = [&](int s) {
        return static_cast<long long>(s) * (std::max(plan.count, 2) - 1) / std::max(setup.steps, 1);
    };
    return (setup.half_step && step == *setup.half_step) || slot(step) != slot(step - 1);
}

Frames::Frames(FramePlan plan, std::string name, const Setup& setup)
    : plan_(std::move(plan)), setup_(setup), name_(std::move(name)) {
    if (plan_.folder.empty()) {
        return;
    }
    check_times(plan_, setup);
    std::error_code ignored; // an unwritable folder is refused below
    std::filesystem::create_directories(plan_.folder, ignored);
    check_outputs({{"--frames", collection()}});
}

std::string Frames::collection() const {
    return (std::filesystem::path(plan_.folder) / (name_ + ".pvd")).string();
}

std::string Frames::path_of(int step) const {
    char number[16];
    std::snprintf(number, sizeof number, "_%05d", step);
    return (std::filesystem::path(plan_.folder) / (name_ + number)).string();
}

std::string Frames::enter(int step, double time) {
    std::string path = path_of(step);
    entries_.emplace_back(time, std::filesystem::path(path + ".vtu").filename().string());
    return path;
}

template <class Real>
std::string Frames::write(int step, double time, const Complex<Real>& complex,
                          std::span<const VtuArray> more) {
    std::string path = enter(step, time) + ".vtu";
    write_vtu(complex, path, more);
    if (!plan_.layers.empty()) {
        write_picture(complex, plan_.layers, name_ + ", time " + to_text(time),
                      path_of(step) + ".svg");
    }
    return path;
}

void Frames::finish(std::span<const Event> events) const {
    if (plan_.folder.empty()) {
        return;
    }
    write_collection(entries_, collection());
    const auto list = std::filesystem::path(collection()).replace_extension(".events.jsonl");
    if (events.empty()) {
        std::filesystem::remove(list); // of an earlier run
    } else {
        write_file(list, events_to_json_lines(events));
    }
}

void Frames::archive(Archive& archive) { archive(entries_); }

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::string Frames::write(int, double, const Complex<Real>&,                          \
                                       std::span<const VtuArray>);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::scenes
