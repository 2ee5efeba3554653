# SPDX-License-Identifier: MIT
"""Reads the results of sweeps, for pictures and tables; machines and commits stay apart."""
import dataclasses
import pathlib
import statistics

from results import load

FORMAT = 1
BUSY = 0.25   # cores that others kept busy beside a timed run: from here on it is marked
NOT_IN_A_LINE = ("h", "dt", "steps")  # settings in which the points of a line differ


@dataclasses.dataclass
class Group:
    """All results of one machine and one commit."""
    machine: str
    commit: str
    facts: dict
    records: list = dataclasses.field(default_factory=list)
    failures: list = dataclasses.field(default_factory=list)

    @property
    def context(self):
        described = next((r["result"]["commit"] for r in self.records
                          if isinstance(r["result"], dict) and "commit" in r["result"]), None)
        others = [r["others_busy"] for r in self.records
                  if r["identity"].get("timed") and r["others_busy"] is not None]
        return load.Context(
            machine=f"{self.facts.get('model', '')}, {self.facts.get('cores', '?')} cores "
                    f"({self.machine})",
            commit=described or self.commit,
            load=f"{statistics.median(others):.2f} cores" if others else "")


@dataclasses.dataclass(frozen=True)
class Spread:
    """Median and quartiles."""
    median: float
    low: float
    high: float
    count: int

    @staticmethod
    def of(values):
        values = sorted(values)
        if len(values) == 1:
            return Spread(values[0], values[0], values[0], 1)
        low, median, high = statistics.quantiles(values, n=4, method="inclusive")
        return Spread(median, low, high, len(values))


@dataclasses.dataclass
class Point:
    """All repeats and seeds of one run of a scene."""
    identity: dict
    records: list

    @property
    def scene(self):
        """Its name; that of a file with the beginning of its digest, for a file that was changed is
        another scene."""
        digest = self.identity.get("sha256")
        return self.identity["scene"] + (f" {digest[:6]}" if digest else "")

    @property
    def strategy(self):
        return self.identity["strategy"]

    @property
    def threads(self):
        return self.identity["threads"]

    @property
    def is_timed(self):
        return bool(self.identity.get("timed"))

    @property
    def is_doubtful(self):
        """Its times are those of runs beside others, or of more threads than the machine has
        cores."""
        return not self.is_timed or any((r["others_busy"] or 0) > BUSY or
                                        self.threads > r["machine"].get("cores", self.threads)
                                        for r in self.records)

    @property
    def h(self):
        return load.number_or_none(self.records[0]["result"].get("parameters", {}), "h")

    def spread(self, key):
        """Of a figure, over those runs that have it; None where none has."""
        values = [load.number_or_none(r["result"], key) for r in self.records]
        values = [value for value in values if value is not None]
        return Spread.of(values) if values else None

    @property
    def setting(self):
        """What tells lines of one scene apart, beside strategy and threads."""
        words = [f"{key}={value}" for key, value in self.identity["values"].items()
                 if key not in NOT_IN_A_LINE]
        words += [f"{key}={self.identity[key]}" for key in ("submeshes", "angle")
                  if key in self.identity]
        return " ".join(words)

    @property
    def label(self):
        words = [self.strategy if self.strategy in ("sequential", "reference") else
                 f"{self.strategy}, {self.threads} thread" + ("" if self.threads == 1 else "s")]
        return ", ".join(words + ([self.setting] if self.setting else []))

    @property
    def problem(self):
        """Everything but strategy, division and threads: what a speed-up compares."""
        return (self.scene, self.is_timed,
                tuple(sorted(self.identity["values"].items())))


def read(folders):
    """[Group], by machine and commit. Raises InputFault for a file that is no result."""
    groups, seen = {}, set()
    for folder in folders:
        paths = sorted(pathlib.Path(folder).glob("*/*/*.json"))
        for path in (path for path in paths if path.parent.name != "running"):
            record = load.read_json(str(path))
            if load.need(record, "format", str(path), int) != FORMAT:
                raise load.InputFault(f"{path} has format {record['format']}, where {FORMAT} is "
                                      "expected.")
            for key in ("machine", "identity"):
                load.need(record, key, str(path), dict)
            for key in ("commit", "key", "row", "what", "again"):
                load.need(record, key, str(path), str)
            name = load.need(record["machine"], "name", str(path), str)
            has_failed = path.name.endswith(".failed.json")
            if (name, record["commit"], record["key"], has_failed) in seen:
                continue  # a folder that was copied
            seen.add((name, record["commit"], record["key"], has_failed))
            group = groups.setdefault((name, record["commit"]),
                                      Group(name, record["commit"], record["machine"]))
            record["path"] = str(path)
            (group.failures if has_failed else group.records).append(record)
    return [groups[key] for key in sorted(groups)]


def points(group):
    """The runs of scenes, repeats and seeds together, in the order of the files' settings."""
    found = {}
    for record in group.records:
        identity = {key: value for key, value in record["identity"].items()
                    if key not in ("repeat", "seed")}
        if "scene" in identity and isinstance(record["result"], dict):
            found.setdefault(repr(sorted(identity.items(), key=str)),
                             Point(identity, [])).records.append(record)
    return sorted(found.values(), key=lambda p: (p.scene, p.label, -(p.h or 0)))


def by(some, key):
    """{key: [point]}, in the order in which the keys come."""
    found = {}
    for one in some:
        found.setdefault(key(one), []).append(one)
    return found
