"""An arm of seven joints and eight meshes in a room of boxes and meshes: Toccata by a Python loop and in batch, beside python-fcl by the same loop.

python-fcl is asked as its users ask it: a BVHModel for each mesh, the obstacles in a DynamicAABBTreeCollisionManager that is
set up once, for each link its collide(), then the pairs of links, until something meets. Where the links are is told to
both by the same forward kinematics (Robot.link_poses). Its meshes are surfaces, so the answers are compared with those of
Toccata about the same meshes as surfaces; which configurations the solids meet besides is counted too.

Edges are asked of python-fcl by configurations between, as planners do: no joint turns farther than STEP from one to the
next. What is met between these is missed, and counted.
"""

import importlib
import time
from collections.abc import Callable
from typing import Any

import numpy

import toccata

# Radians between two configurations of an edge that is asked about by samples.
STEP = 0.05
# Disagreements that are listed; all are counted.
LISTED = 10


def installed(name: str) -> Any:
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def seconds_and_answers(work: Callable[[], Any], rounds: int) -> tuple[float, Any]:
    """The processor's, the least of the rounds, and what the last one answered."""
    found, answers = [], None
    for _ in range(rounds):
        begin = time.process_time()
        answers = work()
        found.append(time.process_time() - begin)
    return min(found), answers


def as_surfaces(robot: toccata.Robot, room: list) -> toccata.RobotScene:
    """The same robot and room, whose meshes are no solids."""
    none, rest = toccata.Solid.none, robot.link_poses(robot.rest())
    links: dict = {name: [] for name in robot.links}
    for link, shape, pose in bodies(robot, rest):
        links[robot.links[link]].append(toccata.SceneInstance(shape, pose, none))
    same = toccata.Robot(links, robot.joints, robot.name)
    return toccata.RobotScene(same, [toccata.SceneInstance(o.shape, o.pose, none, o.name) for o in room])


def bodies(robot: toccata.Robot, rest: numpy.ndarray) -> list:
    """(link, shape, where it is in the frame of the link); of the generated arm each link has one."""
    posed = robot.posed(robot.rest())
    assert len(posed) == len(robot.links)
    return [(i, body.shape, numpy.linalg.inv(rest[i]) @ body.pose.matrix) for i, body in enumerate(posed)]


class FclScene:
    """What python-fcl is asked about."""

    def __init__(self, fcl: Any, scene: toccata.RobotScene):
        self.fcl, robot = fcl, scene.robot
        self.robot = robot
        self.links = [(link, local, fcl.CollisionObject(self.geometry(shape))) for link, shape, local in bodies(robot, robot.link_poses(robot.rest()))]
        count = len(self.links)
        self.pairs = [(i, j) for i in range(count) for j in range(i + 1, count) if scene.looks_at(self.links[i][0], self.links[j][0])]
        self.obstacles = [fcl.CollisionObject(self.geometry(o.shape), self.transform(o.pose.matrix)) for o in scene.obstacles]
        self.manager = fcl.DynamicAABBTreeCollisionManager()
        self.manager.registerObjects(self.obstacles)
        self.manager.setup()

    def transform(self, matrix: numpy.ndarray) -> Any:
        return self.fcl.Transform(matrix[:3, :3], matrix[:3, 3])

    def geometry(self, shape: toccata.Shape) -> Any:
        if isinstance(shape, toccata.Box):
            assert not shape.centre.any()
            return self.fcl.Box(*(2 * shape.half_extents))
        model = self.fcl.BVHModel()
        model.beginModel(len(shape.vertices), len(shape.faces))
        model.addSubModel(shape.vertices, shape.faces)
        model.endModel()
        return model

    def meets(self, configuration: numpy.ndarray) -> bool:
        fcl, poses = self.fcl, self.robot.link_poses(configuration)
        for link, local, thing in self.links:
            thing.setTransform(self.transform(poses[link] @ local))
        for _, _, thing in self.links:
            data = fcl.CollisionData()
            self.manager.collide(thing, data, fcl.defaultCollisionCallback)
            if data.result.is_collision:
                return True
        return any(fcl.collide(self.links[i][2], self.links[j][2]) > 0 for i, j in self.pairs)

    def is_free(self, begin: numpy.ndarray, end: numpy.ndarray) -> bool:
        steps = max(1, int(numpy.ceil(numpy.abs(end - begin).max() / STEP)))
        return not any(self.meets(begin + (i / steps) * (end - begin)) for i in range(steps + 1))


def a_second(count: int, seconds: float) -> int:
    return round(count / seconds) if seconds > 0 else 0


