#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""bands.py DSC_SCENE LIMITS_JSON: writes the limits of the parallel checks anew, and those of the
histograms against the reference.

How far may a parallel run be from the sequential one? As far as two sequential runs are from each
other that take the interface in different orders: each scene is run as it is and in fifty shuffled
orders (--set seed=1..50), and the largest distance between any two of these runs, a tenth added, is
the limit. The order changes how far a coarse run is from the reference by a factor of two as well, so
that the farthest of these orders, a tenth added, is the limit there. What is required, such as
that all vertices arrive, stays as it is. To be run by hand when the algorithm changes; the gate itself
never writes limits. Standard library only."""
import itertools
import json
import math
import os
import subprocess
import sys
import tempfile

SEEDS = range(1, 51)
MARGIN = 0.1
# The coarse runs that are compared with the reference: those of runs.cpp.
COARSE = ("h=0.05", "longest=1.4", "shortest=0.45", "deviation=0.02")
AGAINST_REFERENCE = {"scaling": (), "translation": (), "rotation-rectangle": (),
                     "speedup-four-circles": (), "swirl": (), "single-vortex": ("period=2",)}
# Runs of rigid motions end on the exact shape to rounding, in any order.
LEAST = {"parallel_area": 1e-12, "parallel_symmetric_difference": 1e-12}


def scenes(program):
    listed = subprocess.run([program, "list"], capture_output=True, text=True, check=True).stdout
    return [line.split()[0] for line in listed.splitlines() if line.strip()]


def run(program, scene, seed, settings=(), strategy="sequential"):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "result.json")
        chosen = [word for one in (f"seed={seed}", *settings) for word in ("--set", one)]
        subprocess.run([program, "run", scene, *chosen, "--strategy", strategy, "--json", path],
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        with open(path, encoding="utf-8") as stream:
            return json.load(stream)


def distance(a, b):
    """Kolmogorov and Smirnov's, of two histograms with the same bins."""
    sums, most = [0.0, 0.0], 0.0
    totals = [sum(a["counts"]), sum(b["counts"])]
    for pair in zip(a["counts"], b["counts"]):
        sums = [s + count / total for s, count, total in zip(sums, pair, totals)]
        most = max(most, abs(sums[0] - sums[1]))
    return most


def differences(base, other):
    """How far two runs are from each other."""
    found = {
        "parallel_area": abs(other["area_ratio"] - base["area_ratio"]) / base["area_ratio"],
        "parallel_area_histogram": distance(base["histograms"]["area"],
                                            other["histograms"]["area"]),
        "parallel_quality_histogram": distance(base["histograms"]["quality"],
                                               other["histograms"]["quality"]),
    }
    if base["sd_rel_last"] is not None:  # there is an exact shape
        found["parallel_symmetric_difference"] = abs(other["sd_rel_last"] - base["sd_rel_last"])
    return found


def rounded(value, up):
    """To two digits, away from what was measured."""
    if value == 0:
        return 0.0
    digits = 1 - math.floor(math.log10(abs(value)))
    scale = 10.0 ** digits
    return round((math.ceil if up else math.floor)(value * scale) / scale, max(digits, 0))


def limit(name, values):
    orders = f"{len(SEEDS) + 1} sequential runs in different orders"
    if name in ("parallel_min_quality", "parallel_min_angle"):
        return {"value": rounded(min(values) * (1 - MARGIN), False),
                "note": f"{orders} had {min(values):.3g} and more; a tenth below"}
    return {"value": max(rounded(max(values) * (1 + MARGIN), True), LEAST.get(name, 0.0)),
            "note": f"any two of {orders} differ by up to {max(values):.3g}; a tenth above"}


def limit_against_reference(values):
    return {"value": rounded(max(values) * (1 + MARGIN), True),
            "note": f"in {len(values)} orders of the interface the library differs from the "
                    f"reference by up to {max(values):.3g}; a tenth above"}


def renew(limits, scene, runs):
    """The limits of the parallel checks of a scene, by its runs in all orders."""
    pairs = [differences(a, b) for a, b in itertools.combinations(runs, 2)]
    found = {name: [pair[name] for pair in pairs] for name in pairs[0]}
    found["parallel_min_quality"] = [one["min_quality_last"] for one in runs]
    found["parallel_min_angle"] = [one["min_angle_deg_last"] for one in runs]
    for name, values in found.items():
        limits.setdefault(name, {})[scene] = limit(name, values)
        print(f"{name} {scene}: {limits[name][scene]['value']}")
    limits.setdefault("parallel_unreached", {}).setdefault(
        scene, {"value": 0, "note": "required: none"})


def write_reference(program, limits):
    for scene, more in AGAINST_REFERENCE.items():
        settings = (*COARSE, *more)
        literal = run(program, scene, 0, settings, "reference")["histograms"]
        runs = [run(program, scene, seed, settings)["histograms"] for seed in (0, *SEEDS)]
        for quantity in ("area", "quality"):
            name = f"reference_{quantity}_histogram"
            limits[name][scene] = limit_against_reference(
                [distance(one[quantity], literal[quantity]) for one in runs])
            print(f"{name} {scene}: {limits[name][scene]['value']}")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, path = sys.argv[1:]
    with open(path, encoding="utf-8") as stream:
        data = json.load(stream)
    for scene in scenes(program):
        renew(data["limits"], scene, [run(program, scene, seed) for seed in (0, *SEEDS)])
    write_reference(program, data["limits"])
    with open(path + ".part", "w", encoding="utf-8") as stream:
        json.dump(data, stream, indent=2)
        stream.write("\n")
    os.replace(path + ".part", path)


if __name__ == "__main__":
    main()
