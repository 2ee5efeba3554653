#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the figures of the thesis's section 10 with ours under them: gallery.html and pictures.

make.py --scene build/release/lib/scenes/dsc_scene --out DIR [--quick]

Everything is run anew, in less than a minute of CPU time. Exit 0 done (a scene that the program
does not know is said to be missing, in the page); 1 a run failed; 2 bad usage.
"""
import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import gallery  # noqa: E402  (the folder above must be on the path first)


def main(argv):
    parser = argparse.ArgumentParser(prog="make.py", description=__doc__.split("\n\n")[0])
    parser.add_argument("--scene", required=True, metavar="FILE", help="the program dsc_scene")
    parser.add_argument("--out", required=True, metavar="DIR", help="where the gallery goes")
    parser.add_argument("--quick", action="store_true", help="no animations")
    options = parser.parse_args(argv)
    try:
        failures = gallery.write(options.scene, pathlib.Path(options.out), options.quick)
    except gallery.NotRun as fault:
        sys.stderr.write(f"make.py: {fault}\n")
        return 2
    except OSError as fault:
        sys.stderr.write(f"make.py: {fault.filename or 'a file'} cannot be written: "
                         f"{fault.strerror}.\n")
        return 2
    for failure in failures:
        sys.stderr.write(f"make.py: {failure}\n")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
