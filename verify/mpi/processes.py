# SPDX-License-Identifier: MIT
"""Processes as /proc shows them: who has been started by whom, and who still runs."""
from __future__ import annotations

import os


def _fields(process: int) -> list[str]:
    """What /proc says after the name of a process; empty if there is none."""
    try:
        with open(f"/proc/{process}/stat", encoding="utf-8") as stream:
            return stream.read().rsplit(")", 1)[1].split()
    except OSError:
        return []


def children(parent: int) -> list[int]:
    """The processes that this one has started, in the order of their numbers."""
    everyone = (int(entry) for entry in os.listdir("/proc") if entry.isdigit())
    return sorted(one for one in everyone if _fields(one)[1:2] == [str(parent)])


def is_running(process: int) -> bool:
    """Not if it has ended and nobody has asked how."""
    return _fields(process)[:1] not in ([], ["Z"], ["X"])


def rank_of(process: int) -> int | None:
    """The number that the launcher has given to a process that it has started."""
    try:
        with open(f"/proc/{process}/environ", "rb") as stream:
            variables = stream.read().split(b"\0")
    except OSError:
        return None
    for variable in variables:
        name, _, value = variable.partition(b"=")
        if name in (b"OMPI_COMM_WORLD_RANK", b"PMI_RANK"):
            return int(value)
    return None
