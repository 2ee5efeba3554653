// SPDX-License-Identifier: MIT
#include "scenes/file/outlines/label_file.h"

#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/table_reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <regex>
#include <sstream>
#include <string_view>

namespace dsc::scenes {

namespace {

class LabelReader {
public:
    LabelReader(const std::string& content, const std::string& where)
        : content_(content), where_(where) {}

    LabelImage read() {
        using namespace std::string_view_literals;
        if (content_.starts_with("\x93NUMPY"sv)) {
            read_npy();
        } else if (content_.starts_with("P2") || content_.starts_with("P5")) {
            read_pgm();
        } else {
            read_text();
        }
        return std::move(image_);
    }

private:
    [[noreturn]] void refuse(const std::string& what, const std::string& value,
                             const std::string& allowed) const {
        throw InputError({.what = what, .where = where_, .value = value, .allowed = allowed});
    }

    void add(std::uint64_t label) {
        if (label > static_cast<std::uint64_t>(largest_phase)) {
            refuse("not a phase", std::to_string(label), "whole numbers from 0 to 1000000");
        }
        image_.labels.push_back(static_cast<Phase>(label));
    }
    void add(const std::string& word) {
        std::uint64_t label = 0;
        const char* end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data(), end, label);
        if (error != std::errc{} || stop != end) {
            refuse("not a phase", quoted_excerpt(word), "whole numbers from 0");
        }
        add(label);
    }

    // The bytes of `rows` * `columns` numbers from `begin` on.
    std::string_view bytes(std::size_t begin, std::size_t bytes_each) {
        const std::size_t there = begin <= content_.size() ? content_.size() - begin : 0;
        if (image_.columns == 0 || image_.rows != there / bytes_each / image_.columns ||
            image_.rows * image_.columns * bytes_each != there) {
            refuse("the data does not match the size of the image",
                   std::to_string(there) + " bytes",
                   std::to_string(image_.rows) + " rows of " + std::to_string(image_.columns) +
                       " numbers of " + std::to_string(bytes_each) + " bytes");
        }
        return std::string_view(content_).substr(begin);
    }
    static std::uint64_t number(std::string_view bytes, bool is_big_endian) {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            const char byte = bytes[is_big_endian ? i : bytes.size() - 1 - i];
            value = value << 8U | static_cast<unsigned char>(byte);
        }
        return value;
    }

    // https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
    void read_npy() {
        const bool is_short = content_.size() > 6 && content_[6] == 1;
        const std::size_t header = is_short ? 10 : 12;
        const std::size_t length =
            content_.size() < header
                ? 0
                : number(std::string_view(content_).substr(8, header - 8), false);
        const std::string text = content_.size() < header
                                     ? ""
                                     : content_.substr(header, std::min<std::size_t>(length, 4096));
        static const std::regex form(R"('descr': *'([<>|=])([iub])(\d)')");
        static const std::regex rows(R"('shape': *\((\d{1,9}), *(\d{1,9})\))");
        std::smatch type;
        std::smatch shape;
        if (!std::regex_search(text, type, form) || !std::regex_search(text, shape, rows)) {
            refuse("not an array of whole numbers in rows and columns", quoted_excerpt(text),
                   "an array of two dimensions and an integer type, by numpy.save");
        }
        image_.rows = std::stoul(shape[1]);
        image_.columns = std::stoul(shape[2]);
        const bool is_by_columns = text.find("'fortran_order': True") != std::string::npos;
        const std::size_t size = std::stoul(type[3]);
        if (size == 0 || size > 8) {
            refuse("not an integer type", type[0], "1 to 8 bytes");
        }
        const std::string_view data = bytes(header + length, size);
        for (std::size_t row = 0; row < image_.rows; ++row) {
            for (std::size_t column = 0; column < image_.columns; ++column) {
                const std::size_t i =
                    is_by_columns ? column * image_.rows + row : row * image_.columns + column;
                const std::uint64_t value = number(data.substr(i * size, size), type[1] == ">");
                if (type[2] == "i" && value >> (8 * size - 1) != 0) {
                    refuse("not a phase", "a negative number", "whole numbers from 0");
                }
                add(value);
            }
        }
    }

    // https://netpbm.sourceforge.net/doc/pgm.html
    void read_pgm() {
        const bool is_plain = content_[1] == '2';
        std::size_t at = 2;
        const auto word = [&] {
            while (at < content_.size() &&
                   (std::isspace(static_cast<unsigned char>(content_[at])) != 0 ||
                    content_[at] == '#')) {
                at = content_[at] == '#' ? std::min(content_.find('\n', at), content_.size())
                                         : at + 1;
            }
            const std::size_t begin = at;
            while (at < content_.size() &&
                   std::isspace(static_cast<unsigned char>(content_[at])) == 0) {
                ++at;
            }
            return content_.substr(begin, at - begin);
        };
        std::array<std::uint64_t, 3> header{}; // columns, rows, largest value
        for (std::uint64_t& value : header) {
            add(word());
            value = image_.labels.back();
        }
        image_.labels.clear();
        image_.columns = header[0];
        image_.rows = header[1];
        if (!is_plain) {
            const std::size_t size = header[2] < 256 ? 1 : 2;
            const std::string_view data = bytes(at + 1, size);
            for (std::size_t i = 0; i < data.size(); i += size) {
                add(number(data.substr(i, size), true));
            }
            return;
        }
        for (std::string text = word(); !text.empty(); text = word()) {
            add(text);
        }
        if (image_.labels.size() != image_.rows * image_.columns) {
            refuse("the data does not match the size of the image",
                   std::to_string(image_.labels.size()) + " numbers",
                   std::to_string(image_.rows) + " rows of " + std::to_string(image_.columns));
        }
    }

    void read_text() {
        std::istringstream lines(content_);
        std::string line;
        for (int number = 1; std::getline(lines, line); ++number) {
            std::string row = line.substr(0, line.find('#'));
            std::ranges::replace(row, ',', ' ');
            const std::size_t before = image_.labels.size();
            std::istringstream words(row);
            for (std::string word; words >> word;) {
                add(word);
            }
            const std::size_t count = image_.labels.size() - before;
            if (count == 0) {
                continue;
            }
            if (image_.rows++ > 0 && count != image_.columns) {
                refuse("rows have different lengths",
                       std::to_string(count) + " numbers in line " + std::to_string(number),
                       std::to_string(image_.columns) + " as in the rows before");
            }
            image_.columns = count;
        }
        if (image_.rows == 0) {
            refuse("the image has no pixels", quoted_excerpt(content_),
                   "a .npy, a .pgm, or rows of whole numbers");
        }
    }

    const std::string& content_;
    const std::string& where_;
    LabelImage image_;
};

} // namespace

LabelImage read_labels(const std::string& content, const std::string& where) {
    return LabelReader(content, where).read();
}

} // namespace dsc::scenes
