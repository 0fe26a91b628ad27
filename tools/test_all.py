#!/usr/bin/env python3
"""./toccata test --all: the tests of ./toccata test, then the long ones. Takes hours.

This may be stopped and started at will: what passed is not run again for the same sources, neither a step nor a part of
one (the tests of a room, a fuzzer, a constant of a proof, a unit of tidy). Which steps passed, for which commit and how
long they took is kept in docs/evidence/test-all.json, the counts of the sweeps in docs/evidence/<sweep>.json.
`--only STEP…` runs some steps and installs only what these need, `--minutes M` limits the sweeps, `--anew` runs them again
for this commit, whatever others have compared, `--scale F` multiplies what they have to compare, and `--cases N` is what each
of their families has to.
"""
import argparse
import hashlib
import itertools
import json
import pathlib
import re
import subprocess
import sys
import time
import typing

ROOT = pathlib.Path(__file__).resolve().parent.parent
STAMPS = ROOT / "build/all"
EVIDENCE = ROOT / "docs/evidence"
FUZZ_SECONDS = 120
CODE = ["apps", "cmake", "include", "src", "tests", "CMakeLists.txt", "CMakePresets.json"]
ALL = [".", ":!docs/evidence"]
# What does not depend on the compiler, and nothing but repeats where the step test has run: texts, pages in a browser, and
# the Python package.
TEXTS = "^python/|^viewer/|^repository/(format|layering|ledger|proofs|recipes|rooms)$"
BEGINS_THREADS = re.compile(r"core/parallel\.hpp|<(atomic|condition_variable|future|mutex|thread)>|tbb/")
SANITIZED = "clang libclang-rt-14-dev"  # which compiles what sanitizers put in between in less time than g++
WITH_CGAL = "-DTOCCATA_BUILD_TESTS=ON -DTOCCATA_TEST_WITH_CGAL=ON"


class Step(typing.NamedTuple):
    """`script` is in the words of tools/steps.sh, and runs each time that the step does. Then come its parts, each once."""
    script: str
    reads: list = CODE  # as git names paths: a step that passed has to run again where one of these changed
    packages: str = ""
    tests: str = ""  # the preset of which all tests run then, a room being a part
    leaving: str = "^$"  # and which of them do not
    environment: str = ""  # of these tests
    fuzzers: bool = False  # are the parts


def rooms_without_threads():
    """The rooms before the first that begins threads, but for the one that has the means to, and the oracles, whose tests
    say nothing about the library."""
    def begins(room):
        folders = (ROOT / "src" / room, ROOT / "include/toccata" / room)
        return any(BEGINS_THREADS.search(p.read_text()) for folder in folders for p in folder.rglob("*") if p.is_file())
    rooms = (ROOT / "tools/rooms.txt").read_text().split()
    return {"oracle", *itertools.takewhile(lambda room: room == "core" or not begins(room), rooms)}


def tested_rooms():
    return {p.parent.name for p in (ROOT / "tests").glob("*/*_test.cpp")}


def programs(rooms):
    return " ".join(f"test_{room}" for room in sorted(rooms))


