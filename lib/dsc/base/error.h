// SPDX-License-Identifier: MIT
// Errors that a caller can correct, the checks of options that throw them, and numbers in their
// messages. A refused operation is not an error: see `Verdict`.
#pragma once

#include "dsc/base/types.h"

#include <array>
#include <charconv>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace dsc {

/// Bad input: says what was wrong, where, the value that was given and what is allowed.
class InputError : public std::runtime_error {
public:
    /// The parts of the sentence, by name, because four strings in a row are easily swapped:
    /// `throw InputError({.what = "no bins", .where = "histogram", .value = "0", .allowed = "1"})`.
    struct Fields {
        std::string what;    ///< what was wrong
        std::string where;   ///< the function, option, file or shape
        std::string value;   ///< as it was given
        std::string allowed; ///< the values that would have been right
    };

    /// `what()` combines all fields into one sentence.
    explicit InputError(Fields fields)
        : std::runtime_error(fields.where + ": " + fields.what + ": got " + fields.value +
                             "; allowed: " + fields.allowed),
          fields_(std::move(fields)) {}

    /// The field `what` alone; `what()` is the whole sentence.
    [[nodiscard]] const std::string& problem() const { return fields_.what; }
    /// The function, option, file or shape.
    [[nodiscard]] const std::string& where() const { return fields_.where; }
    /// As it was given.
    [[nodiscard]] const std::string& value() const { return fields_.value; }
    /// The values that would have been right.
    [[nodiscard]] const std::string& allowed() const { return fields_.allowed; }

private:
    Fields fields_;
};

/// An error of the file system: an unwritable folder, a full disk, an unreadable or truncated file.
class FileError : public std::runtime_error {
public:
    /// `error` is the value of errno, whose text is appended, or 0.
    FileError(const std::string& what, const std::string& path, int error = 0)
        : std::runtime_error(path + ": " + what +
                             (error == 0 ? "" : ": " + std::generic_category().message(error))),
          path_(path), error_(error) {}

    /// The path of the file.
    [[nodiscard]] const std::string& path() const { return path_; }
    /// The value of errno; 0 if the system gave no reason.
    [[nodiscard]] int error() const { return error_; }

private:
    std::string path_;
    int error_;
};

/// A broken invariant of the library itself: a defect, never the caller's fault.
class InvariantError : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

/// The shortest digits that read back as the same number.
template <class Number>
[[nodiscard]] std::string to_text(Number value) {
    std::array<char, 64> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end.ptr};
}

/// The coordinates in brackets.
template <class Real>
[[nodiscard]] std::string to_text(const Point<Real>& point) {
    std::string words(1, '('); // GCC 12 warns of "(" + a temporary string (its bug 105651)
    words += to_text(point.x());
    words += ", ";
    words += to_text(point.y());
    words += ')';
    return words;
}

/// Throws InputError if `good` is false for this value of the option `name`.
inline void require(bool good, std::string_view name, double value, std::string_view allowed) {
    if (!good) {
        throw InputError({.what = "value out of range",
                          .where = std::string(name),
                          .value = to_text(value),
                          .allowed = std::string(allowed)});
    }
}

} // namespace dsc
