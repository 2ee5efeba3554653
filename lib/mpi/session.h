// SPDX-License-Identifier: MIT
// MPI for the time of a program. Does not need its headers, so that a program that may also run
// without MPI includes nothing of it.
#pragma once

#include "dsc/parallel/ranks/transport.h"

#include <memory>

namespace dsc {

/// MPI_Init and a transport between all processes; MPI_Finalize at the end, or MPI_Abort where the
/// others cannot be reached any more. One in a program.
class MpiSession {
public:
    /// Called by all processes.
    MpiSession(int& argc, char**& argv);
    ~MpiSession();
    MpiSession(const MpiSession&) = delete;
    MpiSession& operator=(const MpiSession&) = delete;
    MpiSession(MpiSession&&) = delete;
    MpiSession& operator=(MpiSession&&) = delete;

    /// Between all processes.
    [[nodiscard]] Transport& transport();

private:
    struct Connection;
    std::unique_ptr<Connection> connection_;
};

} // namespace dsc
