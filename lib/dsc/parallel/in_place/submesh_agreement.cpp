// SPDX-License-Identifier: MIT
// Whether all ranks hold the same: the complex, and everything of the submeshes that a later
// section or step reads. A test of the library itself, O(mesh) each time; see
// SubmeshOptions::checks_ranks.
#include "dsc/complex/ranges.h"
#include "dsc/parallel/in_place/submesh_ranks.h"

#include <algorithm>
#include <string>

namespace dsc {

namespace {

/// One thing that has to agree: its name, and its entries as bytes.
struct Item {
    std::string name;
    std::string bytes;
    std::size_t entry = 4; ///< bytes of an entry, which begins with its id
};

// Fowler, Noll and Vo's hash.
std::uint64_t hash_of(const std::string& bytes) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char byte : bytes) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    }
    return hash;
}

template <class... Values>
void put(std::string& bytes, const Values&... values) {
    const auto one = [&bytes](const auto& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    (one(values), ...);
}

template <class Record>
Item list_item(std::string name, const std::vector<Record>& list) {
    Item item{.name = std::move(name), .bytes = {}};
    item.bytes.assign(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(Record));
    return item;
}

// Living ones alone: what is left of others is overwritten before it is read. Marks, stamps and
// slots are scratch.
template <class Real>
void add_complex(const Complex<Real>& complex, std::vector<Item>& items) {
    Item& of_vertices = items.emplace_back();
    of_vertices.name = "the vertices";
    for (const Vertex v : vertices(complex)) {
        const auto& record = complex.vertices[v.id];
        put(of_vertices.bytes, v.id, record.x, record.y, record.corner, record.flags);
    }
    of_vertices.entry = 2 * sizeof(Real) + 12;
    Item& of_triangles = items.emplace_back();
    of_triangles.name = "the triangles";
    for (const Triangle t : triangles(complex)) {
        const auto& record = complex.triangles[t.id];
        put(of_triangles.bytes, t.id, record.v, record.n, record.phase);
    }
    of_triangles.entry = 4 + 24 + sizeof(Phase);
    items.push_back(list_item("the free vertices of the complex", complex.ids.vertices));
    items.push_back(list_item("the free triangles of the complex", complex.ids.triangles));
}

template <class Real>
void add_attributes(const Complex<Real>& complex, std::vector<Item>& items) {
    std::array<std::vector<std::uint32_t>, 3> living;
    for (const Vertex v : vertices(complex)) {
        living[static_cast<std::size_t>(SimplexKind::vertex)].push_back(v.id);
    }
    for (const Triangle t : triangles(complex)) {
        living[static_cast<std::size_t>(SimplexKind::triangle)].push_back(t.id);
        for (std::uint32_t i = 0; i < 3; ++i) {
            living[static_cast<std::size_t>(SimplexKind::edge)].push_back(corner_of(t.id, i));
        }
    }
    for (const auto& attribute : complex.attributes.list()) {
        Item& item = items.emplace_back();
        item.name = "the attribute '" + attribute->name() + "'";
        const auto some = attribute->clone_empty();
        some->append(*attribute, living[static_cast<std::size_t>(attribute->kind())]);
        Archive values;
        try {
            some->archive(values);
            item.bytes = values.bytes();
        } catch (const InputError&) {
            item.name += ", which cannot be read"; // a class of the application without archive()
        }
    }
}

std::string where_they_differ(const Item& item, const std::string& other) {
    const std::size_t common = std::min(item.bytes.size(), other.size());
    const auto first =
        std::mismatch(item.bytes.begin(), item.bytes.begin() + static_cast<std::ptrdiff_t>(common),
                      other.begin());
    const auto at = static_cast<std::size_t>(first.first - item.bytes.begin());
    const std::size_t entry = at / item.entry;
    std::string text = ", entry " + std::to_string(entry);
    if ((entry + 1) * item.entry <= item.bytes.size()) {
        std::uint32_t id = 0;
        std::memcpy(&id, item.bytes.data() + entry * item.entry, sizeof id);
        text += " (id " + std::to_string(id) + ")";
    }
    return text;
}

template <class Real>
void add_work(const std::string& whose, const Work<Real>& work, bool is_listed,
              std::vector<Item>& items) {
    if (is_listed) {
        items.push_back(list_item("the interface of " + whose, work.interface));
    }
    items.push_back(list_item("the active set of " + whose, work.active));
    items.push_back(list_item("the stars to be looked at again of " + whose, work.resized));
    items.push_back(list_item("the changed interface of " + whose, work.changed_interface));
    Item& others = items.emplace_back();
    others.name = "the suspects, missed movements or counts of " + whose;
    for (const Suspect<Real>& one : work.topology_suspects) {
        put(others.bytes, one.vertex, one.x, one.y, one.is_thin, one.is_facing, one.is_sharp,
            one.is_junction);
    }
    for (const Mover<Real>& one : work.missed) {
        put(others.bytes, one.vertex, one.x, one.y);
    }
    put(others.bytes, work.log.counts);
}

} // namespace

template <class Real>
void SubmeshExecutor<Real>::expect_agreement(const char* when) {
    std::vector<Item> items;
    add_complex(complex_, items);
    add_attributes(complex_, items);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const std::string name = "submesh " + std::to_string(i);
        add_work(name, parts_[i]->work, i < first_colour_, items);
        items.push_back(list_item("the free vertices of " + name, parts_[i]->pool.vertices));
        items.push_back(list_item("the free triangles of " + name, parts_[i]->pool.triangles));
        Item& examined = items.emplace_back();
        examined.name = "the stars examined in " + name;
        put(examined.bytes, parts_[i]->examined);
    }
    add_work("what no submesh owns", whole_, true, items);

    std::vector<std::uint64_t> hashes;
    for (const Item& item : items) {
        hashes.push_back(hash_of(item.bytes));
    }
    Ranks& ranks = shared_->ranks;
    ranks.begin().list(hashes);
    std::size_t differs = items.size();
    std::uint32_t with = 0;
    std::vector<std::uint64_t> theirs;
    std::vector<std::uint64_t> first;
    const auto all = ranks.exchange();
    for (std::uint32_t rank = 0; rank < all.size(); ++rank) {
        all[rank].list(rank == 0 ? first : theirs);
        if (rank > 0 && differs == items.size() && theirs != first) {
            const auto at = std::ranges::mismatch(first, theirs);
            differs = std::min<std::size_t>(static_cast<std::size_t>(at.in1 - first.begin()),
                                            items.size() - 1);
            with = rank;
        }
    }
    if (differs == items.size()) {
        return;
    }
    ranks.begin().text(items[differs].bytes);
    const auto told = ranks.exchange();
    Item of_first = items[differs];
    of_first.bytes = told[0].text();
    throw InvariantError(std::string("ranks 0 and ") + std::to_string(with) + " differ " + when +
                         " in " + of_first.name + where_they_differ(of_first, told[with].text()));
}

template void SubmeshExecutor<double>::expect_agreement(const char*);
template void SubmeshExecutor<float>::expect_agreement(const char*);

} // namespace dsc
