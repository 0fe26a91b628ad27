"""How deep, how much of it, and at which points two shapes overlap; and what of one is in a region."""

import itertools

import numpy
import pytest

import toccata
from conftest import SLICE, matrices, one_of_each
from test_questions import defined, same

BOX, BALL = toccata.Box((1, 1, 1)), toccata.Sphere(0.5)


def test_brackets_hold_and_are_as_narrow_as_asked():
    cube = toccata.generate_mesh("box")
    size = numpy.ptp(cube.vertices, axis=0)
    moved = (0.75 * size[0], 0.1, 0.05)
    narrow = toccata.depth_bracket(cube, cube, pose_b=moved, precision=0.02)
    assert narrow.lower <= 0.25 * size[0] * (1 + 1e-12) and 0.25 * size[0] <= narrow.upper * (1 + 1e-12)
    assert narrow.end == toccata.DepthEnd.precise and narrow.upper <= 1.02 * narrow.lower
    knot = toccata.generate_mesh("torus-knot")
    poses = matrices(2 if SLICE else 6, 1, 4)
    each = toccata.depth_bracket_each(knot, BOX, poses_b=poses, precision=0.5)
    for pose, row in zip(poses, each):
        assert same(toccata.depth_bracket(knot, BOX, pose_b=pose, precision=0.5), row)
        assert row["upper"] <= 1.5 * row["lower"] or row["end"] != toccata.DepthEnd.precise
    assert toccata.depth_bracket(knot, knot, time_limit=1e-9).upper >= 0
    for wrong in ({"precision": 0}, {"precision": float("nan")}, {"time_limit": 0}, {"time_limit": -1}):
        with pytest.raises(toccata.Error):
            toccata.depth_bracket(knot, knot, **wrong)


def test_how_much_two_solids_have_in_common():
    volume = toccata.overlap_volume(BOX, BOX, pose_b=(1.5, 0.5, 0))
    assert volume.lower <= 0.5 * 1.5 * 2 <= volume.upper and volume.upper - volume.lower < 1e-12
    assert toccata.overlap_volume(BOX, BOX, pose_b=(5, 0, 0)).upper == 0
    ball = toccata.overlap_volume(BALL, BOX)
    assert ball.lower <= 4 / 3 * numpy.pi / 8 <= ball.upper and ball.status == toccata.Status.not_converged
    with pytest.raises(toccata.Error):
        toccata.overlap_volume(BOX, toccata.Triangle([[0, 0, 0], [1, 0, 0], [0, 1, 0]]))


def test_manifolds_of_convex_shapes_are_their_manifold():
    shapes = [s for s in one_of_each() if defined(toccata.manifold, s, s)]
    some = 0
    for a, b in itertools.combinations(shapes, 2):
        if not defined(toccata.manifold, a, b):
            continue
        alone, found = toccata.manifold(a, b), toccata.manifolds(a, b)
        assert len(found) == (1 if len(alone) else 0)
        for manifold in found:
            some += 1
            assert numpy.array_equal(manifold.positions, alone.positions) and numpy.array_equal(manifold.normal, alone.normal)
            assert manifold.elements_a.shape == manifold.elements_b.shape == (len(alone),)
    assert some > 20
    cube = toccata.generate_mesh("box")
    top = float(cube.vertices[:, 2].max())
    (standing,) = toccata.manifolds(cube, BOX, pose_b=(0, 0, top + 0.99))
    assert isinstance(standing, toccata.Manifold) and standing.normal.tolist() == [0, 0, 1] and numpy.allclose(standing.depths, 0.01)


def test_manifolds_in_batches():
    poses = matrices(40, 1.5, 8)
    counts, normals, positions, depths = toccata.manifold_each(BOX, BALL, poses_b=poses)
    assert positions.shape == (40, 4, 3) and 0 < (counts > 0).sum() < 40
    for i, pose in enumerate(poses):
        alone = toccata.manifold(BOX, BALL, pose_b=pose)
        assert counts[i] == len(alone) and numpy.array_equal(normals[i], alone.normal)
        assert numpy.array_equal(positions[i, : counts[i]], alone.positions) and numpy.array_equal(depths[i, : counts[i]], alone.depths)


