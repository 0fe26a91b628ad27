#!/usr/bin/env python3
"""Runs clang-tidy with the checks of .clang-tidy over what build/clang compiles: all files with --all, otherwise those
changed since main (or since the last commit, on main). Units that include CGAL are left out: they take minutes each.
"""
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/clang"


def compiled():
    entries = json.loads((BUILD / "compile_commands.json").read_text())
    files = {pathlib.Path(entry["file"]).resolve() for entry in entries}
    return {f for f in files if not f.is_relative_to(ROOT / "build") and "_cgal_" not in f.name}


def changed():
    def git(*words):
        return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True).stdout.split()
    base = git("merge-base", "HEAD", "main") or ["HEAD"]
    if base == git("rev-parse", "HEAD"):
        base = ["HEAD~1"]
    return {ROOT / name for name in git("diff", "--name-only", base[0])}


def tidy(file):
    return subprocess.run(["clang-tidy", "-p", BUILD, "--quiet", file], capture_output=True, text=True)


def main():
    files = sorted(compiled() if "--all" in sys.argv else compiled() & changed())
    bad = 0
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        for file, run in zip(files, pool.map(tidy, files)):
            if run.returncode != 0:
                bad += 1
                print(f"{file.relative_to(ROOT)}:\n{run.stdout}", flush=True)
    print(f"tidy: {len(files)} files, {bad} with complaints")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
