#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Sets up, builds, and tests everything: optimised tests, the gate, tests under the address, undefined
# behaviour and thread sanitizers, and a search by libFuzzer in two targets, chosen by turns. Quick unit tests
# run under the former two sanitizers alone, unless these are left out; see the labels in
# verify/CMakeLists.txt.
set -euo pipefail

usage() {
    cat <<'USAGE'
usage: verify/run.sh [--quick | --all] [--sanitizers | --no-sanitizers | --faults] [ctest options]
  --quick          in five minutes on two cores: the release build of the
                   short tests and of the gate, and the gate's checks of sequential runs
  --all            the tests labelled long and tools as well, all others optimised as well, the preset
                   lto, and whether the tests notice a tenth of the seeded faults, those of this commit
  --sanitizers     nothing but the tests and the search under the sanitizers
  --no-sanitizers  everything but them
  --faults         nothing but this tenth of the seeded faults
Other options go to each run of ctest, e.g. -R test_geometry; nothing is searched and no faults are seeded
then. Installs missing Debian packages as root or through sudo.
Exit code: 0 all passed, 1 something failed, 2 nothing was run.
USAGE
}

all=false
quick=false
with_release=true
with_sanitizers=true
with_search=true
ctest_options=()
for argument in "$@"; do
    case $argument in
        --all) all=true ;;
        --quick)
            quick=true
            with_sanitizers=false
            ;;
        --sanitizers) with_release=false ;;
        --no-sanitizers) with_sanitizers=false ;;
        --faults)
            folder=$(dirname -- "${BASH_SOURCE[0]}")
            exec "$folder/faults.sh" --tenth "$(git -C "$folder" rev-parse HEAD)"
            ;;
        -h | --help) usage; exit 0 ;;
        *)
            ctest_options+=("$argument")
            with_search=false
            ;;
    esac
done
if { ! $with_release && ! $with_sanitizers; } || { $quick && $all; }; then
    usage >&2
    exit 2
fi

# shellcheck source=verify/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

# Threads that spin while they wait are slow where cores are shared.
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}

failed=()
commit=$(git rev-parse HEAD 2>/dev/null || echo 0000000)

run_tests() { # run_tests PRESET [COMMAND PREFIX...]
    local test_preset=$1
    shift
    say "tests of preset $test_preset"
    "$@" ctest --preset "$test_preset" --parallel "$jobs" "${ctest_options[@]}" </dev/null ||
        failed+=("tests of preset $test_preset")
}

# Short scenes that use every part of a step.
quick_tests=(test_base test_geometry test_complex test_operations test_quality test_motion
    test_passes test_algorithm test_thesis)
# Checks of the sequential run of every scene.
quick_checks=(area_ratio symmetric_difference symmetric_difference_half inverted unreached
    min_quality)

# A figure also fails if it is worse than its stored measurement by more than a tenth.
run_gate() { # run_gate [CHECK...]: all, unless some are named
    say "gate"
    build/release/verify/dsc_verify run "$@" --drift 0.1 --jobs "$jobs" \
        --out build/release/verify/out </dev/null || failed+=("gate")
}

run_sanitizer() { # run_sanitizer PRESET [COMMAND PREFIX...]
    local test_preset=$1 targets=()
    if $all && [[ $1 == asan ]]; then
        test_preset=asan-all
        targets=(--target dsc_tests_asan_all)
    fi
    if build_preset "$1" "${targets[@]}"; then
        run_tests "$test_preset" "${@:2}"
    else
        failed+=("build of preset $1")
        return 1
    fi
}

if $quick; then
    set_up plain
    if ! build_preset release --target dsc_verify "${quick_tests[@]}"; then
        say "the release build failed: nothing was tested"
        exit 1
    fi
    pattern=$(IFS='|' && printf '%s' "${quick_tests[*]}")
    ctest_options=(-R "^($pattern)\\." "${ctest_options[@]}")
    run_tests release
    run_gate "${quick_checks[@]}"
    with_release=false
else
    if $with_release; then
        install_packages "${guide_packages[@]}"
    fi
    if $all; then
        install_packages "${browser_packages[@]}" "${reader_packages[@]}" "${workflow_packages[@]}"
    fi
fi
if $with_sanitizers; then
    set_up tsan
elif ! $quick; then
    set_up plain
fi

if $with_release; then
    preset=release
    targets=()
    if $all; then
        preset=release-all
    elif $with_sanitizers && [[ ${#ctest_options[@]} -eq 0 ]]; then
        preset=release-optimised
        targets=(--target dsc_tests_optimised)
    fi
    if ! build_preset release "${targets[@]}"; then
        say "the release build failed: nothing was tested"
        exit 1
    fi
    run_tests "$preset"
    run_gate
    if $all && ! build_preset lto; then
        failed+=("build of preset lto")
    fi
fi

if $with_sanitizers; then
    # A selection of tests may contain none for a sanitizer.
    if [[ ${#ctest_options[@]} -gt 0 ]]; then
        ctest_options+=(--no-tests=ignore)
    fi
    if run_sanitizer asan && $with_search; then
        say "search by libFuzzer"
        # The limit allows for other programs on the cores; on an idle machine no input takes a second.
        verify/fuzz.sh --turn "$commit" 30 -timeout=60 </dev/null || failed+=("search by libFuzzer")
    fi
    # Kernels that randomise addresses widely leave clang 14's thread sanitizer no room.
    fixed_addresses=()
    if setarch "$(uname -m)" --addr-no-randomize true 2>/dev/null; then
        fixed_addresses=(setarch "$(uname -m)" --addr-no-randomize)
    fi
    run_sanitizer tsan "${fixed_addresses[@]}" || true
fi

if $all && $with_release && $with_search; then
    say "seeded faults"
    verify/faults.sh --tenth "$commit" --own </dev/null || failed+=("seeded faults")
fi
if [[ ${#failed[@]} -gt 0 ]]; then
    printf 'failed: %s\n' "${failed[@]}"
    exit 1
fi
