// SPDX-License-Identifier: MIT
#include "dsc3/parallel/submeshes.h"

#include "dsc3/parallel/division.h"

#include <algorithm>
#include <atomic>

namespace dsc3 {

namespace {

// The free ids that a submesh gets: for each of its items, and at least.
constexpr std::size_t tets_each = 2;
constexpr std::size_t vertices_each = 4; // items for each vertex
constexpr std::size_t min_vertices = 16;

} // namespace

Submeshes::Submeshes(Complex& complex, Real edge_length, const Parallel& parallel, Team& team)
    : complex_(complex), team_(team), edge_length_(edge_length), parallel_(parallel),
      workers_(largest_division(parallel)), workspaces_(team.size()) {
    ownership_.partition = parallel.partition;
    ownership_.submeshes = partition_size(parallel);
    for (std::uint32_t i = 0; i < workers_.size(); ++i) {
        workers_[i].submesh.index = i;
    }
    for (Workspace& work : workspaces_) {
        work.rewiring.ownership = &ownership_;
    }
}

std::uint32_t Submeshes::kind() const {
    if (!parallel_.partition) {
        return parallel_.submeshes + 256 * static_cast<std::uint32_t>(parallel_.division);
    }
    std::uint32_t hash = 2166136261U; // FNV-1a
    for (const VertexRecord& vertex : complex_.vertices) {
        if ((vertex.flags & vertex_dead) == 0) {
            hash ^= parallel_.partition(vertex.position) % ownership_.submeshes;
            hash *= 16777619U;
        }
    }
    return parallel_.submeshes + 256 * 255 + (hash & 0xFFFF0000U);
}

void Submeshes::gather_places() {
    for (SubmeshWorker& worker : workers_) {
        move_all(places_, worker.places);
    }
}

void Submeshes::archive(dsc::Archive& archive) {
    gather_places();
    places_.resize(archive.length(places_.size(), sizeof(Point)));
    for (Point& p : places_) {
        archive.raw(p.data(), sizeof p);
        archive.expect(p.allFinite(), "contains a place of work that is not finite");
    }
}

void Submeshes::divide(const std::vector<std::uint32_t>& interface) {
    gather_places();
    if (places_.size() < interface.size() / 2) {
        places_.clear();
        for (const std::uint32_t v : interface) {
            places_.push_back(complex_.at(v));
        }
    }
    ownership_.trees = cut_colours(places_, parallel_, edge_length_);
    places_.clear();
    label();
}

// Labels all living vertices, and sets the outer bits.
void Submeshes::label() {
    auto& labels = ownership_.labels;
    labels.resize(complex_.vertex_bound());
    constexpr std::size_t grain = 1024;
    team_.chunks(labels.size(), grain,
                 [&](std::uint32_t, std::size_t begin, std::size_t end, std::uint32_t) {
                     for (std::size_t v = begin; v < end; ++v) {
                         const VertexRecord& vertex = complex_.vertices[v];
                         if ((vertex.flags & vertex_dead) == 0) {
                             labels[v] = ownership_.label_at(vertex.position);
                         }
                     }
                 });
    team_.chunks(
        complex_.tets.size(), grain,
        [&](std::uint32_t, std::size_t begin, std::size_t end, std::uint32_t) {
            for (std::size_t t = begin; t < end; ++t) {
                const auto& v = complex_.tets[t].v;
                if (v[0] == no_id) {
                    continue;
                }
                const auto of = [&](std::uint32_t i) {
                    return std::atomic_ref(labels[v[i]]).load(std::memory_order_relaxed);
                };
                if (const Label outer = outer_of(of(0), of(1), of(2), of(3)); outer != 0) {
                    for (const std::uint32_t vertex : v) {
                        std::atomic_ref(labels[vertex]).fetch_or(outer, std::memory_order_relaxed);
                    }
                }
            }
        });
}

// Each submesh gets its free ids from the end of the lists, in the order of the submeshes.
void Submeshes::deal_ids(std::uint32_t colour) {
    const auto tets_for = [](std::size_t load) { return 2 * min_free_tets + tets_each * load; };
    const auto vertices_for = [](std::size_t load) { return min_vertices + load / vertices_each; };
    order_.clear();
    std::size_t tets = 0;
    std::size_t vertices = 0;
    for (std::uint32_t i = 0; i < loads_.size(); ++i) {
        if (loads_[i] > 0) {
            order_.push_back(i);
            tets += tets_for(loads_[i]);
            vertices += vertices_for(loads_[i]);
        }
    }
    complex_.reserve_ids(vertices, tets);
    ownership_.labels.resize(complex_.vertex_bound());
    const bool has_spare = !complex_.attributes.empty(dsc::SimplexKind::triangle);
    if (has_spare) {
        complex_.attributes.resize_triangles(complex_.tet_bound() + workers_.size());
    }
    const auto move_end = [](std::vector<std::uint32_t>& from, std::size_t count,
                             std::vector<std::uint32_t>& to) {
        to.assign(from.end() - static_cast<std::ptrdiff_t>(count), from.end());
        from.resize(from.size() - count);
    };
    for (const std::uint32_t i : order_) {
        Submesh& submesh = workers_[i].submesh;
        submesh.colour = colour;
        submesh.spare_entry = complex_.tet_bound() + i;
        move_end(complex_.free_tets, tets_for(loads_[i]), submesh.free_tets);
        move_end(complex_.free_vertices, vertices_for(loads_[i]), submesh.free_vertices);
    }
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return loads_[a] > loads_[b]; });
}

void Submeshes::take_ids_back() {
    for (std::size_t i = workers_.size(); i-- > 0;) {
        move_all(complex_.free_tets, workers_[i].submesh.free_tets);
        move_all(complex_.free_vertices, workers_[i].submesh.free_vertices);
    }
    complex_.attributes.resize_triangles(complex_.tet_bound());
    ++complex_.version;
}

void Submeshes::hand_over(Workspace& work) {
    for (Workspace& done_there : workspaces_) {
        work.counts += done_there.counts;
        done_there.counts = {};
        work.treated += done_there.treated;
        work.treated_together += done_there.treated;
        done_there.treated = 0;
    }
    for (SubmeshWorker& worker : workers_) {
        move_all(work.rewiring.changed, worker.changed);
        move_all(work.rewiring.interface, worker.interface);
    }
}

} // namespace dsc3
