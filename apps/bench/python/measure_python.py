"""Measures the Python package beside its peers, in one run on the same inputs, and compares the answers.

usage: measure_python.py [--mesh FILE.obj] [--poses N] [--parts N] [--configurations N] [--edges N] [--json FILE]
                         [--evidence] [--library BUILD]

The mesh of the batch is that of --mesh, or the bunny of the folder TOCCATA_DATA, or a torus knot that is generated. Peers
that are not installed are left out: python-fcl, coal, pybullet, trimesh. With --library, a folder in which the library is
built (build/release), the same batch is timed in C++ too, and Python may take 5 % longer than that. Times are the
processor's, of one thread, and each the best of several rounds, so that a busy machine disturbs them less; what is
compared takes turns, as the machine may be busier at one time than at another. --evidence docs/evidence/python.json. Exits with 1 where an answer differs.
"""

import argparse
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from typing import Any

import numpy

import toccata
from measure_robot import installed, measure_robot

ROOT = pathlib.Path(__file__).resolve().parents[3]
EVIDENCE = ROOT / "docs/evidence/python.json"
# How much longer a batch may take from Python than from C++.
MOST_OVER_CPP = 1.05
# How often Python and C++ are asked in turns, each in a process of its own on one core, as single turns differ by a fifth.
TURNS = 21
# Of managers: their questions take less than the machine takes to change its pace.
MANAGER_ROUNDS = 40


def best(work: Callable[[], Any], rounds: int = 5, times: int = 1) -> float:
    """Processor seconds of one call."""
    found = []
    for _ in range(rounds):
        begin = time.process_time()
        for _ in range(times):
            work()
        found.append(time.process_time() - begin)
    return min(found) / times


def best_in_turns(works: dict[str, Callable[[], Any]], rounds: int) -> dict[str, float]:
    """Processor seconds of each, which take turns."""
    found = {name: math.inf for name in works}
    for _ in range(rounds):
        for name, work in works.items():
            found[name] = min(found[name], best(work, rounds=1))
    return found


def rotations(count: int, rng: numpy.random.Generator) -> numpy.ndarray:
    q = rng.normal(size=(count, 4))
    w, x, y, z = (q / numpy.linalg.norm(q, axis=1, keepdims=True)).T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return numpy.moveaxis(numpy.array(rows), 2, 0)


def random_poses(count: int, spread: float, seed: int) -> numpy.ndarray:
    rng = numpy.random.default_rng(seed)
    poses = numpy.tile(numpy.eye(4), (count, 1, 1))
    poses[:, :3, :3] = rotations(count, rng)
    poses[:, :3, 3] = rng.uniform(-spread, spread, (count, 3))
    return poses


def measure_call() -> dict:
    """One call: the distance of a box and a sphere."""
    ball, box, pose = toccata.Sphere(0.25), toccata.Box((1, 1, 0.5)), toccata.Pose((0.25, 0, 3))
    ask, times, rounds = toccata.distance, 2_000, 60
    batch = numpy.tile(pose.matrix, (100_000, 1, 1))
    pairs = {
        "call": best(lambda: ask(box, ball, None, pose), rounds, times),
        "call, pose by its name": best(lambda: ask(box, ball, pose_b=pose), rounds, times),
        "loop alone": best(lambda: None, rounds, times),
        "a question of a batch": best(lambda: toccata.distance_each(box, ball, poses_b=batch, threads=1)) / len(batch),
    }
    told = ask(box, ball, None, pose).upper
    wrong = []
    if fcl := installed("fcl"):
        of_box = fcl.CollisionObject(fcl.Box(2, 2, 1))
        of_ball = fcl.CollisionObject(fcl.Sphere(0.25), fcl.Transform(numpy.eye(3), numpy.array([0.25, 0, 3.0])))
        pairs["python-fcl"] = best(lambda: fcl.distance(of_box, of_ball), times=2_000)
        if abs(fcl.distance(of_box, of_ball) - told) > 1e-3:
            wrong.append("python-fcl")
    if coal := installed("coal"):
        shape_a, shape_b, at = coal.Box(2, 2, 1), coal.Sphere(0.25), coal.Transform3s(numpy.eye(3), numpy.array([0.25, 0, 3.0]))
        here, request, result = coal.Transform3s(), coal.DistanceRequest(), coal.DistanceResult()

        def by_coal() -> float:
            result.clear()
            return float(coal.distance(shape_a, here, shape_b, at, request, result))

        pairs["coal"] = best(by_coal, times=2_000)
        if abs(by_coal() - told) > 1e-6:
            wrong.append("coal")
    if pybullet := installed("pybullet"):
        client = pybullet.connect(pybullet.DIRECT)
        bodies = [
            pybullet.createMultiBody(0, pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=[1, 1, 0.5])),
            pybullet.createMultiBody(0, pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=0.25), basePosition=[0.25, 0, 3]),
        ]
        pairs["pybullet"] = best(lambda: pybullet.getClosestPoints(*bodies, distance=10), times=2_000)
        if abs(pybullet.getClosestPoints(*bodies, distance=10)[0][8] - told) > 1e-3:
            wrong.append("pybullet")
        pybullet.disconnect(client)
    return {"nanoseconds": {k: round(v * 1e9) for k, v in pairs.items()}, "wrong": wrong}


