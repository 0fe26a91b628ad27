"""Robots: what Python answers is what the library answers, to the bit, and batches are each alone."""

import copy
import gc
import itertools
import math
import pickle
import threading
import time
import warnings

import numpy
import pytest

import toccata
from conftest import SLICE, in_slices
from test_bits import COMMAND, asked, scene_of, written

# Of batches that are compared with their questions one by one.
COUNT = 15 if SLICE else 60
CRATE = toccata.SceneInstance(toccata.Box((0.2, 0.2, 0.2)), (0.6, 0, 0.5), name="crate")


@pytest.fixture(scope="module")
def robot() -> toccata.Robot:
    return toccata.Robot.generated()


@pytest.fixture(scope="module")
def scene(robot) -> toccata.RobotScene:
    return toccata.RobotScene(robot, [CRATE])


def planar() -> toccata.Robot:
    """Two boxes of length 1 in a plane, and a ball that slides out of the second."""
    bar = (toccata.Box((0.5, 0.1, 0.1)), (0.5, 0, 0))
    kind = toccata.RobotJointKind
    joints = [
        toccata.RobotJoint("shoulder", kind.continuous, "ground", "upper", axis=(0, 0, 2)),
        toccata.RobotJoint("elbow", kind.revolute, "upper", "lower", (1, 0, 0), (0, 0, 1), limits=(-3, 3)),
        toccata.RobotJoint("slide", kind.prismatic, "lower", "tip", (1, 0, 0), limits=(0, 1)),
    ]
    return toccata.Robot({"ground": [], "upper": [bar], "lower": [bar], "tip": [toccata.Sphere(0.1)]}, joints, "planar")


def test_a_robot_tells_what_it_is(robot):
    assert robot.links[0] == "base" and len(robot.links) == 8
    assert [p.name for p in robot.positions] == [j.name for j in robot.joints] == [f"joint {i}" for i in range(1, 8)]
    assert robot.limits.shape == (7, 2) and numpy.all(robot.limits[:, 0] < robot.limits[:, 1])
    assert numpy.array_equal(robot.rest(), numpy.zeros(7)) and robot.beyond_limits(numpy.zeros(7)) is None
    assert robot.beyond_limits(numpy.full(7, 99.0)) == 0 and robot.link_of("link 3") == 3
    assert all(p.turns and p.limits == tuple(limits) for p, limits in zip(robot.positions, robot.limits))


def test_a_robot_is_described_by_its_links_and_joints():
    robot = planar()
    assert robot.links == ["ground", "upper", "lower", "tip"] and robot.name == "planar"
    assert [(p.name, p.turns, p.limits) for p in robot.positions] == [
        ("shoulder", True, None), ("elbow", True, (-3, 3)), ("slide", False, (0, 1))]
    scene = toccata.RobotScene(robot, [(toccata.Box((0.2, 0.2, 0.2)), (0, 1.5, 0))])
    assert not scene.meets([0, 0, 0.5])
    contacts = scene.contacts([math.pi / 2, 0, 0])
    assert [scene.names(contact) for contact in contacts] == [("lower", "obstacle 0")]
    assert [shape.shape.kind for shape in robot.posed([0, 0, 0.5])] == ["box", "box", "sphere"]
    assert scene.looks_at(1, 3) and not scene.looks_at(1, 2) and scene.looks_at(3, 0, True)
    follower = toccata.RobotJoint("b", toccata.RobotJointKind.revolute, "one", "two", limits=(-1, 1), mimic=("a", 2, 0.5))
    leader = toccata.RobotJoint("a", toccata.RobotJointKind.revolute, "zero", "one", limits=(-1, 1))
    both = toccata.Robot({"zero": [], "one": [], "two": []}, [leader, follower])
    assert len(both.positions) == 1 and follower.mimic == ("a", 2, 0.5)
    turned = both.link_poses([0.25])[2]
    assert math.isclose(turned[2, 1], math.sin(0.25 + 2 * 0.25 + 0.5), rel_tol=1e-12)


