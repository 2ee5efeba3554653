// SPDX-License-Identifier: MIT
// What a simulation carries from one step to the next, as bytes.
#include "dsc/algorithm/simulation.h"

#include "dsc/complex/complex.h"
#include "dsc/queries/validate.h"

namespace dsc {

template <class Real>
void Simulation<Real>::archive(Archive& archive) {
    if (archive.is_reading()) {
        is_whole_ = false; // until all has been read
    } else {
        expect_whole("Simulation::archive");
    }
    archive(complex_, fastest_, most_dt_, swept_);
    std::uint64_t absorbed = absorbed_;
    archive(absorbed);
    archive.expect(absorbed <= complex_.journal.records.size(),
                   "has read edits that were not made");
    absorbed_ = static_cast<std::size_t>(absorbed);
    executor_->archive(archive);
    for (const auto& stage : stages_) {
        stage->archive(archive);
    }
    if (archive.is_reading()) {
        if (const ValidationReport report = validate(complex_); !report.ok()) {
            archive.refuse("holds no valid complex: " + report.problem);
        }
        is_whole_ = true;
    }
}

template void Simulation<double>::archive(Archive&);
template void Simulation<float>::archive(Archive&);

} // namespace dsc
