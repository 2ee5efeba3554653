#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The table of choosing.md, from measurements:

choices.py DSC_SCENE          runs all rows and writes the table into choosing.md
choices.py DSC_SCENE --check  runs them and compares the errors with those in the file; not the times

Exit 0: done; 1: an error differs. A row runs the single vortex with T = 8 and dt = h unless it says
otherwise; the CPU time is the shortest of three runs.
"""
import json
import os
import re
import subprocess
import sys
import tempfile

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "choosing.md")
BEGIN, END = "<!-- table by choices.py -->\n", "<!-- end of the table -->\n"
HEADER = ("| `--set` | error at the end | half-way | CPU time |\n"
          "| --- | --- | --- | --- |\n")
LENGTHS = ("0.04", "0.02", "0.01", "0.005")
ROWS = (
    *({"h": h, "dt": h} for h in LENGTHS),
    # The deviation falls with the fourth power of h.
    *({"h": h, "dt": h, "reading": "cubic", "deviation": f"{27000 * float(h) ** 4:.2g}"}
      for h in LENGTHS),
    {"h": "0.01", "dt": "0.01", "coarsening": "never"},
    {"h": "0.01", "dt": "0.01", "insertion": "arc"},
    {"h": "0.01", "dt": "0.01", "insertion": "linear"},
    {"h": "0.01", "dt": "0.01", "coarsening": "length"},
    {"h": "0.01", "dt": "0.01", "integrator": "midpoint"},
    {"h": "0.01", "dt": "0.01", "integrator": "centred"},
    {"h": "0.01", "dt": "0.001", "integrator": "euler"},
    {"h": "0.01", "dt": "0.01", "integrator": "adaptive", "tolerance": "1e-5"},
    {"h": "0.01", "dt": "0.01", "integrator": "centred", "insertion": "linear",
     "coarsening": "length"},
)


def measured(program, settings, runs):
    """(error at the end, half-way, CPU seconds)"""
    words = [program, "run", "single-vortex"]
    for key, value in settings.items():
        words += ["--set", f"{key}={value}"]
    results = []
    with tempfile.TemporaryDirectory() as folder:
        result = os.path.join(folder, "result.json")
        for _ in range(runs):
            subprocess.run([*words, "--json", result], check=True, stdout=subprocess.DEVNULL,
                           env={**os.environ, "OMP_WAIT_POLICY": "passive"})
            with open(result, encoding="utf-8") as stream:
                results.append(json.load(stream))
    return (results[0]["sd_rel_last"], results[0]["sd_rel_half"],
            min(result["cpu_s"] for result in results))


def row(settings, figures):
    words = " ".join(f"{key}={value}" for key, value in settings.items())
    last, half, cpu = figures
    return f"| `{words}` | {last:.1e} | {half:.1e} | {cpu:.2g} s |\n"


def errors(table):
    """The rows without the times."""
    return [re.sub(r"\| [^|]+ s \|$", "", line) for line in table.splitlines()]


def main(arguments):
    with open(PAGE, encoding="utf-8") as stream:
        page = stream.read()
    begin, end = page.index(BEGIN) + len(BEGIN), page.index(END)
    check = "--check" in arguments
    table = HEADER + "".join(row(r, measured(arguments[0], r, 1 if check else 3)) for r in ROWS)
    if check:
        differing = [f"{old}\n{new}" for old, new in zip(errors(page[begin:end]), errors(table))
                     if old != new]
        print("\n".join(differing) or "the errors are those of the table")
        return 1 if differing or len(errors(page[begin:end])) != len(errors(table)) else 0
    with open(PAGE, "w", encoding="utf-8") as stream:
        stream.write(page[:begin] + table + page[end:])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
