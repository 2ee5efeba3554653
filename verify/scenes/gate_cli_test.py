# SPDX-License-Identifier: MIT
"""The command lines of dsc_verify and dsc_hard: good calls, and every kind of bad one."""
import json
import unittest
import xml.etree.ElementTree as xml

from command_line import VERIFY, HARD, LIMITS, limited_to, CommandLine


class Gate(CommandLine):
    """Of the gate's checks only the cheapest ones run here; all of them run as the gate."""
    program = VERIFY
    cheap = "accuracy_area"
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
        self.assertTrue(all(c["description"] for c in result["checks"] + result["not_run"]))
        others = {c["check"] for c in result["not_run"]}
        self.assertIn(self.cheap, others)
        self.assertNotIn(self.with_reference, others)
        strategies = {h["strategy"] for h in result["histograms"]}
        self.assertEqual(strategies, {"sequential", "reference"})

        scene = "vortex-square"
        tightened = self.limits(lambda limits: limits[self.cheap][scene].update(value=-1))
        done = self.call("run", self.cheap, "--limits", tightened, "--out", "out")
        self.assertEqual(done.returncode, 1)
        self.assertIn("FAIL", done.stdout)
        verdicts = {c["scene"]: c["verdict"] for c in self.result()["checks"]}
        self.assertEqual(verdicts.pop(scene), "fail")
        self.assertEqual(set(verdicts.values()), {"pass"})
        suites = xml.parse(self.path("out/verify.xml")).getroot()
        self.assertEqual(suites.get("failures"), "1")
        self.assertEqual(suites.get("tests"), str(len(self.result()["checks"])))
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
        self.assertIn("choose_frame", refused["error_message"])
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
