# SPDX-License-Identifier: MIT
"""Checks of a page: each returns a list of faults, as sentences that begin with the place."""
import os
import re
import subprocess
import sys

from blocks import commands, is_part_of, without_times

# Programs that pages name without a folder, and the folders where they are built.
PROGRAMS = {"dsc_scene": "lib/scenes", "dsc_bench": "bench", "dsc_precision": "bench",
            "dsc_verify": "verify", "dsc_hard": "verify"}
PLACEHOLDER = re.compile(r"\b[A-Z]{3,}\b")  # in a command of the text: FILE, SCENE
SOURCE_LANGUAGES = ("cpp", "cmake", "toml", "python")
COMMAND_LANGUAGES = ("sh", "console")
ROOMS = ("lib", "verify", "bench", "plots", "reference")
LONGEST = 300  # seconds: a build without optimisation, on a machine with other work


def bare(language, lines):
    """The lines of a source file without the licence and the description at its top."""
    comment = "//" if language == "cpp" else "#"
    first = next((i for i, line in enumerate(lines) if not line.startswith(comment)), len(lines))
    return lines[first:] if language in ("cpp", "cmake", "python") else lines


def sources(page, root):
    """Blocks in a language that is compiled or parsed must be parts of files."""
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
    """Runs a command and returns its exit code and output."""
    # Uses this interpreter, which can import matplotlib; the first on PATH may not.
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
    """Runs the commands of the blocks in `folder`; they must print what the page shows."""
    problems = []
    for block in page.blocks:
        if block.language not in COMMAND_LANGUAGES or block.mark.startswith("not run: "):
            continue
        if block.mark and not block.mark.startswith("run with "):
            problems.append(f"{block.where}: not understood: {block.mark}")
            continue
        extra = block.mark.removeprefix("run with ")
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


def briefly(words):
    """A short command that shows whether the program accepts these arguments; None if the text is no command,
    or a command that always takes long."""
    program, *rest = words.split()
    program = os.path.basename(program)
    if program == "dsc_scene" and rest:
        if rest[0] == "run" and "--resume" not in rest:
            return f"{words} --set h=0.03 --set steps=2"
        return words
    if program == "dsc_bench" and rest:
        return f"{words} --benchmark_list_tests=true"
    if program == "dsc_verify" and rest[:1] == ["run"]:
        # Only checks, groups and scenes are looked up, not files and values of options.
        names = [name for word in rest[1:] for name in word.split(",")
                 if not word.startswith("--") and not word.endswith(".toml") and not word.isdigit()]
        return " && ".join(f"{program} list | grep -qw {name}" for name in names) or None
    return None


def commands_in_text(page, file, folder):
    """The programs must accept the commands between backquotes."""
    problems = []
    last = ""
    for number, span in page.spans:
        if span.startswith("... "):  # an argument that continues the command before it
            span = last + span.removeprefix("...")
        words = None if PLACEHOLDER.search(span) else briefly(span)
        if words is None:
            continue
        last = span
        if not is_built(span, folder):
            continue
        code, _, errors = run(words, folder)
        if code != 0 and not (code == 1 and "run" in words and "dsc_scene" in words):
            # A scene ends with code 1 if steps were so long that vertices did not arrive.
            problems.append(f"{file}:{number}: `{span}` ended with {code}: {errors.strip()}")
    return problems


def paths(page, file, root):
    """Files that are named or linked to must exist."""
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


def rooms(page, file, root):
    """The rooms of the library may include only rooms above them in the table."""
    problems = []
    above = []
    for number, spans in page.rows:
        room = spans[0] if spans and re.fullmatch(r"lib/dsc/\w+", spans[0]) else None
        if room is None:
            continue
        above.append(room)
        for folder, _, names in os.walk(os.path.join(root, room)):
            for name in names:
                with open(os.path.join(folder, name), encoding="utf-8") as stream:
                    included = re.findall(r'#include "(dsc/\w+)/', stream.read())
                problems += [f"{file}:{number}: {room}, {name} includes {other}"
                             for other in included if f"lib/{other}" not in above]
    return problems


def public_headers(root, module):
    """The public headers: MODULE/MODULE.h, for the core also dsc/engine.h, and all headers that these
    include."""
    found = [f"{module}/{module}.h"] + (["dsc/engine.h"] if module == "dsc" else [])
    for header in found:
        with open(os.path.join(root, "lib", header), encoding="utf-8") as stream:
            found += [other for other in re.findall(r'#include "([^"]+)"', stream.read())
                      if other not in found]
    return found


def modules(root, names):
    """Each of `names`, the core first, may include only its own headers and public headers of those before it."""
    problems = []
    for at, module in enumerate(names):
        allowed = {header for other in names[:at] for header in public_headers(root, other)}
        for folder, _, files in os.walk(os.path.join(root, "lib", module)):
            for name in (name for name in files if name.endswith((".h", ".cpp"))):
                with open(os.path.join(folder, name), encoding="utf-8") as stream:
                    included = re.findall(r'#include "([^"]+)"', stream.read())
                problems += [f"lib/{module}: {name} includes {other}" for other in included
                             if not other.startswith(f"{module}/") and other not in allowed]
    return problems
