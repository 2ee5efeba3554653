# SPDX-License-Identifier: MIT
"""Result files of `dsc_bench`, in the format of Google Benchmark, as arrays."""
import json
import pathlib

import numpy as np


def read(*paths):
    """Reads the rows of result files.

    Parameters
    ----------
    *paths : str or path
        Files, or folders with such files.

    Returns
    -------
    pandas.DataFrame or dict of arrays
        A column for each name in any row; NaN or None if a row lacks it. A frame if
        pandas is installed. `file` is the file of a row.
    """
    files = [file for path in map(pathlib.Path, paths)
             for file in (sorted(path.glob("*.json")) if path.is_dir() else [path])]
    rows = [row | {"file": str(file)} for file in files
            for row in json.loads(file.read_text(encoding="utf-8")).get("benchmarks", [])]
    names = dict.fromkeys(name for row in rows for name in row)
    columns = {}
    for name in names:
        values = [row.get(name) for row in rows]
        is_number = all(value is None or isinstance(value, (int, float)) for value in values)
        columns[name] = np.array(values, float if is_number else object)
    try:
        import pandas
    except ImportError:
        return columns
    return pandas.DataFrame(columns)
