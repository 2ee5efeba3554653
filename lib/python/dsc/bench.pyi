# SPDX-License-Identifier: MIT
from os import PathLike
from typing import Any

def read(*paths: str | PathLike[str]) -> Any: ...
