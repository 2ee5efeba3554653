// SPDX-License-Identifier: MIT
// State as bytes. One function lists the parts of a value; it both writes and reads them, so that
// the two cannot drift apart:
//
//     void archive(Archive& archive, Ball& ball) { archive(ball.place, ball.radius); }
//
// Bytes are little endian, as the machine must be; numbers keep their bits. Input is not trusted: a
// length beyond the end, a flag that is neither 0 nor 1, or a choice that does not exist is
// refused.
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
    /// Reads. `name` is what errors call these bytes: the path of their file.
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
    /// A choice of `count`: an enum or a number, from 0 to count - 1.
    template <class Choice>
    void choice(Choice& value, std::uint32_t count) {
        auto number = static_cast<std::uint32_t>(value);
        raw(&number, sizeof number);
        expect(number < count, "names a choice that does not exist");
        value = static_cast<Choice>(number);
    }
    /// Records without padding, as they lie in memory. O(list), and fast.
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
    /// The length of a list whose entries take `least` bytes or more: writes `size`, or returns
    /// what has been read.
    [[nodiscard]] std::uint64_t length(std::uint64_t size, std::size_t least);
    /// `size` bytes, as they lie in memory.
    void raw(void* data, std::size_t size);

    /// Refuses what has been read unless the condition holds.
    void expect(bool condition, const char* problem) const {
        if (!condition) {
            refuse(problem);
        }
    }
    /// Throws FileError: the bytes are not what was written, or belong to something else.
    [[noreturn]] void refuse(const std::string& problem) const;
    /// To be called after the last value has been read: nothing may be left.
    void expect_end() const;

private:
    template <class Value>
    void visit(Value& value) {
        constexpr int deepest = 64; // a file must not be able to exhaust the stack
        expect(++depth_ < deepest, "is nested too deeply");
        archive(*this, value);
        --depth_;
    }

    std::string bytes_;
    std::string name_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool is_reading_ = false;
};

/// Has `transfer(archive)` read its values as a whole or not at all: where it throws, what was
/// there before is read back. Writes as `transfer` does. Reading takes the memory of what was
/// there.
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
            Archive again(before.bytes(), "what was there before");
            transfer(again);
        }
        throw;
    }
}

/// What an archive can hold.
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

template <class Real>
void archive(Archive& archive, Eigen::Matrix<Real, 2, 1>& point) {
    archive(point.x(), point.y());
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
