// SPDX-License-Identifier: MIT
#include "dsc/io/appended_data.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <string_view>

#include <zlib.h>

namespace dsc {

namespace {

/// Whole numbers of entries of any type. Larger ones compress no better.
constexpr std::size_t vtk_block_size = std::size_t{1} << 17U;
/// The files become a tenth larger than at zlib's default, in a third of the time.
constexpr int vtk_compression = 2;

std::string compressed(const char* bytes, std::size_t size) {
    uLongf length = compressBound(static_cast<uLong>(size));
    std::string block(length, '\0');
    const int code =
        compress2(reinterpret_cast<Bytef*>(block.data()), &length,
                  reinterpret_cast<const Bytef*>(bytes), static_cast<uLong>(size), vtk_compression);
    if (code != Z_OK) {
        throw InvariantError("zlib returns " + std::to_string(code) + " for " +
                             std::to_string(size) + " bytes");
    }
    block.resize(length);
    return block;
}

} // namespace

// The header: the number of blocks, the size of each before it was compressed, that of the last one
// if it is smaller (else 0), and the size of each afterwards. The header is padded separately.
std::size_t AppendedData::add_bytes(const char* bytes, std::size_t size) {
    const std::size_t offset = text_.size();
    std::vector<std::uint64_t> sizes{(size + vtk_block_size - 1) / vtk_block_size, vtk_block_size,
                                     size % vtk_block_size};
    std::string blocks;
    for (std::size_t at = 0; at < size; at += vtk_block_size) {
        const std::string block = compressed(bytes + at, std::min(vtk_block_size, size - at));
        sizes.push_back(block.size());
        blocks += block;
    }
    append_base64(text_, std::string(reinterpret_cast<const char*>(sizes.data()),
                                     sizes.size() * sizeof(std::uint64_t)));
    append_base64(text_, blocks);
    return offset;
}

void append_base64(std::string& text, const std::string& bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    text.reserve(text.size() + (bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            word = word << 8U | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += k <= count ? digits[word >> (18 - 6 * k) & 63U] : '=';
        }
    }
}

} // namespace dsc
