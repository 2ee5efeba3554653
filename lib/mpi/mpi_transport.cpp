// SPDX-License-Identifier: MIT
#include "mpi/mpi_transport.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

namespace dsc {

namespace {

constexpr std::size_t first_room = 4096;
constexpr std::size_t prefix = sizeof(std::uint64_t);
constexpr int tag = 1;

} // namespace

MpiTransport::MpiTransport(MPI_Comm communicator) : room_(first_room) {
    check(MPI_Comm_dup(communicator, &communicator_));
    check(MPI_Comm_set_errhandler(communicator_, MPI_ERRORS_RETURN));
    int rank = 0;
    int size = 1;
    check(MPI_Comm_rank(communicator_, &rank));
    check(MPI_Comm_size(communicator_, &size));
    rank_ = static_cast<std::uint32_t>(rank);
    size_ = static_cast<std::uint32_t>(size);
    buffers_.resize(size_);
    all_.resize(size_);
}

MpiTransport::~MpiTransport() {
    if (!is_lost_) {
        MPI_Comm_free(&communicator_);
    }
}

void MpiTransport::check(int code) {
    if (code == MPI_SUCCESS) {
        return;
    }
    is_lost_ = true;
    std::string text(MPI_MAX_ERROR_STRING, '\0');
    int length = 0;
    MPI_Error_string(code, text.data(), &length);
    text.resize(static_cast<std::size_t>(length));
    throw std::runtime_error("rank " + std::to_string(rank_) + " cannot reach the others: " + text);
}

// Bytes from .. from + bytes of the own message, and so many of each other one's.
void MpiTransport::exchange(std::size_t from, std::size_t bytes,
                            std::span<const std::size_t> theirs) {
    requests_.clear();
    for (std::uint32_t other = 0; other < size_; ++other) {
        if (other != rank_ && theirs[other] > 0) {
            check(MPI_Irecv(buffers_[other].data() + from, static_cast<int>(theirs[other]),
                            MPI_BYTE, static_cast<int>(other), tag, communicator_,
                            &requests_.emplace_back()));
        }
    }
    for (std::uint32_t step = 1; step < size_ && bytes > 0; ++step) {
        const std::uint32_t other = (rank_ + step) % size_; // each begins with another one
        check(MPI_Isend(sent_.data() + from, static_cast<int>(bytes), MPI_BYTE,
                        static_cast<int>(other), tag, communicator_, &requests_.emplace_back()));
    }
    check(MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE));
}

// The first message of each has all, unless it is longer than any before; then the rest follows,
// and from then on there is room for it.
RankBytes MpiTransport::all_gather(std::span<const std::byte> mine) {
    const std::uint64_t length = prefix + mine.size();
    sent_.resize(length);
    std::memcpy(sent_.data(), &length, prefix);
    if (!mine.empty()) {
        std::memcpy(sent_.data() + prefix, mine.data(), mine.size());
    }
    std::vector<std::size_t> theirs(size_, room_);
    for (auto& buffer : buffers_) {
        buffer.resize(std::max(buffer.size(), room_));
    }
    exchange(0, std::min<std::size_t>(length, room_), theirs);
    std::size_t longest = length;
    for (std::uint32_t other = 0; other < size_; ++other) {
        std::uint64_t total = length;
        if (other != rank_) {
            std::memcpy(&total, buffers_[other].data(), prefix);
        }
        longest = std::max<std::size_t>(longest, total);
        theirs[other] = total;
    }
    if (longest > room_) {
        for (std::uint32_t other = 0; other < size_; ++other) {
            buffers_[other].resize(std::max(buffers_[other].size(), theirs[other]));
            theirs[other] -= std::min(theirs[other], room_);
        }
        exchange(room_, length - std::min<std::size_t>(length, room_), theirs);
        for (std::uint32_t other = 0; other < size_; ++other) {
            std::uint64_t total = 0;
            std::memcpy(&total, other == rank_ ? sent_.data() : buffers_[other].data(), prefix);
            theirs[other] = total;
        }
        room_ = longest + longest / 2;
    }
    for (std::uint32_t other = 0; other < size_; ++other) {
        const std::byte* const bytes = other == rank_ ? sent_.data() : buffers_[other].data();
        all_[other] = {bytes + prefix, theirs[other] - prefix};
    }
    return all_;
}

} // namespace dsc
