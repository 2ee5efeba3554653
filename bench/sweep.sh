#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Many runs from one table: sizes, strategies, threads, seeds, commits; see bench/sweep.
set -euo pipefail

usage() {
    cat <<'USAGE'
usage: bench/sweep.sh TABLE.toml [--out DIR] [--jobs N] [--profile P | --plain] [--retry-failed]
       bench/sweep.sh list TABLE.toml
       bench/sweep.sh collect DIR... [--report DIR]
  TABLE.toml      what to run: bench/sweep/tables has some, example.toml shows all that may stand in one
  --out DIR       where the results are; build/sweep/TABLE unless given
  --jobs N        cores of this machine, or jobs that a cluster has at a time
  --profile P     where Snakemake runs the jobs: slurm, or the folder of a profile of your own
  --plain         a plain loop, which is also what is done where Snakemake is not installed
  --retry-failed  runs that failed before are run again
  collect         a report of all results in some folders, each machine and commit by itself
More options: --help after the table. A sweep that was interrupted goes on where it stopped.
Exit code: 0 every run has a result, 1 some have failed or were not run, 2 nothing could be run.
USAGE
}

case ${1:-} in
    "" | -h | --help) usage; exit 0 ;;
esac

# Paths are those of the caller; the set-up goes to the project's root.
folder=$PWD
# shellcheck source=verify/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../verify/setup.sh"
set_up plain
cd -- "$folder"
exec "$python" "$project_root/bench/sweep/sweep.py" "$@"
