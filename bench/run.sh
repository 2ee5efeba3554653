#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Sets up, builds, measures, and draws: build/release/report/index.html.
set -euo pipefail

usage() {
    cat <<'USAGE'
usage: bench/run.sh [--quick] [Google Benchmark options]
  --quick  leaves out meshes of 280,000 triangles and more, fine meshes and some scenes
Other options go to dsc_bench after our own and win over them, e.g. --benchmark_filter=flip.
Installs missing Debian packages as root or through sudo. DSC_JOBS sets the number of build jobs,
PYTHON the interpreter for the plots.
Exit code: 0 done, 1 something failed, 2 bad usage or nothing was run.
USAGE
}

quick=false
list_only=false
# The file gets every repetition, the terminal medians and spread.
bench_options=(--benchmark_enable_random_interleaving=true --benchmark_display_aggregates_only=true
    --benchmark_repetitions=5 --benchmark_min_time=0.05)
user_options=()
for argument in "$@"; do
    case $argument in
        --quick)
            quick=true
            bench_options+=(--benchmark_repetitions=3 --benchmark_min_time=0.02
                --benchmark_filter=-280000)
            ;;
        -h | --help) usage; exit 0 ;;
        --benchmark_out=* | --benchmark_out_format=*)
            printf '%s: %s: the report needs the result where it looks for it; %s\n' "$0" \
                "$argument" "for another file run build/release/bench/dsc_bench" >&2
            exit 2
            ;;
        --benchmark_list_tests | --benchmark_list_tests=true)
            list_only=true
            user_options+=("$argument")
            ;;
        *) user_options+=("$argument") ;;
    esac
done

# shellcheck source=verify/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../verify/setup.sh"

# Threads that spin while they wait cost a step microseconds less on an idle machine, and
# milliseconds more where cores are shared; threads that wander between cores make figures that
# cannot be repeated.
read -r load_now _ </proc/loadavg
if awk -v load="$load_now" -v cores="$(nproc)" 'BEGIN { exit !(load > 0.75 * cores) }'; then
    export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}
fi
export OMP_PROC_BIND=${OMP_PROC_BIND:-true}

report=build/release/report
bench=build/release/bench/dsc_bench
precision=build/release/bench/dsc_precision
hard=build/release/verify/dsc_hard
scene=build/release/lib/scenes/dsc_scene
cores=$(env -u OMP_NUM_THREADS nproc)
failed=()

# dsc_bench: 0 done, 1 it refused to time a wrong answer (the report says which), 2 bad usage.
run_benchmarks() {
    local result=$report/bench.json code=0
    say "benchmarks"
    "$bench" "${bench_options[@]}" --benchmark_out="$result.part" --benchmark_out_format=json \
        "${user_options[@]}" </dev/null || code=$?
    if [[ $code -le 1 ]] && ! "$python" -m json.tool "$result.part" >/dev/null 2>&1; then
        printf '%s: dsc_bench left no whole JSON in %s.part\n' "$0" "$result" >&2
        code=2
    fi
    if [[ $code -gt 1 ]]; then
        rm -f "$result.part"
        return "$code"
    fi
    mv "$result.part" "$result"
    if [[ $code -ne 0 ]]; then
        failed+=("benchmarks")
    fi
}

run_scene() { # run_scene NAME SCENE [OPTION...]: NAME is that of the result
    local name=$1 code=0
    shift
    say "scene $name"
    timeout --foreground 180 "$scene" run "$@" --json "$report/scenes/$name.json" </dev/null ||
        code=$?
    if [[ $code -eq 124 ]]; then
        printf '%s: scene %s was stopped after 180 s\n' "$0" "$name" >&2
    fi
    if [[ $code -ne 0 ]]; then
        failed+=("scene $name")
    fi
}

