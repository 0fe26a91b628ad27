"""Every answer of Python is that of the C++ library, to the bit: 10,000 generated questions, asked of the command too.

The command is TOCCATA_COMMAND, or that of build/release; its JSON holds doubles that round-trip. What it does not tell, a
small program of C++ does (library_answers.cpp), which is compiled against the library TOCCATA_LIBRARY, or that of
build/release.
"""

import itertools
import json
import os
import pathlib
import shutil
import subprocess

import numpy
import pytest

import toccata
from conftest import SLICE, in_slices, matrices, one_of_each

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMAND = pathlib.Path(os.environ.get("TOCCATA_COMMAND", ROOT / "build/release/apps/toccata/toccata"))
LIBRARY = pathlib.Path(os.environ.get("TOCCATA_LIBRARY", ROOT / "build/release/libtoccata.a"))
needs_command = pytest.mark.skipif(not COMMAND.exists(), reason=f"there is no command {COMMAND}: nothing to compare with")
POSES = in_slices(40)
POINTS = in_slices(100)


def described(shape: toccata.Shape, folder: pathlib.Path) -> dict:
    """The shape as a scene file has it."""
    triple = lambda v: [float(x) for x in v]  # noqa: E731
    rows = lambda m: [triple(v) for v in m]  # noqa: E731
    kind = shape.kind.replace(" ", "-")
    numbers = {
        "point": lambda: {"position": triple(shape.position)},
        "segment": lambda: {"start": triple(shape.start), "end": triple(shape.end)},
        "triangle": lambda: {"vertices": rows(shape.vertices)},
        "half-space": lambda: {"point": triple(shape.point), "normal": triple(shape.normal)},
        "sphere": lambda: {"radius": shape.radius, "centre": triple(shape.centre)},
        "box": lambda: {"half_extents": triple(shape.half_extents), "centre": triple(shape.centre)},
        "capsule": lambda: {"start": triple(shape.start), "end": triple(shape.end), "radius": shape.radius},
        "convex-hull": lambda: {"points": rows(shape.vertices)},
        "rounded-shape": lambda: {"core": described(shape.core, folder)["shape"], "radius": shape.radius},
        "cylinder": lambda: {"radius": shape.radius, "half_height": shape.half_height},
        "cone": lambda: {"radius": shape.radius, "half_height": shape.half_height},
        "ellipsoid": lambda: {"half_axes": triple(shape.half_axes)},
        "height-field": lambda: {
            "columns": shape.heights.shape[1],
            "rows": shape.heights.shape[0],
            "spacing": list(shape.spacing),
            "heights": shape.heights.ravel().tolist(),
        },
        "compound": lambda: {
            "parts": [{**described(part, folder), "pose": {"translation": triple(pose.offset)}} for part, pose in shape.parts]
        },
    }
    if kind == "mesh":
        shape.write(str(folder / "mesh.obj"))
        return {"file": "mesh.obj"}
    return {"shape": {"type": "rounded" if kind == "rounded-shape" else kind, **numbers[kind]()}}


def scene_of(shapes: list, folder: pathlib.Path) -> pathlib.Path:
    objects = [{"name": f"{i}", **described(shape, folder)} for i, shape in enumerate(shapes)]
    file = folder / "scene.json"
    file.write_text(json.dumps({"format": "toccata-scene", "version": 1, "unit": "unit", "objects": objects}))
    return file


def asked(*words: object) -> dict:
    run = subprocess.run([str(COMMAND), *map(str, words), "--json"], capture_output=True, text=True)
    assert run.returncode in (0, 1), run.stderr
    return json.loads(run.stdout)


def written(rows: numpy.ndarray, file: pathlib.Path) -> pathlib.Path:
    file.write_text("".join(" ".join(map(repr, row)) + "\n" for row in rows.tolist()))
    return file


def poses_file(poses: numpy.ndarray, file: pathlib.Path) -> pathlib.Path:
    return written(numpy.concatenate([poses[:, :3, :3].reshape(-1, 9), poses[:, :3, 3]], axis=1), file)


def pairs_asked() -> list:
    """Of all; in a slice of a third, in which every shape is still."""
    shapes = one_of_each()
    pairs = itertools.combinations_with_replacement(range(len(shapes)), 2)
    return [(shapes[i], shapes[j]) for i, j in pairs if not SLICE or (i + j) % 3 == 0]


