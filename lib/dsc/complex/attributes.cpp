// SPDX-License-Identifier: MIT
#include "dsc/complex/attributes.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace dsc {

void AttributeBase::archive(Archive& /*archive*/) {
    throw InputError({.what = "attribute cannot be part of a checkpoint",
                      .where = "archive",
                      .value = "'" + name_ + "'",
                      .allowed = "entries of a type that has an archive function"});
}

void AttributeFailure::note() noexcept {
    const std::scoped_lock lock(mutex_);
    if (!first_) {
        first_ = std::current_exception();
        is_there_.store(true, std::memory_order_relaxed);
    }
}

void AttributeFailure::throw_kept() {
    std::exception_ptr first;
    {
        const std::scoped_lock lock(mutex_);
        first.swap(first_);
        is_there_.store(false, std::memory_order_relaxed);
    }
    if (first) {
        std::rethrow_exception(first);
    }
}

namespace {

// An attribute of the same behaviour with the entries order[i]; no_id: the initial value.
std::unique_ptr<AttributeBase> taken_from(const AttributeBase& attribute,
                                          const std::vector<std::uint32_t>& order) {
    auto taken = attribute.clone_empty();
    taken->set_field(attribute.is_field(), attribute.on_interface());
    taken->reserve(order.size());
    taken->append(attribute, order);
    return taken;
}

} // namespace

AttributeSet::AttributeSet(const AttributeSet& other)
    : counts_(other.counts_), vertex_bound_(other.vertex_bound_),
      triangle_bound_(other.triangle_bound_) {
    std::vector<std::uint32_t> all;
    for (const auto& attribute : other.list_) {
        all.resize(attribute->size());
        std::iota(all.begin(), all.end(), 0U);
        list_.push_back(taken_from(*attribute, all));
    }
}

AttributeSet& AttributeSet::operator=(const AttributeSet& other) {
    if (this != &other) {
        AttributeSet copy(other);
        *this = std::move(copy);
    }
    return *this;
}

void AttributeSet::insert(std::unique_ptr<AttributeBase> attribute) {
    if (attribute == nullptr) {
        refuse("", "null pointer");
    }
    if (find(attribute->name()) != nullptr) {
        refuse(attribute->name(), "an attribute of that name exists");
    }
    attribute->reserve(entries(attribute->kind(), vertex_room_, triangle_room_));
    attribute->resize(entries(attribute->kind(), vertex_bound_, triangle_bound_));
    list_.push_back(std::move(attribute));
    ++counts_[index(list_.back()->kind())];
}

bool AttributeSet::has_fields() const {
    return std::ranges::any_of(list_, [](const auto& attribute) {
        return attribute->kind() == SimplexKind::vertex && attribute->is_field();
    });
}

AttributeBase* AttributeSet::find(std::string_view name) const {
    for (const auto& attribute : list_) {
        if (attribute->name() == name) {
            return attribute.get();
        }
    }
    return nullptr;
}

AttributeBase& AttributeSet::find_or_throw(std::string_view name) const {
    AttributeBase* const found = find(name);
    if (found == nullptr) {
        refuse(name, "no such attribute");
    }
    return *found;
}

void AttributeSet::remove(std::string_view name) {
    --counts_[index(find_or_throw(name).kind())];
    std::erase_if(list_, [&](const auto& attribute) { return attribute->name() == name; });
}

void AttributeSet::resize_vertices(std::size_t bound) {
    vertex_bound_ = bound;
    for (const auto& attribute : list_) {
        if (attribute->kind() == SimplexKind::vertex) {
            attribute->resize(bound);
        }
    }
}

void AttributeSet::resize_triangles(std::size_t bound) {
    triangle_bound_ = bound;
    for (const auto& attribute : list_) {
        if (attribute->kind() != SimplexKind::vertex) {
            attribute->resize(entries(attribute->kind(), vertex_bound_, bound));
        }
    }
}

void AttributeSet::reserve(std::size_t vertex_bound, std::size_t triangle_bound) {
    vertex_room_ = vertex_bound;
    triangle_room_ = triangle_bound;
    for (const auto& attribute : list_) {
        attribute->reserve(entries(attribute->kind(), vertex_bound, triangle_bound));
    }
}

void AttributeSet::permute(SimplexKind kind, const std::vector<std::uint32_t>& order) {
    std::vector<std::unique_ptr<AttributeBase>> permuted; // all of them, or none
    for (const auto& attribute : list_) {
        if (attribute->kind() == kind) {
            permuted.push_back(taken_from(*attribute, order));
        }
    }
    for (auto entries = permuted.begin(); const auto& attribute : list_) {
        if (attribute->kind() == kind) {
            attribute->swap_entries(**entries++);
        }
    }
    if (kind == SimplexKind::vertex) {
        vertex_bound_ = order.size();
    } else if (kind == SimplexKind::triangle) {
        triangle_bound_ = order.size();
    }
}

AttributeSet AttributeSet::without_entries() const {
    AttributeSet empty;
    for (const auto& attribute : list_) {
        empty.insert(taken_from(*attribute, {}));
    }
    return empty;
}

void AttributeSet::swap_entries(AttributeSet& other) noexcept {
    for (std::size_t i = 0; i < list_.size(); ++i) {
        list_[i]->swap_entries(*other.list_[i]);
    }
    std::swap(vertex_bound_, other.vertex_bound_);
    std::swap(triangle_bound_, other.triangle_bound_);
}

void AttributeSet::archive(Archive& archive) {
    std::uint64_t count = list_.size();
    archive(count, vertex_bound_, triangle_bound_);
    archive.expect(count == list_.size(), "the attributes differ from those of this complex");
    for (const auto& listed : list_) {
        std::string name = listed->name();
        SimplexKind kind = listed->kind();
        archive(name);
        archive.choice(kind, 3);
        AttributeBase* const attribute = find(name);
        archive.expect(attribute != nullptr && kind == attribute->kind(),
                       "the attributes differ from those of this complex");
        attribute->archive(archive);
    }
}

void AttributeSet::refuse(std::string_view name, const char* problem) {
    throw InputError(
        {.what = problem,
         .where = "attribute",
         .value = "'" + std::string(name) + "'",
         .allowed = "name, kind and type of an existing attribute, or a new name to add"});
}

} // namespace dsc
