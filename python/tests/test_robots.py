"""Robots: what Python answers is what it says, and batches are each alone."""

import math
import warnings

import numpy as np
import pytest

import toccata


@pytest.fixture(scope="module")
def robot():
    return toccata.Robot.generated()


@pytest.fixture(scope="module")
def scene(robot):
    return toccata.RobotScene(robot, [(toccata.Box((0.2, 0.2, 0.2)), toccata.Pose.translation(0.6, 0, 0.5), "crate")])


def test_a_robot_tells_what_it_is(robot):
    assert robot.links[0] == "base" and len(robot.links) == 8
    assert robot.positions == [f"joint {i}" for i in range(1, 8)]
    assert robot.limits.shape == (7, 2) and np.all(robot.limits[:, 0] < robot.limits[:, 1])
    assert np.array_equal(robot.rest(), np.zeros(7))


def test_link_poses_are_matrices(robot):
    many = robot.sampled(5)
    poses = robot.link_poses(many)
    assert poses.shape == (5, 8, 4, 4)
    assert np.array_equal(poses[3], robot.link_poses(many[3]))
    assert np.allclose(poses[..., :3, :3] @ np.swapaxes(poses[..., :3, :3], -1, -2), np.eye(3))
    upright = robot.link_poses(np.zeros(7))
    assert math.isclose(upright[7, 2, 3], 1.22, abs_tol=1e-12)


def test_batches_are_each_alone(scene, robot):
    many = robot.sampled(200, seed=3)
    found = scene.meets(many)
    assert found.dtype == bool and found.any() and not found.all()
    for one, expected in zip(many, found):
        assert scene.meets(one) == expected == bool(scene.contacts(one))
    assert np.array_equal(found, scene.meets(many, threads=1))


def test_gradients_are_those_of_small_changes(scene, robot):
    many = robot.sampled(30, seed=5)
    here = scene.distances(many)
    assert np.array_equal(here.upper == 0, scene.meets(many))
    off = 0
    for j in range(7):
        step = np.zeros(7)
        step[j] = 1e-6
        difference = (scene.distances(many + step).upper - scene.distances(many - step).upper) / 2e-6
        apart = here.upper > 1e-5
        off += np.sum(np.abs(difference - here.gradient[:, j])[apart] > 1e-4)
    assert off <= 4
    assert all(len(pair) == 2 for pair in here.pairs)


def test_edges_are_free_or_meet(scene, robot):
    begin, end = robot.sampled(40, seed=1), robot.sampled(40, seed=2)
    edges = scene.edges(begin, end)
    assert np.array_equal(edges.free, scene.free(begin, end))
    assert edges.free.any() or edges.free.size
    for i in range(40):
        if edges.free[i]:
            assert edges.pairs[i] is None
            between = begin[i] + np.linspace(0, 1, 50)[:, None] * (end[i] - begin[i])
            assert not scene.meets(between).any()
        else:
            assert edges.lower[i] <= edges.upper[i] and len(edges.pairs[i]) == 2


def test_allowed_pairs_and_attached_objects(robot):
    pairs = robot.allowed_pairs(200)
    assert ("base", "link 1", "adjacent") in pairs
    holding = robot.with_attached("cup", toccata.Sphere(0.05), "link 7", toccata.Pose.translation(0, 0, 0.15))
    wall = [(toccata.Box((1, 1, 0.01)), toccata.Pose.translation(0, 0, 1.42), "ceiling")]
    assert not toccata.RobotScene(robot, wall).meets(np.zeros(7))
    assert toccata.RobotScene(holding, wall).contacts(np.zeros(7)) == [("cup", "ceiling")]
    allowing = toccata.RobotScene(holding, wall, allowed=[("cup", "ceiling")])
    assert not allowing.meets(np.zeros(7))


URDF = """<robot name="two"><link name="a"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
<link name="b"><visual><geometry><sphere radius="0.1"/></geometry></visual></link>
<joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint></robot>"""


def test_urdf_is_read_and_warned_of(tmp_path):
    file = tmp_path / "two.urdf"
    file.write_text(URDF)
    try:
        with pytest.warns(UserWarning, match="link 'b' has a picture"):
            robot = toccata.Robot.from_urdf(str(file))
    except toccata.Error as error:
        pytest.skip(str(error))
    assert robot.positions == ["j"] and np.isinf(robot.limits).all()
    file.write_text(URDF.replace("continuous", "continuus"))
    with pytest.raises(toccata.Error, match="two.urdf:3: joint 'j' is of the type 'continuus'"):
        toccata.Robot.from_urdf(str(file))


@pytest.mark.parametrize("wrong", [np.zeros(6), np.zeros((2, 6)), np.zeros((1, 1, 7)), "seven", [[0] * 7, [0] * 6]])
def test_wrong_shapes_are_refused(scene, wrong):
    with pytest.raises(toccata.Error):
        scene.meets(wrong)


def test_what_is_not_finite_is_named(scene):
    many = np.zeros((3, 7))
    many[1, 2] = math.nan
    with pytest.raises(toccata.Error, match="configuration 1: the position of 'joint 3' is nan"):
        scene.meets(many)
    with pytest.raises(toccata.Error, match="no link 'lnk 7'"):
        toccata.Robot.generated().with_attached("cup", toccata.Sphere(1), "lnk 7")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        toccata.Robot.generated()