def test_robots_and_joints_are_values(robot):
    again = pickle.loads(pickle.dumps(robot))
    many = robot.sampled(20)
    assert numpy.array_equal(again.link_poses_each(many), robot.link_poses_each(many))
    assert again.joints == robot.joints and copy.copy(robot).links == robot.links
    moved = toccata.Robot({"a": [toccata.Sphere(1)]}, base=(1, 2, 3))
    assert pickle.loads(pickle.dumps(moved)).link_poses([])[0, :3, 3].tolist() == [1, 2, 3]
    assert "joint 1" in repr(robot.joints[0]) and "7 positions" in repr(robot)
    holding = robot.with_attached("cup", toccata.Sphere(0.05), "link 7")
    assert pickle.loads(pickle.dumps(holding)) == holding != robot == again


def test_scenes_hold_their_robot_and_are_copied_and_pickled():
    scene = toccata.RobotScene(toccata.Robot.generated(1), [CRATE])
    gc.collect()
    many = scene.robot.sampled(50)
    meets = scene.meets_each(many)
    for again in (copy.copy(scene), copy.deepcopy(scene), pickle.loads(pickle.dumps(scene)), toccata.RobotScene(scene.robot, scene.obstacles)):
        assert 0 < meets.sum() < 50 and numpy.array_equal(again.meets_each(many), meets)


def test_names_are_any_text():
    """Also with a NUL in them, which ends a string of C; but surrogates by themselves are no text."""
    joint = toccata.RobotJoint("j\0", toccata.RobotJointKind.revolute, "a\0b", "a\0c", limits=(-1, 1))
    robot = toccata.Robot({"a\0b": [toccata.Sphere(1)], "a\0c": [toccata.Sphere(1)]}, [joint], "n\0")
    for told in (robot, pickle.loads(pickle.dumps(robot))):
        assert told.links == ["a\0b", "a\0c"] and told.name == "n\0" and told.link_of("a\0c") == 1 and len(told.posed([0])) == 2
    scene = toccata.RobotScene(robot, allow_adjacent=False)
    assert scene.names(scene.contacts([0])[0]) == ("a\0b", "a\0c")
    assert not toccata.RobotScene(robot, allowed=[("a\0b", "a\0c")]).meets([0])
    for ask in (lambda: toccata.Robot({"a\ud800": []}), lambda: toccata.RobotScene(robot, allowed=[("a\0b", "\ud800")])):
        with pytest.raises(toccata.Error, match="no text"):
            ask()
    for ask in (lambda: toccata.RobotJoint("\ud800", toccata.RobotJointKind.fixed, "a", "b"), lambda: robot.link_of("\ud800")):
        with pytest.raises(TypeError):
            ask()


def test_limits_as_wide_as_doubles():
    kind, ball = toccata.RobotJointKind.prismatic, toccata.Sphere(1)
    joints = [toccata.RobotJoint("x", kind, "a", "b", axis=(1, 0, 0), limits=(-1e308, 1e308)),
              toccata.RobotJoint("y", kind, "b", "c", axis=(0, 1, 0), limits=(-1.7e308, 1.7e308))]
    robot = toccata.Robot({"a": [ball], "b": [ball], "c": [ball]}, joints)
    many = robot.sampled(200)
    assert numpy.isfinite(many).all() and numpy.abs(many).max(axis=0).min() > 5e307 and (many.min(axis=0) < 0).all()
    assert robot.allowed_pairs(200) == [("a", "b", "adjacent"), ("a", "c", "at rest"), ("b", "c", "adjacent")]


def test_link_poses_are_matrices(robot):
    many = robot.sampled(5)
    poses = robot.link_poses_each(many)
    assert poses.shape == (5, 8, 4, 4)
    assert all(numpy.array_equal(poses[i], robot.link_poses(many[i])) for i in range(5))
    assert numpy.allclose(poses[..., :3, :3] @ numpy.swapaxes(poses[..., :3, :3], -1, -2), numpy.eye(3))
    assert math.isclose(robot.link_poses(numpy.zeros(7))[7, 2, 3], 1.22, abs_tol=1e-12)


