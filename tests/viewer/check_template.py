#!/usr/bin/env python3
"""Checks that apps/viewer/dist/page.html belongs to its sources.

The page names the hash of what it was built from; that is compared always. Where apps/viewer/node_modules is there
(`npm ci` in apps/viewer), the page is also built again and must have the same bytes.
"""
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys

VIEWER = pathlib.Path(__file__).resolve().parent.parent.parent / "apps/viewer"


def sources_hash():
    names = sorted([*(f"src/{path.name}" for path in (VIEWER / "src").iterdir()), "build.mjs", "package.json", "package-lock.json"])
    digest = hashlib.sha256()
    for name in names:
        digest.update(f"{name}\n{(VIEWER / name).read_text()}\n".encode())
    return digest.hexdigest()


def main():
    page = (VIEWER / "dist/page.html").read_bytes()
    if any(byte > 127 for byte in page):
        print("dist/page.html is not ASCII")
        return 1
    named = re.search(rb"Built from ([0-9a-f]{64})", page)
    if named is None or named.group(1).decode() != sources_hash():
        print("dist/page.html was built from other sources: run npm ci && npm run build in apps/viewer")
        return 1
    print("dist/page.html names its sources")
    if not (VIEWER / "node_modules/esbuild").exists() or shutil.which("node") is None:
        print("not built again: there is no apps/viewer/node_modules (npm ci in apps/viewer)")
        return 0
    return subprocess.run(["node", VIEWER / "build.mjs", "--check"]).returncode


if __name__ == "__main__":
    sys.exit(main())
