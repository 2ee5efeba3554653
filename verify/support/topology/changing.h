// SPDX-License-Identifier: MIT
// A simulation in which the topology may change, with its stage and options.
#pragma once

#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "topology/stage.h"

#include <memory>
#include <utility>
#include <vector>

namespace dsc::test {

/// Options of a simulation, and of its topology.
template <class Real>
struct ChangingOptions : Options<Real> {
    TopologyOptions<Real> topology = {};
};

/// The report of a step, including changes of topology.
struct ChangingReport : StepReport {
    std::vector<Event> events;
    AreaAccount area;
};

template <class Real>
class ChangingSimulation : public Simulation<Real> {
public:
    ChangingSimulation(Complex<Real>& complex, const ChangingOptions<Real>& options,
                       std::unique_ptr<Executor<Real>> executor = nullptr)
        : Simulation<Real>(complex, options, std::move(executor)),
          stage_(std::make_shared<TopologyStage<Real>>(options.topology)) {
        this->add_stage(stage_);
    }
    ChangingSimulation(Complex<Real>& complex, const ChangingOptions<Real>& options,
                       const Parallel& parallel)
        : ChangingSimulation(complex, options, make_executor<Real>(complex, options, parallel)) {}

    [[nodiscard]] TopologyStage<Real>& topology() { return *stage_; }
    void set_options(const ChangingOptions<Real>& options) {
        stage_->set_options(options.topology);
        Simulation<Real>::set_options(options);
    }
    template <class Flow>
    ChangingReport step(const Flow& flow, Real time, Real dt) {
        ChangingReport report{Simulation<Real>::step(flow, time, dt), {}, {}};
        report.events = stage_->take_events();
        report.area = stage_->take_area();
        return report;
    }

private:
    std::shared_ptr<TopologyStage<Real>> stage_;
};

} // namespace dsc::test
