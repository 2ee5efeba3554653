# SPDX-License-Identifier: MIT
"""The command line of dsc_scene: good calls, and every kind of bad one."""
import csv
import json
import os
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree as xml

from command_line import SCENE, SHORT, PROMPTLY, limited_to, CommandLine


class SceneGood(CommandLine):
    program = SCENE

    def test_list_names_scenes_and_keys(self):
        done = self.call("list")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stderr, "")
        for word in ("swirl", "translation", "zalesak", "integrator"):
            self.assertIn(word, done.stdout)

    def test_help(self):
        for arguments in (["--help"], ["run", "--help"]):
            done = self.call(*arguments)
            self.assertEqual(done.returncode, 0)
            self.assertEqual(done.stderr, "")

    def test_series_adds_up_to_the_result(self):
        done = self.call("run", "swirl", *SHORT, "--json", self.path("r.json"),
                         "--series", self.path("s.csv"), "--every", "3")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
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

    def test_run_writes_its_result(self):
        done = self.call("run", "swirl", *SHORT, "--json", self.path("r.json"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.files(), ["r.json"])
        with open(self.path("r.json"), encoding="utf-8") as stream:
            result = json.load(stream)
        self.assertEqual(result["scene"], "swirl")
        self.assertEqual(result["steps"], 8)
        self.assertEqual(result["parameters"]["h"], 0.05)
        self.assertEqual(result["strategy"], "sequential")
        self.assertEqual((result["inverted"], result["unreached"]), (0, 0))

    def test_every_strategy_runs(self):
        parallel = ("fixed", "counting", "active", "blocks", "cells", "copy")
        for strategy in ("sequential", *parallel, "reference"):
            threads = ["--threads", "2"] if strategy in parallel else []
            done = self.call("run", "scaling", *SHORT, "--strategy", strategy, *threads,
                             "--submeshes", "4", "--json", self.path("r.json"))
            self.assertEqual((done.returncode, done.stderr), (0, ""), strategy)
            with open(self.path("r.json"), encoding="utf-8") as stream:
                result = json.load(stream)
            self.assertEqual(result["strategy"], strategy)
            self.assertEqual((result["inverted"], result["unreached"]), (0, 0), strategy)
            self.assertAlmostEqual(result["area_drift_exact_last"], 0, delta=0.02, msg=strategy)

    def test_threads_are_enough(self):
        """The interface is long enough for two threads to be used."""
        hashes = set()
        for arguments, used in ((["--threads", "1"], 1), (["--threads", "2"], 2),
                                (["--strategy", "cells"], 1)):
            done = self.call("run", "scaling", "--set", "h=0.01", "--set", "steps=4", *arguments,
                             "--json", self.path("r.json"))
            self.assertEqual((done.returncode, done.stderr), (0, ""), arguments)
            with open(self.path("r.json"), encoding="utf-8") as stream:
                result = json.load(stream)
            self.assertEqual((result["strategy"], result["threads_used"]), ("cells", used))
            self.assertGreaterEqual(result["run_s"], result["first_step_us"] / 1e6)
            self.assertGreater(result["first_step_us"], 0)
            hashes.add(result["mesh_hash"])
        self.assertEqual(len(hashes), 1)

    def test_slabs_may_lie_at_an_angle(self):
        for angle in ("0", "90", "-33.5", "shape"):
            done = self.call("run", "scaling", *SHORT, "--strategy", "active", "--submeshes", "3",
                             f"--angle={angle}", "--json", self.path("r.json"))
            self.assertEqual((done.returncode, done.stderr), (0, ""), angle)

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

    def test_a_described_scene_runs_to_the_same_mesh(self):
        described = self.call("describe", "zalesak", *SHORT)
        self.assertEqual((described.returncode, described.stderr), (0, ""))
        with open(self.path("mine.toml"), "w", encoding="utf-8") as stream:
            stream.write(described.stdout)
        results = []
        for scene in (["zalesak", *SHORT], ["mine.toml"]):
            done = self.call("run", *scene, "--json", self.path("r.json"))
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with open(self.path("r.json"), encoding="utf-8") as stream:
                result = json.load(stream)
            results.append([result[key] for key in ("scene", "mesh_hash", "sd_rel_last")])
        self.assertEqual(*results)

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

    def test_an_interrupted_run_keeps_its_result(self):
        # Of one that is stretched more and more, the exact shape takes long.
        with subprocess.Popen([SCENE, "run", "translation", "--set", "h=0.02", "--set",
                               "steps=1000000", "--json", self.path("r.json")],
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
            time.sleep(1)
            process.send_signal(signal.SIGINT)
            _, errors = process.communicate(timeout=PROMPTLY)
        self.assertEqual(process.returncode, 1, errors)
        self.assertIn("interrupted", errors)
        with open(self.path("r.json"), encoding="utf-8") as stream:
            self.assertTrue(json.load(stream)["interrupted"])


class SceneBad(CommandLine):
    program = SCENE

    def test_no_or_wrong_command(self):
        self.expect_refusal()
        self.expect_refusal("walk", words=["walk"])
        self.expect_refusal("run")
        self.expect_refusal("run", "swirl", "scaling", words=["scaling"])
        self.expect_refusal("run", "swirl", "--colour", "red", words=["--colour"])
        self.expect_refusal("list", "everything", words=["everything"])

    def test_unknown_scene(self):
        for name in ("swril", "", "SWIRL", "../swirl"):
            self.expect_refusal("run", name, words=[f"'{name}'", "swirl", "scaling"])

    def test_bad_scene_file(self):
        self.expect_refusal("run", "none.toml", words=["none.toml", "No such file", "swirl"])
        self.expect_refusal("run", "/dev/zero", words=["/dev/zero", "regular"])
        with open(self.path("mine.toml"), "w", encoding="utf-8") as stream:
            stream.write("[options]\nh = 0.1\n\nstpes = 9\n")
        self.expect_refusal("run", "mine.toml", words=["mine.toml:4", "'stpes'", "steps"])
        self.expect_refusal("describe", "none", words=["'none'", "swirl"])
        self.expect_refusal("describe")

    def test_unknown_strategy(self):
        for name in ("cubes", "", "Fixed"):
            self.expect_refusal("run", "swirl", "--strategy", name,
                                words=[f"'{name}'", "sequential", "counting"])

    def test_unknown_key(self):
        self.expect_refusal("run", "swirl", "--set", "size=3", words=["'size'", "integrator"])
        self.expect_refusal("run", "swirl", "--set", "=3", words=["''"])
        self.expect_refusal("run", "translation", "--set", "period=3", words=["'period'"])

    def test_a_setting_without_a_value(self):
        self.expect_refusal("run", "swirl", "--set", "h", words=["'h'", "key=value"])
        self.expect_refusal("run", "swirl", "--set")
        self.expect_refusal("run", "swirl", "--set", "h=", words=["h", "''"])

    def test_bad_numbers(self):
        for value in ("abc", "0", "-0.1", "nan", "inf", "1e300", "1e-300", "0.1x", "1,5"):
            for key in ("h", "dt"):
                self.expect_refusal("run", "swirl", "--set", f"{key}={value}",
                                    words=[key, f"'{value}'", "allowed"])
        for value in ("abc", "0", "-1", "1.5", "nan", "1e9", "99999999999999999999"):
            self.expect_refusal("run", "swirl", "--set", f"steps={value}",
                                words=["steps", f"'{value}'", "allowed"])
        for value in ("-1", "x", "1.5"):
            self.expect_refusal("run", "swirl", "--set", f"seed={value}", words=[f"'{value}'"])
        for value in ("abc", "0", "-8", "nan"):
            self.expect_refusal("run", "single-vortex", "--set", f"period={value}",
                                words=["period", f"'{value}'"])

    def test_bad_words(self):
        for key, value, allowed in (("integrator", "rk5", "midpoint"), ("real", "half", "float"),
                                    ("insertion", "quintic", "cubic")):
            self.expect_refusal("run", "swirl", "--set", f"{key}={value}",
                                words=[key, f"'{value}'", allowed])

    def test_a_mesh_too_fine_for_any_memory(self):
        self.expect_refusal("run", "scaling", "--set", "h=0.00001", words=["allowed"])

    def test_bad_counts(self):
        for option in ("--threads", "--submeshes"):
            for value in ("0", "-1", "x", "1.5", "1000000", "99999999999", "nan", ""):
                self.expect_refusal("run", "swirl", *SHORT, "--strategy", "fixed",
                                    f"{option}={value}", words=[option])

    def test_bad_series(self):
        for value in ("0", "-1", "x", "1.5"):
            self.expect_refusal("run", "swirl", *SHORT, "--series", self.path("s.csv"),
                                f"--every={value}", words=["--every"])
        self.expect_refusal("run", "swirl", *SHORT, "--every", "2", words=["--every", "--series"])
        self.expect_refusal("run", "swirl", *SHORT, "--series", self.path("none/s.csv"),
                            words=["--series", "allowed"])

    def test_bad_angles(self):
        for value in ("x", "nan", "inf", "", "9o"):
            self.expect_refusal("run", "swirl", *SHORT, "--strategy", "fixed", f"--angle={value}",
                                words=["--angle"])

    def test_what_does_not_go_together(self):
        self.expect_refusal("run", "swirl", *SHORT, "--strategy", "sequential", "--threads", "2",
                            words=["--threads"])
        self.expect_refusal("run", "swirl", *SHORT, "--strategy", "reference", "--set",
                            "real=float", words=["float"])

    def test_a_step_that_no_mesh_can_follow(self):
        self.expect_refusal("run", "scaling", "--set", "h=0.02", "--set", "dt=999", "--set",
                            "steps=1", words=["sub-steps"], code=(1,))

    def test_result_file_that_cannot_be_written(self):
        with open(self.path("file"), "w", encoding="utf-8") as stream:
            stream.write("here before")
        for path in (self.path("none/r.json"), self.path("file/r.json"), self.folder, "",
                     "/proc/r.json", "/dev/null/r.json"):
            done = self.expect_refusal("run", "swirl", *SHORT, "--json", path, code=(1, 2),
                                       words=[path])
            if not path.startswith("/proc"):
                self.assertEqual(done.returncode, 2, path)
        with open(self.path("file"), encoding="utf-8") as stream:
            self.assertEqual(stream.read(), "here before")

    def test_folder_for_frames_that_cannot_be_written(self):
        with open(self.path("file"), "w", encoding="utf-8"):
            pass
        for path in (self.path("file/frames"), self.path("file"), "/proc/frames"):
            self.expect_refusal("run", "swirl", *SHORT, "--frames", path, words=[path])

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
