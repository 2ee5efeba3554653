# SPDX-License-Identifier: MIT
"""The command line of dsc_scene: runs that are broken off and resumed, and what they write on the way."""
import csv
import json
import os
import resource
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree as xml

from command_line import SCENE, SHORT, PROMPTLY, CommandLine


class Checkpoints(CommandLine):
    program = SCENE
    LONG = ["drop-and-pool", "--set", "h=0.03", "--set", "steps=30"]

    def result(self, *arguments, code=0):
        done = self.call("run", *arguments, "--json", self.path("r.json"))
        self.assertEqual(done.returncode, code, done.stderr)
        with open(self.path("r.json"), encoding="utf-8") as stream:
            return json.load(stream)

    def same(self, one, other):
        for key in ("mesh_hash", "steps", "operations", "events", "phases", "min_quality_ever",
                    "unreached", "sub_steps", "series"):
            self.assertEqual(one.get(key), other.get(key), key)

    def test_a_scene_file_is_in_the_checkpoint(self):
        with open(self.path("mine.toml"), "w", encoding="utf-8") as stream:
            stream.write("scene = 'swirl'\n[options]\nh = 0.05\nsteps = 9\n")
        whole = self.result("mine.toml", "--set", "integrator=centred")
        self.result("mine.toml", "--set", "integrator=centred", "--checkpoint", "c",
                    "--stop-after", "10", code=1)
        os.remove(self.path("mine.toml"))
        self.same(self.result("--resume", "c"), whole)

    def endless(self, *arguments):
        # Of a shape that is stretched more and more, the exact one takes long.
        return subprocess.Popen([SCENE, "run", "translation", "--set", "h=0.02", "--set",
                                 "steps=1000000", *arguments], stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE, text=True, cwd=self.folder)

    def wait_for(self, name):
        for _ in range(10 * PROMPTLY):
            if os.path.exists(self.path(name)):
                return
            time.sleep(0.1)

    def test_an_interruption_writes_a_checkpoint(self):
        with self.endless("--checkpoint", "c", "--json", "r.json") as process:
            time.sleep(1)
            process.send_signal(signal.SIGTERM)
            _, errors = process.communicate(timeout=PROMPTLY)
        self.assertEqual(process.returncode, 1, errors)
        self.assertIn("run --resume c", errors)
        with open(self.path("r.json"), encoding="utf-8") as stream:
            part = json.load(stream)
        self.assertTrue(part["partial"])
        after = str(part["steps"] + 2)
        self.assertEqual(self.result("--resume", "c", "--stop-after", after, code=1)["steps"],
                         part["steps"] + 2)

    def test_a_killed_run_goes_on_from_its_last_checkpoint(self):
        for wait in (0.0, 0.03, 0.07):
            with self.endless("--checkpoint", "c", "--every", "1") as process:
                self.wait_for("c")
                time.sleep(wait)
                process.kill()
                process.communicate(timeout=PROMPTLY)
            part = self.result("--resume", "c", "--stop-after", "1", code=1)
            self.assertGreaterEqual(part["steps"], 1)
            os.remove(self.path("c"))

    def content(self, name):
        with open(os.path.join(self.folder, "f", name), "rb") as stream:
            return stream.read()

    def test_frames_and_series_go_on(self):
        outputs = ["--frames", "f", "--series", "s.csv", "--every", "20"]
        self.result(*self.LONG, *outputs)
        whole = {name: self.content(name) for name in os.listdir(self.path("f"))}
        self.assertEqual(sum(name.endswith(".vtu") for name in whole), 4)
        self.result(*self.LONG, *outputs, "--checkpoint", "c", "--stop-after", "30", code=1)
        self.result("--resume", "c", *outputs)
        for name, content in whole.items():
            self.assertEqual(self.content(name), content, name)
        with open(self.path("s.csv"), encoding="utf-8", newline="") as stream:
            self.assertEqual([row["step"] for row in csv.DictReader(stream)],
                             ["0", "20", "40", "60"])

    def test_bad_checkpoints(self):
        with open(self.path("c"), "w", encoding="utf-8") as stream:
            stream.write("not a checkpoint, but a text of some length")
        self.expect_refusal("run", "--resume", "c", words=["c: is no file of kind"], code=(1,))
        self.expect_refusal("run", "--resume", "none", words=["none", "cannot be read"], code=(1,))
        os.mkfifo(self.path("pipe"))  # a file would take its place
        self.expect_refusal("run", "swirl", *SHORT, "--checkpoint", "pipe",
                            words=["--checkpoint", "allowed"])

    def test_a_file_that_may_not_grow_ends_the_run_with_a_sentence(self):
        limits = (4096, 4096)  # bytes
        done = subprocess.run([SCENE, "run", "swirl", *SHORT, "--checkpoint", "c"],
                              cwd=self.folder, text=True, capture_output=True, check=False,
                              timeout=PROMPTLY,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, limits))
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr, "dsc_scene: c: writing failed: File too large\n")
        self.assertEqual(os.listdir(self.folder), [])


class Frames(CommandLine):
    program = SCENE

    def test_pictures(self):
        done = self.call("run", "swirl", *SHORT, "--frames", "f", "--every", "4", "--pictures",
                         "quality,interface")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        pictures = [name for name in self.files() if name.endswith(".svg")]
        self.assertEqual(len(pictures), 3)
        root = xml.parse(os.path.join(self.folder, "f", pictures[0])).getroot()
        self.assertTrue(root.tag.endswith("svg"))


if __name__ == "__main__":
    unittest.main()
