# SPDX-License-Identifier: MIT
"""Where results are: FOLDER/MACHINE/COMMIT/KEY.json for a run that has ended well, KEY.failed.json
for one that has not, and FOLDER/MACHINE/attempts.log, which only grows, with a line for each
beginning and end.

A result is written beside and renamed: of a sweep that is killed each result is there as a whole or
not at all."""
import json
import os
import pathlib
import time

DONE, FAILED = ".json", ".failed.json"


class Store:
    def __init__(self, folder, machine, of_any_machine=False):
        """`of_any_machine`: a run that has a result of another machine is not run again."""
        self.folder = pathlib.Path(folder).absolute()  # runs are made in other folders
        self.machine = machine
        self.of_any_machine = of_any_machine

    @property
    def mine(self):
        return self.folder / self.machine

    def path(self, run, suffix=DONE):
        return self.mine / run.commit / (run.key + suffix)

    def _has(self, run, suffix):
        if self.path(run, suffix).exists():
            return True
        return self.of_any_machine and any(self.folder.glob(f"*/{run.commit}/{run.key}{suffix}"))

    def is_done(self, run):
        return self._has(run, DONE)

    def has_failed(self, run):
        return not self.is_done(run) and self._has(run, FAILED)

    def failure(self, run):
        """The record of a run that has failed."""
        paths = [self.path(run, FAILED), *self.folder.glob(f"*/{run.commit}/{run.key}{FAILED}")]
        return read(next(path for path in paths if path.exists()))

    def lock(self, run):
        path = self.path(run, ".lock")
        path.parent.mkdir(parents=True, exist_ok=True)
        return path

    def scratch(self, run):
        """A folder for what a run writes while it runs; what a killed one has left is removed."""
        return self.mine / "running" / run.key

    def save(self, run, record, has_failed):
        write(self.path(run, FAILED if has_failed else DONE), record)
        if not has_failed:
            self.path(run, FAILED).unlink(missing_ok=True)

    def note(self, run, event, **more):
        """One line of the log; it is appended in one piece, whoever else appends."""
        line = json.dumps({"at": now(), "event": event, "key": run.key, "commit": run.commit,
                           "pid": os.getpid(), **more}) + "\n"
        self.mine.mkdir(parents=True, exist_ok=True)
        stream = os.open(self.mine / "attempts.log", os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o666)
        try:
            os.write(stream, line.encode())
        finally:
            os.close(stream)


def now():
    return time.strftime("%Y-%m-%dT%H:%M:%S%z")


def write(path, data):
    """The file exists as a whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    try:
        part.write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")
        part.replace(path)
    except OSError:
        part.unlink(missing_ok=True)
        raise


def read(path):
    return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))


def attempts(folder):
    """The lines of all logs below a folder, in their order; half a line at the end of a log, of a
    machine that lost power, is none."""
    found = []
    for path in sorted(pathlib.Path(folder).glob("*/attempts.log")):
        for line in path.read_text(encoding="utf-8").split("\n")[:-1]:
            try:
                found.append(json.loads(line))
            except json.JSONDecodeError:
                continue
    return found
