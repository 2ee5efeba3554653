# SPDX-License-Identifier: MIT
"""Docstrings have examples that run, and stubs agree with the parameters of functions."""
import ast
import doctest
import inspect
import os
import pathlib
import re
import runpy
import shutil
import subprocess
import tempfile
import unittest

import dsc
import numpy as np
from meshes import H, ball_mesh, disc_mesh

# A program of a user, with one error.
TYPED = """import dsc
mesh = dsc.initial_complex(((0, 0), (1, 1)), {1: [(0.3, 0.3), (0.7, 0.3), (0.5, 0.7)]}, edge_length=0.1)
sim = dsc.Simulation(mesh, edge_length=0.1, integrator="rk4")
report: dsc.Report = sim.step(dsc.curvature_flow(), 0, 1e-3)
solid = dsc.initial_complex(((0, 0, 0), (1, 1, 1)), {1: dsc.ball((0.5, 0.5, 0.5), 0.2)}, edge_length=0.1)
reports = dsc.run(dsc.Simulation(solid, edge_length=0.1), lambda x, t: 0 * x, 0.1, 2)
splits: int = reports[0].operations["splits"] + len(solid.tetrahedra)
merged = [event.kind for one in dsc.run(sim, dsc.swirl(), 0.1, 2) for event in one.events]
fluid = dsc.Fluid(sim, {0: (1, 1), 1: None}, {(0, 1): 1.0}, slip={"left", "right"})
fluid.simulation.mesh.vertex_data["heat"] = [0.0] * len(mesh.points)
area: float = dsc.scenes.run("swirl", h=0.1)["area_ratio"]
rows = dsc.bench.read("folder")
dsc.Simulation(mesh, edge_length=0.1, topology="changes")
"""

STUBS = pathlib.Path(dsc.__file__).with_name("__init__.pyi")


def members(value):
    """Names and values of the members of a class or module of the package, including those of base
    classes."""
    found = {}
    for base in reversed(inspect.getmro(value) if inspect.isclass(value) else [value]):
        if not inspect.isclass(base) or base.__module__.startswith("dsc"):
            found |= vars(base)
    return found


def public():
    """(name, object) for everything public."""
    for name in dsc.__all__:
        thing = getattr(dsc, name)
        yield name, thing
        if inspect.isclass(thing) or inspect.ismodule(thing):
            for member, value in members(thing).items():
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    yield f"{name}.{member}", value


def stubbed():
    """The functions of the stub, with the names and defaults of the parameters of each overload."""
    found = {}

    def read(body, prefix):
        for node in body:
            if isinstance(node, ast.ClassDef):
                read(node.body, f"{prefix}{node.name}.")
            elif isinstance(node, ast.FunctionDef):
                positional = [one.arg for one in node.args.args if one.arg != "self"]
                named = [one.arg for one in node.args.kwonlyargs]
                defaults = dict(zip(reversed(positional), reversed(node.args.defaults)))
                defaults |= dict(zip(named, node.args.kw_defaults))
                found.setdefault(prefix + node.name, []).append((positional + named, defaults))

    read(ast.parse(STUBS.read_text(encoding="utf-8")).body, "")
    return found


def fields(name):
    """The names of a record's fields in the stub."""
    [record] = [node for node in ast.parse(STUBS.read_text(encoding="utf-8")).body
                if isinstance(node, ast.ClassDef) and node.name == name]
    return [node.target.id for node in record.body if isinstance(node, ast.AnnAssign)]


class Docstrings(unittest.TestCase):
    def test_everything_public_has_one(self):
        for name, value in public():
            self.assertTrue((value.__doc__ or "").strip(), name)

    def test_examples_run(self):
        ran = 0
        with tempfile.TemporaryDirectory() as folder:
            for name, value in [("dsc", dsc), *public()]:
                mesh = disc_mesh()
                known = {"dsc": dsc, "np": np, "mesh": mesh, "folder": pathlib.Path(folder),
                         "sim": dsc.Simulation(mesh, edge_length=H), "mesh3": ball_mesh()}
                test = doctest.DocTestParser().get_doctest(inspect.getdoc(value) or "", known, name, None, 0)
                result = doctest.DocTestRunner().run(test)
                self.assertEqual(result.failed, 0, name)
                ran += result.attempted
        self.assertGreaterEqual(ran, 15)

    def test_the_program_of_the_page_runs(self):
        import matplotlib
        matplotlib.use("Agg")
        ran = runpy.run_path(str(pathlib.Path(__file__).parent / "readme.py"))
        self.assertAlmostEqual(ran["mesh"].areas[1], 0.0707, places=4)

    def test_the_flow_past_a_cylinder_has_its_drag(self):
        ran = runpy.run_path(str(pathlib.Path(__file__).parent / "cylinder.py"))
        self.assertAlmostEqual(ran["drag"], 5.58, delta=0.15)


