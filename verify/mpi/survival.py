#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs in several processes that come to a bad end, and what is left of them: each trial breaks a run
in one way, and goes on from its last checkpoint in one process and in another number of them. Lost is
a run that does not end, does not say why, has no checkpoint, or ends with another mesh than the run
that nobody broke.

    DSC_SCENE=build/release/lib/scenes/dsc_scene DSC_MPIRUN=mpirun verify/mpi/survival.py --seed 1

Prints a table, and exits with 1 if any is lost. The trials follow from the seed, but for the moments
at which the system lets processes run."""
from __future__ import annotations

import argparse
import collections
import contextlib
import dataclasses
import functools
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from typing import Any

import disks
import launcher
import processes

CELLS = ["--strategy", "cells", "--submeshes", "8"]
SCENES = (
    ("swirl", ["h=0.02", "steps=60"]),
    ("grains", ["h=0.02", "steps=100"]),
    ("drop-and-pool", ["h=0.02"]),
    ("single-vortex", ["h=0.03", "period=2"]),
)
PATIENCE_S = 600  # on cores that others use as well; what hangs is lost
GLANCE_S = 0.0002


class Lost(Exception):
    """Why."""


@dataclasses.dataclass
class Trial:
    """What is broken, and how it ended."""
    number: int
    kind: str
    scene: str
    ranks: int
    every: int
    detail: str = ""
    end_s: float = 0
    lost: str = ""


class Run:
    """One run under the launcher in a folder of its own."""

    def __init__(self, folder: str, trial: Trial, dice: random.Random,
                 disk: str | None = None) -> None:
        self.folder, self.trial, self.dice = folder, trial, dice
        self.checkpoint = os.path.join(disk or folder, "c")
        self.part = self.checkpoint + ".part"
        self.errors = ""

    def command(self, ranks: int | None, *arguments: str) -> list[str]:
        launch = [] if ranks is None else [launcher.MPIRUN, "-n", str(ranks)]
        return [*launch, launcher.SCENE, "run", *arguments]

    def start(self, *arguments: str) -> None:
        """Returns when there is a checkpoint."""
        self.process = subprocess.Popen(
            self.command(self.trial.ranks, *arguments, "--checkpoint", self.checkpoint, "--every",
                         str(self.trial.every)),
            cwd=self.folder, text=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
            env={**os.environ, **launcher.OPTIONS})
        self.watch(lambda: os.path.exists(self.checkpoint))
        found = {processes.rank_of(one): one for one in processes.children(self.process.pid)}
        self.ranks = {rank: one for rank, one in found.items() if rank is not None}

    def watch(self, is_so: Callable[[], bool]) -> bool:
        """Whether it has become so before the run has ended."""
        begin = time.monotonic()
        while not is_so():
            if self.process.poll() is not None:
                return is_so()
            if time.monotonic() - begin > PATIENCE_S:
                raise Lost("nothing happened")
            time.sleep(GLANCE_S)
        return True

    def written(self) -> int:
        """A number that changes with each checkpoint."""
        return os.stat(self.checkpoint).st_mtime_ns

    def wait_for_some(self) -> None:
        """A random number of checkpoints, and part of the time between two of them."""
        between = 0.0
        for _ in range(self.dice.randint(1, 5)):
            before, begin = self.written(), time.monotonic()
            self.watch(lambda: self.written() != before)  # noqa: B023: called at once
            between = time.monotonic() - begin
        time.sleep(min(between, 1.0) * self.dice.random())

    def end(self) -> None:
        """Until the launcher and all ranks have ended."""
        begin = time.monotonic()
        try:
            _, self.errors = self.process.communicate(timeout=PATIENCE_S)
        except subprocess.TimeoutExpired as error:
            self.process.kill()
            raise Lost("the run did not end") from error
        while any(processes.is_running(one) for one in self.ranks.values()):
            if time.monotonic() - begin > PATIENCE_S:
                raise Lost("a rank did not end")
            time.sleep(0.01)
        self.trial.end_s = time.monotonic() - begin

    def words(self) -> list[str]:
        """What dsc_scene itself has said."""
        return [line for line in self.errors.splitlines() if line.startswith("dsc_scene: ")]

    def expect_one_sentence(self, code: int, word: str, returned: int) -> None:
        if returned != code or len(self.words()) != 1 or word not in self.words()[0]:
            raise Lost(f"exit code {returned} and {self.words()}, wanted {code} and one sentence "
                       f"with '{word}'")

    def call(self, ranks: int | None, *arguments: str) -> int:
        done = subprocess.run(self.command(ranks, *arguments), cwd=self.folder, text=True,
                              capture_output=True, check=False, timeout=PATIENCE_S,
                              env={**os.environ, **launcher.OPTIONS})
        self.errors = done.stderr
        return done.returncode

    def go_on(self, checkpoint: str) -> None:
        """To the mesh of the run that nobody broke: in one process, and in another number."""
        other = self.dice.choice([n for n in (1, 2, 3, 4) if n != self.trial.ranks])
        for ranks in (None, other):
            copy = os.path.join(self.folder, "copy")
            shutil.copy(checkpoint, copy)
            if os.path.exists(self.part):
                shutil.copy(self.part, copy + ".part")
            code = self.call(ranks, "--resume", copy, "--checkpoint", copy, "--every", "7",
                             "--json", "r.json")
            if code != 0:
                raise Lost(f"going on in {ranks or 'no'} ranks ended with {code}: {self.errors}")
            with open(os.path.join(self.folder, "r.json"), encoding="utf-8") as stream:
                result = json.load(stream)
            if outcome(result) != unbroken(self.trial.scene):
                raise Lost(f"going on in {ranks or 'no'} ranks ended with {outcome(result)}, "
                           f"and not with {unbroken(self.trial.scene)}")
            if os.path.exists(copy + ".part"):
                raise Lost("a part of a file is left behind")


def outcome(result: dict[str, Any]) -> tuple[int, str]:
    return result["steps"], result["mesh_hash"]


def settings(scene: str) -> list[str]:
    return [word for key in dict(SCENES)[scene] for word in ("--set", key)]


@functools.cache
def unbroken(scene: str) -> tuple[int, str]:
    """The end of the scene in one process."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([launcher.SCENE, "run", scene, *settings(scene), *CELLS, "--json", "r.json"],
                       cwd=folder, stdout=subprocess.DEVNULL, check=True, timeout=PATIENCE_S)
        with open(os.path.join(folder, "r.json"), encoding="utf-8") as stream:
            return outcome(json.load(stream))


