#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Mutation testing: builds a copy of the project that contains all seeded faults of verify/faults/table, each
# with a switch, and runs the tests on each fault until one catches it. The options are those of faults.py,
# which --help shows. The build takes a quarter of an hour of CPU time, all faults another half, and 1,000
# mutants some hours; the results are in build/faults/faults.json and mutants.json. Installs missing Debian
# packages as root or through sudo. Exit code: 0 all were caught (of the mutants nine in ten), 1 some were
# not, 2 nothing was run.
set -euo pipefail

if [[ ${1-} == -h || ${1-} == --help ]]; then
    exec python3 "$(dirname -- "${BASH_SOURCE[0]}")/faults/faults.py" --help
fi
# shellcheck source=verify/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"
set_up plain
exec "$python" verify/faults/faults.py build/faults --jobs "$jobs" "$@"
