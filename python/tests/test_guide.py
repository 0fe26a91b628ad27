"""The programs of the pages about Python run, those of a page one after the other, and print what the page says."""

import contextlib
import io
import pathlib
import re
import sys
import types

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = ["README.md", *(f"docs/guide/{name}.md" for name in ("python", "python-batches", "from-trimesh", "from-python-fcl", "from-coal", "robots"))]


@pytest.mark.skipif(not (ROOT / "docs/guide").exists(), reason="the guide is not beside the tests")
@pytest.mark.parametrize("page", PAGES)
def test_programs_print_what_the_page_says(page, monkeypatch):
    file = ROOT / page
    blocks = re.findall(r"```python\n(.*?)```\n\n(?:prints\n\n)?```output\n(.*?)```", file.read_text(), re.DOTALL)
    assert blocks
    script = types.ModuleType("page")  # where classes of a page are found by their names, as pickle does
    monkeypatch.setitem(sys.modules, "page", script)
    known = vars(script)
    for program, told in blocks:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(program, str(file), "exec"), known)
        assert printed.getvalue() == told
