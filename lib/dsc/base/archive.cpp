// SPDX-License-Identifier: MIT
#include "dsc/base/archive.h"

#include "dsc/base/error.h"

namespace dsc {

static_assert(std::endian::native == std::endian::little, "an archive holds the bytes of memory");

void Archive::raw(void* data, std::size_t size) {
    if (!is_reading_) {
        bytes_.append(static_cast<const char*>(data), size);
        return;
    }
    expect(size <= bytes_.size() - at_, "unexpected end of data");
    std::memcpy(data, bytes_.data() + at_, size);
    at_ += size;
}

std::uint64_t Archive::length(std::uint64_t size, std::size_t min_size) {
    raw(&size, sizeof size);
    if (is_reading_) {
        expect(size <= (bytes_.size() - at_) / min_size, "unexpected end of data");
    }
    return size;
}

void Archive::refuse(const std::string& problem) const {
    throw FileError(problem, name_.empty() ? "archive" : name_);
}

void Archive::expect_end() const {
    expect(at_ == bytes_.size(), "trailing bytes after the last value");
}

void archive(Archive& archive, std::string& text) {
    const std::uint64_t size = archive.length(text.size(), 1);
    if (archive.is_reading()) {
        text.resize(size);
    }
    archive.raw(text.data(), size);
}

} // namespace dsc
