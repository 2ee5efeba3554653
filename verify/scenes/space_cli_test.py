# SPDX-License-Identifier: MIT
"""A user's scenes in three dimensions: run, interrupted, resumed, held to limits, and every kind of bad
file."""
import json
import os
import unittest

from command_line import SCENE, VERIFY, CommandLine

RING = """name = "ring"
[domain]
low = [-1, -1, -1]
size = [2, 2, 2]
[[shape]]
torus = { centre = [0.2, 0, 0], axis = [0, 1, 1], radius = 0.4, tube = 0.15 }
[[shape]]
box = { low = [-0.4, -0.4, -0.8], high = [-0.1, -0.1, -0.55] }
phase = 2
[flow]
u = "-s*y"
v = "s*x + 0*z"
w = "0.1*cos(pi*t/period)"
parameters = { s = 1 }
[options]
h = 0.12
dt = 0.1
period = 1
"""
EGG = """[domain]
size = [1, 1, 1]
[shape]
ellipsoid = { centre = [0.5, 0.6, 0.5], radii = [0.1, 0.2, 0.15] }
[flow]
u = "(z - 0.5)*cos(pi*t/period)"
v = "0"
w = "-(x - 0.5)*cos(pi*t/period)"
[options]
h = 0.07
steps = 10
period = 1
[exact]
back = true
[limits]
sd_rel_last = 0.08
sd_rel_half = 0.08
vertex_error_rms_h = 0.01
unreached = 0
min_dihedral_deg_ever.min = 5
"""
# A box with quadrilateral faces; the last face is its lid.
BOX = """v 2 2 3\nv 8 2 3\nv 8 8 3\nv 2 8 3\nv 2 2 7\nv 8 2 7\nv 8 8 7\nv 2 8 7
f 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 6 7 8\n"""


