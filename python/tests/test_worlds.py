"""Bodies that move: a World's pairs are those of the questions about two."""

import copy
import pickle
import threading

import numpy
import pytest

import toccata
from conftest import SLICE, matrices

BOX, BALL = toccata.Box((0.5, 0.5, 0.5)), toccata.Sphere(0.4)


def pairs_of(step_pairs) -> set:
    rows = step_pairs.pairs
    return set(zip(rows["a"]["index"].tolist(), rows["b"]["index"].tolist()))


@pytest.mark.parametrize("threads", [1, 2])
def test_steps_tell_what_begins_persists_and_ends(knot, threads):
    shapes, count = [BOX, BALL, knot], 12 if SLICE else 30
    world = toccata.World(relation=True, distance=True, contacts=True, penetration=True, threads=threads)
    ids = world.add_each([shapes[i % 3] for i in range(count)], matrices(count, 3, 1))
    assert ids["index"].tolist() == list(range(count)) and len(world) == count
    before: set = set()
    for step_number in range(4):
        poses = matrices(count, 3, 10 + step_number)
        world.move(ids, poses)
        step = world.step()
        expected = {
            (i, j)
            for i in range(count)
            for j in range(i + 1, count)
            if toccata.overlap(shapes[i % 3], shapes[j % 3], poses[i], poses[j])
        }
        assert pairs_of(step.begin) == expected - before and pairs_of(step.persist) == expected & before
        assert pairs_of(step.end) == before - expected and pairs_of(world.pairs) == expected
        rows, kinds = world.pairs.pairs, world.pairs.relations
        for row, relation in zip(rows, kinds):
            i, j = row["a"]["index"], row["b"]["index"]
            told = toccata.relation(shapes[i % 3], shapes[j % 3], poses[i], poses[j])
            assert relation["kind"] == int(told.kind) and row["in_contact"]
        assert (world.pairs.distances["upper"] == 0).all()
        assert set(world.pairs.contacts["pair"].tolist()) <= set(range(len(rows)))
        assert world.any_overlap() == bool(expected)
        before = expected


def test_bodies_come_and_go():
    world = toccata.World()
    first = world.add(BOX, (0, 0, 0), name="first", user_data=7, type=toccata.BodyType.static_body)
    second = world.add(toccata.Body(BALL, (0.5, 0, 0), category=2, mask=1))
    assert first in world and second in world and 5 not in world
    assert world[first].name == "first" and world[first].user_data == 7 and world[first].shape == BOX
    assert len(world.step().begin) == 1
    world.replace(second, toccata.Body(BALL, (0.5, 0, 0), category=2, mask=2))
    assert len(world.step().end) == 1
    world.remove(first)
    assert first not in world and world.bodies["index"].tolist() == [second.index]
    for wrong in (lambda: world[first], lambda: world.remove(first), lambda: world.move(first, (0, 0, 0))):
        with pytest.raises(toccata.Error):
            wrong()
    assert pickle.loads(pickle.dumps(second)) == second and len({first, second, pickle.loads(pickle.dumps(first))}) == 2
    world.step()
    again = world.add(BOX)
    assert again.index == first.index and again != first


def test_margins_rules_and_filters():
    world = toccata.World(distance=True)
    ids = world.add_each(BALL, [[0, 0, 0], [1, 0, 0], [2, 0, 0]], margins=[0.1, 0.1, 0.2])
    assert pairs_of(world.step().begin) == {(0, 1), (1, 2)}
    assert world.pairs.distances["upper"] == pytest.approx([0.2, 0.2])
    a, b, c = (world_id(world, i) for i in range(3))
    world.set_rule(a, b, excluded=True)
    world.set_rule(a, c, margin=2.0)
    assert pairs_of(world.step().begin) == {(0, 2)}
    world.exclude(ids[:1], ids[2:])
    assert pairs_of(world.step().persist) == {(1, 2)}
    assert world.nearest(BALL, (0.1, 0, 0), only=toccata.BodyFilter(except_bodies=[a])).body == b
    assert world.overlapping(toccata.Sphere(5), only=toccata.BodyFilter(except_bodies=ids[1:]))["index"].tolist() == [0]
    assert len(world.overlapping(toccata.Sphere(5), only=toccata.BodyFilter(mask=2))) == 0
    with pytest.raises(toccata.Error):
        world.add(BALL, margin=-1.0)


