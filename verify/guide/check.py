# SPDX-License-Identifier: MIT
"""Checks of a page: each returns a list of what is wrong, in sentences that begin with the place."""
import os
import re
import subprocess
import sys

from blocks import commands, is_part_of, without_times

# Programs that the text names without a folder, and where they are built.
PROGRAMS = {"dsc_scene": "lib/scenes", "dsc_bench": "bench", "dsc_precision": "bench",
            "dsc_verify": "verify", "dsc_hard": "verify"}
# What makes a command within the text short: it is checked that it is taken, not what comes out.
SHORT = {"dsc_scene run": "--set h=0.03 --set steps=2",
         "dsc_bench": "--benchmark_list_tests=true"}
SOURCE_LANGUAGES = ("cpp", "cmake", "toml")
COMMAND_LANGUAGES = ("sh", "console")
ROOMS = ("lib", "verify", "bench", "plots", "reference")
LONGEST = 60  # seconds


def bare(language, lines):
    """A source without the licence and the description at its top."""
    comment = "//" if language == "cpp" else "#"
    first = next((i for i, line in enumerate(lines) if not line.startswith(comment)), len(lines))
    return lines[first:] if language in ("cpp", "cmake") else lines


def sources(page, root):
    """Blocks of a language that is compiled or read are parts of files."""
    problems = []
    for block in page.blocks:
        if block.language not in SOURCE_LANGUAGES:
            continue
        if not block.mark.startswith("from "):
            problems.append(f"{block.where}: no comment `from FILE` above this block")
            continue
        path = os.path.join(root, block.mark.removeprefix("from "))
        if not os.path.exists(path):
            problems.append(f"{block.where}: there is no file {block.mark[5:]}")
            continue
        with open(path, encoding="utf-8") as stream:
            source = bare(block.language, stream.read().splitlines())
        if not is_part_of(block.text, source):
            problems.append(f"{block.where}: differs from {block.mark[5:]}")
    return problems


def run(words, folder):
    """The exit code and what was printed."""
    # The interpreter that runs this can import matplotlib; the first on PATH may not.
    words = re.sub(r"^python3\b", sys.executable, words)
    paths = [os.path.join(folder, "build/release", room) for room in sorted(set(PROGRAMS.values()))]
    environment = {**os.environ, "PATH": os.pathsep.join([*paths, os.environ["PATH"]]),
                   "OMP_WAIT_POLICY": "passive", "MPLBACKEND": "Agg"}
    done = subprocess.run(["bash", "-c", words], cwd=folder, env=environment, check=False,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          timeout=LONGEST)
    return done.returncode, done.stdout, done.stderr


def is_built(words, folder):
    name = os.path.basename(words.split()[0])
    return name not in PROGRAMS or os.path.exists(
        os.path.join(folder, "build/release", PROGRAMS[name], name))


def shown_commands(page, folder):
    """The commands of the blocks, run in `folder`: what they print is what is shown."""
    problems = []
    for block in page.blocks:
        if block.language not in COMMAND_LANGUAGES or block.mark.startswith("not run: "):
            continue
        extra = block.mark.removeprefix("run with ") if block.mark else ""
        for command in commands(block):
            if not is_built(command.words, folder):
                continue
            words = f"{command.words} {extra}" if "dsc_scene run" in command.words else command.words
            code, printed, errors = run(words, folder)
            if code != 0:
                problems.append(f"{block.where}: `{words}` ended with {code}: {errors.strip()}")
            elif command.output is not None:
                expected = [without_times(line) for line in command.output]
                if not is_part_of(expected, without_times(printed).splitlines()):
                    problems.append(f"{block.where}: `{words}` printed something else:\n{printed}")
    return problems


def commands_in_text(page, file, folder):
    """Commands between backquotes are taken by the programs; each is run once, and briefly."""
    problems = []
    before = {}
    for number, span in page.spans:
        if span.startswith("... "):  # goes on from the command before it
            span = before.get("command", "") + span.removeprefix("...")
        name = next((each for each in SHORT if span.startswith(each + " ")), None)
        if name is None:
            continue
        before["command"] = span
        if not is_built(span, folder):
            continue
        code, _, errors = run(f"{span} {SHORT[name]}", folder)
        if code not in (0, 1):  # 1: so few steps are so long that vertices did not arrive
            problems.append(f"{file}:{number}: `{span}` ended with {code}: {errors.strip()}")
    return problems


def paths(page, file, root):
    """Files that are named or linked to exist."""
    problems = []
    for number, span in page.spans:
        if re.fullmatch(rf"({'|'.join(ROOMS)})/[\w./-]+", span) and not os.path.exists(
                os.path.join(root, span)):
            problems.append(f"{file}:{number}: there is no {span}")
    folder = os.path.dirname(os.path.join(root, file))
    for number, link in page.links:
        if "://" not in link and not os.path.exists(os.path.join(folder, link)):
            problems.append(f"{file}:{number}: there is no {link}")
    return problems


def recipes(page, file, root):
    """In a row of a table that names a recipe, the other code is in that recipe."""
    problems = []
    for number, spans in page.rows:
        recipe = next((span for span in spans if span.startswith("verify/recipes/")), None)
        if recipe is None:
            continue
        with open(os.path.join(root, recipe), encoding="utf-8") as stream:
            source = stream.read()
        for span in spans:
            pattern = re.escape(span).replace(re.escape("..."), ".*")
            if span != recipe and not re.search(pattern, source, re.DOTALL):
                problems.append(f"{file}:{number}: {recipe} does not hold {span}")
    return problems
