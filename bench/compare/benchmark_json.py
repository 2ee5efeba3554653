# SPDX-License-Identifier: MIT
"""Times in the form of Google Benchmark, for its compare.py: `compare.py benchmarks base.json
new.json`."""
import json
import os


def entries(name, times_us):
    """One repetition for each time."""
    return [{"name": name, "run_name": name, "run_type": "iteration", "repetitions": len(times_us),
             "repetition_index": i, "threads": 1, "iterations": 1, "real_time": time,
             "cpu_time": time, "time_unit": "us"} for i, time in enumerate(times_us)]


def replace(path, data):
    """Writes JSON atomically."""
    part = f"{path}.{os.getpid()}.part"  # a name of this process: comparisons may run at the same time
    with open(part, "w", encoding="utf-8") as stream:
        json.dump(data, stream, indent=1)
        stream.write("\n")
    os.replace(part, path)


def write(path, executable, series, context):
    """`series`: {name: [microseconds]}."""
    data = {"context": {"executable": executable, "library_build_type": "release", **context},
            "benchmarks": [entry for name, times in series.items()
                           for entry in entries(name, times)]}
    replace(path, data)
