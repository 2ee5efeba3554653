// SPDX-License-Identifier: MIT
// Errors that a caller can correct. A refused operation is not an error: see verdict.h.
#pragma once

#include <stdexcept>
#include <string>

namespace dsc {

/// Bad input: says what was wrong, where, the value that was given and what is allowed.
class InputError : public std::runtime_error {
public:
    InputError(const std::string& what, const std::string& where, const std::string& value,
               const std::string& allowed)
        : std::runtime_error(where + ": " + what + ": got " + value + "; allowed: " + allowed),
          where_(where), value_(value), allowed_(allowed) {}

    [[nodiscard]] const std::string& where() const { return where_; }
    [[nodiscard]] const std::string& value() const { return value_; }
    [[nodiscard]] const std::string& allowed() const { return allowed_; }

private:
    std::string where_;
    std::string value_;
    std::string allowed_;
};

/// The file system refused: an unwritable folder, a full disk, an unreadable or truncated file.
class FileError : public std::runtime_error {
public:
    FileError(const std::string& what, const std::string& path)
        : std::runtime_error(path + ": " + what), path_(path) {}

    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::string path_;
};

/// A broken invariant of the library itself: a defect, never the caller's fault.
class InvariantError : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

} // namespace dsc
