// SPDX-License-Identifier: MIT
// Archives types of the standard library in results and frames; in the namespace of the archive, so
// that it finds them.
#pragma once

#include "dsc/base/archive.h"

#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace dsc {

template <class First, class Second>
void archive(Archive& archive, std::pair<First, Second>& pair) {
    archive(pair.first, pair.second);
}

template <class Value>
requires Archivable<Value>
void archive(Archive& archive, std::optional<Value>& value) {
    bool has_value = value.has_value();
    archive(has_value);
    if (archive.is_reading()) {
        value.reset();
        if (has_value) {
            value.emplace();
        }
    }
    if (has_value) {
        archive(*value);
    }
}

template <class Key, class Value>
void archive(Archive& archive, std::map<Key, Value>& map) {
    std::vector<std::pair<Key, Value>> list(map.begin(), map.end());
    archive(list);
    map = {list.begin(), list.end()};
}

template <class... Kinds>
void archive(Archive& archive, std::variant<Kinds...>& value) {
    std::size_t kind = value.index();
    archive.choice(kind, sizeof...(Kinds));
    if (archive.is_reading()) {
        std::size_t number = 0;
        ((number++ == kind ? static_cast<void>(value.template emplace<Kinds>()) : void()), ...);
    }
    std::visit([&](auto& one) { archive(one); }, value);
}

} // namespace dsc
