# SPDX-License-Identifier: MIT
"""Runs scenes with dsc_scene and keeps what they wrote: result, counts of each step, frames."""
import csv
import functools
import json
import math
import pathlib
import re
import subprocess
from dataclasses import dataclass, field

from gallery.shared import vtu

TIME_LIMIT = 120  # seconds that one run may take


class NotRun(Exception):
    """A run without a result; its text is one sentence."""


class Missing(NotRun):
    """A scene that the program does not have."""


@dataclass(frozen=True)
class Plan:
    """What is run. Equal plans are run once."""

    scene: str
    settings: tuple = ()    # of (key, value), given by --set
    strategy: str = ""      # "": the program's default
    submeshes: int = 0      # 0: the program's default
    threads: int = 0        # 0: the program's default
    again: int = 0          # tells repetitions apart, which are run for their times

    def __str__(self):
        """As one would type it."""
        return " ".join(self.words())

    def words(self):
        words = ["run", self.scene]
        for key, value in self.settings:
            words += ["--set", f"{key}={value}"]
        if self.strategy:
            words += ["--strategy", self.strategy]
        if self.submeshes:
            words += ["--submeshes", str(self.submeshes)]
        if self.threads:
            words += ["--threads", str(self.threads)]
        return words


@dataclass
class Run:
    """What a run wrote."""

    plan: Plan
    result: dict            # the JSON of dsc_scene
    counts: dict            # {step: number of triangles after it}, at the steps asked for
    frames: list = field(default_factory=list)  # [(step, path)] in order

    @property
    def last_step(self):
        return int(self.result["steps"])

    def nearest(self, step):
        """(step, path) of the frame that is nearest to a step."""
        if not self.frames:
            raise NotRun(f"{self.plan.scene} wrote no frame.")
        return min(self.frames, key=lambda frame: abs(frame[0] - step))

    @functools.lru_cache(maxsize=4)  # a still picture and an animation often share a frame
    def frame(self, path):
        try:
            return vtu.read(path)
        except vtu.BadFrame as fault:
            raise NotRun(str(fault)) from fault

    __hash__ = object.__hash__


class Program:
    """dsc_scene, which is asked once what it knows."""

    def __init__(self, path, folder):
        self.path, self.folder = str(path), pathlib.Path(folder)
        self._kept, self._count = {}, 0
        words = self._call(["list"]).split("\n")
        self.scenes = {line.split()[0] for line in words if line and not line[0].isspace()}
        if not self.scenes:
            raise NotRun(f"{self.path} lists no scenes: it is not dsc_scene.")
        self.takes_times = re.search(r"^\s+--at\b", self._call(["run", "--help"]), re.M) is not None

    def run(self, plan, steps=(), more=0):
        """The Run of a plan, with frames at the steps and at `more` equal times where the program
        takes times of frames, else at the program's own. Throws NotRun."""
        if plan.scene not in self.scenes:
            raise Missing(f"The scene {plan.scene} is missing: dsc_scene does not know it yet.")
        kept = self._kept.get(plan)
        if kept is None or (steps and not kept.frames):
            kept = self._kept[plan] = self._run(plan, steps, more)
        return kept

    def _run(self, plan, steps, more):
        self._count += 1
        place = self.folder / f"run-{self._count:02d}"
        place.mkdir(parents=True, exist_ok=True)
        words = plan.words() + ["--json", str(place / "result.json")]
        if not (steps or more):
            self._call(words)
            return Run(plan, _json(place / "result.json"), {})
        draws = ["--frames", str(place / "frames")]
        # A row of the series can take longer than its step, for the exact shape's sake.
        words += ["--series", str(place / "series.csv"),
                  "--every", str(max(1, math.gcd(*steps)))]
        self._call(words if self.takes_times else words + draws)
        with open(place / "series.csv", encoding="utf-8", newline="") as file:
            series = list(csv.DictReader(file))
        if self.takes_times:
            # The times of the steps are known only now, so the same run is done again.
            self._call(plan.words() + draws + ["--at", _times(series[-1], steps, more)])
        frames = sorted((int(path.stem.rsplit("_", 1)[1]), str(path))
                        for path in (place / "frames").glob("*.vtu"))
        counts = {int(row["step"]): int(row["triangles"]) for row in series}
        return Run(plan, _json(place / "result.json"), counts, frames)

    def _call(self, words):
        try:
            done = subprocess.run([self.path, *words], capture_output=True, text=True, check=False,
                                  timeout=TIME_LIMIT)
        except OSError as fault:
            raise NotRun(f"{self.path} cannot be run: {fault.strerror}.") from fault
        except subprocess.TimeoutExpired as fault:
            raise NotRun(f"dsc_scene {' '.join(words[:2])} was stopped after {TIME_LIMIT} s."
                         ) from fault
        if done.returncode != 0:
            said = (done.stderr.strip().splitlines() or ["no message"])[0]
            raise NotRun(f"dsc_scene {' '.join(words[:2])} ended with {done.returncode}: {said}")
        return done.stdout


def _json(path):
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as fault:
        raise NotRun(f"{path.name} of dsc_scene is not whole: {fault}.") from fault


def _times(end, steps, more):
    """Times of frames in the middle of the steps that end with one: rounding cannot miss them.
    end: the last row of the series."""
    last = int(end["step"])
    wanted = {min(step, last) for step in steps}
    wanted |= {round(k * last / (more - 1)) for k in range(more)} if more > 1 else set()
    return ",".join(repr(max(0.0, step - 0.5) * float(end["time"]) / last)
                    for step in sorted(wanted))
