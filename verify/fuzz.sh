#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Searches for inputs that break a guarantee of the library: builds the preset fuzz, then lets libFuzzer
# search from the corpus and from what earlier searches have kept. See verify/fuzz/target.h.
set -euo pipefail

usage() {
    cat <<'USAGE'
usage: verify/fuzz.sh [TARGET|all] [SECONDS] [libFuzzer options]
       verify/fuzz.sh --turn HASH [SECONDS] [libFuzzer options]
  TARGET       a folder of verify/fuzz/corpus; all (the default): one after the other
  SECONDS      of search in each, 60 unless given
  --turn HASH  two targets side by side, chosen by the hash of a commit, with the program of the preset
               asan, which has to be built
New inputs are kept in build/fuzz/search/TARGET/inputs (or build/asan/search), and findings beside them.
Installs missing Debian packages as root or through sudo.
Exit code: 0 nothing was found, 1 something was, 2 nothing was run.
USAGE
}

if [[ ${1-} == -h || ${1-} == --help ]]; then
    usage
    exit 0
fi
# shellcheck source=verify/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

corpus=verify/fuzz/corpus
mapfile -t all_targets < <(ls "$corpus")
build=build/fuzz
if [[ ${1-} == --turn ]]; then
    [[ ${2-} =~ ^[0-9a-f]{7,40}$ ]] || give_up "--turn: not the hash of a commit: '${2-}'"
    build=build/asan
    count=${#all_targets[@]}
    first=$((16#${2:0:7} % count))
    chosen=("${all_targets[first]}" "${all_targets[(first + count / 2) % count]}")
    shift
elif [[ ${1:-all} == all ]]; then
    chosen=("${all_targets[@]}")
else
    chosen=("$1")
fi
seconds=${2:-60}
fuzzer_options=("${@:3}")
[[ -d $corpus/${chosen[0]} ]] ||
    give_up "unknown target '${chosen[0]}'; allowed: all, $(ls -m "$corpus")"
[[ $seconds =~ ^[1-9][0-9]*$ ]] || give_up "not a number of seconds: '$seconds'"

if [[ $build == build/fuzz ]]; then
    install_packages "${build_packages[@]}" "${tsan_packages[@]}"
    say "building preset fuzz with $jobs jobs"
    quietly cmake --preset fuzz
    quietly cmake --build build/fuzz --parallel "$jobs" --target dsc_fuzz
fi
program=$build/verify/fuzz/dsc_fuzz
[[ -x $program ]] || give_up "there is no $program: build the preset ${build#build/} first"

symbolizer=$(command -v llvm-symbolizer-14 || true)
export ASAN_OPTIONS="${symbolizer:+external_symbolizer_path=$symbolizer:}detect_stack_use_after_return=1"
export UBSAN_OPTIONS="${symbolizer:+external_symbolizer_path=$symbolizer:}print_stacktrace=1"
export OMP_WAIT_POLICY=passive

search_in() { # search_in TARGET: fails if something was found
    local folder=$build/search/$1 corpora before findings inputs
    local log=$folder/log.txt
    mkdir -p "$folder/inputs" "$folder/findings"
    # An input that takes ten seconds or a gigabyte is a finding too. The seconds are wall-clock time; on a busy
    # machine, add -timeout=60, which overrides it.
    local options=(--target="$1" -max_total_time="$seconds" -timeout=10 -report_slow_units=1000
        -rss_limit_mb=2048 -malloc_limit_mb=1024 -print_final_stats=1
        -artifact_prefix="$folder/findings/" "${fuzzer_options[@]}")
    if [[ -f verify/fuzz/dictionaries/$1.txt ]]; then
        options+=("-dict=verify/fuzz/dictionaries/$1.txt")
    fi
    corpora=("$folder/inputs" "$corpus/$1")
    if [[ $1 == scene_file ]]; then
        corpora+=(lib/scenes/examples)
    fi
    before=$(find "$folder/findings" -type f | wc -l)
    say "searching in $1 for $seconds s"
    "$program" "${options[@]}" "${corpora[@]}" >"$log" 2>&1 || true
    findings=$(($(find "$folder/findings" -type f | wc -l) - before))
    inputs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    echo "$1: ${inputs:=0} inputs, findings: $findings;$(grep -o ' cov: [0-9]*' "$log" | tail -n 1 || true)"
    if [[ $findings -gt 0 || $inputs -eq 0 ]]; then
        grep -m 1 -A 12 -E 'finding:|ERROR:|runtime error:' "$log" || tail -n 5 "$log"
    fi
    if [[ $findings -gt 0 ]]; then
        echo "again: $program --target=$1 -timeout=10 -rss_limit_mb=2048 $folder/findings/*"
    fi
    [[ $findings -eq 0 && $inputs -gt 0 ]]
}

found=0
if [[ $build == build/asan ]]; then
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
