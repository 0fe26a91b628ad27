"""trimesh's collision manager, answered exactly: `from toccata import trimesh as collision` for `from trimesh import collision`.

The classes and functions have trimesh's names, arguments and results. Where the answers are others, it is because they are
exact: docs/guide/from-trimesh.md lists all differences. trimesh itself is not needed; a mesh is whatever has `vertices` and
`faces`, or a toccata.Shape.
"""

from __future__ import annotations

import math
import weakref
from collections.abc import Hashable, Iterable
from typing import Any

import numpy
from numpy.typing import NDArray

import toccata

__all__ = ["CollisionManager", "ContactData", "DistanceData", "scene_to_collision"]

Name = Hashable
# What the object is called that a question brings along.
EXTERNAL = "__external"
# Of equal meshes one shape is made, as long as somebody uses it.
_shapes: weakref.WeakValueDictionary[tuple[Any, Any], toccata.Shape] = weakref.WeakValueDictionary()


class ContactData:
    """Two faces that meet, one of each of two meshes."""

    def __init__(self, names: tuple[Name, Name], faces: tuple[int, int], point: Any, normal: Any, depth: float) -> None:
        self.names = set(names)
        self._faces = dict(zip(names, faces))
        self._point, self._normal, self._depth = point, normal, depth

    @property
    def normal(self) -> NDArray[numpy.float64]:
        """Unit, shape (3,), from the first of the two meshes to the second: the shortest way to part them."""
        return numpy.asarray(self._normal)

    @property
    def point(self) -> NDArray[numpy.float64]:
        """The middle of what the two faces have in common, shape (3,), in the world."""
        return numpy.asarray(self._point)

    @property
    def depth(self) -> float:
        """How deep the two meshes overlap: moved so far along the normal they do not. 0 where one is a surface."""
        return self._depth

    def index(self, name: Name) -> int:
        """The face of the mesh of that name."""
        return self._faces[name]


class DistanceData:
    """The nearest points of two meshes, or how deep they overlap."""

    def __init__(self, names: tuple[Name, Name], distance: float, points: tuple[Any, Any], faces: tuple[int, int]) -> None:
        self.names = set(names)
        self._distance = distance
        self._points = dict(zip(names, points))
        self._faces = dict(zip(names, faces))

    @property
    def distance(self) -> float:
        """How far apart they are; negative, by how deep they overlap."""
        return self._distance

    def index(self, name: Name) -> int:
        """The nearest face of the mesh of that name."""
        return self._faces[name]

    def point(self, name: Name) -> NDArray[numpy.float64]:
        """The nearest point of the mesh of that name, shape (3,)."""
        return numpy.asarray(self._points[name])


class _Part:
    """A named mesh at its place."""

    def __init__(self, name: Name, shape: toccata.Shape, pose: toccata.Pose) -> None:
        self.name, self.shape, self.pose = name, shape, pose


