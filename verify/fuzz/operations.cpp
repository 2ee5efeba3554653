// SPDX-License-Identifier: MIT
// Makes an arbitrary sequence of an application's edits on a small complex: each edit is done or
// refused, and leaves the complex valid. Edits that the library does not promise to refuse (a
// vertex put anywhere, a triangle laid over others) are tried on a copy, which is kept if it is
// valid. Replaying their log gives the same complex.
#include "fuzz/bytes.h"
#include "fuzz/target.h"
#include "support/random/complex.h"

#include "dsc/base/error.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/numbering.h"
#include "dsc/complex/ranges.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "dsc/queries/validate.h"
#include "replay/replay.h"
#include "thesis/operations/local_retriangulation.h"
#include "thesis/operations/loop_subdivision.h"
#include "thesis/operations/replay.h"
#include "thesis/operations/smoothing.h"
#include "thesis/operations/triangle_collapse.h"
#include "thesis/sets/insertion_removal.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace dsc::fuzz {

namespace {

constexpr std::uint32_t max_triangles = 400;
constexpr int max_edits = 300;

template <class Real>
class Session {
public:
    Session(Complex<Real> complex, Bytes& bytes)
        : bytes_(bytes), first_(complex), complex_(std::move(complex)) {
        complex_.journal.readers = 1;
        labels_ = test::random_labels(bytes_.byte(), complex_);
    }

    // Arguments are drawn before a call: compilers evaluate them in different orders.
    void edit() {
        const std::uint32_t kind = bytes_.below(18);
        switch (kind) {
        case 0: edge_flip(complex_, edge()); break;
        case 1: split(edge()); break;
        case 2: edge_collapse(complex_, edge()); break;
        case 3: {
            const Edge e = edge();
            edge_collapse(complex_, e, vertex());
            break;
        }
        case 4: collapse_triangle(); break;
        case 5: loop_subdivide(); break;
        case 6: {
            const Triangle t = triangle();
            local_retriangulation(complex_, t,
                                  bytes_.below(2) == 0 ? RetriangulationMethod::ear_clipping
                                                       : RetriangulationMethod::delaunay);
            break;
        }
        case 7: laplacian_smoothing(complex_, vertex()); break;
        case 8: {
            const Vertex v = vertex();
            interface_smoothing(complex_, v,
                                {.feature_degrees = bytes_.in(0, 180), .step = bytes_.in(0, 1)});
            break;
        }
        case 9:
            if (const Vertex v = vertex(); complex_.is_alive(v)) {
                complex_.set_locked(v, bytes_.below(2) == 0);
            }
            break;
        case 10:
            if (const Triangle t = triangle(); complex_.is_alive(t)) {
                complex_.set_phase(t, bytes_.below(4));
            }
            break;
        case 11: renumber(complex_); break;
        case 12: edit_submesh(); break;
        default: edit_copy(kind); break;
        }
    }

    void check(int edits) const {
        const std::string problem = validate(complex_).problem;
        expect(problem.empty(), "after edit " + std::to_string(edits) + ": " + problem);
    }

    void check_log() const {
        Complex<Real> again = first_;
        const ReplayReport report =
            replay<Real>(again, complex_.journal.records, repeat_edit<Real>);
        expect(report.skipped == 0, "the log does not fit the complex that it is a log of");
        expect(mesh_hash(again) == mesh_hash(complex_), "the log replayed gives another complex");
    }

    // Replays a part of the log, as when the log of a failure is reduced: replay must end,
    // whichever records are left out.
    void replay_parts(std::uint8_t pattern) const {
        std::vector<Edit> rest;
        for (std::size_t i = 0; i < complex_.journal.records.size(); ++i) {
            if ((pattern >> (i % 8) & 1U) == 0) {
                rest.push_back(complex_.journal.records[i]);
            }
        }
        Complex<Real> again = first_;
        const ReplayReport report = replay<Real>(again, rest, repeat_edit<Real>);
        expect(report.done + report.skipped == rest.size(), "records that were lost");
    }

private:
    // The handles drawn may be dead, beyond the end, or not canonical.
    Vertex vertex() { return Vertex{bytes_.below(complex_.vertex_bound() + 2)}; }
    Triangle triangle() { return Triangle{bytes_.below(complex_.triangle_bound() + 1)}; }
    Edge edge() {
        const Triangle t = triangle();
        const std::uint32_t side = bytes_.byte();
        const Corner corner = corner_of(t.id, side % 4);
        return side % 4 < 3 && side < 240 && complex_.is_alive(t) ? complex_.edge(corner)
                                                                  : Edge{corner};
    }

    // A point near a triangle, one of its corners, or coordinates that are not finite or too large.
    Point<Real> place() {
        const std::uint8_t kind = bytes_.byte();
        if (kind >= 250) {
            static constexpr std::array<Real, 3> odd{std::numeric_limits<Real>::quiet_NaN(),
                                                     std::numeric_limits<Real>::infinity(),
                                                     std::numeric_limits<Real>::max()};
            const Real y = odd[bytes_.below(3)];
            return {odd[kind % 3], y};
        }
        const Triangle t = triangle();
        if (!complex_.is_alive(t)) {
            return Point<Real>::Zero();
        }
        const auto [a, b, c] = complex_.vertices_of(t);
        // Multiples of 1/16 along two edges, also beyond their ends.
        const Real s = static_cast<Real>(bytes_.below(33)) / 16 - Real(0.5);
        const Real r = static_cast<Real>(bytes_.below(33)) / 16 - Real(0.5);
        return complex_.position(a) + s * (complex_.position(b) - complex_.position(a)) +
               r * (complex_.position(c) - complex_.position(a));
    }

