// SPDX-License-Identifier: MIT
#include "scenes/parameters.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace dsc::scenes {

namespace {

std::string join(const std::vector<std::string>& words) {
    std::string text;
    for (const auto& word : words) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

[[noreturn]] void refuse(const std::string& key, const std::string& value,
                         const std::string& allowed) {
    throw InputError("bad value", "--set " + key, "'" + value + "'", allowed);
}

double number(const std::string& key, const std::string& value, double low, double high,
              const std::string& allowed) {
    double result = 0;
    const char* end = value.data() + value.size();
    const auto [stop, error] = std::from_chars(value.data(), end, result);
    if (error != std::errc{} || stop != end || !std::isfinite(result) || result < low ||
        result > high) {
        refuse(key, value, allowed);
    }
    return result;
}

template <class Integer>
Integer whole_number(const std::string& key, const std::string& value, Integer low, Integer high,
                     const std::string& allowed) {
    Integer result = 0;
    const char* end = value.data() + value.size();
    const auto [stop, error] = std::from_chars(value.data(), end, result);
    if (error != std::errc{} || stop != end || result < low || result > high) {
        refuse(key, value, allowed);
    }
    return result;
}

// One of some enumerators, by the name that to_string gives it.
template <class Enum, std::size_t n>
Enum choice(const std::string& key, const std::string& value, const std::array<Enum, n>& all) {
    std::vector<std::string> names;
    for (const Enum one : all) {
        if (value == to_string(one)) {
            return one;
        }
        names.emplace_back(to_string(one));
    }
    refuse(key, value, join(names));
}

} // namespace

void set_parameter(Parameters& parameters, const std::vector<std::string>& keys,
                   const std::string& key, const std::string& value) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
        throw InputError("unknown key", "--set", "'" + key + "'", "for this scene: " + join(keys));
    }
    if (key == "h") {
        parameters.h =
            number(key, value, 1e-5, 1, "a length from 1e-5 to 1, in units of the domain");
    } else if (key == "dt") {
        parameters.dt = number(key, value, 1e-12, 1e3, "a time from 1e-12 to 1000");
    } else if (key == "steps") {
        parameters.steps =
            whole_number<int>(key, value, 1, 100'000'000, "a whole number from 1 to 100000000");
    } else if (key == "period") {
        parameters.period = number(key, value, 1e-6, 1e6, "a time from 1e-6 to 1e6");
    } else if (key == "seed") {
        parameters.seed = whole_number<std::uint64_t>(key, value, 0, UINT64_MAX,
                                                      "a whole number from 0 to 2^64 - 1");
    } else if (key == "integrator") {
        parameters.integrator =
            choice(key, value,
                   std::array{Integrator::euler, Integrator::centred, Integrator::midpoint,
                              Integrator::rk4, Integrator::adaptive});
    } else if (key == "tolerance") {
        parameters.tolerance = number(key, value, 1e-12, 1, "1e-12 to 1, an error in edge lengths");
    } else if (key == "insertion") {
        parameters.insertion =
            choice(key, value, std::array{Insertion::linear, Insertion::cubic, Insertion::arc});
    } else if (key == "coarsening") {
        parameters.interface.coarsening =
            choice(key, value,
                   std::array{Coarsening::deviation, Coarsening::length, Coarsening::area,
                              Coarsening::never});
    } else if (key == "reading") {
        parameters.interface.reading =
            choice(key, value, std::array{Reading::chords, Reading::cubic});
    } else if (key == "longest") {
        parameters.interface.longest = number(key, value, 0.1, 10, "0.1 to 10, in edge lengths");
    } else if (key == "shortest") {
        parameters.interface.shortest = number(key, value, 0, 5, "0 to 5, in edge lengths");
    } else if (key == "deviation") {
        parameters.interface.deviation = number(key, value, 0, 1, "0 to 1, in edge lengths");
    } else if (key == "turn") {
        parameters.interface.turn_degrees = number(key, value, 0, 180, "0 (off), 1 to 180 degrees");
    } else if (key == "gap") {
        parameters.interface.gap = number(key, value, 0, 100, "0 (off), 0.1 to 100");
    } else if (key == "grading") {
        parameters.interface.grading = number(key, value, 0, 100, "0 (off), 2 to 100");
    } else if (key == "finest") {
        parameters.interface.finest = number(key, value, 1e-3, 1, "0.001 to 1, in edge lengths");
    } else if (key == "real") {
        if (value == "double") {
            parameters.real = RealType::double_precision;
        } else if (value == "float") {
            parameters.real = RealType::single_precision;
        } else {
            refuse(key, value, "double, float");
        }
    }
}

} // namespace dsc::scenes
