"""What moves and turns: sweeps, features that move, the volume that is passed."""

import copy
import gc
import weakref

import numpy
import pytest

import toccata
from conftest import matrices
from test_questions import same

BOX, BALL = toccata.Box((1, 0.5, 0.25)), toccata.Sphere(0.5)


def test_motions_begin_and_end_where_they_are_told():
    start, end = (toccata.Pose(m) for m in matrices(2, 3, 1))
    for motion in (
        toccata.RigidMotion.between(start, end),
        toccata.RigidMotion.screw(start, end),
        toccata.RigidMotion.through([0, 0.3, 1], [start, toccata.Pose(matrices(1, 2, 2)[0]), end]),
    ):
        assert copy.copy(motion).at(0.4) == motion.at(0.4)
        assert motion.at(0) == start and numpy.allclose(motion.at(1).matrix, end.matrix, atol=1e-12)
        assert numpy.allclose(numpy.linalg.det(motion.at(0.4).linear), 1)
    straight = toccata.RigidMotion.straight(start, (1, 2, 3))
    assert numpy.allclose(straight.at(0.5).offset, start.offset + (0.5, 1, 1.5))
    turning = toccata.RigidMotion(start, turns=0.25, axis=(0, 0, 2), centre=(1, 0, 0))
    (begin, finish, first, move), = turning.pieces
    assert (begin, finish, first, move) == (0, 1, start, ((1, 0, 0), (0, 0, 2), 0.25, (0, 0, 0)))
    carried = turning.carrying((1, 0, 0))
    assert numpy.allclose(carried.at(0.7).matrix, (turning.at(0.7) @ toccata.Pose((1, 0, 0))).matrix)
    for wrong in (lambda: turning.at(2), lambda: toccata.RigidMotion.through([0, 1], [start]), lambda: toccata.RigidMotion("pose")):
        with pytest.raises(toccata.Error):
            wrong()


def test_what_does_not_turn_is_a_cast():
    motions = numpy.random.default_rng(1).normal(size=(20, 3)) * 5
    for motion in motions:
        swept = toccata.sweep(BALL, toccata.RigidMotion.straight((3, 0, 0), motion), BOX)
        assert swept == toccata.cast_shape(BALL, motion, BOX, (3, 0, 0))


def test_a_turn_meets_what_no_straight_way_does(knot):
    """The box turns about its middle; the ball is beside it where it is at first."""
    turning = toccata.RigidMotion(None, turns=0.25)
    hit = toccata.sweep(BOX, turning, BALL, (0, 1.2, 0))
    assert hit and 0 < hit.lower <= hit.upper < 1
    assert not toccata.overlap(BOX, BALL, turning.at(hit.lower * 0.999), (0, 1.2, 0))
    assert toccata.overlap(BOX, BALL, turning.at(hit.upper * 1.001), (0, 1.2, 0))
    assert not toccata.sweep(BOX, turning, BALL, (0, 2, 0))
    near = toccata.sweep(BOX, turning, BALL, (0, 1.7, 0), stop_before=0.3)
    assert near and toccata.sweep(BOX, turning, BALL, (0, 1.7, 0)) is None
    motions = [toccata.RigidMotion.between(m, n) for m, n in zip(matrices(12, 3, 3), matrices(12, 3, 4))]
    for threads in (1, 2):
        rows = toccata.sweep_each(BOX, motions, knot, threads=threads)
        assert 0 < rows["found"].sum()
        assert all(same(toccata.sweep(BOX, motion, knot), row) for motion, row in zip(motions, rows))
    with pytest.raises(toccata.Error, match="motion 0"):
        toccata.sweep_each(BOX, [toccata.RigidMotion(numpy.zeros((3, 4)))], knot)


