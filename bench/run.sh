#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Sets up, builds, measures, and draws: build/release/report/index.html.
set -euo pipefail

usage() {
    cat <<'USAGE'
usage: bench/run.sh [--quick] [--suite FILE] [--only WHAT] [Google Benchmark options]
  --quick       leaves out meshes of 80,000 triangles and more, fine edges, the hard cases, and some
                flows and scenes
  --suite FILE  measures this suite alone and draws S(n) and U(n): report/suites has the result and
                the pictures, called as the file is; `dsc_bench --help` shows a suite
  --only WHAT   nothing else: speedup (of the suite bench/suites/speedup.toml unless one is given),
                precision, hard or gallery; earlier results stay as they are
Other options go to dsc_bench after our own and win over them, e.g. --benchmark_filter=flip.
Installs missing Debian packages as root or through sudo.
Exit code: 0 done, 1 something failed, 2 bad usage or nothing was run.
USAGE
}

# refuse WHAT VALUE ALLOWED: bad usage, before anything has been done.
refuse() {
    printf "%s: %s: got '%s'; allowed: %s\n" "$0" "$@" >&2
    exit 2
}

quick=false
list_only=false
suite=
only=
# Left out by --quick, because they take minutes and add nothing to smaller ones: the fine swirl, four circles at 2.8
# million triangles, at this size all strategies that do not follow the interface, copies of large meshes in more than
# one scene, the cost of options, and in three dimensions all but Enright's test in cells at h = 1/32.
large='^option/|380000|four_circles.*(2800000|copy.*280000/)|(fixed|counting|active|blocks)/.*2800000|enright/edges:32'
large+='|translation-3d_run|enright_run/.*(h:0.015625|submeshes|fixed|active|blocks)'
# The file gets every repetition; the terminal shows medians and spread.
bench_options=(--benchmark_enable_random_interleaving=true --benchmark_display_aggregates_only=true
    --benchmark_repetitions=3 --benchmark_min_time=0.05)
user_options=()
flags='^--(v|benchmark_(list_tests|filter|min_time|min_warmup_time|repetitions|format|color|context'
flags+='|time_unit|counters_tabular|enable_random_interleaving|(report|display)_aggregates_only))(=.*)?$'
while [[ $# -gt 0 ]]; do
    case $1 in
        --suite=* | --only=*) set -- "${1%%=*}" "${1#*=}" "${@:2}" ; continue ;;
        --suite | --only)
            [[ $# -gt 1 ]] || refuse "a value is missing" "$1" "$1 and a value"
            if [[ $1 == --suite ]]; then
                suite=$(realpath -e -- "$2" 2>/dev/null) || refuse "--suite" "$2" "a file that exists"
            else
                only=$2
            fi
            shift
            ;;
        --quick)
            quick=true
            bench_options+=(--benchmark_min_time=0.02)
            large+='|80000|95000|112000'
            ;;
        -h | --help) usage; exit 0 ;;
        --benchmark_out=* | --benchmark_out_format=*)
            refuse "the report needs the result in its own folder" "$1" \
                "another file by build/release/bench/dsc_bench $1"
            ;;
        *)
            [[ $1 =~ $flags ]] || refuse "unknown option" "$1" "those of --help"
            [[ ! $1 =~ ^--benchmark_list_tests(=true)?$ ]] || list_only=true
            user_options+=("$1")
            ;;
    esac
    shift
done
only=${only:-${suite:+speedup}}
case $only in
    "" | speedup | precision | hard | gallery) ;;
    *) refuse "--only" "$only" "speedup, precision, hard or gallery" ;;
esac
if [[ -n $suite && $only != speedup ]]; then
    refuse "--suite" "$suite with --only $only" "--only speedup, or none"
fi

# shellcheck source=verify/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../verify/setup.sh"

report=build/release/report
frames=build/release/frames # large, and not needed after drawing
bench=build/release/bench/dsc_bench
precision=build/release/bench/dsc_precision
hard=build/release/verify/dsc_hard
gate=build/release/verify/dsc_verify
scene=build/release/lib/scenes/dsc_scene
cores=$(env -u OMP_NUM_THREADS nproc)
if [[ $only == speedup ]]; then
    suite=${suite:-$project_root/bench/suites/speedup.toml}
    # One more than a 95 % interval needs.
    bench_options+=("--suite=$suite" --benchmark_repetitions=7)
else
    bench_options+=("--benchmark_filter=-$large") # the last filter counts, so the user's overrides this one
fi
failed=()

# Prints how many cores were busy in the last second. The load average would still include the build a minute later.
busy_cores() {
    local before after
    before=$(head -n 1 /proc/stat)
    sleep 1
    after=$(head -n 1 /proc/stat)
    printf '%s\n%s\n' "$before" "$after" | awk -v cores="$(nproc --all)" '
        { all = 0; for (i = 2; i <= 9; ++i) { all += $i }; idle = $5 + $6 }
        NR == 1 { all_before = all; idle_before = idle }
        END { printf "%.2f", cores * (1 - (idle - idle_before) / (all - all_before)) }'
}

