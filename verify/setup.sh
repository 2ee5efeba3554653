# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# Set-up that bench/run.sh and verify/run.sh share; they source this file. It changes to the
# project's root and defines functions. It asks no questions and may be sourced any number of times.

project_root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd -- "$project_root" || exit 2

build_packages=(cmake g++ ninja-build git libeigen3-dev libboost-dev zlib1g-dev libassimp-dev
    nlohmann-json3-dev libtomlplusplus-dev libcli11-dev googletest libgtest-dev libbenchmark-dev
    python3-yaml pybind11-dev python3-dev python3-numpy python3-venv)
plot_packages=(python3 python3-matplotlib python3-meshio)
# For the reference pages and the types of the Python package, which `verify/run.sh` tests unless it is quick.
guide_packages=(doxygen mypy)
# For the tests that only `verify/run.sh --all` needs: a browser for the page of the report, programs
# that read frames, and the workflow engine of bench/Snakefile.
browser_packages=(chromium chromium-driver python3-selenium)
reader_packages=(python3-vtk9)
workflow_packages=(snakemake)
# The sanitizer's own runtime is only recommended by clang-14, so it is named.
tsan_packages=(clang-14 clang-format-14 lld-14 libclang-rt-14-dev libomp-14-dev)

jobs=$(env -u OMP_NUM_THREADS nproc)

say() {
    printf '== %s [%d:%02d]\n' "$*" $((SECONDS / 60)) $((SECONDS % 60))
}

# Prints the reason why nothing was run, and exits with code 2.
give_up() {
    printf '%s: %s\n' "$0" "$*" >&2
    exit 2
}

# quietly COMMAND...: shows what the command printed only if it fails.
quietly() {
    local output code=0
    output=$("$@" </dev/null 2>&1) || code=$?
    if [[ $code -ne 0 ]]; then
        printf '%s\n' "$output" >&2
    fi
    return "$code"
}

# install_packages PACKAGE...: installs those that dpkg does not know as installed.
install_packages() {
    local package missing=()
    if ! command -v dpkg-query >/dev/null; then
        say "not a Debian system: assuming that these are installed: ${*}"
        return
    fi
    for package in "$@"; do
        if [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) != installed ]]; then
            missing+=("$package")
        fi
    done
    if [[ ${#missing[@]} -eq 0 ]]; then
        return
    fi

    local as_root=()
    if [[ $(id -u) -ne 0 ]]; then
        if ! sudo -n true 2>/dev/null; then
            give_up "these packages are missing: ${missing[*]}
Install them with: sudo apt-get install --no-install-recommends ${missing[*]}"
        fi
        as_root=(sudo -n)
    fi
    say "installing ${missing[*]}"
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q
        -o DPkg::Lock::Timeout=300)
    # A failed update matters only if the packages cannot be installed.
    quietly "${apt[@]}" update || say "apt-get update failed: using the existing package lists"
    quietly "${apt[@]}" install -y --no-install-recommends "${missing[@]}" ||
        give_up "apt-get could not install ${missing[*]}"
}

# Sets `python` to the first interpreter that can draw, which is not always the first
# on PATH: Debian's packages serve /usr/bin/python3 alone.
find_python() {
    local candidate
    for candidate in python3 /usr/bin/python3; do
        if "$candidate" -c 'import matplotlib, meshio' >/dev/null 2>&1; then
            python=$(command -v "$candidate")
            return 0
        fi
    done
    return 1
}

# set_up plain|tsan: everything that is needed to build, run and plot; sets `python`.
set_up() {
    local packages=("${build_packages[@]}")
    if [[ $1 == tsan ]]; then
        packages+=("${tsan_packages[@]}")
    fi
    if ! find_python; then
        packages+=("${plot_packages[@]}")
    fi
    install_packages "${packages[@]}"
    if ! find_python; then
        give_up "neither python3 nor /usr/bin/python3 can import matplotlib and meshio (Debian: \
python3-matplotlib, python3-meshio); put one that can on PATH, as python3"
    fi
    say "set-up done; plots by $python"
}

# build_preset PRESET [BUILD OPTION...]
build_preset() {
    local preset=$1
    shift
    local quiet=()
    if [[ ! -t 1 ]]; then
        quiet=(-- --quiet)
    fi
    say "building preset $preset with $jobs jobs"
    quietly cmake --preset "$preset" -D DSC_PYTHON="$python" &&
        cmake --build --preset "$preset" --parallel "$jobs" "$@" "${quiet[@]}"
}
