# SPDX-License-Identifier: MIT
"""Sweeps in a plain loop: each run once, failures named, timed runs alone, machines and commits
apart."""
import json
import os
import signal
import subprocess
import time
import unittest

from tests.support import Project

# Writes what the file `answer` beside the table says, or fails with it.
SOME = '''
[[run]]
name = "some"
command = ["bash", "-c", """
echo word {i}; [ {i} != 3 ] || {{ cat answer >&2; exit 7; }}; echo '[{i}]' > {out}/result.json"""]
with = { i = [1, 2, 3, 4] }
accept = [0]
'''
# When each began and ended, by its own clock.
WATCHED = '''
[[run]]
name = "beside"
command = ["python3", "-S", "-c", """
import json, time
began = time.monotonic(); time.sleep(0.1)
json.dump([began, time.monotonic()], open('{out}/result.json', 'w'))"""]
with = { i = [1, 2, 3, 4] }
[[run]]
name = "alone"
command = ["python3", "-S", "-c", """
import json, time
began = time.monotonic(); time.sleep(0.1)
json.dump([began, time.monotonic()], open('{out}/result.json', 'w'))"""]
timed = true
repeats = 3
'''

CMAKE = '''#!/bin/sh
echo "$@" >> "$CMAKE_LOG"
[ "$1" = --build ] || exit 0
program=$2/lib/scenes/dsc_scene
mkdir -p "$2/lib/scenes"
printf '#!/bin/sh\\nfor last; do :; done\\necho "{\\\\"commit\\\\": \\\\"%s\\\\"}" > $last\\n' \\
    "$(git describe --always --dirty=+ --abbrev=10)" > "$program"
chmod +x "$program"
'''


def overlapping(records):
    """Pairs of runs that ran at the same time, one of them timed."""
    return [(a["what"], b["what"]) for a in records for b in records
            if a is not b and a["identity"].get("timed")
            and a["result"][0] < b["result"][1] and b["result"][0] < a["result"][1]]


def is_running(pid):
    """Whether there is such a process, and it has not ended."""
    try:
        with open(f"/proc/{pid}/stat", encoding="utf-8") as stream:
            return stream.read().rpartition(")")[2].split()[0] not in "ZX"
    except OSError:
        return False


