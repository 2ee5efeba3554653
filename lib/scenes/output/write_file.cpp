// SPDX-License-Identifier: MIT
#include "scenes/output/write_file.h"

#include "dsc/base/error.h"
#include "dsc/io/part_file.h"

#include <unistd.h>

#include <filesystem>

namespace dsc::scenes {

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
