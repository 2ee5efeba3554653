# SPDX-License-Identifier: MIT
"""What the tests notice: seeded faults, which test caught each and how fast, and the score of mutants
by room. Both are results of verify/faults.sh."""
import collections
import statistics

from look import style
from page import document as page
from results import load

NOT_RUN = "The faults were not seeded (verify/faults.sh), so nothing is said about what the tests notice."
OPEN = "nothing"


def read(path):
    """The entries of faults.json: {name: entry}."""
    found = load.need(load.read_json(path), "faults", path, dict)
    for name, entry in found.items():
        where = f"fault '{name}'"
        for key in ("room", "kind", "says"):
            load.need(entry, key, path, str, where)
        load.need(entry, "cpu_s", path, float, where)
        if load.need(entry, "caught_by", path, None, where) is not None:
            for key in ("caught_by", "how", "test"):
                load.need(entry, key, path, str, where)
            load.need(entry, "own", path, bool, where)
    return found


def read_mutants(path):
    """The entries of score.json."""
    found = load.need(load.read_json(path), "mutants", path, dict)
    for name, entry in found.items():
        where = f"mutant '{name}'"
        load.need(entry, "room", path, str, where)
        for key in ("killed_by", "equivalent"):
            load.need(entry, key, path, None, where)
    return list(found.values())


def _by(entry):
    if entry["caught_by"] is None:
        return OPEN
    return f"{entry['caught_by']}: {entry['test']}" if entry["test"] else entry["caught_by"]


def table(faults):
    """The sentence and the table of seeded faults."""
    if not faults:
        return page.paragraph("The list of seeded faults is empty, so it proves nothing.")
    caught = [entry for entry in faults.values() if entry["caught_by"]]
    missed = sorted(name for name, entry in faults.items() if not entry["caught_by"])
    text = (f"The tests caught {len(caught)} of {style.counted(len(faults), 'seeded fault')}, "
            f"{sum(entry['own'] for entry in caught)} of them the tests of the fault's own room")
    if caught:
        seconds = statistics.median(entry["cpu_s"] for entry in caught)
        text += f", in {style.digits(seconds, 2)} CPU seconds at the median"
    text += f"; nothing caught {style.listing(missed)}." if missed else "."
    rows = [[name, e["room"], e["kind"], e["says"], _by(e), e.get("how") or "–",
             f"{e['cpu_s']:.1f} s"]
            for name, e in sorted(faults.items(), key=lambda item: (item[1]["room"], item[0]))]
    marks = {(r, 4): "bad" for r, row in enumerate(rows) if row[4] == OPEN}
    return page.paragraph(text) + page.table(
        ["fault", "room", "kind", "what is wrong", "caught by", "how", "CPU time"], rows, marks,
        "Seeded faults")


def _score(entries):
    caught = sum(entry["killed_by"] is not None for entry in entries)
    equivalent = sum(entry["killed_by"] is None and bool(entry["equivalent"]) for entry in entries)
    return caught, equivalent, len(entries) - caught - equivalent


def _percent(caught, survivors):
    return f"{100 * caught / (caught + survivors):.0f} %" if caught + survivors else "–"


def mutants_table(entries):
    """The sentence and the table of mutants by room."""
    if not entries:
        return page.paragraph("The list of mutants is empty, so it proves nothing.")
    rooms = collections.defaultdict(list)
    for entry in entries:
        rooms[entry["room"]].append(entry)
    caught, equivalent, survivors = _score(entries)
    text = (f"Of {style.counted(len(entries), 'mutant')}, small changes made by rule, the tests caught "
            f"{caught}; {equivalent} cannot be told from the original, and {survivors} "
            f"{'survives' if survivors == 1 else 'survive'}: a score of "
            f"{_percent(caught, survivors)}.")
    rows = []
    for room, mine in sorted(rooms.items()):
        caught, equivalent, survivors = _score(mine)
        rows.append([room, len(mine), caught, equivalent, survivors, _percent(caught, survivors)])
    return page.paragraph(text) + page.table(
        ["room", "mutants", "caught", "equivalent", "survive", "score"], rows, name="Mutants by room")


def section(faults, mutants):
    """What there is of both, or nothing."""
    return ("" if faults is None else table(faults)) + ("" if mutants is None
                                                        else mutants_table(mutants))
