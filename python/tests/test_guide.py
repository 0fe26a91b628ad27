"""The programs of docs/guide/python.md run, one after the other, and print what the page says."""

import contextlib
import io
import pathlib
import re

import pytest

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/guide/python.md"


@pytest.mark.skipif(not PAGE.exists(), reason="the guide is not beside the tests")
def test_programs_print_what_the_page_says():
    blocks = re.findall(r"```python\n(.*?)```\n\n```output\n(.*?)```", PAGE.read_text(), re.DOTALL)
    assert len(blocks) >= 4
    known: dict = {}
    for program, told in blocks:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(program, str(PAGE), "exec"), known)
        assert printed.getvalue() == told
