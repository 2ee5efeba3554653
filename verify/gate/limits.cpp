// SPDX-License-Identifier: MIT
#include "limits.h"

#include "dsc/base/error.h"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace dsc::gate {

namespace {

using Json = nlohmann::json;

std::string read_file(const std::string& path) {
    if (std::filesystem::is_directory(path)) {
        throw FileError("cannot read the limits: it is a folder", path);
    }
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream || !text) {
        const int reason = errno;
        throw FileError(std::string("cannot read the limits: ") +
                            (reason != 0 ? std::strerror(reason) : "the file is empty"),
                        path);
    }
    return text.str();
}

std::string shortened(const Json& value) {
    const std::string text = value.dump();
    return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

const Json& member(const Json& object, const char* key, const std::string& where,
                   const std::string& allowed) {
    if (!object.is_object() || !object.contains(key)) {
        throw InputError({.what = std::string("no '") + key + "'",
                          .where = where,
                          .value = shortened(object),
                          .allowed = allowed});
    }
    return object.at(key);
}

Limit read_limit(const Json& entry, const std::string& where) {
    const std::string allowed = R"({"value": a finite number, "note": where it comes from})";
    const Json& value = member(entry, "value", where, allowed);
    const Json& note = member(entry, "note", where, allowed);
    if (!value.is_number() || !std::isfinite(value.get<double>()) || !note.is_string() ||
        note.get<std::string>().empty()) {
        throw InputError(
            {.what = "not a limit", .where = where, .value = shortened(entry), .allowed = allowed});
    }
    return {value.get<double>(), note.get<std::string>()};
}

} // namespace

Limits Limits::read(const std::string& path) {
    Json json;
    try {
        json = Json::parse(read_file(path));
    } catch (const Json::out_of_range& error) {
        throw InputError({.what = "a number beyond all bounds",
                          .where = path,
                          .value = error.what(),
                          .allowed = "finite limits"});
    } catch (const Json::parse_error& error) {
        throw InputError(
            {.what = "not whole JSON",
             .where = path,
             .value = "an error at byte " + std::to_string(error.byte),
             .allowed = "a limits file, which this one may have been before it was cut off"});
    }
    const std::string allowed = R"({"limits": {CHECK: {SCENE: {"value", "note"}}}})";
    const Json& checks = member(json, "limits", path, allowed);
    if (!checks.is_object()) {
        throw InputError(
            {.what = "no limits", .where = path, .value = shortened(checks), .allowed = allowed});
    }
    Limits limits(path);
    for (const auto& [check, scenes] : checks.items()) {
        if (!scenes.is_object()) {
            throw InputError({.what = "no limits",
                              .where = path + ": " + check,
                              .value = shortened(scenes),
                              .allowed = allowed});
        }
        for (const auto& [scene, entry] : scenes.items()) {
            limits.limits_[{check, scene}] = read_limit(entry, path + ": " + check + ", " + scene);
        }
    }
    return limits;
}

const Limit& Limits::find(const std::string& check, const std::string& scene) const {
    const auto found = limits_.find({check, scene});
    if (found == limits_.end()) {
        throw InputError({.what = "a limit is missing",
                          .where = path_,
                          .value = "none for check '" + check + "', scene '" + scene + "'",
                          .allowed = "one for every scene of the checks that run"});
    }
    return found->second;
}

} // namespace dsc::gate
