// SPDX-License-Identifier: MIT
#include "update.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <sstream>

namespace dsc::gate {

namespace {

/// A text that replaces the characters from `begin` to `end`.
struct Edit {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string text;
};

// The offset of a position of the parser, which counts lines and columns from 1, and columns in
// characters of one or several bytes.
std::size_t byte_at(const std::string& text, const toml::source_position& place) {
    std::size_t byte = 0;
    for (toml::source_index line = 1; line < place.line; ++line) {
        byte = text.find('\n', byte) + 1;
    }
    for (toml::source_index column = 1; column < place.column; ++column) {
        do {
            ++byte;
        } while (byte < text.size() && (static_cast<unsigned char>(text[byte]) & 0xc0U) == 0x80U);
    }
    return byte;
}

constexpr std::size_t counts_per_line = 10;

// Entries that equal those of `known`, the suite's defaults of the check, are left out.
std::string limit_text(const Band& band, const toml::table* known) {
    const Limit& limit = band.limit;
    if (!limit.measured) {
        return to_text(limit.value);
    }
    std::ostringstream text;
    const auto add = [&](const char* key, const auto& value) {
        if (known == nullptr || (*known)[key].value<std::decay_t<decltype(value)>>() != value) {
            const toml::value node(value);
            text << ", " << key << " = "
                 << toml::toml_formatter(node, toml::format_flags::allow_unicode_strings);
        }
    };
    text << (band.check->at_least ? "{ at_least = " : "{ at_most = ") << to_text(limit.value)
         << ", measured = " << few_digits(*limit.measured, 3);
    if (limit.around) {
        text << ", around = " << to_text(*limit.around);
    }
    if (!limit.histogram.empty()) {
        text << ", histogram = [";
        for (std::size_t i = 0; i < limit.histogram.size(); ++i) {
            text << (i == 0 ? "" : ",") << (i % counts_per_line == 0 ? "\n    " : " ")
                 << limit.histogram[i];
        }
        text << ']';
    }
    if (limit.rule != "required") {
        add("rule", limit.rule);
    }
    if (limit.orders > 0) {
        add("orders", static_cast<std::int64_t>(limit.orders));
    }
    if (!limit.note.empty()) {
        add("note", limit.note);
    }
    if (!limit.at.empty()) {
        add("at", limit.at);
    }
    text << " }";
    return text.str();
}

// Replaces an existing limit. A new one is inserted after the head of the table of limits, or,
// without such a table, as a key after the scene.
Edit edit_of(const std::string& text, const toml::table& suite, const Band& band) {
    const toml::node& whole = *suite.get("case");
    const toml::table& c =
        *(whole.is_array() ? *whole.as_array()->get(*band.of->table) : whole).as_table();
    const toml::table* limits = c["limits"].as_table();
    const std::string& name = band.check->name;
    const std::string entry = limit_text(band, suite["defaults"][name].as_table());
    if (limits != nullptr && limits->contains(name)) {
        const toml::source_region& old = limits->get(name)->source();
        return {byte_at(text, old.begin), byte_at(text, old.end), entry};
    }
    if (limits != nullptr && limits->is_inline()) {
        const std::size_t inside = byte_at(text, limits->source().begin) + 1;
        return {inside, inside, ' ' + name + " = " + entry + ','};
    }
    const bool has_head = limits != nullptr && text[byte_at(text, limits->source().begin)] == '[';
    const toml::node& before = has_head ? *limits : *c.get("scene");
    const std::size_t behind = byte_at(text, {before.source().end.line + 1, 1});
    return {behind, behind, (has_head ? "" : "limits.") + name + " = " + entry + '\n'};
}

} // namespace

void check_writable(const std::vector<Wanted>& limits, const std::filesystem::path& path) {
    for (const Wanted& one : limits) {
        if (!one.of->table) {
            throw InputError(
                {.what = "the [[case]] has several scenes or sizes",
                 .where = path.string(),
                 .value = "'" + one.of->name + "'",
                 .allowed = "one [[case]] for each scene and size whose limits are written"});
        }
    }
}

std::string with_limits(const std::string& text, const std::filesystem::path& path,
                        const std::vector<Band>& bands) {
    std::string result = text.ends_with('\n') ? text : text + '\n';
    const toml::table suite = scenes::parse_toml(result, path);
    std::vector<Edit> edits;
    for (const Band& band : bands) {
        edits.push_back(edit_of(result, suite, band));
    }
    // Edits are applied from the end backwards, so that earlier offsets stay valid.
    std::ranges::stable_sort(edits, {}, &Edit::begin);
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
        result.replace(edit->begin, edit->end - edit->begin, edit->text);
    }
    (void)read_suite_text(result, path);
    return result;
}

} // namespace dsc::gate
