"""Nothing that is handed over wrongly ends the interpreter: it is a toccata.Error, or a TypeError."""

import copy
import gc
import pickle
import weakref

import numpy
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import toccata
from conftest import in_slices

REFUSED = (toccata.Error, TypeError, OverflowError)
BALL, BOX, MESH = toccata.Sphere(1), toccata.Box((1, 1, 1)), toccata.generate_mesh("icosphere", radius=1, subdivisions=1)
KINDS = st.sampled_from(["f2", "f4", "f8", ">f8", "i1", "u2", "i8", "u8", "?", "c16", "U3", "S2", "O", "M8[s]", "f16"])
SHAPES = arrays.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=5)


@st.composite
def any_array(draw):
    """Of any type, shape and stride, sometimes one that cannot be written to."""
    dtype = numpy.dtype(draw(KINDS))
    array = draw(arrays.arrays(dtype, draw(SHAPES)) if dtype.kind != "O" else st.just(numpy.array([None, 1, "x"], dtype=object)))
    if draw(st.booleans()) and array.ndim:
        array = array[:: draw(st.sampled_from([1, 2, -1]))]
    if draw(st.booleans()) and array.ndim > 1:
        array = array.T
    array.flags.writeable = draw(st.booleans()) and array.flags.writeable
    return array


NUMBERS = st.one_of(st.floats(), st.integers(-(10**30), 10**30))
ANYTHING = st.one_of(
    any_array(),
    st.none(),
    st.text(max_size=4),
    st.binary(max_size=4),
    st.recursive(NUMBERS, lambda inner: st.lists(inner, max_size=4), max_leaves=20),
    st.tuples(NUMBERS, NUMBERS, NUMBERS),
    st.builds(object),
    st.dictionaries(st.integers(), st.integers(), max_size=2),
    st.complex_numbers(),
)
OFTEN = settings(max_examples=in_slices(150), deadline=None, suppress_health_check=list(HealthCheck))


def tried(ask, *arguments, **named):
    try:
        return ask(*arguments, **named)
    except REFUSED as error:
        assert str(error)
        return None


@OFTEN
@given(ANYTHING, ANYTHING)
def test_poses(a, b):
    for ask in (toccata.overlap, toccata.distance, toccata.relation, toccata.penetration):
        tried(ask, BALL, BOX, a, b)
        tried(ask, MESH, BOX, pose_b=a)
    for ask in (toccata.overlap_each, toccata.distance_each, toccata.penetration_each):
        tried(ask, BALL, BOX, a, b)
    pose = tried(toccata.Pose, a)
    if pose is not None:
        assert toccata.Pose(pose.matrix) == pose
    tried(toccata.Pose, a, b)
    tried(toccata.Pose.from_quaternion, a, b)
    tried(toccata.Pose.rotation, a, 30)
    tried(toccata.Pose().transform, a)


@OFTEN
@given(ANYTHING, ANYTHING, ANYTHING)
def test_shapes(a, b, c):
    for make in (
        toccata.Point,
        toccata.Segment,
        toccata.Triangle,
        toccata.Sphere,
        toccata.Box,
        toccata.Capsule,
        toccata.HalfSpace,
        toccata.Ellipsoid,
        toccata.ConvexHull,
        toccata.HeightField,
        toccata.Compound,
        toccata.Rounded,
        toccata.Mesh,
        toccata.Cylinder,
    ):
        for arguments in ((a,), (a, b), (a, b, c)):
            shape = tried(make, *arguments)
            if shape is not None:
                tried(toccata.distance, shape, BOX)


@OFTEN
@given(ANYTHING, ANYTHING)
def test_points_and_rays(a, b):
    for shape in (BALL, MESH):
        tried(toccata.nearest_point, a, shape, b)
        tried(toccata.nearest_point_each, a, shape)
        tried(toccata.signed_distance, a, shape)
        tried(toccata.signed_distance_each, a, shape)
        tried(toccata.cast_ray, a, b, shape)
        tried(toccata.cast_ray_each, a, b, shape)
        tried(toccata.cast_shape, BOX, a, shape, b)
        tried(toccata.cast_shape_each, BOX, a, shape, b)


@OFTEN
@given(arrays.arrays("f8", st.tuples(st.integers(0, 5), st.just(3))), arrays.arrays("i8", st.tuples(st.integers(0, 5), st.just(3)), elements=st.integers(-2, 6)))
def test_meshes(vertices, faces):
    mesh = tried(toccata.Mesh, vertices, faces)
    if mesh is not None:
        assert len(faces) > 0 and faces.min() >= 0 and faces.max() < len(vertices) and numpy.isfinite(vertices).all()
        tried(toccata.overlap, mesh, mesh)
        mesh.health()
        tried(mesh.update, vertices * 2)