class CollisionManager:
    """Named meshes at their places, and which of them collide.

    A closed mesh is the solid that it encloses, so one within another collides with it; an open one is a surface.
    Transforms are used as given, in doubles, and may scale. Touching counts.
    """

    def __init__(self) -> None:
        self._world = toccata.World()  # which alone knows where they are
        self._bodies: dict[Name, toccata.BodyId] = {}
        self._shapes: dict[Name, toccata.Shape] = {}
        self._names: dict[int, Name] = {}  # by the index of the body

    def add_object(self, name: Name, mesh: Any, transform: Any = None) -> toccata.BodyId:
        """Adds a mesh under a name, in place of one that had it. The transform is (4, 4); None: the identity."""
        shape, pose = shape_of(mesh), _pose_of(transform)
        if name in self._bodies:
            self.remove_object(name)
        body = self._world.add(shape, pose)
        self._bodies[name], self._shapes[name], self._names[body.index] = body, shape, name
        return body

    def remove_object(self, name: Name) -> None:
        """Raises ValueError when there is none of that name."""
        body = self._body(name)
        self._world.remove(body)
        del self._bodies[name], self._shapes[name], self._names[body.index]

    def set_transform(self, name: Name, transform: Any) -> None:
        """Raises ValueError when there is none of that name, and for what is no transform."""
        body = self._bodies.get(name)
        if body is None:
            raise ValueError(f"{name} not in collision manager!")
        self._world.place(body, transform)

    def in_collision_single(
        self, mesh: Any, transform: Any = None, return_names: bool = False, return_data: bool = False
    ) -> Any:
        """Whether a mesh meets any; with return_names also the set of their names, with return_data the contacts."""
        part = _Part(EXTERNAL, shape_of(mesh), _pose_of(transform))
        found = [self._names[index] for index in self._world.overlapping(part.shape, part.pose)["index"].tolist()]
        contacts = lambda: _contacts([self._part(name) for name in found], [part])  # noqa: E731
        return _told(bool(found), set(found), contacts, return_names, return_data)

    def in_collision_internal(self, return_names: bool = False, return_data: bool = False) -> Any:
        """Whether any two meet; with return_names also the set of sorted pairs of names, with return_data the contacts."""
        if not (return_names or return_data):
            return self._world.any_overlap()
        pairs = self._colliding()
        contacts = lambda: [c for a, b in pairs for c in _contacts([self._part(a)], [self._part(b)])]  # noqa: E731
        return _told(bool(pairs), {_sorted(pair) for pair in pairs}, contacts, return_names, return_data)

    def in_collision_other(
        self, other_manager: CollisionManager, return_names: bool = False, return_data: bool = False
    ) -> Any:
        """Whether any meets any of another manager; pairs of names have this one's first."""
        pairs = self._colliding_with(other_manager)
        contacts = lambda: [  # noqa: E731
            c for a, b in pairs for c in _contacts([self._part(a)], [other_manager._part(b)])
        ]
        return _told(bool(pairs), set(pairs), contacts, return_names, return_data)

    def min_distance_single(
        self, mesh: Any, transform: Any = None, return_name: bool = False, return_data: bool = False
    ) -> Any:
        """How far a mesh is from the nearest; negative, by how deep it overlaps, where it meets one."""
        nearest = self._nearest_to([_Part(EXTERNAL, shape_of(mesh), _pose_of(transform))])
        return _told_distance(nearest, nearest.names[0], return_name, return_data)

    def min_distance_internal(
        self, name: Name | None = None, return_names: bool = False, return_data: bool = False
    ) -> Any:
        """How far the nearest two are apart; with a name, that one from the nearest of the others."""
        nearest = self._nearest_within(list(self._bodies) if name is None else [name], name is None)
        names = None if nearest.names == (None, None) else _sorted(nearest.names)
        return _told_distance(nearest, names, return_names, return_data)

    def min_distance_other(
        self, other_manager: CollisionManager, return_names: bool = False, return_data: bool = False
    ) -> Any:
        """How far the nearest two are apart of which one is of another manager; names have this one's first."""
        nearest = self._nearest_to(other_manager._part(name) for name in other_manager._bodies)
        names = None if nearest.names == (None, None) else nearest.names
        return _told_distance(nearest, names, return_names, return_data)

    def _body(self, name: Name) -> toccata.BodyId:
        body = self._bodies.get(name)
        if body is None:
            raise ValueError(f"{name} not in collision manager!")
        return body

    def _part(self, name: Name) -> _Part:
        return _Part(name, self._shapes[name], self._world[self._bodies[name]].pose)

    def _colliding(self) -> list[tuple[Name, Name]]:
        self._world.step()
        pairs = self._world.pairs.pairs
        names = self._names
        return [(names[a], names[b]) for a, b in zip(pairs["a"]["index"].tolist(), pairs["b"]["index"].tolist())]

    def _colliding_with(self, other: CollisionManager) -> list[tuple[Name, Name]]:
        names = list(other._bodies)
        if not names or not self._bodies:
            return []
        poses = other._world.poses[[body.index for body in other._bodies.values()]]
        rows = self._world.overlapping_each(list(other._shapes.values()), poses)
        bodies = rows["body"]["index"].tolist()
        return [(self._names[body], names[i]) for i, body in zip(rows["query"].tolist(), bodies)]

    def _nearest_to(self, others: Iterable[_Part]) -> _Nearest:
        """Of all pairs of one that is here and one of the others: the deepest, or the nearest."""
        best = _Nearest()
        for other in others:
            best = self._nearer(best, other, None)
        return best

    def _nearest_within(self, names: list[Name], each_pair_once: bool) -> _Nearest:
        best = _Nearest()
        done: list[toccata.BodyId] = []
        for name in names:
            done.append(self._body(name))
            best = self._nearer(best, self._part(name), toccata.BodyFilter(except_bodies=done))
            if not each_pair_once:
                done.clear()
        return best

    def _nearer(self, best: _Nearest, other: _Part, only: toccata.BodyFilter | None) -> _Nearest:
        overlapping = self._world.overlapping(other.shape, other.pose, only=only)["index"].tolist()
        for index in overlapping:
            found = _deep(self._part(self._names[index]), other)
            if found.distance < best.distance:
                best = found
        if overlapping or best.distance <= 0:
            return best
        near = self._world.nearest(other.shape, other.pose, best.distance, only=only)
        if near is None or near.upper >= best.distance:
            return best
        name = self._names[near.body.index]
        return _Nearest(near.upper, (name, other.name), (near.on_b, near.on_a), (near.face_b, near.face_a))


