"""A character that walks in a scene and in a world."""

import numpy
import pytest

import toccata

PERSON = toccata.Capsule((0, 0, 0.3), (0, 0, 1.5), 0.3)
FLOOR = (toccata.Box((20, 20, 0.5)), (0, 0, -0.5))
WALL = (toccata.Box((0.1, 20, 2)), (3, 0, 2))


def test_a_character_falls_walks_and_stops_at_a_wall():
    level = toccata.SceneIndex([FLOOR, WALL])
    state = toccata.SceneMoverState((0, 0, 1))
    assert state.ground is None
    step = level.move_character(PERSON, state, (0, 0, -2))
    assert step.state.ground.object == 0 and 0 < step.state.pose.offset[2] < 0.02 and numpy.allclose(step.state.ground.normal, (0, 0, 1))
    for _ in range(10):
        step = level.move_character(PERSON, step.state, (0.5, 0.1, 0))
    assert step.met_wall and not step.stuck and 2.5 < step.state.pose.offset[0] < 2.6 and numpy.isclose(step.state.pose.offset[1], 1)
    assert [contact.object for contact in step.contacts] == [1]
    level_alone = level.move_character(PERSON, step.state, (0.5, 0, 0), only=[True, False])
    assert level_alone.moved[0] == 0.5
    slid = toccata.velocity_along((1, 0, -1), [step.contacts[0].normal])
    assert numpy.allclose(slid, (0, 0, -1))


def test_a_character_climbs_steps_as_its_options_say():
    level = toccata.SceneIndex([FLOOR, (toccata.Box((2, 2, 0.1)), (2.6, 0, 0.1))])
    start = level.move_character(PERSON, toccata.SceneMoverState((0, 0, 0.1)), (0, 0, -1)).state
    up = level.move_character(PERSON, start, (1, 0, 0))
    assert up.stepped and up.state.pose.offset[2] > 0.2
    low = toccata.MoverOptions(step_height=0.1)
    assert low.step_height == 0.1 and not level.move_character(PERSON, start, (1, 0, 0), low).stepped
    for wrong in ({"skin": -1}, {"max_slope_degrees": 100}, {"max_slides": 0}, {"up": (0, 0, 0)}):
        with pytest.raises(toccata.Error):
            level.move_character(PERSON, start, (1, 0, 0), toccata.MoverOptions(**wrong))


def test_a_character_is_carried_by_what_moves():
    world = toccata.World()
    lift = world.add(*FLOOR, type=toccata.BodyType.kinematic_body)
    state = world.move_character(PERSON, toccata.BodyMoverState((0, 0, 0.5)), (0, 0, -1)).state
    assert state.ground.object == lift
    before = world[lift].pose
    world.move(lift, (0.25, 0, -0.25))
    step = world.move_character(PERSON, state, (0, 0, 0), moved=[(lift, before)])
    assert numpy.allclose(step.carried, (0.25, 0, 0.25)) and step.state.ground.object == lift
    for wrong in ([5], [(5, None)], "x", [(lift,)], [(lift, "x")]):
        with pytest.raises(toccata.Error):
            world.move_character(PERSON, state, (0, 0, 0), moved=wrong)
    with pytest.raises(toccata.Error):
        world.move_character(toccata.generate_mesh("box"), state, (0, 0, 0))


def test_pairs_of_a_world_without_a_step():
    world = toccata.World()
    a, b, c = (world.add(toccata.Sphere(1), (x, 0, 0)) for x in (0, 3, 4.5))
    assert world.any_contact() == (b, c) and world.any_within(0) == (b, c) and world.any_within(1.5) == (a, b)
    world.move(c, (9, 0, 0))
    assert world.any_contact() is None and world.any_within(0.5) is None
    near = world.least_distance()
    assert near[:2] == (a, b) and near[2] == toccata.distance(toccata.Sphere(1), toccata.Sphere(1), (0, 0, 0), (3, 0, 0))
    assert world.least_distance(0.5) is None
    with pytest.raises(toccata.Error):
        world.any_within(-1)
