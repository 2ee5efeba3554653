// SPDX-License-Identifier: MIT
// The parameters of a scene, which can be set by the keys in keys.h.
#pragma once

#include "dsc/base/names.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/passes/options.h"
#include "scenes/integrator_choice.h"
#include "topology/options.h"

#include <cstdint>

namespace dsc::scenes {

enum class RealType : std::uint8_t { double_precision, single_precision };

inline constexpr std::array real_type_names{
    Named{RealType::double_precision, "double"},
    Named{RealType::single_precision, "float"},
};

[[nodiscard]] constexpr std::string_view to_string(RealType real) {
    return name_in(real_type_names, real);
}

/// The size of the triangles of a phase.
enum class Fineness : std::uint8_t { fine, coarse };

inline constexpr std::array fineness_names{
    Named{Fineness::fine, "fine"},
    Named{Fineness::coarse, "coarse"},
};

/// How a value rises from 0 to 1.
enum class Ramp : std::uint8_t {
    quadratic, ///< with a continuous slope: linear interpolation is of second order
    linear,    ///< as in the thesis, with a kink: of first order there
};

inline constexpr std::array ramp_names{
    Named{Ramp::quadratic, "quadratic"},
    Named{Ramp::linear, "linear"},
};

inline constexpr std::array no_or_yes{Named{false, "no"}, Named{true, "yes"}};

struct Parameters {
    double h = 0.02;         ///< target edge length, in units of the domain
    double dt = 0.01;        ///< time step
    int steps = 0;           ///< time steps; for the swirl: each way
    double period = 0;       ///< duration of a flow that turns back; 0: none
    double angle = 0;        ///< angle between the x axis and the rays of four sectors, in degrees
    int grains = 0;          ///< grains, bubbles or discs at the start; 0: chosen from h
    std::uint64_t sites = 0; ///< draws the places of discs
    double nucleation = 0;   ///< discs that appear later, per unit of area and time
    Fineness inside = Fineness::fine;  ///< triangles of the shape
    Fineness outside = Fineness::fine; ///< of the exterior
    Ramp ramp = Ramp::quadratic; ///< form of the rise of a value from the first radius to the last
    IntegratorChoice integrator = IntegratorChoice::rk4;
    double tolerance = Options<double>{}.tolerance; ///< of `adaptive`, in edge lengths
    Insertion insertion = Insertion::cubic;
    InterfaceThresholds interface {};
    Topology topology = Topology::keep; ///< of all pairs of phases
    double contact = 0;  ///< thickness at which a film opens, a length; 0: the library's default
    double min_area = 1; ///< smaller pieces vanish; in squared edge lengths
    bool follows_seams = true; ///< whether the opening of a film continues along it
    double grade = 0;          ///< growth factor from one edge to the next; 0: uniform lengths
    bool gives_back = false;   ///< whether area lost in changes of topology is restored
    Detail detail = InitialOptions{}.detail; ///< treatment of detail finer than the mesh
    double border_tolerance = InitialOptions{}.border_tolerance; ///< in edge lengths
    Coverage coverage = InitialOptions{}.coverage;               ///< treatment of gaps and overlaps
    RealType real = RealType::double_precision;
    std::uint64_t seed = 0; ///< shuffles the order in which interface vertices are visited; 0: no
};

} // namespace dsc::scenes
