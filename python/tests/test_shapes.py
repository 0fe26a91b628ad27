"""Shapes and poses as values: they are made, told, compared, copied and pickled."""

import copy
import pickle

import numpy
import pytest

import toccata
from conftest import matrices


def test_pickle_copy_and_equality(shape):
    for again in (pickle.loads(pickle.dumps(shape)), copy.copy(shape), copy.deepcopy(shape)):
        assert again == shape
        assert type(again) is type(shape)
        assert again is not shape
    assert shape != toccata.Sphere(123)
    assert shape != "a text"
    assert not shape == None and None != shape and [None, shape].index(shape) == 1  # noqa: E711


def test_nothing_equals_none():
    """None is no error: lists are searched, and data classes compared, that have it too."""
    ball, box = toccata.Sphere(1), toccata.Box((1, 1, 1))
    values = (toccata.Pose(), toccata.distance(ball, box), toccata.manifold(ball, box, pose_b=(1.5, 0, 0)), toccata.SceneInstance(ball),
              toccata.RobotJoint("j", toccata.RobotJointKind.fixed, "a", "b"))
    for value in values:
        assert value != None and not None == value and value in [None, value]  # noqa: E711


def test_manifolds_are_values():
    box, mesh = toccata.Box((1, 1, 1)), toccata.generate_mesh("box")
    (of_meshes, *_) = toccata.manifolds(mesh, mesh, pose_b=(0.25, 0.25, 0.9))
    for manifold in (toccata.manifold(box, box, pose_b=(0.5, 0, 1.75)), of_meshes):
        for again in (pickle.loads(pickle.dumps(manifold)), copy.copy(manifold), copy.deepcopy(manifold)):
            assert again == manifold and type(again) is type(manifold) and len(again) == len(manifold) > 0
            assert (again.positions == manifold.positions).all() and (again.depths == manifold.depths).all()
        assert manifold != toccata.manifold(box, box, pose_b=(0.5, 0, 1.5))
    assert (pickle.loads(pickle.dumps(of_meshes)).elements_a == of_meshes.elements_a).all()


def test_kinds_are_all_unlike():
    from conftest import one_of_each

    shapes = one_of_each()
    for i, a in enumerate(shapes):
        assert [a == b for b in shapes] == [i == j for j in range(len(shapes))]


def test_what_is_printed_makes_the_same_again():
    names = vars(toccata)
    for shape in (
        toccata.Sphere(0.1, (1, 2, 3)),
        toccata.Box((1, 2, 3)),
        toccata.Capsule((0, 0, 0), (1, 0, 0), 0.5),
        toccata.HalfSpace((0, 0, 0), (0, 0, 1)),
        toccata.Cylinder(1, 2),
        toccata.Triangle([[0, 0, 0], [1, 0, 0], [0, 1, 0]]),
        toccata.Rounded(toccata.Point((1, 2, 3)), 2),
    ):
        assert eval(repr(shape), dict(names)) == shape
    pose = toccata.Pose.rotation((1, 2, 3), 40)
    assert eval(repr(pose), dict(names)) == pose


def test_hashes_follow_equality():
    assert len({toccata.Sphere(1), toccata.Sphere(1.0, (0, 0, 0)), toccata.Sphere(2)}) == 2
    assert len({toccata.Pose(), toccata.Pose(numpy.eye(4)), toccata.Pose.translation(0, 0, 1)}) == 2
    with pytest.raises(TypeError):
        hash(toccata.generate_mesh("box"))  # it can be updated


@pytest.mark.parametrize("wrong", [numpy.nan, numpy.inf])
def test_poses_are_finite(wrong):
    for make in (lambda: toccata.Pose((0, wrong, 0)), lambda: toccata.Pose.translation(0, wrong, 0), lambda: toccata.Pose.rotation((0, 0, 1), wrong),
                 lambda: toccata.Pose.from_quaternion((0, 0, 0, 1), (0, wrong, 0)), lambda: toccata.Pose.from_quaternion((0, wrong, 0, 1)),
                 lambda: toccata.Pose.nearest_rigid((numpy.eye(3), (0, wrong, 0)))):
        with pytest.raises(toccata.Error, match="finite"):
            make()


def test_meshes_give_their_own_memory_out():
    vertices = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
    faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
    mesh = toccata.Mesh(vertices, faces)
    assert mesh.closed and mesh.solid
    assert numpy.array_equal(mesh.vertices, vertices) and numpy.array_equal(mesh.faces, faces)
    assert mesh.faces.dtype == numpy.uint32
    seen = mesh.vertices
    with pytest.raises(ValueError):
        seen[0, 0] = 5
    vertices[0, 0] = 7  # copied when the mesh was made
    assert mesh.vertices[0, 0] == 0
    del mesh
    assert seen[1, 0] == 1  # the memory lives as long as it is looked at
    assert toccata.Mesh(seen, numpy.array(faces, dtype=numpy.uint8)) == toccata.Mesh(seen[:, :], numpy.array(faces, dtype="i8"))


@pytest.mark.parametrize("dtype", ["f2", "f4", "f8", ">f8", "i4", "u1"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_vertices_of_any_type_and_order(dtype, order):
    numbers = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], dtype=dtype, order=order)
    mesh = toccata.Mesh(numbers, [[0, 1, 2]])
    assert numpy.array_equal(mesh.vertices, numbers.astype(float))
    every_second = numpy.zeros((6, 6), dtype)
    every_second[::2, ::2] = numbers
    assert toccata.Mesh(every_second[::2, ::2], [[0, 1, 2]]) == mesh


