# SPDX-License-Identifier: MIT
"""The command line of dsc_scene; and bad calls of it, of dsc_verify and of dsc_hard (refusals.txt)."""
import csv
import json
import os
import re
import shlex
import unittest
import xml.etree.ElementTree as xml

from command_line import HARD, ROOM, SCENE, SHORT, VERIFY, limited_to, CommandLine


class SceneGood(CommandLine):
    program = SCENE

    def test_help(self):
        for arguments in (["--help"], ["run", "--help"]):
            done = self.call(*arguments)
            self.assertEqual(done.returncode, 0)
            self.assertEqual(done.stderr, "")

    def test_series_adds_up_to_the_result(self):
        done = self.call("run", "swirl", *SHORT, "--json", self.path("r.json"),
                         "--series", self.path("s.csv"), "--every", "3")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.files(), ["r.json", "s.csv"])
        with open(self.path("r.json"), encoding="utf-8") as stream:
            result = json.load(stream)
        with open(self.path("s.csv"), encoding="utf-8", newline="") as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual([int(row["step"]) for row in rows], [0, 3, 6, 8])
        for name, count in result["operations"].items():
            self.assertEqual(sum(int(row[name]) for row in rows), count, name)
        self.assertAlmostEqual(sum(float(row["wall_us"]) for row in rows) / 1e6, result["wall_s"])
        for figure in ("area", "sd_rel", "min_quality", "min_angle_deg"):
            self.assertEqual(float(rows[-1][figure]), result[f"{figure}_last"])
        self.assertEqual(float(rows[-1]["interface_length"]), result["phases"][1]["perimeter"])
        self.assertEqual(int(rows[0]["triangles"]), result["triangles_first"])
        self.assertEqual(int(rows[-1]["triangles"]), result["triangles_last"])

    def test_three_dimensions(self):
        """A ball that is advected reaches its exact position, with the same result in each call."""
        results = []
        for _ in range(2):
            done = self.call("run", "translation-3d", "--set", "h=0.0625", "--json",
                             self.path("r.json"))
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with open(self.path("r.json"), encoding="utf-8") as stream:
                results.append(json.load(stream))
        result = results[0]
        self.assertEqual(result["mesh_hash"], results[1]["mesh_hash"])
        self.assertEqual((result["scene"], result["steps"]), ("translation-3d", 16))
        self.assertEqual((result["inverted"], result["unreached"], result["problem"]), (0, 0, None))
        self.assertAlmostEqual(result["volume_ratio"], 1, delta=2e-3)
        self.assertLess(result["vertex_error_max"], 1e-7)
        self.assertLess(result["sd_rel_last"], 0.06)
        self.assertGreater(result["min_dihedral_deg_ever"], 7)

    def test_a_slotted_sphere_keeps_its_slot(self):
        """After a full turn, only the sphere's sharp edges, which the first complex rounds, differ from the
        exact shape."""
        done = self.call("run", "slotted-sphere", "--set", "h=0.03125", "--json", self.path("r.json"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.path("r.json"), encoding="utf-8") as stream:
            result = json.load(stream)
        self.assertAlmostEqual(result["volume_ratio"], 1, delta=1e-3)
        self.assertLess(result["vertex_error_max"], 1e-6)
        self.assertLess(result["sd_rel_last"], 0.04)
        self.assertGreater(result["min_dihedral_deg_ever"], 7)

    def test_frames_in_three_dimensions(self):
        """A flow that returns is also measured half-way, where a coarse film is already inaccurate."""
        done = self.call("run", "enright", "--set", "h=0.0625", "--set", "period=0.5", "--json",
                         self.path("r.json"), "--frames", self.path("f"), "--at", "0.25")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.path("r.json"), encoding="utf-8") as stream:
            result = json.load(stream)
        self.assertLess(result["sd_rel_half"], 0.08)
        self.assertGreater(result["sd_rel_half"], 0.04)
        self.assertEqual(sorted(os.listdir(self.path("f"))),
                         ["enright.pvd", "enright_00004.ply", "enright_00004.vtu"])

    def test_threads_are_enough(self):
        """The interface is long enough that two threads are used once they have been tried."""
        hashes = set()
        for arguments, used in ((["--threads", "1"], 1), (["--threads", "2"], 2),
                                (["--strategy", "cells"], 1)):
            done = self.call("run", "scaling", "--set", "h=0.01", "--set", "steps=9", *arguments,
                             "--json", self.path("r.json"))
            self.assertEqual((done.returncode, done.stderr), (0, ""), arguments)
            with open(self.path("r.json"), encoding="utf-8") as stream:
                result = json.load(stream)
            self.assertEqual((result["strategy"], result["threads_used"]), ("cells", used))
            self.assertGreaterEqual(result["run_s"], result["first_step_us"] / 1e6)
            self.assertGreater(result["first_step_us"], 0)
            hashes.add(result["mesh_hash"])
        self.assertEqual(len(hashes), 1)

    def test_frames_of_submeshes_say_where_they_are(self):
        done = self.call("run", "speedup-scaling", *SHORT, "--strategy", "cells", "--submeshes",
                         "2", "--frames", self.path("frames"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        maps = [name for name in self.files() if name.endswith(".submeshes.json")]
        self.assertTrue(maps)
        with open(os.path.join(self.path("frames"), maps[-1]), encoding="utf-8") as stream:
            colours = json.load(stream)["colours"]
        self.assertGreaterEqual(len(colours), 1)
        for colour in colours:
            for region in colour["regions"]:
                self.assertIn(region["kind"], ("box", "whole"))
                self.assertGreaterEqual(region["work_us"], 0)

    def test_frames_are_whole(self):
        done = self.call("run", "swirl", *SHORT, "--frames", self.path("frames"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        names = self.files()
        self.assertTrue(any(name.endswith(".pvd") for name in names), names)
        self.assertGreaterEqual(sum(name.endswith(".vtu") for name in names), 2, names)
        self.assertFalse([name for name in names if name.endswith(".part")])
        for name in names:
            xml.parse(os.path.join(self.path("frames"), name))

    def test_a_scene_file_takes_settings(self):
        with open(self.path("mine.toml"), "w", encoding="utf-8") as stream:
            stream.write("[options]\nh = 0.1\ndt = 0.1\nsteps = 9\n[flow]\nu = '-y'\nv = 'x'\n")
        done = self.call("run", "./mine.toml", *SHORT, "--json", self.path("r.json"), "--frames",
                         self.path("frames"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.path("r.json"), encoding="utf-8") as stream:
            result = json.load(stream)
        self.assertEqual((result["scene"], result["steps"]), ("mine", 4))
        self.assertEqual(result["parameters"]["h"], 0.05)
        self.assertTrue(all(name.startswith(("mine", "r.json")) for name in self.files()),
                        self.files())


class Refusals(CommandLine):
    def test_bad_calls(self):
        with open(os.path.join(ROOM, "refusals.txt"), encoding="utf-8") as stream:
            lines = [line for line in stream if not line.startswith("#")]
        with open(self.path("file"), "w", encoding="utf-8") as stream:
            stream.write("here before")
        for line in lines:
            with self.subTest(line=line):
                call, words = line.split(" |")
                program, *arguments = shlex.split(call)
                self.program = {"dsc_scene": SCENE, "dsc_verify": VERIFY, "dsc_hard": HARD}[program]
                # Single quotes belong to the message; double quotes group words.
                self.expect_refusal(*arguments, words=[word.strip('"') for word in
                                                       re.findall(r'"[^"]+"|\S+', words)])
        with open(self.path("file"), encoding="utf-8") as stream:
            self.assertEqual(stream.read(), "here before")


class SceneBad(CommandLine):
    program = SCENE

    def test_bad_scene_file(self):
        with open(self.path("mine.toml"), "w", encoding="utf-8") as stream:
            stream.write("[options]\nh = 0.1\n\nstpes = 9\n")
        self.expect_refusal("run", "mine.toml", words=["mine.toml:4", "'stpes'", "steps"])

    def test_a_file_that_the_scene_names(self):
        with open(self.path("mine.toml"), "w", encoding="utf-8") as stream:
            stream.write('[options]\nh = 0.1\ndt = 0.1\nsteps = 1\n[flow]\nu = "1"\nv = "0"\n[shape]\nfile = "none.txt"\n')
        self.expect_refusal("run", "mine.toml", words=["mine.toml: a file that the scene names", "none.txt",
                                                       "No such file"])

    def test_a_step_that_no_mesh_can_follow(self):
        self.expect_refusal("run", "scaling", "--set", "h=0.02", "--set", "dt=999", "--set",
                            "steps=1", words=["sub-steps"], code=(1,))

    def test_a_full_disk(self):
        for size in (0, 100, 1000):
            self.expect_refusal("run", "swirl", *SHORT, "--json", self.path("r.json"),
                                words=["r.json"], code=(1,), prepare=limited_to(size))
            self.expect_refusal("run", "swirl", *SHORT, "--frames", self.path("frames"),
                                words=["frames"], code=(1, 2), prepare=limited_to(size))

    def test_a_full_disk_keeps_the_old_result(self):
        with open(self.path("r.json"), "w", encoding="utf-8") as stream:
            stream.write("here before")
        self.expect_refusal("run", "swirl", *SHORT, "--json", self.path("r.json"), code=(1,),
                            prepare=limited_to(100))
        with open(self.path("r.json"), encoding="utf-8") as stream:
            self.assertEqual(stream.read(), "here before")


if __name__ == "__main__":
    unittest.main()
