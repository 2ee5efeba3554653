#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Sets up, builds, and tests everything: unit tests, the gate, and the tests again under the
# address, undefined behaviour and thread sanitizers.
set -euo pipefail

usage() {
    cat <<'USAGE'
usage: verify/run.sh [--all] [--sanitizers | --no-sanitizers] [ctest options]
  --all            the tests labelled long as well
  --sanitizers     nothing but the tests under the sanitizers
  --no-sanitizers  everything but them
Other options go to each run of ctest, e.g. -R predicates. Installs missing Debian packages as root
or through sudo. DSC_JOBS sets the number of jobs, PYTHON the interpreter for the plots.
Exit code: 0 all passed, 1 something failed, 2 nothing was run.
USAGE
}

preset=release
with_release=true
with_sanitizers=true
ctest_options=()
for argument in "$@"; do
    case $argument in
        --all) preset=release-all ;;
        --sanitizers) with_release=false ;;
        --no-sanitizers) with_sanitizers=false ;;
        -h | --help) usage; exit 0 ;;
        *) ctest_options+=("$argument") ;;
    esac
done
if ! $with_release && ! $with_sanitizers; then
    usage >&2
    exit 2
fi

# shellcheck source=verify/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

# Threads that spin while they wait are slow where cores are shared.
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}

failed=()

run_tests() { # run_tests PRESET [COMMAND PREFIX...]
    local test_preset=$1
    shift
    say "tests of preset $test_preset"
    "$@" ctest --preset "$test_preset" --parallel "$jobs" "${ctest_options[@]}" </dev/null ||
        failed+=("tests of preset $test_preset")
}

run_gate() {
    say "gate"
    build/release/verify/dsc_verify run --out build/release/verify/out </dev/null || failed+=("gate")
}

run_sanitizer() { # run_sanitizer PRESET [COMMAND PREFIX...]
    if build_preset "$1"; then
        run_tests "$@"
    else
        failed+=("build of preset $1")
    fi
}

if $with_sanitizers; then
    set_up tsan
else
    set_up plain
fi

if $with_release; then
    if ! build_preset release; then
        say "the release build failed: nothing was tested"
        exit 1
    fi
    run_tests "$preset"
    run_gate
fi

if $with_sanitizers; then
    # A selection of tests may well leave a sanitizer none.
    if [[ ${#ctest_options[@]} -gt 0 ]]; then
        ctest_options+=(--no-tests=ignore)
    fi
    run_sanitizer asan
    # Kernels that randomise addresses widely leave clang 14's thread sanitizer no room.
    fixed_addresses=()
    if setarch "$(uname -m)" --addr-no-randomize true 2>/dev/null; then
        fixed_addresses=(setarch "$(uname -m)" --addr-no-randomize)
    fi
    run_sanitizer tsan "${fixed_addresses[@]}"
fi

if [[ ${#failed[@]} -gt 0 ]]; then
    printf 'failed: %s\n' "${failed[@]}"
    exit 1
fi
