// SPDX-License-Identifier: MIT
#include "dsc/complex/edit_log.h"

namespace dsc {

OperationCounts& OperationCounts::operator+=(const OperationCounts& other) {
    moves += other.moves;
    flips += other.flips;
    interface_splits += other.interface_splits;
    interface_collapses += other.interface_collapses;
    splits += other.splits;
    collapses += other.collapses;
    smoothed += other.smoothed;
    subdivisions += other.subdivisions;
    retriangulations += other.retriangulations;
    relabelled += other.relabelled;
    examined += other.examined;
    return *this;
}

} // namespace dsc
