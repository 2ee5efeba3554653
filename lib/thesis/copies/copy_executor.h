// SPDX-License-Identifier: MIT
// Parallel DSC as printed in the thesis: algorithm 6.3 over CreateSubmeshes and MergeSubmeshes,
// which copy the whole mesh into submeshes and back, for red and again for black. It is here to
// show what this costs compared with the submeshes that run in place
// (dsc/parallel/in_place/submesh_executor.h).
#pragma once

#include "dsc/algorithm/executor.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/deferred.h"
#include "dsc/passes/work.h"
#include "thesis/copies/copied_submeshes.h"

#include <exception>

namespace dsc {

/// Slabs cut by the counting method.
struct CopyOptions {
    std::uint32_t submeshes = 8; ///< of either colour; 1 to 65536
    std::uint32_t threads = 1;   ///< 1 to 1024; the result does not depend on it
    double normal_x = 1;         ///< direction along which the slabs follow each other; length 1
    double normal_y = 0;
};

/// The seconds of the calling thread since the beginning, by part.
struct CopyCosts {
    double create_s = 0;      ///< CreateSubmeshes, and distributing the work
    double run_s = 0;         ///< the submeshes, in parallel
    double merge_s = 0;       ///< MergeSubmeshes, and collecting what was deferred
    double whole_s = 0;       ///< the run on the whole complex for what both colours deferred
    std::uint64_t steps = 0;  ///< that have been run
    std::uint64_t rounds = 0; ///< number of divisions and merges
};

/// Runs the remeshing on the whole complex; the motion passes on red submeshes, then on black ones
/// for what red deferred, then on the whole complex for what both deferred. Submeshes share neither
/// locks nor memory while they run: any pass that keeps to `Work::submesh` may run in them, but it
/// finds the ids and the attributes of the submesh (`work.complex.attributes`), not of the mesh.
///
/// The complex stays the same object, and so do its attributes. All ids change in `move`, as in the
/// thesis: handles from before a step are invalid, and the application finds its simplices again by
/// its attributes; vertices without triangles are lost. If a velocity or a pass throws, the running
/// submeshes are dropped and the complex is that of the last merge. The result is bitwise identical
/// for any number of threads; if several passes throw, the exception of the first submesh is
/// rethrown.
template <class Real>
class CopyExecutor final : public Executor<Real> {
public:
    /// Throws InputError if an option is out of range.
    CopyExecutor(Complex<Real>& complex, const Options<Real>& options, Algorithm<Real> algorithm,
                 const CopyOptions& copy);

    void begin_step() override;
    /// O(mesh) for each colour, however little moves. Edits within submeshes name the ids of copies
    /// and are not reported: each merge is one `rebuild`.
    MoveReport move() override;
    void end_step() override;
    /// Submeshes are created in each step, so that they are not archived.
    void archive(Archive& archive) override;

    /// The costs so far.
    [[nodiscard]] const CopyCosts& costs() const { return costs_; }
    /// The division of the last round.
    [[nodiscard]] const CopiedSubmeshes<Real>& submeshes() const { return submeshes_; }

private:
    /// The work of one submesh.
    struct Task {
        Task(Complex<Real>& complex, const Options<Real>& options) : work(complex, options) {}
        Work<Real> work;
        std::vector<std::uint32_t> given; ///< `work.interface` when it was distributed
        std::exception_ptr failure;
        std::uint32_t passes = 0;
    };

    /// Returns whether anything was deferred, because of submesh boundaries or a lack of ids.
    [[nodiscard]] bool run_round(RedBlack colour, MoveReport& report);
    void distribute_work();
    void run_tasks();
    [[nodiscard]] bool collect_work();
    void restore_interface(bool is_as_given);
    void recover();

    using Executor<Real>::complex_;
    using Executor<Real>::options_;
    using Executor<Real>::algorithm_;
    using Executor<Real>::whole_; // remeshing and targets; between the rounds, the work that
                                  // remains
    using Executor<Real>::epoch_;
    using typename Executor<Real>::Progress;
    using Executor<Real>::progress_;

    CopyOptions copy_;
    CopiedSubmeshes<Real> submeshes_;
    std::vector<std::unique_ptr<Task>> tasks_;
    // Work on submesh boundaries, which waits for the next round; by vertex of the mesh.
    std::vector<MovingVertex<Real>> waiting_vertices_;
    std::vector<std::uint32_t> waiting_active_;
    CopyCosts costs_;
};

/// Create and merge as one of the ways to divide a mesh: `Parallel{.division = &copy_division}`.
extern const Division copy_division;

} // namespace dsc
