#!/usr/bin/env python3
"""Runs clang-tidy with the checks of .clang-tidy over what build/clang compiles: all of it with --all, otherwise the
units with a file that changed since main (or since the last commit, on main). A unit is a united piece or a file that
stays alone (cmake/ToccataUnite.cmake); to clang-tidy the files of a piece are what headers are. Units that include CGAL
are left out: they take minutes each.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/clang"


def sources_of(unit):
    """The files of ours that a unit compiles; none of one that CMake wrote for itself."""
    if not unit.is_relative_to(ROOT / "build"):
        return {unit}
    included = [pathlib.Path(name) for name in re.findall(r'^#include "(.*)"', unit.read_text(), re.MULTILINE)]
    return {file for file in included if file.suffix == ".cpp"}


def units():
    entries = json.loads((BUILD / "compile_commands.json").read_text())
    of_unit = {file: sources_of(file) for file in {pathlib.Path(entry["file"]).resolve() for entry in entries} if file.is_file()}
    return {unit: files for unit, files in of_unit.items() if files and not any("_cgal_" in file.name for file in files)}


def changed():
    def git(*words):
        return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True).stdout.split()
    base = git("merge-base", "HEAD", "main") or ["HEAD"]
    if base == git("rev-parse", "HEAD"):
        base = ["HEAD~1"]
    return {ROOT / name for name in git("diff", "--name-only", base[0])}


def tidy(unit):
    return subprocess.run(["clang-tidy", "-p", BUILD, "--quiet", unit], capture_output=True, text=True)


def main():
    of_unit = units()
    asked = sorted(of_unit) if "--all" in sys.argv else sorted(unit for unit, files in of_unit.items() if files & changed())
    bad = 0
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        for unit, run in zip(asked, pool.map(tidy, asked)):
            if run.returncode != 0:
                bad += 1
                print(f"{unit.relative_to(ROOT)}:\n{run.stdout}", flush=True)
    print(f"tidy: {len(asked)} units of {sum(len(of_unit[unit]) for unit in asked)} files, {bad} with complaints")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
