// SPDX-License-Identifier: MIT
// The attributes of a complex: added and found by name, notified of every edit. A complex without
// attributes of a kind pays one predictable branch for each edit of that kind.
#pragma once

#include "dsc/complex/attribute.h"

#include <array>
#include <atomic>
#include <exception>
#include <mutex>
#include <string>
#include <string_view>

namespace dsc {

/// The first exception that an attribute threw in an edit, on any thread. It is not copied or moved
/// with its object.
class AttributeFailure {
public:
    AttributeFailure() = default;
    /// Starts without an exception.
    AttributeFailure(const AttributeFailure& /*other*/) noexcept {}
    /// Changes nothing.
    AttributeFailure& operator=(const AttributeFailure& /*other*/) noexcept { return *this; }
    ~AttributeFailure() = default;

    /// Stores the exception being handled, unless one is stored already.
    void note() noexcept;
    /// Throws the stored exception, if any, and clears it. O(1).
    void rethrow() {
        if (is_there_.load(std::memory_order_relaxed)) [[unlikely]] {
            throw_kept();
        }
    }

private:
    void throw_kept();

    std::atomic<bool> is_there_ = false;
    std::mutex mutex_;
    std::exception_ptr first_;
};

/// The attributes of one complex. Copied with it.
class AttributeSet {
public:
    AttributeSet() = default;
    /// Copies the attributes with their entries.
    AttributeSet(const AttributeSet& other);
    /// Replaces all attributes; references to the old ones become invalid.
    AttributeSet& operator=(const AttributeSet& other);
    AttributeSet(AttributeSet&&) = default;
    AttributeSet& operator=(AttributeSet&&) = default;
    ~AttributeSet() = default;

    /// Adds an attribute, `add<Vertex>("heat", 20.0)`, and returns it; the reference stays valid
    /// until the attribute or its complex is destroyed. Throws InputError if the name is taken.
    /// `blend` empty: linear for floating point numbers and Eigen vectors, otherwise the value of
    /// the first vertex.
    template <SimplexHandle Simplex, class T>
    Attribute<T, Simplex>& add(std::string name, T initial,
                               std::type_identity_t<Blend<T>> blend = {});
    /// The same with the initial value T{}: `add<Vertex, double>("heat")`.
    template <SimplexHandle Simplex, class T>
    Attribute<T, Simplex>& add(std::string name) {
        return add<Simplex, T>(std::move(name), T{});
    }
    /// Adds an attribute of a class defined by the application, and resizes it. Throws InputError
    /// if it is null or the name is taken.
    template <std::derived_from<AttributeBase> Own>
    Own& add(std::unique_ptr<Own> attribute) {
        Own* const added = attribute.get();
        insert(std::move(attribute));
        return *added;
    }

    /// Whether there is an attribute of that name, of any kind.
    [[nodiscard]] bool contains(std::string_view name) const { return find(name) != nullptr; }
    /// The attribute of that name, kind and type, `get<Vertex, double>("heat")`; throws InputError
    /// if there is none.
    template <SimplexHandle Simplex, class T>
    [[nodiscard]] Attribute<T, Simplex>& get(std::string_view name) {
        return cast<Attribute<T, Simplex>>(name, kind_of<Simplex>);
    }
    /// The same, read-only.
    template <SimplexHandle Simplex, class T>
    [[nodiscard]] const Attribute<T, Simplex>& get(std::string_view name) const {
        return cast<Attribute<T, Simplex>>(name, kind_of<Simplex>);
    }
    /// The attribute of that name and class; throws InputError if there is none.
    template <std::derived_from<AttributeBase> Own>
    [[nodiscard]] Own& get(std::string_view name) {
        return cast<Own>(name, find_or_throw(name).kind());
    }
    /// Removes the attribute of that name. Throws InputError if there is none.
    void remove(std::string_view name);

    /// Whether there are no attributes.
    [[nodiscard]] bool empty() const { return list_.empty(); }
    /// Whether there is no attribute of that kind.
    [[nodiscard]] bool empty(SimplexKind kind) const { return counts_[index(kind)] == 0; }
    /// Whether an attribute of the vertices is a field (`AttributeBase::is_field`). O(attributes).
    [[nodiscard]] bool has_fields() const;
    /// All attributes, in the order in which they were added.
    [[nodiscard]] const std::vector<std::unique_ptr<AttributeBase>>& list() const { return list_; }

    /// The number of entries of an attribute of that kind, for ids below these bounds.
    [[nodiscard]] static std::size_t entries(SimplexKind kind, std::size_t vertex_bound,
                                             std::size_t triangle_bound) {
        return kind == SimplexKind::vertex ? vertex_bound
               : kind == SimplexKind::edge ? 4 * triangle_bound
                                           : triangle_bound;
    }

    /// An exception of an attribute does not interrupt the edit: the mesh, its log and the other
    /// attributes end up as without it. An operation called with a handle rethrows it at its end, a
    /// simulation at the end of its sub-step.
    AttributeFailure failure;

