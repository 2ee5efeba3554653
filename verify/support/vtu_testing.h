// SPDX-License-Identifier: MIT
// Reads back what write_vtu writes, in the simplest way, for tests.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <zlib.h>

namespace dsc::test {

inline std::string from_base64(const std::string& text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t word = 0;
    int bits = 0;
    for (const char c : text) {
        if (c == '=') {
            break;
        }
        const auto digit = digits.find(c);
        EXPECT_NE(digit, std::string::npos) << "not in base64: " << c;
        word = word << 6U | static_cast<std::uint32_t>(digit);
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes += static_cast<char>(word >> static_cast<unsigned>(bits) & 255U);
        }
    }
    return bytes;
}

/// A file of this library, as text.
struct VtuText {
    std::string text;

    /// The tag of the array of that name, as it is escaped; empty if there is none.
    [[nodiscard]] std::string tag(const std::string& name) const {
        const auto at = text.find("Name=\"" + name + "\"");
        if (at == std::string::npos) {
            return {};
        }
        const auto begin = text.rfind('<', at);
        return text.substr(begin, text.find('>', at) - begin + 1);
    }

    /// Its numbers, which must be of type `Number` (VTK calls it `type`).
    template <class Number>
    [[nodiscard]] std::vector<Number> numbers(const std::string& name,
                                              const std::string& type) const {
        const std::string found = tag(name);
        EXPECT_NE(found.find("type=\"" + type + "\""), std::string::npos) << name << ": " << found;
        const auto attribute = found.find("offset=\"");
        if (attribute == std::string::npos) {
            ADD_FAILURE() << "no such array: " << name;
            return {};
        }
        const auto data = text.find('_', text.find("<AppendedData encoding=\"base64\">")) + 1;
        const std::string bytes = inflate(data + std::stoul(found.substr(attribute + 8)));
        std::vector<Number> numbers(bytes.size() / sizeof(Number));
        if (!numbers.empty()) {
            std::memcpy(numbers.data(), bytes.data(), bytes.size());
        }
        return numbers;
    }

private:
    [[nodiscard]] static std::uint64_t word(const std::string& bytes, std::size_t i) {
        std::uint64_t value = 0;
        std::memcpy(&value, bytes.data() + 8 * i, 8);
        return value;
    }

    [[nodiscard]] std::string inflate(std::size_t at) const {
        const std::uint64_t blocks = word(from_base64(text.substr(at, 12)), 0);
        const std::size_t header_length = (8 * (3 + blocks) + 2) / 3 * 4;
        const std::string header = from_base64(text.substr(at, header_length));
        std::size_t packed_size = 0;
        for (std::size_t i = 0; i < blocks; ++i) {
            packed_size += word(header, 3 + i);
        }
        const std::string packed =
            from_base64(text.substr(at + header_length, (packed_size + 2) / 3 * 4));
        std::string bytes;
        std::size_t begin = 0;
        for (std::size_t i = 0; i < blocks; ++i) {
            const bool is_cut = i + 1 == blocks && word(header, 2) != 0;
            std::string block(word(header, is_cut ? 2 : 1), '\0');
            uLongf size = block.size();
            EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(block.data()), &size,
                                 reinterpret_cast<const Bytef*>(packed.data() + begin),
                                 word(header, 3 + i)),
                      Z_OK);
            EXPECT_EQ(size, block.size());
            begin += word(header, 3 + i);
            bytes += block;
        }
        return bytes;
    }
};

} // namespace dsc::test
