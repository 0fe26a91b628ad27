#!/usr/bin/env python3
"""Two builds of toccata-bench beside each other: is any row of the benchmarks slower than it was?

compare_benchmarks.py OLD NEW [--only TEXT] [--repeat N]: runs the same questions by both programs in turns, N times (5),
and prints for each row the least of its medians, old and new, and how many times as long the new one takes; rows beyond
1.05 are marked. Rows are compared in their order, so both programs must know the same ones. Only Toccata is measured;
run it on a machine that does nothing else.
"""
import argparse
import itertools
import json
import subprocess
import sys

KNOT, SPHERE = "gen:torus-knot", "gen:noise-sphere?subdivisions=5"
CONVEX = ["hull", "box", "sphere", "sphere-box", "sphere-triangle", "sphere-capsule", "capsule", "capsule-box", "cylinder-box", "cone-box", "ellipsoid"]
MESHES = f"--mesh-a {KNOT} --mesh-b {SPHERE}"


def suite():
    """The command lines, without the program."""
    yield "triangle"
    for pair, task, regime in itertools.product(CONVEX, ["overlap", "distance"], ["far", "near", "deep", "coherent"]):
        yield f"convex --pair {pair} --task {task} --regime {regime}"
    for pair, task in itertools.product(["hull", "box", "cylinder-box", "cone-box", "ellipsoid"], ["penetration", "manifold"]):
        yield f"convex --pair {pair} --task {task} --regime deep --count 500"
    for pair, regime in itertools.product(["ray-cylinder", "ray-cone", "ray-ellipsoid", "cylinder-box", "cone-box", "ellipsoid"], ["hit", "graze", "miss"]):
        yield f"casts --pair {pair} --regime {regime} --count 1000"
    for task, near in itertools.product(["overlap", "contacts", "distance"], ["", " --near"]):
        yield f"mesh {MESHES} --random 200 --task {task}{near}"
    yield f"mesh {MESHES} --random 10 --task coherent-distance"
    yield f"mesh {MESHES} --random 10 --task build"
    for mesh in [KNOT, SPHERE]:
        yield f"rays --mesh {mesh} --count 20000"
        yield f"self --mesh {mesh}"
        yield f"refit --mesh {mesh}"
        yield f"nearest --mesh {mesh} --where near --count 20000"
        yield f"nearest --mesh {mesh} --where far --count 20000"
    for task in ["box", "pairs"]:
        yield f"partitions --mesh {KNOT} --task {task} --queries 500"
    for scene in ["uniform", "clustered", "sizes", "static", "terrain", "fast"]:
        yield f"broad --scene {scene} --count 10000 --frames 20"
    yield "world --count 10000 --frames 10 --threads 1"
    yield "parts --count 3000"
    for asked in ["ray", "nearest", "overlap", "cast", "cast --shape hull", "cast --shape cylinder"]:
        yield f"world-queries --task {asked} --bodies 10000 --count 2000"
    yield "sums --count 300"
    yield "sums --task point --count 300"
    yield f"decompose --mesh {KNOT}"


def rows(program, words):
    """What one run measured: names of the rows, and their times."""
    run = subprocess.run([program, *words.split(), "--json"], capture_output=True, text=True)
    if run.returncode != 0:
        raise SystemExit(f"{program} {words}: exit code {run.returncode}\n{run.stderr}")
    times = {}
    for row in json.loads(run.stdout)["results"]:
        time = next((row[key] for key in ["median_ns", "median_us", "median_ms", "seconds"] if key in row), None)
        times[f"{row.get('variant', '')} {row.get('task', '')}".strip()] = time
    return times


def compare(old, new, words, repeat):
    """Prints a line for each row; returns those that are slower."""
    least = [{}, {}]
    for turn in range(repeat):
        for side, program in [(0, old), (1, new)][:: 1 if turn % 2 == 0 else -1]:
            for i, (name, time) in enumerate(rows(program, words).items()):
                if time:
                    known = least[side].get(i, (name, time))
                    least[side][i] = (name, min(known[1], time))
    slower = []
    for i in sorted(least[0].keys() & least[1].keys()):
        ratio = least[1][i][1] / least[0][i][1]
        line = f"{least[0][i][1]:12.4f} {least[1][i][1]:12.4f} {ratio:6.3f}{' SLOWER' if ratio > 1.05 else '       '} {words}: {least[1][i][0]}"
        print(line, flush=True)
        if ratio > 1.05:
            slower.append(line)
    return slower


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--only", default="")
    parser.add_argument("--repeat", type=int, default=5)
    options = parser.parse_args()
    slower = [line for words in suite() if options.only in words for line in compare(options.old, options.new, words, options.repeat)]
    print(f"{len(slower)} rows are slower by more than a twentieth")
    return 1 if slower else 0


if __name__ == "__main__":
    sys.exit(main())
