#!/usr/bin/env python3
"""What toccata-check-ranks writes, on several ranks, is what the command writes on one process, to the byte.

check_ranks.py MPIEXEC RANKS TOCCATA TOCCATA_CHECK_RANKS
"""
import pathlib
import random
import subprocess
import sys
import tempfile

FACES = ((1, 3, 2), (2, 3, 4), (5, 6, 7), (6, 8, 7), (1, 2, 5), (2, 6, 5), (3, 7, 4), (4, 7, 8), (1, 5, 3), (3, 5, 7),
         (2, 4, 6), (4, 8, 6))


def write_box(path, lower, upper):
    lines = [f"v {(lower, upper)[i & 1][0]} {(lower, upper)[i >> 1 & 1][1]} {(lower, upper)[i >> 2][2]}" for i in range(8)]
    lines += ["f " + " ".join(map(str, face)) for face in FACES]
    path.write_text("\n".join(lines) + "\n")


def write_boxes(folder):
    numbers = random.Random(3)
    files = []
    for i in range(30):
        lower = [numbers.uniform(0, 4) for _ in range(3)]
        upper = [at + numbers.uniform(0.3, 1.5) for at in lower]
        files.append(folder / f"part{i}" / "box.obj")  # all of one name
        files[-1].parent.mkdir()
        write_box(files[-1], lower, upper)
    return [str(file) for file in files]


def run(*words):
    return subprocess.run(words, capture_output=True, text=True, check=False)


def main():
    mpiexec, ranks, command, over_ranks = sys.argv[1:]
    launch = [mpiexec, "-np", ranks, over_ranks]
    trouble = []
    with tempfile.TemporaryDirectory() as folder:
        files = write_boxes(pathlib.Path(folder))
        for options in ([], ["--clearance", "0.3"], ["--penetration", "--volume"], ["--touching", "ignore", "--solid", "none"]):
            one, many = run(command, "check", *files, *options, "--csv"), run(*launch, *files, *options)
            if one.stdout != many.stdout or one.returncode != many.returncode or not one.stdout.count("\n") > 9:
                trouble.append(f"{options}: exit codes {one.returncode} and {many.returncode}, {len(one.stdout)} and "
                               f"{len(many.stdout)} bytes\n{many.stderr}")
        broken = pathlib.Path(folder) / "broken.obj"
        broken.write_text("v 0 0 zero\n")
        many = run(*launch, *files, str(broken))
        if many.returncode != 2 or many.stderr.count("broken.obj") != 1 or many.stdout:
            trouble.append(f"a broken file: exit code {many.returncode}\n{many.stderr}")
        for words, told in (([*files, "--clearance", "nan"], "--clearance"), ([*files, "--threads", "-3"], "--threads"), (files[:1], "a check needs two")):
            many = run(*launch, *words)
            if many.returncode != 2 or many.stderr.count(told) != 1 or many.stdout:
                trouble.append(f"{words[-2:]}: exit code {many.returncode}\n{many.stderr}")
    print("\n".join(trouble) or f"{ranks} ranks write the same bytes")
    return 1 if trouble else 0


if __name__ == "__main__":
    sys.exit(main())
