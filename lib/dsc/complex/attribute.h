// SPDX-License-Identifier: MIT
// Data that an application attaches to the simplices of one kind: contiguous, one array per
// attribute (thesis, sections 2.2 and 8.3), and kept in step by the operations themselves.
//
//   vertex attributes    a new vertex between a and b gets `blend(data[a], data[b], fraction)`
//   edge attributes      stored per corner; the halves of a split edge inherit, a new edge gets
//                        the attribute's default
//   triangle attributes  the parts of a split triangle inherit; a flip keeps the value of the id
//
// An application that needs more (a conserved quantity, say, or storage of its own) derives a class
// from `AttributeBase`.
#pragma once

#include "dsc/base/archive.h"
#include "dsc/base/types.h"

#include <concepts>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace dsc {

/// The dimension of a simplex.
enum class SimplexKind : std::uint8_t { vertex, edge, triangle };

/// The kind of a type of handles. Specialised by libraries that have handles of their own; in three
/// dimensions tets take the place of triangles.
template <class Handle>
struct HandleKind {};
/// Of vertices.
template <>
struct HandleKind<Vertex> {
    static constexpr SimplexKind value = SimplexKind::vertex; ///< the kind
};
/// Of edges.
template <>
struct HandleKind<Edge> {
    static constexpr SimplexKind value = SimplexKind::edge; ///< the kind
};
/// Of triangles.
template <>
struct HandleKind<Triangle> {
    static constexpr SimplexKind value = SimplexKind::triangle; ///< the kind
};

/// `Vertex`, `Edge`, `Triangle` and others that have a kind.
template <class Handle>
concept SimplexHandle = requires {
    HandleKind<Handle>::value;
};

/// The kind of a type of handles.
template <SimplexHandle Simplex>
inline constexpr SimplexKind kind_of = HandleKind<Simplex>::value;

/// What happens to a field's value at a vertex that moves with the interface.
enum class OnInterface : std::uint8_t {
    sampled,  ///< the vertex takes the value at its new position, as everywhere else
    advected, ///< the vertex keeps its value; for fields that matter only on the interface and
              ///< behind it
};

/// The base class of attributes: a complex and its operations report every edit to it. Entries are
/// named by vertex ids, corners (four to a triangle; both corners opposite to an edge are its
/// entries) or triangle ids. Operations on disjoint submeshes run at the same time: a function that
/// handles an edit may access only the entries named, and shared data only under a lock. An
/// exception that it throws is rethrown after the edit (`AttributeSet::failure`); its entry stays
/// as it left it.
class AttributeBase : public Unmovable {
public:
    /// The name and the kind do not change.
    AttributeBase(std::string name, SimplexKind kind) : name_(std::move(name)), kind_(kind) {}
    virtual ~AttributeBase() = default;

    /// The name under which it was added.
    [[nodiscard]] const std::string& name() const { return name_; }
    /// The kind of simplices that have a value.
    [[nodiscard]] SimplexKind kind() const { return kind_; }
    /// Whether the values of vertices are samples of a field in the plane: a vertex that a step
    /// moves then takes the value of its new place, blended in its star. Otherwise, and by default,
    /// it keeps its value, as it does after `set_position`.
    [[nodiscard]] bool is_field() const { return is_field_; }
    /// What happens to the values of a field at vertices that move with the interface. A vertex
    /// that smoothing moves inside a phase always takes the value of its new place.
    [[nodiscard]] OnInterface on_interface() const { return on_interface_; }
    /// Declares the values to be samples of a field, or not.
    void set_field(bool is_field, OnInterface on_interface = OnInterface::sampled) {
        is_field_ = is_field;
        on_interface_ = on_interface;
    }

    // --- storage
    /// The number of entries.
    [[nodiscard]] virtual std::size_t size() const = 0;
    /// Changes the number of entries; new ones take the initial value.
    virtual void resize(std::size_t size) = 0;
    /// Reserves room for `size` entries, so that growth up to that size copies nothing. Optional.
    virtual void reserve(std::size_t /*size*/) {}
    /// An attribute of the same class, name, kind, initial value and behaviour, without entries.
    [[nodiscard]] virtual std::unique_ptr<AttributeBase> clone_empty() const = 0;
    /// Appends the entries order[i] of an attribute of the same class; no_id: the initial value.
    virtual void append(const AttributeBase& from, const std::vector<std::uint32_t>& order) = 0;
    /// Swaps the entries, and nothing else, with an attribute of the same class.
    virtual void swap_entries(AttributeBase& other) noexcept = 0;
    /// Writes the entries, or reads them back (base/archive.h). Without an override it throws
    /// InputError: an attribute of this class cannot be part of a checkpoint.
    virtual void archive(Archive& archive);