class Plain(unittest.TestCase):
    def setUp(self):
        self.project = Project(self)

    def run_some(self, *options, answer="something is wrong"):
        (self.project.root / "answer").write_text(answer + "\n")
        self.project.table(SOME)
        return self.project.sweep("--plain", *options)

    def test_a_failed_run_is_named_and_the_others_go_on(self):
        done = self.run_some()
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertIn("failed: some: i=3\n  exit code 7\n  ", done.stdout)
        self.assertIn("bash -c 'echo word 3;", done.stdout)
        self.assertIn("\n  | something is wrong\n", done.stdout)
        self.assertIn("3 done (0 of them before), 1 failed, 0 not run", done.stdout)
        found = self.project.results()
        self.assertEqual(sorted(r["result"][0] for r in found.values()), [1, 2, 4])
        failed, = self.project.results(".failed.json").values()
        self.assertEqual((failed["exit_code"], failed["problem"]), (7, "exit code 7"))
        self.assertEqual(failed["last_words"],
                         {"stdout": ["word 3"], "stderr": ["something is wrong"]})

    def test_the_command_that_is_named_can_be_typed(self):
        self.run_some()
        failed, = self.project.results(".failed.json").values()
        done = subprocess.run(["bash", "-c", failed["again"]], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (7, "something is wrong\n"))
        other = next(iter(self.project.results().values()))
        done = subprocess.run(["bash", "-c", other["again"]], capture_output=True)
        self.assertEqual(done.returncode, 0)

    def test_nothing_is_run_twice(self):
        self.run_some()
        before = self.project.results()
        done = self.run_some()
        self.assertEqual(done.returncode, 1)  # what has failed is named again
        self.assertIn("exit code 7", done.stdout)
        self.assertIn("4 runs in table, 0 due", done.stdout)
        self.assertEqual(set(self.project.begun().values()), {1})
        self.assertEqual(self.project.results(), before)

    def test_failed_runs_are_run_again_when_asked(self):
        self.run_some()
        done = self.run_some("--retry-failed", answer="still wrong")
        self.assertEqual(done.returncode, 1)
        self.assertIn("| still wrong", done.stdout)
        self.assertEqual(sorted(self.project.begun().values()), [1, 1, 1, 2])
        self.project.table(SOME.replace("accept = [0]", "accept = [0, 7]"))
        done = self.project.sweep("--plain", "--retry-failed")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(self.project.results(".failed.json"), {})

    def test_results_are_below_machine_and_commit_by_their_key(self):
        self.run_some()
        for path, record in self.project.results().items():
            self.assertEqual(path, f"here/unknown/{record['key']}.json")
            for key in ("command", "again", "begun", "ended", "wall_s", "cpu_s", "machine",
                        "identity"):
                self.assertIn(key, record)
        self.assertEqual(sorted(os.listdir(self.project.out / "here")),
                         ["attempts.log", "running", "unknown"])
        self.assertEqual(os.listdir(self.project.out / "here/running"), [])

    def test_another_machine_has_results_of_its_own(self):
        self.run_some()
        self.project.environment["DSC_SWEEP_MACHINE"] = "There, 8 cores"
        done = self.run_some()
        self.assertIn("3 done (0 of them before)", done.stdout)
        names = {path.split("/")[0] for path in self.project.results()}
        self.assertEqual(names, {"here", "there-8-cores"})

    def test_half_a_file_of_a_killed_sweep_is_no_result(self):
        self.run_some()
        path = next(iter(self.project.results()))
        whole = self.project.out / path
        whole.rename(f"{whole}.123.part")
        self.assertIn("3 done (2 of them before)", self.run_some().stdout)

    def test_timed_runs_are_alone(self):
        self.project.table(WATCHED)
        done = self.project.sweep("--plain", "--jobs", "4")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        found = list(self.project.results().values())
        self.assertEqual(len(found), 7)
        self.assertEqual(overlapping(found), [])

    def start(self, table, *options):
        return subprocess.Popen(self.project.words("--plain", *options, table=table),
                                stdout=subprocess.DEVNULL, env=self.project.environment)

    def test_timed_runs_are_alone_beside_another_sweep(self):
        beside, alone = WATCHED.split("[[run]]")[1:]
        self.project.table("[[run]]" + beside.replace("1, 2, 3, 4", str(list(range(12)))[1:-1]))
        self.project.table("[[run]]" + alone, "alone.toml")
        first = self.start("table.toml", "--jobs", "1")
        while not self.project.results():
            time.sleep(0.01)
        self.assertEqual((self.start("alone.toml").wait(), first.wait()), (0, 0))
        found = list(self.project.results().values())
        self.assertEqual(len(found), 12 + 3)
        self.assertEqual(overlapping(found), [])

    def test_two_sweeps_of_one_table_run_each_once(self):
        self.project.table('[[run]]\nname = "a"\ncommand = ["sleep", "0.3"]\n'
                           'with = {i = [1, 2, 3, 4]}\n')
        both = [self.start("table.toml", "--jobs", "2") for _ in range(2)]
        self.assertEqual([process.wait() for process in both], [0, 0])
        self.assertEqual(list(self.project.begun().values()), [1] * 4)

    def test_runs_of_several_cores(self):
        self.project.table(WATCHED.replace('name = "beside"', 'name = "beside"\ncores = 2'))
        self.project.sweep("--plain", "--jobs", "2")
        found = [r for r in self.project.results().values() if r["row"] == "beside"]
        times = sorted(r["result"] for r in found)
        self.assertTrue(all(a[1] <= b[0] for a, b in zip(times, times[1:])), times)

    def test_an_interrupted_sweep_leaves_whole_results_and_goes_on(self):
        self.project.table('[[run]]\nname = "a"\ncommand = ["bash", "-c", "sleep {s} & '
                           'echo $! > pid{s}; wait"]\nwith = {s = [0.01, 30]}\n')
        process = subprocess.Popen(self.project.words("--plain", "--jobs", "2"), text=True,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                   env=self.project.environment)
        other = self.project.root / "pid30"
        while len(self.project.results()) < 1 or not other.exists() or \
                not other.read_text().strip():
            time.sleep(0.02)
        process.send_signal(signal.SIGTERM)
        self.assertIn("interrupted", process.communicate()[1])
        self.assertEqual(process.returncode, 130)
        self.assertEqual(len(self.project.results()), 1)
        self.assertEqual(self.project.results(".failed.json"), {})
        self.assertEqual(os.listdir(self.project.out / "here/running"), [])
        self.assertFalse(is_running(int(other.read_text())))  # nor what the run had started

    def test_what_else_makes_a_run_fail(self):
        self.project.table("".join(
            f'[[run]]\nname = "r{k}"\ncommand = {json.dumps(command)}\n{more}\n'
            for k, (command, more) in enumerate((
                (["sleep", "20"], "timeout = 0.2"), (["no-such-program"], ""),
                (["bash", "-c", "kill -SEGV $$"], ""),
                (["bash", "-c", "echo '[1' > {out}/result.json"], ""),
                (["true"], 'files = ["no-such-file"]')))))
        done = self.project.sweep("--plain")
        self.assertEqual(done.returncode, 1)
        problems = {r["row"]: r["problem"] for r in self.project.results(".failed.json").values()}
        for row, words in (("r0", "was stopped after 0.2 s"), ("r1", "no such program"),
                           ("r2", "SIGSEGV"), ("r3", "not whole JSON"), ("r4", "left no file")):
            self.assertIn(words, problems[row])
        self.assertEqual(done.stdout.count("\nfailed: "), 5)

    def test_files_are_kept_with_the_result(self):
        self.project.table('[[run]]\nname = "a"\ncommand = ["bash", "-c", "echo text > x.txt; '
                           'mkdir {out}/sub; echo 1 > {out}/sub/y.json"]\nfiles = ["x.txt"]\n')
        self.assertEqual(self.project.sweep("--plain").returncode, 0)
        record, = self.project.results().values()
        self.assertEqual(record["files"], {"x.txt": "text\n", "sub/y.json": 1})