def measure_batch(mesh: str, count: int, library: pathlib.Path | None) -> dict:
    """A mesh against itself at many poses, on one thread."""
    shape = toccata.load_mesh(mesh)
    size = float(numpy.ptp(shape.vertices, axis=0).max())
    poses = random_poses(count, 0.7 * size, 3)
    seconds = best(lambda: toccata.overlap_each(shape, shape, poses_b=poses, threads=1), rounds=3)
    found = toccata.overlap_each(shape, shape, poses_b=poses, threads=1)
    told: dict = {"poses": count, "meet": int(found.sum()), "microseconds a pose": seconds / count * 1e6, "wrong": []}
    if fcl := installed("fcl"):
        model = fcl.BVHModel()
        model.beginModel(len(shape.vertices), len(shape.faces))
        model.addSubModel(shape.vertices, shape.faces)
        model.endModel()
        still, moved = fcl.CollisionObject(model), fcl.CollisionObject(model)
        some = poses[: min(count, 2000)]

        def by_fcl() -> list:
            answers = []
            for pose in some:
                moved.setTransform(fcl.Transform(pose[:3, :3], pose[:3, 3]))
                answers.append(fcl.collide(still, moved) > 0)
            return answers

        told["python-fcl, microseconds a pose"] = best(by_fcl, rounds=2) / len(some) * 1e6
        surfaces = toccata.overlap_each(shape, shape, poses_b=some, solid_a=toccata.Solid.none, solid_b=toccata.Solid.none)
        told["answers of python-fcl that differ from the exact ones of the surfaces"] = int((surfaces != by_fcl()).sum())
    if library is not None:
        with tempfile.TemporaryDirectory() as folder:
            in_cpp = cpp_program(pathlib.Path(folder), mesh, poses, library)
            in_python = [sys.executable, str(pathlib.Path(__file__).with_name("batch.py")), *in_cpp[1:]]
            runs = [in_turn(in_cpp, in_python, turn) for turn in range(TURNS)]
        told["C++, nanoseconds a call of distance"] = round(min(cpp[2] for cpp, _ in runs) * 1e9)
        told["microseconds a pose"] = min(python[0] for _, python in runs) / count * 1e6
        told["C++, microseconds a pose"] = min(cpp[0] for cpp, _ in runs) / count * 1e6
        ratio = statistics.median(python[0] / cpp[0] for cpp, python in runs)
        told["Python to C++ in each turn"] = [round(python[0] / cpp[0], 3) for cpp, python in runs]
        told["Python to C++"] = ratio
        told["at most 5 % more than C++"] = ratio <= MOST_OVER_CPP
        told["wrong"] += [f"{cpp[1]} meet in C++, {python[1]} in Python" for cpp, python in runs if not cpp[1] == python[1] == told["meet"]]
    return told


def cpp_program(folder: pathlib.Path, mesh: str, poses: numpy.ndarray, library: pathlib.Path) -> list[str]:
    """What asks the same in C++, compiled into the folder."""
    program, file = folder / "batch", folder / "poses"
    numbers = numpy.concatenate([poses[:, :3, :3].reshape(-1, 9), poses[:, :3, 3]], axis=1)
    file.write_bytes(numpy.ascontiguousarray(numbers).tobytes())
    source = pathlib.Path(__file__).with_name("batch.cpp")
    words = ["-std=c++20", "-O2", "-ffp-contract=off", f"-I{ROOT / 'include'}", source, library / "libtoccata.a"]
    subprocess.run(["c++", *map(str, words), "-ltbb", "-lhwy", "-lfmt", "-lpthread", "-o", str(program)], check=True)
    return [str(program), mesh, str(file), str(len(poses))]


def in_turn(one: list[str], other: list[str], turn: int) -> tuple[list[float], list[float]]:
    """What two programs tell, of which each is the first in every second turn: a machine changes its pace."""
    if turn % 2 == 0:
        return run(one), run(other)
    later = run(other)
    return run(one), later


def run(program: list[str]) -> list[float]:
    """Processor seconds of the batch, how many meet, and in C++ seconds of a call."""
    core = min(os.sched_getaffinity(0))
    result = subprocess.run(program, capture_output=True, text=True, check=True, preexec_fn=lambda: os.sched_setaffinity(0, {core}))
    return [float(word) for word in result.stdout.split()]


