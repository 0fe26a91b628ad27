"""What is wrong with a mesh and how it is closed; hulls of half-spaces and views; files of many objects."""

import json

import numpy
import pytest

import toccata


def test_parameters_of_a_generator_are_named_as_in_python():
    thin, plain = (toccata.generate_mesh("torus", radius=1, **more) for more in ({"tube_radius": 0.1}, {}))
    assert thin == toccata.generate_mesh("torus", **{"radius": 1, "tube-radius": 0.1}) and thin != plain
    with pytest.raises(toccata.Error, match="tube-width"):
        toccata.generate_mesh("torus", tube_width=1)


def test_holes_are_found_and_closed():
    ball = toccata.generate_mesh("icosphere", radius=1, subdivisions=2)
    opened = toccata.Mesh(ball.vertices, ball.faces[1:])
    (fault,) = toccata.mesh_faults(opened)
    assert fault.kind == toccata.MeshFaultKind.boundary_edges and len(fault) == 3 == opened.health().boundary_edges
    assert fault.edges.shape == (3, 2) and fault.triangles.shape == (0,) and not toccata.mesh_faults(ball)
    a, b, c = ball.vertices[ball.faces[0]]
    sides = [numpy.linalg.norm(side) for side in (b - a, c - b, a - c)]
    height = numpy.linalg.norm(numpy.cross(b - a, c - a)) / max(sides)
    closed, done = toccata.close_mesh(opened, (height + min(sides)) / 2)  # by a triangle, and not by one vertex for its corners
    assert closed.closed and isinstance(closed, toccata.Mesh) and (done.filled_holes, done.added_triangles, done.open_holes) == (1, 1, 0)
    assert toccata.closing_gap(ball) == 0 and toccata.closing_gap(toccata.Mesh(ball.vertices, ball.faces[:1])) is None
    corners = ball.vertices[ball.faces].reshape(-1, 3)
    torn = toccata.Mesh(corners + numpy.random.default_rng(1).uniform(-1e-6, 1e-6, corners.shape), numpy.arange(len(corners)).reshape(-1, 3))
    gap = toccata.closing_gap(torn)
    assert 1e-7 < gap < 1e-5 and toccata.close_mesh(torn, gap)[0].closed
    left, nothing = toccata.close_mesh(opened, 1e-9)
    assert not left.closed and nothing.open_holes == 1
    for wrong in (0, -1, float("nan"), float("inf")):
        with pytest.raises(toccata.Error):
            toccata.close_mesh(opened, wrong)
    with pytest.raises(toccata.Error, match="Mesh is needed"):
        toccata.mesh_faults(toccata.Sphere(1))


def test_parts_of_a_mesh():
    ball = toccata.generate_mesh("icosphere", radius=1, subdivisions=1)
    two = toccata.Mesh(numpy.vstack([ball.vertices, ball.vertices + 5]), numpy.vstack([ball.faces, ball.faces + len(ball.vertices)]))
    parts = toccata.mesh_parts(two)
    assert parts.tolist() == [0] * len(ball.faces) + [1] * len(ball.faces)


def test_hulls_of_half_spaces_and_views():
    sides = [toccata.HalfSpace(numpy.multiply(normal, 2), normal) for normal in numpy.vstack([numpy.eye(3), -numpy.eye(3)])]
    cube = toccata.hull_of_half_spaces(sides)
    assert isinstance(cube, toccata.ConvexHull) and sorted(map(tuple, numpy.abs(cube.vertices))) == [(2, 2, 2)] * 8
    for wrong in (sides[:4], [], [5], [toccata.Sphere(1)], [toccata.HalfSpace((0, 0, 0), (0, 0, 1)), toccata.HalfSpace((0, 0, 5), (0, 0, -1))]):
        with pytest.raises(toccata.Error):
            toccata.hull_of_half_spaces(wrong)
    view = toccata.view_frustum((0, 0, 0), (0, 0, -1), nearest=1, farthest=10)
    seen = [toccata.overlap(view, toccata.Point(p)) for p in ((0, 0, -5), (0, 0, 5), (0, 0, -11), (9, 0, -5))]
    assert seen == [True, False, False, False]
    with pytest.raises(toccata.Error):
        toccata.view_frustum((0, 0, 0), (0, 1, 0), nearest=2, farthest=1)


