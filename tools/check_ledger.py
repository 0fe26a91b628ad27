#!/usr/bin/env python3
"""Checks docs/evidence/ledger.json, the list of methods and of what shows that each works.

A row has the cells api, command, oracle_test, benchmark, docs, picture. A cell is a reference or a list of references,
"n/a: reason", or empty; a row with an empty cell, or with a member "missing" that names a part which is still to come, is
open. Every reference must lead somewhere:

  api          a name declared in include/            command    a subcommand of the command
  oracle_test  FILE:Suite.Test or FILE:sweep          the others a file, docs with or without #heading

docs/design/traps.md names tests in the same way. In docs/methods/questions.md every row has a number, a link to an answer under a
heading of that number, and tests that exist; every such heading has its row; and every `Suite.Test` that a page of docs/ names exists.
With --write the table docs/methods.md is made anew; without, it must be what would be written.
"""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LEDGER = ROOT / "docs/evidence/ledger.json"
TABLE = ROOT / "docs/methods.md"
TRAPS = ROOT / "docs/design/traps.md"
QUESTIONS = ROOT / "docs/methods/questions.md"
QUESTION_ROW = re.compile(r"^\| Q(\d+) \|.*\]\(([\w-]+)\.md#q(\d+)-[^)]*\) \| (.*) \|$", re.MULTILINE)
ANSWER = re.compile(r"^### Q(\d+):.*$", re.MULTILINE)
NAMED_TEST = re.compile(r"`([A-Z]\w+\.[A-Z]\w+)`")
CELLS = ["api", "command", "oracle_test", "benchmark", "docs", "picture"]
IDS = [*(f"A{i}" for i in range(1, 15)), *(f"B{i}" for i in range(1, 14)), *(f"C{i}" for i in range(1, 19))]


def text_of(folder, suffixes=(".hpp", ".cpp")):
    return "\n".join(p.read_text() for p in sorted((ROOT / folder).rglob("*")) if p.suffix in suffixes)


def references(cell):
    """The references of a cell; none when it is empty or does not apply."""
    entries = cell if isinstance(cell, list) else [cell]
    return [e for e in entries if e and not e.startswith("n/a: ")]


def is_test(reference):
    name, _, test = reference.partition(":")
    path = ROOT / name
    if not path.is_file() or not test:
        return False
    suite, dot, case = test.partition(".")
    if dot:
        return re.search(rf"\b(TYPED_)?TEST(_F|_P)?\(\s*{re.escape(suite)}\s*,\s*{re.escape(case)}\s*\)", path.read_text()) is not None
    return f'"{test}"' in path.read_text()


def exists(kind, reference, public_headers, command):
    if kind == "api":
        return re.search(rf"\b{re.escape(reference)}\b", public_headers) is not None
    if kind == "command":
        return f'add_subcommand("{reference}"' in command
    if kind == "oracle_test":
        return is_test(reference)
    return (ROOT / reference.partition("#")[0]).is_file()


def check_rows(rows):
    public_headers, command = text_of("include"), text_of("apps/toccata")
    if [row["id"] for row in rows] != IDS:
        yield "the ledger's rows are not A1 … A14, B1 … B13, C1 … C18 in this order"
    for row in rows:
        if set(row) - {"missing"} != {"id", "method", *CELLS}:
            yield f"{row['id']}: has other cells than {', '.join(CELLS)}"
            continue
        for kind in CELLS:
            for reference in references(row[kind]):
                if not exists(kind, reference, public_headers, command):
                    yield f"{row['id']}: {kind} {reference} leads nowhere"


def check_traps():
    rows = [line for line in TRAPS.read_text().splitlines() if line.startswith("|")][2:]
    for row in rows:
        tests = re.findall(r"`(tests/[^`]*)`", row)
        for test in tests:
            if not is_test(test):
                yield f"docs/design/traps.md: {test} leads nowhere"
        if not tests:
            yield f"docs/design/traps.md: no test springs this: {row}"


