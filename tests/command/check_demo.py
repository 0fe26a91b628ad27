#!/usr/bin/env python3
"""The demo that ./toccata builds first prints what `toccata demo` prints, but for the seconds that it took.

check_demo.py TOCCATA TOCCATA-DEMO
"""
import os
import re
import subprocess
import sys


def printed(*words):
    """What a program prints, the seconds blotted out."""
    environment = {**os.environ, "TOCCATA_CALLED_AS": "./toccata"}
    run = subprocess.run(words, capture_output=True, text=True, env=environment)
    assert run.returncode == 0, f"{words} ended with {run.returncode}: {run.stderr}"
    return re.sub(r"checked in [0-9.]+ s", "checked in … s", run.stdout)


def main():
    command, demo = sys.argv[1:]
    whole, alone = printed(command, "demo"), printed(demo)
    assert "./toccata check scenes/a.obj" in whole and "checked in … s" in whole, whole
    assert whole == alone, f"the command prints\n{whole}\nand the demo alone\n{alone}"


if __name__ == "__main__":
    main()