class _Nearest:
    def __init__(
        self,
        distance: float = math.inf,
        names: tuple[Name, Name] = (None, None),
        points: tuple[Any, Any] = (None, None),
        faces: tuple[int, int] = (-1, -1),
    ) -> None:
        self.distance, self.names, self.points, self.faces = distance, names, points, faces


def scene_to_collision(scene: Any) -> tuple[CollisionManager, dict[Any, toccata.BodyId]]:
    """A manager of all meshes of a trimesh.Scene, and what `add_object` returned, by the names of its nodes."""
    manager = CollisionManager()
    objects = {}
    for node in scene.graph.nodes_geometry:
        transform, geometry = scene.graph[node]
        objects[node] = manager.add_object(node, scene.geometry[geometry], transform)
    return manager, objects


def shape_of(mesh: Any) -> toccata.Shape:
    """The shape of a mesh: the same one for meshes that are equal, while it is used."""
    if isinstance(mesh, toccata.Shape):
        return mesh
    if not hasattr(mesh, "vertices") or not hasattr(mesh, "faces"):
        scene = "; scene_to_collision takes a Scene" if hasattr(mesh, "geometry") else ""
        raise toccata.Error(f"a mesh is needed, with vertices and faces, and what is given is a {type(mesh).__name__}{scene}")
    vertices, faces = mesh.vertices, mesh.faces
    try:
        key = (hash(vertices), hash(faces))  # trimesh's arrays have a hash of what they hold
    except TypeError:
        return toccata.Mesh(vertices, faces)
    known = _shapes.get(key)
    if isinstance(known, toccata.Mesh) and numpy.array_equal(known.vertices, vertices) and numpy.array_equal(known.faces, faces):
        return known
    made = toccata.Mesh(vertices, faces)
    _shapes[key] = made
    return made


def _pose_of(transform: Any) -> toccata.Pose:
    if transform is None:
        return toccata.Pose()
    # An array tells its shape in less time than numpy.shape takes.
    if getattr(transform, "shape", None) != (4, 4) and numpy.shape(transform) != (4, 4):
        raise ValueError("transform must be (4,4)!")
    return toccata.Pose(transform)


def _sorted(names: tuple[Any, Any]) -> tuple[Name, Name]:
    return names if names[0] <= names[1] else (names[1], names[0])


def _told(result: bool, names: set[Any], contacts: Any, return_names: bool, return_data: bool) -> Any:
    told = (result, *((names,) if return_names else ()), *((contacts(),) if return_data else ()))
    return told if len(told) > 1 else result


def _told_distance(nearest: _Nearest, name: Any, return_name: bool, return_data: bool) -> Any:
    told: tuple[Any, ...] = (nearest.distance,)
    if return_name:
        told += (name,)
    if return_data:
        told += (DistanceData(nearest.names, nearest.distance, nearest.points, nearest.faces),)
    return told if len(told) > 1 else nearest.distance


def _deep(a: _Part, b: _Part) -> _Nearest:
    """Of two that meet: minus how deep they overlap, or 0 where one is a surface."""
    faces = toccata.distance(a.shape, b.shape, a.pose, b.pose)
    try:
        depth = toccata.penetration(a.shape, b.shape, a.pose, b.pose)
    except toccata.Error:
        return _Nearest(0.0, (a.name, b.name), (faces.on_a, faces.on_b), (faces.face_a, faces.face_b))
    return _Nearest(-depth.upper, (a.name, b.name), (depth.on_a, depth.on_b), (faces.face_a, faces.face_b))


def _contacts(first: list[_Part], second: list[_Part]) -> list[ContactData]:
    """The contacts of each of the first with each of the second, all of which meet."""
    contacts = []
    for a in first:
        for b in second:
            deep = _deep(a, b)
            normal = _normal(a, b, deep)
            rows = toccata.contacts_with_points(a.shape, b.shape, a.pose, b.pose)
            names, depth = (a.name, b.name), -deep.distance
            for row in rows:
                count = int(row["point_count"])
                point = row["points"][:count].mean(axis=0) if count else deep.points[0]
                contacts.append(ContactData(names, (int(row["face_a"]), int(row["face_b"])), point, normal, depth))
            if not len(rows):  # one lies within the other
                contacts.append(ContactData(names, deep.faces, (deep.points[0] + deep.points[1]) / 2, normal, depth))
    return contacts


def _normal(a: _Part, b: _Part, deep: _Nearest) -> Any:
    """From the first to the second."""
    way = numpy.subtract(deep.points[0], deep.points[1])
    length = float(numpy.linalg.norm(way))
    if deep.distance < 0 and length > 0:
        return way / length
    try:
        regions = toccata.contact_regions(a.shape, b.shape, a.pose, b.pose)
    except toccata.Error:  # no meshes
        return numpy.zeros(3)
    return regions[0]["normal"] if len(regions) else numpy.zeros(3)
