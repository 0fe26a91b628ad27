"""Questions about pairs and points, single and in batches."""

import itertools
import pickle

import numpy
import pytest

import toccata
from conftest import SLICE, matrices, one_of_each


def same(single, row):
    """An answer and the row of an array hold the same bits, or neither says anything."""
    is_told = "found" not in row.dtype.names or row["found"]
    if single is None or not is_told:
        return single is None and not is_told
    return all(numpy.array_equal(getattr(single, name), row[name]) for name in row.dtype.names if name != "found")


def defined(question, a, b):
    try:
        question(a, b)
    except toccata.Error:
        return False
    return True


def test_every_pair_of_kinds_answers_or_says_why():
    answered = 0
    for a, b in itertools.product(one_of_each(), repeat=2):
        assert toccata.overlap(a, b) == toccata.overlap(b, a)
        assert toccata.overlap(a, b) == (toccata.relation(a, b).kind != toccata.RelationKind.apart)
        assert toccata.overlap(a, b) == (toccata.distance(a, b).upper == 0)
        assert toccata.overlap(a, b) == toccata.within_distance(a, b, 0)
        for question in (toccata.penetration, toccata.manifold, lambda x, y: toccata.cast_shape(x, (1, 2, 3), y)):
            answered += defined(question, a, b)
    assert answered > 300


@pytest.mark.parametrize("threads", [1, 2, 0])
def test_batches_answer_as_single_questions(knot, threads):
    poses = matrices(15 if SLICE else 40, 2, 7)
    ball, box = toccata.Sphere(0.9), toccata.Box((0.9, 0.8, 0.7))
    for a, b in ((ball, box), (knot, box), (knot, knot)):
        overlaps = toccata.overlap_each(a, b, poses_b=poses, threads=threads)
        assert overlaps.dtype == bool and 0 < overlaps.sum() < len(poses)
        distances = toccata.distance_each(a, b, poses_b=poses, threads=threads)
        relations = toccata.relation_each(a, b, poses_b=poses, threads=threads)
        near = toccata.within_distance_each(a, b, 0.2, poses_b=poses, threads=threads)
        counts = toccata.count_contacts_each(a, b, poses_b=poses, threads=threads)
        for i, pose in enumerate(poses):
            assert overlaps[i] == toccata.overlap(a, b, pose_b=pose)
            assert same(toccata.distance(a, b, pose_b=pose), distances[i])
            assert same(toccata.relation(a, b, pose_b=pose), relations[i])
            assert near[i] == toccata.within_distance(a, b, 0.2, pose_b=pose)
            assert counts[i]["triangle_pairs"] == len(toccata.contacts(a, b, pose_b=pose))
    depths = toccata.penetration_each(box, ball, poses, threads=threads)
    assert all(same(toccata.penetration(box, ball, pose), depths[i]) for i, pose in enumerate(poses))


def test_poses_of_both_and_of_many_sorts():
    spatial = pytest.importorskip("scipy.spatial.transform")
    a, b = toccata.Box((1, 1, 1)), toccata.Box((0.5, 0.5, 0.5))
    poses = matrices(20, 2, 3)
    expected = toccata.distance_each(a, b, poses, poses[::-1])
    told = toccata.distance_each(a, b, [toccata.Pose(p) for p in poses], poses[::-1, :3])
    assert numpy.array_equal(expected, told)
    turns = spatial.Rotation.from_matrix(poses[:, :3, :3])
    assert len(toccata.distance_each(a, b, poses_b=turns)) == 20
    # Of scipy, of pairs, of all together, and of rotations and translations that are arrays of their own.
    rotations, places = poses[:, :3, :3].copy(), poses[:, :3, 3].copy()
    pairs = list(zip(rotations, places))
    for given in (pairs, pairs[:2], pairs[:3], list(zip(turns, places)), (rotations, places), [rotations, places], [*pairs[:2], toccata.Pose(poses[2])],
                  [poses[0], toccata.Pose(poses[1])], [poses[0], pairs[1], poses[2]]):
        count = len(given[0]) if len(given) == 2 and given[0] is rotations else len(given)
        assert numpy.allclose(toccata.distance_each(a, b, poses_b=given)["upper"], toccata.distance_each(a, b, poses_b=poses[:count])["upper"], atol=1e-12)
    for given in (list(turns), list(turns[:2]), [turns[0], toccata.Pose(), None]):
        assert len(toccata.distance_each(a, b, poses_b=given)) == len(given)
    assert numpy.allclose(toccata.distance_each(a, b, poses_b=(turns, (3, 0, 0)))["upper"], toccata.distance_each(a, b, poses_b=[(r, (3, 0, 0)) for r in rotations])["upper"], atol=1e-12)
    with pytest.raises(toccata.Error, match="\\(20, 3, 3\\) and \\(3, 3\\)"):
        toccata.distance_each(a, b, poses_b=(rotations, places[:3]))
    assert toccata.overlap_each(a, b, poses_b=[[0, 0, 0], [9, 0, 0], [1.5, 0, 0]]).tolist() == [True, False, True]
    assert toccata.overlap_each(a, b).tolist() == [True]
    assert toccata.overlap_each(a, b, poses_b=numpy.zeros((0, 4, 4))).shape == (0,)
    assert toccata.distance_each(a, b, poses_b=numpy.zeros((0, 4, 4)))["lower"].shape == (0,)
    with pytest.raises(toccata.Error, match="20 poses of a and 3 poses of b"):
        toccata.distance_each(a, b, poses, poses[:3])


