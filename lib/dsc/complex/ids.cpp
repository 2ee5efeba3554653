// SPDX-License-Identifier: MIT
#include "dsc/complex/ids.h"

#include <utility>

namespace dsc {

namespace {

std::uint32_t total(const FreeIds& ids, std::vector<std::uint32_t> IdPool::*of_kind) {
    std::size_t sum = (ids.*of_kind).size();
    for (const IdPool& pool : ids.lent) {
        sum += (pool.*of_kind).size();
    }
    return static_cast<std::uint32_t>(sum);
}

} // namespace

void move_ids(IdPool& from, IdPool& to, std::size_t vertices, std::size_t triangles) {
    const auto move = [](std::vector<std::uint32_t>& out, std::vector<std::uint32_t>& in,
                         std::size_t keep) {
        while (out.size() > keep) {
            in.push_back(out.back());
            out.pop_back();
        }
    };
    move(from.vertices, to.vertices, vertices);
    move(from.triangles, to.triangles, triangles);
}

FreeIds::FreeIds(FreeIds&& other) noexcept { *this = std::move(other); }

FreeIds& FreeIds::operator=(const FreeIds& other) {
    return this == &other ? *this : *this = FreeIds(other);
}

FreeIds& FreeIds::operator=(FreeIds&& other) noexcept {
    if (this != &other) {
        clear();
        vertices.swap(other.vertices);
        triangles.swap(other.triangles);
        lent.swap(other.lent);
        may_grow = other.may_grow;
        ++other.generation;
    }
    return *this;
}

IdPool& FreeIds::lend(std::size_t number) {
    while (lent.size() <= number) {
        lent.emplace_back().may_grow = false;
    }
    return lent[number];
}

void FreeIds::collect() {
    for (IdPool& pool : lent) {
        move_ids(pool, *this, 0, 0);
    }
    lent.clear();
    ++generation;
}

void FreeIds::clear() {
    vertices.clear();
    triangles.clear();
    lent.clear();
    ++generation;
}

std::uint32_t FreeIds::vertex_total() const { return total(*this, &IdPool::vertices); }
std::uint32_t FreeIds::triangle_total() const { return total(*this, &IdPool::triangles); }

} // namespace dsc
