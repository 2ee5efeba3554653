#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Do the tests notice what is wrong? Builds a copy of the project that holds all seeded faults of
# verify/faults/table, each with a switch, and runs the tests on each of them until one catches it.
set -euo pipefail

usage() {
    cat <<'USAGE'
usage: verify/faults.sh [--tenth HASH | --only NAME... | --mutants N [--seed TEXT]] [--own] [--jobs N]
  --tenth HASH  the faults of about a tenth of the rooms, those that belong to a commit
  --only NAME   these faults, or rooms
  --mutants N   in place of them N small changes of the library, made by rule; nine in ten have to be caught
  --own         by the tests of each fault's own room alone; no others are built
  --jobs N      so many faults at the same time; by default one for each core
The build takes a quarter of an hour of CPU time, all faults another half, and 1,000 mutants some hours. The
results are in build/faults/faults.json and mutants.json. Installs missing Debian packages as root or through
sudo. Exit code: 0 all were caught, 1 some were not, 2 nothing was run.
USAGE
}

# Refused before anything is installed or built; faults.py looks at the values.
for argument in "$@"; do
    case $argument in
        -h | --help) usage; exit 0 ;;
        --tenth | --only | --mutants | --seed | --own | --jobs) ;;
        -*)
            printf '%s: unknown option: %s; --help shows those that there are\n' "$0" "$argument" >&2
            exit 2
            ;;
    esac
done
# shellcheck source=verify/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"
set_up plain
exec "$python" verify/faults/faults.py build/faults --jobs "$jobs" "$@"
