// SPDX-License-Identifier: MIT
// Parallel DSC [6.6, 8.10] in place: the passes run on red slabs at once, then on black ones for
// what the red boundaries kept from them, then once on the whole complex for what both left. The
// cuts, the order within a slab and the pools of ids depend on the slabs only: the same bits for
// any number of threads.
#pragma once

#include "dsc/algorithm/driver.h"
#include "dsc/parallel/slabs.h"

namespace dsc {

template <class Real>
class SlabExecutor final : public Executor<Real> {
public:
    /// Throws InputError where the options make no sense.
    SlabExecutor(Complex<Real>& complex, const Options<Real>& options, Algorithm<Real> algorithm,
                 const SlabOptions& slabs);
    /// Gives the ids that the slabs hold back to the complex.
    ~SlabExecutor() override;
    SlabExecutor(const SlabExecutor&) = delete;
    SlabExecutor& operator=(const SlabExecutor&) = delete;
    SlabExecutor(SlabExecutor&&) = delete;
    SlabExecutor& operator=(SlabExecutor&&) = delete;

    void begin_step() override;
    void run_upkeep() override;
    std::size_t run_motion() override;
    void end_step() override;
    void for_pieces(std::size_t n, const typename Executor<Real>::PieceFunction& run) override;
    [[nodiscard]] std::size_t piece_count() const override { return slabs_.submeshes; }
    [[nodiscard]] const std::vector<std::uint32_t>& interface() const override {
        return interface_;
    }
    [[nodiscard]] std::vector<Mover<Real>>& movers() override { return movers_; }
    [[nodiscard]] OperationCounts take_counts() override;

    /// The cuts in force, for drawing.
    [[nodiscard]] const Cuts& cuts() const { return cuts_; }

private:
    struct Slab {
        explicit Slab(Complex<Real>& complex, const Options<Real>& options);
        Work<Real> work;
        IdPool pool;
    };
    using Slabs = std::vector<std::unique_ptr<Slab>>;

    void choose_cuts();
    void refill(Slabs& slabs);
    /// Keeps as many as the next step is likely to need.
    void return_surplus(Slabs& slabs);
    void return_all(IdPool& pool);
    /// Runs one task per slab; the first and the last black slab are one task [8.5].
    void run_colour(Slabs& slabs, const std::vector<Pass<Real>>& passes, bool combine_ends);
    /// After an exception: forgets what was on its way, and looks for the interface again. O(mesh).
    void recover();
    std::size_t slab_at(const std::vector<double>& cuts, std::uint32_t vertex) const;

    Complex<Real>& complex_;
    const Options<Real>& options_;
    Algorithm<Real> algorithm_;
    SlabOptions slabs_;
    Cuts cuts_;
    std::uint64_t steps_ = 0;
    bool under_way_ = false; ///< still true at the end of a step: a pass threw
    std::uint32_t epoch_ = 0;

    Slabs red_;
    Slabs black_;
    Work<Real> whole_; ///< for what both colours left
    std::vector<std::uint32_t> interface_;
    std::vector<Mover<Real>> movers_;
    std::vector<double> scratch_;
};

} // namespace dsc
