#!/usr/bin/env python3
"""./toccata test --all: the tests of ./toccata test, then the long ones. Takes hours.

A step that passed is not run again for the same sources, so that this may be stopped and started at will; what passed,
for which commit and how long it took is kept in docs/evidence/test-all.json, the counts of the sweeps in
docs/evidence/<sweep>.json. `--only STEP…` runs some steps, `--minutes M` limits the sweeps.
"""
import argparse
import hashlib
import json
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
STAMPS = ROOT / "build/all"
EVIDENCE = ROOT / "docs/evidence"
FUZZ_SECONDS = 120

# What each step runs, in the words of tools/steps.sh.
STEPS = {
    "test": "run_tests",
    "asan": "configure asan-ubsan; build asan-ubsan; run_ctest asan-ubsan",
    "peers": "configure release -DTOCCATA_BUILD_TESTS=ON -DTOCCATA_BUILD_BENCH=ON -DTOCCATA_BENCH_WITH_PEERS=ON "
    "-DTOCCATA_BENCH_ONLY_TESTED=OFF -DTOCCATA_TEST_WITH_CGAL=ON; build release; run_ctest release -R '^bench/|[Cc]gal'",
    "page": "python3 tests/viewer/check_template.py --npm",
    "clang": "configure clang; build clang; run_ctest clang",
    "debug": "configure debug; build debug; run_ctest debug",
    "tsan": "configure tsan; build tsan; TSAN_OPTIONS=ignore_noninstrumented_modules=1 run_ctest tsan",
    "tidy": "configure clang -DTOCCATA_BUILD_TESTS=ON; build clang; python3 tools/check_tidy.py --all",
    "proofs": "python3 tools/check_proofs.py",
    # The library is compiled with the command, with which the package's answers are compared.
    "python": "configure release; build release; cmake --install build/release --prefix build/python/prefix >/dev/null; "
    "python3 tools/check_wheel.py --prefix build/python/prefix",
    "python-asan": "python3 -m venv build/python/asan; build/python/asan/bin/pip install --quiet nanobind numpy pytest hypothesis; "
    "cmake --preset asan-ubsan -B build/python/sanitized -DTOCCATA_BUILD_PYTHON=ON -DTOCCATA_BUILD_TESTS=OFF -DTOCCATA_BUILD_COMMAND=OFF "
    "-DTOCCATA_INSTALL=OFF -DTOCCATA_WARNINGS=OFF -DPython_EXECUTABLE=$PWD/build/python/asan/bin/python >/dev/null; "
    "ninja -C build/python/sanitized toccata_python; bash tools/test_python_sanitized.sh build/python/sanitized/python build/python/asan/bin/python",
    "recipes": "python3 tools/check_recipes.py --build",
    "fuzz": "configure fuzz; build fuzz; for f in build/fuzz/tests/fuzz/fuzz_*; do [[ -x $f && ! -d $f ]] || continue; "
    "known=../../tests/fuzz/corpus/${f##*/fuzz_}; [[ -d build/fuzz/$known ]] || known=; "
    f"(mkdir -p build/fuzz/corpus/${{f##*/}} && cd build/fuzz && ../../$f -max_total_time={FUZZ_SECONDS} -timeout=10 "
    "-rss_limit_mb=2048 corpus/${f##*/} $known); done",
}


def fingerprint():
    """One number for everything that the steps depend on."""
    digest = hashlib.sha256()
    for folder in ["apps", "cmake", "include", "src", "tests", "tools", "python", "CMakeLists.txt", "CMakePresets.json", ".clang-tidy"]:
        path = ROOT / folder
        for file in [path] if path.is_file() else sorted(p for p in path.rglob("*") if p.is_file() and "__pycache__" not in p.parts):
            digest.update(str(file.relative_to(ROOT)).encode() + b"\0" + file.read_bytes())
    return digest.hexdigest()


def commit():
    """The commit, with a + when the folder differs from it."""
    def git(*words):
        return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True).stdout.strip()
    changed = git("status", "--porcelain", "--", ".", ":!docs/evidence")
    return (git("rev-parse", "--short=12", "HEAD") or "unknown") + ("+" if changed else "")


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


def run_once(step):
    """Runs a step unless it passed for these sources; says whether it passes."""
    stamp, now = STAMPS / step, fingerprint()
    if stamp.exists() and stamp.read_text() == now:
        print(f"== {step}: passed before, nothing changed", flush=True)
        return True
    print(f"== {step}", flush=True)
    start = time.monotonic()
    if run_steps(STEPS[step]) != 0:
        print(f"== {step}: failed", flush=True)
        return False
    record(step, time.monotonic() - start)
    STAMPS.mkdir(parents=True, exist_ok=True)
    stamp.write_text(now)
    return True


def run_sweeps(minutes):
    print("== sweeps", flush=True)
    run = f"build/release/tests/toccata-sweeps --evidence docs/evidence --commit {commit()}"
    limit = f" --minutes {minutes}" if minutes else ""
    return run_steps(f"configure release -DTOCCATA_BUILD_TESTS=ON -DTOCCATA_TEST_WITH_CGAL=ON -DTOCCATA_TEST_OPTIONS=-O2; build release toccata_sweeps; {run}{limit}") == 0


def main():
    parser = argparse.ArgumentParser(prog="./toccata test --all")
    parser.add_argument("--only", nargs="+", choices=[*STEPS, "sweeps"], default=[*STEPS, "sweeps"])
    parser.add_argument("--minutes", type=float)
    options = parser.parse_args()
    if run_steps("install_packages packages packages-test packages-all") != 0:
        return 2
    failed = [step for step in STEPS if step in options.only and not run_once(step)]
    if "sweeps" in options.only and not run_sweeps(options.minutes):
        failed.append("sweeps")
    print(f"failed: {', '.join(failed)}" if failed else "all passed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