STEPS = {
    # Without the second run under sanitizers, since the step asan has all tests run under these and more.
    "test": Step("lock_build_folder; configure_tests OFF; build release", ALL, "chromium assimp-utils", tests="release"),
    "asan": Step("configure asan-ubsan; build asan-ubsan", packages=SANITIZED, tests="asan-ubsan"),
    "peers": Step(f"configure release {WITH_CGAL} -DTOCCATA_BUILD_BENCH=ON -DTOCCATA_BENCH_WITH_PEERS=ON -DTOCCATA_BENCH_ONLY_TESTED=OFF; "
                  "build release toccata_bench $(programs_with_cgal); run_ctest release -R '^bench/|[Cc]gal'",
                  packages="$(cat tools/packages-bench-peers.txt)"),
    "page": Step("python3 tests/viewer/check_template.py --npm", ["apps/viewer", "tests/viewer"]),
    "clang": Step("configure clang; build clang", ALL, "clang", tests="clang", leaving=TEXTS),
    "debug": Step("configure debug; build debug", ALL, tests="debug", leaving="^python/|^viewer/|^repository/"),
    "tsan": Step(f"configure tsan; build tsan {programs(tested_rooms() - rooms_without_threads())}", packages=SANITIZED, tests="tsan",
                 leaving=f"^({'|'.join(sorted(rooms_without_threads()))})/", environment="TSAN_OPTIONS=ignore_noninstrumented_modules=1"),
    "tidy": Step("configure clang -DTOCCATA_BUILD_TESTS=ON; python3 tools/check_tidy.py --all", [*CODE, ".clang-tidy", "tools"], "clang clang-tidy"),
    "proofs": Step("python3 tools/check_proofs.py", [*CODE, "tools"]),
    # The command is built with the library, since the package's answers are compared with its.
    "python": Step("configure release -DTOCCATA_WITH_MPI=OFF; build release toccata_reports toccata_command; cmake --install build/release --prefix build/python/prefix >/dev/null; "
                   "python3 tools/check_wheel.py --prefix build/python/prefix",
                   [*CODE, "docs", "python", "pyproject.toml", "tools"], "python3-dev python3-venv"),
    # The bindings alone are compiled under sanitizers, against the libraries that the tests' second run has.
    "python-asan": Step("configure_tests ON; build release toccata_reports_sanitized; bash tools/test_python_sanitized.sh build/release",
                        [*CODE, "python", "tools"], "python3-dev python3-venv"),
    "formats": Step("configure release -DTOCCATA_BUILD_TESTS=ON -DTOCCATA_WITH_STEP=ON -DTOCCATA_WITH_ASSIMP=ON; "
                    "build release toccata_command toccata_read_step toccata_write_step toccata_read_assimp; add_ifc; python3 tests/formats/check_formats.py build/release/apps/toccata; "
                    "add_bcf_reader; for way in --reader '--schemas build/formats/bcf/schemas'; do "
                    "build/formats/bcf/bin/python tests/command/check_exchange.py build/release/apps/toccata/toccata $way; done",
                    packages="$(cat tools/packages-step.txt tools/packages-assimp.txt)"),
    # The room that needs MPI, on up to 8 ranks, and on 2 under sanitizers. The folder has then no such room any more.
    "ranks": Step("trap 'configure release -DTOCCATA_WITH_MPI=OFF' EXIT; configure release -DTOCCATA_BUILD_TESTS=ON -DTOCCATA_TEST_SANITIZED=ON -DTOCCATA_WITH_MPI=ON "
                  "'-DTOCCATA_TEST_RANKS=1;2;3;5;8' -DTOCCATA_TEST_RANKS_SANITIZED=ON; "
                  "build release test_distributed test_distributed_sanitized toccata_command toccata_check_ranks toccata_crowd_ranks toccata_bench_ranks; "
                  "run_ctest release -R '^distributed/|^package/find_distributed'",
                  packages="$(cat tools/packages-mpi.txt)"),
    "recipes": Step("python3 tools/check_recipes.py --build", [*CODE, "docs/design/recipes", "examples", "tools"]),
    "fuzz": Step("configure fuzz; build fuzz", packages=SANITIZED, fuzzers=True),
}


def git(*words):
    return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True).stdout


def fingerprint(paths):
    """One number for the files of ours at these paths."""
    digest = hashlib.sha256()
    for name in sorted(set(git("ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", *paths).split("\0"))):
        if (ROOT / name).is_file():
            digest.update(name.encode() + b"\0" + (ROOT / name).read_bytes())
    return digest.hexdigest()


def commit():
    """The commit, with a + when the folder differs from it."""
    changed = git("status", "--porcelain", "--", *ALL).strip()
    return (git("rev-parse", "--short=12", "HEAD").strip() or "unknown") + ("+" if changed else "")


def run_steps(script):
    shell = f"set -euo pipefail; source_folder={ROOT}; source tools/steps.sh; {script}"
    return subprocess.run(["bash", "-c", shell], cwd=ROOT).returncode


def record(step, seconds):
    file = EVIDENCE / "test-all.json"
    known = json.loads(file.read_text()) if file.exists() else {}
    known[step] = {"passed": commit(), "seconds": round(seconds)}
    EVIDENCE.mkdir(parents=True, exist_ok=True)
    unfinished = file.with_suffix(".unfinished")
    unfinished.write_text(json.dumps(known, indent=1) + "\n")
    unfinished.replace(file)