def test_the_first_contact_is_the_least(knot):
    for pose in matrices(20, 1.5, 6):
        first, rows = toccata.first_contact(knot, knot, pose_b=pose), toccata.contacts(knot, knot, pose_b=pose)
        assert (first is None) == (len(rows) == 0)
        assert first is None or same(first, rows[0])


def test_distances_within_a_limit_in_batches(knot):
    poses = matrices(40, 4, 6)
    found = toccata.distance_within_each(knot, BALL, 0.7, poses_b=poses)
    assert 0 < found["found"].sum() < 40
    for pose, row in zip(poses, found):
        alone = toccata.distance_within(knot, BALL, 0.7, pose_b=pose)
        assert (alone is not None) == row["found"]
        assert alone is None or all(numpy.array_equal(getattr(alone, name), row[name]) for name in row.dtype.names if name != "found")


def test_faces_in_regions_are_those_that_overlap_them(knot):
    rng = numpy.random.default_rng(5)
    triangles = [toccata.Triangle(knot.vertices[corners]) for corners in knot.faces]
    middles = knot.vertices[rng.integers(len(knot.vertices), size=4)]
    boxes = numpy.stack([middles - 0.2, middles + rng.uniform(0.05, 0.3, (4, 3))], axis=1)
    in_boxes = toccata.faces_in_region_each(knot, boxes=boxes)
    in_balls = toccata.faces_in_region_each(knot, centres=middles, radii=0.25)
    for i, (lower, upper) in enumerate(boxes):
        box = toccata.Box((upper - lower) / 2, (lower + upper) / 2)
        rows = toccata.faces_in_box(knot, lower, upper)
        assert rows["element"].tolist() == in_boxes["element"][in_boxes["query"] == i].tolist()
        near = {j for j, t in enumerate(triangles) if toccata.distance(t, box).upper < 1e-9}  # the box is rounded
        assert len(near) > 3 and set(rows["element"].tolist()) <= near and len(near - set(rows["element"].tolist())) <= 2
        ball = toccata.faces_in_ball(knot, middles[i], 0.25)["element"].tolist()
        assert ball == in_balls["element"][in_balls["query"] == i].tolist()
        assert ball == [j for j, t in enumerate(triangles) if toccata.overlap(t, toccata.Sphere(0.25, middles[i]))]
    for wrong in ({}, {"boxes": boxes, "radii": 1}, {"boxes": boxes[:, ::-1]}, {"centres": middles, "radii": -1}, {"centres": middles, "radii": [1, 2]}):
        with pytest.raises(toccata.Error):
            toccata.faces_in_region_each(knot, **wrong)


def test_points_among_many_shapes(knot):
    objects = [(knot, (0, 0, 0)), (BOX, (6, 0, 0)), toccata.SceneInstance(BALL, (0, 6, 0))]
    points = numpy.random.default_rng(1).uniform(-2, 8, (50, 3))
    near = toccata.nearest_points_each(points, 2, objects)
    signed = toccata.scene_signed_distance_each(points, objects)
    for i, point in enumerate(points):
        rows = near[near["query"] == i]
        alone = [toccata.nearest_point(point, shape, pose) for shape, pose in [*objects[:2], (BALL, (0, 6, 0))]]
        assert rows["upper"][0] == min(a.upper for a in alone) and (numpy.diff(rows["upper"]) >= 0).all() and len(rows) == 2
        assert numpy.isclose(abs(signed["upper"][i]), rows["upper"][0], rtol=1e-9) and signed["inside"][i] == (signed["side"][i] == toccata.Side.inside)
    inside = toccata.scene_signed_distance_each([[6, 0, 0]], objects)[0]
    assert inside["inside"] and inside["inside_of"] == inside["object"] == 1 and inside["lower"] <= -1 <= inside["upper"]
