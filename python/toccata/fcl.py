"""python-fcl's names over Toccata: `from toccata import fcl` in place of `import fcl`.

Shapes, objects, requests, results, managers and callbacks are called as there, as far as trimesh and common scripts do. The
answers are exact, so some are others: docs/guide/from-python-fcl.md lists all differences. What Toccata has no counterpart
of (Plane, OcTree, splines) raises toccata.Error.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator
from typing import Any

import numpy
from numpy.typing import NDArray

import toccata

Vector = NDArray[numpy.float64]

# What FCL tells in place of the number of a triangle where a shape has none.
NONE = -1
# What FCL calls the distance of what meets, where no depth is asked for or none is defined.
MEET = -1.0


class OBJECT_TYPE:
    OT_UNKNOWN, OT_BVH, OT_GEOM, OT_OCTREE, OT_COUNT = range(5)


class NODE_TYPE:
    BV_UNKNOWN, BV_AABB, BV_OBB, BV_RSS, BV_kIOS, BV_OBBRSS, BV_KDOP16, BV_KDOP18, BV_KDOP24 = range(9)
    GEOM_BOX, GEOM_SPHERE, GEOM_ELLIPSOID, GEOM_CAPSULE, GEOM_CONE, GEOM_CYLINDER, GEOM_CONVEX = range(9, 16)
    GEOM_PLANE, GEOM_HALFSPACE, GEOM_TRIANGLE, GEOM_OCTREE, NODE_COUNT = range(16, 21)


class CCDMotionType:
    CCDM_TRANS, CCDM_LINEAR, CCDM_SCREW, CCDM_SPLINE = range(4)


class CCDSolverType:
    CCDC_NAIVE, CCDC_CONSERVATIVE_ADVANCEMENT, CCDC_RAY_SHOOTING, CCDC_POLYNOMIAL_SOLVER = range(4)


class GJKSolverType:
    GST_LIBCCD, GST_INDEP = range(2)


class Transform:
    """A rotation, a matrix of 3×3 or a quaternion w, x, y, z, and a translation; both may be left out."""

    def __init__(self, *args: Any) -> None:
        self._rotation: Vector = numpy.eye(3)
        self._translation: Vector = numpy.zeros(3)
        if len(args) > 2:
            raise ValueError("Too many arguments to Transform().")
        if len(args) == 1 and isinstance(args[0], Transform):
            self._rotation, self._translation = args[0]._rotation, args[0]._translation
        elif len(args) == 1 and numpy.shape(args[0]) == (3,):
            self.setTranslation(args[0])
        elif args:
            self._set_any_rotation(args[0])
            if len(args) == 2:
                self.setTranslation(numpy.squeeze(numpy.asarray(args[1], dtype=float)))

    def _set_any_rotation(self, given: Any) -> None:
        if numpy.shape(given) == (3, 3):
            self.setRotation(given)
        elif numpy.shape(given) == (4,):
            self.setQuatRotation(given)
        else:
            raise ValueError("Invalid input to Transform().")

    def getRotation(self) -> Vector:
        return self._rotation.copy()

    def getTranslation(self) -> Vector:
        return self._translation.copy()

    def getQuatRotation(self) -> Vector:
        return _quaternion_of(self._rotation)

    def setRotation(self, R: Any) -> None:
        self._rotation = _array(R, (3, 3), "a rotation")

    def setTranslation(self, T: Any) -> None:
        self._translation = _array(T, (3,), "a translation")

    def setQuatRotation(self, q: Any) -> None:
        w, x, y, z = _array(q, (4,), "a quaternion")
        self._rotation = toccata.Pose.from_quaternion((x, y, z, w)).linear

    def _pose(self) -> toccata.Pose:
        return toccata.Pose(self._rotation, self._translation)


class _Numbers:
    """An array of a shape: reading it copies it, as there, so that nobody changes a number of it unseen."""

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = f"_{name}"

    def __get__(self, shape: CollisionGeometry, owner: type | None = None) -> Any:
        return getattr(shape, self._name).copy()

    def __set__(self, shape: CollisionGeometry, given: Any) -> None:
        setattr(shape, self._name, numpy.array(given, dtype=float))


class CollisionGeometry:
    """What shapes have in common. A shape may be changed; objects that have it see that."""

    _node_type: int | None = None

    def __init__(self) -> None:
        self._shape: toccata.Shape | None = None

    def __setattr__(self, name: str, value: Any) -> None:
        super().__setattr__(name, value)
        if name != "_shape":
            super().__setattr__("_shape", None)

    def getNodeType(self) -> int | None:
        return self._node_type

    def computeLocalAABB(self) -> None:
        """There is nothing to do."""

    @property
    def aabb_center(self) -> Vector:
        lower, upper = _box_of(self._made(), toccata.Pose())
        centre: Vector = (lower + upper) / 2
        return centre

    def _make(self) -> toccata.Shape:
        raise toccata.Error(f"fcl.{type(self).__name__}: there is no such shape in Toccata")

    def _made(self) -> toccata.Shape:
        if self._shape is None:
            self._shape = self._make()
        return self._shape


class TriangleP(CollisionGeometry):
    _node_type = NODE_TYPE.GEOM_TRIANGLE
    a, b, c = _Numbers(), _Numbers(), _Numbers()

    def __init__(self, a: Any, b: Any, c: Any) -> None:
        super().__init__()
        self.a, self.b, self.c = (_array(v, (3,), "a corner") for v in (a, b, c))

    def _make(self) -> toccata.Shape:
        return toccata.Triangle([self.a, self.b, self.c])


class Box(CollisionGeometry):
    """Of the sides x, y, z, around the origin."""

    _node_type = NODE_TYPE.GEOM_BOX
    side = _Numbers()

    def __init__(self, x: float, y: float, z: float) -> None:
        super().__init__()
        self.side = [x, y, z]

    def _make(self) -> toccata.Shape:
        return toccata.Box(self.side / 2)


class Sphere(CollisionGeometry):
    _node_type = NODE_TYPE.GEOM_SPHERE

    def __init__(self, radius: float) -> None:
        super().__init__()
        self.radius = radius

    def _make(self) -> toccata.Shape:
        return toccata.Sphere(self.radius)


class Ellipsoid(CollisionGeometry):
    _node_type = NODE_TYPE.GEOM_ELLIPSOID
    radii = _Numbers()

    def __init__(self, a: float, b: float, c: float) -> None:
        super().__init__()
        self.radii = [a, b, c]

    def _make(self) -> toccata.Shape:
        return toccata.Ellipsoid(self.radii)


class _AlongZ(CollisionGeometry):
    """Around the z axis, from -lz / 2 to lz / 2."""

    def __init__(self, radius: float, lz: float) -> None:
        super().__init__()
        self.radius, self.lz = radius, lz


class Capsule(_AlongZ):
    """lz is the length of the segment within."""

    _node_type = NODE_TYPE.GEOM_CAPSULE

    def _make(self) -> toccata.Shape:
        return toccata.Capsule((0, 0, -self.lz / 2), (0, 0, self.lz / 2), self.radius)


class Cone(_AlongZ):
    """Its tip is at lz / 2."""

    _node_type = NODE_TYPE.GEOM_CONE

    def _make(self) -> toccata.Shape:
        return toccata.Cone(self.radius, self.lz / 2)


class Cylinder(_AlongZ):
    _node_type = NODE_TYPE.GEOM_CYLINDER

    def _make(self) -> toccata.Shape:
        return toccata.Cylinder(self.radius, self.lz / 2)


class Convex(CollisionGeometry):
    """The convex hull of the vertices. `faces` (the number of corners of each, and their numbers) are not looked at."""

    _node_type = NODE_TYPE.GEOM_CONVEX

    def __init__(self, vertices: Any, num_faces: int, faces: Any) -> None:
        super().__init__()
        self.num_faces = num_faces
        self._vertices = numpy.array(vertices, dtype=float)

    def _make(self) -> toccata.Shape:
        return toccata.ConvexHull(self._vertices)


class Halfspace(CollisionGeometry):
    """All points x with n · x <= d."""

    _node_type = NODE_TYPE.GEOM_HALFSPACE
    n = _Numbers()

    def __init__(self, n: Any, d: float) -> None:
        super().__init__()
        self.n = _array(n, (3,), "a normal")
        self.d = d

    def _make(self) -> toccata.Shape:
        normal = self.n
        return toccata.HalfSpace(normal * (self.d / normal.dot(normal)), normal)


class Plane(CollisionGeometry):
    def __init__(self, n: Any, d: float) -> None:
        raise toccata.Error("fcl.Plane: Toccata has no plane without thickness; take a Halfspace, or two")


class OcTree(CollisionGeometry):
    def __init__(self, r: float, data: bytes) -> None:
        raise toccata.Error("fcl.OcTree: Toccata reads no octrees; take a toccata.Compound of boxes")


class BVHModel(CollisionGeometry):
    """A mesh: solid where it is closed, else a surface."""

    _node_type = NODE_TYPE.BV_OBBRSS

    def __init__(self) -> None:
        super().__init__()
        self._vertices: list[Vector] = []
        self._triangles: list[Vector] = []
        self._vertex_count = 0

    def beginModel(self, num_tris_: int = 0, num_vertices_: int = 0) -> int:
        self._vertices, self._triangles, self._vertex_count = [], [], 0
        return 0

    def addVertex(self, x: float, y: float, z: float) -> bool:
        return self._add(numpy.array([[x, y, z]], dtype=float), numpy.zeros((0, 3), dtype=numpy.int64))

    def addTriangle(self, v1: Any, v2: Any, v3: Any) -> bool:
        return self._add(numpy.array([v1, v2, v3], dtype=float), numpy.array([[0, 1, 2]]))

    def addSubModel(self, verts: Any, triangles: Any) -> bool:
        return self._add(numpy.array(verts, dtype=float), numpy.array(triangles))

    def endModel(self) -> int:
        self._made()  # what is no mesh is told here
        return 0

    def num_tries_(self) -> int:
        return sum(len(t) for t in self._triangles)

    def buildState(self) -> int:
        return 2  # processed

    def _add(self, vertices: Vector, triangles: Any) -> bool:
        self._triangles = [*self._triangles, triangles + self._vertex_count]
        self._vertices = [*self._vertices, vertices]
        self._vertex_count += len(vertices)
        return True

    def _make(self) -> toccata.Shape:
        if not self._triangles:
            raise ValueError("BVH geometry is not prepared")
        return toccata.Mesh(numpy.vstack(self._vertices), numpy.vstack(self._triangles))


class CollisionObject:
    """A shape at its place."""

    def __init__(self, geom: CollisionGeometry | None = None, tf: Transform | None = None) -> None:
        if geom is None or geom.getNodeType() is None:
            raise ValueError("a CollisionObject needs a geometry")
        self.geom = geom
        self._transform = Transform() if tf is None else Transform(tf)
        self._pose: toccata.Pose | None = None

    def getObjectType(self) -> int:
        return OBJECT_TYPE.OT_BVH if isinstance(self.geom, BVHModel) else OBJECT_TYPE.OT_GEOM

    def getNodeType(self) -> int | None:
        return self.geom.getNodeType()

    def getTranslation(self) -> Vector:
        return self._transform.getTranslation()

    def setTranslation(self, vec: Any) -> None:
        self._transform.setTranslation(vec)
        self._pose = None

    def getRotation(self) -> Vector:
        return self._transform.getRotation()

    def setRotation(self, mat: Any) -> None:
        self._transform.setRotation(mat)
        self._pose = None

    def getQuatRotation(self) -> Vector:
        return self._transform.getQuatRotation()

    def setQuatRotation(self, q: Any) -> None:
        self._transform.setQuatRotation(q)
        self._pose = None

    def getTransform(self) -> Transform:
        return Transform(self._transform)

    def setTransform(self, tf: Transform) -> None:
        self._transform = Transform(tf)
        self._pose = None

    def isOccupied(self) -> bool:
        return True

    def isFree(self) -> bool:
        return False

    def isUncertain(self) -> bool:
        return False

    def _posed(self) -> tuple[toccata.Shape, toccata.Pose]:
        if self._pose is None:
            self._pose = self._transform._pose()
        return self.geom._made(), self._pose


class Contact:
    def __init__(self) -> None:
        self.o1: Any = None
        self.o2: Any = None
        self.b1 = 0
        self.b2 = 0
        self.normal: Any = numpy.zeros(3)  # unit, from o1 to o2
        self.pos: Any = numpy.zeros(3)
        self.penetration_depth = 0.0


class CostSource:
    def __init__(self) -> None:
        self.aabb_min: Any = numpy.zeros(3)
        self.aabb_max: Any = numpy.zeros(3)
        self.cost_density = 0.0
        self.total_cost = 0.0


class CollisionRequest:
    """Of it, num_max_contacts and enable_contact count."""

    def __init__(
        self,
        num_max_contacts: int = 1,
        enable_contact: bool = False,
        num_max_cost_sources: int = 1,
        enable_cost: bool = False,
        use_approximate_cost: bool = True,
        gjk_solver_type: int = GJKSolverType.GST_LIBCCD,
    ) -> None:
        self.num_max_contacts = num_max_contacts
        self.enable_contact = enable_contact
        self.num_max_cost_sources = num_max_cost_sources
        self.enable_cost = enable_cost
        self.use_approximate_cost = use_approximate_cost
        self.gjk_solver_type = gjk_solver_type


class CollisionResult:
    def __init__(self, is_collision: bool = False) -> None:
        self.is_collision = False
        self.contacts: list[Contact] = []
        self.cost_sources: list[CostSource] = []


class ContinuousCollisionRequest:
    """Of it, ccd_motion_type counts: answers need no tolerance and no number of iterations."""

    def __init__(
        self,
        num_max_iterations: int = 10,
        toc_err: float = 0.0001,
        ccd_motion_type: int = CCDMotionType.CCDM_TRANS,
        gjk_solver_type: int = GJKSolverType.GST_LIBCCD,
        ccd_solver_type: int = CCDSolverType.CCDC_CONSERVATIVE_ADVANCEMENT,
    ) -> None:
        self.num_max_iterations = num_max_iterations
        self.toc_err = toc_err
        self.ccd_motion_type = ccd_motion_type
        self.gjk_solver_type = gjk_solver_type
        self.ccd_solver_type = ccd_solver_type


class ContinuousCollisionResult:
    def __init__(self, is_collide: bool = False, time_of_contact: float = 1.0) -> None:
        self.is_collide = is_collide
        self.time_of_contact = time_of_contact


class DistanceRequest:
    def __init__(
        self,
        enable_nearest_points: bool = False,
        enable_signed_distance: bool = False,
        gjk_solver_type: int = GJKSolverType.GST_LIBCCD,
    ) -> None:
        self.enable_nearest_points = enable_nearest_points
        self.enable_signed_distance = enable_signed_distance
        self.gjk_solver_type = gjk_solver_type


class DistanceResult:
    def __init__(self, min_distance_: float = sys.float_info.max) -> None:
        self.min_distance = min_distance_
        self.nearest_points: list[Any] = [None, None]
        self.o1: Any = None
        self.o2: Any = None
        self.b1 = NONE
        self.b2 = NONE


class CollisionData:
    def __init__(self, request: CollisionRequest | None = None, result: CollisionResult | None = None) -> None:
        self.request = CollisionRequest() if request is None else request
        self.result = CollisionResult() if result is None else result
        self.done = False


class DistanceData:
    def __init__(self, request: DistanceRequest | None = None, result: DistanceResult | None = None) -> None:
        self.request = DistanceRequest() if request is None else request
        self.result = DistanceResult() if result is None else result
        self.done = False


# Questions.


def collide(o1: CollisionObject, o2: CollisionObject, request: Any = None, result: Any = None) -> int:
    """How many contacts there are, at most as many as were asked for; 0 exactly when the two are apart."""
    request = CollisionRequest() if request is None else request
    result = CollisionResult() if result is None else result
    (a, pose_a), (b, pose_b) = o1._posed(), o2._posed()
    if not toccata.overlap(a, b, pose_a, pose_b):
        return 0
    result.is_collision = True
    contacts = _contacts(o1, o2, request) if request.enable_contact or request.num_max_contacts > 1 else [_contact(o1, o2)]
    result.contacts.extend(contacts)
    return len(contacts)


def distance(o1: CollisionObject, o2: CollisionObject, request: Any = None, result: Any = None) -> float:
    """How far apart the two are. Where they meet: -1, or, with enable_signed_distance, minus how deep they overlap."""
    request = DistanceRequest() if request is None else request
    result = DistanceResult() if result is None else result
    (a, pose_a), (b, pose_b) = o1._posed(), o2._posed()
    found = toccata.distance(a, b, pose_a, pose_b)
    told, points = found.upper, [found.on_a, found.on_b]
    if told == 0:
        told, depth = MEET, _depth_of(o1, o2) if request.enable_signed_distance else None
        if depth is not None:
            told, points = -depth.upper, [depth.on_a, depth.on_b]
    if told < result.min_distance:
        result.min_distance, result.nearest_points = told, points
        result.o1, result.o2 = o1.geom, o2.geom
        result.b1, result.b2 = _number(a, found.face_a), _number(b, found.face_b)
    return told


def continuousCollide(
    o1: CollisionObject, tf1_end: Transform, o2: CollisionObject, tf2_end: Transform, request: Any = None, result: Any = None
) -> float:
    """The part of the way, from 0 to 1, before which nothing is met: certified. 1 where nothing is met, which is proved."""
    request = ContinuousCollisionRequest() if request is None else request
    result = ContinuousCollisionResult() if result is None else result
    (a, pose_a), (b, pose_b) = o1._posed(), o2._posed()
    kind = request.ccd_motion_type
    hit = toccata.sweep(a, _motion(pose_a, tf1_end, kind), b, _motion(pose_b, tf2_end, kind))
    time = hit.lower if hit else 1.0
    result.is_collide = result.is_collide or hit is not None
    result.time_of_contact = min(time, result.time_of_contact)
    return time


def defaultCollisionCallback(o1: CollisionObject, o2: CollisionObject, cdata: CollisionData) -> bool:
    if not cdata.done:
        collide(o1, o2, cdata.request, cdata.result)
        cdata.done = cdata.result.is_collision and len(cdata.result.contacts) > cdata.request.num_max_contacts
    return cdata.done


def defaultDistanceCallback(o1: CollisionObject, o2: CollisionObject, cdata: DistanceData) -> tuple[bool, float]:
    if cdata.done:
        return True, cdata.result.min_distance
    distance(o1, o2, cdata.request, cdata.result)
    return cdata.result.min_distance <= 0, cdata.result.min_distance


class DynamicAABBTreeCollisionManager:
    """Objects, and which pairs of them meet. `update` need not be called: what moved is looked at when asked."""

    def __init__(self) -> None:
        self._objects: dict[int, tuple[CollisionObject, toccata.BodyId]] = {}  # by id(object)
        self._by_index: dict[int, CollisionObject] = {}
        self._seen: dict[int, tuple[toccata.Shape, toccata.Pose]] = {}  # what the world was told
        self._world = toccata.World()
        # How FCL balances its tree; not looked at here.
        self.max_tree_nonbalanced_level = self.tree_incremental_balance_pass = 10
        self.tree_topdown_balance_threshold, self.tree_topdown_level, self.tree_init_level = 2, 0, 0
        self.octree_as_geometry_collide = self.octree_as_geometry_distance = False

    def registerObjects(self, other_objs: Iterable[CollisionObject]) -> None:
        for obj in other_objs:
            self.registerObject(obj)

    def registerObject(self, obj: CollisionObject) -> None:
        if id(obj) in self._objects:
            return
        shape, pose = obj._posed()
        body = self._world.add(shape, pose)
        self._objects[id(obj)] = (obj, body)
        self._by_index[body.index] = obj
        self._seen[id(obj)] = (shape, pose)

    def unregisterObject(self, obj: CollisionObject) -> None:
        if id(obj) in self._objects:
            _, body = self._objects.pop(id(obj))
            self._world.remove(body)
            del self._by_index[body.index], self._seen[id(obj)]

    def setup(self) -> None:
        """There is nothing to do."""

    def update(self, arg: Any = None) -> None:
        """There is nothing to do."""

    def getObjects(self) -> list[CollisionObject]:
        return [obj for obj, _ in self._objects.values()]

    def clear(self) -> None:
        for obj in self.getObjects():
            self.unregisterObject(obj)

    def empty(self) -> bool:
        return not self._objects

    def size(self) -> int:
        return len(self._objects)

    def collide(self, *args: Any) -> None:
        """(data, callback), (object, data, callback), or (manager, data, callback).

        The callback gets every pair whose boxes overlap, until it returns True; the default one only those that meet.
        """
        with_whom, data, callback = args if len(args) == 3 else (None, *args)
        meeting = callback is defaultCollisionCallback
        for o1, o2 in self._meeting(with_whom) if meeting else self._near(with_whom):
            if callback(o1, o2, data):
                return

    def distance(self, *args: Any) -> None:
        """As collide; the callback returns whether it is done, and how far apart pairs may be that are of interest."""
        with_whom, data, callback = args if len(args) == 3 else (None, *args)
        limit = numpy.inf
        for gap, o1, o2 in self._by_gap(with_whom):
            if gap > limit:
                return
            done, limit = callback(o1, o2, data)
            if done:
                return

    def _current(self) -> toccata.World:
        moved = []
        for key, (obj, body) in self._objects.items():
            shape, pose = obj._posed()
            seen_shape, seen_pose = self._seen[key]
            if shape is not seen_shape:
                self._world.replace(body, toccata.Body(shape, pose))
            elif pose is not seen_pose:
                moved.append((body, pose))
            self._seen[key] = (shape, pose)
        if moved:
            self._world.move([body for body, _ in moved], [pose for _, pose in moved])
        return self._world

    def _meeting(self, with_whom: Any) -> Iterator[tuple[CollisionObject, CollisionObject]]:
        world = self._current()
        if isinstance(with_whom, CollisionObject):
            for index in world.overlapping(*with_whom._posed())["index"].tolist():
                yield self._by_index[index], with_whom
        elif isinstance(with_whom, DynamicAABBTreeCollisionManager):
            for other in with_whom.getObjects():
                yield from self._meeting(other)
        else:
            world.step()
            pairs = world.pairs.pairs
            for a, b in zip(pairs["a"]["index"].tolist(), pairs["b"]["index"].tolist()):
                yield self._by_index[a], self._by_index[b]

    def _boxes(self) -> tuple[Vector, list[CollisionObject]]:
        boxes = self._current().boxes
        order = sorted(self._by_index)
        return boxes[order], [self._by_index[index] for index in order]

    def _sides(self, with_whom: Any) -> tuple[Vector, list[CollisionObject], Vector, list[CollisionObject]]:
        """The boxes and objects here, and those of whom they are compared with."""
        boxes, objects = self._boxes()
        if isinstance(with_whom, CollisionObject):
            return boxes, objects, _box_of(*with_whom._posed())[None], [with_whom]
        return (boxes, objects, *with_whom._boxes())

    def _near(self, with_whom: Any) -> Iterator[tuple[CollisionObject, CollisionObject]]:
        if with_whom is None:
            boxes, objects = self._boxes()
            for i, j in toccata.overlapping_pairs(boxes).tolist():
                yield objects[i], objects[j]
            return
        boxes, objects, other_boxes, others = self._sides(with_whom)
        for i, j in toccata.overlapping_pairs(numpy.concatenate([boxes, other_boxes])).tolist():
            if i < len(objects) <= j:
                yield objects[i], others[j - len(objects)]

    def _by_gap(self, with_whom: Any) -> list[tuple[float, CollisionObject, CollisionObject]]:
        """All pairs, those first whose boxes are the nearest."""
        if with_whom is None:
            boxes, objects = self._boxes()
            i, j = numpy.triu_indices(len(objects), 1)
            other_boxes, others = boxes, objects
        else:
            boxes, objects, other_boxes, others = self._sides(with_whom)
            i, j = (index.ravel() for index in numpy.indices((len(objects), len(others))))
        apart = numpy.maximum(boxes[i, 0] - other_boxes[j, 1], other_boxes[j, 0] - boxes[i, 1])
        # Rounded down by more than all roundings are.
        gaps = numpy.linalg.norm(numpy.maximum(apart, 0), axis=-1) * (1 - 1e-14)
        return [(gaps[k], objects[i[k]], others[j[k]]) for k in numpy.argsort(gaps, kind="stable")]


# What FCL and Toccata tell each in its way.


def _array(given: Any, shape: tuple[int, ...], what: str) -> Vector:
    array: Vector = numpy.array(given, dtype=float)
    if array.shape != shape:
        raise ValueError(f"{what} has the shape {shape}, and what is given {array.shape}")
    return array


def _quaternion_of(m: Vector) -> Vector:
    """w, x, y, z of a rotation; the largest of the four is the root, so that nothing is divided by a small number."""
    xx, yy, zz = m[0, 0], m[1, 1], m[2, 2]
    squares = numpy.array([1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz])
    sums = numpy.array(
        [
            [squares[0], m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]],
            [m[2, 1] - m[1, 2], squares[1], m[0, 1] + m[1, 0], m[0, 2] + m[2, 0]],
            [m[0, 2] - m[2, 0], m[0, 1] + m[1, 0], squares[2], m[1, 2] + m[2, 1]],
            [m[1, 0] - m[0, 1], m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], squares[3]],
        ]
    )
    row: Vector = sums[int(numpy.argmax(squares))]
    return row / numpy.linalg.norm(row)


def _box_of(shape: toccata.Shape, pose: toccata.Pose) -> Vector:
    world = toccata.World()
    world.add(shape, pose)
    box: Vector = world.boxes[0]
    return box


def _number(shape: toccata.Shape, face: int) -> int:
    return face if isinstance(shape, toccata.Mesh) else NONE


def _depth_of(o1: CollisionObject, o2: CollisionObject) -> toccata.Penetration | None:
    """None where one of the two is a surface."""
    (a, pose_a), (b, pose_b) = o1._posed(), o2._posed()
    try:
        return toccata.penetration(a, b, pose_a, pose_b)
    except toccata.Error:
        return None


def _contact(o1: CollisionObject, o2: CollisionObject, b1: int = NONE, b2: int = NONE) -> Contact:
    contact = Contact()
    contact.o1, contact.o2, contact.b1, contact.b2 = o1.geom, o2.geom, b1, b2
    return contact


def _contacts(o1: CollisionObject, o2: CollisionObject, request: Any) -> list[Contact]:
    """Of two that meet: where a mesh is involved its triangles, else the points of the manifold."""
    (a, pose_a), (b, pose_b) = o1._posed(), o2._posed()
    most = request.num_max_contacts
    if not isinstance(a, toccata.Mesh) and not isinstance(b, toccata.Mesh):
        found = _manifold_contacts(o1, o2, most)
        if found:
            return found
    depth = _depth_of(o1, o2)
    middle = toccata.distance(a, b, pose_a, pose_b).on_a if depth is None else (depth.on_a + depth.on_b) / 2
    contacts = []
    for row in toccata.contacts_with_points(a, b, pose_a, pose_b)[:most]:
        contact = _contact(o1, o2, _number(a, int(row["face_a"])), _number(b, int(row["face_b"])))
        count = int(row["point_count"])
        contact.pos = row["points"][:count].mean(axis=0) if count else middle
        contacts.append(contact)
    if not contacts:  # one lies within the other
        contacts = [_contact(o1, o2)]
        contacts[0].pos = middle
    for contact in contacts:
        if depth is not None:
            contact.normal, contact.penetration_depth = depth.direction, depth.upper
    return contacts


def _manifold_contacts(o1: CollisionObject, o2: CollisionObject, most: int) -> list[Contact]:
    (a, pose_a), (b, pose_b) = o1._posed(), o2._posed()
    try:
        manifold = toccata.manifold(a, b, pose_a, pose_b)
    except toccata.Error:
        return []
    contacts = []
    for position, depth in list(zip(manifold.positions, manifold.depths.tolist()))[:most]:
        contact = _contact(o1, o2)
        contact.pos, contact.normal, contact.penetration_depth = position, manifold.normal, depth
        contacts.append(contact)
    return contacts


def _motion(start: toccata.Pose, end: Transform, kind: int) -> toccata.RigidMotion:
    if kind == CCDMotionType.CCDM_TRANS:
        return toccata.RigidMotion.straight(start, end.getTranslation() - start.offset)
    if kind == CCDMotionType.CCDM_LINEAR:
        return toccata.RigidMotion.between(start, end._pose())
    if kind == CCDMotionType.CCDM_SCREW:
        return toccata.RigidMotion.screw(start, end._pose())
    raise toccata.Error("fcl.continuousCollide: of the motions, CCDM_TRANS, CCDM_LINEAR and CCDM_SCREW are there")


Callback = Callable[[CollisionObject, CollisionObject, Any], Any]
__version__ = toccata.__version__
