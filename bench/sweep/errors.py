# SPDX-License-Identifier: MIT
"""What goes wrong with a sweep as a whole; a run that fails is a result."""


class SweepError(Exception):
    """Nothing can be run, or no further; its text is a sentence for the user."""


class TableError(SweepError):
    """A table that cannot be used: what is wrong, where, the value, and what is allowed."""

    def __init__(self, what, where, value, allowed):
        super().__init__(f"{where}: {what}: got '{value}'; allowed: {allowed}")


class Interrupted(Exception):
    """A signal ended the sweep; what was running has left nothing."""
