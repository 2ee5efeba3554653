# SPDX-License-Identifier: MIT
"""A project of its own in a temporary folder, with a copy of the room, in which sweeps are run."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOM = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOM))

import store as stores  # noqa: E402


class Project:
    """Without a repository, all runs are those of the commit `unknown`."""

    def __init__(self, test, machine="here"):
        folder = tempfile.TemporaryDirectory()
        test.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        shutil.copytree(ROOM, self.root / "bench/sweep",
                        ignore=shutil.ignore_patterns("tests", "__pycache__"))
        self.out = self.root / "out"
        self.environment = {**os.environ, "DSC_SWEEP_MACHINE": machine,
                            "DSC_SWEEP_LOCK": str(self.root / "machine.lock"),
                            "GIT_CEILING_DIRECTORIES": str(self.root.parent)}

    def table(self, text, name="table.toml"):
        (self.root / name).write_text(text, encoding="utf-8")

    def words(self, *options, table="table.toml"):
        return [sys.executable, str(self.root / "bench/sweep/sweep.py"), str(self.root / table),
                "--out", str(self.out), "--no-build", *options]

    def sweep(self, *options, table="table.toml"):
        return subprocess.run(self.words(*options, table=table), capture_output=True, text=True,
                              check=False, env=self.environment, cwd=self.root)

    def results(self, suffix=".json"):
        """{path below the folder of results: content}; whole JSON, all of them."""
        paths = [path for path in sorted(self.out.glob("*/*/*.json"))
                 if path.name.endswith(suffix) and
                 (suffix != ".json" or not path.name.endswith(".failed.json"))]
        return {path.relative_to(self.out).as_posix(): json.loads(path.read_text("utf-8"))
                for path in paths}

    def attempts(self):
        return stores.attempts(self.out)

    def begun(self):
        """{key: how often it was begun}"""
        found = {}
        for line in self.attempts():
            if line["event"] == "begins":
                found[line["key"]] = found.get(line["key"], 0) + 1
        return found
