// SPDX-License-Identifier: MIT
// The data of VTK's XML files: arrays one after the other, each cut into blocks that zlib has
// compressed, with a header that says how long they are; in base64, so that the file is still XML.
#pragma once

#include <string>
#include <vector>

namespace dsc {

/// Collects arrays, which are written once all are known.
class AppendedData {
public:
    /// Appends an array and returns its offset, which its tag names. O(size).
    template <class Number>
    std::size_t add(const std::vector<Number>& numbers) {
        return add_bytes(reinterpret_cast<const char*>(numbers.data()),
                         numbers.size() * sizeof(Number));
    }
    /// All arrays in base64, without the underscore in front of the first.
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::size_t add_bytes(const char* bytes, std::size_t size);

    std::string text_;
};

/// Appends bytes as base64 (RFC 4648), padded.
void append_base64(std::string& text, const std::string& bytes);

} // namespace dsc
