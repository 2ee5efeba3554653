// SPDX-License-Identifier: MIT
#include "topology/stage.h"

#include "dsc/algorithm/stage.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"
#include "topology/change.h"
#include "topology/contact_check.h"

#include <algorithm>

namespace dsc {

template <class Real>
TopologyStage<Real>::TopologyStage(TopologyOptions<Real> options) : options_(std::move(options)) {
    check_topology(options_);
}

template <class Real>
void TopologyStage<Real>::set_options(TopologyOptions<Real> options) {
    check_topology(options);
    // Checked only if contact distances change, because a phase that has shrunk since is no error.
    if (complex_ != nullptr && differ_in_contact(options, options_)) {
        check_contact<Real>(*complex_, options, edge_length_);
    }
    options_ = std::move(options);
    find_curvature();
}

template <class Real>
void TopologyStage<Real>::check(const Complex<Real>& complex, const Options<Real>& options) const {
    if (complex_ != &complex) { // not later, because a phase that has shrunk is no error
        check_contact<Real>(complex, options_, options.edge_length);
    }
}

template <class Real>
void TopologyStage<Real>::begin(Complex<Real>& complex, const Options<Real>& options) {
    if (complex_ != &complex || !has_notes(complex)) {
        begin_notes(complex);
    }
    complex_ = &complex;
    notes_ = &notes_of(complex);
    places_ = &places_of(complex);
    edge_length_ = options.edge_length;
    find_curvature();
}

template <class Real>
void TopologyStage<Real>::find_curvature() {
    curvature_ = options_.changes() ? curvature_around(min_area(options_, edge_length_)) : Real(0);
}

template <class Real>
std::optional<Pass<Real>> TopologyStage<Real>::pass() {
    return Pass<Real>{
        "notes for the topology",
        [this](Work<Real>& work) { note_stars(work, curvature_, round_); }, true,
        [this](Work<Real>& work, const Star<Real>& star, const IncidentEdges& incident) {
            if (curvature_ > 0) {
                note_star(work, star, incident, curvature_, round_, {notes_, places_});
            }
        }};
}

template <class Real>
void TopologyStage<Real>::run(const Between<Real>& between) {
    run_round(between, round_++, false);
}

template <class Real>
void TopologyStage<Real>::run_again(const Between<Real>& between) {
    run_round(between, round_ - 1, true);
}

// `round`: of the notes.
template <class Real>
void TopologyStage<Real>::run_round(const Between<Real>& between, std::uint32_t round,
                                    bool is_again) {
    if (curvature_ == 0) {
        return;
    }
    const Complex<Real>& complex = between.complex;
    candidates_.clear();
    const auto look = [&](std::uint32_t v, std::vector<Candidate>& found) {
        const Note note = (*notes_)[Vertex{v}];
        const std::uint32_t bits = note.round == round ? note.what : 0U;
        const bool is_blocked = (complex.vertices[v].flags & vertex_contact) != 0;
        if ((bits & (noted_sharp | noted_junction)) != 0 || is_blocked) {
            found.push_back({.vertex = v,
                             .is_sharp = (bits & noted_sharp) != 0,
                             .is_junction = (bits & noted_junction) != 0});
        }
    };
    find_at(between.in_shares, between.interface, candidates_, look);
    if (!is_again) {
        missed_.clear();
        for (const MovingVertex<Real>& one : between.missed) {
            missed_.push_back({one.vertex, {one.x, one.y}, (*places_)[Vertex{one.vertex}]});
        }
        std::ranges::sort(missed_, {}, &Missed<Real>::vertex);
    }
    area_ += change_topology<Real>({.complex = between.complex,
                                    .options = options_,
                                    .edge_length = edge_length_,
                                    .time = static_cast<double>(between.time),
                                    .dt = between.dt,
                                    .events = events_,
                                    .interface = between.interface,
                                    .round = round,
                                    .is_again = is_again,
                                    .in_shares = between.in_shares,
                                    .missed = missed_},
                                   candidates_);
}

template <class Real>
void TopologyStage<Real>::tell() {
    const std::size_t from = std::exchange(told_, events_.size());
    if (from == events_.size()) {
        return;
    }
    for (const EventListener& listener : listeners_) {
        listener(std::span<const Event>(events_).subspan(from));
    }
}

template <class Real>
void TopologyStage<Real>::archive(Archive& archive) {
    std::uint64_t told = told_;
    archive(round_, events_, told, area_);
    archive.expect(told <= events_.size(), "more events reported than happened");
    told_ = static_cast<std::size_t>(told);
}

template <class Real>
std::vector<Event> TopologyStage<Real>::take_events() {
    told_ = 0;
    return std::exchange(events_, {});
}

template <class Real>
AreaAccount TopologyStage<Real>::take_area() {
    return std::exchange(area_, {});
}

template class TopologyStage<double>;
template class TopologyStage<float>;

} // namespace dsc