    [[nodiscard]] bool is_full() const { return complex_.triangle_count() > max_triangles; }

    void split(Edge e) {
        if (is_full()) {
            return;
        }
        if (complex_.is_alive(e) && is_border(complex_.twin(e.id))) {
            on_copy([&](Complex<Real>& copy) { edge_split(copy, e); });
        } else if (bytes_.below(2) == 0) {
            edge_split(complex_, e);
        } else {
            edge_split(complex_, e, place());
        }
    }

    void collapse_triangle() {
        const Triangle t = triangle();
        TriangleCollapseOptions<Real> options;
        options.interface = bytes_.below(2) == 0 ? InterfaceRule::keep : InterfaceRule::change;
        if (bytes_.below(2) == 0) {
            options.place = place();
        }
        try {
            triangle_collapse(complex_, t, options);
        } catch (const InputError&) {
            expect(!options.place->allFinite(), "a finite place was called an input error");
        }
    }

    // Loop subdivision also splits edges of the domain boundary, at midpoints that may be rounded
    // outwards, so it works on a copy.
    void loop_subdivide() {
        const Triangle t = triangle();
        if (!is_full()) {
            on_copy([&](Complex<Real>& copy) { loop_subdivision(copy, t); });
        }
    }

    void edit_submesh() {
        labels_.resize(complex_.vertex_bound(), 0);
        Submesh submesh = Submesh(complex_);
        submesh.region.kind = Region::Kind::labels;
        submesh.region.labels = labels_.data();
        submesh.region.label = 1;
        const std::vector<Edge> outside = edges_outside(submesh.region);
        const std::uint32_t kind = bytes_.below(5);
        switch (kind) {
        case 0: edge_flip(submesh, edge()); break;
        case 1: edge_collapse(submesh, edge()); break;
        case 2: laplacian_smoothing(submesh, vertex()); break;
        case 3: interface_smoothing(submesh, vertex()); break;
        default: local_retriangulation(submesh, triangle()); break;
        }
        for (const Edge e : outside) {
            expect(complex_.is_alive(e), "an edge outside the submesh vanished");
        }
    }

    // Counts the triangles of which the submesh owns no vertex.
    std::vector<Edge> edges_outside(const Region& region) const {
        std::vector<Edge> outside;
        for (const Triangle t : triangles(complex_)) {
            bool is_outside = true;
            for (const Vertex v : complex_.vertices_of(t)) {
                is_outside = is_outside && !owns(complex_, region, v.id);
            }
            if (is_outside) {
                for (const Edge e : complex_.edges_of(t)) {
                    outside.push_back(e);
                }
            }
        }
        return outside;
    }

    void edit_copy(std::uint32_t kind) {
        if (is_full()) {
            return;
        }
        if (kind == 13) {
            const Vertex v = vertex();
            const Point<Real> p = place();
            on_copy([&](Complex<Real>& copy) {
                if (copy.is_alive(v)) {
                    copy.set_position(v, p);
                }
            });
        } else if (kind == 14) {
            const Point<Real> p = place();
            on_copy([&](Complex<Real>& copy) { insert_vertex(copy, p); });
        } else if (kind == 15) {
            const std::array<Vertex, 3> v{vertex(), vertex(), vertex()};
            const Phase phase = bytes_.below(4);
            on_copy([&](Complex<Real>& copy) { insert_triangle(copy, v[0], v[1], v[2], phase); });
        } else if (kind == 16) {
            const Triangle t = triangle();
            on_copy([&](Complex<Real>& copy) { remove(copy, SimplexSet({}, {}, {t})); });
        } else {
            const Vertex v = vertex();
            const Edge e = edge();
            on_copy([&](Complex<Real>& copy) { remove(copy, SimplexSet({v}, {e}, {})); });
        }
    }

    // An edit that throws must leave the complex unchanged.
    template <class Edit>
    void on_copy(Edit edit) {
        Complex<Real> copy = complex_;
        copy.journal.readers = 1;
        copy.journal.records = complex_.journal.records;
        try {
            edit(copy);
        } catch (const InputError&) {
            expect(mesh_hash(copy) == mesh_hash(complex_), "a refused edit changed the complex");
        }
        if (validate(copy).ok()) {
            auto records = std::move(copy.journal.records);
            complex_ = std::move(copy);
            // The assignment noted a `rebuild`; the log goes on with the copy's records instead.
            complex_.journal.records = std::move(records);
        }
    }

    Bytes& bytes_;
    Complex<Real> first_;
    Complex<Real> complex_;
    std::vector<std::uint32_t> labels_;
};

template <class Real>
std::uint64_t run_session(Bytes& bytes) {
    const std::uint64_t seed = bytes.below(65536);
    const std::uint8_t left_out = bytes.byte();
    test::RandomComplexOptions options = test::random_options(seed, 16);
    options.scramble = std::min(options.scramble, 20U);
    Session<Real> session(test::random_complex<Real>(seed, options), bytes);
    session.check(0);
    int edits = 0;
    for (; edits < max_edits && !bytes.empty(); ++edits) {
        session.edit();
        session.check(edits + 1);
    }
    session.check_log();
    session.replay_parts(left_out);
    return static_cast<std::uint64_t>(edits);
}

} // namespace

std::uint64_t run_operations(std::span<const std::uint8_t> bytes) {
    Bytes decoder(bytes);
    return decoder.below(4) == 3 ? run_session<float>(decoder) : run_session<double>(decoder);
}

} // namespace dsc::fuzz
