# SPDX-License-Identifier: MIT
"""The common part of all scripts: reads files, draws, saves, and prints the sentences of the pictures.
A file that cannot be used gives one sentence on the error stream."""
import argparse
import sys

from look import saving, style
from results.load import InputFault

FORMATS = ("png", "svg", "pdf")
NOTE = "Exit 0 done; 2 bad usage or a file that cannot be used, with one sentence on the error stream."


def parser(doc):
    """An argument parser from the script's docstring, which begins with its purpose and usage."""
    what, call, *more = doc.strip().split("\n\n")
    return argparse.ArgumentParser(
        prog=call.split()[0], usage=call, description=what, epilog="\n\n".join([*more, NOTE]),
        formatter_class=argparse.RawDescriptionHelpFormatter)


def attempt(name, work):
    """The exit status of a script that does this."""
    try:
        work()
    except (InputFault, OSError) as fault:
        sys.stderr.write(f"{name}: {fault}\n")
        return 2
    return 0


def main(doc, draw, argv=None, **options):
    """Saves the Pictures of draw(given), made from given.files, to given.out, or to one file each if there
    are several. options: {name: keywords of argparse} of the script."""
    words = parser(doc)
    words.add_argument("files", nargs="+", metavar="FILE")
    words.add_argument("--out", required=True, metavar="PICTURE", help="png, svg or pdf")
    for name, keywords in options.items():
        words.add_argument(f"--{name}", **keywords)
    given = words.parse_args(argv)
    stem, _, form = given.out.rpartition(".")

    def draw_all():
        if form not in FORMATS:
            raise InputFault(f"--out has '{given.out}', where names ending in "
                             f"{style.listing('.' + name for name in FORMATS)} are allowed.")
        pictures = list(draw(given))
        if not pictures:
            raise InputFault(f"{given.files[0]} has nothing to draw in this picture.")
        for picture in pictures:
            name = stem if len(pictures) == 1 else f"{stem}-{picture.name}"
            saving.save(picture.figure, name, [form])
            print(f"{name}.{form}: {picture.sentence}")

    return attempt(words.prog, draw_all)
