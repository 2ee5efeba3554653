// SPDX-License-Identifier: MIT
#include "fluid/field/convection.h"

namespace dsc {

namespace {

// Interpolates velocities; each search starts where the last one ended.
class Reader {
public:
    Reader(const FluidPast& past, std::uint32_t near)
        : past_(past), one_(start_at(past.one->mesh, near)),
          two_(past.two == nullptr ? 0 : start_at(past.two->mesh, near)) {}

    [[nodiscard]] Point<double> one(const Point<double>& at) { return look(*past_.one, at, one_); }
    [[nodiscard]] Point<double> two(const Point<double>& at) { return look(*past_.two, at, two_); }
    [[nodiscard]] Point<double> extrapolated(const Point<double>& at, double time) {
        Point<double> velocity = one(at);
        if (past_.two != nullptr) {
            const double share = (time - past_.one->time) / (past_.one->time - past_.two->time);
            if (share != 0) {
                velocity += share * (velocity - two(at));
            }
        }
        return velocity;
    }

private:
    static Point<double> look(const FluidField& field, const Point<double>& at,
                              std::uint32_t& start) {
        const Spot spot = find_spot(field.mesh, at, start);
        start = spot.triangle;
        return velocity_at(field, spot);
    }

    const FluidPast& past_;
    std::uint32_t one_;
    std::uint32_t two_;
};

// The position at the time `duration` ago of a particle with a velocity of about `guess`, by the
// midpoint rule.
Point<double> foot(Reader& reader, const Point<double>& at, double time, double duration,
                   const Point<double>& guess) {
    const Point<double> half = at - duration / 2 * guess;
    return at - duration * reader.extrapolated(half, time - duration / 2);
}

} // namespace

BackwardDifference backward_difference(const FluidPast& past, double time) {
    const double dt = time - past.one->time;
    if (past.two == nullptr) {
        return {1 / dt, -1 / dt, 0};
    }
    const double ratio = dt / (past.one->time - past.two->time);
    return {(1 + 2 * ratio) / (1 + ratio) / dt, -(1 + ratio) / dt,
            ratio * ratio / (1 + ratio) / dt};
}

Point<double> extrapolated_velocity(const FluidPast& past, const Point<double>& at, double time,
                                    std::uint32_t near) {
    return Reader(past, near).extrapolated(at, time);
}

Point<double> last_velocity(const FluidPast& past, const Point<double>& at, double time,
                            std::uint32_t near) {
    Reader reader(past, near);
    return reader.one(at - (time - past.one->time) * reader.one(at));
}

std::array<Point<double>, 7> past_accelerations(const MeshSnapshot& mesh,
                                                const SnapshotTriangle& triangle,
                                                const FluidPast& past, double time) {
    const BackwardDifference difference = backward_difference(past, time);
    const double dt = time - past.one->time;
    std::array<Point<double>, 7> accelerations;
    Reader reader(past, triangle.nodes[0]);
    for (std::size_t q = 0; q < 7; ++q) {
        const Barycentric& l = points_of_degree_5[q].at;
        const Point<double> at = l[0] * mesh.nodes[triangle.nodes[0]] +
                                 l[1] * mesh.nodes[triangle.nodes[1]] +
                                 l[2] * mesh.nodes[triangle.nodes[2]];
        const Point<double> one = reader.one(foot(reader, at, time, dt, reader.one(at)));
        accelerations[q] = difference.one * one;
        if (past.two != nullptr) {
            const double both = time - past.two->time;
            accelerations[q] += difference.two * reader.two(foot(reader, at, time, both, one));
        }
    }
    return accelerations;
}

} // namespace dsc
