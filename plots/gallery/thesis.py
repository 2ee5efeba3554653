# SPDX-License-Identifier: MIT
"""The facts of the thesis's section 10, from the published figures of the repository."""
import json
import pathlib
from dataclasses import dataclass

PUBLISHED = pathlib.Path(__file__).resolve().parents[2] / "reference" / "published"


@dataclass(frozen=True)
class Described:
    """A figure of the thesis in our own words."""

    title: str
    shows: str
    source: str


class Facts:
    def __init__(self, folder=PUBLISHED):
        thesis = _json(folder / "thesis.json")
        self._figures = thesis["figures"]
        self._entries = {**_json(folder / "speedup.json")["entries"], **thesis["entries"]}

    def figure(self, number):
        item = self._figures[number]
        return Described(item["title"], item["shows"], item["source"])

    def numbers(self):
        """The numbers of all figures, in the thesis's order."""
        return list(self._figures)

    def entry(self, identifier):
        return self._entries[identifier]

    def value(self, identifier):
        return self._entries[identifier]["value"]

    def triangles(self, identifier):
        """{step: number of triangles}"""
        return {item["step"]: item["triangles"] for item in self._entries[identifier]["values"]}


def _json(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)
