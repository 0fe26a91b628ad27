"""Nothing is kept that is not used: memory stays flat over 10⁶ calls, and no call keeps a reference."""

import gc
import itertools
import subprocess
import sys

import numpy

import toccata
from conftest import SLICE, in_slices

CALLS = """
import numpy, toccata, resource
knot = toccata.generate_mesh("torus-knot", **{})
ball, box = toccata.Sphere(0.4), toccata.Box((1, 1, 1))
pose, matrix = toccata.Pose((0.5, 0, 0)), numpy.eye(4)
world = toccata.World(distance=True)
ids = world.add_each(box, numpy.arange(12.0).reshape(4, 3))
index = toccata.SceneIndex([ball, (box, pose)])
robot = toccata.Robot.generated(1)
scene, many = toccata.RobotScene(robot, [box]), robot.sampled(3)
deforming = toccata.DeformingMesh(toccata.generate_mesh("box"))
walker, state = toccata.SceneIndex([(box, (0, 0, -1))]), toccata.SceneMoverState((0, 0, 2))

def some_calls():
    for _ in range(PER_ROUND):
        toccata.distance(ball, box, pose_b=pose).on_a
        toccata.overlap(ball, box, matrix, pose_b=(3, 0, 0))
        toccata.Pose(matrix) * pose
        toccata.relation(ball, box)
        try:
            toccata.overlap(ball, 5)
        except TypeError:
            pass
        toccata.cast_ray((0, 0, 5), (0, 0, -9), box)
        toccata.Box((1, 2, 3)).half_extents
        world.nearest(ball)
        index.overlapping(ball)
        toccata.distance_each(ball, box, poses_b=[[0, 0, 0], [5, 0, 0]], threads=1)
    for _ in range(PER_ROUND // 100):
        world.move(ids, numpy.random.default_rng(1).normal(size=(4, 3)))
        world.step().begin.distances
        toccata.contacts_with_points(knot, box, pose_b=pose)
        toccata.check_all([ball, (box, pose)], contacts=True, penetration=True, threads=1).pairs
        toccata.Mesh(knot.vertices[:9], [[0, 1, 2]]).update(numpy.zeros((9, 3)))
    for _ in range(PER_ROUND // 500):
        scene.distance_each(many, threads=1)["gradient"], scene.edge(many[0], many[1]), scene.contacts_each(many, threads=1)
        robot.posed(many[0]), robot.with_attached("cup", ball, "link 7"), robot.link_poses_each(many, threads=1)
        deforming.advance(deforming.start + 1), deforming.impacts()
        walker.move_character(ball, state, (1, 0, -3)).contacts
        toccata.sweep(ball, toccata.RigidMotion.of(lambda s: (9 * s, 0, 0), speed=9), box)
        toccata.faces_in_ball(knot, (0, 0, 0), 1), toccata.depth_bracket(ball, box), toccata.manifolds(knot, box, pose_b=pose)
        toccata.point_cloud(knot.vertices[:5], 0.1), toccata.close_mesh(toccata.Mesh(knot.vertices, knot.faces[1:]), 1)

def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize()

some_calls()
before = resident()
for _ in range(ROUNDS):
    some_calls()
print(10 * PER_ROUND * ROUNDS, resident() - before)
"""


def test_memory_is_flat_over_a_million_calls():
    rounds = 6 if SLICE else 20
    program = CALLS.replace("PER_ROUND", str(in_slices(5000))).replace("ROUNDS", str(rounds))
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    calls, grown = map(int, run.stdout.split())
    assert calls == (30_000 if SLICE else 1_000_000) and grown < 2_000_000, (grown, run.stderr)


def test_no_call_keeps_a_reference(knot):
    ball, box, pose, matrix = toccata.Sphere(0.4), toccata.Box((1, 1, 1)), toccata.Pose((0.5, 0, 0)), numpy.eye(4)
    world, poses = toccata.World(), numpy.tile(numpy.eye(4), (4, 1, 1))
    ids = world.add_each(box, poses)
    index = toccata.SceneIndex([ball, box])
    motion = toccata.RigidMotion.straight(pose, (1, 0, 0))
    robot = toccata.Robot.generated(1)
    scene, many = toccata.RobotScene(robot, [(box, pose)]), robot.sampled(4)
    deforming, state, way = toccata.DeformingMesh(knot), toccata.SceneMoverState(pose), lambda s: (s, 0, 0)

    def fails(s):
        raise KeyError

    def failing():
        try:
            toccata.sweep(ball, toccata.RigidMotion.of(fails, speed=1), box)
        except KeyError:
            pass

    asks = [
        lambda: toccata.distance(ball, box, pose, matrix),
        lambda: toccata.distance_each(knot, box, poses_b=poses),
        lambda: toccata.overlap_each([ball, box], knot, pose),
        lambda: toccata.contacts(knot, knot),
        lambda: toccata.check_all([ball, (box, pose)]).pairs,
        lambda: (world.move(ids, poses), world.step(), world.pairs.pairs, world.boxes, world.bodies),
        lambda: (world.overlapping(ball, pose), world.nearest(ball), world[world.nearest(ball).body].shape),
        lambda: (index.overlapping(ball, only=[1, 0]), index.objects, index.cast_ray_each(poses[:, 0, :3], poses[:, 1, :3])),
        lambda: (toccata.sweep(ball, motion, box), toccata.sweep_each(ball, [motion, motion], box), motion.pieces),
        lambda: toccata.decompose(toccata.generate_mesh("torus"), max_parts=2).parts,
        lambda: toccata.overlapping_pairs(world.boxes),
        lambda: toccata.show([ball]).html,
        lambda: (scene.meets_each(many), scene.distance(many[0]), scene.distance_each(many), scene.edge_each(many, many[::-1]), scene.obstacles),
        lambda: (scene.robot, scene.contacts(many[1]), robot.posed(many[0]), robot.joints, robot.with_attached("cup", ball, "link 7", pose)),
        lambda: (deforming.advance(knot.vertices), deforming.meets(), deforming.edges),
        lambda: toccata.sweep(ball, toccata.RigidMotion.of(way, speed=1), box),
        failing,
        lambda: (index.move_character(ball, state, (1, 0, 0)).contacts, toccata.faces_in_ball(knot, (0, 0, 0), 1)),
        lambda: (toccata.depth_bracket(ball, box), toccata.manifolds(knot, box), toccata.first_contact(knot, box), toccata.overlap_volume(ball, box)),
        lambda: (toccata.mesh_faults(knot), toccata.close_mesh(knot, 1), toccata.mesh_parts(knot), toccata.point_cloud(poses[:, 0, :3], 1)),
    ]
    watched = [ball, box, pose, matrix, poses, ids, knot, world, index, motion, toccata.Distance, toccata.BodyId, ids.dtype]
    watched += [robot, scene, many, deforming, state, way, fails]
    for ask in asks:
        ask()
    gc.collect()
    before = [sys.getrefcount(thing) for thing in watched]
    for ask in itertools.chain.from_iterable(itertools.repeat(asks, max(5, in_slices(20)))):
        ask()
    gc.collect()
    after = [sys.getrefcount(thing) for thing in watched]
    assert all(abs(a - b) < 5 for a, b in zip(before, after)), list(zip(watched, before, after))
