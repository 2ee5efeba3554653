# SPDX-License-Identifier: MIT
"""Runs scenes of the catalogue, or from files, by `dsc_scene`; results are dictionaries.
The program is searched for in the build tree or the prefix of the package, and on PATH; the
environment variable DSC_SCENE can name another one.
"""
import json
import os
import pathlib


def program():
    """The path of `dsc_scene`. Raises FileNotFoundError."""
    import shutil

    here = pathlib.Path(__file__).resolve()
    places = [here.parents[2] / "scenes" / "dsc_scene",
              *(parent / "bin" / "dsc_scene" for parent in here.parents)]
    found = os.environ.get("DSC_SCENE") or next(
        (str(place) for place in places if place.exists()), shutil.which("dsc_scene"))
    if found is None:
        raise FileNotFoundError("dsc_scene: found neither beside the package nor on PATH; name it in the "
                                "environment variable DSC_SCENE")
    return found


def _call(arguments):
    import subprocess  # here, because it would take a third of the import time of the package

    done = subprocess.run([program(), *arguments], capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        raise ValueError(done.stderr.strip() or f"dsc_scene ended with {done.returncode}")
    return done


def names():
    """The names of the catalogue.

    Returns
    -------
    list of str
    """
    lines = _call(["list"]).stdout.splitlines()
    return [line.split()[0] for line in lines if line.strip() and not line[0].isspace()]


def run(scene, *, strategy=None, submeshes=None, threads=None, frames=None, events=None, series=None,
        checkpoint=None, **settings):
    """Runs a scene.

    Parameters
    ----------
    scene : str or path
        A name, or a TOML file.
    strategy, submeshes, threads, frames, events, series, checkpoint
        The options of `dsc_scene run`.
    **settings
        `h=.005` means `--set h=.005`.

    Returns
    -------
    dict
        The result: `sd_rel_last`, `area_ratio`, `mesh_hash`, ...; `holds` says whether all
        invariants held.
    """
    import tempfile

    options = {"strategy": strategy, "submeshes": submeshes, "threads": threads, "frames": frames,
               "events": events, "series": series, "checkpoint": checkpoint}
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "result.json"
        arguments = ["run", str(scene), "--json", str(file)]
        for name, value in options.items():
            if value is not None:
                arguments += [f"--{name}", str(value)]
        for key, value in settings.items():
            arguments += ["--set", f"{key}={value}"]
        done = _call(arguments)
        return json.loads(file.read_text(encoding="utf-8")) | {"holds": done.returncode == 0}
