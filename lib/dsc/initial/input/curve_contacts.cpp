// SPDX-License-Identifier: MIT
#include "dsc/initial/input/curve_contacts.h"

#include "dsc/geometry/predicates.h"

#include <algorithm>
#include <cmath>

namespace dsc::initial {

namespace {

// Whether p and q lie in the same direction from c; exact, for three points on one line.
bool same_direction(const Point<double>& c, const Point<double>& p, const Point<double>& q) {
    const auto sign = [](double from, double to) { return (to > from) - (to < from); };
    return sign(c.x(), p.x()) == sign(c.x(), q.x()) && sign(c.y(), p.y()) == sign(c.y(), q.y());
}

// Boxes of cells, both ends included.
struct CellBox {
    std::int64_t left, right, bottom, top;
};

class PieceGrid {
public:
    PieceGrid(std::span<const Point<double>> points, std::span<const NetworkPiece> pieces,
              double reach)
        : points_(points), reach_(reach) {
        low_ = points.front();
        Point<double> high = points.front();
        for (const Point<double>& p : points) {
            low_ = low_.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        double length = 0;
        for (const NetworkPiece& piece : pieces) {
            length += (points[piece.line.to] - points[piece.line.from]).norm();
        }
        // About one piece in a cell, and few cells under each piece.
        const auto count = static_cast<double>(pieces.size());
        const Point<double> size = high - low_;
        width_ = std::max({length / count, std::sqrt(size.x() / count * size.y()), reach});
        columns_ = 1 + static_cast<std::int64_t>(size.x() / width_);
        rows_ = 1 + static_cast<std::int64_t>(size.y() / width_);
        fill(pieces);
    }

    [[nodiscard]] std::size_t cells() const { return first_.size() - 1; }
    [[nodiscard]] std::span<const std::uint32_t> members(std::size_t cell) const {
        return std::span(members_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
    }

private:
    [[nodiscard]] CellBox box_of(const NetworkPiece& piece) const {
        const Point<double>& a = points_[piece.line.from];
        const Point<double>& b = points_[piece.line.to];
        const auto cell = [&](double distance, std::int64_t count) {
            return std::clamp<std::int64_t>(static_cast<std::int64_t>(distance / width_), 0,
                                            count - 1);
        };
        return {cell(std::min(a.x(), b.x()) - reach_ - low_.x(), columns_),
                cell(std::max(a.x(), b.x()) + reach_ - low_.x(), columns_),
                cell(std::min(a.y(), b.y()) - reach_ - low_.y(), rows_),
                cell(std::max(a.y(), b.y()) + reach_ - low_.y(), rows_)};
    }

    template <class Visit>
    void for_each_cell(const NetworkPiece& piece, Visit visit) const {
        const CellBox box = box_of(piece);
        for (std::int64_t row = box.bottom; row <= box.top; ++row) {
            for (std::int64_t column = box.left; column <= box.right; ++column) {
                visit(static_cast<std::size_t>(row * columns_ + column));
            }
        }
    }

    // Counts, sums up, and puts each piece into its cells.
    void fill(std::span<const NetworkPiece> pieces) {
        first_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
        for (const NetworkPiece& piece : pieces) {
            for_each_cell(piece, [&](std::size_t cell) { ++first_[cell + 1]; });
        }
        for (std::size_t cell = 1; cell < first_.size(); ++cell) {
            first_[cell] += first_[cell - 1];
        }
        members_.resize(first_.back());
        std::vector<std::size_t> place(first_.begin(), first_.end() - 1);
        for (std::uint32_t k = 0; k < pieces.size(); ++k) {
            for_each_cell(pieces[k], [&](std::size_t cell) { members_[place[cell]++] = k; });
        }
    }

    std::span<const Point<double>> points_;
    double reach_;
    Point<double> low_;
    double width_ = 1;
    std::int64_t columns_ = 1;
    std::int64_t rows_ = 1;
    std::vector<std::size_t> first_; // by cell, into members_
    std::vector<std::uint32_t> members_;
};

// Whether two lines have a point in common, other than an end with the same number.
bool meet(std::span<const Point<double>> points, const NetworkEdge& s, const NetworkEdge& t) {
    const bool from_shared = s.from == t.from || s.from == t.to;
    const bool to_shared = s.to == t.from || s.to == t.to;
    if (from_shared && to_shared) {
        return true;
    }
    if (!from_shared && !to_shared) {
        return segments_meet<double>(points[s.from], points[s.to], points[t.from], points[t.to]);
    }
    const std::uint32_t common = from_shared ? s.from : s.to;
    const Point<double>& c = points[common];
    const Point<double>& p = points[from_shared ? s.to : s.from];
    const Point<double>& q = points[t.from == common ? t.to : t.from];
    return orientation<double>(p, c, q) == 0 && same_direction(c, p, q);
}

} // namespace

std::optional<EdgeContact> find_contact(std::span<const Point<double>> points,
                                        std::span<const NetworkEdge> edges,
                                        std::span<const NetworkPiece> pieces, double reach) {
    std::optional<EdgeContact> first;
    if (pieces.empty()) {
        return first;
    }
    const PieceGrid grid(points, pieces, reach);
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
        const auto members = grid.members(cell);
        for (std::size_t i = 0; i < members.size(); ++i) {
            for (std::size_t j = i + 1; j < members.size(); ++j) {
                const NetworkPiece& one = pieces[members[i]];
                const NetworkPiece& other = pieces[members[j]];
                const auto [e, f] = std::minmax(one.edge, other.edge);
                const EdgeContact contact{e, f};
                if ((!first || contact < *first) && ((e != f && meet(points, edges[e], edges[f])) ||
                                                     meet(points, one.line, other.line))) {
                    first = contact;
                }
            }
        }
    }
    return first;
}

} // namespace dsc::initial
