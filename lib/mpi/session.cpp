// SPDX-License-Identifier: MIT
#include "mpi/session.h"

#include "mpi/mpi_transport.h"

#include <optional>

namespace dsc {

struct MpiSession::Connection {
    std::optional<MpiTransport> transport;
};

MpiSession::MpiSession(int& argc, char**& argv) : connection_(std::make_unique<Connection>()) {
    // Only the thread that calls a step exchanges messages.
    int provided = MPI_THREAD_SINGLE;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    connection_->transport.emplace(MPI_COMM_WORLD);
}

MpiSession::~MpiSession() {
    const bool is_lost = connection_->transport->is_lost();
    connection_->transport.reset();
    if (is_lost) {
        MPI_Abort(MPI_COMM_WORLD, 1); // to wait for the others would be in vain
    }
    MPI_Finalize();
}

Transport& MpiSession::transport() { return *connection_->transport; }

} // namespace dsc
