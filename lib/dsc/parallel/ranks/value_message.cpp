// SPDX-License-Identifier: MIT
#include "dsc/parallel/ranks/value_message.h"

#include "dsc/base/archive.h"

#include <numeric>

namespace dsc {

void write_values(MessageWriter& message, const AttributeSet& attributes,
                  const std::vector<std::uint32_t>& vertices) {
    message.list(vertices);
    if (vertices.empty()) {
        return;
    }
    for (const auto& attribute : attributes.list()) {
        if (attribute->kind() == SimplexKind::vertex) {
            const auto some = attribute->clone_empty();
            some->append(*attribute, vertices);
            Archive values;
            some->archive(values);
            message.text(values.bytes());
        }
    }
}

void read_values(MessageReader& message, AttributeSet& attributes) {
    std::vector<std::uint32_t> vertices;
    message.list(vertices);
    if (vertices.empty()) {
        return;
    }
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0U);
    for (const auto& attribute : attributes.list()) {
        if (attribute->kind() != SimplexKind::vertex) {
            continue;
        }
        const auto some = attribute->clone_empty();
        Archive values(message.text(), "the message of another rank");
        some->archive(values);
        const std::size_t bound = attribute->size();
        if (some->size() != vertices.size()) {
            throw InvariantError("another rank has other attributes than '" + attribute->name() +
                                 "'");
        }
        // An attribute copies entries of its own, so they are put at its end for a moment.
        attribute->append(*some, order);
        for (const std::uint32_t i : order) {
            if (vertices[i] >= bound) {
                throw InvariantError("another rank has a value of vertex " +
                                     std::to_string(vertices[i]) + ", which does not exist");
            }
            attribute->copy(vertices[i], static_cast<std::uint32_t>(bound) + i);
        }
        attribute->resize(bound);
    }
}

} // namespace dsc
