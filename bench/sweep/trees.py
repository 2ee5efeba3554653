# SPDX-License-Identifier: MIT
"""The sources and the builds of the commits that a table names.

"." is the working tree, built in build/release as always; its label names its last commit and, if
there are changes since, a digest of them, so that results of yesterday's changes are not taken for
today's. Any other commit is built once, in a git worktree of its own under build/sweep/commits."""
import dataclasses
import hashlib
import os
import subprocess

from errors import SweepError

DESCRIBE = ("describe", "--always", "--dirty=+", "--abbrev=10")  # as lib/scenes/CMakeLists.txt does
FOLDER = "build/sweep/commits"


@dataclasses.dataclass(frozen=True)
class Tree:
    label: str
    commit: str
    described: str
    source: str
    build: str
    native: bool
    is_working_tree: bool


def git(folder, *words, check=True):
    done = subprocess.run(["git", "-C", folder, *words], capture_output=True, check=False,
                          stdin=subprocess.DEVNULL)
    if done.returncode != 0:
        if not check:
            return None
        raise SweepError(f"git {' '.join(words)} in {folder} ended with {done.returncode}: "
                         f"{done.stderr.decode(errors='replace').strip()}")
    return done.stdout


def changes(root):
    """Digest of what differs from the last commit; empty where nothing does."""
    difference = git(root, "diff", "HEAD", "--binary")
    others = git(root, "ls-files", "--others", "--exclude-standard", "-z").split(b"\0")[:-1]
    if not difference and not others:
        return ""
    digest = hashlib.sha256(difference)
    for name in others:
        digest.update(name + b"\0")
        path = os.path.join(root.encode(), name)
        if os.path.isfile(path):
            with open(path, "rb") as stream:
                digest.update(hashlib.sha256(stream.read()).digest())
    return digest.hexdigest()[:8]


def find(name, root, native):
    """The tree that a table calls `name`; nothing is built yet."""
    if name == ".":
        if git(root, "rev-parse", "HEAD", check=False) is None:
            return Tree("unknown", "", "", root, os.path.join(root, "build/release"), native, True)
        commit = git(root, "rev-parse", "HEAD").decode().strip()
        changed = changes(root)
        build = "build/release" if native else "build/sweep/portable"
        return Tree(commit[:12] + (f"-{changed}" if changed else ""), commit,
                    git(root, *DESCRIBE).decode().strip(), root, os.path.join(root, build), native,
                    True)
    found = git(root, "rev-parse", "--verify", "--quiet", f"{name}^{{commit}}", check=False)
    if found is None:
        raise SweepError(f"no such commit: got '{name}'; allowed: a commit, tag or branch of this "
                         "repository, or . for the working tree")
    commit = found.decode().strip()
    folder = os.path.join(root, FOLDER, commit[:12])
    return Tree(commit[:12], commit, git(root, *DESCRIBE[:2], DESCRIBE[3], commit).decode().strip(),
                os.path.join(folder, "source"),
                os.path.join(folder, "build" if native else "portable"), native, False)


def prepare(tree, root, targets, commands, say):
    """Checks the sources out, builds the targets, and runs the commands that have to come first."""
    if not tree.is_working_tree and not os.path.isdir(tree.source):
        say(f"checking out {tree.label}")
        git(root, "worktree", "prune")
        git(root, "worktree", "add", "--force", "--detach", tree.source, tree.commit)
    if targets:
        say(f"building {', '.join(sorted(targets))} of {tree.label}")
        _call(["cmake", *_options(tree)], tree.source)
        _call(["cmake", "--build", tree.build, "--parallel",
               os.environ.get("DSC_JOBS") or str(os.cpu_count()), "--target", *sorted(targets)],
              tree.source)
    for command in commands:
        say(f"first: {' '.join(command)}")
        _call(command, tree.source)


def _options(tree):
    """Those of cmake to configure a build, again where there is one: then it names today's commit."""
    native = f"DSC_NATIVE={'ON' if tree.native else 'OFF'}"
    if os.path.exists(os.path.join(tree.build, "CMakeCache.txt")):
        return [tree.build, "-D", native]  # with what else somebody has chosen for it
    options = ["--preset", "release", "-B", tree.build, "-D", native]
    launcher = os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER")
    if launcher:
        options += ["-D", f"CMAKE_CXX_COMPILER_LAUNCHER={launcher}"]
    # A warning of this compiler is of no interest in an old commit.
    return options if tree.is_working_tree else [*options, "-D", "DSC_STRICT=OFF"]


def _call(command, folder):
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False,
                              stdin=subprocess.DEVNULL)
    except OSError as error:
        raise SweepError(f"{command[0]} cannot be run: {error.strerror}") from error
    if done.returncode != 0:
        last = "\n".join((done.stdout + done.stderr).splitlines()[-30:])
        raise SweepError(f"{' '.join(command)} in {folder} ended with {done.returncode}:\n{last}")