def world_id(world: toccata.World, index: int) -> toccata.BodyId:
    """The id of a body as an object: that of what is nearest to where it is."""
    centre = world.boxes[index].mean(axis=0)
    return world.nearest(toccata.Point(centre)).body


def test_a_body_is_placed_by_a_matrix_as_it_is_moved(knot):
    placed, moved = toccata.World(), toccata.World()
    shapes, start, poses = [BOX, BALL, knot], matrices(6, 3, 1), matrices(6, 3, 2)
    ids = [[world.add(shapes[i % 3], start[i]) for i in range(6)] for world in (placed, moved)]
    assert numpy.array_equal(placed.poses, start)
    for i, pose in enumerate(poses):
        placed.place(ids[0][i], (pose, pose.tolist(), numpy.asfortranarray(pose), toccata.Pose(pose))[i % 4])
        moved.move(ids[1][i], pose)
    assert numpy.array_equal(placed.poses, poses) and numpy.array_equal(placed.boxes, moved.boxes)
    assert pairs_of(placed.step().begin) == pairs_of(moved.step().begin)
    placed.place(ids[0][0], None)
    assert placed[ids[0][0]].pose == toccata.Pose()
    placed.remove(ids[0][2])
    assert numpy.isnan(placed.poses[2]).all() and not numpy.isnan(placed.poses[3]).any()


def test_what_a_body_may_not_have_leaves_it_where_it_is():
    world, elsewhere = toccata.World(), toccata.World()
    ball, stranger = world.add(BALL, (1, 2, 3)), elsewhere.add(BALL)
    twice, nowhere, projection = 2 * numpy.eye(4), numpy.full((4, 4), numpy.nan), numpy.ones((4, 4))
    twice[3, 3] = 1
    for matrix in (nowhere, projection, twice, numpy.eye(3), numpy.eye(4)[:3], numpy.tile(numpy.eye(4), (1, 1, 1)), (1, 2, 3), "no", numpy.eye(4) * 1j):
        with pytest.raises(toccata.Error):
            world.place(ball, matrix)
    with pytest.raises(toccata.Error, match="of another World"):
        world.place(stranger, numpy.eye(4))
    assert world[ball].pose == toccata.Pose((1, 2, 3))


@pytest.mark.parametrize("count", [3, 200, 2500])
def test_whether_any_overlap_is_told_of_few_and_of_many(count):
    """With a tree around them and without; of boxes that have no end, too."""
    rng = numpy.random.default_rng(count)
    cells = numpy.stack(numpy.unravel_index(rng.permutation(16**3)[:count], (16, 16, 16)), axis=1)
    world = toccata.World()
    ids = world.add_each(toccata.Sphere(0.49), cells.astype(float))
    assert not world.any_overlap()
    for body in rng.integers(count, size=5):
        world.move(ids[body : body + 1], cells[body - 1] + [0.0, 0.0, 0.5])
        assert world.any_overlap()
        world.move(ids[body : body + 1], cells[body].astype(float))
        assert not world.any_overlap()
    ground = world.add(toccata.HalfSpace((0, 0, -1), (0, 0, 1)))
    assert not world.any_overlap()
    world.move(ground, (0, 0, 0.6))
    assert world.any_overlap()
    world.remove(world.bodies)
    assert not world.any_overlap()


def test_bodies_are_placed_while_another_thread_asks(knot):
    world = toccata.World()
    ids = [world.add(knot, (10.0 * i, 0, 0)) for i in range(4)]
    stop = threading.Event()
    errors: list = []

    def ask():
        try:
            while not stop.is_set():
                assert len(world.step().begin) + len(world.poses) + world.any_overlap() >= 4
        except BaseException as error:
            errors.append(error)

    asking = threading.Thread(target=ask)
    asking.start()
    for i in range(400 if SLICE else 4000):
        world.place(ids[i % 4], toccata.Pose((10.0 * (i % 4), i % 3, 0)).matrix)
    stop.set()
    asking.join()
    assert not errors


