// SPDX-License-Identifier: MIT
// A scene is written down once, and turned about its domain.
#pragma once

#include "combinations/row.h"

#include "dsc/initial/initial_complex.h"

#include <utility>

namespace dsc::combinations {

class Frame {
public:
    Frame(Turned turned, const Point<double>& size) : turned_(turned), size_(size) {}

    [[nodiscard]] Point<double> size() const {
        return is_upright() ? size_ : Point<double>(size_.y(), size_.x());
    }

    [[nodiscard]] Point<double> place(const Point<double>& p) const {
        switch (turned_) {
        case Turned::not_at_all: return p;
        case Turned::quarter: return {size_.y() - p.y(), p.x()};
        case Turned::half: return {size_.x() - p.x(), size_.y() - p.y()};
        case Turned::three_quarters: return {p.y(), size_.x() - p.x()};
        case Turned::mirrored: return {size_.x() - p.x(), p.y()};
        }
        return p;
    }
    [[nodiscard]] Point<double> place_before(const Point<double>& p) const {
        switch (turned_) {
        case Turned::not_at_all: return p;
        case Turned::quarter: return {p.y(), size_.y() - p.x()};
        case Turned::half: return {size_.x() - p.x(), size_.y() - p.y()};
        case Turned::three_quarters: return {size_.x() - p.y(), p.x()};
        case Turned::mirrored: return {size_.x() - p.x(), p.y()};
        }
        return p;
    }
    [[nodiscard]] Point<double> way(const Point<double>& v) const {
        return place(v) - place(Point<double>(0, 0));
    }
    [[nodiscard]] Curve curve(Curve one) const {
        for (Point<double>& p : one.points) {
            p = place(p);
        }
        if (turned_ == Turned::mirrored) {
            std::swap(one.left, one.right);
        }
        return one;
    }

private:
    [[nodiscard]] bool is_upright() const {
        return turned_ != Turned::quarter && turned_ != Turned::three_quarters;
    }
    Turned turned_;
    Point<double> size_;
};

} // namespace dsc::combinations
