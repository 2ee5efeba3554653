# SPDX-License-Identifier: MIT
"""dsc_verify with a user's scenes: judged by their [limits] and by suites, like those of the catalogue;
limits proposed from shuffled orders; and every kind of bad call."""
import json
import os
import unittest
import xml.etree.ElementTree as xml

from command_line import SCENE, VERIFY, SUITES, CommandLine

MINE = """name = "mine"
[options]
h = 0.05
dt = 0.05
period = 1
[flow]
u = "sin(pi*x)^2 * sin(2*pi*y) * cos(pi*t/period)"
v = "-sin(pi*y)^2 * sin(2*pi*x) * cos(pi*t/period)"
[[shape]]
circle = { centre = [0.5, 0.7], radius = 0.15 }
[exact]
advected = true
"""
LENIENT = """[limits]
sd_rel_last = 0.1
inverted = 0
min_angle_deg_last.min = 5
area_ratio = { min = 0.9, max = 1.1 }
"""


class OwnScenes(CommandLine):
    program = VERIFY

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as stream:
            stream.write(text)
        return self.path(name)

    def scene(self, text=MINE + LENIENT, name="mine.toml"):
        return self.write(name, text)

    def suite(self, limits, name="suite.toml", more=""):
        """Of the scene mine.toml."""
        return self.write(name, f'{more}[[case]]\nscene = "mine.toml"\n{limits}\n')

    def call_scene(self, *arguments):
        self.program = SCENE
        done = self.call(*arguments)
        self.program = VERIFY
        return done

    def rows(self):
        with open(self.path("out/verify.json"), encoding="utf-8") as stream:
            return {row["check"]: row for row in json.load(stream)["checks"]}