    // --- edits of any kind of simplex
    /// The simplex `to` inherits from `from`.
    virtual void copy(std::uint32_t to, std::uint32_t from) = 0;
    /// The simplex is new: the entry takes the initial value.
    virtual void reset(std::uint32_t to) = 0;

    // --- edits of vertices
    /// `to` is new, at a + fraction (b - a).
    virtual void blend(std::uint32_t to, std::uint32_t a, [[maybe_unused]] std::uint32_t b,
                       [[maybe_unused]] double fraction) {
        copy(to, a);
    }

    // --- edits of triangles
    /// The triangle `to` is new, cut off from `from`; `share` is its fraction of their total area.
    virtual void split(std::uint32_t to, std::uint32_t from, [[maybe_unused]] double share) {
        copy(to, from);
    }
    /// `gone` vanishes; `into` is one of the triangles that replace it.
    virtual void merge([[maybe_unused]] std::uint32_t into, [[maybe_unused]] std::uint32_t gone) {}
    /// The common edge of the two triangles was flipped to the other diagonal; `share` is the
    /// fraction of `one` in their total area.
    virtual void flip([[maybe_unused]] std::uint32_t one, [[maybe_unused]] std::uint32_t other,
                      [[maybe_unused]] double share) {}

private:
    std::string name_;
    SimplexKind kind_;
    bool is_field_ = false;
    OnInterface on_interface_ = OnInterface::sampled;
};

/// The interpolator of a vertex attribute (thesis, section 8.9): the value at a + fraction (b - a).
template <class T>
using Blend = std::function<T(const T& a, const T& b, double fraction)>;

/// One value of type T for each simplex of a kind. Thread-safe for different simplices.
template <class T, SimplexHandle Simplex>
class Attribute final : public AttributeBase {
    static_assert(!std::is_same_v<T, bool>, "neighbouring bits race between threads: use uint8_t");
    static constexpr bool of_edges = std::same_as<Simplex, Edge>;

public:
    /// See `AttributeSet::add`.
    Attribute(std::string name, T initial, Blend<T> blend)
        : AttributeBase(std::move(name), kind_of<Simplex>), initial_(std::move(initial)),
          blend_(std::move(blend)) {}

    /// The value of a simplex, which is not checked. O(1).
    [[nodiscard]] const T& operator[](Simplex simplex) const { return data_[simplex.id]; }
    /// The same, writable. Not available for edges, which have two entries: see `set`.
    [[nodiscard]] T& operator[](Simplex simplex) requires(!of_edges) { return data_[simplex.id]; }
    /// Writes both entries of a living edge of this complex.
    template <class AnyComplex>
    void set(const AnyComplex& complex, Edge edge, const T& value) requires(of_edges) {
        data_[edge.id] = value;
        const Corner other = complex.twin(edge.id);
        if (!is_border(other)) {
            data_[other] = value;
        }
    }
    /// The value of the edge opposite to a corner.
    [[nodiscard]] const T& at_corner(Corner c) const requires(of_edges) { return data_[c]; }

    /// All values, by id (edges: by corner, both entries equal). `Eigen::Map` over data().data()
    /// costs nothing.
    [[nodiscard]] std::vector<T>& data() { return data_; }
    /// The same, read-only.
    [[nodiscard]] const std::vector<T>& data() const { return data_; }

    [[nodiscard]] std::size_t size() const override { return data_.size(); }
    void resize(std::size_t size) override { data_.resize(size, initial_); }
    void reserve(std::size_t size) override { data_.reserve(size); }
    [[nodiscard]] std::unique_ptr<AttributeBase> clone_empty() const override {
        return std::make_unique<Attribute>(name(), initial_, blend_);
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
    void archive(Archive& archive) override {
        if constexpr (Archivable<T> && std::is_default_constructible_v<T>) {
            archive(data_);
        } else {
            AttributeBase::archive(archive);
        }
    }
    void copy(std::uint32_t to, std::uint32_t from) override { data_[to] = data_[from]; }
    void reset(std::uint32_t to) override { data_[to] = initial_; }
    void blend(std::uint32_t to, std::uint32_t a, std::uint32_t b, double fraction) override {
        data_[to] = blend_ ? blend_(data_[a], data_[b], fraction) : data_[a];
    }

private:
    std::vector<T> data_;
    T initial_;
    Blend<T> blend_;
};

/// One value for each vertex.
template <class T>
using VertexAttribute = Attribute<T, Vertex>;
/// One value for each edge.
template <class T>
using EdgeAttribute = Attribute<T, Edge>;
/// One value for each triangle.
template <class T>
using TriangleAttribute = Attribute<T, Triangle>;

} // namespace dsc
