// SPDX-License-Identifier: MIT
#include "dsc/io/part_file.h"

#include "dsc/base/error.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace dsc {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t block_size = std::size_t{1} << 16U;
constexpr int max_links = 40;               ///< the kernel's own limit
constexpr int max_parts = 10000;            ///< part files of one path at a time
constexpr std::size_t longest_prefix = 100; ///< bytes: no file system allows fewer than 143

// Whether a link is in the folder of this process's open descriptors: opening such a link starts at
// the beginning of the file, or fails.
bool is_descriptor(const fs::path& link) {
    std::error_code error;
    const fs::path all = fs::canonical("/proc/self/fd", error);
    return !error && fs::canonical(link.parent_path(), error) == all;
}

fs::path folder_of(const fs::path& file) { return file.parent_path() / "."; }

} // namespace

Destination destination_of(const std::string& path) {
    fs::path place(path.substr(0, path.find('\0'))); // as much as the kernel would read
    std::error_code error;
    const fs::file_status status = fs::status(place, error);
    if (fs::is_directory(status)) {
        throw FileError("cannot be written", path, EISDIR);
    }
    if (status.type() == fs::file_type::none || place.native() != path || !place.has_filename()) {
        throw FileError("cannot be written", path.empty() ? "''" : place.string(),
                        error ? error.value() : EINVAL);
    }
    for (int i = 0; i < max_links && fs::is_symlink(fs::symlink_status(place, error)); ++i) {
        if (is_descriptor(place)) {
            return {place.string(), true, std::stoi(place.filename())};
        }
        place = place.parent_path() / fs::read_symlink(place, error);
    }
    return {place.string(), fs::exists(status) && !fs::is_regular_file(status)};
}

// POSIX calls rather than std::ofstream: they say why they failed, and close() reports data
// lost to a full disk or a quota.
PartFile::PartFile(std::string path) : path_(std::move(path)), place_(destination_of(path_)) {
    buffer_.reserve(block_size + 1024);
    if (place_.descriptor >= 0) {
        descriptor_ = ::fcntl(place_.descriptor, F_DUPFD_CLOEXEC, 0);
    } else if (place_.is_stream) {
        descriptor_ = ::open(place_.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    } else {
        make_part();
    }
    if (descriptor_ < 0) {
        throw FileError("cannot be written", path_, errno);
    }
}

// A file without write permission must not be replaced either.
void PartFile::make_part() {
    const fs::path place(place_.path);
    if (::access(place.c_str(), W_OK) != 0 && errno != ENOENT) {
        return;
    }
    const std::string name = place.filename();
    const fs::path prefix = folder_of(place) / (name.size() > longest_prefix ? "dsc" : name);
    // A string, because gcc 12 sees an overflow that is none in "." + a string.
    const std::string process = std::string(".") + std::to_string(::getpid()) + "-";
    for (int i = 0; i < max_parts && descriptor_ < 0 && (i == 0 || errno == EEXIST); ++i) {
        part_ = prefix.string() + process + std::to_string(i) + ".part";
        descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    }
}

PartFile::~PartFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
        ::unlink(part_.c_str());
    }
}

void PartFile::fail(const std::string& what, int error) {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
        descriptor_ = -1;
    }
    ::unlink(part_.c_str());
    throw FileError(what, path_, error);
}

void PartFile::write_block() {
    std::size_t done = 0;
    while (done < buffer_.size()) {
        const ssize_t written = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
        if (written < 0) {
            if (errno == EINTR) {
                continue;
            }
            fail("writing failed", errno);
        }
        done += static_cast<std::size_t>(written);
    }
    buffer_.clear();
}

PartFile& PartFile::operator<<(std::string_view text) {
    buffer_.append(text);
    if (buffer_.size() >= block_size) {
        write_block();
    }
    return *this;
}

PartFile& PartFile::operator<<(char c) { return *this << std::string_view(&c, 1); }

void PartFile::commit(Until until) {
    write_block();
    // Some file systems, and streams, cannot sync (EINVAL): then the rename alone must suffice.
    if (until == Until::on_disk && ::fsync(descriptor_) != 0 && errno != EINVAL) {
        fail("writing failed", errno);
    }
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) {
        fail("closing failed", errno);
    }
    if (place_.is_stream) {
        return;
    }
    if (std::rename(part_.c_str(), place_.path.c_str()) != 0) {
        fail("renaming failed", errno);
    }
    part_.clear(); // the name may belong to another writer by now
    if (until == Until::on_disk) {
        descriptor_ = ::open(folder_of(place_.path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (descriptor_ >= 0 && ::fsync(descriptor_) != 0 && errno != EINVAL) {
            fail("syncing its folder failed", errno);
        }
        ::close(std::exchange(descriptor_, -1));
    }
}

std::string escape_xml(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&': result += "&amp;"; break;
        case '<': result += "&lt;"; break;
        case '>': result += "&gt;"; break;
        case '"': result += "&quot;"; break;
        case '\'': result += "&apos;"; break;
        default: result += c;
        }
    }
    return result;
}

} // namespace dsc
