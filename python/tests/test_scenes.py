"""Many posed shapes: SceneIndex, check_all, contacts of many. Each answer is that of the questions about two."""

import pickle

import numpy
import pytest

import toccata
from conftest import matrices, one_of_each
from test_questions import same

BALL, BOX = toccata.Sphere(0.6), toccata.Box((0.5, 0.6, 0.7))


def parts(knot: toccata.Mesh, count: int = 24) -> list:
    """Objects of several kinds, some of which meet."""
    shapes = [knot, BALL, BOX, toccata.Capsule((0, 0, 0), (0, 0, 1), 0.3)]
    return [(shapes[i % 4], pose) for i, pose in enumerate(matrices(count, 3, 31))]


@pytest.fixture(scope="module")
def scene(knot) -> tuple:
    objects = parts(knot)
    return objects, toccata.SceneIndex(objects)


def test_lists_are_those_of_every_object(scene):
    objects, index = scene
    assert len(index) == len(objects)
    for pose in matrices(10, 3, 5):
        meeting = [i for i, (s, p) in enumerate(objects) if toccata.overlap(BALL, s, pose, p)]
        assert index.overlapping(BALL, pose).tolist() == meeting
        near = [i for i, (s, p) in enumerate(objects) if toccata.within_distance(BALL, s, 0.5, pose, p)]
        assert index.within(BALL, 0.5, pose).tolist() == near
        rows = index.relations(BALL, pose)
        assert rows["object"].tolist() == meeting
        for row in rows:
            shape, placed = objects[row["object"]]
            relation = toccata.relation(BALL, shape, pose, placed)
            assert row["kind"] == int(relation.kind) and row["containment"] == int(relation.containment)


def test_the_nearest_is_the_least_of_all(scene):
    objects, index = scene
    for pose in matrices(10, 6, 6):
        found = index.nearest(BOX, pose)
        each = [toccata.distance(BOX, s, pose, p) for s, p in objects]
        assert found.upper == min(d.upper for d in each)
        assert each[found.object].upper == found.upper and numpy.array_equal(each[found.object].on_a, found.on_a)
        assert index.nearest(BOX, pose, found.lower * 0.9 - 1e-9 if found.upper else -0.0) is None or found.upper == 0


def test_rays_and_moving_shapes_meet_the_first(scene):
    objects, index = scene
    rng = numpy.random.default_rng(8)
    origins, motions = rng.normal(size=(40, 3)) * 4, rng.normal(size=(40, 3)) * 6
    rays = index.cast_ray_each(origins, motions)
    casts = index.cast_shape_each(BALL, motions, origins)
    assert 0 < rays["found"].sum() < 40 and 0 < casts["found"].sum() < 40
    for i in range(40):
        hits = [toccata.cast_ray(origins[i], motions[i], s, p) for s, p in objects]
        first = min((h.upper, k) for k, h in enumerate(hits) if h) if any(hits) else None
        single = index.cast_ray(origins[i], motions[i])
        assert (single is None) == (first is None) == (not rays[i]["found"])
        if first is not None:
            assert (single.upper, single.object) == first and same(single, rays[i][list(rays.dtype.names[1:])])
            through = index.cast_ray_through(origins[i], motions[i])
            assert sorted(through["object"].tolist()) == [k for k, h in enumerate(hits) if h]
        moved = [toccata.cast_shape(BALL, motions[i], s, origins[i], p) for s, p in objects]
        cast = index.cast_shape(BALL, motions[i], origins[i])
        assert (cast is None) == (not any(moved)) == (not casts[i]["found"])
        if cast is not None:
            assert cast.upper == min(h.upper for h in moved if h) and same(cast, casts[i][list(casts.dtype.names[1:])])


@pytest.mark.parametrize("threads", [1, 2, 0])
def test_batches_are_rows_of_single_answers(scene, threads):
    objects, index = scene
    poses = matrices(15, 3, 9)
    rows = index.overlapping_each(BALL, poses, threads=threads)
    near = index.within_each([BALL] * 15, 0.4, poses, threads=threads)
    nearest = index.nearest_each(BALL, poses, threads=threads)
    for i, pose in enumerate(poses):
        assert rows["object"][rows["query"] == i].tolist() == index.overlapping(BALL, pose).tolist()
        assert near["object"][near["query"] == i].tolist() == index.within(BALL, 0.4, pose).tolist()
        assert nearest[i]["object"] == index.nearest(BALL, pose).object


def test_only_some_are_asked(scene):
    objects, index = scene
    only = numpy.arange(len(objects)) % 2 == 1
    pose = (0, 0, 0)
    every = index.overlapping(toccata.Sphere(3), pose)
    assert index.overlapping(toccata.Sphere(3), pose, only=only).tolist() == [i for i in every if only[i]]
    assert index.nearest(BALL, pose, only=numpy.zeros(len(objects))) is None
    with pytest.raises(toccata.Error, match="24 truths"):
        index.overlapping(BALL, only=[True])


def test_instances_pickle_and_compare(scene):
    objects, index = scene
    again = pickle.loads(pickle.dumps(index))
    assert again.objects == index.objects
    crate = toccata.SceneInstance(BOX, (1, 2, 3), toccata.Solid.all, "crate", "left")
    kept = pickle.loads(pickle.dumps(crate))
    assert (kept.solid, kept.name, kept.group) == (toccata.Solid.all, "crate", "left") and kept == crate
    assert crate != toccata.SceneInstance(BOX, (1, 2, 3))
    assert crate.name in repr(crate) and crate.shape == BOX and crate.pose == toccata.Pose((1, 2, 3))


