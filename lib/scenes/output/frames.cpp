// SPDX-License-Identifier: MIT
#include "scenes/output/frames.h"

#include "dsc/base/error.h"
#include "scenes/output/event_lines.h"
#include "scenes/output/write_file.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

namespace dsc::scenes {

Frames::Frames(std::string folder, std::string name, int count, int steps, std::optional<int> half)
    : folder_(std::move(folder)), name_(std::move(name)), count_(std::max(count, 2)),
      steps_(std::max(steps, 1)), half_(half) {
    if (folder_.empty()) {
        return;
    }
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error || access(folder_.c_str(), W_OK) != 0) {
        throw InputError(
            {.what = "cannot write to this folder",
             .where = "--frames",
             .value = "'" + folder_ + "'",
             .allowed = "a folder that exists or can be made, with permission to write"});
    }
}

bool Frames::is_due(int step) const {
    if (folder_.empty()) {
        return false;
    }
    if (step == 0 || step == steps_ || (half_ && step == *half_)) {
        return true;
    }
    const auto slot = [&](int s) { return static_cast<long long>(s) * (count_ - 1) / steps_; };
    return slot(step) != slot(step - 1);
}

template <class Real>
std::string Frames::write(int step, double time, const Complex<Real>& complex) {
    if (!is_due(step)) {
        return {};
    }
    char number[16];
    std::snprintf(number, sizeof number, "%05d", step);
    const std::string file = name_ + "_" + number + ".vtu";
    std::string path = (std::filesystem::path(folder_) / file).string();
    write_vtu(complex, path);
    entries_.push_back({time, file});
    return path;
}

void Frames::finish(std::span<const Event> events) const {
    if (folder_.empty()) {
        return;
    }
    const std::filesystem::path path = std::filesystem::path(folder_) / name_;
    write_pvd(entries_, path.string() + ".pvd");
    const std::string list = path.string() + ".events.jsonl";
    if (events.empty()) {
        std::filesystem::remove(list); // of an earlier run
    } else {
        write_file(list, events_to_json_lines(events));
    }
}

template std::string Frames::write(int, double, const Complex<double>&);
template std::string Frames::write(int, double, const Complex<float>&);

} // namespace dsc::scenes
