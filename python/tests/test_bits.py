"""Every answer of Python is that of the C++ library, to the bit: 10,000 generated questions, asked of the command too.

The command is TOCCATA_COMMAND, or that of build/release; its JSON holds doubles that round-trip.
"""

import itertools
import json
import os
import pathlib
import subprocess

import numpy
import pytest

import toccata
from conftest import SLICE, in_slices, matrices, one_of_each

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMAND = pathlib.Path(os.environ.get("TOCCATA_COMMAND", ROOT / "build/release/apps/toccata/toccata"))
pytestmark = pytest.mark.skipif(not COMMAND.exists(), reason=f"there is no command {COMMAND}: nothing to compare with")
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


def test_questions_about_two_shapes(tmp_path):
    compared = 0
    for number, (a, b) in enumerate(itertools.combinations_with_replacement(one_of_each(), 2)):
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
    assert compared >= (900 if SLICE else 9000)


def defined(question, a, b) -> bool:
    try:
        question(a, b)
    except toccata.Error:
        return False
    return True


def test_questions_about_points_and_rays(tmp_path):
    compared = 0
    for number, shape in enumerate(one_of_each()):
        rng = numpy.random.default_rng(number)
        points, ends = rng.normal(size=(2, POINTS, 3))
        scene = scene_of([shape], tmp_path)
        rays = asked("ray", scene, "--rays", written(numpy.hstack([points, ends]), tmp_path / "rays.txt"))["rays"]
        hits = toccata.cast_ray_each(points, ends - points, shape)
        for told, row in zip(rays, hits, strict=True):
            assert told["hit"] == row["hit"]
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
