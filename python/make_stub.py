"""Writes python/toccata/__init__.pyi, which type checkers read: what the compiled part says of itself.

usage: make_stub.py [--check]   with the package installed and nanobind; --check only compares
"""

import pathlib
import re
import subprocess
import sys
import tempfile

STUB = pathlib.Path(__file__).resolve().parent / "toccata/__init__.pyi"


def made() -> str:
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "stub.pyi"
        subprocess.run([sys.executable, "-m", "nanobind.stubgen", "-q", "-m", "toccata", "-o", file], check=True)
        return of_the_compiled_part(file.read_text())


# What nanobind writes that a strict type checker refuses, and what it means.
CORRECTIONS = (
    (r"^import Solid\n", ""),  # the Solid of this module
    (r"^from toccata\._show import \(.*?^\)\n", ""),  # methods of a class there
    (r"^import enum$", "import builtins\nimport enum"),
    (r"^from typing import overload$", "from typing import ClassVar, overload"),
    (r"other: object, /", "other: builtins.object, /"),  # some classes have an `object` of their own
    (r"__hash__: None = None", "__hash__: ClassVar[None]  # type: ignore[assignment]"),
    (r"\btuple(?=[:,])", "tuple[builtins.object, ...]"),
    (r"\bos\.PathLike(?!\[)", "os.PathLike[str]"),
    (r"(?<=def __reduce__\(self\) -> )object", "tuple[builtins.object, ...]"),
)


def of_the_compiled_part(stub: str) -> str:
    """What is written in Python has its types where it is."""
    for pattern, meant in CORRECTIONS:
        stub = re.sub(pattern, meant, stub, flags=re.MULTILINE | re.DOTALL)
    for name in ("class Page:", "def show("):
        stub = re.sub(rf"^{re.escape(name)}.*?(?=^\S)", "", stub, flags=re.MULTILINE | re.DOTALL)
    return stub.replace("__all__: list =", "from ._show import Page as Page, show as show\n\n__all__: list[str] =") + "\n__version__: str\n"


if __name__ == "__main__":
    if "--check" in sys.argv:
        sys.exit(0 if made() == STUB.read_text() else f"{STUB.name} is out of date: run make_stub.py")
    STUB.write_text(made())
