#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Which lines and branches of lib/dsc and the modules do the tests run? Builds them with --coverage, runs those of
# GoogleTest that are not long, and prints the shares of each room.
set -euo pipefail

usage() {
    cat <<'USAGE'
usage: verify/coverage.sh [--no-run] [ctest options]
  --no-run  the report alone, of what the last run has left
Other options go to ctest, e.g. -R test_geometry. Leaves build/coverage/coverage.md, the shares by room and
the lines that no test runs, and build/coverage/html/index.html, each file line by line. Branches that only
exceptions take are not counted; throws themselves are lines as all others. Installs missing Debian
packages as root or through sudo.
Exit code: 0 enough is covered, 1 it is not or a test failed, 2 nothing was measured.
USAGE
}

with_run=true
ctest_options=()
for argument in "$@"; do
    case $argument in
        -h | --help) usage; exit 0 ;;
        --no-run) with_run=false ;;
        *) ctest_options+=("$argument") ;;
    esac
done

# shellcheck source=verify/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"
set_up plain
install_packages gcovr

folder=build/coverage
failed=false
if $with_run; then
    mapfile -t programs < <(sed -n 's/^dsc_add_tests(\(test_[a-z_]*\).*/\1/p' verify/CMakeLists.txt |
        grep -v '^test_hard_long$')
    build_preset coverage --target "${programs[@]}" ||
        give_up "the build failed: nothing was measured"
    # Counts of an earlier run would be added to these.
    find "$folder" -name '*.gcda' -delete
    say "tests of preset coverage"
    OMP_WAIT_POLICY=passive ctest --preset coverage --parallel "$jobs" "${ctest_options[@]}" </dev/null ||
        failed=true
fi

say "counting"
rm -rf "$folder/html"
mkdir -p "$folder/html"
quietly gcovr --root . --filter 'lib/(dsc|fluid|geometric_flows|thesis|topology)/' --exclude-throw-branches --exclude-unreachable-branches \
    --json "$folder/coverage.json" -j "$jobs" "$folder" ||
    give_up "gcovr could not read the counts in $folder"
quietly gcovr --root . --add-tracefile "$folder/coverage.json" --html-details \
    "$folder/html/index.html" || give_up "gcovr could not write $folder/html"
code=0
python3 verify/coverage/rooms.py "$folder/coverage.json" --out "$folder/coverage.md" || code=$?
if $failed && [[ $code -eq 0 ]]; then
    say "a test failed"
    code=1
fi
exit "$code"