def stamped(name, sources):
    """How many seconds what passed for these sources took, or None."""
    stamp = STAMPS / name
    known, _, seconds = stamp.read_text().partition(" ") if stamp.exists() else ("", "", "")
    return float(seconds or 0) if known == sources else None


def passes_once(name, sources, script):
    """The seconds that the script took, now or before for the same sources; None where it fails."""
    before = stamped(name, sources)
    if before is not None:
        print(f"== {name}: passed before", flush=True)
        return before
    print(f"== {name}", flush=True)
    start = time.monotonic()
    if run_steps(script) != 0:
        return None
    seconds = time.monotonic() - start
    stamp = STAMPS / name
    stamp.parent.mkdir(parents=True, exist_ok=True)
    stamp.write_text(f"{sources} {seconds:.0f}")
    return seconds


def rooms_with_tests(preset, leaving):
    listed = subprocess.run(["ctest", "--test-dir", ROOT / "build" / preset, "--show-only=json-v1", "-E", leaving], capture_output=True, text=True, check=True)
    return sorted({test["name"].partition("/")[0] for test in json.loads(listed.stdout)["tests"]})


def parts_of(step):
    """(name, script) of each part, once the step's own script has run."""
    if step.tests:
        for room in rooms_with_tests(step.tests, step.leaving):
            yield room, f"{step.environment} run_ctest {step.tests} -R '^{room}(/|$)' -E '{step.leaving}'"
    if step.fuzzers:
        for fuzzer in sorted(p.stem.removesuffix("_fuzz") for p in (ROOT / "tests/fuzz").glob("*_fuzz.cpp")):
            known = f"../../tests/fuzz/corpus/{fuzzer}" if (ROOT / "tests/fuzz/corpus" / fuzzer).is_dir() else ""
            yield fuzzer, (f"mkdir -p build/fuzz/corpus/fuzz_{fuzzer}; cd build/fuzz; tests/fuzz/fuzz_{fuzzer} -max_total_time={FUZZ_SECONDS} "
                           f"-timeout=10 -rss_limit_mb=2048 corpus/fuzz_{fuzzer} {known}")


def passes(name):
    """Whether a step passes, now or before for the same sources. After a part that fails the others still run."""
    step = STEPS[name]
    sources = fingerprint(step.reads)
    if stamped(name, sources) is not None:
        print(f"== {name}: passed before, nothing changed", flush=True)
        return True
    print(f"== {name}", flush=True)
    start = time.monotonic()
    if run_steps(step.script) != 0:
        print(f"== {name}: failed", flush=True)
        return False
    took = [time.monotonic() - start, *(passes_once(f"{name}-{part}", sources, script) for part, script in parts_of(step))]
    if None in took:
        print(f"== {name}: failed", flush=True)
        return False
    record(name, sum(took))
    STAMPS.mkdir(parents=True, exist_ok=True)
    (STAMPS / name).write_text(f"{sources} {sum(took):.0f}")
    return True


def run_sweeps(options):
    print("== sweeps", flush=True)
    run = f"build/release/tests/toccata-sweeps --evidence docs/evidence --commit {commit()}"
    for name, value in (("minutes", options.minutes), ("scale", options.scale), ("cases", options.cases)):
        run += "" if value is None else f" --{name} {value}"
    run += " --anew" if options.anew else ""
    return run_steps(f"configure release {WITH_CGAL} -DTOCCATA_TEST_OPTIONS=-O2; build release toccata_sweeps; {run}") == 0


def install(chosen):
    wanted = " ".join(["libcgal-dev" if "sweeps" in chosen else "", *(STEPS[name].packages for name in STEPS if name in chosen)])
    return run_steps(f"install_packages packages packages-test; install_named {wanted}") == 0


def main():
    parser = argparse.ArgumentParser(prog="./toccata test --all")
    parser.add_argument("--only", nargs="+", choices=[*STEPS, "sweeps"], default=[*STEPS, "sweeps"])
    parser.add_argument("--minutes", type=float)
    parser.add_argument("--scale", type=float)
    parser.add_argument("--cases", type=int)
    parser.add_argument("--anew", action="store_true")
    options = parser.parse_args()
    if not install(options.only):
        return 2
    failed = [name for name in STEPS if name in options.only and not passes(name)]
    if "sweeps" in options.only and not run_sweeps(options):
        failed.append("sweeps")
    print(f"failed: {', '.join(failed)}" if failed else "all passed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