# Waits until the machine is idle, for at most half a minute.
await_quiet() {
    local busy i
    for ((i = 0; i < 30; ++i)); do
        busy=$(busy_cores)
        if awk -v busy="$busy" 'BEGIN { exit !(busy < 0.2) }'; then
            break
        fi
    done
    say "other programs keep $busy of $cores cores busy"
    # Spinning threads make a step microseconds faster on an idle machine, and milliseconds slower if cores are shared.
    if awk -v busy="$busy" -v cores="$cores" 'BEGIN { exit !(busy > 0.25 * cores) }'; then
        export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}
    fi
}

# run_benchmarks RESULT. Exit codes of dsc_bench: 0 done, 1 wrong answers were not timed (the report lists them), 2 bad
# usage.
run_benchmarks() {
    local result=$1 code=0
    say "benchmarks"
    # OMP_PROC_BIND would bind the calling thread to one core, which other programs may use.
    env -u OMP_PROC_BIND "$bench" "${bench_options[@]}" \
        --benchmark_out="$result.part" --benchmark_out_format=json \
        "${user_options[@]}" </dev/null || code=$?
    if [[ $code -le 1 ]] && ! "$python" -m json.tool "$result.part" >/dev/null 2>&1; then
        printf '%s: dsc_bench left incomplete JSON in %s.part\n' "$0" "$result" >&2
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

# beside COMMAND...: runs the command on another core, if there is one; await_beside shows its output.
beside_words=$report/beside.txt
beside=
trap '[[ -z $beside ]] || kill "$beside" 2>/dev/null || true' EXIT
beside() {
    if [[ $cores -gt 1 ]]; then
        "$@" >"$beside_words" 2>&1 &
        beside=$!
    else
        "$@" || failed+=("$1")
    fi
}

await_beside() { # await_beside WHAT
    if [[ -n $beside ]]; then
        wait "$beside" || failed+=("$1")
        beside=
        cat "$beside_words"
        rm -f "$beside_words"
    fi
}

run_scene() { # run_scene NAME SCENE [OPTION...]: NAME is the name of the result
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

# Checks all limits, or uses the result of verify/run.sh for the same commit; a quick report checks only sequential runs
# of all scenes.
run_gate() {
    local checks=() left=build/release/verify/out/verify.json
    if ! $quick && "$python" - "$left" "$(git describe --always --abbrev=10 --dirty=+)" <<'PYTHON'
import json
import sys

try:
    with open(sys.argv[1], encoding="utf-8") as stream:
        left = json.load(stream)
except (OSError, ValueError):
    sys.exit(1)
# A modified tree may have changed since.
same = left["commit"] == sys.argv[2] and not left["commit"].endswith("+")
sys.exit(0 if same and not left["not_run"] and len(left["suites"]) > 1 else 1)
PYTHON
    then
        printf 'the gate: result of verify/run.sh for this commit, in %s\n' "$left"
        mkdir -p "$report/gate"
        cp "$left" "$report/gate/verify.json"
        return
    fi
    if $quick; then
        checks=(area_ratio symmetric_difference symmetric_difference_half inverted unreached min_quality)
    fi
    "$gate" run "${checks[@]}" --jobs "$cores" --out "$report/gate" </dev/null ||
        failed+=("gate")
}

# The longest runs: the literal method, and a film of a coarse fluid for the page.
run_reference_and_film() {
    local code=0
    timeout --foreground 180 "$scene" run speedup-scaling "${coarse[@]}" --strategy reference \
        --json "$report/scenes/scaling-reference.json" </dev/null || code=1
    { "$scene" run bubbles --set h=0.03 --frames "$frames/film" --every 8 &&
        "$python" plots/film.py "$frames/film" --out "$report/bubbles.webp"; } \
        </dev/null >/dev/null || code=1
    run_space </dev/null >/dev/null || code=1
    return "$code"
}

# Enright's test in three dimensions: several sizes, and a picture of the finest.
run_space() {
    local sizes=(16 24 32) n
    $quick || sizes+=(48 64)
    for n in "${sizes[@]}"; do
        rm -rf "$frames/space"
        "$scene" run enright --set h="$(awk "BEGIN { print 1 / $n }")" --frames "$frames/space" \
            --at 0,1.5,3 --json "$report/enright-$n.json" || return 1
    done
    "$python" plots/space.py "$frames/space" --out "$report/enright.png"
}

run_scenes() {
    local keep_frames=(--frames "$frames")

    # The histograms of three strategies, and frames with the submeshes beside them.
    run_scene scaling-sequential speedup-scaling "${coarse[@]}"
    run_scene scaling-counting speedup-scaling "${coarse[@]}" --strategy counting \
        --threads "$cores"
    run_scene scaling-cells speedup-scaling "${coarse[@]}" --strategy cells --threads "$cores" \
        "${keep_frames[@]}"

    run_scene swirl swirl "${keep_frames[@]}"
    run_scene zalesak zalesak "${keep_frames[@]}"
    run_scene four-circles speedup-four-circles
    run_scene vortex-square vortex-square
    run_scene drop-and-pool drop-and-pool "${keep_frames[@]}"
    if ! $quick; then
        run_scene single-vortex single-vortex
        run_scene swirl-cells swirl --set h=0.01 --strategy cells --threads "$cores"
        run_scene rotation-crescent rotation-crescent
        run_scene translation translation

        # Phases that merge and split. With longer steps the film between the two discs blocks a vertex before it opens,
        # which counts as unreached.
        run_scene grow-shrink grow-shrink --set dt=0.002 "${keep_frames[@]}"
        run_scene erode-dumbbell erode-dumbbell "${keep_frames[@]}"
        run_scene johnson-mehl johnson-mehl "${keep_frames[@]}"
        run_scene t1 t1 "${keep_frames[@]}"
        run_scene grains grains --set h=0.01 "${keep_frames[@]}"
        run_scene foam foam --set h=0.01 "${keep_frames[@]}"
    fi
}

# Error against time of all methods: two flows at a time, each on its own core.
run_precision() {
    local first=(single-vortex-8) second=(single-vortex-2 swirl-260 swirl-420 zalesak vortex-square)
    local options=()
    if $quick; then
        options=(--quick)
        second=(swirl-260)
    fi
    say "error against time"
    rm -rf "$report/precision"
    beside "$precision" run "${options[@]}" "${first[@]/#/--flow=}" --out "$report/precision" \
        </dev/null
    "$precision" run "${options[@]}" "${second[@]/#/--flow=}" --out "$report/precision" \
        </dev/null || failed+=("error against time")
    await_beside "error against time"
}

# The results of the hard cases, for the table.
run_hard_cases() {
    say "hard cases"
    "$hard" run --json "$report/hard.json" </dev/null >"$report/hard.txt" ||
        failed+=("hard cases")
    tail -n 1 "$report/hard.txt"
}

# A single suite, with its own pictures.
run_suite() {
    local name form code=0
    name=$report/suites/$(basename -s .toml -- "$suite")
    run_benchmarks "$name.json" || code=$?
    if [[ $code -ne 0 ]]; then
        exit "$code"
    fi
    for form in svg png pdf; do
        MPLBACKEND=Agg "$python" plots/speedup.py "$name.json" --out "$name.$form" ||
            failed+=("pictures of $name.json")
    done
}

# The figures of the thesis, a section of the page.
run_gallery() {
    say "the thesis's figures"
    "$python" plots/gallery/make.py --scene "$scene" --out "$report/gallery" \
        </dev/null || failed+=("the thesis's figures")
}

draw() {
    local scenes=("$report"/scenes/*.json) verify=("$report"/gate/*.json)
    local errors=("$report"/precision/*.json) cases=()
    if [[ -f $report/hard.json ]]; then
        cases=(--hard "$report/hard.json")
    fi
    say "plots"
    MPLBACKEND=Agg "$python" plots/report.py --bench "$report/bench.json" \
        --scenes "${scenes[@]}" --precision "${errors[@]}" "${cases[@]}" \
        --verify "${verify[@]}" --frames "$frames" --published reference/published --out "$report"
}

# A pattern without matching files expands to nothing.
shopt -s nullglob

coarse=()
if $quick; then
    coarse=(--set h=0.02)
fi
set_up plain
case $only in
    speedup) targets=(dsc_bench) ;;
    precision) targets=(dsc_precision) ;;
    hard) targets=(dsc_hard) ;;
    gallery) targets=(dsc_scene) ;;
    *)
        targets=(dsc_bench dsc_precision dsc_verify dsc_scene dsc_module)
        $quick || targets+=(dsc_hard)
        ;;
esac
build_preset release --target "${targets[@]}" || exit 1
if $list_only; then
    exec "$bench" "${bench_options[@]}" "${user_options[@]}"
fi

run_all() {
    local code=0
    # Results of other suites are kept.
    mkdir -p "$report"
    find "$report" -mindepth 1 -maxdepth 1 ! -name suites -exec rm -rf {} +
    rm -rf "$frames"
    mkdir -p "$report/scenes" "$frames"
    await_quiet

    run_benchmarks "$report/bench.json" || code=$?
    if [[ $code -ne 0 ]]; then
        # Without measurements there is nothing to draw; dsc_bench has printed the reason.
        exit "$code"
    fi
    run_precision
    say "the literal method and a film of bubbles, beside the scenes"
    beside run_reference_and_film
    if ! $quick; then
        run_hard_cases
    fi
    run_scenes
    run_gallery
    await_beside "literal method or film"
    say "gate"
    run_gate
    draw || failed+=("plots")
    rm -rf "$frames"
}

mkdir -p "$report/suites"
case $only in
    speedup) await_quiet; run_suite ;;
    precision) await_quiet; run_precision ;;
    hard) run_hard_cases ;;
    gallery) run_gallery ;;
    *) run_all ;;
esac

if [[ ${#failed[@]} -gt 0 ]]; then
    printf 'failed: %s\n' "${failed[@]}"
    exit 1
fi
if [[ -n $only ]]; then
    say "results: $project_root/$report"
else
    say "report: $project_root/$report/index.html"
fi
