# SPDX-License-Identifier: MIT
"""The README and the guide are true: tests compile the programs they show, their commands run and print what
is shown, and the files they name exist."""
import filecmp
import os
import shutil
import subprocess
import tempfile
import unittest

import check
from blocks import read_page

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BUILD = os.environ["DSC_BUILD"]
GUIDE = os.path.join(ROOT, "lib", "guide")
FILES = ["README.md"] + sorted(f"lib/guide/{name}" for name in os.listdir(GUIDE)
                               if name.endswith(".md"))
# A module comes after those that it uses.
MODULES = ["dsc3", "fluid", "geometric_flows", "replay", "surface_files", "thesis", "topology"]
FILES += [f"lib/{module}/README.md" for module in MODULES]


def read(file):
    with open(os.path.join(ROOT, file), encoding="utf-8") as stream:
        return read_page(file, stream.read())


def scratch_folder(test):
    """Makes a folder that looks like the root of the repository to a command, and receives the files that the
    command writes."""
    folder = tempfile.mkdtemp()
    test.addCleanup(shutil.rmtree, folder)
    for room in check.ROOMS:
        os.symlink(os.path.join(ROOT, room), os.path.join(folder, room))
    os.mkdir(os.path.join(folder, "build"))
    os.symlink(BUILD, os.path.join(folder, "build", "release"))
    return folder


class Pages(unittest.TestCase):
    def check(self, problems):
        self.assertEqual(problems, [], "\n".join(problems))

    def test_programs_are_those_that_are_compiled(self):
        for file in FILES:
            self.check(check.sources(read(file), ROOT))

    def test_files_exist(self):
        for file in FILES:
            self.check(check.paths(read(file), file, ROOT))

    def test_rooms_include_only_those_above(self):
        page = read("README.md")
        self.assertGreater(sum(spans[:1] == ["lib/dsc/base"] for _, spans in page.rows), 0)
        self.check(check.rooms(page, "README.md", ROOT))

    def test_scenes_are_of_the_catalogue(self):
        program = os.path.join(BUILD, "lib", "scenes", "dsc_scene")
        if not os.path.exists(program):
            self.skipTest("dsc_scene is not built")
        done = subprocess.run([program, "list"], check=True, capture_output=True, text=True)
        names = {line.split()[0] for line in done.stdout.splitlines()}
        rows = [set(spans) for _, spans in read("README.md").rows if names & set(spans)]
        self.assertGreaterEqual(len(rows), 10)
        self.check([f"there is no scene {name}" for row in rows for name in row - names])

    def test_modules_are_written_as_an_application_is(self):
        self.check(check.modules(ROOT, ["dsc", *MODULES]))
        self.assertNotEqual(check.modules(ROOT, [*MODULES, "dsc"]), [])

    def test_pictures_are_what_the_library_draws(self):
        program = os.path.join(BUILD, "lib", "guide", "dsc_guide_pictures")
        if not os.path.exists(program):
            self.skipTest("dsc_guide_pictures is not built")
        folder = scratch_folder(self)
        subprocess.run([program, folder], check=True)
        kept = os.path.join(GUIDE, "pictures")
        names = sorted(os.listdir(kept))
        self.assertEqual([n for n in sorted(os.listdir(folder)) if n.endswith(".svg")], names)
        _, differing, missing = filecmp.cmpfiles(folder, kept, names, shallow=False)
        self.assertEqual(differing + missing, [])

    def test_commands_do_what_is_shown(self):
        for file in FILES:
            with self.subTest(file=file):
                self.check(check.shown_commands(read(file), scratch_folder(self)))

    def test_commands_in_the_text_are_taken(self):
        for file in FILES:
            with self.subTest(file=file):
                self.check(check.commands_in_text(read(file), file, scratch_folder(self)))


if __name__ == "__main__":
    unittest.main()
