// SPDX-License-Identifier: MIT
#include "scenes/write_file.h"

#include "dsc/base/error.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace dsc::scenes {

void check_writable(const std::string& path, const std::string& where) {
    const std::filesystem::path file(path);
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code error;
    if (path.empty() || !std::filesystem::is_directory(folder, error) ||
        std::filesystem::is_directory(file, error) || access(folder.c_str(), W_OK) != 0) {
        throw InputError("cannot write this file", where, "'" + path + "'",
                         "a file in a folder that exists, with permission to write");
    }
}

void write_file(const std::string& path, const std::string& content) {
    const std::string part = path + ".part";
    errno = 0;
    std::ofstream stream(part, std::ios::binary | std::ios::trunc);
    stream << content;
    stream.close();
    if (!stream) {
        const int reason = errno;
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        throw FileError(std::string("cannot write: ") +
                            (reason != 0 ? std::strerror(reason) : "the stream failed"),
                        path);
    }
    std::error_code error;
    std::filesystem::rename(part, path, error);
    if (error) {
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        throw FileError("cannot rename the finished file: " + error.message(), path);
    }
}

} // namespace dsc::scenes
