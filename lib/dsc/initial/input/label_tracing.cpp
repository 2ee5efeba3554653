// SPDX-License-Identifier: MIT
#include "dsc/initial/input/label_tracing.h"

#include <array>
#include <optional>
#include <utility>

namespace dsc::initial {

namespace {

// Directions are counted counter-clockwise from that of x.
constexpr std::array<std::array<int, 2>, 4> ways{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

constexpr int opposite(int way) { return (way + 2) % 4; }

class Tracing {
public:
    Tracing(const LabelImage& image, const Grains& grains)
        : image_(image), grains_(grains), columns_(static_cast<int>(image.columns)),
          rows_(static_cast<int>(image.rows)),
          done_((image.columns + 1) * (image.rows + 1) * 2, 0) {}

    void run() {
        const std::size_t corners = (image_.columns + 1) * (image_.rows + 1);
        node_at_.assign(corners, no_id);
        for (int y = 0; y <= rows_; ++y) {
            for (int x = 0; x <= columns_; ++x) {
                if (is_node(x, y)) {
                    for (int way = 0; way < 4; ++way) {
                        follow(x, y, way);
                    }
                }
            }
        }
        for (int y = 0; y <= rows_; ++y) {
            for (int x = 0; x <= columns_; ++x) {
                follow(x, y, 0); // a closed boundary has horizontal sides
            }
        }
    }

    Boundaries take() { return std::move(found_); }

private:
    // The index of the pixel above and to the right of a corner.
    [[nodiscard]] std::size_t pixel(int x, int y) const {
        return static_cast<std::size_t>(rows_ - 1 - y) * image_.columns +
               static_cast<std::size_t>(x);
    }
    // The pixels on the left and on the right of a step from a corner; none if the step leads
    // outside or along a side of the image.
    [[nodiscard]] std::optional<std::array<std::size_t, 2>> beside(int x, int y, int way) const {
        // Offsets from a corner to the pixels around it, counter-clockwise from the upper right
        // one.
        constexpr std::array<std::array<int, 2>, 4> around{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
        std::array<std::size_t, 2> found{};
        for (std::size_t i = 0; i < 2; ++i) {
            const auto& [dx, dy] = around[(static_cast<std::size_t>(way) + 3 * i) % 4];
            if (x + dx < 0 || x + dx >= columns_ || y + dy < 0 || y + dy >= rows_) {
                return std::nullopt;
            }
            found[i] = pixel(x + dx, y + dy);
        }
        return found;
    }
    [[nodiscard]] bool leads(int x, int y, int way) const {
        const auto pixels = beside(x, y, way);
        return pixels && image_.labels[(*pixels)[0]] != image_.labels[(*pixels)[1]];
    }
    [[nodiscard]] bool is_node(int x, int y) const {
        int arms = 0;
        for (int way = 0; way < 4; ++way) {
            arms += leads(x, y, way) ? 1 : 0;
        }
        return arms != 0 && arms != 2;
    }
    // The direction in which a boundary continues from a corner that is not a node, after arriving
    // in the direction `way`.
    [[nodiscard]] int next_way(int x, int y, int way) const {
        for (int other = 0; other < 4; ++other) {
            if (other != opposite(way) && leads(x, y, other)) {
                return other;
            }
        }
        return opposite(way);
    }
    [[nodiscard]] std::uint8_t& done(int x, int y, int way) {
        const int left = way == 2 ? x - 1 : x;
        const int low = way == 3 ? y - 1 : y;
        const auto corner =
            static_cast<std::size_t>(low) * (image_.columns + 1) + static_cast<std::size_t>(left);
        return done_[2 * corner + static_cast<std::size_t>(way % 2)];
    }

    std::uint32_t node(int x, int y) {
        std::uint32_t& id = node_at_[static_cast<std::size_t>(y) * (image_.columns + 1) +
                                     static_cast<std::size_t>(x)];
        if (id == no_id) {
            const bool is_upright = x == 0 || x == columns_;
            const bool is_end = is_upright || y == 0 || y == rows_;
            id = add({x, y}, is_end ? Site::Kind::end : Site::Kind::junction);
            found_.sites[id].slides_upright = is_upright;
        }
        return id;
    }
    std::uint32_t add(const Point<double>& place, Site::Kind kind) {
        found_.sites.push_back({.first = place, .place = place, .kind = kind});
        return static_cast<std::uint32_t>(found_.sites.size() - 1);
    }

    void follow(int x, int y, int way) {
        if (!leads(x, y, way) || done(x, y, way) != 0) {
            return;
        }
        Boundary& boundary = found_.boundaries.emplace_back();
        const auto pixels = *beside(x, y, way);
        boundary.left = grains_.of_pixel[pixels[0]];
        boundary.right = grains_.of_pixel[pixels[1]];
        boundary.left_phase = image_.labels[pixels[0]];
        boundary.right_phase = image_.labels[pixels[1]];
        if (is_node(x, y)) {
            boundary.sites.push_back(node(x, y));
        }
        while (done(x, y, way) == 0) {
            done(x, y, way) = 1;
            const auto& [dx, dy] = ways[static_cast<std::size_t>(way)];
            boundary.first_area += x * dy;
            boundary.sites.push_back(add({x + 0.5 * dx, y + 0.5 * dy}, Site::Kind::side_of_pixels));
            x += dx;
            y += dy;
            if (is_node(x, y)) {
                boundary.sites.push_back(node(x, y));
                return;
            }
            way = next_way(x, y, way);
        }
        boundary.sites.push_back(boundary.sites.front());
    }

    Boundaries found_;
    const LabelImage& image_;
    const Grains& grains_;
    int columns_;
    int rows_;
    std::vector<std::uint8_t> done_;     // by corner: the sides to its right, and above it
    std::vector<std::uint32_t> node_at_; // by corner
};

} // namespace

Boundaries trace_boundaries(const LabelImage& image, const Grains& grains) {
    Tracing tracing(image, grains);
    tracing.run();
    return tracing.take();
}

} // namespace dsc::initial
