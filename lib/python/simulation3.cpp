// SPDX-License-Identifier: MIT
// A simulation of tets for Python, with its mesh.
#include "python/flows.h"
#include "python/module.h"
#include "python/options3.h"

#include <memory>
#include <string>
#include <utility>

namespace dsc::python {

namespace {

py::dict counts_of(const dsc3::OperationCounts& counts) {
    return py::dict(
        "splits"_a = counts.splits, "collapses"_a = counts.collapses,
        "edge_removals"_a = counts.edge_removals, "face_flips"_a = counts.face_flips,
        "smoothings"_a = counts.smoothings, "interface_splits"_a = counts.interface_splits,
        "interface_collapses"_a = counts.interface_collapses,
        "interface_flips"_a = counts.interface_flips, "reassigned"_a = counts.reassigned);
}

class Running3 {
public:
    Running3(std::shared_ptr<Mesh3> mesh, const py::dict& keywords) : mesh_(std::move(mesh)) {
        apply(choices_, keywords);
        const auto change = mesh_->change(); // refused while a step of it runs
        dsc3::Complex& complex = mesh_->complex_to_step();
        const auto parallel = choices_.parallel();
        const py::gil_scoped_release others_run;
        simulation_ = parallel
                          ? std::make_unique<dsc3::Simulation>(complex, choices_.options, *parallel)
                          : std::make_unique<dsc3::Simulation>(complex, choices_.options);
    }

    [[nodiscard]] const std::shared_ptr<Mesh3>& mesh() const { return mesh_; }
    [[nodiscard]] py::dict options() const { return values_of(choices_); }
    [[nodiscard]] double time() const { return time_; }
    // The report of the last step, with the names of dsc/records.py.
    [[nodiscard]] py::dict report() const {
        const dsc3::StepReport& report = still().report();
        const bool gave_up = report.gave_up != GiveUp::none; // for one reason
        return py::dict("unreached"_a = report.unreached, "held"_a = report.held,
                        "sub_steps"_a = report.sub_steps,
                        "interface_vertices"_a = report.interface_vertices, "reached"_a = time_,
                        "gave_up"_a =
                            gave_up ? std::string(name_in(give_up_names, report.gave_up)) : "",
                        "reason"_a = gave_up ? "the step needs more than max_sub_steps sub-steps: "
                                               "the velocity is too large, or jumps"
                                             : "",
                        "passes"_a = report.passes, "unjammed"_a = report.unjammed,
                        "error"_a = report.error, "operations"_a = counts_of(report.operations));
    }
    [[nodiscard]] std::size_t interface_size() const { return still().interface().size(); }

    void step(const py::function& velocity, double time, double dt) {
        const auto change = mesh_->change();
        const dsc3::VelocityAtOnce at_once{velocity_of<3>(velocity)};
        try {
            const py::gil_scoped_release others_run;
            simulation_->step(at_once, time, dt);
        } catch (const InputError&) {
            if (simulation_->report().sub_steps > 0) { // false: the step was refused
                time_ = simulation_->report().reached;
            }
            throw;
        } catch (...) {
            time_ = simulation_->report().reached;
            throw;
        }
        time_ = simulation_->report().reached;
    }

    [[nodiscard]] py::bytes state() {
        (void)mesh_->complex(); // refused while a step runs
        Archive archive;
        archive(time_);
        simulation_->archive(archive);
        return archive.bytes();
    }
    void restore(const std::string& bytes) {
        const auto change = mesh_->change();
        Archive archive(bytes, "simulation");
        as_a_whole(archive, [this](Archive& each) {
            each(time_);
            simulation_->archive(each);
            if (each.is_reading()) {
                each.expect_end();
            }
        });
    }

private:
    // The simulation, between steps.
    [[nodiscard]] const dsc3::Simulation& still() const {
        (void)mesh_->complex(); // refused while a step runs
        return *simulation_;
    }

    std::shared_ptr<Mesh3> mesh_;
    Choices3 choices_;
    double time_ = 0;
    std::unique_ptr<dsc3::Simulation> simulation_;
};

} // namespace

void add_simulation3(py::module_& module) {
    module.attr("option3_help") = option3_help();

    py::class_<Running3>(module, "Simulation3")
        .def(py::init<std::shared_ptr<Mesh3>, const py::dict&>(),
             py::keep_alive<1, 2>()) // the Python object of the mesh
        .def("step", &Running3::step)
        .def("report", &Running3::report)
        .def("state", &Running3::state)
        .def("restore", &Running3::restore)
        .def_property_readonly("mesh", &Running3::mesh)
        .def_property_readonly("time", &Running3::time)
        .def_property_readonly("options", &Running3::options)
        .def_property_readonly("interface_size", &Running3::interface_size);
}

} // namespace dsc::python
