"""The stubs fit the compiled part, and mypy takes what is written by them."""

import os
import pathlib
import subprocess
import sys

import pytest

import toccata

HERE = pathlib.Path(__file__).resolve().parent


def test_stubs_are_up_to_date():
    pytest.importorskip("nanobind")
    run = subprocess.run([sys.executable, HERE.parent / "make_stub.py", "--check"], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr


def test_mypy_is_content(tmp_path):
    """With the stubs of the compiled part, the modules in Python, and what is written by them: typed.py."""
    pytest.importorskip("mypy")
    words = ["--strict", "--warn-unused-ignores", "-p", "toccata", "-m", "typed"]
    run = subprocess.run([sys.executable, "-m", "mypy", *words], capture_output=True, text=True, cwd=tmp_path, env={**os.environ, "MYPYPATH": str(HERE)})
    assert run.returncode == 0, run.stdout + run.stderr


def test_everything_is_documented():
    for name in toccata.__all__:
        thing = getattr(toccata, name)
        if callable(thing) and not issubclass(type(thing), type):
            assert thing.__doc__ and len(thing.__doc__) > 60, name
        elif isinstance(thing, type) and not issubclass(thing, Exception):
            assert thing.__doc__, name


def test_names_are_those_of_the_package():
    for name in toccata.__all__:
        thing = getattr(toccata, name)
        if hasattr(thing, "__module__"):
            assert thing.__module__ == "toccata", name
