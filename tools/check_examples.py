#!/usr/bin/env python3
"""Checks that every program in examples/ compiles without a warning, runs, and prints what is beside it.

usage: check_examples.py --prefix DIR --compiler CXX [--write] [NAME…]

DIR is where the library is installed. What examples/NAME.cpp prints must be examples/NAME.txt, in which … stands for
anything within a line. With --write the text is made anew.
"""
import argparse
import concurrent.futures
import os
import pathlib
import subprocess
import sys
import tempfile

from check_docs import ROOT, Checker, matches

EXAMPLES = ROOT / "examples"


def compiled(checker, name, folder):
    """The complaint of the compiler, or None."""
    source = EXAMPLES / f"{name}.cpp"
    flags = ["-std=c++20", "-Wall", "-Wextra", "-Werror", *checker.first(source.read_text())]
    command = [checker.compiler, *flags, source, "-o", folder / name, *checker.flags]
    run = subprocess.run(command, capture_output=True, text=True)
    return None if run.returncode == 0 else f"examples/{name}.cpp does not compile\n{run.stderr}"


def check(checker, name, folder, write):
    complaint = compiled(checker, name, folder)
    if complaint:
        return complaint
    run = subprocess.run([folder / name], cwd=folder, capture_output=True, text=True)
    if run.returncode != 0:
        return f"examples/{name}.cpp ends with status {run.returncode}\n{run.stdout}{run.stderr}"
    expected = EXAMPLES / f"{name}.txt"
    if write:
        expected.write_text(run.stdout)
    elif not expected.exists() or not matches(expected.read_text(), run.stdout):
        return f"examples/{name}.cpp prints something else than examples/{name}.txt says:\n{run.stdout}"
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--prefix", type=pathlib.Path, required=True)
    parser.add_argument("--compiler", default="c++")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    names = options.names or sorted(p.stem for p in EXAMPLES.glob("*.cpp"))
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        folder = pathlib.Path(name)
        checker = Checker(options.prefix, options.compiler, folder)
        complaints = [c for c in pool.map(lambda n: check(checker, n, folder, options.write), names) if c]
    for complaint in complaints:
        print(complaint)
    print(f"examples: {len(names)} programs, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
