// SPDX-License-Identifier: MIT
#include "precision_methods.h"

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
        {.name = "default", .group = Group::base},

        {.name = "euler",
         .group = Group::time,
         .settings = {{"integrator", "euler"}},
         .step = Method::Step::with_square,
         .most_lengths = 3}, // a fourth takes longer than all other methods together
        {.name = "midpoint", .group = Group::time, .settings = {{"integrator", "midpoint"}}},

        {.name = "linear insertion", .group = Group::upkeep, .settings = {{"insertion", "linear"}}},

        {.name = "float", .group = Group::other, .settings = {{"real", "float"}}},
        {.name = "thesis's choice",
         .group = Group::other,
         .settings = {{"integrator", "midpoint"}, {"insertion", "linear"}}},
        {.name = "literal reference",
         .group = Group::other,
         .most_lengths = 1,
         .strategy = scenes::Strategy::reference},

        {.name = "markers, linear",
         .group = Group::markers,
         .markers = BareMarkers{.cubic = false, .shortest_over_h = 0.3}},
        {.name = "markers, cubic",
         .group = Group::markers,
         .markers = BareMarkers{.shortest_over_h = 0.3}},
        {.name = "markers, cubic, all kept", .group = Group::markers, .markers = BareMarkers{}},
        {.name = "markers, read as cubic, all kept",
         .group = Group::markers,
         .markers = BareMarkers{.parts = 16}},
    };
    return methods;
}

} // namespace dsc::bench