def test_features_that_move():
    starts = numpy.array([[[0.2, 0.2, 1], [0, 0, 0], [1, 0, 0], [0, 1, 0]], [[2, 2, 1], [0, 0, 0], [1, 0, 0], [0, 1, 0]]], dtype=float)
    ends = starts.copy()
    ends[:, 0, 2] = -1
    found = toccata.vertex_face_impacts(starts, ends)
    assert found["found"].tolist() == [True, False] and found["lower"][0] == found["upper"][0] == 0.5
    edges = toccata.edge_edge_impacts([[[-1, 0, 1], [1, 0, 1], [0, -1, 0], [0, 1, 0]]], [[[-1, 0, -1], [1, 0, -1], [0, -1, 0], [0, 1, 0]]])
    assert edges["found"].tolist() == [True] and edges["upper"][0] == 0.5
    with pytest.raises(toccata.Error, match=r"\(N, 4, 3\)"):
        toccata.vertex_face_impacts(starts, ends[:1])


def test_the_volume_that_is_passed():
    motion = toccata.RigidMotion(None, translation=(4, 0, 0), turns=0.5)
    volume, excess = toccata.swept_volume(BOX, motion)
    assert excess > 0
    for time in numpy.linspace(0, 1, 11):
        corner = motion.at(time).transform((0.99, 0.49, 0.24))
        assert toccata.overlap(volume, toccata.Point(corner))
    assert not toccata.overlap(volume, BALL, pose_b=(0, 4, 0))
    capsule, excess = toccata.swept_volume(BALL, toccata.RigidMotion.straight(None, (1, 0, 0)))
    assert excess == 0 and capsule == toccata.Capsule((0, 0, 0), (1, 0, 0), 0.5)


def test_a_motion_may_be_told_by_a_function(knot):
    """What turns evenly, told both ways: the time by the function is within what its bound allows."""
    box, ball = toccata.Box((1, 1, 1)), toccata.Sphere(0.5)
    turned = lambda s: toccata.Pose.rotation((0, 0, 1), 90 * s) * toccata.Pose((4 - 4 * s, 0, 0))  # noqa: E731
    motion = toccata.RigidMotion.of(turned, speed=8, turns=0.25)
    assert motion.at(0.5) == turned(0.5) and not motion.pieces
    hit = toccata.sweep(box, (0, 0, 0), ball, motion)
    assert hit and toccata.distance(box, ball, pose_b=turned(hit.lower)).upper < 1e-6 * 8
    assert all(not toccata.overlap(box, ball, pose_b=turned(s)) for s in numpy.linspace(0, hit.lower * 0.999, 50))
    assert not toccata.sweep(box, (9, 9, 9), ball, motion)
    hits = toccata.sweep_each(ball, [motion] * 4, box, threads=2)
    assert (hits["found"]).all() and len(set(hits["lower"].tolist())) == 1
    fast = toccata.RigidMotion.of(lambda s: (9 - 9 * s, 0, 0), speed=1)
    with pytest.raises(toccata.Error, match="faster"):
        toccata.sweep(box, (0, 0, 0), ball, fast)

    def broken(time: float) -> object:
        raise KeyError("a word of mine")

    for threads in (1, 2):
        with pytest.raises(KeyError, match="a word of mine"):
            toccata.sweep_each(ball, [toccata.RigidMotion.of(broken, speed=1)] * 3, box, threads=threads)
    for wrong in (lambda s: "x", lambda s: None if s else [1, 2], lambda s: numpy.full(3, numpy.nan)):
        with pytest.raises(toccata.Error):
            toccata.sweep(box, (0, 0, 0), ball, toccata.RigidMotion.of(wrong, speed=1))
    for speed in (-1, numpy.nan, numpy.inf):
        with pytest.raises(toccata.Error):
            toccata.RigidMotion.of(turned, speed=speed)
    with pytest.raises(TypeError):
        toccata.RigidMotion.of(5, speed=1)


class Way:
    """Leads on, and may hold the motion that it tells."""

    def __call__(self, time: float) -> tuple[float, float, float]:
        return (time, 0, 0)


def test_a_motion_and_its_function_that_hold_each_other_are_collected():
    for made in (lambda way: toccata.RigidMotion.of(way, speed=1), lambda way: toccata.RigidMotion.of(way, speed=1).carrying((0, 0, 1))):
        way = Way()
        way.motion = made(way)
        known, copy = weakref.ref(way), way.motion.carrying((0, 1, 0))
        del way
        gc.collect()
        assert known() is not None and copy.at(0.5).offset[:2].tolist() == [0.5, 1]
        del copy
        gc.collect()
        assert known() is None
