# SPDX-License-Identifier: MIT
"""dsc_scene under mpirun, for tests: as root, with more processes than cores, in a sandbox.

The environment names the programs: DSC_SCENE and DSC_MPIRUN.
"""
from __future__ import annotations

import json
import os
import signal
import subprocess
import tempfile
import unittest
from typing import Any

SCENE = os.environ["DSC_SCENE"]
MPIRUN = os.environ["DSC_MPIRUN"]
PROMPTLY = 600  # seconds, on cores that others use as well
SHORT = ["--set", "h=0.05", "--set", "steps=4"]

# Open MPI reads its options from here; other launchers do not look.
OPTIONS = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_hwloc_base_binding_policy": "none",
    "OMPI_MCA_mpi_yield_when_idle": "1",
    "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
    "OMP_WAIT_POLICY": "passive",
}


class Launched(unittest.TestCase):
    """Runs in a folder of its own."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name: str) -> str:
        return os.path.join(self.folder, name)

    def start(self, ranks: int | None, *arguments: str) -> subprocess.Popen[str]:
        """`ranks` None: without a launcher."""
        command = [SCENE, *arguments]
        if ranks is not None:
            command = [MPIRUN, "-n", str(ranks), *command]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True, cwd=self.folder, env={**os.environ, **OPTIONS})
        self.addCleanup(self.stop, process)
        return process

    @staticmethod
    def stop(process: subprocess.Popen[str]) -> None:
        if process.poll() is None:
            process.send_signal(signal.SIGKILL)
            process.communicate()
        for stream in (process.stdout, process.stderr):
            if stream is not None:
                stream.close()

    def call(self, ranks: int | None, *arguments: str) -> tuple[int, str, list[str]]:
        """The exit code, stdout, and what dsc_scene said on stderr: mpirun has words of its own."""
        process = self.start(ranks, *arguments)
        out, err = process.communicate(timeout=PROMPTLY)
        return (process.returncode, out,
                [line for line in err.splitlines() if line.startswith("dsc_scene: ")])

    def result(self, ranks: int | None, *arguments: str, code: int = 0) -> dict[str, Any]:
        done, out, words = self.call(ranks, "run", *arguments, "--json", "result.json")
        self.assertEqual(done, code, f"{ranks} ranks, {arguments}: {out}{words}")
        with open(self.path("result.json"), encoding="utf-8") as stream:
            read: dict[str, Any] = json.load(stream)
        os.remove(self.path("result.json"))
        return read

    def expect_same(self, one: dict[str, Any], other: dict[str, Any], what: str) -> None:
        """All but times, memory, and how many ran it."""
        differ = {"cpu_s", "wall_s", "run_s", "first_step_us", "step_us_median",
                  "us_per_vertex_step", "peak_memory_mb", "threads", "threads_used", "ranks",
                  "bytes_per_step", "exchanges_per_step", "rank_us_per_step"}
        for key in sorted((set(one) | set(other)) - differ):
            self.assertEqual(one.get(key), other.get(key), f"{what}: {key}")
