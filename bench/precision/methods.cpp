// SPDX-License-Identifier: MIT
#include "methods.h"

#include "dsc/base/names.h"
#include "scenes/parameters.h"

namespace dsc::bench {

std::string to_string(Group group) {
    switch (group) {
    case Group::base: return "default";
    case Group::time: return "time";
    case Group::remeshing: return "remeshing";
    case Group::other: return "other";
    case Group::markers: return "markers";
    }
    return "unknown";
}

namespace {

// One method for each non-default value of an option.
template <class Enum, std::size_t n, class Make>
void add_others(std::vector<Method>& methods, const EnumTable<Enum, n>& table, Enum standard,
                Make make) {
    for (const auto& [value, name] : table) {
        if (value != standard) {
            methods.push_back(make(value, std::string(name)));
        }
    }
}

Method of_time(scenes::IntegratorChoice integrator, const std::string& name) {
    Method method{.name = name, .group = Group::time, .settings = {{"integrator", name}}};
    if (integrator == scenes::IntegratorChoice::euler) {
        method.step = Method::Step::with_square;
        method.max_lengths = 3; // a fourth takes longer than all other methods together
    } else if (integrator == scenes::IntegratorChoice::adaptive) {
        method.settings.push_back({.key = "tolerance", .factor = 0.1, .power = 2});
        method.step_factor = 8;
    }
    return method;
}

Method of_insertion(Insertion, const std::string& name) {
    return {
        .name = name + " insertion", .group = Group::remeshing, .settings = {{"insertion", name}}};
}

Method of_coarsening(Coarsening coarsening, const std::string& name) {
    const bool never = coarsening == Coarsening::never;
    return {.name = never ? "never coarsened" : "coarsening by " + name,
            .group = Group::remeshing,
            .settings = {{"coarsening", name}},
            .to_the_last = never};
}

std::vector<Method> make_methods() {
    const scenes::Parameters standard;
    std::vector<Method> methods{{.name = "default", .group = Group::base, .to_the_last = true}};
    add_others(methods, scenes::integrator_choice_names, standard.integrator, of_time);
    add_others(methods, insertion_names, standard.insertion, of_insertion);
    add_others(methods, coarsening_names, standard.interface.coarsening, of_coarsening);
    const std::vector<Method> others{
        {.name = "fourth order",
         .group = Group::other,
         .settings = {{"reading", "cubic"}, {"coarsening", "never"}},
         .to_the_last = true,
         .reads_curves = true},

        // Equally accurate with a fraction of the vertices and with good angles.
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
         .max_lengths = 1,
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
    methods.insert(methods.end(), others.begin(), others.end());
    return methods;
}

} // namespace

const std::vector<Method>& precision_methods() {
    static const std::vector<Method> methods = make_methods();
    return methods;
}

} // namespace dsc::bench
