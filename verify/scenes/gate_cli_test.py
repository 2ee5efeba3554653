# SPDX-License-Identifier: MIT
"""The command lines of dsc_verify and dsc_hard: good calls, and every kind of bad one."""
import json
import os
import unittest
import xml.etree.ElementTree as xml

from command_line import VERIFY, HARD, SUITES, limited_to, CommandLine


class Gate(CommandLine):
    """Only the gate's cheapest checks run here; the gate runs all of them."""
    program = VERIFY
    cheap = "accuracy_area"
    with_reference = "reference_area"  # draws histograms as well

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as stream:
            stream.write(text)
        return self.path(name)

    def suite(self, name, old, new):
        """One of the project's suites, with a change."""
        with open(os.path.join(SUITES, name), encoding="utf-8") as stream:
            text = stream.read()
        self.assertIn(old, text)
        return self.write("suite.toml", text.replace(old, new))

    def result(self):
        with open(self.path("out/verify.json"), encoding="utf-8") as stream:
            return json.load(stream)

    def test_pass_and_failure(self):
        done = self.call("run", self.with_reference, "scaling", "--out", "out")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.assertEqual(self.files(), ["verify.json", "verify.xml"])
        result = self.result()
        self.assertTrue(result["machine"] and result["commit"])
        self.assertTrue(result["checks"])
        self.assertEqual({c["verdict"] for c in result["checks"]}, {"pass"})
        self.assertEqual({c["check"] for c in result["checks"]}, {self.with_reference})
        self.assertTrue(all(c["description"] for c in result["checks"] + result["not_run"]))
        others = {c["check"] for c in result["not_run"]}
        self.assertIn("parallel_area", others)
        self.assertNotIn(self.with_reference, others)
        strategies = {h["strategy"] for h in result["histograms"]}
        self.assertEqual(strategies, {"sequential", "reference"})

        scene = "vortex-square"
        tightened = self.suite("accuracy.toml", "3.2e-7, measured = 2.07e-7", "1e-12, measured = 0")
        done = self.call("run", self.cheap, tightened, "--out", "out")
        self.assertEqual(done.returncode, 1)
        self.assertIn("FAIL", done.stdout)
        verdicts = {c["scene"]: c["verdict"] for c in self.result()["checks"]}
        self.assertEqual(verdicts.pop(scene), "fail")
        self.assertEqual(set(verdicts.values()), {"pass"})
        suites = xml.parse(self.path("out/verify.xml")).getroot()
        self.assertEqual(suites.get("failures"), "1")
        self.assertEqual(suites.get("tests"), str(len(self.result()["checks"])))
        self.assertEqual(len(suites.findall(".//failure")), 1)

    def test_what_is_run(self):
        """Chooses scenes and a group of checks; simultaneous runs print the same."""
        printed = set()
        for jobs in (1, 2):
            done = self.call("run", "translation", "scaling", "--only", "validity,area_ratio",
                             "--jobs", jobs, "--out", "out")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            printed.add(done.stdout)
            self.assertEqual({(c["check"], c["scene"]) for c in self.result()["checks"]},
                             {(check, scene) for scene in ("translation", "scaling") for check in
                              ("inverted", "unreached", "parallel_unreached", "area_ratio")})
        self.assertEqual(len(printed), 1)

    def test_what_has_become_worse(self):
        drifted = self.suite("accuracy.toml", "3.2e-7, measured = 2.07e-7",
                             "2.6e-7, measured = 1.8e-7")
        for drift, code in ((None, 0), (0.2, 0), (0.1, 1)):
            done = self.call("run", self.cheap, "vortex-square", drifted, "--out", "out",
                             *(["--drift", drift] if drift else []))
            self.assertEqual(done.returncode, code, done.stdout)

    def test_limits_of_several_sizes_are_refused_before_anything_runs(self):
        text = '[[case]]\nscene = "scaling"\nh = [0.1, 0.001]\n[case.limits]\ninverted = { at_most = 0, orders = 51 }\n'
        suite = self.write("suite.toml", text)
        done = self.call("propose", suite, "--update")  # one size alone would take minutes in 51 orders
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("the [[case]] has several scenes or sizes", done.stderr)
        self.assertIn("one [[case]] for each scene and size", done.stderr)
        with open(suite, encoding="utf-8") as stream:
            self.assertEqual(stream.read(), text)

    def test_a_full_disk(self):
        self.expect_refusal("run", self.cheap, "--out", self.path("out"), words=["verify.json"],
                            code=(1,), prepare=limited_to(100))


class HardCases(CommandLine):
    """Only the cheapest hard cases run here; each case also has a test of its own."""
    program = HARD
    cheap = ("nan-some", "size-1e-75")

    def test_list(self):
        done = self.call("list")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        names = [line.split()[0] for line in done.stdout.splitlines()]
        self.assertEqual(len(names), len(set(names)))
        for name in (*self.cheap, "offset-1e12", "pressed-slowly", "slow-1000000"):
            self.assertIn(name, names)
        self.assertIn("zalesak-100  (long)", done.stdout)

    def test_run_writes_its_results(self):
        done = self.call("run", *self.cheap, "--json", self.path("hard.json"))
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.assertIn("2 cases, 0 do not hold", done.stdout)
        self.assertEqual(self.files(), ["hard.json"])
        with open(self.path("hard.json"), encoding="utf-8") as stream:
            cases = json.load(stream)
        self.assertEqual([case["name"] for case in cases], list(self.cheap))
        held, refused = cases
        self.assertTrue(held["holds"] and held["asked"] and held["what_happened"])
        self.assertEqual((held["inverted"], held["uncounted"], held["gave_up"]), (0, 0, ""))
        self.assertEqual(held["missed"], held["unreached"])
        self.assertGreater(held["held"], 0)
        self.assertIsNone(held["shape_error"])
        self.assertIn("choose_frame", refused["error_message"])


if __name__ == "__main__":
    unittest.main()
