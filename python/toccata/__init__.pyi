"""
Exact collision detection: do these shapes touch, how far apart are they, how deep do they overlap, what is hit first?

Shapes are made once and asked about under any pose; `overlap(a, b, pose_b=matrix)` answers one question, `overlap_each(a,
b, poses_b=matrices)` many, on all cores. Numbers have no unit: lengths come back in that of what was given. Every yes or no
is exact, and every length an interval that contains the exact one. What is asked wrongly raises `toccata.Error`, a
ValueError that says what to do. Many posed shapes are a SceneIndex, or a World when they move. `toccata.trimesh` and
`toccata.fcl` stand in for trimesh's collision manager and for python-fcl. See docs/guide/python.md.
"""

from collections.abc import Callable, Iterable, Sequence
import builtins
import enum
import os
from typing import ClassVar, overload

import numpy
import numpy.typing

import toccata._typing


class Error(ValueError):
    """
    What was asked wrongly, and what to do: the message of the C++ library, which names the argument, file or element.
    """

class Status(enum.IntEnum):
    """How far an answer can be trusted."""

    exact = 0
    """It is the truth for the given numbers."""

    undecided = 1
    """Within the stated bound of the boundary; the safe answer is given."""

    not_converged = 2
    """The interval is wider than promised, and still holds."""

class Pose:
    """
    Where a shape is: world = linear @ local + offset.

    Pose() is the identity. Pose(given) takes whatever a question takes for a pose: a matrix of 4×4 numbers (its last row
    0 0 0 1) or of 3×4, a pair (R, t), three numbers for a translation, or what has as_matrix(), as scipy's Rotation and
    RigidTransform. Pose(R, t) takes a 3×3 matrix, or a rotation of scipy, and a translation. The numbers are used as given,
    and never corrected: they may scale, shear and mirror, but spheres, capsules, rounded shapes and half-spaces need a
    rotation. Lengths are in the unit of the coordinates. Immutable. Raises Error for what is no pose.
    """

    @overload
    def __init__(self) -> None: ...

    @overload
    def __init__(self, given: toccata._typing.PoseLike) -> None: ...

    @overload
    def __init__(self, linear: toccata._typing.PoseLike, offset: numpy.typing.ArrayLike) -> None: ...

    @staticmethod
    def translation(x: float, y: float, z: float) -> Pose:
        """
        Moves by (x, y, z), in the unit of the coordinates. Raises Error when a number is not finite.
        """

    @staticmethod
    def rotation(axis: numpy.typing.ArrayLike, degrees: float) -> Pose:
        """
        Turns counter-clockwise, by an angle in degrees, about an axis through the origin, shape (3,), of any length but 0. Quarter turns about coordinate axes are exact. Raises Error when a number is not finite or the axis is 0.
        """

    @staticmethod
    def from_quaternion(quaternion: numpy.typing.ArrayLike, translation: numpy.typing.ArrayLike = (0.0, 0.0, 0.0)) -> Pose:
        """
        Of a quaternion, shape (4,), in the order x, y, z, w, as scipy and ROS have it; trimesh's has w first. It need not have length 1. The translation has the shape (3,), in the unit of the coordinates. Raises Error when a number is not finite or all four are 0.
        """

    @staticmethod
    def nearest_rigid(given: toccata._typing.PoseLike) -> Pose:
        """
        With the rotation that is nearest to the given linear part (N. J. Higham, 1986): what drifted or came from floats becomes a pose that every shape accepts. Raises Error where that mirrors or flattens.
        """

    @property
    def matrix(self) -> toccata._typing.Floats:
        """A new array of the shape (4, 4)."""

    @property
    def linear(self) -> toccata._typing.Floats:
        """A new array of the shape (3, 3)."""

    @property
    def offset(self) -> toccata._typing.Floats:
        """A new array of the shape (3,)."""

    def inverse(self) -> Pose:
        """
        The pose that undoes it: each number of its linear part is the nearest double. Raises Error where it is singular.
        """

    def transform(self, points: numpy.typing.ArrayLike) -> toccata._typing.Floats:
        """
        Where the pose brings a point, shape (3,), or points, shape (N, 3), in the unit of the coordinates. Rounded as the truth page says (docs/truth.md). Raises Error for other shapes.
        """

    def __mul__(self, inner: Pose) -> Pose:
        """The inner pose first, then this one; rounded."""

    def __matmul__(self, inner: Pose) -> Pose:
        """The same as *."""

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def __repr__(self) -> str: ...

    def __array__(self, dtype: object | None = None, copy: object | None = None) -> toccata._typing.Floats:
        """What numpy.asarray makes of it: the matrix."""

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class Solid(enum.Enum):
    """What a mesh is taken for."""

    automatic = 0
    """Closed meshes are solids, open ones surfaces."""

    all = 1
    """It must be a solid: an open mesh is an error."""

    none = 2
    """A surface."""

