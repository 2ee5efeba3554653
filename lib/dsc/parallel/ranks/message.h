// SPDX-License-Identifier: MIT
// What ranks tell each other, as bytes: written and read back in the same order. All ranks run the
// same program on the same kind of machine, so numbers are copied as they lie in memory.
#pragma once

#include "dsc/base/error.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace dsc {

/// A message that grows. Its memory is kept from one message to the next.
class MessageWriter {
public:
    /// Begins another message.
    void clear() { size_ = 0; }
    /// The message so far.
    [[nodiscard]] std::span<const std::byte> bytes() const {
        return std::span<const std::byte>(bytes_).first(size_);
    }
    /// The byte at a place before the end, to be written later.
    [[nodiscard]] std::byte& at(std::size_t place) { return bytes_[place]; }

    /// A small number takes few bytes: seven bits in each.
    void count(std::uint64_t number) {
        std::byte* out = extend(most_of_count);
        while (number >= 0x80U) {
            *out++ = static_cast<std::byte>(number | 0x80U);
            number >>= 7U;
        }
        *out++ = static_cast<std::byte>(number);
        size_ = static_cast<std::size_t>(out - bytes_.data());
    }
    /// The values as they lie in memory.
    template <class... Values>
    void raw(const Values&... values) {
        std::byte* out = extend((sizeof values + ...));
        ((std::memcpy(out, &values, sizeof values), out += sizeof values), ...);
        size_ = static_cast<std::size_t>(out - bytes_.data());
    }
    /// The length, and the entries as they lie in memory.
    template <class Record>
    void list(std::span<const Record> records) {
        static_assert(std::is_trivially_copyable_v<Record>);
        count(records.size());
        if (!records.empty()) { // memcpy wants an address
            std::memcpy(extend(records.size_bytes()), records.data(), records.size_bytes());
            size_ += records.size_bytes();
        }
    }
    /// The length, and the entries.
    template <class Record>
    void list(const std::vector<Record>& records) {
        list(std::span<const Record>(records));
    }
    /// The length, and the characters.
    void text(const std::string& characters) {
        list(std::span<const char>(characters.data(), characters.size()));
    }

private:
    static constexpr std::size_t most_of_count = 10; // bytes of 64 bits, seven in each

    // Where so many bytes more may be written.
    std::byte* extend(std::size_t size) {
        if (bytes_.size() - size_ < size) {
            bytes_.resize(2 * (size_ + size));
        }
        return bytes_.data() + size_;
    }

    std::vector<std::byte> bytes_; // the message, and room behind it
    std::size_t size_ = 0;
};

/// A message that is read. Throws InvariantError where it ends too early.
class MessageReader {
public:
    MessageReader() = default;
    /// Refers to the bytes.
    explicit MessageReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    /// As `MessageWriter::count`.
    std::uint64_t count() {
        std::uint64_t number = 0;
        for (unsigned shift = 0; shift < 64; shift += 7) {
            const auto byte = std::to_integer<std::uint64_t>(*take(1));
            number |= (byte & 0x7fU) << shift;
            if (byte < 0x80U) {
                return number;
            }
        }
        throw InvariantError("a message of another rank has a number of more than 64 bits");
    }
    /// As `MessageWriter::raw`.
    template <class... Values>
    void raw(Values&... values) {
        (get(&values, sizeof values), ...);
    }
    /// One value.
    template <class Value>
    Value one() {
        Value value{};
        raw(value);
        return value;
    }
    /// As `MessageWriter::list`; replaces what was there.
    template <class Record>
    void list(std::vector<Record>& records) {
        static_assert(std::is_trivially_copyable_v<Record>);
        const std::uint64_t size = count();
        expect(size <= (bytes_.size() - at_) / sizeof(Record));
        records.resize(size);
        get(records.data(), size * sizeof(Record));
    }
    /// As `MessageWriter::text`.
    std::string text() {
        const std::uint64_t size = count();
        const std::byte* const data = take(size);
        std::string characters(size, '\0');
        if (size > 0) {
            std::memcpy(characters.data(), data, size);
        }
        return characters;
    }
    /// Whether all has been read.
    [[nodiscard]] bool is_at_end() const { return at_ == bytes_.size(); }

private:
    static void expect(bool holds) {
        if (!holds) {
            throw InvariantError("a message of another rank ends too early");
        }
    }
    const std::byte* take(std::size_t size) {
        expect(size <= bytes_.size() - at_);
        const std::byte* const data = bytes_.data() + at_;
        at_ += size;
        return data;
    }
    void get(void* data, std::size_t size) {
        if (size > 0) {
            std::memcpy(data, take(size), size);
        }
    }

    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

} // namespace dsc
