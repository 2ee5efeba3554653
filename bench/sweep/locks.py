# SPDX-License-Identifier: MIT
"""Locks that the kernel takes off when the last process that holds them has gone. A run inherits
the locks that it is made under, so that what a killed sweep has left running still holds them."""
import contextlib
import fcntl
import os
import tempfile
import time

MACHINE_VARIABLE = "DSC_SWEEP_LOCK"


@contextlib.contextmanager
def hold(path, is_shared=False, stopped=lambda: False):
    """Waits for the lock and gives its file descriptor; None if `stopped` while waiting."""
    stream = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o666)
    try:
        kind = fcntl.LOCK_SH if is_shared else fcntl.LOCK_EX
        while True:
            try:
                fcntl.flock(stream, kind | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                if stopped():
                    yield None
                    return
                time.sleep(0.02)
        yield stream
    finally:
        os.close(stream)


def machine_path():
    """The lock of this user on this machine: many untimed runs hold it together, a timed one
    alone."""
    return os.environ.get(MACHINE_VARIABLE) or os.path.join(
        tempfile.gettempdir(), f"dsc-sweep-{os.getuid()}.lock")
