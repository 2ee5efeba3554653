# SPDX-License-Identifier: MIT
from os import PathLike
from typing import Any

def program() -> str: ...
def names() -> list[str]: ...
def run(
    scene: str | PathLike[str],
    *,
    strategy: str | None = None,
    submeshes: int | None = None,
    threads: int | None = None,
    frames: str | PathLike[str] | None = None,
    events: str | PathLike[str] | None = None,
    series: str | PathLike[str] | None = None,
    checkpoint: str | PathLike[str] | None = None,
    **settings: object,
) -> dict[str, Any]: ...
