#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Do the tests notice what is wrong? Builds a copy of the project that holds all seeded faults of
# verify/faults/table, each with a switch, and runs the tests on each of them until one catches it.
set -euo pipefail

usage() {
    cat <<'USAGE'
usage: verify/faults.sh [--tenth HASH | --room NAME | --only NAME...] [--own] [--baseline] [--jobs N]
       verify/faults.sh --mutants [--count N] [--seed TEXT] [--seconds S] [--survivors] [--jobs N]
       verify/faults.sh --build
  --tenth HASH  the rooms that belong to a commit, with about a tenth of the faults
  --room NAME   the faults of one room
  --only NAME   these faults alone, tried anew
  --own         by the tests of each fault's own room alone; no others are built
  --baseline    measures anew how long the tests take without a fault
  --jobs N      so many faults at the same time; by default one for each core
  --mutants     in place of them a sample of small changes of the library made by rule, 1000 by default, in
                a build of their own: a score for each room, and what survives, in
                build/mutants/mutants.md; --seconds: CPU time of tests that one has to survive;
                --survivors: what survived is tried again, by the tests that were not tried on it;
                --programs TEST...: by these alone, e.g. test_io. Half an hour of CPU time beside the
                build. Exit code: 0 nine in ten were caught of those that are not in
                verify/faults/equivalent.toml, 1 fewer
  --build       builds the copy and tests nothing
The build takes a quarter of an hour of CPU time, and all faults another half at least; an interrupted run
goes on where it stopped. The results are build/faults/faults.json and the table build/faults/faults.md.
Installs missing Debian packages as root or through sudo. Exit code: 0 all were caught, 1 some were not, 2 nothing was run.
USAGE
}

# Refused before anything is installed or built; run.py and mutate.py look at the values.
refuse() {
    printf '%s: unknown option: %s; --help shows those that there are\n' "$0" "$1" >&2
    exit 2
}
for argument in "$@"; do
    case $argument in
        -h | --help) usage; exit 0 ;;
        --tenth | --room | --only | --own | --baseline | --jobs | --build) ;;
        --mutants | --count | --seed | --seconds | --survivors | --programs) ;;
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
    exec "$python" verify/faults/mutate.py build/mutants --jobs "$jobs" "$@"
fi

folder=build/faults
mkdir -p "$folder"
"$python" verify/faults/overlay.py . "$folder/source"
say "building the copy with the faults, with $jobs jobs"
# Nearly as quick to build as without optimisation, and the tests take a third of the time.
quietly cmake -S "$folder/source" -B "$folder/build" -G Ninja -D CMAKE_BUILD_TYPE=Release \
    -D CMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" -D DSC_PRECOMPILE=ON -D DSC_UNITY=ON \
    -D DSC_BUILD_HARNESS=ON -D DSC_PYTHON="$python"
build_only=false
if [[ ${1:-} == --build ]]; then
    build_only=true
    shift
fi
mapfile -t targets < <("$python" verify/faults/run.py "$folder" --targets "$@")
if ! cmake --build "$folder/build" --parallel "$jobs" --target "${targets[@]}" -- --quiet; then
    say "the build failed: nothing was tested"
    exit 2
fi
if $build_only; then
    exit 0
fi
exec "$python" verify/faults/run.py "$folder" --jobs "$jobs" "$@"
