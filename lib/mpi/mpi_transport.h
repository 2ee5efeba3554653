// SPDX-License-Identifier: MIT
// Ranks that are processes of MPI. A library of its own, dsc::mpi: nothing else needs MPI.
#pragma once

#include "dsc/parallel/ranks/transport.h"

#include <mpi.h>

#include <vector>

namespace dsc {

/// Carries bytes between the processes of a communicator. Each gives its bytes to each other one at
/// once, so that an exchange takes the time of one message.
class MpiTransport final : public Transport {
public:
    /// Works in a copy of the communicator, so that no other messages come in between. Called by
    /// all of its processes, between MPI_Init and MPI_Finalize; the destructor as well.
    explicit MpiTransport(MPI_Comm communicator);
    ~MpiTransport() override;
    MpiTransport(const MpiTransport&) = delete;
    MpiTransport& operator=(const MpiTransport&) = delete;
    MpiTransport(MpiTransport&&) = delete;
    MpiTransport& operator=(MpiTransport&&) = delete;

    [[nodiscard]] std::uint32_t rank() const override { return rank_; }
    [[nodiscard]] std::uint32_t size() const override { return size_; }
    /// Throws std::runtime_error, with the text of MPI, where the connection is lost.
    [[nodiscard]] RankBytes all_gather(std::span<const std::byte> mine) override;
    /// Whether an exchange has thrown: the other processes cannot be reached any more.
    [[nodiscard]] bool is_lost() const { return is_lost_; }

private:
    void check(int code);
    void exchange(std::size_t from, std::size_t bytes, std::span<const std::size_t> theirs);

    MPI_Comm communicator_ = MPI_COMM_NULL;
    std::uint32_t rank_ = 0;
    std::uint32_t size_ = 1;
    std::size_t room_;                            ///< of the first message, as agreed by all
    std::vector<std::byte> sent_;                 ///< the length, and the bytes
    std::vector<std::vector<std::byte>> buffers_; ///< by rank, as received
    std::vector<MPI_Request> requests_;
    std::vector<std::span<const std::byte>> all_;
    bool is_lost_ = false;
};

} // namespace dsc
