# SPDX-License-Identifier: MIT
"""Ways in which the disk of a run becomes full while it runs."""
from __future__ import annotations

import contextlib
import os
import resource
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator

SMALL = 64 << 20  # bytes of the file system that can be filled in earnest
PATIENCE = 60_000  # tries


@contextlib.contextmanager
def small_disk() -> Iterator[str | None]:
    """A folder on a small file system of its own; None where none may be mounted."""
    with tempfile.TemporaryDirectory() as folder:
        mount = ["mount", "-t", "tmpfs", "-o", f"size={SMALL}", "tmpfs", folder]
        if os.geteuid() != 0 or subprocess.run(mount, capture_output=True, check=False).returncode != 0:
            yield None
            return
        try:
            yield folder
        finally:
            subprocess.run(["umount", "--lazy", folder], capture_output=True, check=False)


def fill(folder: str, room: int) -> None:
    """Leaves about so many bytes free."""
    left = shutil.disk_usage(folder).free - room
    with open(os.path.join(folder, "ballast"), "wb", buffering=0) as stream, \
            contextlib.suppress(OSError):  # the run has taken some of it meanwhile
        while left > 0:
            left -= stream.write(bytes(min(left, 1 << 20)))


def lead_to_full(path: str) -> None:
    """What is written to this file ends on a device that is always full."""
    for _ in range(PATIENCE):
        with contextlib.suppress(FileExistsError):
            os.symlink("/dev/full", path)
            return
        time.sleep(0.001)  # the run is writing this very file, and will rename it in a moment
    raise TimeoutError(f"{path} stays where it is")


def limit_files(process: int, size: int) -> None:
    """From now on no file of this process may grow beyond so many bytes."""
    resource.prlimit(process, resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))