def skip_without_urdfdom(error):
    if "liburdfdom" not in str(error):
        raise error
    pytest.skip(str(error))


@pytest.mark.skipif(not COMMAND.exists(), reason=f"there is no command {COMMAND}: nothing to compare with")
def test_every_answer_is_that_of_the_library(robot, tmp_path):
    """A generated table: 400 configurations, their distances and the ways between them, to the bit."""
    try:
        robot.write_urdf(str(tmp_path / "arm"))
        read = toccata.Robot.from_urdf(str(tmp_path / "arm/robot.urdf"))
    except toccata.Error as error:
        skip_without_urdfdom(error)
    obstacles = [toccata.Box((0.2, 0.2, 0.2), (0.6, 0, 0.5)), toccata.Sphere(0.15, (-0.4, 0.5, 0.8)), toccata.Capsule((0, -0.6, 0), (0, -0.6, 1), 0.1)]
    file = scene_of(obstacles, tmp_path)
    scene = toccata.RobotScene(read, [toccata.SceneInstance(o, name=f"{i}") for i, o in enumerate(obstacles)])
    many = read.sampled(in_slices(400), seed=9)
    words = ["--scene", file, "--configurations", written(many, tmp_path / "q.csv"), "--distance", "--edges"]
    report = asked("robot", tmp_path / "arm/robot.urdf", *words)
    meets, nearest, contacts = scene.meets_each(many), scene.distance_each(many), scene.contacts_each(many)
    assert 0.1 < meets.mean() < 0.9
    for i, told in enumerate(report["configurations"]):
        assert told["positions"] == many[i].tolist() and told["meets"] == meets[i]
        assert [(c["link"], c["other"]) for c in told["contacts"]] == [scene.names(row) for row in contacts[contacts["query"] == i]]
        distance, row = told["distance"], nearest[i]
        assert (distance["link"], distance["other"]) == scene.names(row) and distance["obstacle"] == row["with_obstacle"]
        for name, ours in (("lower", "lower"), ("upper", "upper"), ("on_link", "on_a"), ("on_other", "on_b"), ("gradient", "gradient")):
            assert numpy.array_equal(distance[name], row[ours]), (i, name)
    edges = scene.edge_each(many[:-1], many[1:])
    assert 0 < edges["is_free"].sum() < len(edges)
    for told, row in zip(report["edges"], edges, strict=True):
        assert told["free"] == row["is_free"]
        if not told["free"]:
            assert (told["lower"], told["upper"], told["status"]) == (row["lower"], row["upper"], toccata.Status(row["status"]).name)
            assert (told["pair"]["link"], told["pair"]["other"]) == scene.names(row)


def test_batches_are_each_alone_on_any_number_of_threads(scene, robot):
    many, others = robot.sampled(COUNT, seed=3), robot.sampled(COUNT, seed=4)
    for threads in (1, 2, 0):
        meets = scene.meets_each(many, threads=threads)
        nearest = scene.distance_each(many, threads=threads)
        near = scene.distance_each(many, 0.02, threads=threads)
        contacts = scene.contacts_each(many, threads=threads)
        edges = scene.edge_each(many, others, threads=threads)
        free = scene.free_each(many, others, threads=threads)
        assert meets.dtype == bool and meets.any() and not meets.all() and free.any() and not free.all()
        for i, (one, other) in enumerate(zip(many, others)):
            assert scene.meets(one) == meets[i] == bool(scene.contacts(one)) == (nearest[i]["upper"] == 0)
            assert [(c.link, c.with_obstacle, c.other) for c in scene.contacts(one)] == [
                tuple(row)[1:] for row in contacts[contacts["query"] == i]]
            alone, within, edge = scene.distance(one), scene.distance(one, 0.02), scene.edge(one, other)
            assert all(numpy.array_equal(getattr(alone, name), nearest[i][name]) for name in nearest.dtype.names if name != "found")
            assert (within is not None) == near[i]["found"] and (within is None or within == alone)
            assert edge.is_free == free[i] and all(getattr(edge, name) == edges[i][name] for name in edges.dtype.names)
    assert alone.gradient.shape == (7,) and nearest["gradient"].shape == (COUNT, 7)
    for answer in (alone, edge, *scene.contacts(many[meets][0])[:1]):
        assert pickle.loads(pickle.dumps(answer)) == answer and repr(answer).startswith("Robot")