class MeshHealth:
    """
    What a mesh is, counted exactly; vertices of equal coordinates are taken as one.
    """

    @property
    def vertices(self) -> int:
        """As stored."""

    @property
    def distinct_vertices(self) -> int:
        """Equal coordinates taken as one."""

    @property
    def unused_vertices(self) -> int:
        """Stored, but in no triangle."""

    @property
    def triangles(self) -> int: ...

    @property
    def faces(self) -> int: ...

    @property
    def components(self) -> int:
        """Parts that are connected through vertices."""

    @property
    def unbalanced_edges(self) -> int:
        """Used unequally often in both directions; 0 means closed."""

    @property
    def boundary_edges(self) -> int:
        """Used by one triangle."""

    @property
    def non_manifold_edges(self) -> int:
        """Used by more than two triangles."""

    @property
    def flipped_edges(self) -> int:
        """Used by two triangles in the same direction."""

    @property
    def degenerate_triangles(self) -> int:
        """Without area, exactly."""

    @property
    def duplicate_triangles(self) -> int:
        """The same vertices as an earlier one."""

    @property
    def closed(self) -> bool:
        """It may be a solid."""

    @property
    def signed_volume(self) -> float:
        """Of a closed mesh; negative when it is inside out."""

    @property
    def lower(self) -> toccata._typing.Floats:
        """The least corner of the box around it."""

    @property
    def upper(self) -> toccata._typing.Floats:
        """The greatest corner."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class Shape:
    """
    What all shapes have in common. A shape is made once, may be shared by threads, and is asked about under any pose. Lengths have no unit: they come back in that of the numbers given.
    """

    @property
    def kind(self) -> str:
        """'sphere', 'convex hull', 'mesh' …"""

    @property
    def element_count(self) -> int:
        """
        Triangles of a mesh or height field, of a compound those of its parts, else 1.
        """

    @property
    def face_count(self) -> int: ...

    @property
    def solid(self) -> bool:
        """It has an interior, and is no mere surface."""

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __repr__(self) -> str: ...

    def __copy__(self) -> Shape: ...

    def __deepcopy__(self, memo: dict[int, object]) -> Shape: ...

class Point(Shape):
    """
    One point, shape (3,), in its own frame and any unit: a surface. Raises Error when a number is not finite.
    """

    def __init__(self, position: numpy.typing.ArrayLike = (0.0, 0.0, 0.0)) -> None: ...

    @property
    def position(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class Segment(Shape):
    """
    A segment between two points, shape (3,), in its own frame and any unit: a surface. Raises Error when a number is not finite.
    """

    def __init__(self, start: numpy.typing.ArrayLike, end: numpy.typing.ArrayLike) -> None: ...

    @property
    def start(self) -> toccata._typing.Floats: ...

    @property
    def end(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class Triangle(Shape):
    """
    A triangle, which may be a segment or a point: a surface. Vertices of the shape (3, 3), in its own frame and any unit. Raises Error when a number is not finite.
    """

    def __init__(self, vertices: numpy.typing.ArrayLike) -> None: ...

    @property
    def vertices(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class Sphere(Shape):
    """
    A solid ball around a centre, shape (3,), in its own frame and any unit. Its pose may not deform it. Raises Error when the radius is not positive, or a number is not finite.
    """

    def __init__(self, radius: float, centre: numpy.typing.ArrayLike = (0.0, 0.0, 0.0)) -> None: ...

    @property
    def radius(self) -> float: ...

    @property
    def centre(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class Box(Shape):
    """
    A solid box along the axes of its own frame; half extents, shape (3,), from the centre to the faces, in any unit. Raises Error when one is not positive, or a number is not finite.
    """

    def __init__(self, half_extents: numpy.typing.ArrayLike, centre: numpy.typing.ArrayLike = (0.0, 0.0, 0.0)) -> None: ...

    @property
    def half_extents(self) -> toccata._typing.Floats: ...

    @property
    def centre(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class Capsule(Shape):
    """
    All points within the radius of a segment between two points, shape (3,), in its own frame and any unit. Its pose may not deform it. Raises Error when the radius is not positive, or a number is not finite.
    """

    def __init__(self, start: numpy.typing.ArrayLike, end: numpy.typing.ArrayLike, radius: float) -> None: ...

    @property
    def start(self) -> toccata._typing.Floats: ...

    @property
    def end(self) -> toccata._typing.Floats: ...

    @property
    def radius(self) -> float: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class HalfSpace(Shape):
    """
    All that lies on the side of a plane away from the normal, which may have any length but 0: solid, and without end. A point of the plane and the normal have the shape (3,), in its own frame and any unit. Its pose may not deform it. Raises Error when a number is not finite, or the normal is 0.
    """

    def __init__(self, point: numpy.typing.ArrayLike, normal: numpy.typing.ArrayLike) -> None: ...

    @property
    def point(self) -> toccata._typing.Floats: ...

    @property
    def normal(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class Cylinder(Shape):
    """
    A solid cylinder around the z axis of its own frame from -half_height to half_height, in any unit. Raises Error when a number is not positive and finite.
    """

    def __init__(self, radius: float, half_height: float) -> None: ...

    @property
    def radius(self) -> float: ...

    @property
    def half_height(self) -> float: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class Cone(Shape):
    """
    A solid cone around the z axis of its own frame, its base at -half_height and its tip at half_height, in any unit. Raises Error when a number is not positive and finite.
    """

    def __init__(self, radius: float, half_height: float) -> None: ...

    @property
    def radius(self) -> float: ...

    @property
    def half_height(self) -> float: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class Ellipsoid(Shape):
    """
    A solid ellipsoid around the origin of its own frame, its half axes, shape (3,), along the axes, in any unit. Raises Error when one is not positive and finite.
    """

    def __init__(self, half_axes: numpy.typing.ArrayLike) -> None: ...

    @property
    def half_axes(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class ConvexHull(Shape):
    """
    The convex hull of points of the shape (N, 3), in its own frame and any unit; exact (C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The quickhull algorithm for convex hulls", 1996). It may be flat, and is a surface then. It is made in one go: Ctrl-C is taken when it is done. Raises Error when there is no point, or one is not finite.
    """

    def __init__(self, points: numpy.typing.ArrayLike) -> None: ...

    @property
    def vertices(self) -> toccata._typing.Floats:
        """
        Those of the points that are extreme, in their order, shape (N, 3): a new array.
        """

    @property
    def dimension(self) -> int:
        """0: a point, 1: a segment, 2: a flat polygon, 3: a solid."""

    def __repr__(self) -> str: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class Rounded(Shape):
    """
    A point, segment, triangle, box or convex hull grown by a ball: all points within the radius of it, in the unit of the shape. Its pose may not deform it. Raises Error when the radius is not positive, and for another shape.
    """

    def __init__(self, core: Shape, radius: float) -> None: ...

    @property
    def core(self) -> Shape:
        """The shape within."""

    @property
    def radius(self) -> float: ...

    def __repr__(self) -> str: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class HeightField(Shape):
    """
    A surface above a grid in the x-y plane of its own frame: the vertex of row j and column i is (i * spacing[0], j * spacing[1], heights[j, i]), in any unit. Heights of the shape (rows, columns), at least two of each. Raises Error when a number is not finite, or a spacing is not positive.
    """

    def __init__(self, heights: numpy.typing.ArrayLike, spacing: numpy.typing.ArrayLike = (1.0, 1.0)) -> None: ...

    @property
    def heights(self) -> toccata._typing.Floats:
        """Shape (rows, columns): a new array."""

    @property
    def spacing(self) -> tuple[float, float]: ...

    def __repr__(self) -> str: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class Mesh(Shape):
    """
    A triangle mesh: solid when it is closed, else a surface.

    Mesh(vertices, faces) copies an array (N, 3) of real numbers, in any unit, and an array (M, 3) of whole numbers counted
    from 0, and builds a tree over the triangles. `face_of_triangle`, shape (M,) and ascending, says to which face of a file
    each triangle belongs, for the answers; left out, every triangle is a face. Mesh(mesh) takes what has `vertices` and
    `faces`, as a trimesh.Trimesh. Nothing is merged or repaired. Raises Error naming the element when a coordinate is not
    finite, an index out of range, or there is no triangle.
    """

    @overload
    def __init__(self, vertices: numpy.typing.ArrayLike, faces: numpy.typing.ArrayLike, face_of_triangle: numpy.typing.ArrayLike | None = None) -> None: ...

    @overload
    def __init__(self, mesh: toccata._typing.HasVerticesAndFaces) -> None: ...

    @property
    def vertices(self) -> toccata._typing.Floats:
        """
        Shape (N, 3): its own memory, which cannot be written to. Stays as it is when the mesh is updated.
        """

    @property
    def faces(self) -> toccata._typing.Indices:
        """
        The corners of its triangles, shape (M, 3): its own memory, which cannot be written to.
        """

    @property
    def face_of_triangle(self) -> toccata._typing.Indices:
        """The face that each triangle belongs to, shape (M,): a new array."""

    @property
    def triangle_count(self) -> int:
        """M."""

    @property
    def closed(self) -> bool:
        """
        Every edge is used equally often in both directions: it may be taken as a solid.
        """

    @property
    def bounds(self) -> toccata._typing.Floats:
        """
        The least and the greatest corner of the box around all vertices, shape (2, 3).
        """

    def health(self) -> MeshHealth:
        """
        What the mesh is: holes, flipped faces, triangles without area. Repairs nothing.
        """

    def update(self, vertices: numpy.typing.ArrayLike) -> None:
        """
        Gives the mesh other vertices, as many as before, shape (N, 3), in its own frame and unit: the boxes of its tree are put around them, and no question sees old ones. Copies, and scenes and worlds that hold the mesh, keep what they have. Raises Error for another number of vertices and where one is not finite; the mesh then stays as it was.
        """

    def write(self, path: str | os.PathLike[str]) -> None:
        """
        Writes OBJ, OFF, STL or PLY by the extension, so that the same numbers are read back. Raises Error naming the file that cannot be written.
        """

    def __repr__(self) -> str: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

def load_mesh(path: str | os.PathLike[str]) -> Mesh:
    """
    Reads a mesh from an OBJ, STL, PLY or OFF file: every number as its nearest double, in the unit of the file, nothing repaired. Raises Error naming file and line.
    """

def generate_mesh(name: str, **parameters: float) -> Mesh:
    """
    A mesh by the name of its generator, such as 'torus-knot', 'gear' or 'noise-sphere', with its parameters (docs/guide/generated-meshes.md), tube_radius for tube-radius: the same bits everywhere. Raises Error for an unknown name.
    """

class Compound(Shape):
    """
    The union of shapes, each a shape or a pair (shape, pose) in the frame of the whole, in one unit; solid if all parts are. Raises Error when there is none, and for a pose that is not finite.
    """

    def __init__(self, parts: Iterable[Shape | tuple[Shape, toccata._typing.PoseLike | None]]) -> None: ...

    @property
    def parts(self) -> list[tuple[Shape, Pose]]:
        """Pairs (shape, pose)."""

    def __repr__(self) -> str: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class RelationKind(enum.IntEnum):
    """How two shapes lie."""

    apart = 0

    touching = 1

    overlapping = 2
    """Two solids have interior points in common."""

    crossing = 3
    """A surface is involved."""

class Containment(enum.IntEnum):
    """Which of two shapes contains the other."""

    none = 0

    a_in_b = 1

    b_in_a = 2

    equal = 3

class Distance:
    """
    How far apart two posed shapes are, in the unit of the coordinates: the exact distance lies in [lower, upper], whose width is at most 1e-12 of upper. Both are 0 when they meet.
    """

    @property
    def lower(self) -> float:
        """The exact distance is at least this."""

    @property
    def upper(self) -> float:
        """The exact distance is at most this; 0 when the shapes meet."""

    @property
    def on_a(self) -> toccata._typing.Floats:
        """The nearest point of A, in the world; shape (3,)."""

    @property
    def on_b(self) -> toccata._typing.Floats:
        """The nearest point of B, in the world; shape (3,)."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    @property
    def element_a(self) -> int:
        """The element of A, of a mesh the triangle."""

    @property
    def element_b(self) -> int:
        """The element of B."""

    @property
    def face_a(self) -> int:
        """The face of A, as its file counts them from 0."""

    @property
    def face_b(self) -> int:
        """The face of B."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class Penetration:
    """
    The shortest way to part two solids: the exact depth lies in [lower, upper], in the unit of the coordinates. Both are 0 when they are apart or touch. Of meshes the bracket may be wide.
    """

    @property
    def lower(self) -> float:
        """The exact depth is at least this."""

    @property
    def upper(self) -> float:
        """Moved this far along the direction, B no longer overlaps A."""

    @property
    def direction(self) -> toccata._typing.Floats:
        """Unit vector from A to B; shape (3,)."""

    @property
    def on_a(self) -> toccata._typing.Floats:
        """The deepest point of A within B; shape (3,)."""

    @property
    def on_b(self) -> toccata._typing.Floats:
        """The deepest point of B within A; shape (3,)."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class Relation:
    """How two posed shapes lie; exact, touching included."""

    @property
    def kind(self) -> RelationKind:
        """Apart, touching, overlapping (two solids) or crossing (a surface)."""

    @property
    def containment(self) -> Containment:
        """Whether one contains the other."""

    @property
    def side_unresolved(self) -> bool:
        """
        Two surfaces touch, and the faces alone do not tell whether they pass through each other.
        """

    @property
    def a_solid(self) -> bool:
        """A was taken as a solid."""

    @property
    def b_solid(self) -> bool:
        """B was taken as a solid."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class ShapeHit:
    """Where a moving shape first meets another."""

    @property
    def lower(self) -> float:
        """The exact fraction of the way is at least this."""

    @property
    def upper(self) -> float:
        """The exact fraction of the way is at most this; from 0 to 1."""

    @property
    def point(self) -> toccata._typing.Floats:
        """Where they meet then, in the world; shape (3,)."""

    @property
    def normal(self) -> toccata._typing.Floats:
        """Unit, from B to A, which moves; shape (3,)."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    @property
    def element_a(self) -> int:
        """The element of A, of a mesh the triangle."""

    @property
    def element_b(self) -> int:
        """The element of B."""

    @property
    def face_a(self) -> int:
        """The face of A, as its file counts them from 0."""

    @property
    def face_b(self) -> int:
        """The face of B."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

def overlap(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> bool:
    """
    Have the two posed shapes a point in common? Exact; touching counts, and a shape inside a solid.

    Shapes are where their poses put them in the world, in any unit that both have. Of cylinders, cones and ellipsoids a no is
    proved, and what is undecided counts as yes. Raises Error when a pose is not finite, or one that its shape may not have, and
    when an open mesh is asked about as a solid.
    """

def relation(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> Relation:
    """
    How the two posed shapes lie in the world, exactly: apart, touching, overlapping or crossing, and which contains the other. Raises Error like overlap.
    """

def distance(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> Distance:
    """
    How far the two posed shapes are apart, certified: an interval that contains the exact distance, and the nearest points.

    0 when they meet, also when one lies within a solid. In the unit of the coordinates; the points are in the world. Convex
    shapes by E. G. Gilbert, D. W. Johnson, S. S. Keerthi, "A fast procedure for computing the distance between complex objects
    in three-dimensional space", 1988; that the interval holds is proved. Raises Error like overlap.
    """

def within_distance(a: Shape, b: Shape, max_distance: float, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> bool:
    """
    Is the exact distance at most the greatest one, in the unit of the coordinates? Decided exactly, and for less than the distance costs. Raises Error like overlap, and for a negative one.
    """

def distance_within(a: Shape, b: Shape, max_distance: float, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> Distance | None:
    """
    What distance answers where it is at most the greatest one, in the unit of the coordinates, else None, which is found out without it. Raises Error like overlap, and for a negative one.
    """

def penetration(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> Penetration:
    """
    How deep two solids overlap, as an interval, and a short way to part them.

    Of convex shapes narrow; of meshes and compounds the bracket holds as well, and may be wide. In the unit of the
    coordinates; direction and points are in the world (G. van den Bergen, "Proximity queries and penetration depth computation
    on 3D game objects", 2001). Raises Error like overlap, and where it is not defined: for surfaces, open meshes, two
    half-spaces.
    """

def cast_shape(a: Shape, motion: numpy.typing.ArrayLike, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> ShapeHit | None:
    """
    Where A, moved from its pose by motion (shape (3,), in the world) without turning, first meets B, which stands;
    None where it does not.

    lower and upper are fractions of the way, from 0 to 1. That nothing is met is proved (conservative advancement: B. Mirtich,
    "Impulse-based dynamic simulation of rigid body systems", 1996). Lengths are in the unit of the coordinates. Raises Error like
    overlap, and where it is not defined, as of two half-spaces.
    """

def cast_shape_each(a: Shape, motions: numpy.typing.ArrayLike, b: Shape, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    cast_shape of many motions, shape (N, 3), in the world and the unit of the coordinates, and poses, N or one of each: a structured array with the members of ShapeHit, and found. Raises Error naming the least query that is asked wrongly.
    """

def overlap_each(a: toccata._typing.ShapesLike, b: toccata._typing.ShapesLike, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Booleans:
    """
    overlap for many poses, on all cores: a bool for each.

    Poses are N matrices of the shape (N, 4, 4) or (N, 3, 4), N translations (N, 3), N poses of scipy or toccata, or one for
    all; a and b are one shape, or a list of N. Poses are in the world, their lengths in any unit that all have. Arrays of
    doubles in C order are read as they are, others are converted first. Entry i is what overlap answers for pose i, whatever
    the number of threads. Raises Error naming the least query that is asked wrongly.
    """

def relation_each(a: toccata._typing.ShapesLike, b: toccata._typing.ShapesLike, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    relation for many poses, in shapes and unit as overlap_each takes them, on all cores: a structured array with the members of Relation, kind and containment as numbers of their enumerations. Raises Error like overlap_each.
    """

def distance_each(a: toccata._typing.ShapesLike, b: toccata._typing.ShapesLike, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    distance for many poses, in shapes as overlap_each takes them, on all cores: a structured array with the members of Distance, in the unit of the coordinates. Raises Error like overlap_each.
    """

def within_distance_each(a: toccata._typing.ShapesLike, b: toccata._typing.ShapesLike, max_distance: float, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Booleans:
    """
    within_distance for many poses, in shapes as overlap_each takes them, on all cores: a bool for each. The greatest distance is in the unit of the coordinates. Raises Error like overlap_each, and for a negative one.
    """

def penetration_each(a: toccata._typing.ShapesLike, b: toccata._typing.ShapesLike, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    penetration for many poses, in shapes as overlap_each takes them, on all cores: a structured array with the members of Penetration, in the unit of the coordinates. Raises Error like overlap_each, and where it is not defined, as penetration.
    """

def count_contacts_each(a: toccata._typing.ShapesLike, b: toccata._typing.ShapesLike, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    How many triangles and faces meet, for many poses, in shapes and unit as overlap_each takes them, on all cores: a structured array with triangle_pairs and face_pairs. Raises Error like overlap_each.
    """

class RayHit:
    """What a ray meets first."""

    @property
    def lower(self) -> float:
        """The exact fraction of the way is at least this."""

    @property
    def upper(self) -> float:
        """The exact fraction of the way is at most this; from 0 to 1."""

    @property
    def point(self) -> toccata._typing.Floats:
        """Where, in the world; shape (3,)."""

    @property
    def normal(self) -> toccata._typing.Floats:
        """Unit, against the ray; zero where it starts inside. Shape (3,)."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    @property
    def element(self) -> int:
        """The element, of a mesh the triangle."""

    @property
    def face(self) -> int:
        """The face, as its file counts them from 0."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class SurfacePoint:
    """The point of a surface that is nearest to a given one."""

    @property
    def lower(self) -> float:
        """The exact distance is at least this."""

    @property
    def upper(self) -> float:
        """The exact distance is at most this."""

    @property
    def point(self) -> toccata._typing.Floats:
        """The nearest point, in the world; shape (3,)."""

    @property
    def element(self) -> int:
        """The element, of a mesh the triangle."""

    @property
    def face(self) -> int:
        """The face, as its file counts them from 0."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

def nearest_point(point: numpy.typing.ArrayLike, surface: Shape, pose: toccata._typing.PoseLike | None = None, max_distance: float = float('inf')) -> SurfacePoint | None:
    """
    The nearest point of the surface of a posed shape, also from within; None where all of it is farther than max_distance.

    The point has the shape (3,), in the world. Nothing farther than max_distance is found, but for 1e-12 of it. In the unit of
    the coordinates. By the tree of a mesh, the nearest boxes first (N. Roussopoulos, S. Kelley, F. Vincent, "Nearest neighbor
    queries", 1995). Raises Error when a number is not finite, the greatest distance is negative, and for poses as overlap does.
    """

def nearest_points(point: numpy.typing.ArrayLike, k: int, surface: Shape, pose: toccata._typing.PoseLike | None = None, max_distance: float = float('inf')) -> toccata._typing.Answers:
    """
    The points that are nearest to one of the shape (3,) in the world, of the k nearest elements, the nearest first: a structured array with the members of SurfacePoint, in the unit of the coordinates. Raises Error like nearest_point.
    """

def nearest_point_each(points: numpy.typing.ArrayLike, surface: Shape, pose: toccata._typing.PoseLike | None = None, max_distance: float = float('inf'), *, threads: int = 0) -> toccata._typing.Answers:
    """
    nearest_point of many points, shape (N, 3), on all cores: a structured array with the members of SurfacePoint, and found, in the unit of the coordinates. Raises Error like nearest_point, naming the point.
    """

class Side(enum.IntEnum):
    """Where a point is."""

    outside = 0

    boundary = 1

    inside = 2

class SignBy(enum.IntEnum):
    """What tells inside from outside."""

    automatic = 0
    """Of a closed mesh the winding number, of an open one the generalised."""

    winding_number = 1
    """Exact. Not of open meshes."""

    generalized_winding_number = 2
    """A guess where holes are."""

class SignedDistance:
    """
    How far a point is from a surface, negative inside: the exact one lies in [lower, upper].
    """

    @property
    def lower(self) -> float:
        """The exact signed distance is at least this."""

    @property
    def upper(self) -> float:
        """The exact signed distance is at most this."""

    @property
    def nearest(self) -> toccata._typing.Floats:
        """The nearest point of the surface; shape (3,)."""

    @property
    def element(self) -> int:
        """The element, of a mesh the triangle."""

    @property
    def face(self) -> int:
        """The face, as its file counts them from 0."""

    @property
    def side(self) -> Side:
        """Inside, outside, or on the boundary."""

    @property
    def sign_by(self) -> SignBy:
        """What told the side."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

def signed_distance(point: numpy.typing.ArrayLike, shape: Shape, pose: toccata._typing.PoseLike | None = None, sign_by: SignBy = SignBy.automatic) -> SignedDistance:
    """
    How far a point, shape (3,) in the world, is from the surface of a posed shape, negative inside.

    The side is exact of closed meshes and of shapes that are none; of an open mesh it is that of the generalised winding
    number (A. Jacobson and others, 2013). In the unit of the coordinates. Raises Error when a number is not finite, or an open
    mesh is asked by SignBy.winding_number.
    """

def signed_distance_each(points: numpy.typing.ArrayLike, shape: Shape, pose: toccata._typing.PoseLike | None = None, sign_by: SignBy = SignBy.automatic, *, threads: int = 0) -> toccata._typing.Answers:
    """
    signed_distance of many points, shape (N, 3), on all cores: a structured array with the members of SignedDistance, in the unit of the coordinates. Raises Error like signed_distance, naming the point.
    """

class WindingNumber:
    """
    The generalised winding number of a mesh around a point: the exact one lies in [lower, upper].
    """

    @property
    def value(self) -> float:
        """1 inside a closed mesh and 0 outside, up to rounding."""

    @property
    def lower(self) -> float:
        """The exact one is at least this."""

    @property
    def upper(self) -> float:
        """The exact one is at most this."""

    @property
    def status(self) -> Status:
        """not_converged: the interval is wider than asked for."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

def locate(point: numpy.typing.ArrayLike, solid: Shape, pose: toccata._typing.PoseLike | None = None) -> tuple[Side, int]:
    """
    Where a point, shape (3,) in the world, lies relative to a closed mesh, exactly, and how often the surface winds around it. Raises Error for an open mesh, and when a number is not finite.
    """

def generalized_winding_number(point: numpy.typing.ArrayLike, mesh: Shape, pose: toccata._typing.PoseLike | None = None, tolerance: float = 0.01) -> WindingNumber:
    """
    How much of the sphere of directions around a point, shape (3,) in the world, a mesh covers: about 1 inside, 0 outside, and between where holes are. Off by at most the tolerance, a number without unit, as an interval (A. Jacobson, L. Kavan, O. Sorkine-Hornung, "Robust inside-outside segmentation using generalized winding numbers", 2013). Raises Error for what is no mesh, and when a number is not finite.
    """

def generalized_winding_number_each(points: numpy.typing.ArrayLike, mesh: Shape, pose: toccata._typing.PoseLike | None = None, tolerance: float = 0.01, *, threads: int = 0) -> toccata._typing.Answers:
    """
    generalized_winding_number of many points, shape (N, 3), on all cores: a structured array with the members of WindingNumber. Raises Error like it, naming the point.
    """

def cast_ray(origin: numpy.typing.ArrayLike, motion: numpy.typing.ArrayLike, target: Shape, pose: toccata._typing.PoseLike | None = None, *, solid: Solid = Solid.automatic) -> RayHit | None:
    """
    Where the ray from origin to origin + motion first meets the posed shape, None where it meets nothing, which is proved;
    both of the shape (3,), in the world.

    lower and upper are fractions of the way, from 0 to 1: a ray ends at origin + motion. No ray passes between two triangles
    that share an edge. A solid is met at once from within; Solid.none asks its surface. Lengths are in the unit of the
    coordinates. Raises Error when a number is not finite or the motion is zero.
    """

def cast_ray_each(origins: numpy.typing.ArrayLike, motions: numpy.typing.ArrayLike, target: Shape, pose: toccata._typing.PoseLike | None = None, *, solid: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    cast_ray of many rays, origins and motions of the shape (N, 3) in the world and the unit of the coordinates, on all cores: a structured array with the members of RayHit, and found. Raises Error like cast_ray, naming the ray.
    """

class IntersectionKind(enum.IntEnum):
    """What two triangles have in common."""

    none = 0

    point = 1

    segment = 2

    polygon = 3
    """They are coplanar and overlap."""

def contacts(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 1) -> toccata._typing.Answers:
    """
    All pairs of triangles, or of other elements, that have a point in common; exact and in order.

    A structured array: element_a, element_b, face_a, face_b, kind (IntersectionKind), coplanar, crossing, point_count. A
    shape inside a solid mesh that does not touch its surface has none: ask relation. Two triangles by T. Möller, "A fast
    triangle-triangle intersection test", 1997, in exact signs. Shapes are where their poses put them in the world, in any unit.
    Raises Error like overlap.
    """

def contacts_with_points(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 1) -> toccata._typing.Answers:
    """
    contacts, with the points in which the triangles meet.

    The array has a field more, points of the shape (6, 3): of each row the first point_count points are the corners of what
    the triangles have in common, in the world and the unit of the coordinates, every number the nearest double; the others are
    0. Where a shape is no mesh there are none: ask manifold. Raises Error like overlap.
    """

def contacts_each(a: toccata._typing.ShapesLike, b: toccata._typing.ShapesLike, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    contacts of many, in shapes and unit as overlap_each takes them, on all cores: one structured array of all, in order, with the fields of contacts and before them query, which says of which question a row is. Raises Error like overlap_each.
    """

def contact_regions(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> toccata._typing.Answers:
    """
    The places at which two meshes meet, the deepest first: a structured array.

    One region is one connected part that two solids have in common, or one curve or area in which surfaces meet. The fields
    are triangle_pairs, face_pairs, lower and upper (the corners of the box around it), point_count, closed, curve_count, area,
    normal (from A to B), depth_lower and depth_upper (NaN where one is a surface), deepest (the deepest point); in the world and
    the unit of the coordinates. Only the counts, closed and the bounds of the depth are exact. Raises Error like overlap, and for
    what is no mesh or height field.
    """

def contact_regions_each(a: toccata._typing.ShapesLike, b: toccata._typing.ShapesLike, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    contact_regions of many, in shapes as overlap_each takes them, on all cores: one structured array of all, in order, whose field query says of which question a row is; in the unit of the coordinates. Raises Error like contact_regions, naming the query.
    """

def self_contacts(mesh: Shape, pose: toccata._typing.PoseLike | None = None) -> toccata._typing.Answers:
    """
    Where a mesh intersects itself: pairs of its triangles that have more in common than the corners they share. A structured array as of contacts, with element_a the lesser. Exact, in any unit. Raises Error for what is no mesh, and for a pose that is not finite.
    """

def self_overlap(mesh: Shape, pose: toccata._typing.PoseLike | None = None) -> bool:
    """
    Whether a mesh intersects itself. Exact, in any unit. Raises Error like self_contacts.
    """

class Manifold:
    """
    Where two convex shapes touch or overlap: up to four points that stand for the region of contact, rounded. Its length is the number of points, 0 when they are apart.
    """

    def __len__(self) -> int: ...

    @property
    def count(self) -> int: ...

    @property
    def normal(self) -> toccata._typing.Floats:
        """Unit, from A to B; shape (3,)."""

    @property
    def positions(self) -> toccata._typing.Floats:
        """Half way between the two surfaces, in the world; shape (count, 3)."""

    @property
    def depths(self) -> toccata._typing.Floats:
        """
        How deep the surfaces overlap there along the normal; negative is a gap. Shape (count,).
        """

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

def manifold(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> Manifold:
    """
    Where two convex shapes, or one and a half-space, touch or overlap: up to four points and a normal.

    Empty exactly when they are apart. In the world and the unit of the coordinates. Raises Error like overlap, and where it is
    not defined, as of meshes: there is one for each contact.
    """

class MoverOptions:
    """
    How a character moves (move_character). Lengths are in the unit of the coordinates.

    up: a vector in the world, shape (3,), of any length above 0. skin: how far the shape stays from everything. max_slope_degrees: the
    steepest ground that is walked on, from level. step_height: the highest step that is walked up. snap_distance: how far below a walker ground
    is looked for. max_slides: how often the way may bend in one step. Options out of range are told by move_character, which
    raises Error.
    """

    def __init__(self, *, up: numpy.typing.ArrayLike = (0.0, 0.0, 1.0), skin: float = 0.01, max_slope_degrees: float = 45.0, step_height: float = 0.3, snap_distance: float = 0.3, max_slides: int = 8) -> None: ...

    @property
    def up(self) -> toccata._typing.Floats: ...

    @property
    def skin(self) -> float: ...

    @property
    def max_slope_degrees(self) -> float: ...

    @property
    def step_height(self) -> float: ...

    @property
    def snap_distance(self) -> float: ...

    @property
    def max_slides(self) -> int: ...

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

def velocity_along(velocity: numpy.typing.ArrayLike, normals: numpy.typing.ArrayLike) -> toccata._typing.Floats:
    """
    The vector nearest to `velocity`, shape (3,), in its unit and frame, that goes into none of the planes with these normals, shape (N, 3), of length 1: so a velocity loses what goes into the contacts of a step of a character. Raises Error for a number that is not finite.
    """

class SceneInstance:
    """
    A shape at its place, as one of many.

    The pose is in the world. What it is called is for messages; two of one group that is not empty are not checked against each
    other (check_all). Raises Error for what is no pose.
    """

    def __init__(self, shape: Shape, pose: toccata._typing.PoseLike | None = None, solid: Solid = Solid.automatic, name: str = '', group: str = '') -> None: ...

    @property
    def shape(self) -> Shape: ...

    @property
    def pose(self) -> Pose: ...

    @property
    def solid(self) -> Solid: ...

    @property
    def name(self) -> str: ...

    @property
    def group(self) -> str: ...

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class SceneRayHit:
    """What a ray meets first."""

    @property
    def object(self) -> int:
        """Of which of the objects: its index."""

    @property
    def lower(self) -> float:
        """The exact fraction of the way is at least this."""

    @property
    def upper(self) -> float:
        """The exact fraction of the way is at most this; from 0 to 1."""

    @property
    def point(self) -> toccata._typing.Floats:
        """Where, in the world; shape (3,)."""

    @property
    def normal(self) -> toccata._typing.Floats:
        """Unit, against the ray; zero where it starts inside. Shape (3,)."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    @property
    def element(self) -> int:
        """The element, of a mesh the triangle."""

    @property
    def face(self) -> int:
        """The face, as its file counts them from 0."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class SceneShapeHit:
    """Where a moving shape first meets another."""

    @property
    def object(self) -> int:
        """Of which of the objects: its index."""

    @property
    def lower(self) -> float:
        """The exact fraction of the way is at least this."""

    @property
    def upper(self) -> float:
        """The exact fraction of the way is at most this; from 0 to 1."""

    @property
    def point(self) -> toccata._typing.Floats:
        """Where they meet then, in the world; shape (3,)."""

    @property
    def normal(self) -> toccata._typing.Floats:
        """Unit, from B to A, which moves; shape (3,)."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    @property
    def element_a(self) -> int:
        """The element of A, of a mesh the triangle."""

    @property
    def element_b(self) -> int:
        """The element of B."""

    @property
    def face_a(self) -> int:
        """The face of A, as its file counts them from 0."""

    @property
    def face_b(self) -> int:
        """The face of B."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class SceneDistance:
    """
    How far apart two posed shapes are, in the unit of the coordinates: the exact distance lies in [lower, upper], whose width is at most 1e-12 of upper. Both are 0 when they meet.
    """

    @property
    def object(self) -> int:
        """Of which of the objects: its index."""

    @property
    def lower(self) -> float:
        """The exact distance is at least this."""

    @property
    def upper(self) -> float:
        """The exact distance is at most this; 0 when the shapes meet."""

    @property
    def on_a(self) -> toccata._typing.Floats:
        """The nearest point of A, in the world; shape (3,)."""

    @property
    def on_b(self) -> toccata._typing.Floats:
        """The nearest point of B, in the world; shape (3,)."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    @property
    def element_a(self) -> int:
        """The element of A, of a mesh the triangle."""

    @property
    def element_b(self) -> int:
        """The element of B."""

    @property
    def face_a(self) -> int:
        """The face of A, as its file counts them from 0."""

    @property
    def face_b(self) -> int:
        """The face of B."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class SceneIndex:
    """
    Posed shapes that stay where they are, in a tree over their boxes.

    Made of a list of shapes, pairs (shape, pose) and SceneInstances. Each answer is what the question of that name gives for
    every one of them by itself. Objects are told by their index in the list; `only`, an array of as many truths, says which
    are asked, and what is asked is in the world. Lengths are in the unit of the coordinates. Questions may be asked from many
    threads at once. Raises Error naming the object that cannot be posed so.
    """

    def __init__(self, objects: toccata._typing.ObjectsLike) -> None: ...

    def __len__(self) -> int: ...

    @property
    def objects(self) -> list[SceneInstance]: ...

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def cast_ray(self, origin: numpy.typing.ArrayLike, motion: numpy.typing.ArrayLike, *, only: object | None = None) -> SceneRayHit | None:
        """
        The first of all that the ray from origin to origin + motion meets, both of the shape (3,) in the world, or None, which is proved. As cast_ray of one shape, in the unit of the coordinates. Raises Error like it.
        """

    def cast_ray_through(self, origin: numpy.typing.ArrayLike, motion: numpy.typing.ArrayLike, *, only: object | None = None) -> toccata._typing.Answers:
        """
        Where the ray from origin to origin + motion, both of the shape (3,) in the world, meets each of them first, in order: a structured array with the members of what cast_ray returns, in the unit of the coordinates. Raises Error like cast_ray.
        """

    def cast_ray_each(self, origins: numpy.typing.ArrayLike, motions: numpy.typing.ArrayLike, *, only: object | None = None, threads: int = 0) -> toccata._typing.Answers:
        """
        cast_ray of many rays, shapes (N, 3), on all cores: a structured array with the members of what cast_ray returns, and found; in the unit of the coordinates. Raises Error like cast_ray, naming the ray.
        """

    def cast_shape(self, shape: Shape, motion: numpy.typing.ArrayLike, pose: toccata._typing.PoseLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None) -> SceneShapeHit | None:
        """
        The first of all that the shape, which is A, meets on its way from its pose by motion, shape (3,) in the world, or None, which is proved. As cast_shape of two, in the unit of the coordinates. Raises Error like it.
        """

    def cast_shape_each(self, shapes: toccata._typing.ShapesLike, motions: numpy.typing.ArrayLike, poses: toccata._typing.PosesLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None, threads: int = 0) -> toccata._typing.Answers:
        """
        cast_shape of many motions, shape (N, 3), of one shape or N, at one pose or N, on all cores: a structured array with the members of what cast_shape returns, and found; in the unit of the coordinates. Raises Error like cast_shape, naming the query.
        """

    def overlapping(self, shape: Shape, pose: toccata._typing.PoseLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None) -> toccata._typing.Indices:
        """
        Which of them have a point in common with the shape at its pose in the world, ascending. Exact, in any unit. Raises Error like overlap.
        """

    def relations(self, shape: Shape, pose: toccata._typing.PoseLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None) -> toccata._typing.Answers:
        """
        overlapping, and how: the shape is A. A structured array with the members of Relation and which it is, in any unit. Raises Error like overlap.
        """

    def within(self, shape: Shape, max_distance: float, pose: toccata._typing.PoseLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None) -> toccata._typing.Indices:
        """
        Which of them are at most so far from the shape at its pose, in the unit of the coordinates, ascending. Decided exactly. Raises Error like within_distance.
        """

    def overlapping_each(self, shapes: toccata._typing.ShapesLike, poses: toccata._typing.PosesLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None, threads: int = 0) -> toccata._typing.Answers:
        """
        overlapping of one shape or N, at one pose or N, on all cores: one structured array of all that was found, in order, whose field query says of which question a row is. In any unit. Raises Error like overlap, naming the query.
        """

    def within_each(self, shapes: toccata._typing.ShapesLike, max_distance: float, poses: toccata._typing.PosesLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None, threads: int = 0) -> toccata._typing.Answers:
        """
        within of one shape or N, at one pose or N, on all cores, in the unit of the coordinates: a structured array as that of overlapping_each. Raises Error like within_distance, naming the query.
        """

    def nearest(self, shape: Shape, pose: toccata._typing.PoseLike | None = None, max_distance: float = float('inf'), *, solid: Solid = Solid.automatic, only: object | None = None) -> SceneDistance | None:
        """
        The nearest of all to the shape, which is A, as distance tells it of two, in the unit of the coordinates; None where none is within the greatest distance, which is decided exactly. Raises Error like distance, and for a greatest distance that is negative.
        """

    def nearest_each(self, shapes: toccata._typing.ShapesLike, poses: toccata._typing.PosesLike | None = None, max_distance: float = float('inf'), *, solid: Solid = Solid.automatic, only: object | None = None, threads: int = 0) -> toccata._typing.Answers:
        """
        nearest of one shape or N, at one pose or N, on all cores: a structured array with the members of what nearest returns, and found; in the unit of the coordinates. Raises Error like nearest, naming the query.
        """

    def move_character(self, shape: Shape, start: SceneMoverState, motion: numpy.typing.ArrayLike, options: MoverOptions = ..., *, only: numpy.typing.ArrayLike | None = None, moved: Sequence[tuple[int, toccata._typing.PoseLike | None]] | None = None) -> SceneMoverStep:
        """
        One step of a character: a convex shape goes from a state by `motion`, shape (3,) in the world and the unit of the coordinates, as far as these objects let it, and slides along what it meets; nothing tunnels, which is proved. On ground a motion that has no part along `up` is walked, over slopes, up and down steps. `moved` tells what was elsewhere before the step: pairs (object, pose before). Raises Error when a number is not finite, the shape is of another kind, or an object is not here.
        """

class SceneMoverContact:
    """Something that a character stands on, or met on its way."""

    @property
    def object(self) -> int:
        """Which."""

    @property
    def element(self) -> int:
        """The element, of a mesh the triangle."""

    @property
    def point(self) -> toccata._typing.Floats:
        """The nearest of the object, shape (3,)."""

    @property
    def normal(self) -> toccata._typing.Floats:
        """Unit, from there to the shape; shape (3,)."""

    def __repr__(self) -> str: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class SceneMoverState:
    """
    Where a character is: all that is known of it from one step to the next. Its pose is in the world. Raises Error for what is no pose.
    """

    def __init__(self, pose: toccata._typing.PoseLike | None = None, ground: SceneMoverContact | None = None) -> None: ...

    @property
    def pose(self) -> Pose:
        """Of the shape; a step changes its offset alone."""

    @property
    def ground(self) -> SceneMoverContact | None:
        """What it stands on; None: it is in the air."""

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class SceneMoverStep:
    """What came of a step of a character."""

    @property
    def state(self) -> SceneMoverState:
        """Where it is now."""

    @property
    def moved(self) -> toccata._typing.Floats:
        """By how much in all, shape (3,)."""

    @property
    def carried(self) -> toccata._typing.Floats:
        """By how much of it on or by objects that moved."""

    @property
    def pushed_out(self) -> toccata._typing.Floats:
        """And out of what it began in."""

    @property
    def contacts(self) -> list[SceneMoverContact]:
        """Met by its own motion, in the order in which they were."""

    @property
    def met_wall(self) -> bool:
        """One of them is too steep to be walked on."""

    @property
    def met_ceiling(self) -> bool:
        """One faces down as ground faces up."""

    @property
    def stepped(self) -> bool:
        """Up a step."""

    @property
    def tight(self) -> bool:
        """It is still nearer to something than it stays."""

    @property
    def stuck(self) -> bool:
        """It still overlaps something: there was no way out."""

    @property
    def crushed(self) -> bool:
        """Something that moved its way could not push it aside."""

    @property
    def cut_short(self) -> bool:
        """It may not have gone as far as it can; the contacts tell why."""

    def __repr__(self) -> str: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class ClashKind(enum.IntEnum):
    """What a clash is in the field's words."""

    clearance = 0
    """Near, and not in contact."""

    touching = 1

    crossing = 2
    """A surface takes part."""

    overlap = 3
    """Of two solids; whether one passes through the other was not asked."""

    protrude = 4
    """One goes into the other, and not through it."""

    pierce = 5
    """One goes into the other at one place and out at another."""

    contains = 6
    """One lies wholly inside the other."""

    equal = 7

class ClashTolerance(enum.IntEnum):
    """How an overlap stands to the tolerance."""

    none = 0
    """None was asked for, or the two do not overlap."""

    within = 1
    """Certainly no deeper."""

    beyond = 2
    """Certainly deeper."""

    undecided = 3
    """Its bracket holds the tolerance, or there is no depth."""

class ClashPiercing(enum.IntEnum):
    """Which of two passes through the other."""

    none = 0
    """Neither, or the volume was not asked for."""

    unknown = 1
    """One does, and which could not be told."""

    a_through_b = 2

    b_through_a = 3

class DepthEnd(enum.IntEnum):
    """Why the search for a depth ended."""

    precise = 0

    exhausted = 1

    out_of_time = 2

class CheckAnswer:
    """
    What check_all found. Its length is the number of pairs.

    Everything is told in structured arrays; where one has a field pair, that counts the rows of pairs.
    """

    def __len__(self) -> int: ...

    @property
    def pairs(self) -> toccata._typing.Answers:
        """
        a, b, the members of Relation, clash (ClashKind), tolerance (ClashTolerance) and piercing (ClashPiercing), ascending by (a, b): a new array.
        """

    @property
    def contacts(self) -> toccata._typing.Answers:
        """pair and the fields of contacts."""

    @property
    def regions(self) -> toccata._typing.Answers:
        """
        pair and the fields of contact_regions, of two meshes, with penetration.
        """

    @property
    def distances(self) -> toccata._typing.Answers:
        """pair and the members of Distance, where a clearance was asked for."""

    @property
    def penetrations(self) -> toccata._typing.Answers:
        """pair, the members of Penetration, and end (DepthEnd)."""

    @property
    def local_depths(self) -> toccata._typing.Answers:
        """
        pair, lower and upper: how deep two meshes are in each other where they are deepest, where that decided how they stand to the tolerance; upper is infinite where it was not needed.
        """

    @property
    def volumes(self) -> toccata._typing.Answers:
        """pair and the members of OverlapVolume, where the volume was asked for."""

    @property
    def candidate_pairs(self) -> int:
        """How many pairs were looked at."""

    def __repr__(self) -> str: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

def check_all(objects: toccata._typing.ObjectsLike, *, contacts: bool = False, penetration: bool = False, clearance: float | None = None, pair_clearances: Sequence[tuple[int, int, float]] | None = None, precision: float = 0.1, volume: bool = False, tolerance: float | None = None, threads: int = 0) -> CheckAnswer:
    """
    Every two of many posed shapes that are not apart, or nearer than the clearance, and how they lie.

    The objects are shapes, pairs (shape, pose), or SceneInstances. On request the contacts of each pair, how deep they overlap
    (brackets as narrow as the precision, a fraction), and with a clearance how far apart they are. pair_clearances, a list of
    (a, b, length), says others for some. volume asks how much they have in common; overlaps that are certainly no deeper than
    the tolerance are told to be within it. Lengths are in the unit of the coordinates. Which pairs is exact. On all cores,
    without the lock; Ctrl-C ends it. Raises Error naming the object that is asked about wrongly.
    """

def self_contacts_each(objects: toccata._typing.ObjectsLike, *, threads: int = 0) -> toccata._typing.Answers:
    """
    Where each of many posed meshes intersects itself, on all cores: a structured array as that of self_contacts, and object, which says whose contact a row is. In any unit. Raises Error like self_contacts, naming the object.
    """

class Contact:
    """Two elements, one of each shape, that have a point in common."""

    @property
    def element_a(self) -> int:
        """The element of A, of a mesh the triangle."""

    @property
    def element_b(self) -> int:
        """The element of B."""

    @property
    def face_a(self) -> int:
        """The face of A, as its file counts them from 0."""

    @property
    def face_b(self) -> int:
        """The face of B."""

    @property
    def kind(self) -> IntersectionKind:
        """Point, segment or polygon."""

    @property
    def coplanar(self) -> bool:
        """All six vertices lie in a plane."""

    @property
    def crossing(self) -> bool:
        """They pass through each other."""

    @property
    def point_count(self) -> int:
        """Corners of what they have in common."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class DepthBracket:
    """
    How deep two solids overlap, as narrow as asked, and why the bracket is no narrower.
    """

    @property
    def lower(self) -> float:
        """The exact depth is at least this."""

    @property
    def upper(self) -> float:
        """Moved this far along the direction, B no longer overlaps A."""

    @property
    def direction(self) -> toccata._typing.Floats:
        """Unit vector from A to B; shape (3,)."""

    @property
    def on_a(self) -> toccata._typing.Floats:
        """The deepest point of A within B; shape (3,)."""

    @property
    def on_b(self) -> toccata._typing.Floats:
        """The deepest point of B within A; shape (3,)."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    @property
    def end(self) -> DepthEnd:
        """Why it is no narrower."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

def depth_bracket(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, precision: float = 0.02, time_limit: float = float('inf'), solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> DepthBracket:
    """
    penetration, as narrow as asked: upper <= (1 + precision) * lower, or the bracket tells why not.

    In the unit of the coordinates; direction and points are in the world. time_limit: seconds, after which nothing new is begun;
    the answer depends on the machine then, as nothing else does. Raises Error like penetration, and for a precision or a limit
    that is not above 0.
    """

def depth_bracket_each(a: toccata._typing.ShapesLike, b: toccata._typing.ShapesLike, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, precision: float = 0.02, time_limit: float = float('inf'), solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    depth_bracket of many, in shapes as overlap_each takes them, on all cores: a structured array with the members of DepthBracket, in the unit of the coordinates. The time limit is that of each. Raises Error like depth_bracket, naming the query.
    """

class OverlapVolume:
    """
    How much volume two solids have in common; the exact number lies in [lower, upper].
    """

    @property
    def lower(self) -> float:
        """In the cubed unit of the coordinates."""

    @property
    def upper(self) -> float:
        """The same."""

    @property
    def status(self) -> Status:
        """not_converged: wider than 1e-9 of it."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

def overlap_volume(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> OverlapVolume:
    """
    How much volume two solids have in common, as a bracket that holds the exact number.

    In the third power of the unit of the coordinates. Of closed meshes, boxes and hulls it is as narrow as rounding; of what is
    round some thousandths wide. Signs that are 0 are decided by H. Edelsbrunner, E. P. Mücke, "Simulation of simplicity", 1990.
    Raises Error like overlap, and where one is a surface, and for two half-spaces.
    """

class ModelManifold(Manifold):
    """A Manifold, and the two elements at which each of its points lies."""

    @property
    def elements_a(self) -> toccata._typing.Indices:
        """Of A, of a mesh triangles; shape (count,)."""

    @property
    def elements_b(self) -> toccata._typing.Indices:
        """Of B."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

def manifolds(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> list[ModelManifold]:
    """
    Where any two shapes touch or overlap: of meshes and compounds one manifold for each normal of their contacts.

    What slides over a surface does not catch on its inner edges: normals are of the Voronoi regions of the mesh (M. Lin,
    J. Canny, "A fast algorithm for incremental distance calculation", 1991). In the world and the unit of the coordinates. Empty
    exactly when they are apart, but for two half-spaces and for what lies wholly within where no penetration is defined. Raises
    Error like overlap.
    """

def manifold_each(a: toccata._typing.ShapesLike, b: toccata._typing.ShapesLike, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, threads: int = 0) -> tuple[numpy.typing.NDArray[numpy.int32], toccata._typing.Floats, toccata._typing.Floats, toccata._typing.Floats]:
    """
    manifold of many, in shapes as overlap_each takes them, on all cores: counts (N,), normals (N, 3), positions (N, 4, 3) and depths (N, 4), of which the first `count` of each are points and the others 0; in the unit of the coordinates. Raises Error like manifold, naming the query.
    """

def first_contact(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> Contact | None:
    """
    The least of contacts, without the others; None where there is none. In any unit. Raises Error like overlap.
    """

def distance_within_each(a: toccata._typing.ShapesLike, b: toccata._typing.ShapesLike, max_distance: float, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    distance_within of many, in shapes as overlap_each takes them, on all cores: a structured array with the members of Distance, and found; in the unit of the coordinates. Raises Error like distance_within, naming the query.
    """

def overlap_bodies(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> tuple[list[Mesh], OverlapVolume]:
    """
    What two solids have in common, as closed meshes, and how much volume that is, as overlap_volume tells it.

    In the world, in the unit of the coordinates: one mesh, of compounds one of each two parts that overlap, none where they are
    apart or merely touch. Which parts of each surface lie in the other solid is exact; corners at which surfaces cross are rounded,
    and for round shapes stand polyhedra within. Signs that are 0 are decided by H. Edelsbrunner, E. P. Mücke, "Simulation of
    simplicity", 1990. Raises Error like overlap_volume, and with the reason where a mesh is not proved to be right but for that
    rounding: one of the two passes through itself there, or what they have in common is thinner than coordinates tell.
    """

def faces_in_box(shape: Shape, lower: numpy.typing.ArrayLike, upper: numpy.typing.ArrayLike, pose: toccata._typing.PoseLike | None = None) -> toccata._typing.Answers:
    """
    What of a posed shape has a point in common with a closed box of the world, by its least and its greatest corner.

    Corners of the shape (3,), in the unit of the coordinates. A structured array: element and face, ascending. Exact, touching
    included; of a mesh its triangles are asked about, so a box deep inside finds none. Raises Error when the box is empty or not finite, and for poses as overlap does.
    """

def faces_in_ball(shape: Shape, centre: numpy.typing.ArrayLike, radius: float, pose: toccata._typing.PoseLike | None = None) -> toccata._typing.Answers:
    """
    faces_in_box of a closed ball of the world, its centre of the shape (3,), whose radius may be 0, in the unit of the coordinates. Raises Error when the radius is negative or a number is not finite, and for poses as overlap does.
    """

def faces_in_region_each(shape: Shape, *, boxes: numpy.typing.ArrayLike | None = None, centres: numpy.typing.ArrayLike | None = None, radii: numpy.typing.ArrayLike | None = None, pose: toccata._typing.PoseLike | None = None, threads: int = 0) -> toccata._typing.Answers:
    """
    faces_in_box of many boxes, shape (N, 2, 3), or faces_in_ball of many balls, centres (N, 3) and one radius or N, in the world and the unit of the coordinates, on all cores: one structured array of all, in order, whose field query says of which region a row is. Raises Error like these, naming the region, and for boxes and balls at once.
    """

def nearest_points_each(points: numpy.typing.ArrayLike, k: int, objects: toccata._typing.ObjectsLike, max_distance: float = float('inf'), *, threads: int = 0) -> toccata._typing.Answers:
    """
    Of many points, shape (N, 3), the k nearest elements of all objects together, on all cores: one structured array, the nearest first of each, with query, object and the members of SurfacePoint; in the world and the unit of the coordinates. Raises Error naming the point.
    """

def scene_signed_distance_each(points: numpy.typing.ArrayLike, objects: toccata._typing.ObjectsLike, sign_by: SignBy = SignBy.automatic, *, threads: int = 0) -> toccata._typing.Answers:
    """
    How far many points, shape (N, 3), are from the nearest surface of all objects, negative inside one of them: a structured array with object, whose surface it is, the members of SignedDistance, inside, and inside_of, the first object that the point is inside of; in the world and the unit of the coordinates. Raises Error like signed_distance, naming the point.
    """

class MeshFaultKind(enum.IntEnum):
    """
    What is out of order at a place of a mesh: what MeshHealth counts under the same name.
    """

    boundary_edges = 0

    non_manifold_edges = 1

    flipped_edges = 2

    degenerate_triangles = 3

    duplicate_triangles = 4

    unused_vertices = 5

class MeshFault:
    """
    Faults of one kind that hang together through vertices: the edges around one hole, say. Its length is how many there are.
    """

    @property
    def kind(self) -> MeshFaultKind: ...

    @property
    def edges(self) -> toccata._typing.Indices:
        """By their vertices, shape (N, 2)."""

    @property
    def triangles(self) -> toccata._typing.Indices: ...

    @property
    def vertices(self) -> toccata._typing.Indices: ...

    def __len__(self) -> int: ...

    def __repr__(self) -> str: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

def mesh_faults(mesh: Shape) -> list[MeshFault]:
    """
    Where the faults are that Mesh.health counts: by kind, then the larger first. Their counts add up to what it says. Raises Error for what is no Mesh.
    """

class MeshRepair:
    """What close_mesh has done, counted."""

    @property
    def moved_vertices(self) -> int:
        """Of the boundary, onto another one."""

    @property
    def collapsed_triangles(self) -> int:
        """They are gone."""

    @property
    def filled_holes(self) -> int: ...

    @property
    def added_triangles(self) -> int:
        """Each is a face of its own, after the others."""

    @property
    def open_holes(self) -> int:
        """That are wider, or no simple loop."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

def close_mesh(mesh: Mesh, gap: float) -> tuple[Mesh, MeshRepair]:
    """
    Another mesh with the gaps closed that are no wider than `gap`, in the unit of the coordinates, and what was done: vertices of the boundary within it of each other become one, and holes are filled that are somewhere no wider. What is no boundary stays as it is. Raises Error for what is no Mesh, and when the gap is not positive and finite.
    """

def closing_gap(mesh: Shape) -> float | None:
    """
    A gap by which close_mesh closes the mesh, in the unit of the coordinates, at most twice the least of some that are tried; 0 of a closed one, None where none does. Raises Error for what is no Mesh.
    """

def mesh_parts(mesh: Shape) -> toccata._typing.Indices:
    """
    To which part of the mesh each triangle belongs, shape (M,): triangles are of one where they are connected through vertices, of equal coordinates taken as one. Raises Error for what is no Mesh.
    """

def hull_of_half_spaces(half_spaces: Sequence[HalfSpace]) -> ConvexHull:
    """
    The solid that half-spaces have in common: its vertices are found exactly, and rounded to the nearest doubles, in the unit of the coordinates. It is found in one go: Ctrl-C is taken when it is. Raises Error when they have no point in common, naming at most four that have none, and when it is flat or has no end.
    """

def view_frustum(eye: numpy.typing.ArrayLike, direction: numpy.typing.ArrayLike, up: numpy.typing.ArrayLike = (0.0, 1.0, 0.0), *, field_of_view: float = 60.0, aspect: float = 1.0, nearest: float = 0.1, farthest: float = 1000.0) -> ConvexHull:
    """
    The solid that a camera sees in perspective: field_of_view from the bottom of the picture to its top, in degrees; aspect, its width over its height; nearest and farthest, in the unit of the coordinates. eye, direction and up have the shape (3,), in the world. What it overlaps is in view. Raises Error that names a number out of range.
    """

def load_scene(path: str | os.PathLike[str], unit: str | None = None, *, scale: float = 1.0, split: bool = False) -> list[SceneInstance]:
    """
    The objects of any file that is read, at their places: a mesh file as one, glTF and GLB as the meshes of their node tree, 3MF, and scene files (.json). unit: what a length of 1 in the file is, "mm", "in", or metres, as "0.001"; lengths are metres then. split: the objects of an OBJ file and the solids of a text STL file are each one. Raises Error naming the file and the line.
    """

class RigidMotion:
    """
    How a shape moves, without changing its form, in the time from 0 to 1.

    At the part s of it a world point w is at centre + R(axis, s * turns) (w - centre) + s * translation, where R turns
    counter-clockwise about the axis and 1 is a whole turn; starting from where the shape is under `start`. RigidMotion(pose)
    rests. RigidMotion(pieces=…) is made of what `pieces` tells, whose times go on from each other from 0 to 1; whether their places do is not looked at. Vectors have the shape (3,); lengths are in the unit of the coordinates. Immutable. Raises Error when a number is not
    finite, and for pieces whose times do not.
    """

    @overload
    def __init__(self, start: toccata._typing.PoseLike | None = None, translation: numpy.typing.ArrayLike = (0.0, 0.0, 0.0), turns: float = 0.0, axis: numpy.typing.ArrayLike = (0.0, 0.0, 1.0), centre: numpy.typing.ArrayLike = (0.0, 0.0, 0.0)) -> None: ...

    @overload
    def __init__(self, *, pieces: Sequence[tuple[float, float, toccata._typing.PoseLike | None, tuple[numpy.typing.ArrayLike, numpy.typing.ArrayLike, float, numpy.typing.ArrayLike]]]) -> None: ...

    @staticmethod
    def straight(start: toccata._typing.PoseLike | None, translation: numpy.typing.ArrayLike) -> RigidMotion:
        """
        Straight on from a pose by a translation, shape (3,), in the world and the unit of the coordinates, without a turn. Raises Error when a number is not finite.
        """

    @staticmethod
    def between(start: toccata._typing.PoseLike | None, end: toccata._typing.PoseLike | None, centre: numpy.typing.ArrayLike = (0.0, 0.0, 0.0)) -> RigidMotion:
        """
        From one pose to another: the centre, a point of the shape's own frame, goes straight on, and the shape turns about it the shorter way at an even speed. The centre has the shape (3,), in the unit of the coordinates. Raises Error when no turn leads from one to the other.
        """

    @staticmethod
    def screw(start: toccata._typing.PoseLike | None, end: toccata._typing.PoseLike | None) -> RigidMotion:
        """
        From one pose to another about one axis and along it (M. Chasles, 1830). Raises Error like between.
        """

    @staticmethod
    def through(times: numpy.typing.ArrayLike, poses: toccata._typing.PosesLike, centre: numpy.typing.ArrayLike = (0.0, 0.0, 0.0)) -> RigidMotion:
        """
        Through poses at times, shape (N,), that ascend from 0 to 1, as between each and the next; the centre in the unit of the coordinates. Raises Error like between, and for other times.
        """

    @staticmethod
    def of(pose_at: Callable[[float], toccata._typing.PoseLike], *, speed: float, turns: float = 0.0, centre: numpy.typing.ArrayLike = (0.0, 0.0, 0.0), rounding: float = 0.0) -> RigidMotion:
        """
        Any motion: where the shape is, told by a function of the time from 0 to 1, and what it never exceeds: the speed of the point `centre`, shape (3,), of the shape's own frame, in the unit of the coordinates, and how fast it turns about it, in whole turns; rounding: how far off the function may be. Answers are true of all such motions. The function is asked from any thread, with the interpreter's lock, and has to return the same for the same time; what it raises comes out of the question. Raises Error when a bound is negative or not finite.
        """

    def at(self, time: float) -> Pose:
        """
        The pose at a time from 0 to 1, rounded. Raises Error for another time.
        """

    def carrying(self, fixed: toccata._typing.PoseLike) -> RigidMotion:
        """
        How something moves that is fixed to the shape: placed by a pose in its frame. Raises Error for what is no pose.
        """

    @property
    def pieces(self) -> list[tuple[float, float, Pose, tuple[tuple[float, float, float], tuple[float, float, float], float, tuple[float, float, float]]]]:
        """(begin, end, start, (centre, axis, turns, translation)) of each piece."""

    def __repr__(self) -> str: ...

    def __copy__(self) -> RigidMotion: ...

    def __deepcopy__(self, memo: dict[int, object]) -> RigidMotion: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __hash__(self) -> int: ...

def sweep(a: Shape, motion_a: toccata._typing.MotionLike, b: Shape, motion_b: toccata._typing.MotionLike | None = None, *, stop_before: float = 0.0, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> ShapeHit | None:
    """
    When two shapes that move and turn first meet, as a ShapeHit: times from 0 to 1. None where they do not, which is proved
    for all of the way.

    Motions are RigidMotions, or poses for what rests. stop_before: when they come as near as that, in the unit of the
    coordinates; negative: when they are so deep in each other. By conservative advancement (B. Mirtich, "Impulse-based dynamic
    simulation of rigid body systems", 1996) with bounds of each box of a tree (M. Tang, Y. J. Kim, D. Manocha, "C2A: controlled
    conservative advancement", 2009). Raises Error like cast_shape.
    """

def sweep_each(a: Shape, motions_a: Sequence[RigidMotion], b: Shape, motion_b: toccata._typing.MotionLike | None = None, *, stop_before: float = 0.0, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    sweep of many motions of A, in the unit of the coordinates, on all cores: a structured array with the members of ShapeHit, and found. Raises Error naming the motion.
    """

def swept_volume(shape: Shape, motion: toccata._typing.MotionLike, *, excess: float = 0.0, max_parts: int = 1024, solid: Solid = Solid.automatic) -> tuple[Shape, float]:
    """
    A shape, in the world, that contains all that a body passes, and how far outside of it it reaches at most; both proved. excess: how far it may reach, in the unit of the coordinates, 0: a 32nd of the body's diagonal. Raises Error for a negative excess, and for what has no end.
    """

def vertex_face_impacts(starts: numpy.typing.ArrayLike, ends: numpy.typing.ArrayLike, *, threads: int = 0) -> toccata._typing.Answers:
    """
    When a moving point first meets a moving triangle, exactly, for many: shapes (N, 4, 3), in each the point and the three corners, at the times 0 and 1, in one frame and any unit; they move straight on. A structured array of found, lower and upper, two neighbouring multiples of 2**-40 (the cubic: X. Provot, "Collision and self-collision handling in cloth model dedicated to design garments", 1997). Raises Error for other shapes, and when a number is not finite.
    """

def edge_edge_impacts(starts: numpy.typing.ArrayLike, ends: numpy.typing.ArrayLike, *, threads: int = 0) -> toccata._typing.Answers:
    """
    vertex_face_impacts of two moving segments: shapes (N, 4, 3), in each the ends of one and of the other, in any unit. Raises Error like it.
    """

class FeatureKind(enum.IntEnum):
    """A part of a triangle."""

    vertex = 0

    edge = 1

    face = 2

class MeshImpact:
    """
    Two features of meshes that deform, which meet, and when first: the exact time lies in [lower, upper], two neighbouring multiples of 2**-40, or is both.
    """

    @property
    def kind_a(self) -> FeatureKind:
        """Vertex, edge or face; of the first mesh, or the lesser."""

    @property
    def number_a(self) -> int:
        """The vertex, the edge (DeformingMesh.edges) or the triangle."""

    @property
    def kind_b(self) -> FeatureKind:
        """The same of the other."""

    @property
    def number_b(self) -> int: ...

    @property
    def lower(self) -> float:
        """They do not meet before; from 0 to 1."""

    @property
    def upper(self) -> float:
        """They have met by then; 0: at the start."""

    @property
    def status(self) -> Status:
        """exact without a separation."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class DeformingMesh:
    """
    A mesh over one step, in which every vertex moves straight on: continuous collision of meshes that deform.

    At the time t from 0 to 1 a vertex is at (1 - t) * start + t * end; left out, `end`, shape (N, 3), is where it starts. Questions are asked
    of the mesh with itself, or with `other`; features that have a vertex in common are not asked about. What counts as meeting
    is contact, exactly, or to be at most `separation` apart, in the unit of the coordinates. `starts_free` promises that nothing
    meets at the start, as where a free step ended: then what pierces something there is not looked for, and stays unseen where
    the promise is broken. Answers do not depend on threads. Raises Error for another number of ends than of vertices and for what
    is not finite; questions of times, asked without a separation, also where they find the promise broken, which meets and
    free_steps never do.
    """

    def __init__(self, mesh: Mesh, end: numpy.typing.ArrayLike | None = None, *, threads: int = 1) -> None: ...

    def move_to(self, end: numpy.typing.ArrayLike, *, threads: int = 1) -> None:
        """
        Another end of the same step, shape (N, 3), as when a solver tries a shorter one. No question sees an old box after it. Raises Error for another number of vertices and for one that is not finite; the mesh then stays as it was.
        """

    def advance(self, end: numpy.typing.ArrayLike, *, threads: int = 1) -> None:
        """
        The next step to an end of the shape (N, 3): what was the end is the start. Raises Error like move_to.
        """

    @property
    def start(self) -> toccata._typing.Floats:
        """Where the vertices are at the time 0, shape (N, 3): a new array."""

    @property
    def end(self) -> toccata._typing.Floats:
        """And at the time 1."""

    @property
    def edges(self) -> toccata._typing.Indices:
        """
        Every edge of a triangle once, by its vertices, ascending, shape (E, 2): an edge's number is its row.
        """

    def __repr__(self) -> str: ...

    def meets(self, other: DeformingMesh | None = None, *, separation: float = 0.0, starts_free: bool = False, threads: int = 1) -> bool:
        """Whether any two features meet in the step."""

    def first_impact(self, other: DeformingMesh | None = None, *, separation: float = 0.0, starts_free: bool = False, threads: int = 1) -> MeshImpact | None:
        """
        The first two to meet: the least by (lower, upper, a, b); None is proved.
        """

    def impacts(self, other: DeformingMesh | None = None, *, separation: float = 0.0, starts_free: bool = False, threads: int = 1) -> toccata._typing.Answers:
        """
        All that meet, each two once, in the same order: a structured array with the members of MeshImpact.
        """

    def free_step(self, other: DeformingMesh | None = None, *, separation: float = 0.0, starts_free: bool = False, threads: int = 1) -> tuple[float, MeshImpact | None]:
        """
        The part of the step in which nothing meets, and what ends it: 1 and None where all of it is free. Where the start is not free it is 0 and means nothing.
        """

    def free_steps(self, other: DeformingMesh | None = None, *, separation: float = 0.0, starts_free: bool = False, threads: int = 1) -> tuple[toccata._typing.Floats, toccata._typing.Floats | None]:
        """
        For each vertex a fraction of its own way: however fast each goes, and wherever up to that it stops, nothing meets. Shapes (N,), of this mesh and of the other, or None.
        """

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class BodyType(enum.Enum):
    """Which pairs of bodies are of interest."""

    static_body = 0
    """Part of the surroundings: two such never make a pair."""

    kinematic_body = 1
    """Goes where its owner says, whatever it meets."""

    dynamic_body = 2
    """Reacts to what it meets."""

class BodyId:
    """
    Names a body of a World for as long as it is there, and never another one.
    """

    @property
    def index(self) -> int:
        """Dense; given out again."""

    @property
    def generation(self) -> int:
        """From 1."""

    @property
    def world(self) -> int:
        """From 1; a copy has its original's."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __hash__(self) -> int: ...

class Body:
    """
    A shape at its place in a World, and what is to be told of it.

    Two bodies make a pair only if each is in a category of the other's mask (a bit each), and are one when they are at most the
    sum of their margins apart: lengths in the unit of the coordinates. The pose is in the world. Raises Error for what is no
    pose; the rest is looked at by World.add.
    """

    def __init__(self, shape: Shape, pose: toccata._typing.PoseLike | None = None, *, type: BodyType = BodyType.dynamic_body, solid: Solid = Solid.automatic, category: int = 1, mask: int = 18446744073709551615, margin: float = 0.0, user_data: int = 0, name: str = '') -> None: ...

    @property
    def shape(self) -> Shape: ...

    @property
    def pose(self) -> Pose: ...

    @property
    def type(self) -> BodyType: ...

    @property
    def solid(self) -> Solid: ...

    @property
    def category(self) -> int: ...

    @property
    def mask(self) -> int: ...

    @property
    def margin(self) -> float: ...

    @property
    def user_data(self) -> int: ...

    @property
    def name(self) -> str: ...

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class BodyFilter:
    """Which bodies of a World are asked. Raises Error for what is no BodyId."""

    def __init__(self, *, mask: int = 18446744073709551615, category: int = 0, except_bodies: toccata._typing.BodiesLike | None = None) -> None:
        """
        Those that are in one of the categories of the mask (a bit each); with a category, of them those whose own mask has it; and none of except_bodies.
        """

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class WorldPairs:
    """
    Pairs of bodies that a step found, ascending, and what was asked to be told of them. Where an array has a field pair, that counts the rows of pairs. Lengths are in the unit of the coordinates.
    """

    def __len__(self) -> int: ...

    @property
    def pairs(self) -> toccata._typing.Answers:
        """
        A structured array: a, b (each with index, generation, world), in_contact.
        """

    @property
    def relations(self) -> toccata._typing.Answers:
        """pair and the members of Relation, if asked for."""

    @property
    def distances(self) -> toccata._typing.Answers:
        """pair and the members of Distance, if asked for."""

    @property
    def penetrations(self) -> toccata._typing.Answers:
        """pair and the members of Penetration, if asked for."""

    @property
    def first_contacts(self) -> toccata._typing.Answers:
        """
        pair and the members of ShapeHit, of those that met on the way of a body (World.move_along).
        """

    @property
    def contacts(self) -> toccata._typing.Answers:
        """pair and the fields of contacts, if asked for."""

    def manifold(self, pair: int) -> Manifold | None:
        """
        Its manifold, if asked for and defined, in the world. Raises Error for a number that no pair has.
        """

    def __repr__(self) -> str: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class WorldStep:
    """What a step of a World found; it stays as it is."""

    @property
    def begin(self) -> WorldPairs:
        """Pairs that were not there at the step before."""

    @property
    def persist(self) -> WorldPairs:
        """Pairs that were there at both, told as they are now."""

    @property
    def end(self) -> WorldPairs:
        """Pairs that were there at the step before only, told as they were then."""

    @property
    def candidates(self) -> int:
        """How many pairs had to be decided."""

    @property
    def asked(self) -> int:
        """How many of them could not be taken over from the step before."""

    def __repr__(self) -> str: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class BodyRayHit:
    """What a ray meets first."""

    @property
    def body(self) -> BodyId:
        """Of which body."""

    @property
    def lower(self) -> float:
        """The exact fraction of the way is at least this."""

    @property
    def upper(self) -> float:
        """The exact fraction of the way is at most this; from 0 to 1."""

    @property
    def point(self) -> toccata._typing.Floats:
        """Where, in the world; shape (3,)."""

    @property
    def normal(self) -> toccata._typing.Floats:
        """Unit, against the ray; zero where it starts inside. Shape (3,)."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    @property
    def element(self) -> int:
        """The element, of a mesh the triangle."""

    @property
    def face(self) -> int:
        """The face, as its file counts them from 0."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class BodyShapeHit:
    """Where a moving shape first meets another."""

    @property
    def body(self) -> BodyId:
        """Of which body."""

    @property
    def lower(self) -> float:
        """The exact fraction of the way is at least this."""

    @property
    def upper(self) -> float:
        """The exact fraction of the way is at most this; from 0 to 1."""

    @property
    def point(self) -> toccata._typing.Floats:
        """Where they meet then, in the world; shape (3,)."""

    @property
    def normal(self) -> toccata._typing.Floats:
        """Unit, from B to A, which moves; shape (3,)."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    @property
    def element_a(self) -> int:
        """The element of A, of a mesh the triangle."""

    @property
    def element_b(self) -> int:
        """The element of B."""

    @property
    def face_a(self) -> int:
        """The face of A, as its file counts them from 0."""

    @property
    def face_b(self) -> int:
        """The face of B."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class BodyDistance:
    """
    How far apart two posed shapes are, in the unit of the coordinates: the exact distance lies in [lower, upper], whose width is at most 1e-12 of upper. Both are 0 when they meet.
    """

    @property
    def body(self) -> BodyId:
        """Of which body."""

    @property
    def lower(self) -> float:
        """The exact distance is at least this."""

    @property
    def upper(self) -> float:
        """The exact distance is at most this; 0 when the shapes meet."""

    @property
    def on_a(self) -> toccata._typing.Floats:
        """The nearest point of A, in the world; shape (3,)."""

    @property
    def on_b(self) -> toccata._typing.Floats:
        """The nearest point of B, in the world; shape (3,)."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    @property
    def element_a(self) -> int:
        """The element of A, of a mesh the triangle."""

    @property
    def element_b(self) -> int:
        """The element of B."""

    @property
    def face_a(self) -> int:
        """The face of A, as its file counts them from 0."""

    @property
    def face_b(self) -> int:
        """The face of B."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class World:
    """
    Bodies that move, and the pairs of them that are in contact or near, step by step.

    The options say what is told of every pair, besides that it is one; each costs what the question of that name costs.
    kinematic_pairs: whether two kinematic bodies, and a kinematic and a static one, make pairs. space_time: pairs that cannot
    meet for some steps are not looked at in these. Which pairs is exact, and the same on any number of threads. Questions
    about the bodies where they are now need no step; `only` is a BodyFilter. Lengths are in the unit of the coordinates. A World
    may be used from many threads, one after the other. Raises Error for a broad phase that there is not.
    """

    def __init__(self, *, relation: bool = False, distance: bool = False, contacts: bool = False, manifold: bool = False, penetration: bool = False, kinematic_pairs: bool = True, space_time: bool = False, broad_phase: str = 'auto', threads: int = 1) -> None: ...

    @overload
    def add(self, body: Body) -> BodyId: ...

    @overload
    def add(self, shape: Shape, pose: toccata._typing.PoseLike | None = None, *, type: BodyType = BodyType.dynamic_body, solid: Solid = Solid.automatic, category: int = 1, mask: int = 18446744073709551615, margin: float = 0.0, user_data: int = 0, name: str = '') -> BodyId:
        """
        The id given to a body: one made before, or of a shape at a pose. Raises Error for a margin that is no length and for a pose that its shape may not have. The pose is in the world, the margin in the unit of the coordinates.
        """

    def add_each(self, shapes: toccata._typing.ShapesLike, poses: toccata._typing.PosesLike | None = None, margins: numpy.typing.ArrayLike = 0.0, *, type: BodyType = BodyType.dynamic_body, solid: Solid = Solid.automatic, category: int = 1, mask: int = 18446744073709551615) -> toccata._typing.Answers:
        """
        Adds one shape at many poses, or as many shapes, with one margin or as many, shape (N,), in the unit of the coordinates; the array of their ids (index, generation, world), in order. Raises Error like add.
        """

    def remove(self, bodies: toccata._typing.BodiesLike) -> None:
        """
        Removes bodies, with their rules. Raises Error naming an id that is of no body here.
        """

    def replace(self, id: BodyId, body: Body) -> None:
        """
        Makes a body into another one, all of it; its id and rules stay. Raises Error like add, and naming an id that is of no body here.
        """

    def move(self, bodies: toccata._typing.BodiesLike, poses: toccata._typing.PosesLike) -> None:
        """
        Gives bodies other poses in the world, however far: as many poses as bodies, or one. Raises Error as add does, and naming an id that is of no body here.
        """

    def place(self, body: BodyId, matrix: toccata._typing.PoseLike | None) -> None:
        """
        move of one body to a pose that is told as a matrix, shape (4, 4): the quickest way for who moves them one by one. Raises Error like move, and for another shape.
        """

    def move_along(self, bodies: toccata._typing.BodiesLike, motions: RigidMotion | Sequence[RigidMotion]) -> None:
        """
        Lets bodies go along motions in the time of the next step, which also finds every pair that meets on the way: nothing tunnels. A body goes from where its motion begins, wherever it was before: what lies between these two is passed over. Raises Error like move.
        """

    def set_rule(self, a: BodyId, b: BodyId, *, excluded: bool = False, margin: float | None = None) -> None:
        """
        What is said about two bodies in particular: that they never make a pair, or another margin than the sum of theirs, in the unit of the coordinates. A rule that says nothing ends an earlier one. Raises Error naming an id that is of no body here, and for a margin that is no length.
        """

    def exclude(self, a: toccata._typing.BodiesLike, b: toccata._typing.BodiesLike) -> None:
        """
        Pairs (a[i], b[i]) that are never told: an allowed-collision list, as arrays of ids, shape (N,). Raises Error naming an id that is of no body here.
        """

    def step(self) -> WorldStep:
        """
        Finds the pairs of the bodies as they are now: which begin, persist and end. Exact, without the lock. Ctrl-C ends it between two pairs, and the World is then as if it had not begun.
        """

    @property
    def pairs(self) -> WorldPairs:
        """All pairs of the last step."""

    def any_overlap(self) -> bool:
        """
        Whether any two bodies have a point in common where they are now, whatever their types, categories, margins and rules. Exact; needs no step, and stops at the first two that it finds.
        """

    def any_contact(self) -> tuple[BodyId, BodyId] | None:
        """
        The least pair of bodies that have a point in common where they are now, by their indices, of those that make pairs; None is proved. Margins do not matter. Needs no step.
        """

    def any_within(self, max_distance: float) -> tuple[BodyId, BodyId] | None:
        """
        any_contact of pairs that are at most so far apart, in the unit of the coordinates, decided exactly. Raises Error for what is no length.
        """

    def least_distance(self, max_distance: float = float('inf')) -> tuple[BodyId, BodyId, Distance] | None:
        """
        The nearest two of the bodies that make pairs, and their distance as of A and B in this order, in the unit of the coordinates; None where none is within the greatest distance. Raises Error for one that is no length.
        """

    def __len__(self) -> int: ...

    @property
    def bodies(self) -> toccata._typing.Answers:
        """The ids of all, ascending: a structured array."""

    def __contains__(self, id: object, /) -> bool: ...

    def __getitem__(self, id: BodyId) -> Body:
        """The body as it is now."""

    @property
    def boxes(self) -> toccata._typing.Floats:
        """
        By index, the boxes around all bodies without their margins, shape (N, 2, 3): a new array. Where no body has that index, the lower corner is +inf and the upper one -inf.
        """

    @property
    def poses(self) -> toccata._typing.Floats:
        """
        By index, where the bodies are in the world, shape (N, 4, 4): a new array. Where no body has that index, all numbers are NaN.
        """

    def __copy__(self) -> World: ...

    def __deepcopy__(self, memo: dict[int, object]) -> World: ...

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def cast_ray(self, origin: numpy.typing.ArrayLike, motion: numpy.typing.ArrayLike, *, only: object | None = None) -> BodyRayHit | None:
        """
        The first of all that the ray from origin to origin + motion meets, both of the shape (3,) in the world, or None, which is proved. As cast_ray of one shape, in the unit of the coordinates. Raises Error like it.
        """

    def cast_ray_through(self, origin: numpy.typing.ArrayLike, motion: numpy.typing.ArrayLike, *, only: object | None = None) -> toccata._typing.Answers:
        """
        Where the ray from origin to origin + motion, both of the shape (3,) in the world, meets each of them first, in order: a structured array with the members of what cast_ray returns, in the unit of the coordinates. Raises Error like cast_ray.
        """

    def cast_ray_each(self, origins: numpy.typing.ArrayLike, motions: numpy.typing.ArrayLike, *, only: object | None = None, threads: int = 0) -> toccata._typing.Answers:
        """
        cast_ray of many rays, shapes (N, 3), on all cores: a structured array with the members of what cast_ray returns, and found; in the unit of the coordinates. Raises Error like cast_ray, naming the ray.
        """

    def cast_shape(self, shape: Shape, motion: numpy.typing.ArrayLike, pose: toccata._typing.PoseLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None) -> BodyShapeHit | None:
        """
        The first of all that the shape, which is A, meets on its way from its pose by motion, shape (3,) in the world, or None, which is proved. As cast_shape of two, in the unit of the coordinates. Raises Error like it.
        """

    def cast_shape_each(self, shapes: toccata._typing.ShapesLike, motions: numpy.typing.ArrayLike, poses: toccata._typing.PosesLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None, threads: int = 0) -> toccata._typing.Answers:
        """
        cast_shape of many motions, shape (N, 3), of one shape or N, at one pose or N, on all cores: a structured array with the members of what cast_shape returns, and found; in the unit of the coordinates. Raises Error like cast_shape, naming the query.
        """

    def overlapping(self, shape: Shape, pose: toccata._typing.PoseLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None) -> toccata._typing.Answers:
        """
        Which of them have a point in common with the shape at its pose in the world, ascending. Exact, in any unit. Raises Error like overlap.
        """

    def relations(self, shape: Shape, pose: toccata._typing.PoseLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None) -> toccata._typing.Answers:
        """
        overlapping, and how: the shape is A. A structured array with the members of Relation and which it is, in any unit. Raises Error like overlap.
        """

    def within(self, shape: Shape, max_distance: float, pose: toccata._typing.PoseLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None) -> toccata._typing.Answers:
        """
        Which of them are at most so far from the shape at its pose, in the unit of the coordinates, ascending. Decided exactly. Raises Error like within_distance.
        """

    def overlapping_each(self, shapes: toccata._typing.ShapesLike, poses: toccata._typing.PosesLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None, threads: int = 0) -> toccata._typing.Answers:
        """
        overlapping of one shape or N, at one pose or N, on all cores: one structured array of all that was found, in order, whose field query says of which question a row is. In any unit. Raises Error like overlap, naming the query.
        """

    def within_each(self, shapes: toccata._typing.ShapesLike, max_distance: float, poses: toccata._typing.PosesLike | None = None, *, solid: Solid = Solid.automatic, only: object | None = None, threads: int = 0) -> toccata._typing.Answers:
        """
        within of one shape or N, at one pose or N, on all cores, in the unit of the coordinates: a structured array as that of overlapping_each. Raises Error like within_distance, naming the query.
        """

    def nearest(self, shape: Shape, pose: toccata._typing.PoseLike | None = None, max_distance: float = float('inf'), *, solid: Solid = Solid.automatic, only: object | None = None) -> BodyDistance | None:
        """
        The nearest of all to the shape, which is A, as distance tells it of two, in the unit of the coordinates; None where none is within the greatest distance, which is decided exactly. Raises Error like distance, and for a greatest distance that is negative.
        """

    def nearest_each(self, shapes: toccata._typing.ShapesLike, poses: toccata._typing.PosesLike | None = None, max_distance: float = float('inf'), *, solid: Solid = Solid.automatic, only: object | None = None, threads: int = 0) -> toccata._typing.Answers:
        """
        nearest of one shape or N, at one pose or N, on all cores: a structured array with the members of what nearest returns, and found; in the unit of the coordinates. Raises Error like nearest, naming the query.
        """

    def move_character(self, shape: Shape, start: BodyMoverState, motion: numpy.typing.ArrayLike, options: MoverOptions = ..., *, only: BodyFilter | None = None, moved: Sequence[tuple[BodyId, toccata._typing.PoseLike | None]] | None = None) -> BodyMoverStep:
        """
        One step of a character: a convex shape goes from a state by `motion`, shape (3,) in the world and the unit of the coordinates, as far as these objects let it, and slides along what it meets; nothing tunnels, which is proved. On ground a motion that has no part along `up` is walked, over slopes, up and down steps. `moved` tells what was elsewhere before the step: pairs (object, pose before). Raises Error when a number is not finite, the shape is of another kind, or an object is not here.
        """

class BodyMoverContact:
    """Something that a character stands on, or met on its way."""

    @property
    def object(self) -> BodyId:
        """Which."""

    @property
    def element(self) -> int:
        """The element, of a mesh the triangle."""

    @property
    def point(self) -> toccata._typing.Floats:
        """The nearest of the object, shape (3,)."""

    @property
    def normal(self) -> toccata._typing.Floats:
        """Unit, from there to the shape; shape (3,)."""

    def __repr__(self) -> str: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class BodyMoverState:
    """
    Where a character is: all that is known of it from one step to the next. Its pose is in the world. Raises Error for what is no pose.
    """

    def __init__(self, pose: toccata._typing.PoseLike | None = None, ground: BodyMoverContact | None = None) -> None: ...

    @property
    def pose(self) -> Pose:
        """Of the shape; a step changes its offset alone."""

    @property
    def ground(self) -> BodyMoverContact | None:
        """What it stands on; None: it is in the air."""

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class BodyMoverStep:
    """What came of a step of a character."""

    @property
    def state(self) -> BodyMoverState:
        """Where it is now."""

    @property
    def moved(self) -> toccata._typing.Floats:
        """By how much in all, shape (3,)."""

    @property
    def carried(self) -> toccata._typing.Floats:
        """By how much of it on or by objects that moved."""

    @property
    def pushed_out(self) -> toccata._typing.Floats:
        """And out of what it began in."""

    @property
    def contacts(self) -> list[BodyMoverContact]:
        """Met by its own motion, in the order in which they were."""

    @property
    def met_wall(self) -> bool:
        """One of them is too steep to be walked on."""

    @property
    def met_ceiling(self) -> bool:
        """One faces down as ground faces up."""

    @property
    def stepped(self) -> bool:
        """Up a step."""

    @property
    def tight(self) -> bool:
        """It is still nearer to something than it stays."""

    @property
    def stuck(self) -> bool:
        """It still overlaps something: there was no way out."""

    @property
    def crushed(self) -> bool:
        """Something that moved its way could not push it aside."""

    @property
    def cut_short(self) -> bool:
        """It may not have gone as far as it can; the contacts tell why."""

    def __repr__(self) -> str: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

def overlapping_pairs(boxes: numpy.typing.ArrayLike, *, method: str = 'auto', threads: int = 0) -> toccata._typing.Indices:
    """
    Which of many boxes overlap, touching included: shape (N, 2, 3), of each the least corner and the greatest. Pairs of indices, shape (K, 2), ascending. In the world and any unit. All methods ('auto', 'brute-force', 'sort-and-sweep' …) find the same. Raises Error naming a box of which a side is no number.
    """

class BroadPhase:
    """
    Boxes that move, and the pairs of them that overlap; touching counts.

    Boxes have the shape (N, 2, 3), in the world and any unit, and numbers that stay theirs until they are removed. One thread
    uses it at a time. Raises Error for a method that there is not.
    """

    def __init__(self, *, method: str = 'auto', threads: int = 1) -> None: ...

    def add(self, boxes: numpy.typing.ArrayLike) -> toccata._typing.Indices:
        """
        The numbers given to the boxes, shape (N, 2, 3), in their order. Raises Error naming a box of which a side is no number.
        """

    def remove(self, numbers: numpy.typing.ArrayLike) -> None:
        """
        Removes boxes by their numbers, shape (N,). Raises Error naming a number that is in use no more.
        """

    def move(self, numbers: numpy.typing.ArrayLike, boxes: numpy.typing.ArrayLike) -> None:
        """
        Gives box numbers[i] the place boxes[i], shapes (N,) and (N, 2, 3). Raises Error like add and remove.
        """

    def update(self) -> toccata._typing.Indices:
        """
        The pairs of the boxes as they are now, shape (K, 2), ascending. Ctrl-C is taken when they are found.
        """

    def changes(self) -> tuple[toccata._typing.Indices, toccata._typing.Indices]:
        """
        Pairs that the last update found and the one before did not, and the reverse.
        """

    @property
    def method(self) -> str:
        """That of the last update, never 'auto'."""

    def __len__(self) -> int: ...

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

class ConvexPart:
    """A convex part of a mesh."""

    @property
    def hull(self) -> ConvexHull: ...

    @property
    def volume(self) -> float:
        """Of the hull, rounded."""

    @property
    def concavity(self) -> float:
        """No point of the hull is farther than this from the solid; proved."""

    @property
    def concavity_found(self) -> float:
        """Some point of the hull is as far as this, at least."""

    @property
    def faces(self) -> toccata._typing.Indices:
        """
        Of the mesh, ascending: those that the part has more than the border of.
        """

    def __repr__(self) -> str: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class ConvexParts:
    """Convex parts whose union contains a solid."""

    def __len__(self) -> int: ...

    @property
    def parts(self) -> list[ConvexPart]:
        """By falling volume."""

    @property
    def mesh_volume(self) -> float:
        """Of the solid, rounded."""

    @property
    def hull_volume(self) -> float:
        """Of all hulls."""

    @property
    def excess(self) -> float:
        """hull_volume - mesh_volume."""

    @property
    def concavity(self) -> float:
        """The greatest of all parts."""

    def compound(self) -> Compound:
        """
        The parts as one shape, for questions that are to be about them and not about the mesh.
        """

    def __repr__(self) -> str: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

def decompose(mesh: Shape, *, max_parts: int = 32, concavity: float = 0.0, threads: int = 1) -> ConvexParts:
    """
    Convex parts whose union contains the solid that a closed mesh encloses; that is proved.

    It stops cutting at max_parts, or where no part is farther than the concavity (in the unit of the mesh) from the solid
    (J.-M. Lien, N. M. Amato, "Approximate convex decomposition of polyhedra", 2007). The same on any number of threads. Ctrl-C
    ends it. Raises Error for what is no closed mesh, and for a limit out of range.
    """

class RobotJointKind(enum.Enum):
    """How a link moves against the one that it hangs on."""

    fixed = 0
    """Not at all; no position."""

    revolute = 1
    """Turns about its axis within limits; one position, in radians."""

    continuous = 2
    """The same without limits."""

    prismatic = 3
    """Slides along its axis; one position, a length."""

    planar = 4
    """Slides across its axis and turns about it: x, y and turn."""

    floating = 5
    """
    Freely: x, y, z, then roll, pitch and yaw about the fixed axes x, y and z.
    """

class RobotJoint:
    """
    How one link of a robot hangs on another, as in URDF.

    origin: where the child is in the parent's frame at the position 0, a rotation and a translation. axis: shape (3,), in the
    child's frame. limits: (lower, upper) of the position, radians or a length in the unit of the coordinates (URDF: metres).
    mimic: (joint, multiplier, offset), whose position it follows. Raises Error for what is no pose and no axis; what is wrong
    among joints is told by Robot.
    """

    def __init__(self, name: str, kind: RobotJointKind, parent: str, child: str, origin: toccata._typing.PoseLike | None = None, axis: numpy.typing.ArrayLike = (1.0, 0.0, 0.0), limits: tuple[float, float] | None = None, mimic: tuple[str, float, float] | None = None) -> None: ...

    @property
    def name(self) -> str: ...

    @property
    def kind(self) -> RobotJointKind: ...

    @property
    def parent(self) -> str:
        """A link, by name."""

    @property
    def child(self) -> str:
        """A link, by name."""

    @property
    def origin(self) -> Pose: ...

    @property
    def axis(self) -> toccata._typing.Floats: ...

    @property
    def limits(self) -> tuple[float, float] | None: ...

    @property
    def mimic(self) -> tuple[str, float, float] | None: ...

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class RobotPosition:
    """One of the numbers that a configuration is made of."""

    @property
    def name(self) -> str:
        """The joint's; of a planar or floating one with "/x", "/y", …"""

    @property
    def joint(self) -> int:
        """The number of the joint."""

    @property
    def turns(self) -> bool:
        """It is in radians; else a length."""

    @property
    def limits(self) -> tuple[float, float] | None: ...

    def __repr__(self) -> str: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class Robot:
    """
    A tree of links and joints. Immutable.

    Robot(links, joints): links are names with the shapes of each, as SceneInstance takes them, in the link's frame; base is
    where the root link is in the world. attached: what it holds, (name, shapes, link, pose, touch_links) of each, as with_attached
    takes them. Configurations are arrays of a number for each of `positions`, in radians where it
    turns and in the unit of the lengths where it slides (URDF: metres). Raises Error naming the link or joint: no tree, two of
    one name, an axis or a number that is not finite, limits the wrong way round.
    """

    def __init__(self, links: dict[str, toccata._typing.ObjectsLike], joints: Sequence[RobotJoint] = (), name: str = '', base: toccata._typing.PoseLike | None = None, attached: Sequence[tuple[str, toccata._typing.ObjectsLike, str, toccata._typing.PoseLike | None, Sequence[str]]] = ()) -> None: ...

    @staticmethod
    def from_urdf(path: str | os.PathLike[str], packages: Sequence[str | os.PathLike[str]] = ()) -> Robot:
        """
        Of a URDF file, with its meshes. package://name/path is looked for in `packages`, which are folders, before the folders that the file lies in. Lengths are metres. Raises Error naming the file, line and element, and for xacro, which is to be expanded first; warns of sizes that look like another unit, of glTF, whose y axis points up, and of links that have a picture alone.
        """

    @staticmethod
    def generated(subdivisions: int = 3, seed: int = 1) -> Robot:
        """
        An arm of seven joints with a mesh of 20 · 4^subdivisions triangles for each link, 1.3 long: to try things with.
        """

    def write_urdf(self, folder: str | os.PathLike[str]) -> None:
        """
        Writes folder/robot.urdf, and every mesh beside it as an OBJ file. Raises Error naming the file that holds something else already, and the link whose shape URDF has not.
        """

    def with_attached(self, name: str, shape: Shape, link: str, pose: toccata._typing.PoseLike | None = None, touch_links: Sequence[str] = ()) -> Robot:
        """
        A robot that holds a shape too: a link more, fixed to `link` at a pose in its frame, in the unit of the robot. It may touch that link and those that are named. Positions stay as they are. Raises Error for links that there are not.
        """

    def __copy__(self) -> Robot: ...

    def __deepcopy__(self, memo: dict[int, object]) -> Robot: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __hash__(self) -> int: ...

    @property
    def name(self) -> str:
        """As its file has it."""

    @property
    def links(self) -> list[str]:
        """Their names; a link's number is its place here."""

    @property
    def joints(self) -> list[RobotJoint]:
        """In order."""

    @property
    def positions(self) -> list[RobotPosition]:
        """
        What a configuration is made of, in the order of the joints; those that mimic have none.
        """

    @property
    def limits(self) -> toccata._typing.Floats:
        """
        The least and the greatest of each position, shape (P, 2); infinite: none.
        """

    def link_of(self, name: str) -> int:
        """The number of a link. Raises Error with what may have been meant."""

    def __repr__(self) -> str: ...

    def rest(self) -> toccata._typing.Floats:
        """All positions 0, or the middle of limits that exclude 0; shape (P,)."""

    def sampled(self, count: int, seed: int = 1) -> toccata._typing.Floats:
        """
        Random configurations within the limits, shape (count, P), in radians and the unit of the lengths; the same for the same seed.
        """

    def read_configurations(self, path: str | os.PathLike[str]) -> toccata._typing.Floats:
        """
        Of a file with a line of numbers for each, by commas or blanks, and names before them or the order of the positions: shape (N, P). Raises Error naming the file and the line.
        """

    def beyond_limits(self, configuration: numpy.typing.ArrayLike) -> int | None:
        """
        The first position of a configuration, shape (P,), that is beyond its limits, or None. Other questions do not look at limits. Raises Error for another shape, and when a number is not finite.
        """

    def link_poses(self, configuration: numpy.typing.ArrayLike) -> toccata._typing.Floats:
        """
        Where the links are in the world at a configuration, shape (P,): matrices, shape (L, 4, 4). Raises Error for another shape, and when a number is not finite.
        """

    def link_poses_each(self, configurations: numpy.typing.ArrayLike, *, threads: int = 0) -> toccata._typing.Floats:
        """
        link_poses of many, shape (N, P), on all cores: matrices in the world, shape (N, L, 4, 4). Raises Error naming the configuration.
        """

    def posed(self, configuration: numpy.typing.ArrayLike) -> list[SceneInstance]:
        """
        The shapes of the links where a configuration, shape (P,), puts them in the world, with names: for show, check_all and SceneIndex. Raises Error like link_poses.
        """

    def srdf_pairs(self, path: str | os.PathLike[str]) -> list[tuple[str, str, str]]:
        """
        The pairs of links that an SRDF file disables, for RobotScene(allowed=…): (a, b, "given"). Raises Error naming the file and the line.
        """

    def adjacent_pairs(self) -> list[tuple[str, str, str]]:
        """
        Links with shapes that are joined by a joint, or by joints and links without shapes.
        """

    def allowed_pairs(self, samples: int = 10000, seed: int = 1, *, threads: int = 0) -> list[tuple[str, str, str]]:
        """
        Pairs of links that need not be looked at, by samples, for RobotScene(allowed=…): (a, b, reason), where the reason is adjacent, always, at rest, or never, which is no proof.
        """

class RobotContact:
    """
    A link and what it meets: another link, or an obstacle. RobotScene.names tells them.
    """

    @property
    def link(self) -> int:
        """The number of the link."""

    @property
    def with_obstacle(self) -> bool:
        """The other is an obstacle, and else a link."""

    @property
    def other(self) -> int:
        """The number of the other, as a link the greater."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class RobotDistance:
    """
    The least of the distances of all pairs that are looked at: the exact one lies in [lower, upper], in the unit of the coordinates, both 0 where they meet. A is the link.
    """

    @property
    def link(self) -> int:
        """The number of the link."""

    @property
    def with_obstacle(self) -> bool:
        """The other is an obstacle, and else a link."""

    @property
    def other(self) -> int:
        """The number of the other, as a link the greater."""

    @property
    def lower(self) -> float:
        """The exact distance is at least this."""

    @property
    def upper(self) -> float:
        """The exact distance is at most this; 0 when the shapes meet."""

    @property
    def on_a(self) -> toccata._typing.Floats:
        """The nearest point of A, in the world; shape (3,)."""

    @property
    def on_b(self) -> toccata._typing.Floats:
        """The nearest point of B, in the world; shape (3,)."""

    @property
    def status(self) -> Status:
        """How far the answer can be trusted."""

    @property
    def element_a(self) -> int:
        """The element of A, of a mesh the triangle."""

    @property
    def element_b(self) -> int:
        """The element of B."""

    @property
    def face_a(self) -> int:
        """The face of A, as its file counts them from 0."""

    @property
    def face_b(self) -> int:
        """The face of B."""

    @property
    def body(self) -> int:
        """Which shape of the robot, of all."""

    @property
    def other_body(self) -> int:
        """Which the other is, of a link; of an obstacle 0."""

    @property
    def gradient(self) -> toccata._typing.Floats:
        """
        How it changes with each position, per radian or per length, by the nearest points; shape (P,), all 0 where they meet. Where several pairs of points are nearest it is that of this pair.
        """

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class RobotEdge:
    """
    What happens on the straight way from one configuration to another, in the time from 0 to 1. Where it is not free, RobotScene.names tells which two meet first.
    """

    @property
    def is_free(self) -> bool:
        """Proved for every moment."""

    @property
    def lower(self) -> float:
        """Nothing is met before, which is proved."""

    @property
    def upper(self) -> float:
        """The first contact is here at the latest; 1 if free."""

    @property
    def status(self) -> Status:
        """
        exact: at `upper` they meet; undecided: they come nearer than can be told.
        """

    @property
    def link(self) -> int:
        """The number of the link."""

    @property
    def with_obstacle(self) -> bool:
        """The other is an obstacle, and else a link."""

    @property
    def other(self) -> int:
        """The number of the other, as a link the greater."""

    def __repr__(self) -> str: ...

    def __eq__(self, other: builtins.object, /) -> bool: ...

    def __getstate__(self) -> tuple[builtins.object, ...]: ...

    def __setstate__(self, arg: tuple[builtins.object, ...], /) -> None: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    __hash__: ClassVar[None]  # type: ignore[assignment]

class RobotScene:
    """
    A robot among obstacles, made ready for questions. Immutable.

    What is said of a configuration is what overlap and distance say of the shapes at the places of Robot.posed, pair by pair:
    exactly, on meshes too. Obstacles are SceneInstances, shapes, or pairs (shape, pose). Pairs of names in `allowed` are not
    looked at, nor, with allow_adjacent, links that a joint joins, nor what an attached object may touch. Answers do not depend
    on threads. Lengths are in the unit of the coordinates (URDF: metres). Raises Error for names that there are not, and naming
    the obstacle that cannot be posed so.
    """

    def __init__(self, robot: Robot, obstacles: toccata._typing.ObjectsLike = (), *, allowed: toccata._typing.AllowedPairs | None = None, allow_adjacent: bool = True) -> None: ...

    @property
    def robot(self) -> Robot: ...

    @property
    def obstacles(self) -> list[SceneInstance]:
        """In their order: their numbers are their places here."""

    def names(self, answer: RobotContact | RobotDistance | RobotEdge | numpy.void) -> tuple[str, str]:
        """
        What the two of an answer, or of a row of an array of answers, are called: a link, and a link or an obstacle. Raises Error for an answer of another scene.
        """

    def looks_at(self, link: int, other: int, with_obstacle: bool = False) -> bool:
        """
        Whether these two, told by their numbers, are looked at: two links in either order, or a link and an obstacle. Raises Error for a number that there is not.
        """

    def __repr__(self) -> str: ...

    def __copy__(self) -> RobotScene: ...

    def __deepcopy__(self, memo: dict[int, object]) -> RobotScene: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

    def meets(self, configuration: numpy.typing.ArrayLike) -> bool:
        """
        Does any pair that is looked at have a point in common, at a configuration, shape (P,)? Exact. Raises Error for another shape, and when a number is not finite.
        """

    def meets_each(self, configurations: numpy.typing.ArrayLike, *, threads: int = 0) -> toccata._typing.Booleans:
        """
        meets of many, shape (N, P), on all cores: an array of bools, shape (N,). Raises Error naming the configuration.
        """

    def contacts(self, configuration: numpy.typing.ArrayLike) -> list[RobotContact]:
        """
        Which links meet which others at a configuration, shape (P,); ascending. Exact. Raises Error like meets.
        """

    def contacts_each(self, configurations: numpy.typing.ArrayLike, *, threads: int = 0) -> toccata._typing.Answers:
        """
        contacts of many, shape (N, P), on all cores: one structured array of all, in order, with the members of RobotContact and query, which says of which configuration a row is. Raises Error naming the configuration.
        """

    def distance(self, configuration: numpy.typing.ArrayLike, max_distance: float = float('inf')) -> RobotDistance | None:
        """
        The least distance of all pairs that are looked at, at a configuration, shape (P,), with its gradient, in the unit of the coordinates; None where there is none within the greatest distance. Raises Error like meets, and for a greatest distance that is negative.
        """

    def distance_each(self, configurations: numpy.typing.ArrayLike, max_distance: float = float('inf'), *, threads: int = 0) -> toccata._typing.Answers:
        """
        distance of many, shape (N, P), on all cores: a structured array with the members of RobotDistance, the gradient of the shape (P,), and found; in the unit of the coordinates. Raises Error naming the configuration.
        """

    def edge(self, begin: numpy.typing.ArrayLike, end: numpy.typing.ArrayLike, precision: float = 9.5367431640625e-07) -> RobotEdge:
        """
        The straight way from one configuration to another, shapes (P,): free at every moment, or when which two first meet, as a part of the way, told within the precision, a part too (conservative advancement: B. Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996). Raises Error like meets, and for a precision below 2**-40 or above 1.
        """

    def edge_each(self, begins: numpy.typing.ArrayLike, ends: numpy.typing.ArrayLike, precision: float = 9.5367431640625e-07, *, threads: int = 0) -> toccata._typing.Answers:
        """
        edge of many, shapes (N, P), on all cores: a structured array with the members of RobotEdge. Raises Error naming the configuration.
        """

    def free_each(self, begins: numpy.typing.ArrayLike, ends: numpy.typing.ArrayLike, precision: float = 9.5367431640625e-07, *, threads: int = 0) -> toccata._typing.Booleans:
        """
        Only whether each edge, by its ends of the shapes (N, P), is free, which is quicker, on all cores: an array of bools, shape (N,). Raises Error like edge_each.
        """

def point_cloud(points: numpy.typing.ArrayLike, radius: float, name: str = 'cloud') -> SceneInstance:
    """
    A point cloud as an obstacle: a ball of this radius around each point, shape (N, 3), in the world and the unit of the coordinates. Raises Error without a point, and for a radius that is not positive.
    """

def voxel_map(middles: numpy.typing.ArrayLike, edge: float, name: str = 'voxels') -> SceneInstance:
    """
    The occupied cells of a voxel map or an octree, all of one size, as an obstacle: a cube of this edge around each middle, shape (N, 3), in the world and the unit of the coordinates. Raises Error like point_cloud.
    """

def generated_room(boxes: int = 100, meshes: bool = True, seed: int = 1) -> list[SceneInstance]:
    """
    What stands around Robot.generated(), in its unit: boxes that are turned any way, and three meshes. Raises Error for more than a million boxes.
    """

class DistanceCache:
    """
    What is kept of one question of distance for the next about the same two meshes, which have moved little in between. It changes no bit of any answer. It belongs to the first two meshes asked about. Lengths are in the unit of the coordinates (what holds for a while: J. Basch, J. Erickson, L. Guibas, J. Hershberger, L. Zhang, "Kinetic collision detection between two simple polygons", 1999).
    """

    def __init__(self) -> None: ...

    def distance(self, a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> Distance:
        """
        What distance answers, to the last bit, in the unit of the coordinates. Raises Error like it, and for another mesh than the first time.
        """

    def clear(self) -> None:
        """Forgets everything, also which meshes it was used for."""

    @property
    def questions(self) -> int:
        """How many were asked with it."""

    @property
    def searches(self) -> int:
        """Of them, those that were searched as without a cache."""

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple[builtins.object, ...]: ...

def view_page(objects: toccata._typing.ObjectsLike, *, title: str = 'Toccata', up: str = 'z', faces: bool = True, penetration: bool = True, clearance: float | None = None, threads: int = 0) -> str:
    """
    One self-contained HTML page that shows posed shapes and what check_all finds of them.

    It opens from disk in any browser with WebGL 2. up: the axis that points up, 'y' or 'z'. faces: which faces meet, and in what
    curves; penetration: how deep; clearance: how far apart, in the unit of the coordinates. Raises Error like check_all, and for
    another axis.
    """

def write_view_page(page: str, path: str | os.PathLike[str]) -> None:
    """
    Writes a page: the file is complete or not there. Raises Error naming the file when it exists and was not written by Toccata, or cannot be written.
    """

from ._show import Page as Page, show as show

__all__: list[str] = ['Body', 'BodyDistance', 'BodyFilter', 'BodyId', 'BodyMoverContact', 'BodyMoverState', 'BodyMoverStep', 'BodyRayHit', 'BodyShapeHit', 'BodyType', 'Box', 'BroadPhase', 'Capsule', 'CheckAnswer', 'ClashKind', 'ClashPiercing', 'ClashTolerance', 'Compound', 'Cone', 'Contact', 'Containment', 'ConvexHull', 'ConvexPart', 'ConvexParts', 'Cylinder', 'DeformingMesh', 'DepthBracket', 'DepthEnd', 'Distance', 'DistanceCache', 'Ellipsoid', 'Error', 'FeatureKind', 'HalfSpace', 'HeightField', 'IntersectionKind', 'Manifold', 'Mesh', 'MeshFault', 'MeshFaultKind', 'MeshHealth', 'MeshImpact', 'MeshRepair', 'ModelManifold', 'MoverOptions', 'OverlapVolume', 'Penetration', 'Point', 'Pose', 'RayHit', 'Relation', 'RelationKind', 'RigidMotion', 'Robot', 'RobotContact', 'RobotDistance', 'RobotEdge', 'RobotJoint', 'RobotJointKind', 'RobotPosition', 'RobotScene', 'Rounded', 'SceneDistance', 'SceneIndex', 'SceneInstance', 'SceneMoverContact', 'SceneMoverState', 'SceneMoverStep', 'SceneRayHit', 'SceneShapeHit', 'Segment', 'Shape', 'ShapeHit', 'Side', 'SignBy', 'SignedDistance', 'Solid', 'Sphere', 'Status', 'SurfacePoint', 'Triangle', 'WindingNumber', 'World', 'WorldPairs', 'WorldStep', 'cast_ray', 'cast_ray_each', 'cast_shape', 'cast_shape_each', 'check_all', 'close_mesh', 'closing_gap', 'contact_regions', 'contact_regions_each', 'contacts', 'contacts_each', 'contacts_with_points', 'count_contacts_each', 'decompose', 'depth_bracket', 'depth_bracket_each', 'distance', 'distance_each', 'distance_within', 'distance_within_each', 'edge_edge_impacts', 'faces_in_ball', 'faces_in_box', 'faces_in_region_each', 'first_contact', 'generalized_winding_number', 'generalized_winding_number_each', 'generate_mesh', 'generated_room', 'hull_of_half_spaces', 'load_mesh', 'load_scene', 'locate', 'manifold', 'manifold_each', 'manifolds', 'mesh_faults', 'mesh_parts', 'nearest_point', 'nearest_point_each', 'nearest_points', 'nearest_points_each', 'overlap', 'overlap_bodies', 'overlap_each', 'overlap_volume', 'overlapping_pairs', 'penetration', 'penetration_each', 'point_cloud', 'relation', 'relation_each', 'scene_signed_distance_each', 'self_contacts', 'self_contacts_each', 'self_overlap', 'signed_distance', 'signed_distance_each', 'sweep', 'sweep_each', 'swept_volume', 'velocity_along', 'vertex_face_impacts', 'view_frustum', 'view_page', 'voxel_map', 'within_distance', 'within_distance_each', 'write_view_page', 'Page', 'show', '__version__']

__version__: str