def test_check_all_tells_what_pierces_and_what_decided_the_tolerance():
    plate, rod = (toccata.generate_mesh("box", half_x=x, half_y=y, half_z=z) for x, y, z in [(2, 2, 0.25), (0.5, 0.25, 2)])
    for objects, way in [((plate, rod), toccata.ClashPiercing.b_through_a), ((rod, plate), toccata.ClashPiercing.a_through_b)]:
        (pair,) = toccata.check_all(objects, volume=True).pairs
        assert pair["clash"] == toccata.ClashKind.pierce and pair["piercing"] == way
    within, beyond = (toccata.check_all([plate, rod], tolerance=length) for length in (0.6, 0.4))  # half of what both are thick
    assert within.pairs["tolerance"][0] == toccata.ClashTolerance.within
    assert within.local_depths["pair"][0] == 0 and 0.5 - 1e-9 <= within.local_depths["upper"][0] <= 0.6
    assert beyond.pairs["tolerance"][0] == toccata.ClashTolerance.beyond
    assert 0.4 < beyond.local_depths["lower"][0] <= 0.5 and len(beyond.penetrations) == 0


def test_check_all_is_every_pair(knot):
    objects = parts(knot, 16)
    answer = toccata.check_all(objects, contacts=True, penetration=True, clearance=0.2)
    expected = []
    for i in range(16):
        for j in range(i + 1, 16):
            (a, p), (b, q) = objects[i], objects[j]
            if toccata.within_distance(a, b, 0.2, p, q):
                expected.append((i, j, int(toccata.relation(a, b, p, q).kind)))
    assert list(zip(*(answer.pairs[name].tolist() for name in ("a", "b", "kind")))) == expected
    assert len(answer) == len(expected) and answer.candidate_pairs >= len(expected)
    for row in answer.distances:
        i, j = answer.pairs[row["pair"]]["a"], answer.pairs[row["pair"]]["b"]
        assert row["upper"] == toccata.distance(objects[i][0], objects[j][0], objects[i][1], objects[j][1]).upper
    first = answer.pairs[0]
    (a, p), (b, q) = objects[first["a"]], objects[first["b"]]
    assert (answer.contacts["pair"] == 0).sum() == len(toccata.contacts(a, b, p, q))
    solids = [row for row in answer.penetrations if row["lower"] > 0]
    assert solids and all(row["lower"] <= row["upper"] for row in solids)
    grouped = [toccata.SceneInstance(s, p, group="all") for s, p in objects]
    assert len(toccata.check_all(grouped)) == 0
    assert len(toccata.check_all(objects, pair_clearances=[(0, 15, 100.0)])) >= 1


def test_pairs_of_shapes_in_one_batch(knot):
    shapes = one_of_each()
    poses = matrices(len(shapes), 1, 3)
    found = toccata.overlap_each(shapes, BOX, poses)
    assert found.tolist() == [toccata.overlap(s, BOX, p) for s, p in zip(shapes, poses)]
    lengths = toccata.distance_each(shapes, shapes[::-1], poses)
    assert all(same(toccata.distance(a, b, p), row) for a, b, p, row in zip(shapes, shapes[::-1], poses, lengths))
    with pytest.raises(toccata.Error, match="15 shapes a and 3 poses of b"):
        toccata.overlap_each(shapes, BOX, poses_b=poses[:3])
    with pytest.raises(toccata.Error, match="entry 1 is no shape"):
        toccata.overlap_each([BOX, 5], BOX)


def test_contacts_and_regions_of_many(knot):
    poses = matrices(12, 1, 4)
    rows = toccata.contacts_each(knot, knot, poses_b=poses)
    regions = toccata.contact_regions_each(knot, knot, poses_b=poses)
    for i, pose in enumerate(poses):
        single = toccata.contacts(knot, knot, pose_b=pose)
        mine = rows[rows["query"] == i]
        assert all(numpy.array_equal(mine[name], single[name]) for name in single.dtype.names)
        places = toccata.contact_regions(knot, knot, pose_b=pose)
        mine = regions[regions["query"] == i]
        assert all(numpy.array_equal(mine[name], places[name]) for name in places.dtype.names)
        assert (places["depth_lower"] <= places["depth_upper"]).all()
    crossed = toccata.Mesh(numpy.vstack([knot.vertices, knot.vertices + 0.1]), numpy.vstack([knot.faces, knot.faces + len(knot.vertices)]))
    found = toccata.self_contacts_each([knot, crossed, BALL])
    assert set(found["object"].tolist()) == {1}
    assert len(found) == len(toccata.self_contacts(crossed))


def test_lists_that_look_like_a_pose():
    """Two translations are no pair (R, t), and neither are two poses or matrices."""
    a, b = toccata.Sphere(1), toccata.Sphere(1)
    expected = [True, False]
    for poses in ([[0, 0, 0], [9, 0, 0]], [toccata.Pose(), toccata.Pose((9, 0, 0))], list(numpy.array([numpy.eye(4), [[1, 0, 0, 9], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]]))):
        assert toccata.overlap_each(a, b, poses_b=poses).tolist() == expected
    assert toccata.overlap_each(a, b, poses_b=(numpy.eye(3), [9, 0, 0])).tolist() == [False]
    assert toccata.overlap_each(a, b, poses_b=[[[1, 0, 0], [0, 1, 0], [0, 0, 1]], [9, 0, 0]]).tolist() == [False]
