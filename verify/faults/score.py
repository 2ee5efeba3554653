# SPDX-License-Identifier: MIT
"""The results of mutate.py in words and as tables."""
import collections

import programs


def counts(entries):
    """{"mutants", "caught", "equivalent", "survivors", ...: how many}"""
    found = collections.Counter(mutants=len(entries))
    for entry in entries:
        if entry["killed_by"]:
            found["caught"] += 1
            found["by time"] += entry["how"] == "did not end"
            found["broad"] += entry["killed_by"] in programs.BROAD
            found["own"] += entry["own"]
        elif entry["equivalent"]:
            found["equivalent"] += 1
        else:
            found["survivors"] += 1
            found["not reached"] += not entry["tried"] and entry["left"] == 0
            found["not all tried"] += entry["left"] > 0
    return found


def share(entries):
    """Caught, of those that are not equivalent."""
    found = counts(entries)
    return found["caught"] / max(found["mutants"] - found["equivalent"], 1)


def summary(entries):
    found = counts(entries)
    return (f"{found['mutants']} mutants: {found['caught']} caught ({found['own']} by tests of their own "
            f"room, {found['broad']} by broad tests alone, {found['by time']} by time), "
            f"{found['equivalent']} equivalent, {found['survivors']} survive ({found['not reached']} are "
            f"reached by no test, {found['not all tried']} were not tried by all tests that reach them); "
            f"{100 * share(entries):.1f} % of those that are not equivalent are caught")


def markdown(entries, candidates):
    rooms = collections.defaultdict(list)
    for entry in entries:
        rooms[entry["room"]].append(entry)
    lines = [f"A sample of {candidates} candidates. " + summary(entries) + ".", "",
             "| room | mutants | caught | equivalent | survivors | score |",
             "| --- | --- | --- | --- | --- | --- |"]
    for room, mine in [*sorted(rooms.items()), ("all", entries)]:
        found = counts(mine)
        lines.append(f"| {room} | {found['mutants']} | {found['caught']} | {found['equivalent']} | "
                     f"{found['survivors']} | {100 * share(mine):.0f} % |")
    lines += ["", "| survivor | rule | line | changed | tried by |", "| --- | --- | --- | --- | --- |"]
    for entry in entries:
        if not entry["killed_by"] and not entry["equivalent"]:
            tried = f"{len(entry['tried'])} tests" if entry["tried"] else "no test reaches it"
            if entry["left"]:
                tried += f", {entry['left']} left"
            cells = [f"{entry['file']}:{entry['line']}", entry["rule"], f"`{entry['code']}`",
                     f"`{entry['changed']}`", tried]
            lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(lines) + "\n"
