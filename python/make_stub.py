"""Writes python/toccata/__init__.pyi, which type checkers read: what the compiled part says of itself.

usage: make_stub.py [--check]   with the package installed and nanobind; --check only compares
"""

import pathlib
import subprocess
import sys
import tempfile

STUB = pathlib.Path(__file__).resolve().parent / "toccata/__init__.pyi"


def made() -> str:
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "stub.pyi"
        subprocess.run([sys.executable, "-m", "nanobind.stubgen", "-q", "-m", "toccata", "-o", file], check=True)
        return file.read_text() + "\n__version__: str\n"


if __name__ == "__main__":
    if "--check" in sys.argv:
        sys.exit(0 if made() == STUB.read_text() else f"{STUB.name} is out of date: run make_stub.py")
    STUB.write_text(made())