@OFTEN
@given(ANYTHING, ANYTHING)
def test_scenes_worlds_and_motions(a, b):
    index, world = toccata.SceneIndex([BALL, (BOX, (3, 0, 0))]), toccata.World()
    body = world.add(BALL)
    for ask in (index.overlapping, index.nearest, index.relations, world.overlapping, world.nearest):
        tried(ask, BALL, a)
        tried(ask, a)
        tried(ask, BALL, only=b)
    for ask in (index.cast_ray, index.cast_ray_each, world.cast_ray_through, index.nearest_each, world.overlapping_each):
        tried(ask, a, b)
    for ask in (toccata.SceneIndex, toccata.check_all, toccata.self_contacts_each, toccata.overlapping_pairs, world.remove, world.exclude):
        tried(ask, a)
        tried(ask, [BALL, a])
    tried(toccata.check_all, [BALL, (BOX, a)], clearance=b)
    tried(toccata.check_all, [BALL, BOX], pair_clearances=a)
    tried(toccata.overlap_each, [BALL, BOX], a, b)
    tried(toccata.contacts_each, MESH, [MESH, BOX], a, b)
    tried(world.add, BALL, a, margin=b)
    tried(world.add_each, [BALL, BOX], a, b)
    tried(world.move, body, a)
    tried(world.move, a, b)
    tried(world.move_along, body, a)
    tried(world.step)
    for ask in (toccata.RigidMotion, toccata.RigidMotion.straight, toccata.RigidMotion.between, toccata.RigidMotion.through):
        tried(ask, a, b)
    tried(toccata.sweep, BALL, a, BOX, b)
    tried(toccata.sweep_each, BALL, a, BOX)
    tried(toccata.vertex_face_impacts, a, b)
    tried(toccata.SceneInstance, BALL, a, name=b)
    tried(toccata.BroadPhase().add, a)
    tried(toccata.BroadPhase().move, a, b)
    tried(toccata.BodyFilter, except_bodies=a)


ROBOT = toccata.Robot.generated(0)
SCENE = toccata.RobotScene(ROBOT, [BOX])


@OFTEN
@given(ANYTHING, ANYTHING, ANYTHING)
def test_robots(a, b, c):
    for ask in (SCENE.meets, SCENE.meets_each, SCENE.contacts, SCENE.contacts_each, SCENE.distance, SCENE.distance_each, ROBOT.posed, ROBOT.link_poses, ROBOT.link_poses_each, ROBOT.beyond_limits):
        tried(ask, a)
    for ask in (SCENE.edge, SCENE.edge_each, SCENE.free_each, SCENE.distance):
        tried(ask, a, b)
        tried(ask, ROBOT.rest(), b)
    tried(toccata.RobotScene, ROBOT, a, allowed=b)
    tried(toccata.RobotScene, ROBOT, [(BALL, a)], allowed=[(b, c)])
    tried(toccata.Robot, {"a": a}, b, name=c)
    tried(toccata.Robot, a, [b])
    joint = tried(toccata.RobotJoint, "j", toccata.RobotJointKind.revolute, "a", "b", a, b, c)
    if joint is not None:
        tried(toccata.Robot, {"a": [BALL], "b": [(BOX, a)]}, [joint])
    tried(ROBOT.with_attached, a, BALL, "link 1", b)
    tried(ROBOT.with_attached, "cup", BALL, "link 1", a, b)
    tried(toccata.point_cloud, a, 0.5)
    tried(toccata.voxel_map, a, b)


@OFTEN
@given(ANYTHING, ANYTHING, ANYTHING)
def test_what_moves_and_deforms(a, b, c):
    level, mesh = toccata.SceneIndex([BOX]), toccata.DeformingMesh(MESH)
    for ask in (mesh.advance, mesh.move_to, mesh.meets, mesh.first_impact):
        tried(ask, a)
    assert mesh.start.shape == MESH.vertices.shape and numpy.isfinite(mesh.end).all()
    tried(toccata.DeformingMesh, MESH, a)
    tried(mesh.meets, separation=a)
    state = tried(toccata.SceneMoverState, a, b)
    options = tried(toccata.MoverOptions, up=a, skin=b)
    tried(level.move_character, BALL, state or toccata.SceneMoverState(), b, options or toccata.MoverOptions(), only=c)
    tried(level.move_character, BALL, toccata.SceneMoverState((0, 0, 3)), (0, 0, -1), moved=a)
    tried(toccata.velocity_along, a, b)
    motion = tried(toccata.RigidMotion.of, lambda s: a, speed=10)
    if motion is not None:
        tried(motion.at, 0.5)
        tried(toccata.sweep, BALL, motion, BOX, b)


