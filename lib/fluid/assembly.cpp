// SPDX-License-Identifier: MIT
#include "fluid/assembly.h"

#include <Eigen/Dense>

namespace dsc {

namespace {

// Unknown 2 i + k of an element is component k of the velocity at node i, unknown 12 + i the
// pressure at vertex i.
using ElementMatrix = Eigen::Matrix<double, 15, 15>;
using ElementVector = Eigen::Matrix<double, 15, 1>;

struct Element {
    ElementMatrix matrix = ElementMatrix::Zero(); // symmetric
    ElementVector forces = ElementVector::Zero();
};

// The gradients of the barycentric coordinates, as columns.
Eigen::Matrix<double, 2, 3> slopes_of(const FrozenMesh& mesh, const FrozenTriangle& t,
                                      double area) {
    Eigen::Matrix<double, 2, 3> slopes;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const Point<double> side = mesh.nodes[t.nodes[prev_index(static_cast<std::uint32_t>(i))]] -
                                   mesh.nodes[t.nodes[next_index(static_cast<std::uint32_t>(i))]];
        slopes.col(i) = Point<double>(-side.y(), side.x()) / (2 * area);
    }
    return slopes;
}

// Viscous stress, 2 mu D(u) : D(v), and the divergence.
void add_stress(Element& element, const Eigen::Matrix<double, 2, 3>& slopes, double area,
                double viscosity) {
    for (const QuadraturePoint& point : points_of_degree_2) {
        const Eigen::Matrix<double, 2, 6> gradients = quadratic_gradients(point.at, slopes);
        const double weight = area * point.weight;
        for (Eigen::Index i = 0; i < 6; ++i) {
            for (Eigen::Index j = 0; j < 6; ++j) {
                Eigen::Matrix2d block = gradients.col(j) * gradients.col(i).transpose();
                block.diagonal().array() += gradients.col(i).dot(gradients.col(j));
                element.matrix.block<2, 2>(2 * i, 2 * j) += weight * viscosity * block;
            }
        }
        for (int j = 0; const double pressure : point.at) {
            element.matrix.col(12 + j++).head<12>() -= weight * pressure * gradients.reshaped();
        }
    }
    element.matrix.bottomLeftCorner<3, 12>() = element.matrix.topRightCorner<12, 3>().transpose();
}

// The mean products of the shape functions.
Eigen::Matrix<double, 6, 6> mean_products() {
    Eigen::Matrix<double, 6, 6> products = Eigen::Matrix<double, 6, 6>::Zero();
    for (const QuadraturePoint& point : points_of_degree_5) {
        const Eigen::Matrix<double, 6, 1> shapes = quadratic_shapes(point.at);
        for (Eigen::Index j = 0; j < 6; ++j) {
            products.col(j) += point.weight * shapes[j] * shapes;
        }
    }
    return products;
}

void add_inertia(Element& element, const Eigen::Matrix<double, 6, 6>& products, double mass_rate) {
    for (Eigen::Index j = 0; j < 6; ++j) {
        for (Eigen::Index i = 0; i < 6; ++i) {
            const double inertia = mass_rate * products(i, j);
            element.matrix(2 * i, 2 * j) += inertia;
            element.matrix(2 * i + 1, 2 * j + 1) += inertia;
        }
    }
}

void add_force(Element& element, const QuadraturePoint& point, const Point<double>& force) {
    const Eigen::Matrix<double, 6, 1> shapes = quadratic_shapes(point.at);
    for (Eigen::Index i = 0; i < 6; ++i) {
        element.forces.segment<2>(2 * i) += point.weight * shapes[i] * force;
    }
}

// The velocity in the middle of an edge between phases is the mean of its ends: half of its
// equations go to each end.
void tie_middle(Element& element, Eigen::Index i) {
    const Eigen::Index middle = 2 * (3 + i);
    for (const Eigen::Index end : {2 * ((i + 1) % 3), 2 * ((i + 2) % 3)}) {
        element.matrix.middleRows<2>(end) += element.matrix.middleRows<2>(middle) / 2;
        element.forces.segment<2>(end) += element.forces.segment<2>(middle) / 2;
    }
    for (const Eigen::Index end : {2 * ((i + 1) % 3), 2 * ((i + 2) % 3)}) {
        element.matrix.middleCols<2>(end) += element.matrix.middleCols<2>(middle) / 2;
    }
}

class Assembler {
public:
    Assembler(const FluidNumbering& numbers, std::size_t triangles) : numbers_(numbers) {
        system_.forces = Eigen::VectorXd::Zero(numbers.size);
        system_.pressure_scale = Eigen::VectorXd::Zero(numbers.size);
        entries_.reserve(120 * triangles);
    }