def test_scenes_are_read_with_their_places(tmp_path):
    ball = toccata.generate_mesh("icosphere", radius=1, subdivisions=1)
    ball.write(str(tmp_path / "ball.obj"))
    objects = [
        {"name": "one", "file": "ball.obj", "pose": {"translation": [1, 2, 3]}},
        {"name": "two", "shape": {"type": "sphere", "radius": 2, "centre": [0, 0, 0]}},
    ]
    file = tmp_path / "scene.json"
    file.write_text(json.dumps({"format": "toccata-scene", "version": 1, "unit": "unit", "objects": objects}))
    one, two = toccata.load_scene(str(file))
    assert (one.name, two.name) == ("one", "two") and one.pose.offset.tolist() == [1, 2, 3] and two.shape.radius == 2
    (alone,) = toccata.load_scene(str(tmp_path / "ball.obj"), "mm")
    assert numpy.allclose(alone.pose.linear, numpy.eye(3) * 1e-3)
    assert toccata.SceneIndex([one, two]).overlapping(toccata.Point((1, 2, 3))).tolist() == [0]
    with pytest.raises(toccata.Error, match="nothing.json"):
        toccata.load_scene(str(tmp_path / "nothing.json"))
    with pytest.raises(toccata.Error):
        toccata.load_scene(str(tmp_path / "ball.obj"), "ells")


@pytest.mark.parametrize("radius", ["x", None, [1], 1j])
def test_parameters_of_generated_meshes_are_numbers(radius):
    with pytest.raises(toccata.Error, match="radius: a number is needed"):
        toccata.generate_mesh("torus", radius=radius)


def test_files_are_named_by_text_or_path(tmp_path):
    ball, file = toccata.generate_mesh("icosphere", radius=1, subdivisions=1), tmp_path / "a ball.obj"
    ball.write(file)
    assert toccata.load_mesh(file) == toccata.load_mesh(str(file)) == ball
    assert toccata.load_scene(file)[0].shape == ball
    robot, folder = toccata.Robot.generated(0), tmp_path / "arm"
    robot.write_urdf(folder)
    read = toccata.Robot.from_urdf(folder / "robot.urdf", packages=[tmp_path, str(tmp_path)])
    (tmp_path / "q.csv").write_text("0 0 0 0 0 0 0\n")
    assert read.read_configurations(tmp_path / "q.csv").shape == (1, 7)
    (tmp_path / "arm.srdf").write_text('<robot name="arm"><disable_collisions link1="base" link2="link 2"/></robot>')
    assert read.srdf_pairs(tmp_path / "arm.srdf") == [("base", "link 2", "given")]
    for nothing in (tmp_path / "nothing.obj", b"no\xffthing.obj", "no\udcffthing.obj"):  # which need not be UTF-8
        with pytest.raises(toccata.Error, match="thing.obj: there is no such file"):
            toccata.load_mesh(nothing)


def test_what_is_no_shape_yet_is_told_how_to_become_one():
    class Others:
        vertices, faces = toccata.generate_mesh("box").vertices, toccata.generate_mesh("box").faces

    ball = toccata.Sphere(1)
    for ask in (lambda: toccata.overlap_each([Others()], ball), lambda: toccata.overlap_each(Others(), ball), lambda: toccata.SceneIndex([ball, Others()]),
                lambda: toccata.check_all([(Others(), (1, 0, 0))])):
        with pytest.raises(toccata.Error, match="toccata.Mesh"):
            ask()
    with pytest.raises(toccata.Error, match="load_mesh"):
        toccata.Mesh("ball.stl")
