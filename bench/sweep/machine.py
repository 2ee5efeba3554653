# SPDX-License-Identifier: MIT
"""Which machine this is: results of two machines are never put together."""
import os
import platform
import re
import socket

NAME_VARIABLE = "DSC_SWEEP_MACHINE"


def model():
    """That of the processor."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as stream:
            for line in stream:
                if line.startswith("model name"):
                    return line.partition(":")[2].strip()
    except OSError:
        pass
    return platform.machine() or "unknown CPU"


def cores():
    """Those that this process may use."""
    return len(os.sched_getaffinity(0))


def name():
    """The name of the folder of this machine's results: what DSC_SWEEP_MACHINE says, or the host's
    name, the processor and the number of its cores."""
    given = os.environ.get(NAME_VARIABLE)
    return slug(given or f"{socket.gethostname()} {model()} {os.cpu_count()} cores")


def slug(text):
    return re.sub(r"[^A-Za-z0-9]+", "-", text).strip("-").lower()[:80] or "unknown"


def facts():
    return {"name": name(), "host": socket.gethostname(), "model": model(), "cores": os.cpu_count(),
            "kernel": platform.release()}


class Busy:
    """How many cores other programs keep busy while something runs."""

    def __init__(self):
        self.first = _ticks()

    def others(self, wall_s, own_cpu_s):
        """A number of cores; None where the system does not tell."""
        last = _ticks()
        if self.first is None or last is None or wall_s <= 0:
            return None
        busy = (last - self.first) / os.sysconf("SC_CLK_TCK")
        return round(max(0.0, (busy - own_cpu_s) / wall_s), 2)


def _ticks():
    """Those of all cores so far in which they were not idle."""
    try:
        with open("/proc/stat", encoding="utf-8") as stream:
            values = [int(word) for word in stream.readline().split()[1:9]]
    except (OSError, ValueError):
        return None
    return sum(values) - values[3] - values[4]