@needs_command
def test_questions_about_two_shapes(tmp_path):
    compared = 0
    for number, (a, b) in enumerate(pairs_asked()):
        poses = matrices(POSES, 1.5, number)
        scene, file = scene_of([a, b], tmp_path), poses_file(poses, tmp_path / "poses.txt")
        found = toccata.distance_each(a, b, poses_b=poses)
        for told, row in zip(asked("distance", scene, "--poses", file)["queries"], found, strict=True):
            for name in ("lower", "upper", "on_a", "on_b", "face_a", "face_b"):
                assert numpy.array_equal(told[name], row[name]), (a, b, told, row)
            assert told["status"] == toccata.Status(row["status"]).name
            compared += 1
        relations = toccata.relation_each(a, b, poses_b=poses)
        quick = not any(s.element_count > 1 for s in (a, b))
        words = ["--penetration"] if quick and defined(toccata.penetration, a, b) else []
        for i, told in enumerate(asked("check", scene, "--poses", file, *words)["queries"]):
            assert told["relation"] == toccata.RelationKind(relations[i]["kind"]).name, (a, b, told)
            assert told["containment"] == toccata.Containment(relations[i]["containment"]).name
            assert told["contact"] == toccata.overlap(a, b, pose_b=poses[i])
            if "penetration" in told:
                depth = toccata.penetration(a, b, pose_b=poses[i])
                for name in ("lower", "upper", "direction", "on_a", "on_b"):
                    assert numpy.array_equal(told["penetration"][name], getattr(depth, name)), (a, b, told, depth)
            compared += 1
    assert compared >= (300 if SLICE else 9000)


def defined(question, a, b) -> bool:
    try:
        question(a, b)
    except toccata.Error:
        return False
    return True


@needs_command
def test_questions_about_points_and_rays(tmp_path):
    compared = 0
    for number, shape in enumerate(one_of_each()):
        rng = numpy.random.default_rng(number)
        points, ends = rng.normal(size=(2, POINTS, 3))
        scene = scene_of([shape], tmp_path)
        rays = asked("ray", scene, "--rays", written(numpy.hstack([points, ends]), tmp_path / "rays.txt"))["rays"]
        hits = toccata.cast_ray_each(points, ends - points, shape)
        for told, row in zip(rays, hits, strict=True):
            assert told["hit"] == row["found"]
            for name in ("lower", "upper", "point", "normal", "face") if told["hit"] else ():
                assert numpy.array_equal(told[name], row[name]), (shape, told, row)
            compared += 1
        near = asked("nearest", scene, "--signed", "--points", written(points, tmp_path / "points.txt"))["points"]
        signed = toccata.signed_distance_each(points, shape)
        for told, row in zip(near, signed, strict=True):
            assert (told["signed_lower"], told["signed_upper"]) == (row["lower"], row["upper"]), (shape, told, row)
            assert numpy.array_equal(told["nearest"][0]["at"], row["nearest"]) and told["side"] == toccata.Side(row["side"]).name
            compared += 1
    assert compared >= (250 if SLICE else 2500)


# What library_answers.cpp asks, asked here.


@pytest.fixture(scope="module")
def told(tmp_path_factory) -> dict:
    """By question, the numbers of each row: what C++ answers, and the poses that it was asked at."""
    compiler = shutil.which("c++")
    if not LIBRARY.exists() or compiler is None:
        pytest.skip(f"there is no library {LIBRARY}, or no compiler: nothing to compare with")
    folder = tmp_path_factory.mktemp("library")
    words = ["-std=c++20", "-O0", "-ffp-contract=off", f"-I{ROOT / 'include'}", pathlib.Path(__file__).with_name("library_answers.cpp"), LIBRARY]
    linked = ["-ltbb", "-lhwy", "-lfmt", "-lpthread", "-ldl", "-o", folder / "library_answers"]
    alone = {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}  # without the sanitizers of Python
    compiled = subprocess.run([compiler, *map(str, words + linked)], capture_output=True, text=True, env=alone)
    assert compiled.returncode == 0, compiled.stderr
    poses = matrices(in_slices(40), 1.2, 77)
    run = subprocess.run([folder / "library_answers", poses_file(poses, folder / "poses.txt")], capture_output=True, text=True, env=alone)
    assert run.returncode == 0, run.stderr
    rows: dict = {"poses": poses}
    for line in run.stdout.splitlines():
        name, numbers_told = line.split("\t")
        query, *numbers = numbers_told.split()
        rows.setdefault(name, []).append([float(query), *map(float.fromhex, numbers)])
    return rows


def numbers_of(row, names: str) -> list[float]:
    """Of an answer, or of a row of an array."""
    get = row.__getitem__ if isinstance(row, numpy.void) else lambda name: getattr(row, name)
    return [float(number) for name in names.split() for number in numpy.ravel(get(name))]


CONTACT = "element_a element_b face_a face_b kind coplanar crossing point_count"
HIT = "lower upper point normal status element_a element_b face_a face_b"


def shapes_asked() -> list:
    return [toccata.generate_mesh("icosphere", subdivisions=2), toccata.generate_mesh("gear"), toccata.Box((0.5, 0.6, 0.7)), toccata.Sphere(0.7),
            toccata.Capsule((0, 0, 0), (0, 0, 1), 0.3)]


def are_equal(ours: dict, told: dict, least: dict) -> None:
    """To the bit, also which zero it is."""
    for name, rows in ours.items():
        expected = told.get(name, [])
        # In few steps of a slice nothing may end.
        assert len(rows) == len(expected) >= (0 if SLICE else least.get(name, 1)), (name, len(rows), len(expected))
        assert numpy.array(rows).tobytes() == numpy.array(expected).tobytes(), name


