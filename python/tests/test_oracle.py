"""Beside python-fcl: the same question, and the same answer within what doubles tell, or an explanation."""

import numpy
import pytest

import toccata
from conftest import matrices

fcl = pytest.importorskip("fcl", reason="python-fcl is not installed: nothing to compare with")


def of_fcl(shape):
    """The same shape in FCL."""
    if isinstance(shape, toccata.Sphere):
        return fcl.Sphere(shape.radius)
    if isinstance(shape, toccata.Box):
        return fcl.Box(*(2 * shape.half_extents))
    if isinstance(shape, toccata.Capsule):
        return fcl.Capsule(shape.radius, 2 * shape.end[2])
    if isinstance(shape, toccata.Cylinder):
        return fcl.Cylinder(shape.radius, 2 * shape.half_height)
    if isinstance(shape, toccata.Ellipsoid):
        return fcl.Ellipsoid(*shape.half_axes)
    model = fcl.BVHModel()
    model.beginModel(len(shape.vertices), len(shape.faces))
    model.addSubModel(shape.vertices, shape.faces)
    model.endModel()
    return model


CONVEX = [
    toccata.Sphere(0.5),
    toccata.Box((0.3, 0.4, 0.5)),
    toccata.Capsule((0, 0, -0.4), (0, 0, 0.4), 0.2),
    toccata.Cylinder(0.3, 0.5),
    toccata.Ellipsoid((0.2, 0.4, 0.6)),
]


def placed(shape, pose):
    return fcl.CollisionObject(of_fcl(shape), fcl.Transform(pose[:3, :3], pose[:3, 3]))


@pytest.mark.parametrize("a", CONVEX, ids=lambda s: s.kind)
@pytest.mark.parametrize("b", CONVEX, ids=lambda s: s.kind)
def test_distances_of_convex_shapes(a, b):
    """FCL's own tolerance is 1e-6; ours is an interval of 1e-12."""
    poses = matrices(60, 1.2, 13)
    found = toccata.distance_each(a, b, poses_b=poses)
    apart = 0
    for pose, answer in zip(poses, found):
        theirs = fcl.distance(placed(a, numpy.eye(4)), placed(b, pose))
        if answer["upper"] > 0.01:
            apart += 1
            assert abs(theirs - answer["upper"]) < 2e-3, (pose, theirs, answer)
    assert apart > 15


def test_meshes_that_touch_or_not(knot):
    """The surfaces alone: FCL does not know of an inside."""
    poses = matrices(60, 1.5, 17)
    ours = toccata.overlap_each(knot, knot, poses_b=poses, solid_a=toccata.Solid.none, solid_b=toccata.Solid.none)
    model = of_fcl(knot)
    still = fcl.CollisionObject(model, fcl.Transform())
    for pose, answer in zip(poses, ours):
        moved = fcl.CollisionObject(model, fcl.Transform(pose[:3, :3], pose[:3, 3]))
        assert (fcl.collide(still, moved, fcl.CollisionRequest(), fcl.CollisionResult()) > 0) == answer
    assert 0 < ours.sum() < len(poses)


def test_distances_of_meshes(knot):
    poses = matrices(20, 4, 19)
    found = toccata.distance_each(knot, knot, poses_b=poses)
    model = of_fcl(knot)
    for pose, answer in zip(poses, found):
        if answer["upper"] == 0:
            continue
        still = fcl.CollisionObject(model, fcl.Transform())
        moved = fcl.CollisionObject(model, fcl.Transform(pose[:3, :3], pose[:3, 3]))
        theirs = fcl.distance(still, moved, fcl.DistanceRequest(), fcl.DistanceResult())
        assert theirs == pytest.approx(answer["upper"], abs=1e-9)


def test_what_fcl_gets_wrong_and_is_told_exactly():
    """A small mesh within a large one: FCL says that they do not collide (its issue 492)."""
    outer = toccata.generate_mesh("icosphere", radius=2, subdivisions=2)
    inner = toccata.generate_mesh("icosphere", radius=0.5, subdivisions=2)
    theirs = fcl.collide(placed(outer, numpy.eye(4)), placed(inner, numpy.eye(4)), fcl.CollisionRequest(), fcl.CollisionResult())
    assert theirs == 0
    assert toccata.overlap(outer, inner)