def test_other_threads_go_on_while_a_batch_is_asked(scene, robot):
    begun, ended, moments = threading.Event(), threading.Event(), []

    def ask() -> None:
        begun.set()
        begin = time.perf_counter()
        scene.distance_each(robot.sampled(500 if SLICE else 1500), threads=1)
        moments.append((begin, time.perf_counter()))
        ended.set()

    thread = threading.Thread(target=ask)
    thread.start()
    begun.wait()
    answered = []
    while not ended.is_set():
        robot.rest()
        answered.append(time.perf_counter())
    thread.join()
    assert sum(moments[0][0] < moment < moments[0][1] for moment in answered) >= 20


def test_gradients_are_those_of_small_changes(scene, robot):
    """But where another pair of points is as near, which is rare."""
    many = robot.sampled(30, seed=5)
    here = scene.distance_each(many)
    apart = here["upper"] > 1e-5
    assert 5 < apart.sum() < 30 and not here["gradient"][~apart].any()
    off = 0
    for j in range(7):
        step = numpy.zeros(7)
        step[j] = 1e-6
        difference = (scene.distance_each(many + step)["upper"] - scene.distance_each(many - step)["upper"]) / 2e-6
        off += numpy.sum(numpy.abs(difference - here["gradient"][:, j])[apart] > 1e-4)
    assert off <= 4


def test_edges_that_are_free_are_free_between(scene, robot):
    begins, ends = robot.sampled(in_slices(40), seed=1), robot.sampled(in_slices(40), seed=2)
    edges = scene.edge_each(begins, ends)
    for begin, end, edge in zip(begins, ends, edges):
        between = scene.meets_each(begin + numpy.linspace(0, 1, 50)[:, None] * (end - begin))
        assert not (edge["is_free"] and between.any())
        if not edge["is_free"] and edge["status"] == toccata.Status.exact:
            assert scene.meets(begin + edge["upper"] * (end - begin)) or edge["upper"] - edge["lower"] < 1e-5
            assert not between[numpy.linspace(0, 1, 50) < edge["lower"]].any()


def test_what_holds_something_is_copied(robot):
    holding = robot.with_attached("cup", toccata.Sphere(0.05), "link 7", (0, 0, 0.15))
    for again in (copy.copy(holding), copy.deepcopy(holding)):
        assert again.links == holding.links and again.links[-1] == "cup"


def test_no_samples_allow_no_pair(robot):
    with pytest.raises(toccata.Error, match="no samples"):
        robot.allowed_pairs(0)
    still = toccata.Robot({"a": [toccata.Sphere(1)], "b": [(toccata.Sphere(1), (3, 0, 0))]}, [toccata.RobotJoint("j", toccata.RobotJointKind.fixed, "a", "b")])
    assert still.allowed_pairs(0) == [("a", "b", "adjacent")]  # there is nothing to choose


