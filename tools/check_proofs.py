#!/usr/bin/env python3
"""Makes the constants on which proofs rest too small, one at a time, and demands that a test notices.

tools/proof_constants.json lists them by room (docs/design/proof-constants.md). An entry has

  name      of the constant                      file, text   where it is; the text is there exactly once
  weaker    what the text is replaced by         noticed_by   ROOM:Suite.Test, the witness that must fail then
  reason    or: why no witness can exist         open         or: what is known about a witness that is still missing
  rebuild   true where the constant cannot be chosen at run time

A copy of the sources in build/proofs is built once, in which every constant can be weakened at run time
(tools/weakened_tree.py); an entry is then two runs of its witness. Where that cannot be, the copy is changed and built
for the entry. What was noticed is not asked again for the same sources.

--survey runs, for each constant, all tests of a room that come to it and take little time, and prints which notice that it
is weakened. An open row needs no `weaker` for that: its small number becomes 0, or its step to the next double is left out.
"""
import argparse
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import time

from weakened_tree import Tree, identifier, with_default_weakening

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIST = ROOT / "tools/proof_constants.json"
PAGE = ROOT / "docs/design/proof-constants.md"
STAMPS = ROOT / "build/proofs/noticed"
OUTCOMES = ("noticed_by", "reason", "open")
LONGEST_OF_SURVEY = 4.0  # seconds that a test may take


def entries():
    return [{"room": room, **entry} for room, rows in json.loads(LIST.read_text()).items() for entry in rows]


def has_test(reference):
    room, _, test = reference.partition(":")
    suite, _, name = test.partition(".")
    # A test with parameters is called Instance/Suite.Test/number.
    suite, name = suite.split("/")[-1], name.split("/")[0]
    pattern = re.compile(rf"TEST(_F|_P)?\(\s*{re.escape(suite)},\s*{re.escape(name)}\s*\)")
    return any(pattern.search(p.read_text()) for p in (ROOT / "tests" / room).glob("*_test.cpp"))


def mistakes(entry):
    """What is wrong with an entry itself."""
    file = ROOT / entry["file"]
    found = file.read_text().count(entry["text"]) if file.is_file() else 0
    if found != 1:
        yield f"{entry['file']} has {found} times: {entry['text']}"
    if sum(key in entry for key in OUTCOMES) != 1:
        yield f"needs exactly one of {', '.join(OUTCOMES)}"
    if "noticed_by" in entry:
        if entry.get("weaker", entry["text"]) == entry["text"]:
            yield "says nothing weaker"
        if not has_test(entry["noticed_by"]):
            yield f"there is no test {entry['noticed_by']}"


def check(rows):
    bad = [f"{entry['name']}: {mistake}" for entry in rows for mistake in mistakes(entry)]
    names = [entry["name"] for entry in rows]
    numbers = [identifier(name) for name in names]
    return bad + [f"{name}: has the name, or the number, of another one" for name in names if numbers.count(identifier(name)) > 1]


def sentence(count):
    """What the page says of how many constants there are."""
    total = sum(count.values())
    open_rows = "none is" if count["open"] == 0 else f"{count['open']} are"
    return f"Of the {total} constants {count['noticed_by']} have a witness and {count['reason']} a reason; {open_rows} open."


def check_page(wanted):
    if wanted not in " ".join(PAGE.read_text().split()):
        yield f"{PAGE.relative_to(ROOT)} has to say: {wanted}"


def fingerprint(tree):
    digest = hashlib.sha256()
    for path in tree.sources():
        digest.update(str(path.relative_to(ROOT)).encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def build(tree, rooms):
    """Empty, or what the compiler said."""
    made = subprocess.run(["ninja", "-k", "0", "-C", tree.build, *(f"test_{room}" for room in rooms)], capture_output=True, text=True)
    return "" if made.returncode == 0 else made.stdout


def run(tree, room, tests, weakened="", touched=""):
    """The tests that fail: all that are there where the program breaks off."""
    environment = {**os.environ, "TOCCATA_WEAKENED": weakened}
    if touched:
        environment["TOCCATA_TOUCHED"] = touched
    command = [tree.program(room), "--gtest_brief=1", f"--gtest_filter={':'.join(tests)}"]
    try:
        ran = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=600, env=environment)
    except subprocess.TimeoutExpired:
        return ["(runs for longer than ten minutes)"]
    failed = sorted(set(re.findall(r"\[  FAILED  \] ([\w/]+\.[\w/-]+)", ran.stdout)))
    if "Running 0 tests" in ran.stdout or ran.returncode == 0:
        return []
    return failed or ["(breaks off)"]


def outcome(tree, entry):
    """ "" where the witness fails with the weaker constant and passes without, otherwise what is wrong."""
    room, _, test = entry["noticed_by"].partition(":")
    if entry["name"] not in tree.left:
        weaker = run(tree, room, [test], f"{identifier(entry['name']):x}")
        sound = run(tree, room, [test])
    else:
        with tree.replaced(entry):
            said = build(tree, [room])
            weaker = [] if said else run(tree, room, [test])
        said = said or build(tree, [room])
        if said:
            return "does not compile:\n" + said[-2000:]
        sound = run(tree, room, [test])
    if sound:
        return "fails without the weaker constant"
    return "" if weaker else "passes with the weaker constant"


