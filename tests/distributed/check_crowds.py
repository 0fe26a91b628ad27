#!/usr/bin/env python3
"""What toccata-crowd-ranks and toccata-bench-ranks tell: the same pairs on any number of ranks, bytes within the bound,
and a model that is right about what it can be right about, the counts.

check_crowds.py MPIEXEC TOCCATA_CROWD_RANKS TOCCATA_BENCH_RANKS TOCCATA
"""
import re
import subprocess
import sys

TROUBLE = []


def check(is_right, what, output=""):
    if not is_right:
        TROUBLE.append(f"{what}\n{output}")


def run(mpiexec, ranks, *words, code=0):
    done = subprocess.run([mpiexec, "-np", str(ranks), *words], capture_output=True, text=True, check=False)
    check(done.returncode == code, f"{words} on {ranks} ranks: exit code {done.returncode}", done.stdout + done.stderr)
    return done.stdout if code == 0 else done.stderr


def rows(output, heading, first):
    """The rows that begin so below a heading, by its words; a row ends where the next does not begin so."""
    lines = output.splitlines()
    begin = next((i for i, line in enumerate(lines) if re.search(heading, line)), None)
    found = []
    for line in lines[begin + 1:] if begin is not None else []:
        if not re.match(first, line):
            break
        found.append([float(word) if re.fullmatch(r"-?[\d.]+", word) else word for word in line.split()])
    return found


def check_crowd(mpiexec, crowd, command):
    pairs = set()
    for ranks in (1, 2, 3):
        output = run(mpiexec, ranks, crowd, "--count", "1000", "--frames", "3", "--scene", "fast")
        table = rows(output, "^rank ", r" +\d")
        check(len(table) == ranks and sum(row[3] for row in table) == 1000, f"bodies on {ranks} ranks", output)
        pairs.update(re.findall(r"^(\d+) pairs in contact$", output, re.MULTILINE))
    output = run(mpiexec, 2, command, "crowd", "--distributed", "--count", "1000", "--frames", "3", "--scene", "fast")
    pairs.update(re.findall(r"^(\d+) pairs in contact$", output, re.MULTILINE) or ["none by --distributed"])
    check(len(pairs) == 1 and pairs.pop() > "0", f"pairs differ: {pairs}")
    check("--moving" in run(mpiexec, 1, crowd, "--moving", "2", code=2), "--moving 2 is told")


def check_bench(mpiexec, bench):
    output = run(mpiexec, 2, bench, "--count", "300", "--frames", "2", "--questions", "40", "--moving", "0.5")
    steps, parts = rows(output, "^scene +ms a step", "[a-z]"), rows(output, "^scene +changes", "[a-z]")
    check(len(steps) == 8 and len(parts) == 8, "eight scenes", output)
    for step, part in zip(steps, parts):
        check(all(seconds >= 0 for seconds in part[1:8]) and sum(part[1:7]) > 0, f"times of {step[0]}", output)
        check((step[0] == "static" or 0 < part[9]) and part[9] <= part[10] <= 100, f"bytes of {step[0]} are within their bound", output)
    check(len(rows(output, "^scene +one rank alone", "[a-z]")) == 8, "nearest boxes of eight scenes", output)
    check(len(rows(output, "^scene +divided by", "[a-z]")) >= 8, "eight scenes are divided", output)


def check_scale(mpiexec, bench):
    output = run(mpiexec, 4, bench, "--scale", "--count", "4000", "--frames", "2")
    measured, foretold = rows(output, "^ *ranks +bodies", r" +\d"), rows(output, "^ *bodies +ranks", r" +\d")
    check([row[0] for row in measured] == [1, 2, 4], "1, 2 and 4 ranks", output)
    check([row[:2] for row in foretold] == [[1e8, 64], [1e8, 1024], [1e9, 1024]], "64 and 1,024 ranks", output)
    if TROUBLE:
        return
    check([row[1] for row in measured] == [4000, 2000, 1000], "bodies a rank", output)
    check(0 < foretold[0][3] < foretold[1][3] < measured[2][2] < 20, "ghosts grow with the surface of a part", output)
    check(all(0 < row[6] < 100 for row in foretold), "a step is more than one World's", output)
    both = run(mpiexec, 1, bench, "--scale", "--count", "1000", "--frames", "1", "--scene", "fast", "sizes")
    check(re.findall(r"^(\w+), 1000 boxes", both, re.MULTILINE) == ["fast", "sizes"], "each scene that is named", both)
    check("--questions" in run(mpiexec, 1, bench, "--scale", "--questions", "5", code=2), "questions are not asked with --scale")
    check("--scale" in run(mpiexec, 1, bench, "--latency", "5", code=2), "a network is assumed with --scale alone")


def main():
    mpiexec, crowd, bench, command = sys.argv[1:]
    check_crowd(mpiexec, crowd, command)
    check_bench(mpiexec, bench)
    check_scale(mpiexec, bench)
    print("\n".join(TROUBLE) or "crowds over ranks are what they should be")
    return 1 if TROUBLE else 0


if __name__ == "__main__":
    sys.exit(main())
