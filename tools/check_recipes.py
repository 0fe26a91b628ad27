#!/usr/bin/env python3
"""Checks that adding something touches as few files as docs/architecture.md says, by examples that do it.

usage: check_recipes.py [--build]

docs/design/recipes/NAME.patch adds a quadric, a bounding volume, or a question of the command. Each must apply to the
sources as they are, and touch no more files of the library and the command than its recipe says. With --build all three
are built into a copy of the sources, in build/recipes, and their tests run.
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from weakened_tree import QUICK_OPTIONS

ROOT = pathlib.Path(__file__).resolve().parent.parent
PATCHES = ROOT / "docs/design/recipes"
CODE = ("include/", "src/", "apps/")
COPIED = ["apps", "cmake", "examples", "include", "src", "tests", "tools", "docs", "CMakeLists.txt", "CMakePresets.json", "toccata"]

# How many files of code each may touch.
RECIPES = {"quadric": 3, "volume": 2, "question": 4}

ROUND = """{"format": "toccata-scene", "version": 1, "objects": [
  {"name": "crate", "shape": {"type": "box", "half_extents": [1, 1, 1]}},
  {"name": "egg", "shape": %s, "pose": {"translation": [3, 1, 0.5]}}]}"""


def patch_of(name):
    return PATCHES / f"{name}.patch"


def touched(name):
    """The files that the patch makes or changes."""
    lines = patch_of(name).read_text().splitlines()
    return [line.removeprefix("+++ b/") for line in lines if line.startswith("+++ b/")]


def copy_sources(folder):
    """In place of what an earlier run left there; only what changed is compiled again."""
    for name in COPIED:
        source = ROOT / name
        if source.is_dir():
            shutil.rmtree(folder / name, ignore_errors=True)
            shutil.copytree(source, folder / name, ignore=shutil.ignore_patterns("node_modules", "__pycache__"))
        else:
            shutil.copy2(source, folder / name)


def applied(name, folder):
    """The complaint of a patch that does not fit, or None."""
    # A copy within the repository is no part of it.
    alone = {**os.environ, "GIT_CEILING_DIRECTORIES": str(folder.parent)}
    run = subprocess.run(["git", "apply", patch_of(name)], cwd=folder, env=alone, capture_output=True, text=True)
    return f"{patch_of(name).relative_to(ROOT)} does not apply any more: make it anew\n{run.stderr}" if run.returncode else None


def check_count(name):
    most = RECIPES[name]
    code = [file for file in touched(name) if file.startswith(CODE)]
    print(f"{name}: {len(code)} files of code ({', '.join(code)}), {len(touched(name)) - len(code)} beside them")
    if len(code) > most:
        yield f"{name}: touches {len(code)} files of code, and at most {most} are wanted"


def check_quick():
    for name in RECIPES:
        yield from check_count(name)
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            for file in filter(lambda file: (ROOT / file).exists(), touched(name)):
                (folder / file).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(ROOT / file, folder / file)
            if complaint := applied(name, folder):
                yield complaint


def distance_to_egg(folder, command, shape):
    """What the report says of the crate and the egg."""
    scene = folder / "round.json"
    scene.write_text(ROUND % shape)
    run = subprocess.run([command, "distance", scene, "--json"], capture_output=True, text=True, check=True)
    return json.loads(run.stdout)["pairs"]


def check_built():
    folder = ROOT / "build/recipes"
    folder.mkdir(parents=True, exist_ok=True)
    copy_sources(folder)
    complaints = [complaint for name in RECIPES if (complaint := applied(name, folder))]
    if complaints:
        yield from complaints
        return
    out = folder / "build/release"
    tests = {"test_narrow": "Quadric*", "test_io": "SceneFile*", "test_bounds": "EveryVolume/13.*", "test_reports": "Extent.*"}
    for words in [["cmake", "--preset", "release", *QUICK_OPTIONS],
                  ["cmake", "--build", out, "--target", "toccata_command", *tests],
                  *[[out / "tests" / test, f"--gtest_filter={names}"] for test, names in tests.items()]]:
        if subprocess.run(words, cwd=folder).returncode != 0:
            yield f"recipes: {' '.join(map(str, words))} fails"
            return
    command = out / "apps/toccata/toccata"
    spheroid = distance_to_egg(folder, command, '{"type": "spheroid", "radius": 0.5, "half_height": 1}')
    if spheroid != distance_to_egg(folder, command, '{"type": "ellipsoid", "half_axes": [0.5, 0.5, 1]}'):
        yield "quadric: a spheroid is not as far away as the ellipsoid that it is"
    if subprocess.run([command, "extent", folder / "round.json"]).returncode != 0:
        yield "question: the command does not answer it"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", action="store_true")
    options = parser.parse_args()
    complaints = list(check_quick()) + (list(check_built()) if options.build else [])
    for complaint in complaints:
        print(complaint)
    print(f"recipes: {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
