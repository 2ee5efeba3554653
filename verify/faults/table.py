# SPDX-License-Identifier: MIT
"""The results of run.py in words and as a table."""
import collections

import programs


def verdict(entry):
    """'own room', 'another test', 'a broad test' or 'nothing'."""
    if not entry["caught_by"]:
        return "nothing"
    if entry["own"]:
        return "own room"
    return "a broad test" if entry["caught_by"] in programs.BROAD else "another test"


def summary(entries):
    counts = collections.Counter(verdict(entry) for entry in entries.values())
    words = ", ".join(f"{counts[k]} by {k}" for k in
                      ("own room", "another test", "a broad test", "nothing"))
    uncaught = [name for name, entry in entries.items() if not entry["caught_by"]]
    return f"{len(entries)} faults: {words}" + (f" ({', '.join(uncaught)})" if uncaught else "")


def markdown(entries):
    lines = [summary(entries), "",
             "| fault | room | kind | what is wrong | caught by | how | CPU, s |",
             "| --- | --- | --- | --- | --- | --- | --- |"]
    for name, entry in sorted(entries.items(), key=lambda item: (item[1]["room"], item[0])):
        by = entry["caught_by"]
        test = f"{by}: {entry['test']}" if by else "**nothing**"
        lines.append(f"| {name} | {entry['room']} | {entry['kind']} | {entry['says']} | {test} | "
                     f"{entry['how'] + ', ' + verdict(entry) if by else ''} | {entry['cpu_s']} |")
    return "\n".join(lines) + "\n"
