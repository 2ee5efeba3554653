# SPDX-License-Identifier: MIT
"""Docstrings have examples that run, and stubs say what the compiled part takes."""
import ast
import doctest
import inspect
import pathlib
import re
import runpy
import tempfile
import unittest

import dsc
import numpy as np
from meshes import H, disc_mesh

STUBS = pathlib.Path(dsc.__file__).parent


def public():
    """(name, object) for all that a user finds."""
    for name in dsc.__all__:
        yield name, getattr(dsc, name)
        if inspect.isclass(getattr(dsc, name)) or inspect.ismodule(getattr(dsc, name)):
            for member, value in vars(getattr(dsc, name)).items():
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    yield f"{name}.{member}", value


def stubbed(file):
    """The names of the functions of a stub, with the names and defaults of what they take."""
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
                found[prefix + node.name] = (positional + named, defaults)

    read(ast.parse((STUBS / file).read_text(encoding="utf-8")).body, "")
    return found


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
                         "sim": dsc.Simulation(mesh, edge_length=H)}
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


class Options(unittest.TestCase):
    def test_are_explained_and_stubbed_with_their_defaults(self):
        sim = dsc.Simulation(disc_mesh(), edge_length=H)
        names, defaults = stubbed("_dsc.pyi")["Simulation.__init__"]
        self.assertEqual(names, ["mesh", "flow", *sim.options])
        for name, value in sim.options.items():
            self.assertIn(f"\n{name} : default ", dsc.Simulation.__doc__)
            if name != "edge_length":
                default = ast.literal_eval(defaults[name])
                self.assertEqual(list(default) if name == "carried_phases" else default, value, name)
        names, _ = stubbed("_dsc.pyi")["initial_complex"]
        for name in names[3:]:
            self.assertIn(f"\n{name} : default ", dsc.initial_complex.__doc__)
            self.assertIn(name, sim.options)


class Stubs(unittest.TestCase):
    def test_name_what_there_is(self):
        stubs = stubbed("_dsc.pyi")
        for name, (arguments, _) in stubs.items():
            value = dsc
            for part in name.split("."):
                value = getattr(value, part)
            signature = re.search(r"^\w+\((.*)\) ->", value.__doc__ or "", re.MULTILINE)
            if signature and "**kwargs" not in signature[1]:
                taken = re.findall(r"(?:^|, )(\w+)(?=:)", signature[1].replace("self: ", ""))
                self.assertEqual([one for one in taken if one in arguments], arguments, name)
        compiled = {name for name, value in public()
                    if type(getattr(dsc, name.split(".")[0])).__module__ != "builtins"
                    and getattr(getattr(dsc, name.split(".")[0]), "__module__", "") == "dsc._dsc"}
        self.assertEqual({name for name in compiled if "." in name} - set(stubs), set())


if __name__ == "__main__":
    unittest.main()
