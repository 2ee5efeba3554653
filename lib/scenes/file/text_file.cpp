// SPDX-License-Identifier: MIT
#include "scenes/file/text_file.h"

#include "dsc/base/error.h"

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

} // namespace dsc::scenes
