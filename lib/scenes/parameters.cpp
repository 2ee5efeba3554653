// SPDX-License-Identifier: MIT
#include "scenes/parameters.h"

#include "dsc/base/error.h"

#include <algorithm>
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
        if (value == "euler") {
            parameters.integrator = Integrator::euler;
        } else if (value == "midpoint") {
            parameters.integrator = Integrator::midpoint;
        } else if (value == "rk4") {
            parameters.integrator = Integrator::rk4;
        } else {
            refuse(key, value, "euler, midpoint, rk4");
        }
    } else if (key == "insertion") {
        if (value == "linear") {
            parameters.insertion = Insertion::linear;
        } else if (value == "cubic") {
            parameters.insertion = Insertion::cubic;
        } else {
            refuse(key, value, "linear, cubic");
        }
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