def test_faces_of_the_file():
    square = toccata.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]], [0, 0])
    assert (square.face_count, square.triangle_count, square.element_count) == (1, 2, 2)
    assert pickle.loads(pickle.dumps(square)) == square
    assert list(square.face_of_triangle) == [0, 0]
    assert toccata.contacts(square, toccata.Segment((0.2, 0.5, -1), (0.2, 0.5, 1)))["face_a"].tolist() == [0]


def test_files_keep_every_bit(tmp_path, knot):
    for ending in ("obj", "off", "ply", "stl"):
        path = str(tmp_path / f"knot.{ending}")
        knot.write(path)
        read = toccata.load_mesh(path)
        assert read.triangle_count == knot.triangle_count
        if ending != "stl":
            assert numpy.array_equal(read.vertices, knot.vertices)
    with pytest.raises(toccata.Error, match="there is no such file"):
        toccata.load_mesh(str(tmp_path / "none.obj"))


def test_health_tells_holes(knot):
    assert knot.health().closed and knot.health().boundary_edges == 0
    open_mesh = toccata.Mesh(knot.vertices, knot.faces[1:])
    assert not open_mesh.solid
    assert open_mesh.health().boundary_edges == 3


def test_poses_of_all_sorts():
    spatial = pytest.importorskip("scipy.spatial.transform")
    turn = spatial.Rotation.from_euler("xyz", [10, 20, 30], degrees=True)
    matrix = numpy.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn.as_matrix(), (1, 2, 3)
    pose = toccata.Pose(matrix)
    told = [
        toccata.Pose(matrix[:3]),
        toccata.Pose(matrix.tolist()),
        toccata.Pose(numpy.asfortranarray(matrix)),
        toccata.Pose((matrix[:3, :3], (1, 2, 3))),
        toccata.Pose((turn, (1, 2, 3))),
        toccata.Pose(turn, [1, 2, 3]),
        toccata.Pose(pose),
        toccata.Pose(pose.linear, pose.offset),
    ]
    assert all(other == pose for other in told)
    if hasattr(spatial, "RigidTransform"):  # which rounds the matrix anew
        moved = toccata.Pose(spatial.RigidTransform.from_components([1, 2, 3], turn))
        assert numpy.allclose(moved.matrix, matrix, rtol=0, atol=1e-15)
    assert numpy.array_equal(numpy.asarray(pose), matrix)
    assert toccata.Pose(turn) == toccata.Pose(turn.as_matrix(), (0, 0, 0))
    assert toccata.Pose((1, 2, 3)) == toccata.Pose.translation(1, 2, 3)
    assert numpy.allclose(toccata.Pose.from_quaternion(turn.as_quat(), (1, 2, 3)).matrix, matrix, atol=1e-15)
    assert pickle.loads(pickle.dumps(pose)) == pose


def test_the_algebra_of_poses():
    a, b = (toccata.Pose(m) for m in matrices(2, 3, 1))
    assert (a @ b) == (a * b)
    assert numpy.allclose((a @ b).matrix, a.matrix @ b.matrix, atol=1e-14)
    assert numpy.allclose((a @ a.inverse()).matrix, numpy.eye(4), atol=1e-14)
    points = numpy.random.default_rng(2).normal(size=(7, 3))
    assert numpy.allclose(a.transform(points), points @ a.linear.T + a.offset, atol=1e-14)
    assert numpy.array_equal(a.transform(points[3]), a.transform(points)[3])
    with pytest.raises(toccata.Error, match="singular"):
        toccata.Pose(numpy.zeros((3, 3)), (0, 0, 0)).inverse()
    drifted = a.linear * (1 + 1e-7)
    assert numpy.allclose(toccata.Pose.nearest_rigid((drifted, a.offset)).linear, a.linear, atol=1e-6)


def test_update_leaves_no_stale_box(knot):
    mesh, vertices = copy.copy(knot), knot.vertices.copy()
    ball = toccata.Sphere(0.1)
    for step in range(5):
        mesh.update(knot.vertices + (10 * step, 0, 0))
        moved = toccata.Mesh(mesh.vertices, mesh.faces)
        for pose in matrices(20, 15, step):
            told, fresh = toccata.distance(mesh, ball, pose_b=pose), toccata.distance(moved, ball, pose_b=pose)
            # The knot has faces of four corners, of which the triangles alone tell nothing.
            assert (told.lower, told.upper, told.element_a) == (fresh.lower, fresh.upper, fresh.element_a)
            assert numpy.array_equal(told.on_a, fresh.on_a) and numpy.array_equal(told.on_b, fresh.on_b)
    assert numpy.array_equal(knot.vertices, vertices) and not numpy.array_equal(mesh.vertices, vertices)  # copies stay
    before = copy.copy(mesh)
    for wrong in (mesh.vertices[1:], mesh.vertices * numpy.nan, "vertices"):
        with pytest.raises(toccata.Error):
            mesh.update(wrong)
        assert mesh == before


def test_trimesh_hands_over():
    trimesh = pytest.importorskip("trimesh")
    box = trimesh.creation.box((1, 2, 3))
    mesh = toccata.Mesh(box)
    assert mesh.closed and numpy.array_equal(mesh.vertices, box.vertices)
    assert toccata.overlap(mesh, mesh, pose_b=trimesh.transformations.rotation_matrix(0.3, (0, 0, 1)))
