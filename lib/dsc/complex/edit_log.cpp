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

EditLog& EditLog::operator=(const EditLog& other) {
    if (this != &other) {
        counts = {};
        if (readers > 0) {
            records.push_back({.kind = EditKind::rebuild});
        } else {
            records.clear();
        }
    }
    return *this;
}

LogReader::~LogReader() {
    if (--log_.readers == 0) {
        log_.records.clear();
    }
}

} // namespace dsc