# Frames are named after scene and strategy: of several such runs only one keeps them.
run_scenes() {
    local keep_frames=(--frames "$report/frames")
    local coarse=()
    rm -rf "$report/scenes" "$report/frames"
    mkdir -p "$report/scenes" "$report/frames"
    if $quick; then
        coarse=(--set h=0.02)
    fi

    run_scene swirl swirl "${keep_frames[@]}"
    run_scene single-vortex single-vortex

    # The histograms of three strategies; the literal method takes longest.
    run_scene scaling-sequential speedup-scaling "${coarse[@]}" "${keep_frames[@]}"
    run_scene scaling-counting speedup-scaling "${coarse[@]}" --strategy counting \
        --threads "$cores"
    run_scene scaling-reference speedup-scaling "${coarse[@]}" --strategy reference

    # Frames with the submeshes beside them.
    run_scene scaling-cells speedup-scaling "${coarse[@]}" --strategy cells --threads "$cores" \
        "${keep_frames[@]}"
    if ! $quick; then
        run_scene scaling-active speedup-scaling --strategy active --threads "$cores" \
            "${keep_frames[@]}"
        run_scene swirl-cells swirl --set h=0.01 --strategy cells --threads "$cores" \
            "${keep_frames[@]}"
    fi

    run_scene four-circles speedup-four-circles "${keep_frames[@]}"
    run_scene zalesak zalesak "${keep_frames[@]}"
    if ! $quick; then
        run_scene vortex-square vortex-square "${keep_frames[@]}"
        run_scene rotation-crescent rotation-crescent "${keep_frames[@]}"
        run_scene translation translation "${keep_frames[@]}"
    fi

    # Phases that meet, merge and part.
    run_scene drop-and-pool drop-and-pool "${keep_frames[@]}"
    run_scene grains grains --set h=0.01 "${keep_frames[@]}"
    if ! $quick; then
        # In longer steps the film holds up a vertex before it opens, which counts as unreached.
        run_scene grow-shrink grow-shrink --set dt=0.002 "${keep_frames[@]}"
        run_scene erode-dumbbell erode-dumbbell "${keep_frames[@]}"
        run_scene t1 t1 "${keep_frames[@]}"
        run_scene foam foam --set h=0.01 "${keep_frames[@]}"
    fi
}

# Error against time of all methods in all flows.
run_precision() {
    local options=()
    if $quick; then
        options=(--quick)
    fi
    say "error against time"
    rm -rf "$report/precision"
    "$precision" run "${options[@]}" --out "$report/precision" </dev/null ||
        failed+=("error against time")
}

# What happens in the hard cases, for the table.
run_hard_cases() {
    say "hard cases"
    "$hard" run --json "$report/hard.json" </dev/null >"$report/hard.txt" ||
        failed+=("hard cases")
    tail -n 1 "$report/hard.txt"
}

draw() {
    local scenes=("$report"/scenes/*.json) verify=(build/release/verify/out/*.json)
    local errors=("$report"/precision/*.json) cases=()
    if [[ -f $report/hard.json ]]; then
        cases=(--hard "$report/hard.json")
    fi
    say "plots"
    MPLBACKEND=Agg "$python" plots/report.py --bench "$report/bench.json" \
        --scenes "${scenes[@]}" --precision "${errors[@]}" "${cases[@]}" \
        --verify "${verify[@]}" --frames "$report/frames" --published reference/published \
        --out "$report"
}

# A folder without results gives no names, rather than its pattern.
shopt -s nullglob

set_up plain
build_preset release --target dsc_bench dsc_precision dsc_hard dsc_scene || exit 1
if $list_only; then
    exec "$bench" "${bench_options[@]}" "${user_options[@]}"
fi
mkdir -p "$report"

code=0
run_benchmarks || code=$?
if [[ $code -ne 0 ]]; then
    # Without measurements there is nothing to draw; dsc_bench has said why.
    exit "$code"
fi
run_precision
run_hard_cases
run_scenes
draw || failed+=("plots")

if [[ ${#failed[@]} -gt 0 ]]; then
    printf 'failed: %s\n' "${failed[@]}"
    exit 1
fi
say "report: $project_root/$report/index.html"
