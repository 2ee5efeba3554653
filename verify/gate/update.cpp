// SPDX-License-Identifier: MIT
#include "update.h"

#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"
#include "scenes/output/machine.h"

#include <algorithm>
#include <ctime>
#include <iterator>
#include <map>

namespace dsc::gate {

namespace {

/// Text that takes the place of what lies between two places.
struct Edit {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string text;
};

/// The bytes of a text by line and column, both from 1, as the parser counts them.
class Places {
public:
    explicit Places(const std::string& text) : text_(&text), lines_{0} {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '\n') {
                lines_.push_back(i + 1);
            }
        }
    }

    [[nodiscard]] std::size_t at(const toml::source_position& place) const {
        std::size_t byte = lines_.at(place.line - 1);
        for (toml::source_index column = 1; column < place.column; ++column) {
            do { // over a character of several bytes
                ++byte;
            } while (byte < text_->size() &&
                     (static_cast<unsigned char>((*text_)[byte]) & 0xc0U) == 0x80U);
        }
        return byte;
    }
    /// Where the next line begins.
    [[nodiscard]] std::size_t after_line(toml::source_index line) const {
        return line < lines_.size() ? lines_[line] : text_->size();
    }

private:
    const std::string* text_;
    std::vector<std::size_t> lines_;
};

// `known` says what need not be repeated, since the suite says it of the check.
std::string limit_text(const Band& band, const toml::table* known, const std::string& at) {
    const Limit& limit = band.limit;
    if (!limit.measured) {
        return to_text(limit.value);
    }
    const auto is_known = [&](const char* key, const auto& value) {
        return known != nullptr && (*known)[key].value<std::decay_t<decltype(value)>>() == value;
    };
    std::string text = std::string(band.check->at_least ? "{ at_least = " : "{ at_most = ") +
                       to_text(limit.value) + ", measured = " + few_digits(*limit.measured, 3);
    if (limit.rule != "required" && !is_known("rule", limit.rule)) {
        text += ", rule = \"" + limit.rule + '"';
    }
    if (limit.orders > 0 && !is_known("orders", static_cast<std::int64_t>(limit.orders))) {
        text += ", orders = " + std::to_string(limit.orders);
    }
    if (!limit.note.empty() && !is_known("note", limit.note)) {
        std::string note;
        for (const char c : limit.note) {
            note += c == '"' || c == '\\' ? std::string(1, '\\') + c : std::string(1, c);
        }
        text += ", note = \"" + note + '"';
    }
    return text + ", at = \"" + at + "\" }";
}

std::string place_text() {
    char day[16];
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    (void)gmtime_r(&now, &utc);
    (void)std::strftime(day, sizeof day, "%F", &utc);
    return "commit = \"" + scenes::commit() + "\"\ndate = " + day + "\nmachine = \"" +
           scenes::machine() + "\"\ncompiler = \"" + scenes::compiler() + "\"\n";
}

// The entry of [measured_at] for limits measured here and now: one that is there, or a new name.
std::string place_name(const toml::table& suite, bool& is_new) {
    const toml::table mine = toml::parse(place_text());
    for (int number = 1;; ++number) {
        const std::string name =
            scenes::commit() + (number == 1 ? "" : '-' + std::to_string(number));
        const toml::table* entry = suite["measured_at"][name].as_table();
        is_new = entry == nullptr;
        if (is_new || *entry == mine) {
            return name;
        }
    }
}

toml::source_index last_line(const toml::node& node) {
    toml::source_index line = std::max(node.source().begin.line, node.source().end.line);
    const auto look = [&](const toml::node& one) { line = std::max(line, last_line(one)); };
    if (const toml::table* table = node.as_table()) {
        for (const auto& entry : *table) {
            look(entry.second);
        }
    } else if (const toml::array* array = node.as_array()) {
        std::ranges::for_each(*array, look);
    }
    return line;
}

// Changes limits that are there, and adds others to those of their case.
std::vector<Edit> edits_of(const toml::table& suite, const Places& places, const toml::table& c,
                           const std::vector<const Band*>& bands, const std::string& at) {
    std::vector<Edit> edits;
    std::string added;
    const toml::table* limits = c["limits"].as_table();
    const bool is_inline = limits != nullptr && limits->is_inline();
    for (const Band* band : bands) {
        const std::string& name = band->check->name;
        const std::string text = limit_text(*band, suite["defaults"][name].as_table(), at);
        const toml::node* old = limits != nullptr ? limits->get(name) : nullptr;
        if (old != nullptr) {
            edits.push_back({places.at(old->source().begin), places.at(old->source().end), text});
        } else if (is_inline) {
            added += (limits->empty() && added.empty() ? " " : ", ") + name + " = " + text;
        } else {
            added += name + " = " + text + '\n';
        }
    }
    if (added.empty()) {
        return edits;
    }
    if (is_inline) {
        const std::size_t brace = places.at(limits->source().end) - 1;
        edits.push_back({brace, brace, added + ' '});
    } else if (limits != nullptr) {
        const std::size_t end = places.after_line(last_line(*limits));
        edits.push_back({end, end, added});
    } else {
        const std::size_t end = places.after_line(last_line(c));
        edits.push_back({end, end, "\n[case.limits]\n" + added});
    }
    return edits;
}

} // namespace

std::string with_limits(const std::string& text, const std::filesystem::path& path,
                        const std::vector<Band>& bands) {
    const std::string whole = text.empty() || text.back() == '\n' ? text : text + '\n';
    const toml::table suite = scenes::parse_toml(whole, path);
    const Places places(whole);
    bool is_new_place = false;
    const std::string at = place_name(suite, is_new_place);

    std::map<std::size_t, std::vector<const Band*>> by_case;
    for (const Band& band : bands) {
        if (!band.of->table) {
            throw InputError({.what = "a [[case]] of several scenes or sizes",
                              .where = path.string(),
                              .value = "'" + band.of->name + "'",
                              .allowed = "a [[case]] for each scene that limits are written for"});
        }
        by_case[*band.of->table].push_back(&band);
    }
    std::vector<Edit> edits;
    for (const auto& [number, of_case] : by_case) {
        const toml::node& node =
            suite["case"].is_array() ? *suite["case"].as_array()->get(number) : *suite.get("case");
        std::ranges::move(edits_of(suite, places, *node.as_table(), of_case, at),
                          std::back_inserter(edits));
    }
    std::ranges::sort(edits, std::ranges::greater{}, &Edit::begin);
    std::string result = whole;
    for (const Edit& edit : edits) {
        result.replace(edit.begin, edit.end - edit.begin, edit.text);
    }
    if (is_new_place && result.find("at = \"" + at + '"') != std::string::npos) {
        result += "\n[measured_at.\"" + at + "\"]\n" + place_text();
    }
    (void)read_suite_text(result, path);
    return result;
}

std::string new_suite(const std::string& scene) {
    return "# Proposed by `dsc_verify propose`: look at each limit before you commit it.\n"
           "[[case]]\nscene = \"" +
           scene + "\"\n";
}

} // namespace dsc::gate