def test_pairs_of_meshes(told):
    knot, bumpy, poses = toccata.generate_mesh("torus-knot"), toccata.generate_mesh("noise-sphere"), told["poses"]
    ours: dict = {name: [] for name in ("contacts", "points", "regions", "casts", "sweeps")}
    for i, pose in enumerate(poses):
        following = poses[(i + 1) % len(poses)]
        ours["contacts"] += [[i, *numbers_of(row, CONTACT)] for row in toccata.contacts(knot, bumpy, pose_b=pose)]
        ours["points"] += [[i, *numbers_of(row, "points")] for row in toccata.contacts_with_points(knot, bumpy, pose_b=pose)]
        regions = toccata.contact_regions(knot, bumpy, pose_b=pose)
        names = "triangle_pairs face_pairs lower upper point_count closed curve_count area normal depth_lower depth_upper deepest"
        ours["regions"] += [[i, *numpy.nan_to_num(numbers_of(row, names)).tolist()] for row in regions]
        if hit := toccata.cast_shape(knot, pose[:3, 3], bumpy, pose_b=following):
            ours["casts"].append([i, *numbers_of(hit, HIT)])
        if hit := toccata.sweep(knot, pose, bumpy, toccata.RigidMotion.between(following, pose)):
            ours["sweeps"].append([i, *numbers_of(hit, HIT)])
    are_equal(ours, told, {"contacts": 100 * len(poses), "points": 100 * len(poses), "regions": len(poses)})


def test_points_beside_meshes(told):
    knot, ball, poses = toccata.generate_mesh("torus-knot"), toccata.generate_mesh("icosphere"), told["poses"]
    opened = toccata.Mesh(ball.vertices, ball.faces[1:])
    ours: dict = {name: [] for name in ("nearest", "located", "winding")}
    for i, pose in enumerate(poses):
        point, pose = pose[:3, 3], poses[(i + 1) % len(poses)]
        near = toccata.nearest_point(point, knot, pose)
        ours["nearest"].append([i, *numbers_of(near, "lower upper point element face status")])
        side, winds = toccata.locate(point, knot, pose)
        ours["located"].append([i, float(side), float(winds)])
        ours["winding"].append([i, *numbers_of(toccata.generalized_winding_number(point, opened, pose), "value lower upper status")])
    are_equal(ours, told, {})


def test_scenes(told):
    shapes, poses = shapes_asked(), told["poses"]
    index = toccata.SceneIndex([(shapes[i % 5], pose) for i, pose in enumerate(poses)])
    ours: dict = {name: [] for name in ("scene rays", "scene overlaps", "scene nearest")}
    for i, pose in enumerate(poses):
        start, shape = pose[:3, 3], shapes[i % 5]
        if hit := index.cast_ray(start, poses[(i + 1) % len(poses), :3, 3] - start):
            ours["scene rays"].append([i, *numbers_of(hit, "object lower upper point normal element face")])
        ours["scene overlaps"] += [[i, float(number)] for number in index.overlapping(shape, start)]
        if near := index.nearest(shape, start + (4, 0, 0)):
            ours["scene nearest"].append([i, *numbers_of(near, "object lower upper on_a on_b element_a element_b")])
    are_equal(ours, told, {"scene overlaps": len(poses)})


def test_steps_of_a_world(told):
    shapes, poses = shapes_asked(), told["poses"]
    world = toccata.World(relation=True, distance=True, contacts=True)
    ids = world.add_each([shapes[i % 5] for i in range(len(poses))], poses, margins=0.25)
    names = ("world", "world begin", "world persist", "world end", "world distances", "world relations", "world contacts")
    ours: dict = {name: [] for name in names}
    for step in range(6):
        found = world.step()
        ours["world"].append([step, float(found.candidates)])
        for part in ("begin", "persist", "end"):
            pairs = getattr(found, part)
            ours[f"world {part}"] += [[step, float(p["a"]["index"]), float(p["b"]["index"]), float(p["in_contact"])] for p in pairs.pairs]
            ours["world distances"] += [[step, *numbers_of(row, "lower upper on_a on_b")] for row in pairs.distances]
            ours["world relations"] += [[step, *numbers_of(row, "kind containment")] for row in pairs.relations]
            ours["world contacts"] += [[step, *numbers_of(row, CONTACT)] for row in pairs.contacts]
        world.move(ids, numpy.roll(poses, -(step // 2 + 1), axis=0))
    are_equal(ours, told, {"world contacts": 100})


def test_a_mesh_and_itself(told):
    knot = toccata.generate_mesh("torus-knot")
    vertices = numpy.vstack([knot.vertices, knot.vertices + (0.25, 0, 0)])
    mesh = toccata.Mesh(vertices, numpy.vstack([knot.faces, knot.faces + len(knot.vertices)]))
    are_equal({"self contacts": [[0, *numbers_of(row, CONTACT)] for row in toccata.self_contacts(mesh)]}, told, {"self contacts": 1000})