def test_errors_of_batches_name_the_question():
    poses = matrices(10, 1, 1)
    poses[7, 0, 0] = numpy.nan
    with pytest.raises(toccata.Error, match="query 7"):
        toccata.distance_each(toccata.Sphere(1), toccata.Box((1, 1, 1)), poses_b=poses)
    poses[3, 3, 0] = 1
    with pytest.raises(toccata.Error, match="poses_b, pose 3"):
        toccata.distance_each(toccata.Sphere(1), toccata.Box((1, 1, 1)), poses_b=poses)
    with pytest.raises(toccata.Error, match="point 1"):
        toccata.nearest_point_each([[0, 0, 0], [numpy.inf, 0, 0]], toccata.Sphere(1))


def test_points_and_rays_in_batches(knot):
    rng = numpy.random.default_rng(11)
    points = rng.normal(size=(200, 3))
    pose = matrices(1, 0.3, 2)[0]
    near = toccata.nearest_point_each(points, knot, pose)
    signed = toccata.signed_distance_each(points, knot, pose)
    winding = toccata.generalized_winding_number_each(points, knot, pose)
    motions = rng.normal(size=(200, 3))
    hits = toccata.cast_ray_each(points, motions, knot, pose)
    assert 0 < hits["found"].sum() < 200
    for i in range(200):
        assert same(toccata.nearest_point(points[i], knot, pose), near[i])
        assert same(toccata.signed_distance(points[i], knot, pose), signed[i])
        assert same(toccata.generalized_winding_number(points[i], knot, pose), winding[i])
        assert same(toccata.cast_ray(points[i], motions[i], knot, pose), hits[i])
        side, number = toccata.locate(points[i], knot, pose)
        assert side == signed[i]["side"] and (number != 0) == (side == toccata.Side.inside)
    k = toccata.nearest_points(points[0], 5, knot, pose)
    assert len(k) == 5 and same(toccata.nearest_point(points[0], knot, pose), k[0])
    assert toccata.nearest_point((9, 9, 9), knot, max_distance=1) is None


def test_casts_in_batches(knot):
    motions = numpy.random.default_rng(3).normal(size=(30, 3)) * 3
    poses = matrices(30, 3, 4)
    ball = toccata.Sphere(0.2)
    hits = toccata.cast_shape_each(ball, motions, knot, poses)
    assert 0 < hits["found"].sum() < 30
    for i in range(30):
        assert same(toccata.cast_shape(ball, motions[i], knot, poses[i]), hits[i])


def test_what_triangles_have_in_common(knot):
    box = toccata.generate_mesh("box")
    contacts = toccata.contacts(knot, box, pose_b=(0.4, 0, 0))
    points = toccata.contacts_with_points(knot, box, pose_b=(0.4, 0, 0))
    assert len(contacts) > 20
    for name in contacts.dtype.names:
        assert numpy.array_equal(contacts[name], points[name])
    for row in points[:50]:
        for point in row["points"][: row["point_count"]]:
            assert toccata.nearest_point(point, knot).upper < 1e-12
            assert toccata.nearest_point(point, box, (0.4, 0, 0)).upper < 1e-12
    assert len(toccata.self_contacts(knot)) == 0 and not toccata.self_overlap(knot)
    crossed = toccata.Mesh(numpy.vstack([box.vertices, box.vertices + 0.3]), numpy.vstack([box.faces, box.faces + 8]))
    assert len(toccata.self_contacts(crossed)) > 0 and toccata.self_overlap(crossed)


def test_solid_or_surface():
    outer, inner = toccata.generate_mesh("box"), toccata.generate_mesh("icosphere", radius=0.1, subdivisions=1)
    assert toccata.overlap(outer, inner)
    assert not toccata.overlap(outer, inner, solid_a=toccata.Solid.none)
    assert toccata.relation(outer, inner).containment == toccata.Containment.b_in_a
    assert toccata.cast_ray((0, 0, 0), (9, 0, 0), outer).upper == 0
    assert toccata.cast_ray((0, 0, 0), (9, 0, 0), outer, solid=toccata.Solid.none).upper > 0
    with pytest.raises(toccata.Error, match="open"):
        toccata.overlap(toccata.Mesh(outer.vertices, outer.faces[1:]), inner, solid_a=toccata.Solid.all)


def test_manifolds():
    crate = toccata.Box((1, 1, 1))
    patch = toccata.manifold(crate, crate, pose_b=(0, 0, 1.9))
    assert len(patch) == 4 and patch.positions.shape == (4, 3)
    assert numpy.allclose(patch.depths, 0.1) and patch.normal.tolist() == [0, 0, 1]
    assert not toccata.manifold(crate, crate, pose_b=(0, 0, 5))


def test_answers_are_values():
    a, b = toccata.Sphere(1), toccata.Box((1, 1, 1))
    answers = [
        toccata.distance(a, b, pose_b=(0, 3, 0)),
        toccata.penetration(a, b),
        toccata.relation(a, b),
        toccata.cast_ray((-5, 0, 0), (9, 0, 0), b),
        toccata.cast_shape(a, (9, 0, 0), b, (-5, 0, 0)),
        toccata.nearest_point((1, 2, 3), b),
        toccata.signed_distance((1, 2, 3), b),
    ]
    for i, answer in enumerate(answers):
        assert pickle.loads(pickle.dumps(answer)) == answer
        assert repr(answer).startswith(type(answer).__name__ + "(")
        assert [answer == other for other in answers] == [i == j for j in range(len(answers))]
        with pytest.raises(AttributeError):
            answer.status = toccata.Status.exact
    assert answers[0].status is toccata.Status.exact
