# SPDX-License-Identifier: MIT
"""The command lines of dsc_scene, dsc_verify and dsc_hard: good calls, and every kind of bad one. A bad call
ends with code 2 (1 where the run had begun) and one sentence on stderr that says what is wrong, the
value and what is allowed; and it leaves no half-written file.

The programs are named by the environment: DSC_SCENE, DSC_VERIFY and DSC_HARD.
"""
import json
import os
import resource
import signal
import subprocess
import tempfile
import time
import unittest
import xml.etree.ElementTree as xml

SCENE = os.environ["DSC_SCENE"]
VERIFY = os.environ["DSC_VERIFY"]
HARD = os.environ["DSC_HARD"]
ROOM = os.path.dirname(os.path.abspath(__file__))
LIMITS = os.path.join(os.path.dirname(ROOM), "gate", "limits.json")
SHORT = ["--set", "h=0.05", "--set", "steps=4"]
PROMPTLY = 120  # seconds; a bad call takes none


def limited_to(size):
    """No file may grow beyond so many bytes: what a full disk looks like to a program."""
    def prepare():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    return prepare


class CommandLine(unittest.TestCase):
    program = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def call(self, *arguments, prepare=None):
        return subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True,
                              timeout=PROMPTLY, cwd=self.folder, preexec_fn=prepare, check=False)

    def path(self, name):
        return os.path.join(self.folder, name)

    def files(self):
        return sorted(name for _, _, names in os.walk(self.folder) for name in names)

    def expect_refusal(self, *arguments, words=(), code=(2,), prepare=None):
        """One sentence that holds all of the words; nothing left behind."""
        before = self.files()
        done = self.call(*arguments, prepare=prepare)
        self.assertIn(done.returncode, code, f"{arguments}: {done.stderr}")
        lines = done.stderr.strip().splitlines()
        self.assertEqual(len(lines), 1, f"{arguments}: not one sentence: {done.stderr!r}")
        name = os.path.basename(self.program)
        self.assertTrue(lines[0].startswith(name + ": "), lines[0])
        for word in words:
            self.assertIn(word, lines[0])
        self.assertEqual(self.files(), before, f"{arguments} left something behind")
        return done


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
        hashes = {}
        parallel = ("fixed", "counting", "active", "blocks", "cells", "copy")
        for strategy in ("sequential", *parallel, "reference"):
            threads = ["--threads", "2"] if strategy in parallel else []
            done = self.call("run", "scaling", *SHORT, "--strategy", strategy, *threads,
                             "--submeshes", "4", "--json", self.path("r.json"))
            self.assertEqual((done.returncode, done.stderr), (0, ""), strategy)
            with open(self.path("r.json"), encoding="utf-8") as stream:
                result = json.load(stream)
            self.assertEqual(result["strategy"], strategy)
            hashes[strategy] = result["mesh_hash"]
        self.assertEqual(len(hashes), 8)

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

    def test_an_interrupted_run_keeps_its_result(self):
        with subprocess.Popen([SCENE, "run", "swirl", "--set", "h=0.02", "--set", "steps=1000000",
                               "--json", self.path("r.json")], stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True) as process:
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

    def test_bad_angles(self):
        for value in ("x", "nan", "inf", "", "9o"):
            self.expect_refusal("run", "swirl", *SHORT, "--strategy", "fixed", f"--angle={value}",
                                words=["--angle"])

    def test_what_does_not_go_together(self):
        self.expect_refusal("run", "swirl", *SHORT, "--threads", "2", words=["--threads"])
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