@OFTEN
@given(ANYTHING, ANYTHING)
def test_depths_and_regions(a, b):
    tried(toccata.depth_bracket, BALL, BOX, a, precision=b)
    tried(toccata.depth_bracket_each, BALL, BOX, a, time_limit=b)
    for ask in (toccata.overlap_volume, toccata.manifolds, toccata.first_contact, toccata.manifold_each):
        tried(ask, BALL, BOX, a, b)
    tried(toccata.faces_in_box, MESH, a, b)
    tried(toccata.faces_in_ball, MESH, a, b)
    tried(toccata.faces_in_region_each, MESH, boxes=a)
    tried(toccata.faces_in_region_each, MESH, centres=a, radii=b)
    tried(toccata.nearest_points_each, a, 2, [MESH])
    tried(toccata.nearest_points_each, [[0, 0, 0]], 2, a, b)
    tried(toccata.scene_signed_distance_each, a, [MESH, BALL])
    tried(toccata.close_mesh, MESH, a)
    tried(toccata.hull_of_half_spaces, a)
    tried(toccata.view_frustum, a, b)
    tried(toccata.load_scene, a)


@pytest.mark.parametrize(
    "arguments, words",
    [
        (([[0, 0, numpy.nan], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), "vertex 0"),
        (([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 3]]), "3"),
        (([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, -1]]), "faces: the index -1 in row 0"),
        (([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0.0, 1.0, 2.0]]), "whole numbers"),
        (([[0, 0, 0], [1, 0, 0], [0, 1, 0]], []), "at least one triangle"),
        (([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]), "vertices: an array of the shape \\(N, 3\\)"),
        (([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2, 0]]), "faces: an array of the shape \\(N, 3\\)"),
        ((["a", "b"], [[0, 1, 2]]), "vertices: real numbers are needed"),
    ],
)
def test_words_of_errors(arguments, words):
    with pytest.raises(toccata.Error, match=words):
        toccata.Mesh(*arguments)
    with pytest.raises(ValueError):  # which it is
        toccata.Mesh(*arguments)


def test_that_open_meshes_have_no_depth(knot):
    with pytest.raises(toccata.Error, match="open"):
        toccata.penetration(toccata.Mesh(knot.vertices, knot.faces[1:]), BOX)


def test_shapes_that_were_never_made():
    for kind in (toccata.Sphere, toccata.Mesh, toccata.Compound, toccata.Pose):
        empty = kind.__new__(kind)
        for ask in (lambda: toccata.overlap(empty, BOX), lambda: toccata.overlap(BOX, BOX, empty), lambda: repr(empty)):
            try:
                ask()
            except (TypeError, toccata.Error):
                pass
    for kind in (toccata.Sphere, toccata.Mesh, toccata.Pose, toccata.RigidMotion, toccata.Body, toccata.Robot, toccata.RobotScene, toccata.World):
        empty = kind.__new__(kind)
        for ask in (copy.copy, copy.deepcopy, pickle.dumps):
            with pytest.raises(TypeError):
                ask(empty)


def test_owners_may_go_first():
    vertices = numpy.random.default_rng(1).normal(size=(30, 3))
    hull = toccata.ConvexHull(vertices)
    watched = weakref.ref(vertices)
    del vertices
    gc.collect()
    assert watched() is None  # copied, and let go
    assert hull.element_count == 1
    answers = toccata.distance_each(BALL, BOX, poses_b=numpy.array([[3, 0, 0], [4, 0, 0]]))
    points = answers["on_a"]
    del answers
    gc.collect()
    assert numpy.isfinite(points).all()
    compound = toccata.Compound([toccata.generate_mesh("torus")])
    part = compound.parts[0][0]
    del compound
    gc.collect()
    assert toccata.overlap(part, toccata.Sphere(2))


def test_memory_is_given_back():
    def resident() -> int:
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * 4096

    vertices, faces = MESH.vertices.copy(), MESH.faces.copy()
    poses = numpy.tile(numpy.eye(4), (200, 1, 1))

    def work(rounds: int) -> None:
        for _ in range(rounds):
            mesh = toccata.Mesh(vertices, faces)
            mesh.update(vertices * 2)
            toccata.distance_each(mesh, BALL, poses_b=poses)
            toccata.distance(mesh, BOX).on_a
            toccata.contacts_with_points(mesh, BOX)
            tried(toccata.Mesh, vertices, faces + 10**6)
            toccata.cast_ray((0, 0, 9), (0, 0, -9), mesh, poses[0])

    work(30)
    before = resident()
    work(150)
    assert resident() - before < 8 << 20
