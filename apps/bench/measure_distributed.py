#!/usr/bin/env python3
"""Boxes over ranks of MPI: what a step takes on one and on two ranks, what is sent, and what a model foretells.

usage: measure_distributed.py TOCCATA_BENCH_RANKS [--small] [--evidence FILE]

Prints the tables of toccata-bench-ranks (docs/design/distributed.md), each with its command, and with --evidence writes them to
the file, too. --small takes a hundredth of the boxes. Exits with 1 where a run fails, as where answers differ.
"""
import argparse
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"}
# (ranks, boxes, other words)
RUNS = (
    (2, 2_000_000, "--scale --frames 3 --scene uniform"),
    (2, 2_000_000, "--scale --frames 3 --scene clustered"),
    (2, 2_000_000, "--frames 3 --questions 0 --scene uniform"),
    (2, 2_000_000, "--frames 3 --questions 0 --moving 0.01 --scene uniform --scene clustered"),
    (2, 1_000_000, "--frames 1 --scene uniform --questions 20000"),
    (2, 20_000, ""),
    (8, 50_000, ""),
    (8, 400_000, "--scale --frames 3 --scene uniform"),
)


def commit():
    words = subprocess.run(["git", "rev-parse", "--short=12", "HEAD"], cwd=ROOT, capture_output=True, text=True, check=False)
    return words.stdout.strip() or "unknown"


def main():
    parser = argparse.ArgumentParser(prog="toccata bench distributed", description="Boxes over ranks of MPI.")
    parser.add_argument("program", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--small", action="store_true", help="a hundredth of the boxes")
    parser.add_argument("--evidence", type=pathlib.Path, metavar="FILE", help="write the tables there, too, once all runs have passed")
    options = parser.parse_args()
    text = f"Written by `./toccata bench distributed`, commit {commit()}, {os.cpu_count()} processors.\n"
    for ranks, boxes, words in RUNS:
        count = boxes // 100 if options.small else boxes
        shown = f"mpirun -np {ranks} toccata-bench-ranks --count {count} {words}".rstrip()
        print(f"\n$ {shown}", flush=True)
        run = subprocess.run(["mpirun", "-np", str(ranks), options.program, "--count", str(count), *words.split()], env={**os.environ, **MPI}, stdout=subprocess.PIPE, text=True, check=False)
        print(run.stdout, end="", flush=True)
        if run.returncode != 0:
            return 1
        text += f"\n$ {shown}\n{run.stdout}"
    if options.evidence:
        options.evidence.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
