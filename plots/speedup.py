#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the speed-up S(n) and the utilisation U(n) from results of dsc_bench.

speedup.py FILE.json... --out PICTURE.pdf [--case NAME]

S(n) is the time of the sequential strategy over that on n threads, U(n) = S(n) / n. A file that
measures several things (NAME_run, NAME_step) becomes as many pictures, PICTURE-NAME_run.pdf and so
on, unless --case chooses one. Prints what the pictures say, and their paths. Exit 0 done; 2 bad
usage or a file that cannot be used, with one sentence on the error stream.
"""
import argparse
import os
import sys

from look import style
from parallel import speedup
from results import load

FORMATS = (".png", ".svg", ".pdf")


def arguments(argv):
    parser = argparse.ArgumentParser(prog="speedup.py", description=__doc__.split("\n\n")[0],
                                     epilog=__doc__.split("\n\n")[2],
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", nargs="+", metavar="FILE.json",
                        help="what dsc_bench --benchmark_out wrote, on one machine at one commit")
    parser.add_argument("--out", required=True, metavar="PICTURE", help="png, svg or pdf")
    parser.add_argument("--case", metavar="NAME", help="of the rows NAME/strategy:..., such as "
                                                       "swirl_run")
    return parser.parse_args(argv)


def chosen(found, name, files):
    """All families, or the one of that name."""
    names = [family.name for family in found]
    if not found:
        raise load.InputFault(f"{files[0]} has no parallel row with a sequential one beside it, so "
                              "there is no S(n); strategies = [\"sequential\", \"cells\"] in a "
                              "suite measures both.")
    if name is not None and name not in names:
        raise load.InputFault(f"--case has '{name}', where {style.listing(names)} can be drawn.")
    return [family for family in found if name in (None, family.name)]


def draw(given):
    stem, form = os.path.splitext(given.out)
    if form not in FORMATS:
        raise load.InputFault(f"--out has '{given.out}', where names ending in "
                              f"{style.listing(FORMATS)} are allowed.")
    bench = load.read_bench(given.results)
    found = chosen(speedup.gather_runs(bench) + speedup.gather(bench, {}), given.case,
                   given.results)
    for family in found:
        path = given.out if len(found) == 1 else f"{stem}-{family.name}{form}"
        picture = speedup.picture(family, bench.context)
        folder, name = os.path.split(path)
        style.save(picture.figure, folder or ".", os.path.splitext(name)[0], [form[1:]])
        print(f"{path}: {picture.details}")


def main(argv):
    try:
        draw(arguments(argv))
    except (load.InputFault, OSError) as fault:
        sys.stderr.write(f"speedup.py: {fault}\n")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
