// SPDX-License-Identifier: MIT
#include "scenes/file/text_file.h"

#include "dsc/base/error.h"
#include "dsc/io/part_file.h"

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
    text << file.rdbuf(); // which fails for an empty file as well
    if (!file.is_open() || (size > 0 && text.fail())) {
        throw FileError("cannot read this file", path.string(), errno);
    }
    return text.str();
}

// A device or a pipe is refused, because the file that is written takes its place.
void check_writable(const std::string& path, const std::string& where) {
    const std::filesystem::path file(path);
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code error;
    if (path.empty() || !std::filesystem::is_directory(folder, error) ||
        (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error)) ||
        access(folder.c_str(), W_OK) != 0) {
        throw InputError({.what = "cannot write this file",
                          .where = where,
                          .value = "'" + path + "'",
                          .allowed = "a file in a folder that exists, with permission to write"});
    }
}

void write_file(const std::string& path, const std::string& content) {
    PartFile file(path);
    file << content;
    file.commit();
}

} // namespace dsc::scenes