def test_pairs_are_allowed_for_a_reason(robot, tmp_path):
    pairs = robot.allowed_pairs(200)
    assert ("base", "link 1", "adjacent") in pairs and {reason for _, _, reason in pairs} <= {"adjacent", "always", "at rest", "never"}
    assert pairs == robot.allowed_pairs(200, threads=1)
    assert set(robot.adjacent_pairs()) >= {p for p in pairs if p[2] == "adjacent"}
    all_pairs = list(itertools.combinations(robot.links, 2))
    assert not toccata.RobotScene(robot, allowed=all_pairs).meets_each(robot.sampled(50)).any()
    assert toccata.RobotScene(robot, allowed=pairs).looks_at(0, 7) == (("base", "link 7") not in {p[:2] for p in pairs})
    assert toccata.RobotScene(robot, allow_adjacent=False).looks_at(0, 1)
    file = tmp_path / "arm.srdf"
    file.write_text('<robot name="generated arm"><disable_collisions link1="base" link2="link 5" reason="Never"/></robot>')
    try:
        assert [pair[:2] for pair in robot.srdf_pairs(str(file))] == [("base", "link 5")]
    except toccata.Error as error:
        assert "liburdfdom" in str(error)
    for wrong in ("base", [("base",)], [("base", 5)], [("base", "nothing")], [5], 5):
        with pytest.raises(toccata.Error):
            toccata.RobotScene(robot, allowed=wrong)


def test_what_is_attached_is_a_link_more(robot):
    cup = toccata.Sphere(0.05)
    holding = robot.with_attached("cup", cup, "link 7", (0, 0, 0.15))
    wall = [toccata.SceneInstance(toccata.Box((1, 1, 0.01)), (0, 0, 1.42), name="ceiling")]
    rest = numpy.zeros(7)
    assert not toccata.RobotScene(robot, wall).meets(rest)
    scene = toccata.RobotScene(holding, wall)
    assert [scene.names(contact) for contact in scene.contacts(rest)] == [("cup", "ceiling")]
    assert not toccata.RobotScene(holding, wall, allowed=[("cup", "ceiling")]).meets(rest)
    within = robot.with_attached("cup", cup, "link 7", (0, 0, -0.15))
    names = {toccata.RobotScene(within).names(c)[0] for c in toccata.RobotScene(within).contacts(rest)}
    assert names and not toccata.RobotScene(robot.with_attached("cup", cup, "link 7", (0, 0, -0.15), sorted(names))).meets(rest)
    with pytest.raises(toccata.Error, match="no link 'lnk 7'"):
        robot.with_attached("cup", cup, "lnk 7")


def test_clouds_and_voxels_are_obstacles(robot):
    """As the balls and the cubes that they are."""
    points = numpy.random.default_rng(2).uniform((-0.8, -0.8, 0.2), (0.8, 0.8, 1.2), (60, 3))
    cloud, voxels = toccata.point_cloud(points, 0.03), toccata.voxel_map(points, 0.06, "cells")
    assert (cloud.name, voxels.name) == ("cloud", "cells")
    balls = [(toccata.Sphere(0.03), point) for point in points]
    cubes = [(toccata.Box((0.03, 0.03, 0.03)), point) for point in points]
    many = robot.sampled(40 if SLICE else 150)
    for whole, parts in ((cloud, balls), (voxels, cubes)):
        one, apart = toccata.RobotScene(robot, [whole]), toccata.RobotScene(robot, parts)
        meets = one.meets_each(many)
        assert numpy.array_equal(meets, apart.meets_each(many)) and 0.07 < meets.mean() < 0.93
        assert numpy.array_equal(one.distance_each(many)["upper"], apart.distance_each(many)["upper"])
    for wrong in (numpy.zeros((0, 3)), numpy.zeros((3, 2)), [[0, 0, math.nan]]):
        with pytest.raises(toccata.Error):
            toccata.point_cloud(wrong, 1)
    with pytest.raises(toccata.Error):
        toccata.voxel_map(points, 0)


def test_a_room_is_free_at_rest(robot):
    room = toccata.generated_room(30)
    assert len(room) == 33 and not toccata.RobotScene(robot, room).meets(robot.rest())


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
        skip_without_urdfdom(error)
    assert [p.name for p in robot.positions] == ["j"] and numpy.isinf(robot.limits).all()
    (tmp_path / "q.csv").write_text("j\n0.5\n-0.5\n")
    assert robot.read_configurations(str(tmp_path / "q.csv")).tolist() == [[0.5], [-0.5]]
    file.write_text(URDF.replace("continuous", "continuus"))
    with pytest.raises(toccata.Error, match="two.urdf"):
        toccata.Robot.from_urdf(str(file))


