// SPDX-License-Identifier: MIT
#include "dsc/io/part_file.h"

#include "dsc/base/error.h"

#include <cerrno>
#include <cstdio>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace dsc {

namespace {

constexpr std::size_t block_size = std::size_t{1} << 16U;

} // namespace

// POSIX calls rather than std::ofstream: they say why they failed, and close() reports data
// lost to a full disk or a quota.
PartFile::PartFile(std::string path) : path_(std::move(path)), part_(path_ + ".part") {
    buffer_.reserve(block_size + 1024);
    descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
        throw FileError("cannot be written", path_, errno);
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
    // Some file systems cannot sync (EINVAL): the rename alone must do.
    if (until == Until::on_disk && ::fsync(descriptor_) != 0 && errno != EINVAL) {
        fail("writing failed", errno);
    }
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) {
        fail("closing failed", errno);
    }
    if (std::rename(part_.c_str(), path_.c_str()) != 0) {
        fail("renaming failed", errno);
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