class Units(OwnScenes):
    def test_metres_of_a_map_do_as_well(self):
        # An island in the coordinates of UTM, far from the origin.
        self.write("island.txt", "510000 6198000 0\n516000 6199000 0\n515000 6205000 0\n509500 6203000 0\n")
        scene = self.scene('[domain]\nlow = [490000, 6178000]\nhigh = [536000, 6224000]\n'
                           '[options]\nh = 1500\nsteps = 10\nperiod = 1\n[flow]\nu = "3000"\nv = "0"\n'
                           '[[shape]]\nfile = "island.txt"\n')
        done = self.call_scene("run", scene, "--json", self.path("r.json"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.path("r.json"), encoding="utf-8") as stream:
            result = json.load(stream)
        self.assertLess(abs(result["area_ratio"] - 1), 1e-10)
        self.assertEqual(result["unreached"], 0)

    def test_micrometres_do_as_well(self):
        in_micrometres = MINE.replace("h = 0.05\n", "h = 12.8\n").replace("[flow]", "[domain]\nlow = [0, 0]\nhigh = [256, 256]\n[flow]") \
            .replace("x)", "x/256)").replace("y)", "y/256)").replace('u = "', 'u = "256*').replace('v = "-', 'v = "-256*') \
            .replace("[0.5, 0.7], radius = 0.15", "[128, 179.2], radius = 38.4")
        results = []
        for text in (MINE, in_micrometres):
            done = self.call_scene("run", self.scene(text), "--json", self.path("result.json"))
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(self.path("result.json"), encoding="utf-8") as stream:
                results.append(json.load(stream))
        one, other = results
        self.assertEqual(one["triangles_last"], other["triangles_last"])
        self.assertAlmostEqual(one["sd_rel_last"], other["sd_rel_last"], delta=1e-12)

    def test_an_edge_length_that_no_memory_holds_is_refused(self):
        done = self.call_scene("run", "swirl", "--set", "h=1e-6")
        self.assertEqual(done.returncode, 2)
        self.assertIn("at most 100000 edges along a side", done.stderr)


class WhereItFails(OwnScenes):
    """The report of a broken limit: figure, reason, place, a picture, and the command that repeats the
    run."""

    def broken(self, limit):
        done = self.call("run", self.scene(MINE + "[limits]\n" + limit), "--out", "out")
        self.assertEqual((done.returncode, done.stderr), (1, ""), done.stdout)
        (row,) = [row for row in self.rows().values() if row["verdict"] == "fail"]
        return done.stdout, row

    def again(self, row):
        """The report's command reproduces the frame of the picture."""
        words = row["place"]["command"].split()
        self.assertEqual(words[0], "dsc_scene")
        done = self.call_scene(*words[1:], "--edits", "again.edits", "--json", "again.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue([name for name in self.files() if name.endswith(".vtu")])
        with open(self.path("again.json"), encoding="utf-8") as stream:
            return json.load(stream)

    def test_the_sharpest_corner(self):
        text, row = self.broken("min_angle_deg_last.min = 59")
        place = row["place"]
        measured = row["measured"]
        self.assertIn(f"an angle of {measured:.4g} degrees", place["what"])
        for words in (place["what"], "mine.toml:14", "again     dsc_scene run", place["picture"]):
            self.assertIn(words, text)
        svg = xml.parse(self.path(place["picture"])).getroot()
        self.assertTrue(svg.tag.endswith("svg"))
        self.assertIn(place["what"], "".join(svg.itertext()))
        self.assertTrue(all(0 <= x <= 1 for x in place["at"]))
        self.assertEqual(self.again(row)["min_angle_deg_last"], measured)
        failure = xml.parse(self.path("out/verify.xml")).getroot().find(".//failure")
        self.assertIn(place["what"], failure.text)
        self.assertIn(place["command"], failure.text)

    def test_the_largest_deviation(self):
        _, row = self.broken("hausdorff_last = 1e-9")
        self.assertIn(f"{row['measured']:.4g} apart", row["place"]["what"])
        self.assertEqual(row["place"]["time"], 1)
        x, y = row["place"]["at"]
        self.assertLess(abs((x - 0.5) ** 2 + (y - 0.7) ** 2 - 0.15 ** 2), 0.05, "near the circle")

    def test_the_edits_that_lead_there(self):
        _, row = self.broken("inverted = -1")
        self.again(row)
        with open(self.path(row["place"]["edits"]), encoding="utf-8") as stream:
            edits = stream.read()
        self.assertGreater(len(edits.splitlines()), 100)
        with open(self.path("again.edits"), encoding="utf-8") as stream:
            self.assertEqual(stream.read(), edits)

    def test_no_place_where_all_holds(self):
        done = self.call("run", self.scene(), "--out", "out")
        self.assertEqual(done.returncode, 0)
        self.assertNotIn("again", done.stdout)
        self.assertFalse([row for row in self.rows().values() if "place" in row])


class Judged(OwnScenes):
    def test_by_the_limits_of_the_file(self):
        done = self.call("run", self.scene(), "--out", "out")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        rows = self.rows()
        self.assertEqual(set(rows), {"limits.sd_rel_last", "limits.inverted",
                                     "limits.min_angle_deg_last.min",
                                     "limits.area_ratio.min", "limits.area_ratio.max"})
        self.assertEqual(rows["limits.min_angle_deg_last.min"]["sense"], ">=")
        self.assertIn("mine.toml:14: [limits] sd_rel_last", rows["limits.sd_rel_last"]["note"])
        self.assertEqual(rows["limits.sd_rel_last"]["scene"], "mine")

    def test_by_a_suite(self):
        self.scene()
        done = self.call("run", self.suite("limits = { unreached = 0, parallel_area = 1e-3 }",
                                           more="[limits]\ninverted = 0\n"), "--out", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(set(self.rows()), {"inverted", "unreached", "parallel_area"})
        done = self.call("run", self.suite("limits.area_ratio = 0"), "--out", "out")
        self.assertEqual(done.returncode, 1)
        self.assertIn("suite.toml:3: [case.limits] area_ratio", done.stdout)

    def test_by_a_suite_as_well(self):
        done = self.call("run", self.scene(), "--limits", self.suite("limits.unreached = 0"),
                         "--out", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("unreached", self.rows())
        self.assertIn("limits.inverted", self.rows())

    def test_a_suite_of_which_rows_are_timed_as_well(self):
        self.scene()
        suite = self.suite("measure = 'step'\nh = [0.05, 0.04]\nthreads = [1, 2]\n"
                           "strategies = ['sequential', 'cells']\narea_error = 'round'\n"
                           "limits = { parallel_area = 1e-3 }")
        done = self.call("run", suite, "--out", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("out/verify.json"), encoding="utf-8") as stream:
            self.assertEqual([row["scene"] for row in json.load(stream)["checks"]],
                             ["mine h:0.05", "mine h:0.04"])

    def test_by_selected_checks(self):
        for chosen in (["limits.inverted"], ["--only", "inverted"]):
            done = self.call("run", *chosen, self.scene(), "--out", "out")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(set(self.rows()), {"limits.inverted"})


class Refused(OwnScenes):
    def test_no_limits(self):
        self.expect_refusal("run", self.scene(MINE), words=["mine.toml", "has no limits",
                                                            "[limits]", "--limits"])

    def test_the_circularity_of_a_phase_at_a_wall(self):
        drop = ("[options]\nh = 0.1\ndt = 0.01\nsteps = 1\n[fluid]\ntensions = [{ one = 0, other = 1, tension = 1 }]\n"
                "phases = [{ phase = 0, density = 1, viscosity = 1 }, { phase = 1, density = 1, viscosity = 1 }]\n"
                "[[shape]]\ncircle = { centre = [0.5, %s], radius = 0.2 }\n[limits]\ncircularity_min = { min = 0.5 }\n")
        self.expect_refusal("run", self.scene(drop % 0.1), words=["mine.toml:11: [limits] circularity_min",
                                                                  "the measured phase reaches a side"])
        done = self.call("run", self.scene(drop % 0.5), "--out", "out")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_suite_without_the_scene(self):
        self.expect_refusal("run", self.scene(), "--limits", os.path.join(SUITES, "accuracy.toml"),
                            words=["mine", "propose"])


class Proposed(OwnScenes):
    NAMES = ("area_ratio", "symmetric_difference", "inverted", "min_quality",
             "parallel_area_histogram", "quality_histogram", "median_quality", "mesh_hash")

    def propose(self, *arguments):
        return self.call("propose", self.scene(MINE), "--orders", "4", *arguments)

    def read(self, name):
        with open(self.path(name), encoding="utf-8") as stream:
            return stream.read()

    def test_limits_hold_for_the_scene(self):
        done = self.propose("--out", "l.toml")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        text = self.read("l.toml")
        for name in self.NAMES:
            self.assertIn(name + " = ", text)
            self.assertIn(name, done.stdout)
        for key in ("rule = ", "orders = 4", "at = "):
            self.assertIn(key, text)
        done = self.call("run", "l.toml", "--only", "symmetric_difference,quality,validity,histograms",
                         "--out", "out")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)

    def test_limits_of_a_suite_are_updated(self):
        self.scene(MINE)
        before = ("[defaults]\nmin_quality = { rule = 'a tenth below', orders = 4 } # all\n\n"
                  "[[case]] # mine\nscene = 'mine.toml'\n[case.limits]\ninverted = 0 # none\n"
                  "min_quality = { at_least = 0.01, measured = 0.0111 } # low\n"
                  "area_ratio = { at_most = 0.5, measured = 0.2 } # by decree\n")
        path = self.write("l.toml", before)
        done = self.call("propose", path, "--orders", "4")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.read("l.toml"), before)
        done = self.call("propose", path, "--orders", "4", "--update")
        # A limit of the rule "required" is not loosened, and must not be far from the measurement.
        self.assertEqual(done.returncode, 2)
        self.assertIn("area_ratio", done.stderr)
        self.assertEqual(self.read("l.toml"), before)
        path = self.write("l.toml", before.replace(
            "{ at_most = 0.5, measured = 0.2 }", "0.5"))
        done = self.call("propose", path, "--orders", "4", "--update")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        text = self.read("l.toml")
        for kept in ("orders = 4 } # all\n", "[[case]] # mine\n", "inverted = 0 # none\n",
                     " } # low\n", "area_ratio = 0.5 # by decree\n"):
            self.assertIn(kept, text)
        self.assertRegex(text, r"min_quality = \{ at_least = 0.[234]\d?, measured = 0.\d+, at = .*g\+\+.* \}")
        done = self.call("run", path, "--out", "out")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)

    def test_nothing_is_overwritten(self):
        before = self.write("l.toml", "mine")
        self.expect_refusal("propose", self.scene(MINE), "--orders", "2", "--out", before,
                            words=["--out", "l.toml", "another name"])
        self.assertEqual(self.read("l.toml"), "mine")

    def test_bad_calls(self):
        self.scene(MINE)
        suite = self.suite("limits.inverted = 0")
        self.expect_refusal("propose", suite, "--out", "l.toml", words=["--out", "--update"])
        shared = self.write("l.toml", "[[case]]\nscene = 'mine.toml'\nh = [0.05, 0.06]\n"
                            "limits.inverted = 0\n"
                            "limits.unreached = { at_most = 2, measured = 1 }\n")
        # Refused before it runs: 10,000 orders would take longer than a call may.
        self.expect_refusal("propose", shared, "--orders", "10000", "--update",
                            words=["l.toml", "'mine h:0.05'", "[[case]] for each"])


if __name__ == "__main__":
    unittest.main()
