// SPDX-License-Identifier: MIT
// Parallel DSC in one line: `Simulation simulation(complex, options, Parallel{.threads = 2})`.
#pragma once

#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/in_place/schedule.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace dsc {

struct DivisionEntry;

/// How the mesh is divided into submeshes: by one of the library's ways, one of a module, or one of
/// the application's own. Two are equal if their entries are the same object.
class Division {
public:
    /// The entry must outlive whatever uses the division.
    explicit constexpr Division(const DivisionEntry& entry) : entry_(&entry) {}
    /// Its properties.
    constexpr const DivisionEntry* operator->() const { return entry_; }
    friend bool operator==(const Division&, const Division&) = default;

    static const Division fixed;    ///< slabs of equal width (thesis, section 6.3)
    static const Division counting; ///< slabs of equal numbers of triangles (thesis, section 6.3)
    static const Division active;   ///< slabs of equal work
    static const Division blocks;   ///< cut in two directions
    static const Division cells;    ///< submeshes that follow the interface

private:
    const DivisionEntry* entry_;
};

namespace detail {
extern const DivisionEntry fixed_division;
extern const DivisionEntry counting_division;
extern const DivisionEntry active_division;
extern const DivisionEntry blocks_division;
extern const DivisionEntry cells_division;
} // namespace detail

inline constexpr Division Division::fixed{detail::fixed_division};
inline constexpr Division Division::counting{detail::counting_division};
inline constexpr Division Division::active{detail::active_division};
inline constexpr Division Division::blocks{detail::blocks_division};
inline constexpr Division Division::cells{detail::cells_division};

/// The result depends on the division, the number of submeshes and the direction, and on nothing
/// else here.
struct Parallel {
    /// 1 to 1024; fewer are used where there is too little to do, or where that takes no longer.
    std::uint32_t threads = 1;
    Division division = Division::cells; ///< how the mesh is divided
    std::uint32_t submeshes = 0;         ///< 0: the division's own choice
    double degrees = 0;                  ///< slabs are cut across this direction, from the x axis
    bool follow_shape = false;       ///< slabs are cut across the direction of the shape instead
    bool always_all_threads = false; ///< also if there is too little to do for them, or no gain
    /// Microseconds that threads wait awake between two steps before they sleep; nothing:
    /// `default_awake_time()`.
    std::optional<std::uint32_t> awake_us = std::nullopt;
    Assignment assignment = Assignment::queue; ///< which thread runs which submesh
    bool profile = false;                      ///< measure times (in_place/step_profile.h)
};

/// Makes an executor for either precision.
template <class Real>
using MakeExecutor = std::unique_ptr<Executor<Real>> (*)(Complex<Real>& complex,
                                                         const Options<Real>& options,
                                                         const Parallel& parallel,
                                                         Algorithm<Real> algorithm);

/// The properties of a division.
struct DivisionEntry {
    std::string_view name;          ///< on command lines and in files
    std::string_view description;   ///< one sentence, for help texts
    std::uint32_t submeshes;        ///< if no number is asked for; 0: chosen during the run
    MakeExecutor<double> in_double; ///< makes its executor
    MakeExecutor<float> in_float;   ///< makes its executor
};

/// The library's divisions, in their order.
[[nodiscard]] std::span<const Division> divisions();

/// The number of submeshes that results: the number asked for, or the division's default; 0: chosen
/// during the run.
[[nodiscard]] std::uint32_t submeshes_of(const Parallel& parallel);

/// The executor for these options, for an algorithm of your own. Throws InputError if the options
/// make no sense together, or while a simulation of the complex lives.
template <class Real>
[[nodiscard]] std::unique_ptr<Executor<Real>>
make_executor(Complex<Real>& complex, const Options<Real>& options, const Parallel& parallel,
              Algorithm<Real> algorithm = default_algorithm<Real>());

} // namespace dsc
