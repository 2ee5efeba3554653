# SPDX-License-Identifier: MIT
"""The command line of dsc_scene: runs that are interrupted and resumed, and the files they write."""
import csv
import json
import os
import resource
import signal
import stat
import subprocess
import time
import unittest
import xml.etree.ElementTree as xml

from command_line import HARD, SCENE, SHORT, PROMPTLY, VERIFY, CommandLine


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

    def endless(self, *arguments, prepare=None):
        # A translation: for shapes that are stretched, computing the exact shape would take too long.
        return subprocess.Popen([SCENE, "run", "translation", "--set", "h=0.02", "--set",
                                 "steps=1000000", *arguments], stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE, text=True, cwd=self.folder,
                                preexec_fn=prepare)

    def wait_for(self, name):
        for _ in range(10 * PROMPTLY):
            if os.path.exists(self.path(name)):
                return
            time.sleep(0.1)

    def test_what_was_left_out_is_told(self):
        with open(self.path("small.toml"), "w", encoding="utf-8") as stream:
            stream.write("[options]\nh = 0.1\ndt = 0.1\nsteps = 1\n[[shape]]\n"
                         "rectangle = { low = [0.5, 0.5], high = [0.52, 0.52] }\n")
        done = self.call("run", "small.toml", "--json", "r.json")
        self.assertIn("\n  1 shape was left out as too small", done.stdout)
        with open(self.path("r.json"), encoding="utf-8") as stream:
            told = json.load(stream)["input"]
        self.assertEqual((told["points"], told["thinned"], told["dropped"], told["clipped"]), (4, 0, 1, 0))
        self.assertAlmostEqual(told["area_dropped"], 4e-4)

    def test_an_interruption_writes_a_checkpoint(self):
        # A terminal that closes often sends two SIGHUP: one by itself, one by the shell.
        for signals in ((signal.SIGHUP, signal.SIGHUP), (signal.SIGTERM,)):
            with self.endless("--checkpoint", "c", "--json", "r.json") as process:
                time.sleep(1)
                for number in signals:
                    process.send_signal(number)
                _, errors = process.communicate(timeout=PROMPTLY)
            self.assertEqual(process.returncode, 1, errors)
            self.assertIn("run --resume c", errors)
        with open(self.path("r.json"), encoding="utf-8") as stream:
            part = json.load(stream)
        self.assertTrue(part["partial"])
        after = str(part["steps"] + 2)
        self.assertEqual(self.result("--resume", "c", "--stop-after", after, code=1)["steps"],
                         part["steps"] + 2)

    def test_what_is_ignored_stays_so(self):
        """Signals that are ignored at the start, as under nohup or in the background of a script, stay
        ignored."""
        def ignore():
            for number in (signal.SIGHUP, signal.SIGINT):
                signal.signal(number, signal.SIG_IGN)

        with self.endless("--checkpoint", "c", prepare=ignore) as process:
            time.sleep(1)
            process.send_signal(signal.SIGHUP)
            process.send_signal(signal.SIGINT)
            with self.assertRaises(subprocess.TimeoutExpired):
                process.wait(timeout=1)
            process.kill()

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
        self.expect_refusal("run", "--resume", "c", words=["c: not a file of kind"], code=(1,))
        self.expect_refusal("run", "--resume", "none", words=["none", "cannot be read"], code=(1,))

    def test_a_file_that_may_not_grow_ends_the_run_with_a_sentence(self):
        limits = (4096, 4096)  # bytes
        done = subprocess.run([SCENE, "run", "swirl", *SHORT, "--checkpoint", "c"],
                              cwd=self.folder, text=True, capture_output=True, check=False,
                              timeout=PROMPTLY,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, limits))
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr, "dsc_scene: c: writing failed: File too large\n")
        self.assertEqual(os.listdir(self.folder), [])


