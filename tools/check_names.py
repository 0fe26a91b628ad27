#!/usr/bin/env python3
"""Checks that no two definitions of the library share a qualified name.

usage: check_names.py [--compiler CXX]

The rule is that the library compiles as one piece: all files of src/ are included into one translation unit, in which
two types, functions or constants of one qualified name are errors, also those of anonymous namespaces. So no two object
files can hold different things of one name (the one-definition rule), any files may share a piece of a united build,
and a name that one meets means one thing. Files compiled once for each SIMD level are included for one level. The files of
the command are checked as a second piece, which compiles without a warning: where the tests link it with the libraries
under sanitizers, its files are those that users get, compiled without warnings.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Highway compiles some files once for each level, each in a namespace of its own; here for the one of plain numbers.
ONE_LEVEL = "-DHWY_COMPILE_ONLY_STATIC"
# Where it may be missing; the file that calls it is compiled by itself.
OF_MPI = "#include <mpi.h>"
# Where g++ stops: what it would instantiate after the last line takes as long as all before, and holds no new names.
END = "the end of the piece"

# As in cmake/ToccataBuildFlags.cmake, but for a local name that hides another file's.
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wnon-virtual-dtor", "-Wold-style-cast", "-Wno-subobject-linkage", "-Werror"]
# g++ would tidy its memory up a tenth of its time.
UNTIDY = ["--param=ggc-min-heapsize=1500000"]


def library():
    return [f for f in sorted((ROOT / "src").rglob("*.cpp")) if OF_MPI not in f.read_text()]


def command():
    return [*sorted((ROOT / "apps/shared").glob("*.cpp")), *sorted((ROOT / "apps/toccata").glob("*.cpp"))]


def clash(compiler, files, warnings, folder, includes):
    """What the compiler says of the files as one piece, empty where it comes to their end."""
    unit = pathlib.Path(folder) / "one.cpp"
    unit.write_text("".join(f'#include "{file}"\n' for file in files) + f'static_assert(false, "{END}");\n')
    words = [compiler, "-std=c++20", "-fsyntax-only", ONE_LEVEL, *warnings, "-Wfatal-errors", *UNTIDY, *(f"-I{d}" for d in includes), unit]
    said = subprocess.run(words, capture_output=True, text=True).stderr
    return "" if END in said else said


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--compiler", default="c++")
    options = parser.parse_args()
    includes = [ROOT / "include", ROOT / "src", ROOT / "apps/shared"]
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        for what, files, warnings in [("library", library(), ["-w"]), ("command", command(), WARNINGS)]:
            said = clash(options.compiler, files, warnings, folder, includes)
            if said:
                failed = True
                print(f"the {what} does not compile as one piece: two definitions share a name, one hides another, or there is a warning\n{said}")
    if not failed:
        print("no two definitions share a name")
    return failed


if __name__ == "__main__":
    sys.exit(main())
