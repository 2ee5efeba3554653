# SPDX-License-Identifier: MIT
"""What may catch a fault: the test programs and the quick gate, in the order in which they are tried.

The tests of a fault's own room come first: what they catch is caught on purpose. Others that notice it
do so because everything changes, or by luck."""
import dataclasses
import os
import pathlib
import re
import sys

# The tests of a room; test programs have one name each in verify/CMakeLists.txt.
OWN = {
    "base": ["base"],
    "geometry": ["geometry"],
    "complex": ["complex", "operations", "fuzz"],
    "queries": ["complex"],
    "quality": ["quality"],
    "operations": ["operations", "reference"],
    "initial": ["initial"],
    "motion": ["motion", "algorithm", "velocities"],
    "sizes": ["sizes", "graded"],
    "passes": ["passes", "effort", "sizes"],
    "algorithm": ["algorithm", "effort"],
    "parallel": ["parallel"],
    "topology": ["topology", "wall_films"],
    "fluid": ["fluid", "fluid_figures"],
    "geometric_flows": ["geometric_flows", "velocities", "algorithm"],
    "thesis": ["thesis", "copies", "operations", "fuzz", "reference"],
    "io": ["io", "checkpoints"],
    "measures": ["measures"],
    "flows": ["flows"],
    "scenes": ["scenes", "scene_files", "scene_runs", "checkpoints", "scene_output_cli"],
    "reference": ["reference"],
    "gate": ["judge", "limits", "gate_cli"],
    "plots": ["plots"],
}
# Cheap ones first. The hashes notice nearly everything and say nothing about what is wrong, so they
# are asked last of all tests.
OTHERS = ["base", "quality", "motion", "passes", "complex", "operations", "thesis", "algorithm", "initial",
          "geometric_flows", "fluid", "fluid_figures",
          "sizes", "io", "measures", "geometry", "recipes", "scene_files", "scene_runs",
          "topology", "wall_films", "fuzz", "hard", "reference", "scenes", "parallel", "copies", "velocities",
          "checkpoints", "figures", "hashes", "gate"]
# Some suites of a test program, by a name of their own.
SUITES = {
    "graded": ("figures", "Sizes/GradedMesh.*"),
    "flows": ("figures", "Velocity.*:SineCosine.*:FlowMap.*:Exact.*:TwoDiscs.*:ErodedDumbbell.*"),
    "scene_runs": ("figures", "RunScene.*:SceneFileExact.*:Describe.*:Catalogue/Described.*"),
}
# What nobody has written to notice a fault in particular.
BROAD = {"hashes", "gate", "hard", "figures"}
QUICK_GATE = ["area_ratio", "symmetric_difference", "symmetric_difference_half", "inverted",
              "unreached", "min_quality"]
# The modules of a unittest, where they run, and the programs that they call.
PYTHON = {
    "limits": ("verify/gate", ["limits_test"], []),
    "gate_cli": ("verify/scenes", ["gate_cli_test"], ["dsc_scene", "dsc_verify", "dsc_hard"]),
    "scene_output_cli": ("verify/scenes", ["scene_output_cli_test"], ["dsc_scene"]),
    "plots": ("plots", ["tests.test_plots", "tests.test_parallel", "tests.test_precision",
                        "tests.test_page"], []),
}


@dataclasses.dataclass(frozen=True)
class Program:
    name: str
    command: tuple
    folder: pathlib.Path
    environment: tuple = ()


def program(name, source, build):
    """`source` and `build`: the copy of the project with the switches, and its build."""
    if name in PYTHON:
        folder, modules, _ = PYTHON[name]
        return Program(name, (sys.executable, "-m", "unittest", "--failfast", "--verbose", *modules),
                       source / folder,
                       (("DSC_SCENE", str(build / "lib/scenes/dsc_scene")),
                        ("DSC_VERIFY", str(build / "verify/dsc_verify")),
                        ("DSC_HARD", str(build / "verify/dsc_hard")),
                        ("MPLBACKEND", "Agg"), ("PYTHONDONTWRITEBYTECODE", "1")))
    if name == "gate":
        return Program(name, (str(build / "verify/dsc_verify"), "run", *QUICK_GATE, "--out",
                              f"gate.{os.getpid()}"), build)
    test, suites = SUITES.get(name, (name, "*"))
    return Program(name, (str(build / f"verify/test_{test}"), "--gtest_fail_fast",
                          f"--gtest_filter={suites}"), build)


def own(fault):
    """The tests that are there for a fault, by name: those of its room, and others that it names."""
    return [*OWN[fault.room], *fault.also]


def others(fault):
    """What is tried on a fault that they do not catch."""
    return [name for name in OTHERS if name not in own(fault)]


def for_fault(fault, is_own):
    """The names of its own tests, or of the others, which are tried after them."""
    return own(fault) if is_own else others(fault)


def all_names():
    names = []
    for name in [name for own in OWN.values() for name in own] + OTHERS:
        if name not in names:
            names.append(name)
    return names


def targets(names=None):
    """What has to be built for these tests, or for all of them."""
    found = []
    for name in all_names() if names is None else names:
        if name in PYTHON:
            found += PYTHON[name][2]
        elif name == "gate":
            found.append("dsc_verify")
        else:
            found.append(f"test_{SUITES.get(name, (name,))[0]}")
    return list(dict.fromkeys(found))


def test_targets(root):
    """All test programs, but for the one whose cases take minutes each."""
    text = (root / "verify/CMakeLists.txt").read_text(encoding="utf-8")
    return [name for name in re.findall(r"^dsc_add_tests\((\w+)", text, re.M)
            if name != "test_hard_long"]
