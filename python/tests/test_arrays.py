"""Which arrays are read as they lie, and which are converted first: docs/guide/python-batches.md, "What is copied"."""

import copy
import gc
import tracemalloc

import numpy
import pytest

import toccata
from conftest import SLICE

COUNT = 6_000 if SLICE else 20_000
RNG = numpy.random.default_rng(3)
BALL, BOX = toccata.Sphere(0.3), toccata.Box((1, 1, 1))


def numpy_bytes(ask) -> int:
    """The most memory that Python and numpy allocated meanwhile; the library's own is not seen."""
    ask()
    gc.collect()
    tracemalloc.start()
    try:
        ask()
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def matrices() -> numpy.ndarray:
    poses = numpy.tile(numpy.eye(4), (COUNT, 1, 1))
    poses[:, :3, 3] = RNG.uniform(-3, 3, (COUNT, 3))
    return poses


def height_field(heights: numpy.ndarray) -> toccata.Shape:
    return toccata.HeightField(heights)


ROBOT = toccata.Robot.generated(0)
LOWER = RNG.uniform(-9, 9, (COUNT, 1, 3))
READ_AS_THEY_LIE = {
    "matrices": (matrices(), lambda given: toccata.overlap_each(BALL, BOX, poses_b=given)),
    "matrices of 3×4": (matrices()[:, :3].copy(), lambda given: toccata.distance_each(BALL, BOX, poses_b=given)),
    "translations": (RNG.uniform(-3, 3, (COUNT, 3)), lambda given: toccata.overlap_each(BALL, BOX, poses_b=given)),
    "points": (RNG.uniform(-3, 3, (COUNT, 3)), lambda given: toccata.nearest_point_each(given, BOX)),
    "motions": (RNG.uniform(1, 3, (COUNT, 3)), lambda given: toccata.cast_shape_each(BALL, given, BOX)),
    "boxes": (numpy.concatenate([LOWER, LOWER + 0.1], axis=1), lambda given: toccata.BroadPhase().add(given)),
    "configurations": (ROBOT.sampled(COUNT), lambda given: ROBOT.link_poses_each(given)),
    "vertices": (RNG.uniform(-3, 3, (COUNT, 3)), lambda given: toccata.ConvexHull(given)),
    "heights": (RNG.uniform(0, 1, (200, 100)), height_field),
}


@pytest.mark.parametrize("name", READ_AS_THEY_LIE)
def test_doubles_in_c_order_are_read_as_they_lie(name):
    given, ask = READ_AS_THEY_LIE[name]
    assert given.dtype == numpy.float64 and given.flags.c_contiguous
    assert numpy_bytes(lambda: ask(given)) < given.nbytes / 20
    given.setflags(write=False)
    assert numpy_bytes(lambda: ask(given)) < given.nbytes / 20


@pytest.mark.parametrize("name", READ_AS_THEY_LIE)
def test_others_are_converted_and_answered_the_same(name):
    given, ask = READ_AS_THEY_LIE[name]
    wide = numpy.empty((*given.shape[:-1], 2 * given.shape[-1]))
    wide[..., ::2] = given
    for other in (numpy.asfortranarray(given), wide[..., ::2], given.astype(">f8"), given.astype(numpy.longdouble)):
        assert numpy_bytes(lambda: ask(other)) >= given.nbytes
    single = given.astype(numpy.float32)
    assert numpy_bytes(lambda: ask(single)) >= given.nbytes
    answers = [ask(one) for one in (given, numpy.asfortranarray(given), wide[..., ::2], given.astype(">f8"))]
    for answer in answers[1:]:
        assert numpy.array_equal(answer, answers[0]) if isinstance(answer, numpy.ndarray) else answer == answers[0]


def test_whole_numbers_of_eight_bytes_are_read_as_they_lie():
    """Those of triangles, from which the mesh takes numbers of four bytes."""
    numbers = numpy.arange(3 * COUNT).reshape(-1, 3)
    vertices = RNG.uniform(-1, 1, (3 * COUNT, 3))
    read = {kind: numpy_bytes(lambda kind=kind: toccata.Mesh(vertices, numbers.astype(kind))) - numpy_bytes(lambda kind=kind: numbers.astype(kind))
            for kind in ("int64", "uint64", "int32", "uint16")}
    assert read["int64"] < numbers.nbytes / 20 and read["uint64"] < numbers.nbytes / 20, read
    assert read["int32"] > numbers.nbytes / 2, read


def test_a_mesh_hands_out_its_own_memory():
    """To all who ask, and who may keep it longer than the mesh; nobody may write to it."""
    mesh = toccata.generate_mesh("torus-knot")
    vertices, faces = mesh.vertices, mesh.faces
    for shown, again in ((vertices, mesh.vertices), (faces, mesh.faces), (vertices, copy.copy(mesh).vertices)):
        assert numpy.shares_memory(shown, again) and not shown.flags.writeable
    given = vertices.copy()
    other = toccata.Mesh(given, faces)
    assert not numpy.shares_memory(other.vertices, given) and not numpy.shares_memory(other.faces, faces)
    before = vertices.copy()
    mesh.update(vertices + 1)
    assert not numpy.shares_memory(mesh.vertices, vertices) and numpy.array_equal(vertices, before)
    del mesh
    gc.collect()
    assert numpy.array_equal(vertices, before)


def test_answers_own_their_memory():
    """A structured array lies over what the library answered; its fields are views of it, and it may be written to."""
    poses = RNG.uniform(-3, 3, (COUNT, 3))
    assert numpy_bytes(lambda: toccata.distance_each(BALL, BOX, poses_b=poses)) < 10_000
    found = toccata.distance_each(BALL, BOX, poses_b=poses)
    assert numpy.shares_memory(found["upper"], found) and numpy.shares_memory(found["on_a"], found)
    again = toccata.distance_each(BALL, BOX, poses_b=poses)
    assert not numpy.shares_memory(found, again)
    again["upper"][:] = 7
    assert not (found["upper"] == 7).any()
