# SPDX-License-Identifier: MIT
"""The jobs of a plan by Snakemake: on the cores of this machine, or wherever a profile says.

What was done is known by the results alone; Snakemake's own notes are thrown away before each
call."""
import os
import shutil
import signal
import subprocess
import sys

import plan as plans
from errors import Interrupted, SweepError

HERE = os.path.dirname(os.path.abspath(__file__))


def program():
    """Snakemake, or None where there is none."""
    return shutil.which("snakemake")


def find_profile(name):
    """The folder of a profile: one of the user's own by its path, one of ours by its name, or else
    what Snakemake finds by that name."""
    for folder in (name, os.path.join(HERE, "profiles", name)):
        if os.path.isfile(os.path.join(folder, "config.yaml")):
            return os.path.abspath(folder)
    return name


def call(chunks, store, jobs, again, profile, stopped):
    """Runs everything. Raises Interrupted when `stopped` says so, and SweepError where Snakemake
    itself cannot go on; a failed run is recorded and the others go on."""
    folder = store.folder / "snakemake"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    guard = "setpriv --pdeathsig TERM --" if shutil.which("setpriv") and not profile else ""
    plans.write(folder / "plan.json", chunks, folder=str(store.folder), again=again,
                machine=None if profile else store.machine, of_any_machine=store.of_any_machine,
                jobs=jobs, is_cluster=bool(profile), python=sys.executable, guard=guard,
                batch=os.path.join(HERE, "batch.py"))
    # Each result is guarded by a lock of its own, which is taken off when its holder is killed.
    words = [program(), "--snakefile", os.path.join(HERE, "Snakefile"), "--directory", str(folder),
             "--config", f"plan={folder / 'plan.json'}", "--nolock", "--keep-going",
             "--scheduler", "greedy", "--quiet", "rules", "progress"]
    words += ["--profile", find_profile(profile), "--jobs", str(jobs)] if profile else \
        ["--cores", str(jobs)]
    log = folder / "snakemake.log"
    with open(log, "wb") as stream:
        process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stderr=stream)
        code = _wait(process, bool(profile), stopped)
    if stopped():
        raise Interrupted
    return code, log.read_text(encoding="utf-8", errors="replace").splitlines()[-20:]


def _wait(process, is_cluster, stopped):
    asked = False
    while True:
        try:
            return process.wait(timeout=0.25)
        except subprocess.TimeoutExpired:
            if stopped() and not asked:
                asked = True
                # A cluster's jobs are Snakemake's to cancel. Jobs here are told to end when it is
                # gone.
                process.send_signal(signal.SIGINT if is_cluster else signal.SIGKILL)


def need_program():
    if program() is None:
        raise SweepError("--profile needs Snakemake (Debian: snakemake), which is not installed")
