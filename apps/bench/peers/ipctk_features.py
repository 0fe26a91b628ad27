#!/usr/bin/env python3
"""Asks ipctk's continuous collision detection when features that move meet. Called by toccata-bench.

usage: ipctk_features.py QUESTIONS ANSWERS ROUNDS

QUESTIONS has a line each: vertex-face or edge-edge, and 24 numbers, the four points at the start and then at the end. ANSWERS
becomes JSON: of each method its name, what a call for a vertex and a face that rest apart costs from Python (floor_ns), and of each
question whether it is a hit, and the least time of so many rounds, in nanoseconds.
"""
import importlib.metadata
import json
import sys
import time

import ipctk
import numpy

SHORT = 10_000  # what takes less nanoseconds is repeated


def question_of(line):
    kind, *numbers = line.split()
    points = numpy.array([float.fromhex(n) for n in numbers]).reshape(8, 3)
    return kind, [numpy.ascontiguousarray(p) for p in points]


def nanoseconds(call, points, repetitions):
    start = time.perf_counter_ns()
    for _ in range(repetitions):
        call(*points)
    return (time.perf_counter_ns() - start) / repetitions


def answer(method, kind, points, rounds):
    call = method.point_triangle_ccd if kind == "vertex-face" else method.edge_edge_ccd
    hit = bool(call(*points)[0])
    repetitions = 16 if nanoseconds(call, points, 1) < SHORT else 1
    return {"hit": hit, "ns": min(nanoseconds(call, points, repetitions) for _ in range(rounds))}


def main():
    questions = [question_of(line) for line in open(sys.argv[1])]
    rounds = int(sys.argv[3])
    apart = [numpy.array(p, dtype=float) for p in [[0, 0, 9], [0, 0, 0], [1, 0, 0], [0, 1, 0]] * 2]
    found = []
    for name, method in [("Tight Inclusion", ipctk.TightInclusionCCD()), ("additive CCD", ipctk.AdditiveCCD())]:
        found.append({"name": name, "floor_ns": answer(method, "vertex-face", apart, 200)["ns"],
                      "answers": [answer(method, kind, points, rounds) for kind, points in questions]})
    with open(sys.argv[2], "w") as file:
        json.dump({"version": importlib.metadata.version("ipctk"), "methods": found}, file)


main()
