# SPDX-License-Identifier: MIT
"""One run: its process, what it leaves, and its last words."""
import contextlib
import json
import os
import pathlib
import select
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import locks
import machine
import placeholders
import runs
import store as stores
from errors import Interrupted

FORMAT = 1               # of the files of results
LAST_LINES = 20
LAST_BYTES = 6000
LARGEST_TEXT = 1 << 20   # of a kept file that is not JSON
LOOK_S = 0.25            # how often a run looks whether the sweep has been stopped


class NotKept(Exception):
    """A run ended well and left something that is no result; its text says what."""


def run_once(run, store, stopped, again=False):
    """Runs it, unless it has a result, and gives 'done', 'failed' or 'skipped'. With `again` a run
    that has failed is run again. Raises Interrupted when `stopped` says so; nothing is left
    then."""
    if _is_settled(run, store, again):
        return "skipped"
    path = store.lock(run)
    with locks.hold(path, stopped=stopped) as claim, \
            _machine_lock(run, stopped, claim) as place:
        if claim is None or place is None:
            raise Interrupted
        # Another sweep may have run it in the meantime.
        outcome = "skipped" if _is_settled(run, store, again) else \
            _run_here(run, store, stopped, (claim, place))
        path.unlink(missing_ok=True)
    return outcome


def _is_settled(run, store, again):
    return store.is_done(run) or (not again and store.has_failed(run))


def _machine_lock(run, stopped, claim):
    if claim is None:
        return contextlib.nullcontext(None)
    return locks.hold(locks.machine_path(), is_shared=not run.timed, stopped=stopped)


def _run_here(run, store, stopped, held):
    folder = store.scratch(run)
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "out").mkdir(parents=True)
    try:
        store.note(run, "begins", what=run.what)
        record = _record(run, folder, stopped, held)
        failed = record["problem"] is not None
        store.save(run, record, failed)
        store.note(run, "failed" if failed else "done", exit_code=record["exit_code"])
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return "failed" if failed else "done"


def _record(run, folder, stopped, held):
    paths = _paths(run, folder / "out")
    command = [placeholders.fill(word, paths) for word in run.command]
    environment = {key: placeholders.fill(text, paths) for key, text in run.environment.items()}
    begun, busy = stores.now(), machine.Busy()
    before = time.monotonic()
    code, cpu_s, problem = _call(run, command, environment, folder, stopped, held)
    wall_s = time.monotonic() - before
    result, files = None, {}
    try:
        files = _files(run, folder / "out", paths)
        result = files.pop(runs.RESULT, None)
        if problem is None:
            _check(run, result)
    except NotKept as error:
        problem = problem or str(error)
    return {
        "format": FORMAT, "key": run.key, "row": run.row, "table": run.table, "what": run.what,
        "identity": run.identity, "commit": run.commit, "machine": machine.facts(),
        "command": command, "environment": environment, "again": shown(run),
        "begun": begun, "ended": stores.now(), "wall_s": round(wall_s, 4), "cpu_s": round(cpu_s, 4),
        "others_busy": busy.others(wall_s, cpu_s), "exit_code": code, "problem": problem,
        "last_words": _last_words(folder), "result": result, "files": files}


def _paths(run, out):
    return {"source": run.source, "build": run.build, "out": str(out), "python": sys.executable}


def shown(run):
    """The command as one types it, from anywhere; what it writes goes to a folder that is kept."""
    out = os.path.join(tempfile.gettempdir(), "dsc-sweep", run.key)
    paths = _paths(run, out)
    words = shlex.join(placeholders.fill(word, paths) for word in run.command)
    settings = "".join(f"{key}={shlex.quote(placeholders.fill(text, paths))} "
                       for key, text in run.environment.items())
    first = f"mkdir -p {shlex.quote(out)} && " if out in words + settings else ""
    return f"{first}cd {shlex.quote(run.source)} && {settings}{words}"


def _call(run, command, environment, folder, stopped, held):
    """(exit code, CPU seconds, what went wrong or None)"""
    # If this process is killed, so is the run: a timed one would otherwise have it for company.
    guard = ["setpriv", "--pdeathsig", "KILL", "--"] if shutil.which("setpriv") else []
    with open(folder / "stdout", "wb") as out, open(folder / "stderr", "wb") as err:
        try:
            if shutil.which(command[0], path=_search_path(run)) is None:
                raise FileNotFoundError(2, "no such program", command[0])
            process = subprocess.Popen([*guard, *command], cwd=run.source, stdin=subprocess.DEVNULL,
                                       stdout=out, stderr=err, start_new_session=True,
                                       pass_fds=held, env={**os.environ, **environment})
        except OSError as error:
            return None, 0.0, f"cannot be run: {error.strerror}: {error.filename}"
        code, cpu_s, was_late = _wait(process, run.timeout_s, stopped)
    if was_late:
        return code, cpu_s, f"was stopped after {run.timeout_s:g} s"
    if code < 0:
        return code, cpu_s, f"ended by signal {signal.Signals(-code).name}"
    return code, cpu_s, None if code in run.accept else f"exit code {code}"


def _search_path(run):
    """A name with a slash is a path that begins at the sources."""
    return os.pathsep.join([os.environ.get("PATH", os.defpath), run.source])


def _wait(process, timeout_s, stopped):
    """(exit code, CPU seconds, whether the run took too long). Tells at once when the process
    ends."""
    end, was_late = time.monotonic() + timeout_s, False
    watch = os.pidfd_open(process.pid)
    try:
        poller = select.poll()
        poller.register(watch, select.POLLIN)
        while not poller.poll(1000 * LOOK_S):
            if stopped():
                _kill(process)
                raise Interrupted
            if not was_late and time.monotonic() > end:
                was_late = True
                _kill(process)
    finally:
        os.close(watch)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime, was_late


def _kill(process):
    """It and all that it has started."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)


def _files(run, out, paths):
    """{name: JSON or text} of what is kept."""
    kept = {path.relative_to(out).as_posix(): path for path in sorted(out.rglob("*.json"))}
    for name in run.files:
        path = pathlib.Path(run.source, placeholders.fill(name, paths))
        if not path.is_file():
            raise NotKept(f"left no file {path}")
        kept[path.name] = path
    found = {}
    for name, path in kept.items():
        text = path.read_text(encoding="utf-8", errors="replace")
        if not name.endswith(".json"):
            found[name] = text[-LARGEST_TEXT:]
            continue
        try:
            found[name] = json.loads(text)
        except json.JSONDecodeError as error:
            raise NotKept(f"left {name}, which is not whole JSON: {error}") from error
    return found


def _check(run, result):
    """A scene has a result, of the commit that was asked for."""
    if "scene" not in run.identity:
        return
    if not isinstance(result, dict):
        raise NotKept(f"left no result in {{out}}/{runs.RESULT}")
    if run.described and result.get("commit") != run.described:
        raise NotKept(f"the program was built from {result.get('commit')}, not {run.described}")


def _last_words(folder):
    found = {}
    for name in ("stdout", "stderr"):
        with open(folder / name, "rb") as stream:
            size = stream.seek(0, os.SEEK_END)
            stream.seek(max(0, size - LAST_BYTES))
            text = stream.read().decode(errors="replace")
        found[name] = text.splitlines()[-LAST_LINES:]
    return found
