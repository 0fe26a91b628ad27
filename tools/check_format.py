#!/usr/bin/env python3
"""Checks that clang-format (14, as in Debian 12) would change no C++ file; names those it would change."""
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ["include", "src", "apps", "tests", "examples", "python"]


def main():
    tool = shutil.which("clang-format-14") or shutil.which("clang-format")
    if tool is None:
        print("clang-format is not installed")
        return 1
    files = sorted(str(p) for f in FOLDERS for p in (ROOT / f).rglob("*") if p.suffix in {".hpp", ".cpp"})
    run = subprocess.run([tool, "--dry-run", "-Werror", "--ferror-limit=1", *files], capture_output=True, text=True)
    for name in sorted({line.split(":")[0] for line in run.stderr.splitlines() if ": error: " in line}):
        print(f"{pathlib.Path(name).relative_to(ROOT)}: run clang-format -i on it")
    print(f"format: {len(files)} files looked at")
    return run.returncode


if __name__ == "__main__":
    sys.exit(main())