class Scenes(unittest.TestCase):
    """With a program in place of dsc_scene that writes its arguments, in a repository."""

    def setUp(self):
        self.project = Project(self)
        self.git("init", "-q")
        (self.project.root / ".gitignore").write_text("build/\nout/\n__pycache__/\n*.lock\n")
        self.project.table('[[run]]\nscene = "swirl"\nset = {h = [0.1, 0.2]}\n')
        self.commit()

    def git(self, *words):
        done = subprocess.run(["git", "-C", self.project.root, "-c", "user.name=a", "-c",
                               "user.email=a@example.org", *words], check=True, capture_output=True)
        return done.stdout.decode().strip()

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-qm", "some")
        self.program(self.git("describe", "--always", "--dirty=+", "--abbrev=10"))

    def program(self, commit):
        path = self.project.root / "build/release/lib/scenes/dsc_scene"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text('#!/bin/sh\nfor last; do :; done\n'
                        f'echo "{{\\"commit\\": \\"{commit}\\"}}" > $last\n')
        path.chmod(0o755)

    def test_a_result_belongs_to_its_commit(self):
        self.assertEqual(self.project.sweep("--plain").returncode, 0)
        first = set(self.project.results())
        (self.project.root / "new").write_text("")
        self.commit()
        done = self.project.sweep("--plain")
        self.assertIn("2 done (0 of them before)", done.stdout)
        self.assertEqual(len(self.project.results()), 4)
        self.assertLess(first, set(self.project.results()))
        self.assertEqual(len({path.split("/")[1] for path in self.project.results()}), 2)

    def test_changes_that_are_not_committed_are_another_commit(self):
        (self.project.root / "new").write_text("one")
        self.project.sweep("--plain")
        (self.project.root / "new").write_text("two")
        self.assertIn("(0 of them before)", self.project.sweep("--plain").stdout)
        self.assertIn("(2 of them before)", self.project.sweep("--plain").stdout)

    def test_a_program_of_another_commit_is_refused(self):
        self.program("0123456789")
        done = self.project.sweep("--plain")
        self.assertEqual(done.returncode, 1)
        self.assertIn("the program was built from 0123456789, not ", done.stdout)

    def build_by_stand_in(self):
        """A cmake that notes what it is asked for, and the program that it makes names its commit."""
        folder = self.project.root / "build/bin"
        folder.mkdir()
        (folder / "cmake").write_text(CMAKE)
        (folder / "cmake").chmod(0o755)
        log = self.project.root / "build/cmake.log"
        self.project.environment.update(PATH=f"{folder}:{os.environ['PATH']}", CMAKE_LOG=str(log),
                                        DSC_JOBS="3")
        self.project.environment.pop("CMAKE_CXX_COMPILER_LAUNCHER", None)
        return log

    def sweep_and_build(self):
        words = [word for word in self.project.words("--plain") if word != "--no-build"]
        return subprocess.run(words, capture_output=True, text=True, env=self.project.environment)

    def test_programs_are_built_before_the_runs(self):
        log = self.build_by_stand_in()
        build = self.project.root / "build/release"
        target = f"--build {build} --parallel 3 --target dsc_scene"
        for name, options in (("one", f"--preset release -B {build} -D DSC_NATIVE=ON"),
                              ("two", f"{build} -D DSC_NATIVE=ON")):  # with what was chosen for it
            self.project.table(f'[[run]]\nscene = "swirl"\nset = {{name = "{name}"}}\n')
            self.commit()
            log.unlink(missing_ok=True)
            self.assertEqual(self.sweep_and_build().returncode, 0)
            self.assertEqual(log.read_text().splitlines(), [options, target])
            (build / "CMakeCache.txt").write_text("")

    def test_each_commit_is_checked_out_and_built_once(self):
        (self.project.root / "new").write_text("")
        self.commit()
        log = self.build_by_stand_in()
        hashes = self.git("rev-parse", "HEAD", "HEAD~1").splitlines()
        commits = json.dumps(hashes)
        for h in ("0.1, 0.2", "0.1, 0.2, 0.3"):
            self.project.table(f'[[run]]\nscene = "swirl"\nset = {{h = [{h}]}}\n'
                               f'commit = {commits}\n')
            done = self.sweep_and_build()
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("6 done (4 of them before)", done.stdout)
        for path, record in self.project.results().items():
            label = path.split("/")[1]
            self.assertTrue(label.startswith(record["result"]["commit"]), label)
        folders = sorted((self.project.root / "build/sweep/commits").iterdir())
        self.assertEqual([folder.name for folder in folders], sorted(h[:12] for h in hashes))
        self.assertEqual([(folder / "source/new").exists() for folder in folders],
                         [folder.name == hashes[0][:12] for folder in folders])
        self.assertEqual(log.read_text().count("--build"), 4)  # the later ones have nothing to do

    def test_a_commit_that_is_not_there(self):
        self.project.table('[[run]]\nscene = "swirl"\ncommit = "no-such-tag"\n')
        done = self.project.sweep("--plain")
        self.assertEqual(done.returncode, 2)
        self.assertIn("no such commit: got 'no-such-tag'", done.stderr)


if __name__ == "__main__":
    unittest.main()