def disagreements(ours: numpy.ndarray, theirs: numpy.ndarray, asked: numpy.ndarray) -> dict:
    differ = numpy.flatnonzero(ours != theirs)
    listed = [{"number": int(i), "exact": bool(ours[i]), "python-fcl": bool(theirs[i]), "asked": asked[i].tolist()} for i in differ[:LISTED]]
    return {"count": len(differ), "listed": listed}


def measure_configurations(scene: toccata.RobotScene, surfaces: toccata.RobotScene, many: numpy.ndarray, peer: FclScene | None, rounds: int) -> dict:
    count = len(many)
    batch, meets = seconds_and_answers(lambda: scene.meets_each(many, threads=1), rounds)
    loop, by_loop = seconds_and_answers(lambda: [scene.meets(q) for q in many], rounds)
    told: dict = {"count": count, "meet": int(meets.sum()),
                  "a second": {"batch": a_second(count, batch), "the same loop": a_second(count, loop)},
                  "wrong": [] if numpy.array_equal(meets, by_loop) else ["loop and batch"]}
    if peer is None:
        return told
    seconds, theirs = seconds_and_answers(lambda: [peer.meets(q) for q in many], 1)
    of_surfaces = surfaces.meets_each(many, threads=1)
    told["a second"]["python-fcl in the loop"] = a_second(count, seconds)
    told["times as fast"] = {"batch": round(seconds / batch, 1), "the same loop": round(seconds / loop, 1)}
    told["python-fcl beside the exact answers of the surfaces"] = disagreements(of_surfaces, numpy.array(theirs), many)
    told["met by the solids alone"] = int((meets & ~of_surfaces).sum())
    return told


def measure_edges(scene: toccata.RobotScene, surfaces: toccata.RobotScene, begins: numpy.ndarray, ends: numpy.ndarray, peer: FclScene | None,
                  rounds: int) -> dict:
    count, pairs = len(begins), list(zip(begins, ends))
    batch, free = seconds_and_answers(lambda: scene.free_each(begins, ends, threads=1), rounds)
    told_when, edges = seconds_and_answers(lambda: scene.edge_each(begins, ends, threads=1), rounds)
    loop, by_loop = seconds_and_answers(lambda: [scene.edge(a, b).is_free for a, b in pairs], rounds)
    same = numpy.array_equal(free, edges["is_free"]) and numpy.array_equal(free, by_loop)
    told: dict = {"count": count, "free": int(free.sum()), "undecided": int((edges["status"] != int(toccata.Status.exact)).sum()),
                  "a second": {"batch, whether free": a_second(count, batch), "batch, and the first contact": a_second(count, told_when),
                               "the same loop": a_second(count, loop)},
                  "wrong": [] if same else ["loop and batch"]}
    if peer is None:
        return told
    seconds, theirs = seconds_and_answers(lambda: [peer.is_free(a, b) for a, b in pairs], 1)
    exact = surfaces.free_each(begins, ends, threads=1)
    told["a second"][f"python-fcl in the loop, every {STEP} radians"] = a_second(count, seconds)
    told["times as fast"] = {"batch, whether free": round(seconds / batch, 1), "the same loop": round(seconds / loop, 1)}
    differing = disagreements(exact, numpy.array(theirs), numpy.stack([begins, ends], axis=1))
    told["python-fcl beside the proved answers of the surfaces"] = differing
    told["not free, and free by python-fcl's samples"] = int((~exact & numpy.array(theirs)).sum())
    return told


def measure_robot(count: int, edges: int, subdivisions: int = 3, boxes: int = 100, part: float = 0.1, rounds: int = 3) -> dict:
    """An edge goes `part` of the way from one random configuration to another."""
    robot, room = toccata.Robot.generated(subdivisions), toccata.generated_room(boxes)
    scene, surfaces = toccata.RobotScene(robot, room), as_surfaces(robot, room)
    many = robot.sampled(count, seed=1)
    begins = robot.sampled(edges, seed=2)
    ends = begins + part * (robot.sampled(edges, seed=3) - begins)
    fcl = installed("fcl")
    peer = FclScene(fcl, scene) if fcl else None
    told: dict = {"triangles of a link": len(bodies(robot, robot.link_poses(robot.rest()))[0][1].faces), "obstacles": len(room)}
    if peer is None:
        told["skipped"] = "python-fcl is not installed"
    told["configurations"] = measure_configurations(scene, surfaces, many, peer, rounds)
    told["edges"] = measure_edges(scene, surfaces, begins, ends, peer, rounds)
    told["wrong"] = told["configurations"]["wrong"] + told["edges"]["wrong"]
    return told