def test_snapshots_go_their_own_way():
    world = toccata.World()
    ids = world.add_each(BOX, [[0, 0, 0], [5, 0, 0]])
    world.step()
    kept = copy.copy(world)
    world.move(ids[1:], [0.5, 0, 0])
    assert world.any_overlap() and not kept.any_overlap()
    assert len(world.step().begin) == 1 and len(kept.step().begin) == 0 and len(copy.deepcopy(kept)) == 2


def test_nothing_tunnels():
    world = toccata.World()
    wall = world.add(toccata.Box((0.01, 5, 5)))
    ball = world.add(BALL, (-10, 0, 0))
    assert len(world.step().begin) == 0
    world.move_along(ball, toccata.RigidMotion.straight((-10, 0, 0), (20, 0, 0)))
    step = world.step()
    assert pairs_of(step.begin) == {(wall.index, ball.index)} and not step.begin.pairs["in_contact"][0]
    hit = step.begin.first_contacts[0]
    assert hit["lower"] == pytest.approx((10 - 0.41) / 20) and hit["pair"] == 0


def test_a_body_goes_from_where_its_motion_begins():
    """Wherever it was: what lies between is passed over."""
    world = toccata.World()
    world.add(toccata.Box((0.01, 5, 5)))
    ball = world.add(BALL, (-10, 0, 0))
    world.move_along(ball, toccata.RigidMotion.straight((10, 0, 0), (5, 0, 0)))
    assert world[ball].pose == toccata.Pose((15, 0, 0)) and len(world.step().begin) == 0
    world.move_along(ball, toccata.RigidMotion.straight((-10, 0, 0), (20, 0, 0)))
    assert len(world.step().begin) == 1


def test_queries_need_no_step(knot):
    poses = matrices(20, 3, 3)
    world, index = toccata.World(), toccata.SceneIndex([(knot, p) for p in poses])
    ids = world.add_each(knot, poses)
    asked = matrices(10, 3, 4)
    rows, expected = world.overlapping_each(BALL, asked), index.overlapping_each(BALL, asked)
    assert rows["query"].tolist() == expected["query"].tolist()
    assert rows["body"]["index"].tolist() == expected["object"].tolist()
    world.move(ids, poses + 0.0)
    world.move(ids[0], matrices(1, 50, 9)[0])
    assert world.nearest(BALL, matrices(1, 50, 9)[0]).body.index == 0
    assert world.cast_ray((0, 0, 90), (0, 0, -180)) is not None


def test_ids_of_other_things_are_refused():
    world = toccata.World()
    world.add(BOX)
    for wrong in (5, "body", [1], numpy.zeros(3), None):
        with pytest.raises((toccata.Error, TypeError)):
            world.remove(wrong)
    with pytest.raises(toccata.Error, match="BodyFilter"):
        world.overlapping(BOX, only=[True])
    assert len(world) == 1


def test_threads_share_a_world(knot):
    """While one thread moves and steps, others ask: every answer is of some state, and nothing breaks."""
    world = toccata.World()
    ids = world.add_each(knot, matrices(10, 2, 1))
    wrong: list = []
    stop = threading.Event()

    def ask() -> None:
        while not stop.is_set():
            found = world.nearest(BALL, (20, 0, 0))
            if not 5 < found.upper < 30 or len(world.overlapping(toccata.Sphere(40))) != 10:
                wrong.append(found)

    threads = [threading.Thread(target=ask) for _ in range(2)]
    for thread in threads:
        thread.start()
    for step in range(15 if SLICE else 40):
        world.move(ids, matrices(10, 2, step))
        world.step()
        assert world.boxes.shape == (10, 2, 3)
    stop.set()
    for thread in threads:
        thread.join()
    assert not wrong
