"""What the tests share: shapes of every kind, poses, and the seeds of what is random."""

import os

import numpy
import pytest

import toccata

# The test python/wheel looks at a part of what is tried at random; --all and the package's own tests at all of it.
SLICE = bool(os.environ.get("TOCCATA_TEST_SLICE"))


def in_slices(count: int) -> int:
    """So many, or a tenth."""
    return max(1, count // 10) if SLICE else count


def rotation(rng: numpy.random.Generator) -> numpy.ndarray:
    """A random rotation, as a matrix of 3×3."""
    q = rng.normal(size=4)
    return toccata.Pose.from_quaternion(q).linear


def matrices(count: int, spread: float, seed: int) -> numpy.ndarray:
    rng = numpy.random.default_rng(seed)
    poses = numpy.tile(numpy.eye(4), (count, 1, 1))
    for pose in poses:
        pose[:3, :3] = rotation(rng)
        pose[:3, 3] = rng.uniform(-spread, spread, 3)
    return poses


def one_of_each() -> list:
    rng = numpy.random.default_rng(5)
    return [
        toccata.Point((0.1, 0.2, 0.3)),
        toccata.Segment((0, 0, 0), (1, 2, 3)),
        toccata.Triangle([[0, 0, 0], [1, 0, 0], [0, 1, 0]]),
        toccata.HalfSpace((0, 0, 0), (0, 1, 1)),
        toccata.Sphere(0.7, (0.1, 0, 0)),
        toccata.Box((0.5, 0.6, 0.7)),
        toccata.Capsule((0, 0, 0), (0, 0, 1), 0.3),
        toccata.ConvexHull(rng.normal(size=(30, 3))),
        toccata.Rounded(toccata.Box((0.3, 0.4, 0.5)), 0.1),
        toccata.Cylinder(0.5, 0.8),
        toccata.Cone(0.5, 0.8),
        toccata.Ellipsoid((0.3, 0.5, 0.9)),
        toccata.HeightField(rng.uniform(0, 1, (4, 5)), (0.5, 0.25)),
        toccata.generate_mesh("icosphere", radius=0.8, subdivisions=2),
        toccata.Compound([toccata.Sphere(0.4), (toccata.Box((0.2, 0.2, 0.9)), (0.5, 0, 0))]),
    ]


@pytest.fixture(scope="session")
def knot() -> toccata.Mesh:
    """Of a third of the triangles in a slice."""
    return toccata.generate_mesh("torus-knot", **({"around": 120, "sides": 8} if SLICE else {}))


@pytest.fixture(params=one_of_each(), ids=lambda shape: shape.kind)
def shape(request: pytest.FixtureRequest) -> toccata.Shape:
    return request.param