def known_tests():
    """Suite.Test of all tests, and the names of the sweeps."""
    text = text_of("tests")
    tests = re.findall(r"\b(?:TYPED_)?TEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\)", text)
    sweeps = re.findall(r'"([a-z][a-z-]+)"', "\n".join(p.read_text() for p in (ROOT / "tests").rglob("*_sweep.cpp")))
    return {f"{suite}.{case}" for suite, case in tests} | set(sweeps)


def check_questions(known):
    rows = QUESTION_ROW.findall(QUESTIONS.read_text())
    numbers = sorted(int(number) for number, *_ in rows)
    if numbers != list(range(1, len(numbers) + 1)) or len(rows) != QUESTIONS.read_text().count("\n| Q"):
        yield "docs/methods/questions.md: the questions are not Q1, Q2 … each once with a link to an answer of its number"
    for number, page, of_link, tests in rows:
        named = re.findall(r"`([^`]*)`", tests)
        if number != of_link or not named:
            yield f"docs/methods/questions.md: Q{number} links to the answer of Q{of_link} or names no test"
        yield from (f"docs/methods/questions.md: Q{number}: there is no test {t}" for t in named if t not in known)
    answers = sorted((number, path.stem) for path in QUESTIONS.parent.glob("*.md") for number in ANSWER.findall(path.read_text()))
    if answers != sorted((number, page) for number, page, *_ in rows):
        yield "docs/methods/questions.md: its links are not the answers that the pages have under ### Q…"


def check_named_tests(known):
    for path in sorted((ROOT / "docs").rglob("*.md")):
        for test in NAMED_TEST.findall(path.read_text()):
            if test not in known:
                yield f"{path.relative_to(ROOT)}: there is no test {test}"


def is_open(row):
    return "missing" in row or any(not row[kind] for kind in CELLS)


def shown(kind, cell):
    entries = cell if isinstance(cell, list) else [cell]
    if entries == [""]:
        return ""
    if kind in {"docs", "picture", "benchmark"}:
        links = {e: f"[{pathlib.Path(e.partition('#')[0]).stem}]({pathlib.Path('..') / e})" for e in references(cell)}
        links = {e: link.replace("](../docs/", "](") for e, link in links.items()}
        return ", ".join(links.get(e, e) for e in entries)
    return ", ".join(e if e.startswith("n/a: ") else f"`{e.rpartition(':')[2]}`" for e in entries)


def table(rows):
    done = sum(not is_open(row) for row in rows)
    begun = sum(bool(row["api"]) for row in rows)
    lines = [
        "# The methods",
        "",
        "What Toccata is to contain, and what shows that it does: made from [ledger.json](evidence/ledger.json) by",
        "`tools/check_ledger.py --write`. A to C are three lectures that Toccata sets out to implement in full: \"Principles of",
        "Computer Game Design and Implementation\", lecture 12; \"Collision detection\", notes by Y. Murugesan, 2011; and CS679,",
        "University of Wisconsin, 20 November 2003. A row with an empty cell or a missing part is open: of these "
        f"{len(rows)} rows {begun} work in this version and {done} are complete (pictures are drawn by `tools/draw_pictures.py`).",
        "",
        "| | method | C++ | command | test against an oracle | benchmark | docs | picture |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        cells = " | ".join(shown(kind, row[kind]) for kind in CELLS)
        missing = f"; still missing: {row['missing']}" if "missing" in row else ""
        lines.append(f"| {row['id']} | {row['method']}{missing} | {cells} |")
    return "\n".join(lines) + "\n"


def main():
    rows = json.loads(LEDGER.read_text())["rows"]
    known = known_tests()
    complaints = [*check_rows(rows), *check_traps(), *check_questions(known), *check_named_tests(known)]
    if "--write" in sys.argv:
        TABLE.write_text(table(rows))
    elif not TABLE.exists() or TABLE.read_text() != table(rows):
        complaints.append("docs/methods.md is not what the ledger says: run tools/check_ledger.py --write")
    for complaint in complaints:
        print(complaint)
    touched = sum(any(references(row[kind]) for kind in CELLS) for row in rows)
    print(f"ledger: {len(rows)} rows, {touched} begun, {sum(not is_open(r) for r in rows)} complete, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