    void add(int i, int j, double entry) {
        if (i >= j && j != no_unknown) {
            entries_.emplace_back(i, j, entry);
        }
    }
    void add_force(int i, double force) {
        if (i != no_unknown) {
            system_.forces[i] += force;
        }
    }
    void add(const FrozenMesh& mesh, std::size_t t, const Element& element) {
        const FrozenTriangle& triangle = mesh.triangles[t];
        Eigen::Matrix<int, 15, 1> unknowns;
        for (int i = 0; const std::uint32_t node : triangle.nodes) {
            unknowns[i++] = numbers_.velocity[node][0];
            unknowns[i++] = numbers_.velocity[node][1];
        }
        unknowns.tail<3>() = Eigen::Map<const Eigen::Vector3i>(numbers_.pressure[t].data());
        for (Eigen::Index i = 0; i < 15; ++i) {
            add_force(unknowns[i], element.forces[i]);
            for (Eigen::Index j = 0; j < 15; ++j) {
                add(unknowns[i], unknowns[j], element.matrix(i, j));
            }
        }
    }
    void add_pressure_scale(std::size_t t, double scale) {
        for (const int i : numbers_.pressure[t]) {
            if (i != no_unknown) {
                system_.pressure_scale[i] += scale;
            }
        }
    }
    [[nodiscard]] FluidSystem finish() {
        system_.matrix.resize(numbers_.size, numbers_.size);
        system_.matrix.setFromTriplets(entries_.begin(), entries_.end());
        return std::move(system_);
    }

private:
    const FluidNumbering& numbers_;
    std::vector<Eigen::Triplet<double>> entries_;
    FluidSystem system_;
};

void add_tension(Assembler& assembler, const FrozenMesh& mesh, const FluidNumbering& numbers,
                 const FluidOptions& options, const FluidPast& past, double time) {
    for (const FrozenEdge& edge : mesh.interface) {
        const Point<double>& from = mesh.nodes[edge.from];
        const Point<double>& to = mesh.nodes[edge.to];
        const double pull = tension_of(options, edge.left, edge.right) / (to - from).norm();
        Point<double> force = pull * (to - from);
        double resistance = 0;
        if (past.one != nullptr) {
            resistance = pull * options.implicitness * (time - past.one->time);
            force -= resistance * (last_velocity(past, to, time, edge.to) -
                                   last_velocity(past, from, time, edge.from));
        }
        for (const std::size_t k : {0U, 1U}) {
            const int a = numbers.velocity[edge.from][k];
            const int b = numbers.velocity[edge.to][k];
            assembler.add_force(a, k == 0 ? force.x() : force.y());
            assembler.add_force(b, k == 0 ? -force.x() : -force.y());
            assembler.add(a, a, resistance);
            assembler.add(b, b, resistance);
            assembler.add(std::max(a, b), std::min(a, b), -resistance);
        }
    }
}

} // namespace

FluidSystem assemble(const FrozenMesh& mesh, const FluidNumbering& numbers,
                     const FluidOptions& options, const FluidPast& past, double time) {
    const bool has_inertia = options.equations == FluidEquations::navier_stokes;
    const auto accelerations = has_inertia ? past_accelerations(mesh, past, time)
                                           : std::vector<std::array<Point<double>, 7>>();
    const double rate = has_inertia ? backward_difference(past, time).now : 0;
    const Eigen::Matrix<double, 6, 6> products = mean_products();
    // A wave of the size of the domain has this squared length, over (2 pi)^2 or so.
    const double extent = (mesh.domain.high - mesh.domain.low).squaredNorm() / 10;
    Assembler assembler(numbers, mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const FrozenTriangle& triangle = mesh.triangles[t];
        const FluidPhase& fluid = fluid_of(options, triangle.phase);
        const double size = area(mesh, triangle);
        Element element;
        add_stress(element, slopes_of(mesh, triangle, size), size, fluid.viscosity);
        if (has_inertia) {
            add_inertia(element, products, size * fluid.density * rate);
        }
        for (std::size_t q = 0; q < points_of_degree_5.size(); ++q) {
            const Point<double> past_part = has_inertia ? accelerations[t][q] : Point<double>(0, 0);
            add_force(element, points_of_degree_5[q],
                      size * fluid.density * (options.gravity - past_part));
        }
        for (const std::uint32_t i : {0U, 1U, 2U}) {
            if (numbers.is_middle_of_phases[triangle.nodes[3 + i]] != 0) {
                tie_middle(element, i);
            }
        }
        assembler.add(mesh, t, element);
        assembler.add_pressure_scale(t,
                                     size / 3 / (fluid.viscosity + fluid.density * rate * extent));
    }
    add_tension(assembler, mesh, numbers, options, past, time);
    return assembler.finish();
}

} // namespace dsc
