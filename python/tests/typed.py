"""Checked by mypy --strict and never run: what the stubs say of the usual calls."""

import pathlib

import numpy
from numpy.typing import NDArray

import toccata
from toccata import Box, Distance, Mesh, Pose, Shape, Sphere, fcl
from toccata.trimesh import CollisionManager

vertices: NDArray[numpy.float64] = numpy.zeros((3, 3))
mesh: Mesh = Mesh(vertices, [[0, 1, 2]])
shapes: list[Shape] = [mesh, Sphere(1), Box((1, 1, 1)), toccata.Compound([mesh, (mesh, (1, 0, 0))])]
pose: Pose = Pose(numpy.eye(4)) @ Pose.rotation((0, 0, 1), 90)
found: Distance = toccata.distance(mesh, shapes[0], pose_b=pose)
number: float = found.upper
point: NDArray[numpy.float64] = found.on_a
exact: bool = found.status is toccata.Status.exact
yes: bool = toccata.overlap(mesh, mesh, (1, 2, 3), (numpy.eye(3), [1, 2, 3]))
each: NDArray[numpy.bool_] = toccata.overlap_each(mesh, mesh, poses_b=numpy.zeros((5, 4, 4)), threads=2)
answers: NDArray[numpy.void] = toccata.distance_each(mesh, mesh, [pose, pose])
answers = toccata.distance_each(mesh, mesh, [(numpy.eye(3), (1, 2, 3)), (numpy.eye(3), (1, 2, 4))], (numpy.zeros((2, 3, 3)), numpy.zeros((2, 3))))
uppers = answers["upper"]
maybe: Distance | None = toccata.distance_within(mesh, mesh, 0.5)
kind: toccata.RelationKind = toccata.relation(mesh, mesh).kind
try:
    toccata.load_mesh("mesh.obj")
    toccata.load_mesh(pathlib.Path("mesh.obj")).write(pathlib.Path("mesh.ply"))
    toccata.Robot.from_urdf(pathlib.Path("arm.urdf"), packages=[pathlib.Path("robots"), "others"])
except toccata.Error as error:
    words: str = str(error)
version: str = toccata.__version__

index: toccata.SceneIndex = toccata.SceneIndex([mesh, (mesh, pose), toccata.SceneInstance(mesh, name="ball")])
first: toccata.SceneRayHit | None = index.cast_ray((0, 0, 9), (0, 0, -9))
if first is not None:
    which: int = first.object
rows: NDArray[numpy.void] = index.nearest_each(mesh, [pose, pose], only=[True, False, True])
world: toccata.World = toccata.World(distance=True)
body: toccata.BodyId = world.add(mesh, pose, type=toccata.BodyType.static_body)
step: toccata.WorldStep = world.step()
begun: NDArray[numpy.void] = step.begin.pairs
world.move(body, pose)
world.move(world.add_each([mesh, mesh]), numpy.zeros((2, 4, 4)))
motion: toccata.RigidMotion = toccata.RigidMotion.between(pose, (1, 2, 3))
swept: toccata.ShapeHit | None = toccata.sweep(mesh, motion, mesh, pose)
checked: toccata.CheckAnswer = toccata.check_all([mesh, mesh], clearance=0.1)
parts: list[toccata.ConvexPart] = toccata.decompose(mesh).parts
pairs: NDArray[numpy.uint32] = toccata.overlapping_pairs(numpy.zeros((4, 2, 3)))
page: toccata.Page = toccata.show([mesh], title="A mesh")
robot: toccata.Robot = toccata.Robot({"a": [mesh], "b": [(mesh, pose)]}, [toccata.RobotJoint("j", toccata.RobotJointKind.continuous, "a", "b", axis=(0, 0, 1))])
place: toccata.RobotScene = toccata.RobotScene(robot, [mesh, toccata.point_cloud(vertices, 0.1)], allowed=robot.allowed_pairs(10))
collides: bool = place.meets([0.5])
meets: NDArray[numpy.bool_] = place.meets_each(robot.sampled(5), threads=2)
touching: list[toccata.RobotContact] = place.contacts([0.5])
near: toccata.RobotDistance | None = place.distance(robot.rest(), 0.5)
if near is not None:
    gradient: NDArray[numpy.float64] = near.gradient
    called: tuple[str, str] = place.names(near)
way: toccata.RobotEdge = place.edge([0], [1])
links: NDArray[numpy.float64] = robot.link_poses_each([[0.0], [1.0]])
deforming: toccata.DeformingMesh = toccata.DeformingMesh(mesh, vertices)
impact: toccata.MeshImpact | None = deforming.first_impact(toccata.DeformingMesh(mesh))
part, ended_by = deforming.free_step()
by_function: toccata.RigidMotion = toccata.RigidMotion.of(lambda s: (s, 0, 0), speed=1)
walked: toccata.SceneMoverStep = index.move_character(Sphere(1), toccata.SceneMoverState(pose), (1, 0, 0))
ridden: toccata.BodyMoverStep = world.move_character(Sphere(1), toccata.BodyMoverState(), (1, 0, 0), moved=[(body, pose)])
bracket: toccata.DepthBracket = toccata.depth_bracket(mesh, mesh, precision=0.1)
patches: list[toccata.ModelManifold] = toccata.manifolds(mesh, mesh)
some: NDArray[numpy.void] = toccata.faces_in_box(mesh, (0, 0, 0), (1, 1, 1))
objects: list[toccata.SceneInstance] = toccata.load_scene("scene.json")
closed, repair = toccata.close_mesh(mesh, 0.1)
manager = CollisionManager()
manager.add_object("mesh", mesh)
hit: bool = fcl.collide(fcl.CollisionObject(fcl.Box(1, 1, 1)), fcl.CollisionObject(fcl.Sphere(1))) > 0

toccata.distance(mesh, 5)  # type: ignore[arg-type]
toccata.overlap(mesh)  # type: ignore[call-arg]
found.upper = 5  # type: ignore[misc]