def measure_manager(count: int, spread: float) -> dict:
    """trimesh's collision manager of many parts that move before every question; the two take turns."""
    trimesh = installed("trimesh")
    if trimesh is None:
        return {"skipped": "trimesh is not installed"}
    import toccata.trimesh

    shapes = [trimesh.creation.torus(1, 0.3), trimesh.creation.icosphere(radius=0.7), trimesh.creation.annulus(0.3, 0.8, 0.5)]
    steps = [random_poses(count, spread * count ** (1 / 3), 20 + i) for i in range(4)]
    told: dict = {"parts": count, "wrong": []}
    kinds = {"toccata": toccata.trimesh.CollisionManager}
    if installed("fcl"):
        kinds["trimesh with python-fcl"] = trimesh.collision.CollisionManager
    managers = {kind: Manager() for kind, Manager in kinds.items()}

    def add_all(manager: Any) -> None:
        for i, pose in enumerate(steps[0]):
            manager.add_object(f"part {i}", shapes[i % 3], pose)

    def move(manager: Any, poses: numpy.ndarray) -> None:
        for i, pose in enumerate(poses):
            manager.set_transform(f"part {i}", pose)

    def move_all(manager: Any) -> None:
        for poses in steps:
            move(manager, poses)

    def moved_and_asked(manager: Any, **words: bool) -> list:
        return [(move(manager, poses), manager.in_collision_internal(**words))[1] for poses in steps]

    def in_turns(work: Callable[..., Any], rounds: int, share: int = len(steps), **words: bool) -> dict[str, float]:
        times = best_in_turns({kind: lambda m=m: work(m, **words) for kind, m in managers.items()}, rounds)
        return {kind: seconds / share for kind, seconds in times.items()}

    times = {
        "add all": in_turns(add_all, 1, 1),
        "in_collision_internal": in_turns(moved_and_asked, MANAGER_ROUNDS),
        "… of them, set_transform": in_turns(move_all, MANAGER_ROUNDS),
        "in_collision_internal(return_names)": in_turns(moved_and_asked, MANAGER_ROUNDS // 5, return_names=True),
    }
    names = {kind: [found for _, found in moved_and_asked(m, return_names=True)] for kind, m in managers.items()}
    for kind in kinds:
        told[kind] = {name: f"{seconds[kind] * 1e3:.3f} ms" for name, seconds in times.items()}
    if len(kinds) == 2:
        ours, theirs = kinds
        told["times as fast"] = {name: round(seconds[theirs] / seconds[ours], 1) for name, seconds in times.items()}
        told["pairs"] = [len(found) for found in names[ours]]
        told["pairs that python-fcl lacks or has besides"] = [len(a ^ b) for a, b in zip(names[ours], names[theirs])]
    return told


def mesh_at_hand(folder: pathlib.Path) -> str:
    """The bunny, where the data are."""
    bunny = pathlib.Path(os.environ.get("TOCCATA_DATA", "")) / "meshes/stanford-bunny.obj"
    if os.environ.get("TOCCATA_DATA") and bunny.exists():
        return str(bunny)
    knot = folder / "knot.obj"
    toccata.generate_mesh("torus-knot").write(str(knot))
    return str(knot)


def commit() -> str:
    run = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=ROOT, capture_output=True, text=True)
    return run.stdout.strip() or "unknown"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--mesh", help="a closed mesh; without, the bunny of TOCCATA_DATA, or a torus knot")
    parser.add_argument("--poses", type=int, default=1_000_000, help="of the mesh against itself, in batch")
    parser.add_argument("--parts", type=int, default=200, help="of the collision manager")
    parser.add_argument("--configurations", type=int, default=20_000, help="of the robot")
    parser.add_argument("--edges", type=int, default=2_000, help="between configurations of the robot")
    parser.add_argument("--library", type=pathlib.Path)
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--evidence", action="store_true")
    words = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        mesh = words.mesh or mesh_at_hand(pathlib.Path(folder))
        report: dict = {
            "version": toccata.__version__,
            "commit": commit(),
            "python": sys.version.split()[0],
            "one call": measure_call(),
            "a batch": {"mesh": pathlib.Path(mesh).name, **measure_batch(mesh, words.poses, words.library)},
            "a collision manager, crowded": measure_manager(words.parts, 0.9),
            "a collision manager, sparse": measure_manager(words.parts, 4),
            "a robot": measure_robot(words.configurations, words.edges),
        }
        call, batch = report["one call"]["nanoseconds"], report["a batch"]
        if "C++, nanoseconds a call of distance" in batch:
            overhead = call["call"] - call["loop alone"] - batch["C++, nanoseconds a call of distance"]
            report["one call"]["overhead over C++ in nanoseconds"] = overhead
    text = json.dumps(report, indent=1, ensure_ascii=False)
    print(text)
    for file in [words.json, EVIDENCE if words.evidence else None]:
        if file:
            file.write_text(text + "\n")
    return 1 if any(part.get("wrong") for part in report.values() if isinstance(part, dict)) else 0


if __name__ == "__main__":
    sys.exit(main())