class Destinations(CommandLine):
    """Output files: where results go, and that no output overwrites another file of the same call."""
    program = SCENE
    RUN = ["run", "mine.toml", "--set", "steps=2"]

    def setUp(self):
        super().setUp()
        os.mkdir(self.path("folder"))
        for name, text in (("mine.toml", "[options]\nh = 0.1\ndt = 0.1\nsteps = 9\n[[shape]]\n"
                                         "file = 'shape.txt'\n"),
                           ("shape.txt", "0.3 0.3\n0.7 0.3\n0.5 0.7\n"), ("old", "here before")):
            with open(self.path(name), "w", encoding="utf-8") as stream:
                stream.write(text)
        os.symlink("old", self.path("link"))
        os.link(self.path("old"), self.path("folder/other-name"))
        os.symlink("new", self.path("dangling"))

    def read(self, name):
        with open(self.path(name), encoding="utf-8") as stream:
            return stream.read()

    def test_two_outputs_of_one_file(self):
        for one, other in (("a", "a"), ("a", "./folder/../a"), ("old", "link"), ("new", "dangling"),
                           ("old", "folder/other-name")):
            self.expect_refusal(*self.RUN, "--json", one, "--series", other,
                                words=["--series", "--json", other])
        for option in ("--json", "--events", "--series", "--edits"):
            self.expect_refusal(*self.RUN, option, "a", "--checkpoint", "a",
                                words=["--checkpoint", option])
        self.expect_refusal(*self.RUN, "--frames", "a", "--json", "a", words=["--json", "--frames"])
        self.assertEqual(self.read("old"), "here before")

    def test_an_output_over_an_input(self):
        for name in ("mine.toml", "shape.txt"):
            before = self.read(name)
            for option in ("--json", "--events", "--series", "--edits", "--checkpoint"):
                self.expect_refusal(*self.RUN, option, f"./{name}", words=[option, "the scene"])
            self.assertEqual(self.read(name), before)

    def test_a_checkpoint_is_an_input_and_goes_on(self):
        stopped = [*self.RUN, "--checkpoint", "c", "--stop-after", "1"]
        self.assertEqual(self.call(*stopped).returncode, 1)
        self.expect_refusal("run", "--resume", "c", "--json", "c", words=["--json", "--resume"])
        done = self.call("run", "--resume", "c", "--checkpoint", "./c")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_an_output_over_the_file_of_standard_output(self):
        for stream in ("stdout", "stderr"):
            with open(self.path("all"), "w", encoding="utf-8") as file:
                done = subprocess.run([SCENE, *self.RUN, "--json", "all"], cwd=self.folder,
                                      check=False, **{stream: file})
            self.assertEqual(done.returncode, 2)

    def test_streams_may_be_named_twice_and_are_not_replaced(self):
        os.mkfifo(self.path("pipe"))
        reader = os.open(self.path("pipe"), os.O_RDWR)  # waits for nobody
        self.addCleanup(os.close, reader)
        done = self.call(*self.RUN, "--json", "pipe", "--series", "/dev/stdout", "--edits",
                         "/dev/stdout")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(json.loads(os.read(reader, 65536))["steps"], 2)
        for word in ("interface_length", "dsc edits", "2 steps"):
            self.assertIn(word, done.stdout)
        self.assertTrue(stat.S_ISFIFO(os.stat(self.path("pipe")).st_mode))
        with open(self.path("all"), "w", encoding="utf-8") as file:
            done = subprocess.run([SCENE, *self.RUN, "--series", "/dev/stdout"], cwd=self.folder,
                                  check=False, stdout=file)
        self.assertEqual(done.returncode, 0)
        self.assertIn("interface_length", self.read("all"))
        self.assertIn("2 steps", self.read("all"))

    def test_what_cannot_be_written_is_refused_before_the_run(self):
        longest = "n" * 256
        for option in ("--json", "--events", "--series", "--edits", "--checkpoint"):
            for path in ("", longest, "none/file", "old/file", "folder", "folder/", "/proc/file"):
                self.expect_refusal(*self.RUN, option, path, words=[option, "allowed"])
        for path in ("", longest, "old", "/proc"):
            self.expect_refusal(*self.RUN, "--frames", path, words=["--frames", "allowed"])

    def test_standard_output(self):
        for program in (SCENE, VERIFY, HARD):
            calls = [["list"], ["--help"]]
            if program == SCENE:
                calls += [["describe", "swirl"], self.RUN]
            for call in calls:
                with open("/dev/full", "w", encoding="utf-8") as full:
                    done = subprocess.run([program, *call], cwd=self.folder, check=False, text=True,
                                          stdout=full, stderr=subprocess.PIPE)
                self.assertEqual(done.returncode, 1, call)
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertIn("standard output", done.stderr)
        # A reader that closes the pipe early is no error.
        done = subprocess.run(f"{SCENE} list | head -1", shell=True, check=True,
                              capture_output=True, text=True)
        self.assertEqual((done.stdout.count("\n"), done.stderr), (1, ""))


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
