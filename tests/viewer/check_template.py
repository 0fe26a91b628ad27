#!/usr/bin/env python3
"""Checks that apps/viewer/dist/page.html belongs to its sources.

usage: check_template.py [--bytes | --npm]

The page names the hash of what it was built from; that is compared. With --bytes the page is built again, by what is in
apps/viewer/node_modules (`npm ci` in apps/viewer), and must have the same bytes; where that or Node.js is missing, the exit
code is 77, which CTest takes for skipped. With --npm the same is done in a copy, in which `npm ci` fetches what is needed.
"""
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

VIEWER = pathlib.Path(__file__).resolve().parent.parent.parent / "apps/viewer"


def sources_hash():
    names = sorted([*(f"src/{path.name}" for path in (VIEWER / "src").iterdir()), "build.mjs", "package.json", "package-lock.json", "tsconfig.json"])
    digest = hashlib.sha256()
    for name in names:
        digest.update(f"{name}\n{(VIEWER / name).read_text()}\n".encode())
    return digest.hexdigest()


def check_hash():
    page = (VIEWER / "dist/page.html").read_bytes()
    if any(byte > 127 for byte in page):
        print("dist/page.html is not ASCII")
        return 1
    named = re.search(rb"Built from ([0-9a-f]{64})", page)
    if named is None or named.group(1).decode() != sources_hash():
        print("dist/page.html was built from other sources: run npm ci && npm run build in apps/viewer")
        return 1
    print("dist/page.html names its sources")
    return 0


def check_bytes(folder):
    if not (folder / "node_modules/esbuild").exists() or shutil.which("node") is None:
        print("SKIPPED: not built again, as there is no apps/viewer/node_modules (npm ci in apps/viewer) or no Node.js")
        return 77
    return subprocess.run(["node", folder / "build.mjs", "--check"]).returncode


def check_bytes_in_copy():
    if shutil.which("npm") is None:
        print("the page cannot be built again: npm is not installed (apt-get install npm)")
        return 1
    with tempfile.TemporaryDirectory() as name:
        copy = pathlib.Path(name) / "viewer"
        shutil.copytree(VIEWER, copy, ignore=shutil.ignore_patterns("node_modules"))
        fetched = subprocess.run(["npm", "ci", "--no-audit", "--no-fund"], cwd=copy).returncode
        return fetched or check_bytes(copy)


def main():
    if sys.argv[1:] not in ([], ["--bytes"], ["--npm"]):
        print(__doc__)
        return 2
    if sys.argv[1:] == ["--bytes"]:
        return check_bytes(VIEWER)
    return check_hash() or (check_bytes_in_copy() if sys.argv[1:] == ["--npm"] else 0)


if __name__ == "__main__":
    sys.exit(main())