def test_macros_are_to_be_expanded_first(tmp_path):
    file = tmp_path / "arm.urdf.xacro"
    file.write_text(URDF)
    try:
        with pytest.raises(toccata.Error, match=r"arm.urdf.xacro: xacro macros are not expanded here; expand them first \(`xacro .*arm.urdf`\)"):
            toccata.Robot.from_urdf(str(file))
    except AssertionError as error:
        skip_without_urdfdom(error)


# A triangle whose third corner is on the y axis.
GLTF = """{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}]}"""


def test_gltf_is_warned_of_and_taken_as_it_is(tmp_path):
    """By its standard y points up, and z in a URDF file."""
    (tmp_path / "part.gltf").write_text(GLTF)
    file = tmp_path / "one.urdf"
    file.write_text('<robot name="one"><link name="a"><collision><geometry><mesh filename="part.gltf"/></geometry></collision></link></robot>')
    try:
        with pytest.warns(UserWarning, match="part.gltf' is glTF, whose y axis points up by its standard: its numbers are taken as they are"):
            robot = toccata.Robot.from_urdf(str(file))
    except toccata.Error as error:
        skip_without_urdfdom(error)
    assert robot.posed([])[0].shape.vertices.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]


def test_wrong_configurations_are_refused(scene, robot):
    one, many = numpy.zeros(7), numpy.zeros((3, 7))
    for wrong in (numpy.zeros(6), numpy.zeros((2, 6)), numpy.zeros((1, 1, 7)), "seven", [[0] * 7, [0] * 6]):
        for ask in (scene.meets, scene.meets_each, scene.contacts, scene.distance, scene.distance_each, robot.link_poses, robot.link_poses_each):
            with pytest.raises(toccata.Error):
                ask(wrong)
    with pytest.raises(toccata.Error, match=r"shape \(N, 7\) is needed"):
        scene.meets_each(one)
    with pytest.raises(toccata.Error, match=r"shape \(7,\) is needed"):
        scene.meets(many)
    with pytest.raises(toccata.Error, match="3 begins and 2 ends"):
        scene.edge_each(many, many[:2])
    with pytest.raises(toccata.Error):
        scene.edge(one, one, precision=2)
    with pytest.raises(toccata.Error):
        scene.distance(one, -1)
    many[1, 2] = math.nan
    with pytest.raises(toccata.Error, match="configuration 1: the position of 'joint 3' is nan"):
        scene.meets_each(many)
    assert scene.meets_each(numpy.zeros((0, 7))).shape == (0,) and scene.distance_each(numpy.zeros((0, 7)))["gradient"].shape == (0, 7)


def test_wrong_robots_are_refused():
    kind = toccata.RobotJointKind
    for links, joints in (
        ({}, []),
        ({"a": [], "b": []}, []),
        ({"a": []}, [toccata.RobotJoint("j", kind.fixed, "a", "c")]),
        ({"a": [5]}, []),
        ({"a": []}, [5]),
        ({5: []}, []),
        ({"a": [], "b": []}, [toccata.RobotJoint("j", kind.revolute, "a", "b", axis=(0, 0, 0))]),
    ):
        with pytest.raises(toccata.Error):
            toccata.Robot(links, joints)
    robot, scene = planar(), toccata.RobotScene(planar())
    for wrong in ({"link": 99, "with_obstacle": False, "other": 1}, 5, None, {}):
        with pytest.raises((toccata.Error, AttributeError, KeyError, TypeError)):
            scene.names(wrong)
    with pytest.raises(toccata.Error):
        scene.looks_at(0, 99)
    with pytest.raises(toccata.Error):
        toccata.RobotScene(robot, [5])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        toccata.Robot.generated(1, 2)
