#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The gate of this project: builds it against the installed dsc, runs its tests, holds its scenes to
# their limits, and, given a base commit, says whether the program has become slower since.
set -euo pipefail

usage() {
    cat <<'USAGE'
usage: ./gate.sh PREFIX [BASE [OPTIONS]]
  PREFIX   where dsc is installed
  BASE     a commit of this project, which is built beside it in build/base and run in turn with it
  OPTIONS  of compare.py, which compares their times
Results: build/gate/verify.json and verify.xml, pictures of what failed in build/gate/failures, and
build/gate/tests.xml. Limits are in scenes/*.toml and gate.toml; to measure those of gate.toml anew:
  dsc_verify propose ./gate.toml --update
Exit code: 0 all holds, 1 something does not, 2 bad usage or a tool is missing.
USAGE
}

case ${1:-} in
    -h | --help) usage; exit 0 ;;
    -* | "") usage >&2; exit 2 ;;
esac
prefix=$(realpath -- "$1")
base=${2:-}
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"
verify=$prefix/bin/dsc_verify
if [[ ! -x $verify ]]; then
    printf '%s: no dsc is installed in %s\n' "$0" "$prefix" >&2
    exit 2
fi

build() { # build SOURCE FOLDER
    cmake -S "$1" -B "$2" -D CMAKE_PREFIX_PATH="$prefix" -D CMAKE_BUILD_TYPE=Release >/dev/null
    cmake --build "$2"
}

failed=()
here=$PWD
mkdir -p build/gate
build . build/new
ctest --test-dir build/new --output-on-failure --output-junit "$here/build/gate/tests.xml" ||
    failed+=("tests")
"$verify" run ./scenes/*.toml ./gate.toml --jobs "$(nproc)" --out build/gate || failed+=("limits")

if [[ -n $base ]]; then
    inside=$(git rev-parse --show-prefix) # if the project is a part of a larger repository
    rm -rf build/base
    git worktree prune
    git worktree add --force --detach build/base "$base"
    build "build/base/$inside" build/of_base
    code=0
    python3 "$prefix/share/dsc/compare/compare.py" --bare --base build/of_base/droplet \
        --new build/new/droplet --out build/gate "${@:3}" || code=$?
    if [[ $code -ne 0 && $code -ne 3 ]]; then # 3: the machine is too noisy for a verdict
        failed+=("speed")
    fi
    git worktree remove --force build/base
fi

if [[ ${#failed[@]} -gt 0 ]]; then
    printf 'failed: %s\n' "${failed[@]}"
    exit 1
fi
