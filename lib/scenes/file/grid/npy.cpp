// SPDX-License-Identifier: MIT
// The format is described in NumPy's own documentation, numpy.lib.format.
#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/grid/grid_files.h"

#include <bit>
#include <charconv>
#include <cstring>

namespace dsc::scenes {

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view npy_magic = "\x93NUMPY";

/// The header, a literal of Python, and the numbers after it.
struct NpyParts {
    std::string_view header;
    std::string_view data;
};

class NpyReader {
public:
    NpyReader(std::string_view bytes, const std::string& where) : bytes_(bytes), where_(where) {}

    GridValues read(const std::vector<double>& times) {
        const NpyParts parts = split();
        if (value_of(parts.header, "fortran_order").substr(0, 5) != "False") {
            refuse("order of the array", parts.header, "C order: numpy.ascontiguousarray");
        }
        std::vector<std::size_t> shape = shape_of(parts.header);
        if (shape.size() == 3) {
            shape.insert(shape.begin(), 1);
        }
        if (shape.size() != 4 || shape[3] != 2) {
            refuse("shape of the array", parts.header, "(times, rows, columns, 2)");
        }
        GridValues grid;
        grid.rows = shape[1];
        grid.columns = shape[2];
        if (times.empty() ? shape[0] != 1 : times.size() != shape[0]) {
            refuse("number of times", std::to_string(times.size()),
                   "the " + std::to_string(shape[0]) + " times of the array");
        }
        grid.times = times.empty() ? std::vector<double>{0} : times;
        const std::size_t count = shape[0] * shape[1] * shape[2];
        const std::string_view type = value_of(parts.header, "descr");
        if (type.starts_with("'<f8'")) {
            grid.velocities = numbers<double>(parts.data, count);
        } else if (type.starts_with("'<f4'")) {
            grid.velocities = numbers<float>(parts.data, count);
        } else {
            refuse("type of the numbers", parts.header, "'<f8' or '<f4'");
        }
        return grid;
    }

private:
    [[noreturn]] void refuse(const std::string& what, std::string_view value,
                             const std::string& allowed) const {
        throw InputError(
            {.what = what, .where = where_, .value = quoted_excerpt(value), .allowed = allowed});
    }

    [[nodiscard]] NpyParts split() const {
        const bool is_npy = bytes_.size() >= 12 && bytes_.starts_with(npy_magic);
        const int version = is_npy ? bytes_[6] : 0;
        if (version != 1 && version != 2) {
            refuse("no NumPy array", bytes_.substr(0, 8), "a file written by numpy.save");
        }
        const std::size_t begin = version == 1 ? 10 : 12;
        std::size_t length = 0;
        for (std::size_t i = begin; i-- > 8;) {
            length = 256 * length + static_cast<unsigned char>(bytes_[i]);
        }
        if (length > bytes_.size() - begin) {
            refuse("file cut short", bytes_.substr(0, 8), "the whole file");
        }
        return {bytes_.substr(begin, length), bytes_.substr(begin + length)};
    }

    [[nodiscard]] std::string_view value_of(std::string_view header, std::string_view key) const {
        const std::string quoted = in_single_quotes(key) + ':';
        const std::size_t found = header.find(quoted);
        if (found == std::string_view::npos) {
            refuse("bad header", header, "with " + quoted);
        }
        std::string_view value = header.substr(found + quoted.size());
        value.remove_prefix(std::min(value.find_first_not_of(' '), value.size()));
        return value;
    }

    // No dimension is larger than the file, so that their product does not overflow.
    [[nodiscard]] std::vector<std::size_t> shape_of(std::string_view header) const {
        std::string_view text = value_of(header, "shape");
        text = text.substr(0, text.find(')'));
        std::vector<std::size_t> shape;
        std::size_t product = 1;
        for (std::size_t at = text.find_first_of("0123456789"); at != std::string_view::npos;
             at = text.find_first_of("0123456789")) {
            std::size_t size = 0;
            const auto [stop, error] =
                std::from_chars(text.data() + at, text.data() + text.size(), size);
            if (error != std::errc{} || size == 0 || size > bytes_.size() / product) {
                refuse("shape of the array", header, "as many numbers as the file has");
            }
            product *= size;
            shape.push_back(size);
            text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
        }
        return shape;
    }

    template <class Number>
    [[nodiscard]] std::vector<Point<double>> numbers(std::string_view data,
                                                     std::size_t count) const {
        if (data.size() != 2 * count * sizeof(Number)) {
            refuse("size of the data", std::to_string(data.size()) + " bytes",
                   std::to_string(2 * count * sizeof(Number)));
        }
        std::vector<Point<double>> points(count);
        for (std::size_t i = 0; i < count; ++i) {
            std::array<Number, 2> pair;
            std::memcpy(pair.data(), data.data() + i * sizeof pair, sizeof pair);
            points[i] = {static_cast<double>(pair[0]), static_cast<double>(pair[1])};
        }
        return points;
    }

    std::string_view bytes_;
    const std::string& where_;
};

} // namespace

GridValues read_npy(std::string_view bytes, const std::vector<double>& times,
                    const std::string& where) {
    return NpyReader(bytes, where).read(times);
}

} // namespace dsc::scenes
