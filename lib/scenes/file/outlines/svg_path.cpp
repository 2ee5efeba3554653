// SPDX-License-Identifier: MIT
#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/outlines/pieces.h"
#include "scenes/file/table_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace dsc::scenes {

namespace {

using Vec = Point<double>;
using std::numbers::pi;

/// Edges of one curve.
constexpr double most_edges = 100'000;

double cross(const Vec& a, const Vec& b) { return a.x() * b.y() - a.y() * b.x(); }

class SvgPathReader {
public:
    SvgPathReader(std::string_view text, double tolerance, double edge_length,
                  const std::string& where)
        : text_(text), tolerance_(tolerance), edge_length_(edge_length), where_(where) {}

    std::vector<Piece> read() {
        char command = 0;
        while (skip_separators(), at_ < text_.size()) {
            const char c = text_[at_];
            if (std::string_view("MmLlHhVvCcSsQqTtAaZz").find(c) != std::string_view::npos) {
                command = c;
                ++at_;
            } else if (command == 0 || command == 'Z' || command == 'z') {
                refuse("command missing", "one of M L H V C S Q T A Z, or in small letters");
            }
            if (!has_begun_ && command != 'M' && command != 'm') {
                refuse("a path does not begin here", "M or m first");
            }
            execute_command(command);
            // More pairs of numbers after a move are lines.
            command = command == 'M' ? 'L' : command == 'm' ? 'l' : command;
        }
        end_piece(false);
        return std::move(pieces_);
    }

private:
    [[noreturn]] void refuse(const std::string& what, const std::string& allowed) const {
        throw InputError(
            {.what = what + " at character " + std::to_string(at_ + 1) + " of the path",
             .where = where_,
             .value = at_ < text_.size() ? quoted_excerpt(text_.substr(at_)) : "the end",
             .allowed = allowed});
    }

    void skip_separators() {
        while (at_ < text_.size() &&
               std::string_view(" \t\r\n,").find(text_[at_]) != std::string_view::npos) {
            ++at_;
        }
    }

    double number() {
        skip_separators();
        const std::size_t begin = at_ < text_.size() && text_[at_] == '+' ? at_ + 1 : at_;
        double value = 0;
        const auto [stop, error] =
            std::from_chars(text_.data() + begin, text_.data() + text_.size(), value);
        if (error != std::errc{} || !(std::abs(value) <= largest_coordinate)) {
            refuse("no number", "a number from -1e6 to 1e6");
        }
        at_ = static_cast<std::size_t>(stop - text_.data());
        return value;
    }

    // The flags of an arc may be written without a separator.
    bool flag() {
        skip_separators();
        if (at_ >= text_.size() || (text_[at_] != '0' && text_[at_] != '1')) {
            refuse("no flag", "0 or 1");
        }
        return text_[at_++] == '1';
    }

    Vec pair(bool is_relative) {
        const double x = number();
        const double y = number();
        return is_relative ? Vec(here_ + Vec(x, y)) : Vec(x, y);
    }

    void add(const Vec& p) {
        if (!(std::abs(p.x()) <= largest_coordinate) || !(std::abs(p.y()) <= largest_coordinate)) {
            refuse("a point beyond all bounds before this", "coordinates from -1e6 to 1e6");
        }
        if (++count_ > most_points) {
            refuse("too many points", "at most 1000000");
        }
        here_ = p;
        if (points_.empty() || points_.back() != p) {
            points_.push_back(p);
        }
    }

    void end_piece(bool is_closed) {
        if (points_.size() > 1) {
            pieces_.push_back(piece_of(points_, is_closed));
        }
        points_.clear();
    }

    void execute_command(char command) {
        const bool is_relative = command >= 'a';
        const char kind = is_relative ? static_cast<char>(command - 'a' + 'A') : command;
        // After Z without M, the next subpath begins where the last one did.
        if (kind != 'M' && kind != 'Z' && points_.empty()) {
            points_.push_back(here_);
        }
        Vec control = here_; // the reflected control point, where the command before had one
        if ((kind == 'S' && last_kind_ == 'C') || (kind == 'T' && last_kind_ == 'Q')) {
            control = 2 * here_ - last_control_;
        }
        last_kind_ = 0;
        switch (kind) {
        case 'M':
            end_piece(false);
            start_ = pair(is_relative);
            has_begun_ = true;
            add(start_);
            break;
        case 'Z':
            end_piece(true);
            here_ = start_;
            break;
        case 'L': add(pair(is_relative)); break;
        case 'H': add({number() + (is_relative ? here_.x() : 0), here_.y()}); break;
        case 'V': add({here_.x(), number() + (is_relative ? here_.y() : 0)}); break;
        case 'C': control = pair(is_relative); [[fallthrough]];
        case 'S': {
            const Vec second = pair(is_relative);
            const Vec end = pair(is_relative);
            cubic(control, second, end);
            last_kind_ = 'C';
            last_control_ = second;
            break;
        }
        case 'Q': control = pair(is_relative); [[fallthrough]];
        case 'T':
            quadratic(control, pair(is_relative));
            last_kind_ = 'Q';
            last_control_ = control;
            break;
        default: arc(is_relative);
        }
    }