def scene_of(run: Run) -> list[str]:
    return [run.trial.scene, *settings(run.trial.scene), *CELLS]


def rank_killed(run: Run) -> None:
    """One rank is killed at a random time."""
    run.start(*scene_of(run))
    run.wait_for_some()
    victim = run.dice.randrange(run.trial.ranks)
    run.trial.detail = f"rank {victim}"
    kill(run, run.ranks.get(victim))


def killed_while_writing(run: Run) -> None:
    """The first rank is killed while it writes a checkpoint."""
    run.start(*scene_of(run))
    for _ in range(run.dice.randint(0, 3)):
        before = run.written()
        run.watch(lambda: run.written() != before)  # noqa: B023: called at once
    run.watch(lambda: os.path.exists(run.part))
    kill(run, run.ranks.get(0))
    with contextlib.suppress(FileNotFoundError):
        run.trial.detail = f"after {os.path.getsize(run.part)} bytes"


def launcher_killed(run: Run) -> None:
    """The launcher is killed, and the ranks have to notice."""
    run.start(*scene_of(run))
    run.wait_for_some()
    kill(run, run.process.pid)


def kill(run: Run, process: int | None) -> None:
    held = run.written()
    if process is not None and run.process.poll() is None:
        os.kill(process, signal.SIGKILL)
    run.end()
    if run.process.returncode == 0:
        run.trial.detail += ", too late"
    elif len(run.words()) > 1:
        raise Lost(f"said {run.words()}")
    if run.written() < held:
        raise Lost("an older checkpoint stands in the place of the last one")


def damaged(run: Run, spoil: Callable[[bytearray, random.Random], str]) -> None:
    """The last checkpoint is damaged: it is refused, and the one before it leads on."""
    steps, _ = unbroken(run.trial.scene)
    first, second = sorted(run.dice.sample(range(1, steps), 2))
    before = os.path.join(run.folder, "before")
    run.call(run.trial.ranks, *scene_of(run), "--checkpoint", before, "--stop-after", str(first))
    run.call(run.trial.ranks, "--resume", before, "--checkpoint", run.checkpoint, "--stop-after",
             str(second))
    content = bytearray(pathlib.Path(run.checkpoint).read_bytes())
    run.trial.detail = spoil(content, run.dice)
    pathlib.Path(run.checkpoint).write_bytes(content)
    names = sorted(os.listdir(run.folder))
    for ranks in (run.trial.ranks, None):
        begin = time.monotonic()
        code = run.call(ranks, "--resume", run.checkpoint, "--checkpoint", run.checkpoint, "--json",
                        "r.json")
        run.trial.end_s = max(run.trial.end_s, time.monotonic() - begin)
        run.expect_one_sentence(1, run.checkpoint, code)
    if pathlib.Path(run.checkpoint).read_bytes() != content or \
            sorted(os.listdir(run.folder)) != names:
        raise Lost("a run that was refused has changed files")
    os.replace(before, run.checkpoint)


