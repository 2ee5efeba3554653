// SPDX-License-Identifier: MIT
// Decodes a fuzzer's bytes to numbers. After the last byte all numbers are 0, so an input means the
// same as a longer one that ends with zeros.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace dsc::fuzz {

class Bytes {
public:
    explicit Bytes(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

    [[nodiscard]] bool empty() const { return rest_.empty(); }
    std::uint8_t byte() {
        if (rest_.empty()) {
            return 0;
        }
        const std::uint8_t first = rest_.front();
        rest_ = rest_.subspan(1);
        return first;
    }
    /// A number from 0 to `bound` - 1, from one byte if that is enough, otherwise from two.
    std::uint32_t below(std::uint32_t bound) {
        std::uint32_t value = byte();
        if (bound > 256) {
            value = value << 8U | byte();
        }
        return bound == 0 ? 0 : value % bound;
    }
    /// A number from one byte: low, high, or one of 254 numbers between them.
    double in(double low, double high) { return low + (high - low) * byte() / 255; }
    /// The rest of the bytes.
    std::string text() {
        std::string all(rest_.begin(), rest_.end());
        rest_ = {};
        return all;
    }

private:
    std::span<const std::uint8_t> rest_;
};

} // namespace dsc::fuzz
