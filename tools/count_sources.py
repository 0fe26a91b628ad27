#!/usr/bin/env python3
"""Counts the library's source, room by room: the table of sizes in docs/design/house.md.

usage: count_sources.py [COMMIT…]

Lines of code are the lines of src/ and include/ that are neither blank nor only a comment. Of public headers (include/)
their number is told, and that of the structures, classes and enumerations at the scope of a namespace in all of them
(tools/check_layering.py tells how many of these toccata.hpp brings). Without a commit, what is committed last.
"""
import argparse
import collections
import io
import pathlib
import subprocess
import tarfile

from check_layering import TYPE

ROOT = pathlib.Path(__file__).resolve().parent.parent
ALL = "all"


def sources(commit):
    """(path, text) of each file of the library."""
    packed = subprocess.run(["git", "archive", commit, "src", "include"], cwd=ROOT, check=True, capture_output=True).stdout
    with tarfile.open(fileobj=io.BytesIO(packed)) as archive:
        for member in archive:
            if member.isfile() and member.name.endswith((".hpp", ".cpp")):
                yield pathlib.PurePath(member.name), archive.extractfile(member).read().decode()


def room_of(path):
    parts = path.parts[2:] if path.parts[0] == "include" else path.parts[1:]
    return parts[0] if len(parts) > 1 else "umbrellas"


def is_code(line):
    return bool(line.strip()) and not line.strip().startswith("//")


def counted(commit):
    """Lines of code by room, and what is counted of all."""
    code, told, types = collections.Counter(), collections.Counter(), set()
    for path, text in sources(commit):
        lines = sum(map(is_code, text.splitlines()))
        code[room_of(path)] += lines
        code[ALL] += lines
        told["lines"] += text.count("\n")
        if path.parts[0] == "include":
            told["public headers"] += 1
            types.update(TYPE.findall(text))
    told["public types"] = len(types)
    return code, told


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("commits", nargs="*", default=["HEAD"], metavar="COMMIT")
    commits = parser.parse_args().commits
    columns = [counted(commit) for commit in commits]
    rooms = sorted({room for code, _ in columns for room in code if room != ALL})
    print(f"{'lines of code':16}", *(f"{commit[:10]:>10}" for commit in commits))
    for room in [*rooms, ALL]:
        print(f"{room:16}", *(f"{code[room]:10,}" for code, _ in columns))
    for what in columns[0][1]:
        print(f"{what:16}", *(f"{told[what]:10,}" for _, told in columns))


if __name__ == "__main__":
    main()
