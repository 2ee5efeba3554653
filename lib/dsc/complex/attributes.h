// SPDX-License-Identifier: MIT
// Data that an application hangs on simplices: contiguous, one array per attribute [2.2, 8.3], and
// kept in step by the operations themselves. A complex without attributes pays one predictable
// branch per operation.
//
//   vertex attributes    a new vertex between a and b gets `blend(data[a], data[b], fraction)`
//   edge attributes      stored per corner; the halves of a split edge inherit, a new edge gets
//                        the attribute's default
//   triangle attributes  the parts of a split triangle inherit; a flip keeps the value of the id
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/corner.h"

#include <functional>
#include <memory>
#include <string>
#include <typeinfo>
#include <vector>

namespace dsc {

enum class SimplexKind : std::uint8_t { vertex, edge, triangle };

/// What the operations tell an attribute. Indices: vertex ids, corners (4 per triangle), triangles.
class AttributeBase {
public:
    AttributeBase(std::string name, SimplexKind kind) : name_(std::move(name)), kind_(kind) {}
    virtual ~AttributeBase() = default;
    AttributeBase(const AttributeBase&) = delete;
    AttributeBase& operator=(const AttributeBase&) = delete;
    AttributeBase(AttributeBase&&) = delete;
    AttributeBase& operator=(AttributeBase&&) = delete;

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] SimplexKind kind() const { return kind_; }

    [[nodiscard]] virtual std::size_t size() const = 0;
    virtual void resize(std::size_t size) = 0;
    virtual void reserve(std::size_t size) = 0;
    virtual void copy(std::uint32_t to, std::uint32_t from) = 0;
    virtual void reset(std::uint32_t to) = 0;
    virtual void blend(std::uint32_t to, std::uint32_t a, std::uint32_t b, double fraction) = 0;
    /// Entry i of the result is the old entry order[i].
    virtual void permute(const std::vector<std::uint32_t>& order) = 0;
    [[nodiscard]] virtual std::unique_ptr<AttributeBase> clone() const = 0;
    /// An attribute of the same name, kind, initial value and interpolator, without entries.
    [[nodiscard]] virtual std::unique_ptr<AttributeBase> clone_empty() const = 0;
    /// Appends the entries order[i] of an attribute of the same type; no_id: the initial value.
    virtual void append(const AttributeBase& from, const std::vector<std::uint32_t>& order) = 0;
    /// Swaps the entries, and nothing else, with an attribute of the same type.
    virtual void swap_entries(AttributeBase& other) noexcept = 0;
    [[nodiscard]] virtual const std::type_info& type() const = 0;

private:
    std::string name_;
    SimplexKind kind_;
};

/// The interpolator of an attribute [8.9]: the value at a + fraction (b - a).
template <class T>
using Blend = std::function<T(const T& a, const T& b, double fraction)>;

template <class T>
class Attribute final : public AttributeBase {
    static_assert(!std::is_same_v<T, bool>, "neighbouring bits race between threads: use uint8_t");

public:
    Attribute(std::string name, SimplexKind kind, T initial, Blend<T> blend)
        : AttributeBase(std::move(name), kind), initial_(std::move(initial)),
          blend_(std::move(blend)) {}

    T& operator[](Vertex v) { return data_[v.id]; }
    const T& operator[](Vertex v) const { return data_[v.id]; }
    T& operator[](Triangle t) { return data_[t.id]; }
    const T& operator[](Triangle t) const { return data_[t.id]; }
    /// Both halves of an edge hold the value; set it through `set_edge` of the complex's functions.
    T& at_corner(Corner c) { return data_[c]; }
    const T& operator[](Edge e) const { return data_[e.id]; }

    /// All values, by id (edges: by corner). `Eigen::Map` over data().data() costs nothing.
    [[nodiscard]] std::vector<T>& data() { return data_; }
    [[nodiscard]] const std::vector<T>& data() const { return data_; }

    [[nodiscard]] std::size_t size() const override { return data_.size(); }
    void resize(std::size_t size) override { data_.resize(size, initial_); }
    void reserve(std::size_t size) override { data_.reserve(size); }
    void copy(std::uint32_t to, std::uint32_t from) override { data_[to] = data_[from]; }
    void reset(std::uint32_t to) override { data_[to] = initial_; }
    void blend(std::uint32_t to, std::uint32_t a, std::uint32_t b, double fraction) override {
        data_[to] = blend_ ? blend_(data_[a], data_[b], fraction) : data_[a];
    }
    void permute(const std::vector<std::uint32_t>& order) override {
        std::vector<T> moved;
        moved.reserve(order.size());
        for (const std::uint32_t from : order) {
            moved.push_back(from == no_id ? initial_ : data_[from]);
        }
        data_ = std::move(moved);
    }
    [[nodiscard]] std::unique_ptr<AttributeBase> clone() const override {
        auto other = std::make_unique<Attribute>(name(), kind(), initial_, blend_);
        other->data_ = data_;
        return other;
    }
    [[nodiscard]] std::unique_ptr<AttributeBase> clone_empty() const override {
        return std::make_unique<Attribute>(name(), kind(), initial_, blend_);
    }
    void append(const AttributeBase& from, const std::vector<std::uint32_t>& order) override {
        const auto& data = static_cast<const Attribute&>(from).data_;
        for (const std::uint32_t entry : order) {
            data_.push_back(entry == no_id ? initial_ : data[entry]);
        }
    }
    void swap_entries(AttributeBase& other) noexcept override {
        data_.swap(static_cast<Attribute&>(other).data_);
    }
    [[nodiscard]] const std::type_info& type() const override { return typeid(T); }

private:
    std::vector<T> data_;
    T initial_;
    Blend<T> blend_;
};

