// SPDX-License-Identifier: MIT
// The log of edits. Functions that change connectivity, positions or phases (nearly all are in
// rewire.h) note each change here: always as a count, and as a record if there is a reader. Active
// sets, interface lists, counts and the listeners of an application read these logs.
//
// Each submesh has a log of its own, so that no two threads share one. The logs are read in the
// order of the submeshes, so the result does not depend on threads.
#pragma once

#include "dsc/base/types.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace dsc {

/// What an edit did.
enum class EditKind : std::uint8_t {
    flip,            ///< an edge was replaced by the other diagonal of its two triangles
    split,           ///< a new vertex on an edge
    collapse,        ///< a vertex vanished into a neighbour
    move,            ///< a vertex changed its position
    relabel,         ///< a triangle changed its phase
    retriangulate,   ///< the triangles around one were replaced; removals follow
    insert_vertex,   ///< a vertex without triangles
    remove_vertex,   ///< a vertex that no triangle uses any more
    insert_triangle, ///< between three vertices
    remove_triangle, ///< leaves its vertices behind
    renumber,        ///< `renumber` was called: all ids are new, earlier handles are invalid
    rebuild,         ///< another mesh took its place: all ids are new (create and merge)
};
/// The number of values of `EditKind`.
inline constexpr int edit_kind_count = 12;

[[nodiscard]] constexpr std::string_view to_string(EditKind kind) {
    switch (kind) {
    case EditKind::flip: return "flip";
    case EditKind::split: return "split";
    case EditKind::collapse: return "collapse";
    case EditKind::move: return "move";
    case EditKind::relabel: return "relabel";
    case EditKind::retriangulate: return "retriangulate";
    case EditKind::insert_vertex: return "insert_vertex";
    case EditKind::remove_vertex: return "remove_vertex";
    case EditKind::insert_triangle: return "insert_triangle";
    case EditKind::remove_triangle: return "remove_triangle";
    case EditKind::renumber: return "renumber";
    case EditKind::rebuild: return "rebuild";
    }
    return "unknown";
}

/// Why a vertex moved.
enum class MoveReason : std::uint8_t {
    application, ///< an edit by the application
    flow,        ///< towards the target given by the velocity
    smoothing,   ///< to improve the quality of its star
    coarsening,  ///< of the vertex that survives a triangle collapse
    giving_back, ///< to give back area that a change of topology took from a phase
};

/// One edit. Fields that a kind of edit does not use are invalid (no_id).
struct Edit {
    EditKind kind = EditKind::flip;              ///< what was done
    MoveReason reason = MoveReason::application; ///< of a move
    bool on_interface = false;                   ///< split, collapse: of an interface edge
    /// flip, split, collapse: opposite to the edge, as a corner before the edit. relabel,
    /// retriangulate, insert_triangle, remove_triangle: 4 * triangle.
    Corner corner = no_id;
    /// split: the new vertex; collapse: the one that vanished; move, insert_vertex, remove_vertex:
    /// the vertex concerned.
    Vertex vertex = {};
    /// flip: the ends of the edge before; split: the parents; collapse: the one that vanished, and
    /// the one that it was merged into. relabel, insert_triangle, remove_triangle: the first two
    /// vertices of the triangle.
    std::array<Vertex, 2> ends = {};
    /// flip: the ends of the edge after; split, collapse: the vertices opposite to the edge, the
    /// second invalid on the domain boundary. relabel, insert_triangle, remove_triangle: the third
    /// vertex.
    std::array<Vertex, 2> apexes = {};
    /// split: the new triangles, the second invalid on the domain boundary. relabel: the phases
    /// before and after. insert_triangle: its phase.
    std::array<std::uint32_t, 2> made{no_id, no_id};
    /// split, move, insert_vertex: the position after, in units of the domain.
    double x = 0;
    double y = 0; ///< as x
};
static_assert(sizeof(Edit) == 56);

/// The number of edits of each kind. Sums over submeshes do not depend on threads.
struct OperationCounts {
    std::uint64_t moves = 0;               ///< vertices moved by the flow, wholly or partly
    std::uint64_t flips = 0;               ///< of edges that are not constrained
    std::uint64_t interface_splits = 0;    ///< of interface edges
    std::uint64_t interface_collapses = 0; ///< along interface edges
    std::uint64_t splits = 0;              ///< of other edges
    std::uint64_t collapses = 0;           ///< along other edges
    std::uint64_t smoothed = 0;            ///< vertices moved for the quality of their stars
    std::uint64_t subdivisions = 0;        ///< of Loop; their splits and flips are counted too
    std::uint64_t retriangulations = 0;    ///< local ones, of whole polygons
    std::uint64_t relabelled = 0;          ///< triangles that changed their phase
    std::uint64_t examined = 0;            ///< stars that were gathered for the mesh update

    OperationCounts& operator+=(const OperationCounts& other);
};

/// Receives edits in batches, in an order that does not depend on threads. The handles are those at
/// the moment of the edit: a vertex of one record may have vanished by a later one. Called by the
/// thread that calls `Simulation::step`, between sub-steps; must not change the complex.
using EditListener = std::function<void(std::span<const Edit> edits)>;

/// Counts edits, and keeps their records while there is a reader. Readers stay with the complex
/// whose log they read: a copied or moved log starts empty.
class EditLog {
public:
    EditLog() = default;
    /// A copy is empty and has no reader.
    EditLog(const EditLog& /*other*/) noexcept {}
    /// The complex is replaced by another mesh: readers find a `rebuild` after the records so far.
    EditLog& operator=(const EditLog& other);
    ~EditLog() = default;

    OperationCounts counts;    ///< of all edits since they were last read
    std::vector<Edit> records; ///< in the order of the edits
    std::uint32_t readers = 0; ///< records are kept while there are any: see `LogReader`
};

/// Makes a log keep its records while this object lives. The destructor of the last reader empties
/// the log. The log must outlive its readers.
class LogReader : public Unmovable {
public:
    /// Reads the edits from now on.
    explicit LogReader(EditLog& log) : log_(log), from_(log.records.size()) { ++log_.readers; }
    ~LogReader();

    /// The edits since this reader was made; valid until the next edit. No other reader may have
    /// emptied the log meanwhile. O(1).
    [[nodiscard]] std::span<const Edit> edits() const {
        return std::span<const Edit>(log_.records).subspan(from_);
    }

private:
    EditLog& log_;
    std::size_t from_;
};

} // namespace dsc
