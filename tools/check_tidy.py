#!/usr/bin/env python3
"""Runs clang-tidy with the checks of .clang-tidy over what build/clang compiles: all of it with --all, otherwise the
units with a file that changed since main (or since the last commit, on main). A unit is a united piece or a file that
stays alone (cmake/ToccataUnite.cmake); to clang-tidy the files of a piece are what headers are. Units that include CGAL
are left out: they take minutes each.

build/clang has to be configured, and not built: its pieces are written anew here, since files may have come and gone, and only
the precompiled headers are needed, and made here. A unit without complaints is not looked at again until it, a header of ours that it includes, its command or the checks change, so that
this may be stopped and goes on where it was.
"""
import concurrent.futures
import functools
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/clang"
STAMPS = BUILD / ".tidy"
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
PRECOMPILED = re.compile(r"-include-pch -Xclang (\S+)")
FOLDER = re.compile(r"-I(\S+)")


def sources_of(unit):
    """The files of ours that a unit compiles; none of one that CMake wrote for itself."""
    if not unit.is_relative_to(ROOT / "build"):
        return {unit}
    included = [pathlib.Path(name) for name in re.findall(r'^#include "(.*)"', unit.read_text(), re.MULTILINE)]
    return {file for file in included if file.suffix == ".cpp"}


def compile_commands():
    """{unit: its command}."""
    entries = json.loads((BUILD / "compile_commands.json").read_text())
    return {pathlib.Path(entry["file"]).resolve(): entry["command"] for entry in entries}


def units(commands):
    of_unit = {file: sources_of(file) for file in commands if file.is_file()}
    return {unit: files for unit, files in of_unit.items() if files and not any("_cgal_" in file.name for file in files)}


def changed():
    def git(*words):
        return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True).stdout.split()
    base = git("merge-base", "HEAD", "main") or ["HEAD"]
    if base == git("rev-parse", "HEAD"):
        base = ["HEAD~1"]
    return {ROOT / name for name in git("diff", "--name-only", base[0])}


def make_precompiled_headers(commands, units, pool):
    """Those of the units that are not there. By their own commands: to ninja they depend on half of the library."""
    wanted = {BUILD / name for unit in units for name in PRECOMPILED.findall(commands[unit])}
    missing = [commands[header.with_suffix(".cxx").resolve()] for header in wanted if not header.exists()]
    for made in pool.map(lambda command: subprocess.run(shlex.split(command), cwd=BUILD), missing):
        made.check_returncode()


@functools.cache
def content(file):
    return file.read_bytes()


@functools.cache
def included(file, folders):
    """The files of ours that a file includes itself; what is not found in the folders is not ours."""
    names = INCLUDE.findall(content(file).decode(errors="replace"))
    places = ([place / name for place in (file.parent, *folders)] for name in names)
    found = ((p.resolve() for p in place if p.is_file()) for place in places)
    return [file for file in (next(files, None) for files in found) if file]


def stamp_of(unit, command, tool):
    """Named by all that the outcome depends on but the headers of the system."""
    folders = tuple(pathlib.Path(name) for name in FOLDER.findall(command) if pathlib.Path(name).is_relative_to(ROOT))
    known, new = set(), {unit}
    while new:
        known |= new
        new = {other for file in new for other in included(file, folders)} - known
    digest = hashlib.sha256(f"{tool}\0{command}".encode())
    for file in sorted(known):
        digest.update(str(file).encode() + b"\0" + content(file))
    return STAMPS / digest.hexdigest()


def tidy(unit, stamp):
    """What there is to complain of."""
    # That is what pieces are.
    less = ["--checks=-bugprone-suspicious-include"] if unit.is_relative_to(BUILD) else []
    run = subprocess.run(["clang-tidy", "-p", BUILD, "--quiet", *less, unit], capture_output=True, text=True)
    if run.returncode == 0:
        stamp.touch()
        return ""
    return run.stdout or run.stderr


def main():
    subprocess.run(["cmake", BUILD], check=True, stdout=subprocess.DEVNULL)
    commands = compile_commands()
    of_unit = units(commands)
    asked = sorted(of_unit) if "--all" in sys.argv else sorted(unit for unit, files in of_unit.items() if files & changed())
    tool = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout + (ROOT / ".clang-tidy").read_text()
    stamps = {unit: stamp_of(unit, commands[unit], tool) for unit in asked}
    new = [unit for unit in asked if not stamps[unit].exists()]
    STAMPS.mkdir(exist_ok=True)
    bad = 0
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        make_precompiled_headers(commands, new, pool)
        for unit, said in zip(new, pool.map(tidy, new, (stamps[unit] for unit in new))):
            if said:
                bad += 1
                print(f"{unit.relative_to(ROOT)}:\n{said}", flush=True)
    print(f"tidy: {len(asked)} units of {sum(len(of_unit[unit]) for unit in asked)} files, {len(asked) - len(new)} of them known, {bad} with complaints")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