class OwnScenesInSpace(CommandLine):
    program = SCENE

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as stream:
            stream.write(text)
        return self.path(name)

    def verify(self, *arguments):
        self.program = VERIFY
        self.addCleanup(setattr, self, "program", SCENE)
        return self.call("run", *arguments)

    def result(self, *arguments):
        done = self.call("run", *arguments, "--json", self.path("r.json"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.path("r.json"), encoding="utf-8") as stream:
            return json.load(stream)

    def test_shapes_and_formulas(self):
        result = self.result(self.write("ring.toml", RING))
        self.assertEqual((result["scene"], result["steps"]), ("ring", 10))
        self.assertEqual((result["inverted"], result["unreached"], result["problem"]), (0, 0, None))
        self.assertAlmostEqual(result["volume_ratio"], 1, delta=5e-3)
        self.assertIsNone(result["sd_rel_last"])
        self.assertEqual(result["parameters"]["h"], 0.12)

    def test_a_run_that_was_broken_off_goes_on_to_the_same_bits(self):
        scene = self.write("ring.toml", RING)
        frames = self.path("one"), self.path("two")
        whole = self.result(scene, "--frames", frames[0], "--every", "3")
        checkpoint = self.path("c")
        done = self.call("run", scene, "--checkpoint", checkpoint, "--every", "3", "--stop-after", "4",
                         "--frames", frames[1])
        self.assertEqual(done.returncode, 1)
        self.assertIn("interrupted after step 4; continue with:", done.stderr)
        resumed = self.result("--resume", checkpoint, "--frames", frames[1], "--every", "3")
        for key in ("mesh_hash", "operations", "moves", "sub_steps", "volume_ratio", "tets_first",
                    "min_dihedral_deg_ever"):
            self.assertEqual(whole[key], resumed[key], key)
        self.assertEqual(sorted(os.listdir(frames[0])), sorted(os.listdir(frames[1])))
        with open(os.path.join(frames[0], "ring.pvd"), encoding="utf-8") as one:
            with open(os.path.join(frames[1], "ring.pvd"), encoding="utf-8") as two:
                self.assertEqual(one.read(), two.read())
        self.write("ring.toml", RING.replace("tube = 0.15", "tube = 0.16"))
        self.result("--resume", checkpoint)  # the checkpoint has the text of the scene
        with open(checkpoint, "r+b") as stream:
            stream.seek(4000)
            stream.write(b"\xff\xff")
        done = self.call("run", "--resume", checkpoint)
        self.assertEqual(done.returncode, 1)
        self.assertIn("damaged: the checksum does not match", done.stderr)

    def test_threads_change_no_bit(self):
        scene = self.write("ring.toml", RING)
        one = self.result(scene, "--threads", "1")
        checkpoint = self.path("c")
        self.assertEqual(self.call("run", scene, "--threads", "2", "--checkpoint", checkpoint,
                                   "--stop-after", "5").returncode, 1)
        three = self.result("--resume", checkpoint, "--threads", "3")
        for key in ("mesh_hash", "operations", "moves", "treated", "treated_together", "strategy"):
            self.assertEqual(one[key], three[key], key)
        self.assertGreater(one["treated_together"], one["treated"] / 3)
        self.assertEqual((one["strategy"], one["threads"], three["threads"]), ("cells", 1, 3))
        self.assertEqual(self.result(scene)["strategy"], "sequential")
        slabs = self.result(scene, "--strategy", "active", "--threads", "2")
        self.assertEqual((slabs["strategy"], slabs["unreached"]), ("active", 0))
        self.assertNotEqual(slabs["mesh_hash"], one["mesh_hash"])

    def test_phases_that_meet(self):
        scene = self.write("halves.toml", EGG[:EGG.index("[exact]")].replace("[flow]", """[[shape]]
plane = { point = [0.5, 0.6, 0.5], normal = [1, 0.3, 0.2] }
divides = [1, 2]
[[shape]]
plane = { point = [0.5, 0.6, 0.5], normal = [-0.3, 1, 0] }
divides = [1, 3, 2, 4]
[flow]""").replace("[shape]", "[[shape]]", 1).replace("h = 0.07", "h = 0.05"))
        result = self.result(scene)
        self.assertEqual((result["unreached"], result["problem"]), (0, None))
        self.assertEqual(result["strata_last"]["point"], 2)  # the planes meet in a line with two ends
        self.assertGreater(result["strata_last"]["curve"], 30)

    def test_limits_are_judged(self):
        scene = self.write("egg.toml", EGG)
        done = self.verify(scene, "--out", self.path("out"))
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.assertIn("limits.sd_rel_half", done.stdout)
        tight = self.write("tight.toml", EGG.replace("sd_rel_last = 0.08", "sd_rel_last = 1e-4"))
        done = self.verify(tight, "--out", self.path("out"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("limits.sd_rel_last", done.stdout)
        suite = self.write("suite.toml", "[[case]]\nscene = 'translation-3d'\nh = 0.0625\n[case.limits]\n"
                           "space_vertices = 1e-6\nspace_angle_ever = 5\naccuracy_lost = 0\n")
        done = self.verify(suite, "--out", self.path("out"))
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)

    def test_surfaces_from_files(self):
        self.write("box.obj", BOX)
        scene = self.write("box.toml", EGG[:EGG.index("[limits]")].replace(
            "ellipsoid = { centre = [0.5, 0.6, 0.5], radii = [0.1, 0.2, 0.15] }",
            'file = "box.obj"\nscale = 0.05\nmove = [0.25, 0.25, 0.25]'))
        done = self.call("run", scene, "--json", self.path("r.json"))
        if "without Assimp" in done.stderr:
            self.skipTest("the program reads no surfaces")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.path("r.json"), encoding="utf-8") as stream:
            result = json.load(stream)
        self.assertAlmostEqual(result["volume_exact_last"], 0.3 * 0.3 * 0.2, places=7)
        self.assertLess(result["vertex_error_rms"], 1e-4)
        self.assertNotIn("does not resolve", done.stdout)
        # A second box, far smaller than an edge.
        smaller = "".join("v " + " ".join(str(9 + float(number) / 100) for number in line.split()[1:]) + "\n"
                          for line in BOX.splitlines() if line.startswith("v"))
        faces = "".join("f " + " ".join(str(8 + int(number)) for number in line.split()[1:]) + "\n"
                        for line in BOX.splitlines() if line.startswith("f"))
        self.write("box.obj", BOX + smaller + faces)
        done = self.call("run", scene)
        self.assertIn("does not resolve the surface in the file: Euler number 2, not 4", done.stdout)
        # A side of the domain cuts the first one off: nothing is known about it.
        self.write("box.obj", BOX)
        with open(scene, encoding="utf-8") as stream:
            cut = self.write("cut.toml", stream.read().replace("move = [0.25", "move = [-0.2"))
        done = self.call("run", cut)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertNotIn("does not resolve", done.stdout)
        self.write("box.obj", BOX[:BOX.rindex("f")])
        self.expect_refusal("run", scene, words=["not closed", "box.obj, at (", "1 triangle"])
        self.write("box.obj", "nothing\n")
        self.assertEqual(self.call("run", scene).returncode, 2)

    def test_a_shape_that_ends_on_a_side(self):
        half = EGG.replace("[0.5, 0.6, 0.5]", "[0.5, 0, 0.5]")
        result = self.result(self.write("half.toml", half))
        self.assertEqual(result["volume_exact_last"], result["volume_first"])
        self.assertLess(abs(result["volume_first"] - 2 / 3 * 3.14159265 * 0.1 * 0.2 * 0.15), 5e-4)
        self.assertLess(result["sd_rel_last"], 0.08)
        self.assertEqual(result["unreached"], 0)

    def test_bad_scenes_are_refused_with_the_place(self):
        for old, new, words in (
                ("size = [2, 2, 2]", "size = [2, 2]", ["[domain] size", "three numbers"]),
                ("size = [2, 2, 2]", "size = [2, 2, -2]", ["[domain] size"]),
                ("axis = [0, 1, 1]", "axis = [0, 0, 0]", ["axis", "a direction"]),
                ("phase = 2", "phase = 2\ndivides = [1, 2]", ["divides", "no key phase"]),
                ("phase = 2", "divides = [1]", ["divides", "pairs of phases"]),
                ("tube = 0.15", "tube = 0.5", ["tube", "less than the radius"]),
                ("high = [-0.1", "high = [-0.9", ["high", "beyond low"]),
                ('torus = {', 'disc = {', ["sphere"]),
                ('"s*x + 0*z"', '"s*x + 0*q"', ["unknown name", "x, y, z, t, pi"]),
                ("{ s = 1 }", "{ z = 1 }", ["bad name for a parameter"]),
                ("dt = 0.1\n", "", ["two of dt, steps and period"]),
                ("h = 0.12", "", ["no h"]),
                ("h = 0.12", "h = 0.12\ntopology = 'change'", ["topology"]),
                ("period = 1", "period = 1\n[limits]\nsd_rel_last = 1", ["does not measure"]),
                ("period = 1", "period = 1\n[limits]\narea_ratio = 1", ["area_ratio"]),
                ("period = 1", "period = 1\n[exact]\nback = true", ["one shape"])):
            self.assertIn(old, RING)
            scene = self.write("bad.toml", RING.replace(old, new, 1))
            self.expect_refusal("run", scene, words=words)
        scene = self.write("ring.toml", RING)
        self.expect_refusal("run", scene, "--strategy", "counting", words=["three dimensions", "cells"])
        self.expect_refusal("run", scene, "--threads", "2", "--submeshes", "3", words=["power of two"])
        self.expect_refusal("run", scene, "--checkpoint", scene, words=["ring.toml"])


if __name__ == "__main__":
    unittest.main()
