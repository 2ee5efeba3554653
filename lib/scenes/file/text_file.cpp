// SPDX-License-Identifier: MIT
#include "scenes/file/text_file.h"

#include "dsc/base/error.h"
#include "dsc/io/part_file.h"
#include "scenes/file/excerpt.h"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>

namespace dsc::scenes {

std::string read_text_file(const std::filesystem::path& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        throw FileError("cannot read this file", path.string(), ENOENT);
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw FileError("not a regular file", path.string());
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || size > largest_text_file) {
        throw FileError("larger than " + std::to_string(largest_text_file) + " bytes",
                        path.string());
    }
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf(); // reading an empty file fails here as well
    if (!file.is_open() || (size > 0 && text.fail())) {
        throw FileError("cannot read this file", path.string(), errno);
    }
    return text.str();
}

namespace {

namespace fs = std::filesystem;

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code error; // ignored: the file may not exist
    if (fs::exists(a, error) || fs::exists(b, error)) {
        return fs::equivalent(a, b, error);
    }
    return a.filename() == b.filename() &&
           fs::equivalent(a.parent_path() / ".", b.parent_path() / ".", error);
}

} // namespace

void check_outputs(const std::vector<NamedFile>& outputs, std::vector<NamedFile> others) {
    others.push_back({"standard output", "/proc/self/fd/1"});
    others.push_back({"the error stream", "/proc/self/fd/2"});
    for (const NamedFile& output : outputs) {
        const auto refuse = [&](const std::string& what, const char* allowed) {
            throw InputError({.what = what,
                              .where = output.option,
                              .value = quoted_excerpt(output.path),
                              .allowed = allowed});
        };
        Destination place;
        try {
            place = destination_of(output.path);
            if (!place.is_stream) {
                PartFile unused(output.path);
            } else if (access(place.path.c_str(), W_OK) !=
                       0) { // opening a pipe would wait for a reader
                throw FileError("cannot be written", output.path, errno);
            }
        } catch (const FileError& error) {
            refuse("cannot write this file (" + std::generic_category().message(error.error()) +
                       ")",
                   "a file in a folder that exists, with permission to write");
        }
        for (const NamedFile& other : others) {
            if (!place.is_stream && is_same_file(place.path, other.path)) {
                refuse("the same file as " + other.option, "a file of its own");
            }
        }
        others.push_back({output.option, place.path});
    }
}

void write_file(const std::string& path, const std::string& content) {
    PartFile file(path);
    file << content;
    file.commit();
}

} // namespace dsc::scenes
