"""The tests of trimesh and of python-fcl, as their authors publish them, run against what stands in for them.

The sources come from the package index: `pip download` puts them into the folder TOCCATA_SDISTS, or into
build/python/sdists. Lines that assert what is not so are replaced, and no others: docs/guide/from-trimesh.md and
docs/guide/from-python-fcl.md tell why.
"""

import os
import pathlib
import subprocess
import sys
import tarfile

import numpy
import pytest

import toccata

from conftest import SLICE

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SDISTS = pathlib.Path(os.environ.get("TOCCATA_SDISTS", ROOT / "build/python/sdists"))

# Two equal cubes may be parted along any axis, and have all their faces in common.
OF_EQUAL_CUBES = {
    "assert g.np.allclose(c.point, g.np.array([5.0, -0.5, 0.5]))": "assert (abs(c.point - (5, 0, 0)) <= 0.5).all()",
    "assert g.np.allclose(c.normal, g.np.array([-1.0, 0.0, 0.0]))": "assert sorted(abs(c.normal)) == [0, 0, 1]",
}

# Of 700 pairs trimesh's manager asks for every contact, to tell a name of each.
LONGEST = "CollisionTest::test_collision_batch"


def sources(name: str, version: str) -> pathlib.Path:
    """The folder with the published sources."""
    known = sorted(SDISTS.glob(f"{name}-{version}.tar.gz"))
    if not known:
        SDISTS.mkdir(parents=True, exist_ok=True)
        words = ["download", "--no-deps", "--no-binary", ":all:", "--dest", str(SDISTS), f"{name}=={version}"]
        run = subprocess.run([sys.executable, "-m", "pip", *words], capture_output=True, text=True)
        known = sorted(SDISTS.glob(f"{name}-{version}.tar.gz"))
        if not known:
            pytest.skip(f"the sources of {name} {version} are not there and could not be fetched: {run.stderr[-200:]}")
    return known[0]


def run_tests_of(archive: pathlib.Path, test: str, folder: pathlib.Path, in_place_of: str, changed: dict, leaving: list[str] | None = None) -> str:
    with tarfile.open(archive) as sdist:
        sdist.extractall(folder, filter="data")
    file = folder / archive.name.removesuffix(".tar.gz") / test
    text = file.read_text()
    for line, instead in changed.items():
        assert text.count(line) == 1, f"{test} has changed: {line}"
        text = text.replace(line, instead)
    file.write_text(text)
    path = os.pathsep.join([str(HERE / "drop_ins"), str(pathlib.Path(sys.modules["toccata"].__file__).parents[1])])
    words = [word for name in leaving or [] for word in ("--deselect", f"{file.name}::{name}")]
    words += ["-q", "-p", "toccata_in_place", "-p", "no:cacheprovider", "--rootdir", str(file.parent), str(file)]
    run = subprocess.run(
        [sys.executable, "-m", "pytest", *words],
        capture_output=True,
        text=True,
        cwd=file.parent,
        env={**os.environ, "PYTHONPATH": path, "TOCCATA_IN_PLACE_OF": in_place_of},
    )
    assert run.returncode == 0, run.stdout + run.stderr
    return run.stdout


@pytest.mark.parametrize("in_place_of", ["collision", "fcl"])
def test_trimesh_s_tests_of_collisions(tmp_path, in_place_of):
    """`collision`: toccata.trimesh for trimesh.collision; `fcl`: trimesh's own manager, which calls toccata.fcl."""
    trimesh = pytest.importorskip("trimesh")
    archive = sources("trimesh", trimesh.__version__)
    left = [LONGEST] if SLICE and in_place_of == "fcl" else []
    out = run_tests_of(archive, "tests/test_collision.py", tmp_path, in_place_of, OF_EQUAL_CUBES, left)
    assert f"{5 - len(left)} passed" in out, out


def test_python_fcl_s_tests(tmp_path):
    """Of the last version whose sources are on the index."""
    archive = sources("python-fcl", "0.0.12")
    out = run_tests_of(archive, "test/test_fcl.py", tmp_path, "fcl", {})
    assert "7 passed" in out, out


def test_what_is_read_of_a_shape_of_fcl_is_a_copy():
    """As there: a number of it that is changed changes neither the shape nor what is told of it."""
    from toccata import fcl

    box, far = fcl.Box(1, 1, 1), fcl.CollisionObject(fcl.Sphere(1), fcl.Transform(numpy.array([1.9, 0, 0])))
    assert fcl.collide(fcl.CollisionObject(box), far) == 0
    box.side[0] = 9
    assert box.side.tolist() == [1, 1, 1] and fcl.collide(fcl.CollisionObject(box), far) == 0
    box.side *= 2
    assert box.side.tolist() == [2, 2, 2] and fcl.collide(fcl.CollisionObject(box), far) == 1
    below = fcl.Halfspace(numpy.array([0, 0, 1.0]), 0)
    below.n[2] = -1
    assert below.n.tolist() == [0, 0, 1]


def test_what_is_no_mesh_is_told():
    from toccata import trimesh as collision

    class Scene:
        geometry: dict = {}

    for given, words in ((None, "NoneType"), ("ball.stl", "str"), (Scene(), "scene_to_collision")):
        with pytest.raises(toccata.Error, match=words):
            collision.CollisionManager().add_object("a", given)
