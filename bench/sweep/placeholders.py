# SPDX-License-Identifier: MIT
"""Words in braces that stand in the commands of a table; {{ and }} are braces.

    {NAME}     a value of the row's `with`
    {threads}  {seed}  {repeat}
    {source}   the folder of the commit's sources, where the command runs
    {build}    the folder of its build by the preset release
    {python}   an interpreter that has matplotlib
    {out}      an empty folder; the JSON files that a run leaves there are kept with its result"""
import re

OF_RUNS = ("threads", "seed", "repeat")
PATHS = ("source", "build", "out", "python")
WORD = re.compile(r"\{\{|\}\}|\{(\w+)\}")


def names_in(text):
    return [found.group(1) for found in WORD.finditer(text) if found.group(1)]


def put_in(text, values):
    """The text with the values of a run in their places; the other placeholders stay for `fill`."""
    def value(found):
        name = found.group(1)
        if name not in values:
            return found.group()
        return values[name].replace("{", "{{").replace("}", "}}")
    return WORD.sub(value, text)


def fill(text, paths):
    """The text without placeholders."""
    return WORD.sub(lambda found: paths[found.group(1)] if found.group(1) else found.group()[0],
                    text)
