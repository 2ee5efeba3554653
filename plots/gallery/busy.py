# SPDX-License-Identifier: MIT
"""How busy the machine is: times of threads mean nothing where others use the cores."""
import pathlib
import time

BUSY = 0.2  # of all cores: from here on times of threads are not taken


def _counters():
    """(idle, all) of all cores since the machine was started, in the kernel's ticks."""
    words = pathlib.Path("/proc/stat").read_text(encoding="ascii").split("\n")[0].split()[1:]
    ticks = [int(word) for word in words]
    return ticks[3] + ticks[4], sum(ticks[:8])


def share(seconds=0.5):
    """The share of all cores that was used over this time, 0 to 1; None where it is not known."""
    try:
        before = _counters()
        time.sleep(seconds)
        after = _counters()
    except (OSError, ValueError, IndexError):
        return None
    idle, total = after[0] - before[0], after[1] - before[1]
    return 1 - idle / total if total > 0 else None
