#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests whether the working tree is slower than a commit: builds both, runs both alternately, and compares their times.
# No stored times are used.
set -euo pipefail

usage() {
    cat <<'USAGE'
usage: bench/compare.sh BASE [FILTER] [--pairs N] [--minutes M] [--native] [--no-times] [--no-counts]
  BASE         a commit, tag or branch; built in a git worktree of its own in build/compare/base
  FILTER       a regular expression for the runs: swirl, single-vortex, zalesak, drop-and-pool,
               growing-circle
  --pairs N, --minutes M   runs pairs (base, change) until the ratio is known to the precision below: at most
               N pairs (default 300), M minutes (default 10)
  --native     tuned for this processor, as the preset release is; valgrind may not know it then
  --no-times   counts alone, which a busy machine does not disturb; --no-counts: times alone
Both are built by the preset release, but for any processor, and run on one thread. To be caught are 5 %
in time, 2 % in the instructions of steps and one allocation a step (the latter two where valgrind is
installed); slower is more than half of each. The figure for time is the median of the ratios of pairs;
pairs are run until its interval of 99.99 % is no wider than 5 % or lies on one side of the limit
(bench/compare/judgement.py says why).
Leaves build/compare/base.json and new.json, which Google Benchmark's compare.py reads as well,
compare.json with the table, and the worktree, for the next time; `git worktree remove --force
build/compare/base` removes it.
Exit code: 0 not slower, 1 slower, 2 bad usage or nothing was measured,
3 undecided: an interval across the limit stayed too wide.
USAGE
}

base=
filter=
native=OFF
options=()
while [[ $# -gt 0 ]]; do
    case $1 in
        -h | --help) usage; exit 0 ;;
        --native) native=ON ;;
        --no-times | --no-counts) options+=("$1") ;;
        --pairs | --minutes)
            options+=("$1" "${2:?$1: how many?}")
            shift
            ;;
        -*) printf '%s: unknown option: got %s (see --help)\n' "$0" "$1" >&2; exit 2 ;;
        *)
            if [[ -z $base ]]; then
                base=$1
            elif [[ -z $filter ]]; then
                filter=$1
            else
                usage >&2
                exit 2
            fi
            ;;
    esac
    shift
done
if [[ -z $base ]]; then
    usage >&2
    exit 2
fi

# shellcheck source=verify/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../verify/setup.sh"

folder=build/compare
program=lib/scenes/dsc_scene
mkdir -p "$folder"

# build SOURCE FOLDER
build() {
    say "building $1"
    # DSC_STRICT=OFF: warnings must not stop the build of an old commit.
    (cd -- "$1" && quietly cmake --preset release -B "$2" -D DSC_NATIVE="$native" -D DSC_STRICT=OFF \
        ${CMAKE_CXX_COMPILER_LAUNCHER:+-D CMAKE_CXX_COMPILER_LAUNCHER="$CMAKE_CXX_COMPILER_LAUNCHER"}) &&
        quietly cmake --build "$2" --parallel "$jobs" --target dsc_scene ||
        give_up "$1 could not be built"
}

commit=$(git rev-parse --verify --quiet "$base^{commit}") ||
    give_up "no such commit: got '$base'; allowed: a commit, tag or branch of this repository"
say "base: $(git log -1 --format='%h %s' "$commit")"
if [[ -e $folder/base/.git ]]; then
    quietly git -C "$folder/base" checkout --force --detach "$commit" ||
        give_up "the worktree $folder/base cannot be moved to $commit"
else
    git worktree prune
    quietly git worktree add --force --detach "$folder/base" "$commit" ||
        give_up "no worktree could be made in $folder/base"
fi
build "$folder/base" "$project_root/$folder/of_base"
build . "$project_root/$folder/of_new"

say "comparing"
exec python3 bench/compare/compare.py --base "$folder/of_base/$program" \
    --new "$folder/of_new/$program" --out "$folder" --filter "$filter" "${options[@]}"