def is_noticed(tree, entry, now):
    stamp = STAMPS / hashlib.sha256(json.dumps(entry, sort_keys=True).encode()).hexdigest()
    if stamp.exists() and stamp.read_text() == now:
        return True
    wrong = outcome(tree, entry)
    if wrong:
        print(f"{entry['name']}: {entry['noticed_by']} {wrong}", flush=True)
        return False
    stamp.parent.mkdir(parents=True, exist_ok=True)
    stamp.write_text(now)
    return True


def check_witnesses(tree, chosen):
    """How many constants were not noticed."""
    now, missed = fingerprint(tree), 0
    for entry in chosen:
        if "noticed_by" not in entry:
            key = "reason" if "reason" in entry else "open"
            print(f"{entry['room']}/{entry['name']:44} {key}: {entry[key]}", flush=True)
            continue
        noticed = is_noticed(tree, entry, now)
        missed += not noticed
        print(f"{entry['room']}/{entry['name']:44} {entry['noticed_by'] if noticed else 'NOT NOTICED'}", flush=True)
    return missed


def what_tests_touch(tree, room):
    """{test: (seconds, the constants that it comes to)} of a room, kept for the same program."""
    program = tree.program(room)
    key, kept = hashlib.sha256(program.read_bytes()).hexdigest(), tree.folder.parent / f"touched-{room}.json"
    if kept.exists() and json.loads(kept.read_text())["key"] == key:
        return json.loads(kept.read_text())["tests"]
    listed, suite, tests, file = subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True).stdout, "", {}, str(kept) + ".part"
    for line in listed.splitlines():
        if not line.startswith(" "):
            suite = line.split()[0]
            continue
        test, began = suite + line.split()[0], time.time()
        run(tree, room, [test], touched=file)
        seconds, touched = time.time() - began, pathlib.Path(file)
        tests[test] = (seconds, touched.read_text().split() if touched.exists() else [])
        touched.unlink(missing_ok=True)
    kept.write_text(json.dumps({"key": key, "tests": tests}))
    return tests


def survey(tree, chosen, rooms):
    """Prints for each constant the tests that notice; the tests are those of the rooms, or of its own room."""
    for room in rooms or sorted({entry["room"] for entry in chosen}):
        touching = what_tests_touch(tree, room)
        for entry in chosen if rooms else [e for e in chosen if e["room"] == room]:
            if "weaker" not in entry or entry["name"] in tree.left:
                print(f"{entry['name']:40} {room}: cannot be weakened at run time", flush=True)
                continue
            weakened = f"{identifier(entry['name']):x}"
            tests = [test for test, (seconds, ids) in touching.items() if weakened in ids and seconds <= LONGEST_OF_SURVEY]
            failed = run(tree, room, tests, weakened) if tests else []
            print(f"{entry['name']:40} {room}: {len(failed)} of {len(tests)} notice {' '.join(failed)}", flush=True)


def rooms_of_tests(chosen, is_survey):
    """A survey runs the tests of a constant's own room, the check those that entries name."""
    if is_survey:
        return sorted({entry["room"] for entry in chosen})
    return sorted({entry["noticed_by"].partition(":")[0] for entry in chosen if "noticed_by" in entry})


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("names", nargs="*", metavar="NAME", help="only the constants of this name, or of this room")
    parser.add_argument("--check", action="store_true", help="only that the list fits the sources, and the page the list")
    parser.add_argument("--survey", action="store_true", help="which tests notice each of these constants, or each open one")
    parser.add_argument("--tests-of", nargs="+", metavar="ROOM", help="whose tests a survey runs, otherwise those of the constant's room")
    parser.add_argument("--tree", type=pathlib.Path, default=ROOT / "build/proofs/tree", help="where the changed copy is")
    options = parser.parse_args()
    rows = entries()
    count = {key: sum(key in entry for entry in rows) for key in OUTCOMES}
    bad = check(rows) + (list(check_page(sentence(count))) if options.check else [])
    if bad:
        print("\n".join(bad))
        return 1
    summary = f"{len(rows)} constants: {count['noticed_by']} with a witness, {count['reason']} with a reason, {count['open']} open"
    if options.check:
        print(summary)
        return 0
    tree = Tree(ROOT, options.tree)
    if options.survey:
        rows = [with_default_weakening(entry, (ROOT / entry["file"]).read_text()) for entry in rows]
    tree.refresh([entry for entry in rows if "weaker" in entry])
    chosen = [e for e in rows if not options.names or e["name"] in options.names or e["room"] in options.names]
    if options.survey and not options.names:
        chosen = [e for e in chosen if "open" in e]
    said = build(tree, options.tests_of or rooms_of_tests(chosen, options.survey))
    if said:
        print("does not compile:\n" + said[-6000:])
        return 1
    if options.survey:
        survey(tree, chosen, options.tests_of)
        return 0
    missed = check_witnesses(tree, chosen)
    print(f"{summary}; {missed} not noticed")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
