#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Searches for inputs that break a promise of the library: builds the preset fuzz, then lets libFuzzer
# search from the corpus and from what earlier searches have kept. See verify/fuzz/target.h.
set -euo pipefail

usage() {
    cat <<'USAGE'
usage: verify/fuzz.sh [--no-build] [TARGET|all] [SECONDS] [libFuzzer options]
       verify/fuzz.sh --turn HASH [SECONDS] [libFuzzer options]
       verify/fuzz.sh --build
  TARGET    a folder of verify/fuzz/corpus; all (the default): one after the other
  SECONDS   of search in each, 60 unless given
  --turn    side by side in the two targets whose turn it is at a commit, others at another, with the
            program of the preset asan, which has to be built; see build/asan/search for what it found
  --build   builds the program and searches nothing; --no-build searches with the program as it is
New inputs are kept in build/fuzz/search/TARGET/inputs, and findings beside them. Installs missing Debian
packages as root or through sudo. DSC_JOBS sets the number of jobs of the build.
Exit code: 0 nothing was found, 1 something was, 2 nothing was run.
USAGE
}

search=build/fuzz/search
program=build/fuzz/verify/fuzz/dsc_fuzz
made_by="verify/fuzz.sh --build"

if [[ ${1-} == -h || ${1-} == --help ]]; then
    usage
    exit 0
fi

# shellcheck source=verify/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

with_build=true
turn=
if [[ ${1-} == --no-build ]]; then
    with_build=false
    shift
elif [[ ${1-} == --turn ]]; then
    turn=${2-}
    if [[ ! $turn =~ ^[0-9a-f]{7,40}$ ]]; then
        give_up "--turn: not the hash of a commit: '$turn'"
    fi
    with_build=false
    program=build/asan/verify/fuzz/dsc_fuzz
    made_by="cmake --preset asan && cmake --build --preset asan"
    search=build/asan/search
    shift # what follows the hash is as behind a target
fi
build_only=false
if [[ ${1-} == --build ]]; then
    build_only=true
    shift
fi
target=${1:-all}
seconds=${2:-60}
fuzzer_options=("${@:3}")
corpus=verify/fuzz/corpus
mapfile -t all_targets < <(ls "$corpus")
if [[ -n $turn ]]; then
    count=${#all_targets[@]}
    first=$((16#${turn:0:7} % count))
    chosen=("${all_targets[first]}" "${all_targets[(first + count / 2) % count]}")
elif [[ $target == all ]]; then
    chosen=("${all_targets[@]}")
else
    chosen=("$target")
fi
if [[ ! -d $corpus/${chosen[0]} ]]; then
    give_up "unknown target '$target'; allowed: all, $(ls -m "$corpus")"
fi
if [[ ! $seconds =~ ^[1-9][0-9]*$ ]]; then
    give_up "not a number of seconds: '$seconds'"
fi

if $with_build; then
    install_packages "${build_packages[@]}" "${tsan_packages[@]}"
    say "building preset fuzz with $jobs jobs"
    quietly cmake --preset fuzz
    quietly cmake --build build/fuzz --parallel "$jobs" --target dsc_fuzz
fi
if $build_only; then
    exit 0
fi
[[ -x $program ]] || give_up "there is no $program: build it first with $made_by"

symbolizer=$(command -v llvm-symbolizer-14 || true)
export ASAN_OPTIONS="${symbolizer:+external_symbolizer_path=$symbolizer:}detect_stack_use_after_return=1"
export UBSAN_OPTIONS="${symbolizer:+external_symbolizer_path=$symbolizer:}print_stacktrace=1"
export OMP_WAIT_POLICY=passive

search_in() { # search_in TARGET: fails if something was found
    local folder=$search/$1 options=()
    local log=$folder/log.txt before findings inputs
    mkdir -p "$folder/inputs" "$folder/findings"
    if [[ -f verify/fuzz/dictionaries/$1.txt ]]; then
        options+=("-dict=verify/fuzz/dictionaries/$1.txt")
    fi
    local corpora=("$folder/inputs" "$corpus/$1")
    if [[ $1 == scene_file ]]; then
        corpora+=(lib/scenes/examples)
    fi
    before=$(find "$folder/findings" -type f | wc -l)
    say "searching in $1 for $seconds s"
    # No input may take ten seconds or a gigabyte: that is a finding too. These are seconds of the clock;
    # on a busy machine, a later -timeout=60 counts.
    options+=(-max_total_time="$seconds" -timeout=10 -report_slow_units=1000 -rss_limit_mb=2048
        -malloc_limit_mb=1024 -print_final_stats=1 -artifact_prefix="$folder/findings/"
        "${fuzzer_options[@]}")
    DSC_FUZZ_TARGET=$1 "$program" "${options[@]}" "${corpora[@]}" >"$log" 2>&1 || true
    findings=$(($(find "$folder/findings" -type f | wc -l) - before))
    inputs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    echo "$1: ${inputs:=0} inputs, findings: $findings;$(grep -o ' cov: [0-9]*' "$log" | tail -n 1 || true)"
    if [[ $findings -gt 0 || $inputs -eq 0 ]]; then
        grep -m 1 -A 12 -E 'finding:|ERROR:|runtime error:' "$log" || tail -n 5 "$log"
    fi
    if [[ $findings -gt 0 ]]; then
        local file
        for file in "$folder"/findings/*; do
            echo "again:   DSC_FUZZ_TARGET=$1 $program -timeout=10 -rss_limit_mb=2048 $file"
            echo "smaller: DSC_FUZZ_TARGET=$1 $program -minimize_crash=1 -max_total_time=60" \
                "-exact_artifact_path=$file.small $file"
        done
    fi
    [[ $findings -eq 0 && $inputs -gt 0 ]]
}

found=0
if [[ -n $turn ]]; then
    searches=()
    for one in "${chosen[@]}"; do
        search_in "$one" &
        searches+=($!)
    done
    for one in "${searches[@]}"; do
        wait "$one" || found=1
    done
else
    for one in "${chosen[@]}"; do
        search_in "$one" || found=1
    done
fi
exit "$found"
