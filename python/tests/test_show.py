"""Pages: to a file, and inline."""

import base64
import re
import zlib

import pytest

import toccata


def test_a_page_holds_the_objects_and_what_was_found(tmp_path, knot):
    crate = toccata.SceneInstance(toccata.Box((0.5, 0.5, 0.5)), (0.8, 0, 0), name="the crate")
    path = tmp_path / "scene.html"
    page = toccata.show([knot, crate, (toccata.Sphere(0.2), (9, 0, 0))], path, title="A knot & a crate")
    text = path.read_text()
    assert text == page.html and text.startswith("<!")
    report, header = (
        zlib.decompress(base64.b64decode(re.search(rf'id="toccata-{name}"[^>]*>(.*?)<', text)[1])).decode() for name in ("report", "header")
    )
    assert "the crate" in report and "A knot" in header
    inline = page._repr_html_()
    assert inline.startswith("<iframe srcdoc=") and "<script" not in inline
    assert len(repr(page)) < 60
    toccata.show([knot], path)  # what Toccata wrote may be written again


def test_nothing_else_is_overwritten(tmp_path, knot):
    path = tmp_path / "notes.html"
    path.write_text("mine")
    with pytest.raises(toccata.Error, match="notes.html"):
        toccata.show([knot], path)
    assert path.read_text() == "mine"
    for wrong in (lambda: toccata.show([5]), lambda: toccata.show([knot], up="x"), lambda: toccata.show(knot)):
        with pytest.raises(toccata.Error):
            wrong()
