// SPDX-License-Identifier: MIT
#include "replay/edits.h"

#include "dsc/base/error.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>
#include <utility>

namespace dsc {

namespace {

constexpr std::string_view first_line = "dsc edits 1";
constexpr std::string_view trailer = "end ";

// The fields of one line, one after the other; `good` is false from the first bad one on.
class Fields {
public:
    explicit Fields(std::string_view line) : rest_(line) {}

    template <class Number>
    void read(Number& value) {
        while (!rest_.empty() && rest_.front() == ' ') {
            rest_.remove_prefix(1);
        }
        const char* end = rest_.data() + rest_.size();
        const auto [stop, error] = std::from_chars(rest_.data(), end, value);
        good = good && error == std::errc{} && (stop == end || *stop == ' ');
        rest_.remove_prefix(static_cast<std::size_t>(stop - rest_.data()));
    }
    [[nodiscard]] bool at_end() const { return rest_.empty(); }

    bool good = true;

private:
    std::string_view rest_;
};

bool parse(std::string_view line, Edit& edit) {
    const std::size_t space = line.find(' ');
    if (space == std::string_view::npos) {
        return false;
    }
    bool is_kind = false;
    for (int i = 0; i < edit_kind_count && !is_kind; ++i) {
        edit.kind = static_cast<EditKind>(i);
        is_kind = to_string(edit.kind) == line.substr(0, space);
    }
    Fields fields(line.substr(space + 1));
    std::uint32_t reason = 0;
    std::uint32_t on_interface = 0;
    fields.read(reason);
    fields.read(on_interface);
    fields.read(edit.corner);
    for (std::uint32_t* id :
         {&edit.vertex.id, &edit.ends[0].id, &edit.ends[1].id, &edit.apexes[0].id,
          &edit.apexes[1].id, &edit.made[0], &edit.made[1]}) {
        fields.read(*id);
    }
    fields.read(edit.x);
    fields.read(edit.y);
    if (!is_kind || !fields.good || !fields.at_end() || on_interface > 1 ||
        reason > static_cast<std::uint32_t>(MoveReason::giving_back) || !std::isfinite(edit.x) ||
        !std::isfinite(edit.y)) {
        return false;
    }
    edit.reason = static_cast<MoveReason>(reason);
    edit.on_interface = on_interface == 1;
    return true;
}

} // namespace

EditFile::EditFile(std::string path) : file_(std::move(path)) { file_ << first_line << '\n'; }

void EditFile::write(std::span<const Edit> edits) {
    for (const Edit& edit : edits) {
        file_ << to_string(edit.kind);
        for (const std::uint32_t field :
             {static_cast<std::uint32_t>(edit.reason), std::uint32_t{edit.on_interface},
              edit.corner, edit.vertex.id, edit.ends[0].id, edit.ends[1].id, edit.apexes[0].id,
              edit.apexes[1].id, edit.made[0], edit.made[1]}) {
            file_ << ' ' << field;
        }
        file_ << ' ' << edit.x << ' ' << edit.y << '\n';
    }
    count_ += edits.size();
}

void EditFile::commit() {
    file_ << trailer << count_ << '\n';
    file_.commit();
}

void write_edits(const std::string& path, std::span<const Edit> edits) {
    EditFile file(path);
    file.write(edits);
    file.commit();
}

std::vector<Edit> read_edits(const std::string& path) {
    errno = 0;
    std::ifstream file(path);
    if (!file) {
        throw FileError("cannot be opened for reading", path, errno);
    }
    std::string line;
    if (!std::getline(file, line) || line != first_line) {
        throw FileError(
            "not a log of edits: the first line is not '" + std::string(first_line) + "'", path);
    }
    std::vector<Edit> edits;
    while (std::getline(file, line)) {
        if (line.starts_with(trailer)) {
            Fields fields(std::string_view(line).substr(trailer.size()));
            std::uint64_t count = 0;
            fields.read(count);
            if (fields.good && fields.at_end() && count == edits.size()) {
                return edits;
            }
            throw FileError("ends with '" + line + "' after " + std::to_string(edits.size()) +
                                " records",
                            path);
        }
        Edit edit;
        if (!parse(line, edit)) {
            throw FileError("line " + std::to_string(edits.size() + 2) + " is not a record: '" +
                                line.substr(0, 80) + "'",
                            path);
        }
        edits.push_back(edit);
    }
    throw FileError("unexpected end of file after " + std::to_string(edits.size()) + " records",
                    path);
}

} // namespace dsc
