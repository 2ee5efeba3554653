// SPDX-License-Identifier: MIT
#include "methods.h"

namespace dsc::bench {

std::string to_string(Group group) {
    switch (group) {
    case Group::base: return "default";
    case Group::time: return "time";
    case Group::upkeep: return "upkeep";
    case Group::other: return "other";
    case Group::markers: return "markers";
    }
    return "unknown";
}

const std::vector<Method>& precision_methods() {
    static const std::vector<Method> methods{
        {.name = "default", .group = Group::base, .to_the_last = true},

        {.name = "euler",
         .group = Group::time,
         .settings = {{"integrator", "euler"}},
         .step = Method::Step::with_square,
         .most_lengths = 3}, // a fourth takes longer than all other methods together
        {.name = "centred", .group = Group::time, .settings = {{"integrator", "centred"}}},
        {.name = "midpoint", .group = Group::time, .settings = {{"integrator", "midpoint"}}},
        {.name = "adaptive",
         .group = Group::time,
         .settings = {{"integrator", "adaptive"}, {.key = "tolerance", .factor = 0.1, .power = 2}},
         .step_factor = 8},

        {.name = "linear insertion", .group = Group::upkeep, .settings = {{"insertion", "linear"}}},
        {.name = "arc insertion", .group = Group::upkeep, .settings = {{"insertion", "arc"}}},
        {.name = "coarsening by length",
         .group = Group::upkeep,
         .settings = {{"coarsening", "length"}}},
        {.name = "coarsening by area",
         .group = Group::upkeep,
         .settings = {{"coarsening", "area"}}},
        {.name = "never coarsened",
         .group = Group::upkeep,
         .settings = {{"coarsening", "never"}},
         .to_the_last = true},

        {.name = "fourth order",
         .group = Group::other,
         .settings = {{"reading", "cubic"}, {"coarsening", "never"}},
         .to_the_last = true,
         .reads_curves = true},

        // As accurate with a fraction of the vertices, and angles that stay good.
        {.name = "fourth order, coarsened",
         .group = Group::other,
         .settings = {{"reading", "cubic"}, {.key = "deviation", .factor = 26844, .power = 4}},
         .to_the_last = true,
         .reads_curves = true},

        {.name = "float", .group = Group::other, .settings = {{"real", "float"}}},
        {.name = "thesis's choice",
         .group = Group::other,
         .settings = {{"integrator", "centred"},
                      {"insertion", "linear"},
                      {"coarsening", "length"}}},
        {.name = "literal reference",
         .group = Group::other,
         .most_lengths = 1,
         .in_quick = false,
         .strategy = scenes::Strategy::reference},

        {.name = "markers, linear",
         .group = Group::markers,
         .to_the_last = true,
         .markers = BareMarkers{.cubic = false, .shortest_over_h = 0.3}},
        {.name = "markers, cubic",
         .group = Group::markers,
         .to_the_last = true,
         .markers = BareMarkers{.shortest_over_h = 0.3}},
        {.name = "markers, cubic, all kept",
         .group = Group::markers,
         .to_the_last = true,
         .markers = BareMarkers{}},
        {.name = "markers, read as cubic, all kept",
         .group = Group::markers,
         .to_the_last = true,
         .markers = BareMarkers{.parts = 16}},
    };
    return methods;
}

} // namespace dsc::bench
