# SPDX-License-Identifier: MIT
"""Runs scenes with dsc_scene and keeps their output: result, counts of each step, frames."""
import csv
import math
import pathlib
import subprocess
from dataclasses import dataclass, field

from results import load

TIME_LIMIT = 120  # seconds that one run may take


@dataclass(frozen=True)
class Plan:
    """The settings of a run. Equal plans are run once."""

    scene: str
    settings: tuple = ()    # of (key, value), given by --set

    def words(self):
        return ["run", self.scene, *(word for key, value in self.settings
                                     for word in ("--set", f"{key}={value}"))]


@dataclass
class Run:
    """The output of a run."""

    scene: load.Scene
    counts: dict = field(default_factory=dict)  # {step: triangles after it}, for the requested steps
    frames: dict = field(default_factory=dict)  # {step: path}


class Program:
    """dsc_scene, whose results are kept in a folder."""

    def __init__(self, path, folder):
        self.path, self.folder, self._kept = str(path), pathlib.Path(folder), {}
        if "swirl" not in self._call(["list"]):
            raise load.InputFault(f"{self.path} lists no scenes: it is not dsc_scene.")

    def run(self, plan, steps=()):
        """The Run of a plan, with frames at the steps. Raises InputFault if the run fails."""
        key = plan, steps
        if key not in self._kept:
            self._kept[key] = self._run(plan, steps)
        return self._kept[key]

    def _run(self, plan, steps):
        place = self.folder / f"run-{len(self._kept):02d}"
        place.mkdir(parents=True, exist_ok=True)
        result, series = place / "result.json", place / "series.csv"
        words = [*plan.words(), "--json", str(result)]
        if steps:
            words += ["--series", str(series), "--frames", str(place / "frames"),
                      "--every", str(math.gcd(*steps) or 1)]
        self._call(words)
        run = Run(load.read_scene(str(result)))
        if steps:
            with open(series, encoding="utf-8", newline="") as file:
                run.counts = {int(row["step"]): int(row["triangles"]) for row in csv.DictReader(file)}
            run.frames = {int(path.stem.rsplit("_", 1)[1]): str(path)
                          for path in (place / "frames").glob("*.vtu")}
        return run

    def _call(self, words):
        try:
            done = subprocess.run([self.path, *words], capture_output=True, text=True, check=False,
                                  timeout=TIME_LIMIT)
        except OSError as fault:
            raise load.InputFault(f"{self.path} cannot be run: {fault.strerror}.") from fault
        except subprocess.TimeoutExpired as fault:
            raise load.InputFault(f"dsc_scene {' '.join(words[:2])} was stopped after "
                                  f"{TIME_LIMIT} s.") from fault
        if done.returncode != 0:
            said = (done.stderr.strip().splitlines() or ["no message"])[0]
            raise load.InputFault(
                f"dsc_scene {' '.join(words[:2])} ended with {done.returncode}: {said}")
        return done.stdout
