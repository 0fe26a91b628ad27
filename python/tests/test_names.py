"""Every name of the C++ library is bound, or docs/reference/python-names.md says why it is not."""

import pathlib
import re

import pytest

import toccata

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/reference/python-names.md"
pytestmark = pytest.mark.skipif(not PAGE.exists() or not (ROOT / "include").exists(), reason="headers and pages are not beside the tests")
OF_TEMPLATES = {"std"}


def names_of(header: str) -> set[str]:
    """Classes, and functions that answer, at the left margin."""
    names = set()
    for line in (ROOT / "include/toccata" / header).read_text().split("\n"):
        if (kind := re.match(r"(?:class|struct|enum class) (\w+)", line)) and not line.endswith(";"):
            names.add(kind[1])
        elif re.match(r"\[\[nodiscard\]\]|(?:void|Refit|bool|double) ", line) and (function := re.search(r"[ &*](\w+)\(", line)):
            names.add(function[1])
    return names - {"name_of"} - OF_TEMPLATES


def names_by_header() -> dict[str, set[str]]:
    headers = [
        header
        for umbrella in ("toccata.hpp", "robots.hpp")
        for header in re.findall(r'#include "toccata/([^"]+)"', (ROOT / "include/toccata" / umbrella).read_text())
    ]
    return {header: names_of(header) for header in headers}


def rows() -> list[tuple[str, set[str], str]]:
    found, header = [], ""
    for line in PAGE.read_text().split("\n"):
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 3 and line.startswith("| ") and cells[0] != "header":
            header = cells[0].strip("`") or header
            found.append((header, set(re.findall(r"`(\w+)`", cells[1])), cells[2]))
    return found


def test_the_page_names_all_that_the_headers_have():
    told: dict[str, set[str]] = {}
    for header, names, _ in rows():
        told.setdefault(header, set()).update(names)
    for header, names in names_by_header().items():
        assert told.get(header, set()) == names, header


def test_what_the_page_calls_bound_is_there():
    bound = 0
    for _, names, told in rows():
        assert told, names
        if told.startswith("not bound"):
            assert re.match(r"not bound( yet)?: [\w`]", told), told
            continue
        for name in re.findall(r"`([A-Za-z_]+(?:\.[a-z_]+)?)`", told):
            thing = toccata
            for part in name.split("."):
                thing = getattr(thing, part, None)
            if name not in ("of", "advance", "move_to", "threads"):
                assert thing is not None, name
                bound += 1
    assert bound > 150