def cut_off(content: bytearray, dice: random.Random) -> str:
    size = dice.randrange(len(content))
    del content[size:]
    return f"at byte {size}"


def flipped(content: bytearray, dice: random.Random) -> str:
    place = dice.randrange(len(content))
    content[place] ^= dice.randint(1, 255)
    return f"byte {place}"


def disk_full(run: Run, kind: str) -> None:
    """From a random time on there is no room for another checkpoint."""
    run.start(*scene_of(run))
    run.wait_for_some()
    size = os.path.getsize(run.checkpoint)
    room = run.dice.randrange(size * 9 // 10)
    run.trial.detail = f"{kind}, {room} bytes of {size}"
    if kind == "full disk":
        disks.fill(os.path.dirname(run.checkpoint), room)
    elif kind == "full device":
        run.trial.detail = kind
        disks.lead_to_full(run.part)
    elif run.process.poll() is None:
        disks.limit_files(run.ranks[0], room)
    run.end()
    if run.process.returncode == 0:
        run.trial.detail += ", too late"
    else:
        run.expect_one_sentence(1, run.checkpoint, run.process.returncode)
    if os.path.lexists(run.part) and run.process.returncode != 0:
        raise Lost("a part of a file is left behind")


KINDS: dict[str, tuple[int, Callable[[Run], None]]] = {  # how many of 30, and what is done
    "rank killed": (9, rank_killed),
    "killed while writing": (6, killed_while_writing),
    "launcher killed": (2, launcher_killed),
    "checkpoint cut off": (3, lambda run: damaged(run, cut_off)),
    "byte changed": (3, lambda run: damaged(run, flipped)),
    "disk full": (3, lambda run: disk_full(run, "full disk")),
    "device full": (2, lambda run: disk_full(run, "full device")),
    "file too large": (2, lambda run: disk_full(run, "limit")),
}


def plan(count: int, seed: int) -> Iterator[tuple[Trial, random.Random]]:
    """The kinds take turns, so that any number of trials has about the same share of each."""
    total = sum(share for share, _ in KINDS.values())
    turns = sorted(((i + 0.5) / share, kind) for kind, (share, _) in KINDS.items()
                   for i in range(share))
    for number in range(count):
        dice = random.Random(f"{seed} {number}")
        scene = dice.choice(SCENES)[0]
        yield Trial(number, turns[number % total][1], scene, dice.randint(2, 4),
                    dice.randint(2, 6)), dice


def attempt(trial: Trial, dice: random.Random) -> None:
    """Fills in how it ended."""
    with contextlib.ExitStack() as stack:
        folder = stack.enter_context(tempfile.TemporaryDirectory())
        disk = stack.enter_context(disks.small_disk()) if trial.kind == "disk full" else None
        run = Run(folder, trial, dice, disk)
        try:
            if trial.kind == "disk full" and disk is None:  # none may be mounted
                disk_full(run, "full device")
            else:
                KINDS[trial.kind][1](run)
            run.go_on(run.checkpoint)
        except (Lost, OSError, subprocess.TimeoutExpired, TimeoutError) as error:
            trial.lost = str(error) or type(error).__name__
        finally:
            process = getattr(run, "process", None)
            if process is not None and process.poll() is None:
                process.kill()


def table(trials: list[Trial]) -> str:
    """Rows by kind."""
    lines = [f"{'kind':<22} tried  lost  longest end", f"{'-' * 22} -----  ----  -----------"]
    by_kind = collections.defaultdict(list)
    for trial in trials:
        by_kind[trial.kind].append(trial)
    for kind in (*KINDS, "all"):
        mine = trials if kind == "all" else by_kind[kind]
        if mine:
            lost = sum(bool(trial.lost) for trial in mine)
            lines.append(f"{kind:<22} {len(mine):>5}  {lost:>4}  "
                         f"{max(trial.end_s for trial in mine):>9.2f} s")
    return "\n".join(lines)


def run_trials(count: int, seed: int) -> list[Trial]:
    trials = []
    for trial, dice in plan(count, seed):
        attempt(trial, dice)
        trials.append(trial)
        print(f"{trial.number:>3} {trial.kind}, {trial.scene}, {trial.ranks} ranks, {trial.detail}:"
              f" {'LOST: ' + trial.lost if trial.lost else 'goes on'}", flush=True)
    return trials


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--trials", type=int, default=30, help="how many (default 30)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", type=pathlib.Path, help="file for the trials")
    arguments = parser.parse_args()
    trials = run_trials(arguments.trials, arguments.seed)
    print(table(trials))
    if arguments.json:
        arguments.json.write_text(json.dumps([dataclasses.asdict(one) for one in trials], indent=1)
                                  + "\n", encoding="utf-8")
    return 1 if any(trial.lost for trial in trials) else 0


if __name__ == "__main__":
    sys.exit(main())
