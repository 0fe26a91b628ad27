#!/usr/bin/env python3
"""Makes the constants on which proofs rest too small, one at a time, and demands that a test notices.

tools/proof_constants.json lists them by room (docs/design/proof-constants.md). An entry has

  name      of the constant                      file, text   where it is; the text is there exactly once
  weaker    what the text is replaced by         noticed_by   ROOM:Suite.Test, the witness that must fail then
  reason    or: why no witness can exist         open         or: what is known about a witness that is still missing

Without --check a copy of the sources in build/proofs is built, file by file; it is changed, built and run for each entry
with a witness, or for those that are named. What was noticed is not asked again for the same sources.
"""
import argparse
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIST = ROOT / "tools/proof_constants.json"
STAMPS = ROOT / "build/proofs/noticed"
COPIED = ["CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "apps", "cmake", "include", "src", "tests", "tools"]
OPTIONS = ["-DTOCCATA_BUILD_TESTS=ON", "-DTOCCATA_TEST_REPOSITORY=OFF", "-DTOCCATA_TEST_WITH_SWEEPS=OFF", "-DTOCCATA_UNITE=OFF"]
OUTCOMES = ("noticed_by", "reason", "open")


def entries():
    return [{"room": room, **entry} for room, rows in json.loads(LIST.read_text()).items() for entry in rows]


def has_test(reference):
    room, _, test = reference.partition(":")
    suite, _, name = test.partition(".")
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
    return bad + [f"{name}: twice in the list" for name in sorted(set(names)) if names.count(name) > 1]


def sources():
    for name in COPIED:
        path = ROOT / name
        yield from [path] if path.is_file() else sorted(p for p in path.rglob("*") if p.is_file() and "__pycache__" not in p.parts)


def fingerprint():
    digest = hashlib.sha256()
    for path in sources():
        digest.update(str(path.relative_to(ROOT)).encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


class Tree:
    """A copy of the sources with a build folder of its own."""

    def __init__(self, folder):
        self.folder, self.build = folder, folder / "build/release"

    def refresh(self):
        """Makes the copy equal to the sources; files that are equal keep their time, so that they are not compiled again."""
        wanted = {path.relative_to(ROOT) for path in sources()}
        for name in COPIED:
            for old in (self.folder / name).rglob("*"):
                if old.is_file() and "__pycache__" not in old.parts and old.relative_to(self.folder) not in wanted:
                    old.unlink()
        for name in wanted:
            to = self.folder / name
            if not to.is_file() or to.read_bytes() != (ROOT / name).read_bytes():
                to.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / name, to)
        if not (self.build / "build.ninja").exists():
            subprocess.run(["cmake", "--preset", "release", *OPTIONS], cwd=self.folder, check=True, stdout=subprocess.DEVNULL)

    def run(self, reference):
        """Builds the room's program and runs the test: "passes", "fails", or what went wrong."""
        room, _, test = reference.partition(":")
        made = subprocess.run(["ninja", "-C", self.build, f"test_{room}"], capture_output=True, text=True)
        if made.returncode != 0:
            return "does not compile:\n" + made.stdout[-2000:]
        command = [self.build / f"tests/test_{room}", f"--gtest_filter={test}"]
        try:
            ran = subprocess.run(command, capture_output=True, text=True, timeout=600)
        except subprocess.TimeoutExpired:
            return "runs for longer than ten minutes"
        if "Running 0 tests" in ran.stdout:
            return "is no test of the program"
        return "passes" if ran.returncode == 0 else "fails"

    def run_changed(self, entry):
        """The same with the weaker constant, which is taken back whatever happens."""
        file = self.folder / entry["file"]
        sound = file.read_text()
        try:
            file.write_text(sound.replace(entry["text"], entry["weaker"]))
            return self.run(entry["noticed_by"])
        finally:
            file.write_text(sound)


def is_noticed(tree, entry, now):
    stamp = STAMPS / hashlib.sha256(json.dumps(entry, sort_keys=True).encode()).hexdigest()
    if stamp.exists() and stamp.read_text() == now:
        return True
    changed = tree.run_changed(entry)
    if changed == "fails" and tree.run(entry["noticed_by"]) == "passes":
        stamp.parent.mkdir(parents=True, exist_ok=True)
        stamp.write_text(now)
        return True
    print(f"{entry['name']}: with the weaker constant {entry['noticed_by']} {changed}", flush=True)
    return False


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("names", nargs="*", metavar="NAME", help="only the constants of this name, or of this room")
    parser.add_argument("--check", action="store_true", help="only that the list fits the sources")
    parser.add_argument("--tree", type=pathlib.Path, default=ROOT / "build/proofs/tree", help="where the changed copy is")
    options = parser.parse_args()
    rows = entries()
    bad = check(rows)
    if bad:
        print("\n".join(bad))
        return 1
    count = {key: sum(key in entry for entry in rows) for key in OUTCOMES}
    summary = f"{len(rows)} constants: {count['noticed_by']} with a witness, {count['reason']} with a reason, {count['open']} open"
    if options.check:
        print(summary)
        return 0
    chosen = [e for e in rows if not options.names or e["name"] in options.names or e["room"] in options.names]
    tree, now, missed = Tree(options.tree), fingerprint(), 0
    tree.refresh()
    for entry in chosen:
        if "noticed_by" not in entry:
            key = "reason" if "reason" in entry else "open"
            print(f"{entry['room']}/{entry['name']:44} {key}: {entry[key]}", flush=True)
            continue
        noticed = is_noticed(tree, entry, now)
        missed += not noticed
        print(f"{entry['room']}/{entry['name']:44} {entry['noticed_by'] if noticed else 'NOT NOTICED'}", flush=True)
    print(f"{summary}; {missed} not noticed")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
