// SPDX-License-Identifier: MIT
// Serialisation. One function lists the members of a value, for writing and for reading, so that
// the two cannot disagree:
//
//     void archive(Archive& archive, Ball& ball) { archive(ball.place, ball.radius); }
//
// Little-endian machines only; numbers keep their bits. Input is not trusted: a length beyond the
// end, a flag that is neither 0 nor 1, or a number outside its enum throws FileError.
#pragma once

#include "dsc/base/types.h"

#include <array>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace dsc {

/// Bytes that grow as values are written, or shrink as they are read back in the same order.
class Archive {
public:
    /// Writes.
    Archive() = default;
    /// Reads. Errors refer to these bytes by `name`, the path of their file.
    Archive(std::string bytes, std::string name)
        : bytes_(std::move(bytes)), name_(std::move(name)), is_reading_(true) {}

    /// Whether values are read back rather than written.
    [[nodiscard]] bool is_reading() const { return is_reading_; }
    /// All bytes written so far; of an archive that reads, all bytes that it was given.
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

    /// Writes the values in their order, or reads them. Throws FileError as `refuse` does.
    template <class... Values>
    void operator()(Values&... values) {
        (visit(values), ...);
    }
    /// Archives an enum, or a number from 0 to count - 1.
    template <class Choice>
    void choice(Choice& value, std::uint32_t count) {
        auto number = static_cast<std::uint32_t>(value);
        raw(&number, sizeof number);
        expect(number < count, "number outside its enum");
        value = static_cast<Choice>(number);
    }
    /// Archives records without padding, as they are in memory. O(list), and fast.
    template <class Record>
    void records(std::vector<Record>& list) {
        static_assert(std::is_trivially_copyable_v<Record>);
        const std::uint64_t count = length(list.size(), sizeof(Record));
        if (is_reading_) {
            list.resize(count);
        }
        if (count > 0) {
            raw(list.data(), count * sizeof(Record));
        }
    }
    /// Writes `size`, the length of a list, or reads a length and returns it. Each entry takes at
    /// least `min_size` bytes: a length that the rest of the bytes cannot hold is refused.
    [[nodiscard]] std::uint64_t length(std::uint64_t size, std::size_t min_size);
    /// Archives `size` bytes, as they are in memory.
    void raw(void* data, std::size_t size);

    /// Throws FileError with this problem unless the condition holds.
    void expect(bool condition, const char* problem) const {
        if (!condition) {
            refuse(problem);
        }
    }
    /// Throws FileError: the bytes are damaged, or were written by something else.
    [[noreturn]] void refuse(const std::string& problem) const;
    /// Call after reading the last value: throws FileError if bytes are left.
    void expect_end() const;

private:
    template <class Value>
    void visit(Value& value) {
        constexpr int deepest = 64; // a file must not be able to exhaust the stack
        expect(++depth_ < deepest, "values nested too deeply");
        archive(*this, value);
        --depth_;
    }

    std::string bytes_;
    std::string name_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool is_reading_ = false;
};

/// Calls `transfer(archive)`. If it throws while reading, the values are restored from a backup in
/// memory, and the exception is passed on.
template <class Transfer>
void as_a_whole(Archive& archive, const Transfer& transfer) {
    Archive before;
    if (archive.is_reading()) {
        transfer(before);
    }
    try {
        transfer(archive);
    } catch (...) {
        if (archive.is_reading()) {
            Archive again(before.bytes(), "backup of the values before");
            transfer(again);
        }
        throw;
    }
}

/// A type that has an `archive` function.
template <class Value>
concept Archivable = requires(Archive& bytes, Value& value) {
    archive(bytes, value);
};

template <class Number>
requires(std::is_arithmetic_v<Number> &&
         !std::is_same_v<Number, bool>) void archive(Archive& archive, Number& value) {
    archive.raw(&value, sizeof value);
}

inline void archive(Archive& archive, bool& value) {
    std::uint8_t byte = value ? 1 : 0;
    archive.choice(byte, 2);
    value = byte == 1;
}

template <class Tag>
void archive(Archive& archive, Handle<Tag>& handle) {
    archive(handle.id);
}

template <class Real, int N>
void archive(Archive& archive, Eigen::Matrix<Real, N, 1>& point) {
    for (Real& coordinate : point) {
        archive(coordinate);
    }
}

void archive(Archive& archive, std::string& text);

template <class Value, std::size_t n>
requires Archivable<Value>
void archive(Archive& archive, std::array<Value, n>& list) {
    for (Value& value : list) {
        archive(value);
    }
}

template <class Value>
requires Archivable<Value>
void archive(Archive& archive, std::vector<Value>& list) {
    if constexpr (std::is_arithmetic_v<Value>) {
        archive.records(list);
    } else {
        const std::uint64_t count = archive.length(list.size(), 1);
        if (archive.is_reading()) {
            list.clear(); // filled one by one: the file's length is not trusted
        }
        for (std::uint64_t i = 0; i < count; ++i) {
            if (archive.is_reading()) {
                list.emplace_back();
            }
            archive(list[i]);
        }
    }
}

} // namespace dsc