class Options(unittest.TestCase):
    def test_are_explained_and_stubbed_with_their_defaults(self):
        signatures = stubbed()
        for k, mesh in enumerate((disc_mesh(), ball_mesh())):
            sim = dsc.Simulation(mesh, edge_length=0.1)
            names, defaults = signatures["Simulation.__init__"][k]
            self.assertEqual(names, ["mesh", "flow", *sim.options])
            explained = dsc.Simulation.__doc__.split("Other Parameters")[k]
            for name, value in sim.options.items():
                self.assertRegex(explained, rf"\n{name} : [^\n]+, default [^\n]+\n    \w")
                if name != "edge_length":
                    self.assertIn(f", default {value!r}\n", explained)
                    default = ast.literal_eval(defaults[name])
                    self.assertEqual(list(default) if name == "advected_phases" else default, value, name)
            names, _ = signatures["initial_complex"][-1 - k]  # the overload for the plane is the last
            explained = dsc.initial_complex.__doc__.split("Other Parameters")[k]
            for name in names[4:]:
                self.assertRegex(explained, rf"\n{name} : [^\n]+, default [^\n]+\n    \w")
                others = [["detail", "border_tolerance", "coverage"], ["growth", "improve_rounds", "max_tets"]][k]
                self.assertIn(name, [*others, *sim.options])


class Stubs(unittest.TestCase):
    def taken(self, name, function):
        """Names and defaults of a function's parameters, without `**options`, which `Options` tests."""
        if isinstance(function, property):
            return [], {}
        try:
            parameters = inspect.signature(function).parameters.values()
        except ValueError:  # compiled: its docstring begins with its signature
            signature = function.__doc__.partition("\n")[0]
            return re.findall(r"(?:^|, )(\w+)(?=:)", signature[signature.index("(") + 1:].replace("self: ", "")), {}
        named = [one for one in parameters if one.kind != one.VAR_KEYWORD]["." in name:]  # without self
        return ([one.name for one in named],
                {one.name: one.default for one in named if one.default is not one.empty})

    def test_name_what_there_is(self):
        found = dict(public())
        stubs = stubbed()
        for name, arguments, defaults in [(name, *one) for name, several in stubs.items() for one in several]:
            owner, _, member = name.partition(".")
            function = found[name] if name in found else getattr(getattr(dsc, owner), member)
            taken, values = self.taken(name, function)
            self.assertEqual(arguments[:len(taken)] if "edge_length" in arguments else arguments, taken, name)
            for one, value in values.items():
                if one not in defaults and len(stubs[name]) > 1:
                    continue  # what tells one overload from another has no default there
                default = ast.literal_eval(defaults[one])
                if default is not ...:
                    self.assertEqual(default, value, f"{name}: {one}")
        for name in ("Curve", "Event", "Faces", "Report", "Report3"):
            self.assertEqual(fields(name), list(getattr(dsc, name)._fields))
        for name, thing in found.items():
            first = getattr(dsc, name.split(".")[0])
            if inspect.isclass(thing) or inspect.ismodule(first) or first.__module__ == "dsc.records":
                continue  # classes are checked by member, records by field; modules have stubs of their own
            if not issubclass(first if inspect.isclass(first) else object, (Exception, dsc.Data)):
                self.assertIn(name, stubs)

    def test_choices_are_those_that_the_module_allows(self):
        text = STUBS.read_text(encoding="utf-8")
        choices = {name: set(re.findall(r'"(\w+)"', words))
                   for name, words in re.findall(r"^ +(\w+): Literal\[([^\]]+)\][^=\n]*=", text, re.M)}
        mesh = disc_mesh()
        for name, words in choices.items():
            with self.assertRaises(dsc.InputError) as refused:
                if name in ("detail", "coverage"):
                    dsc.initial_complex(((0, 0), (1, 1)), {}, edge_length=H, **{name: "none of them"})
                else:
                    dsc.Simulation(mesh, edge_length=H, **{name: "none of them"})
            allowed = str(refused.exception).partition("allowed: ")[2]
            self.assertEqual(set(re.findall(r"\w+", allowed)) - {"or", "None"}, words, name)
        self.assertEqual(len(choices), 8)

    @unittest.skipUnless(shutil.which("mypy"), "mypy is not installed")
    def test_a_program_is_checked_strictly(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "program.py"
            program.write_text(TYPED, encoding="utf-8")
            done = subprocess.run(["mypy", "--strict", f"--cache-dir={folder}/cache", program], check=False,
                                  capture_output=True, text=True,
                                  env={**os.environ, "MYPYPATH": str(STUBS.parents[1])})
        errors = [line for line in done.stdout.splitlines() if ": error:" in line]
        self.assertEqual(len(errors), 1, done.stdout)
        self.assertIn(f"program.py:{len(TYPED.splitlines())}: ", errors[0])  # the line with a wrong choice


if __name__ == "__main__":
    unittest.main()
