# SPDX-License-Identifier: MIT
"""Instructions and allocations of a run, counted by callgrind (Debian: valgrind)."""
import os
import re
import shutil
import subprocess
import tempfile

ALLOCATORS = {"malloc", "calloc", "realloc", "aligned_alloc", "posix_memalign", "memalign"}


class NotCounted(Exception):
    """Counting failed; the message says why."""


class NotCalled(NotCounted):
    """The program has not called the functions to be counted."""


def is_installed():
    return shutil.which("valgrind") is not None


def parse(lines):
    """(instructions, allocations) of a callgrind file. Raises NotCounted if it is incomplete or not such a file.

    Names are written in full once, as `cfn=(7) malloc`, and later as `cfn=(7)`; `calls=3 ...` follows
    the name of the called function."""
    names = {}
    called = None
    allocations = 0
    total = None
    for line in lines:
        found = re.match(r"(c?fn)=\((\d+)\)(?: (.*))?", line)
        if found:
            kind, number, name = found.groups()
            if name is not None:
                names[number] = name.strip()
            if kind == "cfn":
                called = names.get(number, "")
        elif line.startswith("calls=") and called is not None:
            # Recursion is marked as malloc'2, versions of a symbol as malloc@@GLIBC_2.2.5.
            if re.split(r"['@]", called)[0] in ALLOCATORS:
                allocations += int(line[len("calls="):].split()[0])
            called = None
        elif line.startswith("totals:"):
            total = int(line.split()[1])
    if total is None:
        raise NotCounted("the counts of callgrind have no total: the file is incomplete")
    return total, allocations


def count(command, within=None):
    """(instructions, allocations) of the command, or only of the functions whose names match the
    pattern `within`, including the functions that they call. Raises NotCounted."""
    only = [f"--toggle-collect={within}"] if within else []
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "callgrind.out")
        done = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={path}", *only, *command],
            capture_output=True, text=True, check=False,
            env={**os.environ, "OMP_NUM_THREADS": "1"})
        if done.returncode != 0:
            last = (done.stderr.strip().splitlines() or ["nothing"])[-1]
            hint = (": valgrind does not know an instruction of this processor; build without --native"
                    if "SIGILL" in done.stderr else "")
            raise NotCounted(f"valgrind ended with {done.returncode} ({last}){hint}")
        with open(path, encoding="utf-8", errors="replace") as stream:
            counted = parse(stream)
    if within and counted[0] == 0:
        raise NotCalled(f"the program has called no function named {within}")
    return counted
