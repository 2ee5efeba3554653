// SPDX-License-Identifier: MIT
#include "python/options3.h"

#include "python/option_table.h"

namespace dsc::python {

namespace {

// clang-format off: a row is a line or two
template <class AnyChoices, class Visit>
void for_each_option3(AnyChoices& choices, Use use, Visit visit) {
    if (use == Use::initial_complex) {
        auto& initial = choices.initial;
        visit("edge_length", initial.edge_length,
              "target length of interface edges, in units of the domain");
        visit("growth", initial.growth,
              "of the largest edge length per distance to the nearest shape");
        visit("improve_rounds", initial.improve_rounds,
              "rounds of interface remeshing and mesh repair");
        visit("max_tets", initial.max_tets, "more are refused: 2e7 need about four gigabytes");
        return;
    }
    auto& options = choices.options;
    auto& interface = options.interface;
    visit("edge_length", options.edge_length,
          "target length of interface edges, in units of the domain");
    visit("longest", interface.longest, "longer interface edges are split, in edge lengths");
    visit("shortest", interface.shortest, "shorter ones are collapsed, in edge lengths...");
    visit("deviation", interface.deviation,
          "if the removed vertex lies within this distance of the new interface, in edge lengths,");
    visit("always", interface.always, "or the edge is shorter than this, in edge lengths");
    visit("quality", options.quality, "changed tets below this quality are improved");
    visit("move_quality", options.move_quality, "moves keep tets above this quality, if they were");
    visit("layers", options.layers, "of vertices beside the interface that move along with it");
    visit("integrator", options.integrator, "how targets are found from velocities");
    visit("tolerance", options.tolerance, "of the adaptive integrator, in edge lengths");
    visit("sub_step", options.sub_step,
          "the largest displacement of a vertex in a sub-step, in edge lengths");
    visit("max_sub_steps", options.max_sub_steps, "a step that needs more gives up");
    visit("max_passes", options.max_passes, "of movement and mesh repair, of a sub-step");
    visit("threads", choices.threads,
          "None: sequential; 1 to 1024: in submeshes, with the same result for any number");
    visit("submeshes", choices.submeshes,
          "a power of two up to 64; 0: chosen by the size of the interface");
}
// clang-format on

} // namespace

std::optional<dsc3::Parallel> Choices3::parallel() const {
    if (!threads && !submeshes) {
        return std::nullopt;
    }
    const dsc3::Parallel usual;
    return dsc3::Parallel{.threads = threads.value_or(usual.threads),
                          .submeshes = submeshes.value_or(usual.submeshes)};
}

void apply(Choices3& choices, const py::dict& given, Use use) {
    set_keywords(given,
                 use == Use::simulation ? "Simulation of a Mesh3" : "initial_complex in space",
                 [&](auto visit) { for_each_option3(choices, use, visit); });
}

py::dict values_of(const Choices3& choices) {
    return values_in([&](auto visit) { for_each_option3(choices, Use::simulation, visit); });
}

std::string option3_help(Use use) {
    const Choices3 defaults;
    return help_of([&](auto visit) { for_each_option3(defaults, use, visit); });
}

} // namespace dsc::python
