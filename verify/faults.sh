#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Do the tests notice what is wrong? Builds a copy of the project that holds all seeded faults of
# verify/faults/table, each with a switch, and runs the tests on each of them until one catches it.
set -euo pipefail

usage() {
    cat <<'USAGE'
usage: verify/faults.sh [--tenth HASH | --room NAME | --only NAME...] [--own] [--jobs N]
       verify/faults.sh --mutants [--count N] [--seed TEXT] [--seconds S] [--programs TEST...] [--jobs N]
  --tenth HASH  the rooms that belong to a commit, with about a tenth of the faults
  --room NAME   the faults of one room
  --only NAME   these faults alone, tried anew
  --own         by the tests of each fault's own room alone; no others are built
  --jobs N      so many faults at the same time; by default one for each core
  --mutants     in place of them a sample of small changes of the library made by rule, 1000 by default, in
                a build of their own: a score for each room, and what survives, in
                build/mutants/mutants.md; --seconds: CPU time of tests that one has to survive;
                --programs TEST...: by these alone, e.g. test_io. Half an hour of CPU time beside the
                build. Exit code: 0 nine in ten were caught of those that are not in
                verify/faults/equivalent.toml, 1 fewer
The build takes a quarter of an hour of CPU time, and all faults another half at least; an interrupted run
goes on where it stopped. The results are in build/faults/faults.json.
Installs missing Debian packages as root or through sudo. Exit code: 0 all were caught, 1 some were not, 2 nothing was run.
USAGE
}

# Refused before anything is installed or built; the programs in Python look at the values.
refuse() {
    printf '%s: unknown option: %s; --help shows those that there are\n' "$0" "$1" >&2
    exit 2
}
for argument in "$@"; do
    case $argument in
        -h | --help) usage; exit 0 ;;
        --tenth | --room | --only | --own | --jobs) ;;
        --mutants | --count | --seed | --seconds | --programs) ;;
        -*) refuse "$argument" ;;
    esac
done
if [[ ${1:---} != --* ]]; then
    refuse "$1"
fi
# shellcheck source=verify/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"
set_up plain

if [[ ${1:-} == --mutants ]]; then
    shift
    mkdir -p build/mutants
    exec "$python" verify/faults/mutants.py build/mutants --jobs "$jobs" "$@"
fi
mkdir -p build/faults
exec "$python" verify/faults/faults.py build/faults --jobs "$jobs" "$@"
