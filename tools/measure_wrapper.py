#!/usr/bin/env python3
"""What ./toccata itself costs: the first build of the command in a fresh clone, and what a call adds when nothing changed.

`tools/measure_wrapper.py [--calls N]` prints both; the figures in docs/guide/benchmarks.md were made by it. The build is
without ccache, and with as many jobs as ninja chooses. Processor time is printed too, because it does not depend on what
else the machine does.
"""
import argparse
import os
import pathlib
import resource
import statistics
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def timed(words, **options):
    """Wall seconds and processor seconds of a program that must succeed."""
    start, used = time.monotonic(), processor_seconds()
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL, **options)
    return time.monotonic() - start, processor_seconds() - used


def measure_build(clone):
    wall, used = timed([clone / "toccata", "build"], env={**os.environ, "CCACHE_DISABLE": "1"})
    print(f"first build of the command: {wall:.0f} s, {used:.0f} s of processor time, on {os.cpu_count()} cores")


def measure_calls(clone, count):
    """The two kinds of call in turn, so that both see the same load."""
    direct, wrapped = [], []
    for _ in range(count):
        direct.append(timed([clone / "build/release/apps/toccata/toccata", "--version"])[0])
        wrapped.append(timed([clone / "toccata", "--version"])[0])
    added = statistics.median(wrapped) - statistics.median(direct)
    print(f"a call when nothing changed: {1000 * added:.0f} ms more than the command's own, median of {count}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--calls", type=int, default=50)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        clone = pathlib.Path(folder) / "toccata"
        subprocess.run(["git", "clone", "--quiet", ROOT, clone], check=True)
        measure_build(clone)
        measure_calls(clone, options.calls)


if __name__ == "__main__":
    main()
