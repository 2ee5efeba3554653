#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The tables of errors in choosing.md and in the README, from measurements:

choices.py DSC_SCENE              runs all rows and writes both tables
choices.py DSC_SCENE --check      runs them and compares their errors, not their times, with the pages
choices.py DSC_SCENE --only PAGE  runs one table: README.md or lib/guide/choosing.md

Exit code: 0 done, 1 an error differs, 2 bad usage. The CPU time of a row is the shortest of three
runs.
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BEGIN, END = "<!-- table by lib/guide/choices.py -->\n", "<!-- end of the table -->\n"
THESIS = {"integrator": "centred", "insertion": "linear", "coarsening": "length"}


def cubic(h):
    """The deviation falls with the fourth power of h."""
    return {"reading": "cubic", "deviation": f"{27000 * float(h) ** 4:.2g}"}


def words_of(settings):
    return " ".join(f"{key}={value}" for key, value in settings.items())


def measured(program, scene, settings, runs):
    """The cells of a row: errors at the end and half-way, and CPU seconds."""
    words = [program, "run", scene]
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
    return cells(results[0]["sd_rel_last"], results[0]["sd_rel_half"],
                 min(result["cpu_s"] for result in results))


def cells(last, half, cpu):
    half = "-" if half is None else f"{half:.1e}"
    return f"{last:.1e} | {half} | {float(f'{cpu:.2g}'):g} s"


def choosing(program, runs):
    """The single vortex with T = 8: the effect of each choice on the error."""
    default = {"h": "0.01", "dt": "0.01"}
    lengths = ("0.04", "0.02", "0.01", "0.005")
    rows = (
        *({"h": h, "dt": h} for h in lengths),
        *({"h": h, "dt": h, **cubic(h)} for h in lengths),
        {**default, "coarsening": "never"},
        {**default, "insertion": "linear"},
        {**default, "coarsening": "length"},
        {**default, "integrator": "midpoint"},
        {**default, "integrator": "centred"},
        {"h": "0.01", "dt": "0.001", "integrator": "euler"},
        {**default, "integrator": "adaptive", "tolerance": "1e-5"},
        {**default, **THESIS},
    )
    yield "| `--set` | error at the end | half-way | CPU time |"
    yield "| --- | --- | --- | --- |"
    for settings in rows:
        yield f"| `{words_of(settings)}` | {measured(program, 'single-vortex', settings, runs)} |"


def official(scene):
    """The cells of the official 2D DSC at h = 0.01; its error half-way was not measured."""
    path = os.path.join(ROOT, "reference", "published", "peers.json")
    with open(path, encoding="utf-8") as stream:
        runs = json.load(stream)["entries"]["official_dsc_scenes"]["values"]
    run = next(run for run in runs if run["scene"] == scene and run["h"] == 0.01
               and run.get("steps_each_way", 260) == 260)
    return cells(run["sd_rel"], None, run["seconds"])


def readme(program, runs):
    """Three scenes with the defaults, with other choices, and with the official 2D DSC."""
    h = {"h": "0.01"}
    rows = (
        ("swirl", "the defaults", h),
        ("swirl", "the interface read as a cubic", {**h, **cubic("0.01")}),
        ("swirl", "the thesis's choices", {**h, **THESIS}),
        ("swirl", "the official 2D DSC", None),
        ("single-vortex", "the defaults", h),
        ("single-vortex", "the interface read as a cubic", {**h, **cubic("0.01")}),
        ("single-vortex", "the thesis's choices", {**h, **THESIS}),
        ("single-vortex", "the official 2D DSC", None),
        ("zalesak", "the defaults", h),
        ("zalesak", "the official 2D DSC", None),
    )
    yield "| scene | method | error at the end | half-way | CPU time |"
    yield "| --- | --- | --- | --- | --- |"
    for scene, method, settings in rows:
        figures = official(scene) if settings is None else measured(program, scene, settings, runs)
        yield f"| `{scene}` | {method} | {figures} |"


TABLES = {"lib/guide/choosing.md": choosing, "README.md": readme}


def errors(table):
    """The rows without the times."""
    return [re.sub(r"\| [^|]+ s \|$", "", line) for line in table]


def differences(page, table):
    """The rows of the page whose errors differ from the table, each with the correct row."""
    old, new = errors(page), errors(table)
    return [f"{a}\n{b}" for a, b in zip(old, new) if a != b] + (
        [] if len(old) == len(new) else [f"{len(old)} rows, not {len(new)}"])


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="DSC_SCENE")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--only", choices=TABLES, metavar="PAGE")
    chosen = parser.parse_args(arguments)
    differing = []
    for page in [chosen.only] if chosen.only else TABLES:
        path = os.path.join(ROOT, page)
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
        table = list(TABLES[page](chosen.program, 1 if chosen.check else 3))
        if chosen.check:
            rows = text[begin:end].splitlines()
            differing += [f"{page}: {row}" for row in differences(rows, table)]
            continue
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text[:begin] + "".join(f"{line}\n" for line in table) + text[end:])
    if chosen.check:
        print("\n".join(differing) or "all errors agree with the tables")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