class Gate(CommandLine):
    """Of the gate's checks only the cheapest ones run here; all of them run as the gate."""
    program = VERIFY
    cheap = "area_ratio"
    with_reference = "reference_area"  # draws histograms as well

    def limits(self, change=lambda limits: None):
        with open(LIMITS, encoding="utf-8") as stream:
            data = json.load(stream)
        change(data["limits"])
        return self.write("limits.json", json.dumps(data))

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as stream:
            stream.write(text)
        return self.path(name)

    def result(self):
        with open(self.path("out/verify.json"), encoding="utf-8") as stream:
            return json.load(stream)

    def test_list(self):
        done = self.call("list")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for word in ("area_ratio", "mesh_hash", "swirl"):
            self.assertIn(word, done.stdout)

    def test_every_limit_has_a_note(self):
        with open(LIMITS, encoding="utf-8") as stream:
            limits = json.load(stream)["limits"]
        for scenes in limits.values():
            for entry in scenes.values():
                self.assertGreater(len(entry["note"]), 10)

    def test_pass_and_failure(self):
        done = self.call("run", self.with_reference, "--out", "out")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.assertEqual(self.files(), ["verify.json", "verify.xml"])
        result = self.result()
        self.assertTrue(result["machine"] and result["commit"])
        self.assertTrue(result["checks"])
        self.assertEqual({c["verdict"] for c in result["checks"]}, {"pass"})
        self.assertEqual({c["check"] for c in result["checks"]}, {self.with_reference})
        strategies = {h["strategy"] for h in result["histograms"]}
        self.assertEqual(strategies, {"sequential", "reference"})

        scene = "swirl"
        tightened = self.limits(lambda limits: limits[self.cheap][scene].update(value=-1))
        done = self.call("run", self.cheap, "--limits", tightened, "--out", "out")
        self.assertEqual(done.returncode, 1)
        self.assertIn("FAIL", done.stdout)
        verdicts = {c["scene"]: c["verdict"] for c in self.result()["checks"]}
        self.assertEqual(verdicts.pop(scene), "fail")
        self.assertEqual(set(verdicts.values()), {"pass"})
        suites = xml.parse(self.path("out/verify.xml")).getroot()
        self.assertEqual(suites.get("failures"), "1")
        self.assertEqual(suites.get("tests"), str(len(result["checks"])))
        self.assertEqual(len(suites.findall(".//failure")), 1)

    def test_no_or_wrong_command(self):
        self.expect_refusal()
        self.expect_refusal("walk", words=["walk"])
        self.expect_refusal("run", "--colour", words=["--colour"])
        self.expect_refusal("run", "--limits")

    def test_unknown_check(self):
        for name in ("area", "", "AREA_RATIO"):
            self.expect_refusal("run", name, words=[f"'{name}'", "area_ratio", "mesh_hash"])

    def test_a_missing_limit(self):
        path = self.limits(lambda limits: limits["area_ratio"].pop("swirl"))
        self.expect_refusal("run", "--limits", path, words=["area_ratio", "swirl"])
        path = self.limits(lambda limits: limits.pop("inverted"))
        self.expect_refusal("run", "inverted", "--limits", path, words=["inverted"])
        path = self.write("limits.json", '{"limits": {}}')
        self.expect_refusal("run", "--limits", path, words=["area_ratio"])

    def test_a_limit_that_no_check_reads(self):
        entry = {"value": 1, "note": "a misspelt name"}
        path = self.limits(lambda limits: limits["area_ratio"].update(swril=entry))
        self.expect_refusal("run", self.cheap, "--limits", path, words=["swril"])
        path = self.limits(lambda limits: limits.update(aera_ratio={"swirl": entry}))
        self.expect_refusal("run", self.cheap, "--limits", path, words=["aera_ratio"])

    def test_unreadable_limits(self):
        for path in (self.path("none.json"), self.folder, "/proc/self/mem", ""):
            self.expect_refusal("run", "--limits", path, words=[path])

    def test_truncated_limits(self):
        with open(LIMITS, encoding="utf-8") as stream:
            text = stream.read().strip()
        for length in (0, 1, len(text) // 3, len(text) // 2, len(text) - 1):
            path = self.write("limits.json", text[:length])
            self.expect_refusal("run", "--limits", path, words=["limits.json"])

    def test_limits_that_are_none(self):
        for text in ("[]", "7", "{}", '{"limits": 3}', '{"limits": {"area_ratio": 3}}',
                     '{"limits": {"area_ratio": {"swirl": 3}}}', "\x00\x01", "nonsense"):
            path = self.write("limits.json", text)
            self.expect_refusal("run", "--limits", path, words=["limits.json"])
        for value in ('"1e-3"', "null", "1e999", "NaN", "true", "[1]"):
            path = self.write("limits.json", '{"limits": {"area_ratio": {"swirl": '
                              f'{{"value": {value}, "note": "as seeded"}}}}}}}}')
            self.expect_refusal("run", "--limits", path, words=["limits.json"])
        path = self.write("limits.json",
                          '{"limits": {"area_ratio": {"swirl": {"value": 1, "note": ""}}}}')
        self.expect_refusal("run", "--limits", path, words=["note"])

    def test_folder_that_cannot_be_written(self):
        self.write("file", "here before")
        for path in (self.path("file"), self.path("file/out"), "/proc/out", ""):
            self.expect_refusal("run", self.cheap, "--out", path, words=[f"'{path}'"])

    def test_a_full_disk(self):
        self.expect_refusal("run", self.cheap, "--out", self.path("out"), words=["out"],
                            prepare=limited_to(0))
        self.expect_refusal("run", self.cheap, "--out", self.path("out"), words=["verify.json"],
                            code=(1,), prepare=limited_to(100))


class HardCases(CommandLine):
    """Only the cheapest cases run here; all of them are tests of their own."""
    program = HARD
    cheap = ("nan-some", "size-1e-150")

    def test_list(self):
        done = self.call("list")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        names = [line.split()[0] for line in done.stdout.splitlines()]
        self.assertEqual(len(names), len(set(names)))
        for name in (*self.cheap, "offset-1e12", "pressed-slowly", "slow-1000000"):
            self.assertIn(name, names)
        self.assertIn("zalesak-100  (long)", done.stdout)

    def test_run_writes_its_results(self):
        done = self.call("run", *self.cheap, "--json", self.path("hard.json"),
                         "--markdown", self.path("hard.md"))
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.assertIn("2 cases, 0 do not hold", done.stdout)
        self.assertEqual(self.files(), ["hard.json", "hard.md"])
        with open(self.path("hard.json"), encoding="utf-8") as stream:
            cases = json.load(stream)
        self.assertEqual([case["name"] for case in cases], list(self.cheap))
        held, refused = cases
        self.assertTrue(held["holds"] and held["asked"] and held["what_happened"])
        self.assertEqual((held["inverted"], held["uncounted"], held["gave_up"]), (0, 0, ""))
        self.assertEqual(held["missed"], held["unreached"])
        self.assertGreater(held["held"], 0)
        self.assertIsNone(held["error"])
        self.assertIn("UnitMap", refused["error_message"])
        with open(self.path("hard.md"), encoding="utf-8") as stream:
            rows = stream.read().splitlines()
        self.assertEqual(len(rows), 4)
        self.assertEqual({row.replace(r"\|", "").count("|") for row in rows}, {12})

    def test_no_or_wrong_command(self):
        self.expect_refusal()
        self.expect_refusal("walk", words=["walk"])
        self.expect_refusal("run", "--colour", words=["--colour"])
        self.expect_refusal("run", "--json")

    def test_unknown_case(self):
        for name in ("nan", "", "NAN-SOME"):
            self.expect_refusal("run", name, words=[f"'{name}'", "dsc_hard list"])

    def test_result_file_that_cannot_be_written(self):
        for option in ("--json", "--markdown"):
            self.expect_refusal("run", self.cheap[0], option, self.path("no/such/folder"),
                                words=[option, "no/such/folder"])

    def test_a_full_disk(self):
        # The table on standard output is written all the same: it goes to a pipe.
        self.expect_refusal("run", self.cheap[0], "--json", self.path("hard.json"),
                            words=["hard.json"], code=(1, 2), prepare=limited_to(100))


if __name__ == "__main__":
    unittest.main()