    // --- called by the operations; nothing happens if there is no attribute of the kind
    /// All ids are now below `bound`.
    void resize_vertices(std::size_t bound);
    /// All ids are now below `bound`.
    void resize_triangles(std::size_t bound);
    /// Reserves room for that many entries, so that growth up to that number copies nothing; also
    /// in attributes that are added later.
    void reserve(std::size_t vertex_bound, std::size_t triangle_bound);
    /// Vertex `to` is new, at a + fraction (b - a). See AttributeBase, as for the following ones.
    void blend_vertex(std::uint32_t to, std::uint32_t a, std::uint32_t b, double fraction) {
        tell(SimplexKind::vertex, [&](AttributeBase& each) { each.blend(to, a, b, fraction); });
    }
    /// Vertex v moves by this fraction of the way to `b`: its fields are blended. If it moves with
    /// the interface, fields that are advected there keep their values.
    void move_fields(std::uint32_t v, std::uint32_t b, double fraction, bool with_interface) {
        tell(SimplexKind::vertex, [&](AttributeBase& each) {
            if (each.is_field() &&
                !(with_interface && each.on_interface() == OnInterface::advected)) {
                each.blend(v, v, b, fraction);
            }
        });
    }
    /// Vertex `to` is new.
    void reset_vertex(std::uint32_t to) { reset(SimplexKind::vertex, to); }
    /// The edge at corner `to` inherits from the edge at corner `from`.
    void copy_edge(Corner to, Corner from) {
        tell(SimplexKind::edge, [&](AttributeBase& each) { each.copy(to, from); });
    }
    /// The edge at corner `to` is new.
    void reset_edge(Corner to) { reset(SimplexKind::edge, to); }
    /// Triangle `to` is new.
    void reset_triangle(std::uint32_t to) { reset(SimplexKind::triangle, to); }
    /// Triangle `to` inherits from `from`.
    void copy_triangle(std::uint32_t to, std::uint32_t from) {
        tell(SimplexKind::triangle, [&](AttributeBase& each) { each.copy(to, from); });
    }
    /// See AttributeBase; `share()` is called only if there is an attribute of this kind.
    template <class Share>
    void split_triangle(std::uint32_t to, std::uint32_t from, Share share) {
        tell(SimplexKind::triangle, [&](AttributeBase& each) { each.split(to, from, share()); });
    }
    /// Triangle `gone` vanishes and is replaced by `into`.
    void merge_triangle(std::uint32_t into, std::uint32_t gone) {
        tell(SimplexKind::triangle, [&](AttributeBase& each) { each.merge(into, gone); });
    }
    /// The two triangles have flipped their common edge.
    template <class Share>
    void flip_triangles(std::uint32_t one, std::uint32_t other, Share share) {
        tell(SimplexKind::triangle, [&](AttributeBase& each) { each.flip(one, other, share()); });
    }
    /// Entry i of the result is the old entry order[i]; no_id: the initial value.
    void permute(SimplexKind kind, const std::vector<std::uint32_t>& order);

    /// The same attributes, without entries.
    [[nodiscard]] AttributeSet without_entries() const;
    /// Swaps the entries with a set that `without_entries` made; the attributes stay where they
    /// are.
    void swap_entries(AttributeSet& other) noexcept;
    /// Writes the entries of all attributes, or reads them back into a set with the same
    /// attributes, in any order. Throws FileError if the attributes differ, InputError if one
    /// cannot be archived.
    void archive(Archive& archive);

private:
    static constexpr std::size_t index(SimplexKind kind) { return static_cast<std::size_t>(kind); }

    template <class Tell>
    void tell(SimplexKind kind, Tell one) {
        if (!empty(kind)) [[unlikely]] {
            tell_each(kind, one);
        }
    }
    // Out of line, so that hot loops stay small.
    template <class Tell>
    [[gnu::noinline]] void tell_each(SimplexKind kind, Tell one) {
        for (const auto& attribute : list_) {
            if (attribute->kind() == kind) {
                try {
                    one(*attribute);
                } catch (...) {
                    failure.note();
                }
            }
        }
    }
    void reset(SimplexKind kind, std::uint32_t to) {
        tell(kind, [&](AttributeBase& each) { each.reset(to); });
    }
    template <class Class>
    [[nodiscard]] Class& cast(std::string_view name, SimplexKind kind) const {
        AttributeBase& found = find_or_throw(name);
        auto* const typed = dynamic_cast<Class*>(&found);
        if (typed == nullptr) {
            refuse(name, found.kind() == kind ? "attribute holds another type"
                                              : "attribute belongs to another kind of simplex");
        }
        return *typed;
    }
    void insert(std::unique_ptr<AttributeBase> attribute);
    [[nodiscard]] AttributeBase* find(std::string_view name) const;
    [[nodiscard]] AttributeBase& find_or_throw(std::string_view name) const;
    [[noreturn]] static void refuse(std::string_view name, const char* problem);

    std::vector<std::unique_ptr<AttributeBase>> list_;
    std::array<std::uint32_t, 3> counts_{}; ///< by kind
    std::size_t vertex_bound_ = 0;
    std::size_t triangle_bound_ = 0;
    std::size_t vertex_room_ = 0; ///< reserved
    std::size_t triangle_room_ = 0;
};

template <SimplexHandle Simplex, class T>
Attribute<T, Simplex>& AttributeSet::add(std::string name, T initial,
                                         std::type_identity_t<Blend<T>> blend) {
    if (!blend) {
        if constexpr (std::is_floating_point_v<T> || requires(T a, double f) {
                          T(a + (a - a) * static_cast<typename T::Scalar>(f));
                      }) {
            blend = [](const T& a, const T& b, double fraction) {
                if constexpr (std::is_floating_point_v<T>) {
                    return static_cast<T>(a + (b - a) * fraction);
                } else {
                    return T(a + (b - a) * static_cast<typename T::Scalar>(fraction));
                }
            };
        }
    }
    return add(std::make_unique<Attribute<T, Simplex>>(std::move(name), std::move(initial),
                                                       std::move(blend)));
}

} // namespace dsc
