// SPDX-License-Identifier: MIT
// A simulation for Python, with its mesh, its stages and the report of the last step.
#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/stage.h"
#include "dsc/base/names.h"
#include "dsc/parallel/executors.h"
#include "dsc/passes/algorithm.h"
#include "python/flows.h"
#include "python/module.h"
#include "python/options.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dsc::python {

namespace {

py::dict event_of(const Event& event) {
    return py::dict("kind"_a = std::string(to_string(event.kind)), "time"_a = event.time,
                    "place"_a = std::pair(event.x, event.y), "lost"_a = event.lost,
                    "taken"_a = std::pair(event.taken[0], event.taken[1]), "area"_a = event.area);
}

// After each sub-step, records the progress of the step and runs signal handlers: their exceptions,
// such as KeyboardInterrupt, end the step.
class Watch final : public Stage<double> {
public:
    StepReport so_far;
    void run(const Between<double>& between) override {
        ++so_far.sub_steps;
        so_far.unreached += between.unreached;
        so_far.reached = between.time;
        so_far.interface_vertices = static_cast<std::uint32_t>(between.interface.size());
        const py::gil_scoped_acquire gil;
        if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
        }
    }
};

// A simulation with its mesh, its stages and the report of the last step.
class Running {
public:
    Running(std::shared_ptr<Mesh> mesh, const AnyFlow* flow, const py::dict& keywords)
        : mesh_(std::move(mesh)) {
        apply(choices_, keywords);
        const auto change = mesh_->change();     // refused while a step of it runs
        const py::gil_scoped_release others_run; // sizes may be functions of Python
        Complex<double>& complex = mesh_->complex_to_step();
        complex.in_use.expect_free();
        forget_foreign_data(complex);
        const Options<double>& options = choices_.options;
        check_options(options);
        const std::optional<Parallel> parallel = choices_.parallel();
        const auto algorithm = flow != nullptr && flow->growth
                                   ? growth_algorithm(complex, *flow->growth)
                                   : default_algorithm<double>();
        auto executor = parallel ? make_executor(complex, options, *parallel, algorithm)
                                 : std::make_unique<Executor<double>>(complex, options, algorithm);
        simulation_ = std::make_unique<Simulation<double>>(complex, options, std::move(executor));
        simulation_->add_stage(watch_);
        if (choices_.topology.changes()) {
            topology_ = std::make_shared<TopologyStage<double>>(choices_.topology);
            simulation_->add_stage(topology_);
        }
    }

    [[nodiscard]] const std::shared_ptr<Mesh>& mesh() const { return mesh_; }
    [[nodiscard]] py::dict options() const { return values_of(choices_); }
    [[nodiscard]] double time() const { return report_.reached; }
    // The report of the last step, with the names of dsc/records.py.
    [[nodiscard]] py::dict report() const {
        py::list events;
        for (const Event& event : events_) {
            events.append(event_of(event));
        }
        return py::dict("unreached"_a = report_.unreached, "held"_a = report_.held,
                        "sub_steps"_a = report_.sub_steps,
                        "interface_vertices"_a = report_.interface_vertices,
                        "reached"_a = report_.reached,
                        "gave_up"_a = report_.gave_up == GiveUp::none
                                          ? std::string()
                                          : std::string(name_in(give_up_names, report_.gave_up)),
                        "events"_a = events, "reason"_a = sentence(report_));
    }
    [[nodiscard]] std::size_t interface_size() const {
        (void)mesh_->complex(); // refused while a step runs
        return simulation_->interface_size();
    }

    void step(const AnyFlow& flow, double time, double dt) {
        const auto change = mesh_->change();
        watch_->so_far = {};
        watch_->so_far.reached = time;
        try {
            const py::gil_scoped_release others_run;
            report_ = flow.step(*simulation_, time, dt);
        } catch (const InputError&) {
            if (watch_->so_far.sub_steps > 0) { // false: the step was refused and nothing has moved
                note_failure();
            }
            throw;
        } catch (...) {
            note_failure();
            throw;
        }
        note_events();
    }

    [[nodiscard]] py::bytes state() {
        (void)mesh_->complex(); // refused while a step runs
        Archive archive;
        archive(report_.reached);
        simulation_->archive(archive);
        return archive.bytes();
    }
    void restore(const std::string& bytes) {
        const auto change = mesh_->change();
        Archive archive(bytes, "simulation");
        as_a_whole(archive, [this](Archive& each) {
            each(report_.reached);
            simulation_->archive(each);
            if (each.is_reading()) {
                each.expect_end();
            }
        });
    }

private:
    void note_failure() {
        report_ = watch_->so_far;
        note_events();
    }
    void note_events() { events_ = topology_ ? topology_->take_events() : std::vector<Event>(); }

    std::shared_ptr<Mesh> mesh_;
    Choices choices_;
    StepReport report_;         ///< of the last step...
    std::vector<Event> events_; ///< ...and the changes of topology in it
    std::shared_ptr<Watch> watch_ = std::make_shared<Watch>();
    std::shared_ptr<TopologyStage<double>> topology_;
    std::unique_ptr<Simulation<double>> simulation_;
};

} // namespace

void add_simulation(py::module_& module) {
    module.attr("option_help") = option_help();

    py::class_<Running>(module, "Simulation")
        .def(py::init<std::shared_ptr<Mesh>, const AnyFlow*, const py::dict&>(),
             py::keep_alive<1, 2>()) // the Python object of the mesh
        .def("step", &Running::step)
        .def("report", &Running::report)
        .def("state", &Running::state)
        .def("restore", &Running::restore)
        .def_property_readonly("mesh", &Running::mesh)
        .def_property_readonly("time", &Running::time)
        .def_property_readonly("options", &Running::options)
        .def_property_readonly("interface_size", &Running::interface_size);
}

} // namespace dsc::python