/// The attributes of one complex. Copied with it.
class AttributeSet {
public:
    AttributeSet() = default;
    AttributeSet(const AttributeSet& other);
    AttributeSet& operator=(const AttributeSet& other);
    AttributeSet(AttributeSet&&) = default;
    AttributeSet& operator=(AttributeSet&&) = default;
    ~AttributeSet() = default;

    /// Adds an attribute and returns it; the reference stays valid while the complex lives.
    /// Throws InputError where the name is taken. `blend` empty: linear for arithmetic types and
    /// Eigen vectors, otherwise the value of the first vertex.
    template <class T>
    Attribute<T>& add(std::string name, SimplexKind kind, T initial = T{}, Blend<T> blend = {});
    /// The attribute of that name and type; throws InputError where there is none.
    template <class T>
    Attribute<T>& get(const std::string& name);
    void remove(const std::string& name);

    [[nodiscard]] bool empty() const { return list_.empty(); }
    [[nodiscard]] const std::vector<std::unique_ptr<AttributeBase>>& list() const { return list_; }

    // Told by the operations; nothing happens where there is no attribute of the kind.
    void resize_vertices(std::size_t bound);
    void resize_triangles(std::size_t bound);
    /// Room for so many entries, so that growth up to there copies nothing.
    void reserve(std::size_t vertex_bound, std::size_t triangle_bound);
    void blend_vertex(std::uint32_t to, std::uint32_t a, std::uint32_t b, double fraction) {
        if (!list_.empty()) {
            tell_blend(to, a, b, fraction);
        }
    }
    void copy_triangle(std::uint32_t to, std::uint32_t from) {
        if (!list_.empty()) {
            tell_copy(SimplexKind::triangle, to, from);
        }
    }
    void copy_edge(Corner to, Corner from) {
        if (!list_.empty()) {
            tell_copy(SimplexKind::edge, to, from);
        }
    }
    void reset_edge(Corner to) {
        if (!list_.empty()) {
            tell_reset(SimplexKind::edge, to);
        }
    }
    void reset_vertex(std::uint32_t to) {
        if (!list_.empty()) {
            tell_reset(SimplexKind::vertex, to);
        }
    }
    void reset_triangle(std::uint32_t to) {
        if (!list_.empty()) {
            tell_reset(SimplexKind::triangle, to);
        }
    }
    /// Entry i of the result is the old entry order[i]; no_id: the initial value.
    void permute(SimplexKind kind, const std::vector<std::uint32_t>& order);

    // For complexes that are divided and merged; the sets must be clones of each other.
    /// The same attributes without entries.
    [[nodiscard]] AttributeSet clone_empty() const;
    /// Appends the entries order[i] of `from`; no_id: the initial value.
    void append(SimplexKind kind, const AttributeSet& from,
                const std::vector<std::uint32_t>& order);
    /// Swaps the entries; references to the attributes of either set stay what they are.
    void swap_entries(AttributeSet& other) noexcept;

private:
    void insert(std::unique_ptr<AttributeBase> attribute);
    [[nodiscard]] AttributeBase* find(const std::string& name) const;
    void tell_blend(std::uint32_t to, std::uint32_t a, std::uint32_t b, double fraction);
    void tell_copy(SimplexKind kind, std::uint32_t to, std::uint32_t from);
    void tell_reset(SimplexKind kind, std::uint32_t to);
    [[noreturn]] static void throw_missing(const std::string& name, const char* problem);

    std::vector<std::unique_ptr<AttributeBase>> list_;
    std::size_t vertex_bound_ = 0;
    std::size_t triangle_bound_ = 0;
};

template <class T>
Attribute<T>& AttributeSet::add(std::string name, SimplexKind kind, T initial, Blend<T> blend) {
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
    auto attribute =
        std::make_unique<Attribute<T>>(std::move(name), kind, std::move(initial), std::move(blend));
    auto& reference = *attribute;
    insert(std::move(attribute));
    return reference;
}

template <class T>
Attribute<T>& AttributeSet::get(const std::string& name) {
    AttributeBase* found = find(name);
    if (found == nullptr) {
        throw_missing(name, "no such attribute");
    }
    if (found->type() != typeid(T)) {
        throw_missing(name, "attribute holds another type");
    }
    return static_cast<Attribute<T>&>(*found);
}

} // namespace dsc