    // Enough edges for the tolerance, where the second derivative is at most so large, and for the
    // longest edge.
    [[nodiscard]] int edges(double second_derivative, double length) const {
        const double count =
            std::max({1.0, std::sqrt(second_derivative / (8 * tolerance_)), length / edge_length_});
        if (!(count <= most_edges)) {
            refuse("a curve before this needs too many edges", "at most 100000: a larger h");
        }
        return static_cast<int>(std::ceil(count));
    }

    void cubic(const Vec& b, const Vec& c, const Vec& d) {
        const Vec a = here_;
        const double bend = 6 * std::max((a - 2 * b + c).norm(), (b - 2 * c + d).norm());
        const int n = edges(bend, (b - a).norm() + (c - b).norm() + (d - c).norm());
        for (int i = 1; i < n; ++i) {
            const double t = static_cast<double>(i) / n;
            const double s = 1 - t;
            add(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
        }
        add(d);
    }

    void quadratic(const Vec& b, const Vec& c) {
        const Vec a = here_;
        const int n = edges(2 * (a - 2 * b + c).norm(), (b - a).norm() + (c - b).norm());
        for (int i = 1; i < n; ++i) {
            const double t = static_cast<double>(i) / n;
            const double s = 1 - t;
            add(s * s * a + 2 * s * t * b + t * t * c);
        }
        add(c);
    }

    // From the end points to the centre: W3C, "Scalable Vector Graphics (SVG) 2", appendix B.2.4.
    void arc(bool is_relative) {
        double rx = std::abs(number());
        double ry = std::abs(number());
        const double angle = number() * pi / 180;
        const bool is_large = flag();
        const bool sweeps = flag();
        const Vec from = here_;
        const Vec to = pair(is_relative);
        if (rx == 0 || ry == 0 || from == to) {
            add(to);
            return;
        }
        const Vec axis(std::cos(angle), std::sin(angle));
        const Vec half = 0.5 * (from - to);
        // In units in which the ellipse is a circle of radius 1.
        Vec p(half.dot(axis) / rx, cross(axis, half) / ry);
        if (const double reach = p.norm(); reach > 1) { // too small: scaled up until it fits
            rx *= reach;
            ry *= reach;
            p /= reach;
        }
        const double square = p.squaredNorm();
        const double off = std::sqrt(std::max(0.0, (1 - square) / square));
        const Vec centre = (is_large == sweeps ? -off : off) * Vec(p.y(), -p.x());
        const Vec first = p - centre;
        const Vec last = -p - centre;
        double turn = std::atan2(cross(first, last), first.dot(last));
        turn += sweeps && turn < 0 ? 2 * pi : !sweeps && turn > 0 ? -2 * pi : 0;
        const double begin = std::atan2(first.y(), first.x());
        const Vec middle = 0.5 * (from + to);
        const double radius = std::max(rx, ry);
        const int n = edges(radius * turn * turn, radius * std::abs(turn));
        for (int i = 1; i < n; ++i) {
            const double phi = begin + turn * i / n;
            const double u = rx * (std::cos(phi) + centre.x());
            const double v = ry * (std::sin(phi) + centre.y());
            add({middle.x() + u * axis.x() - v * axis.y(),
                 middle.y() + u * axis.y() + v * axis.x()});
        }
        add(to);
    }

    std::string_view text_;
    double tolerance_;
    double edge_length_;
    const std::string& where_;
    std::size_t at_ = 0;
    std::size_t count_ = 0;
    bool has_begun_ = false;
    Vec start_{0, 0};
    Vec here_{0, 0};
    char last_kind_ = 0; ///< C or Q, if the last command had a control point
    Vec last_control_{0, 0};
    std::vector<Vec> points_;
    std::vector<Piece> pieces_;
};

} // namespace

std::vector<Piece> read_svg_path(std::string_view text, double tolerance, double edge_length,
                                 const std::string& where) {
    return SvgPathReader(text, tolerance, edge_length, where).read();
}

} // namespace dsc::scenes
