"""
Exact collision detection: do these shapes touch, how far apart are they, how deep do they overlap, what is hit first?

Shapes are made once and asked about under any pose; `overlap(a, b, pose_b=matrix)` answers one question, `overlap_each(a,
b, poses_b=matrices)` many, on all cores. Numbers have no unit: lengths come back in that of what was given. Every yes or no
is exact, and every length an interval that contains the exact one. What is asked wrongly raises `toccata.Error`, a
ValueError that says what to do. See docs/guide/python.md.
"""

from collections.abc import Iterable
import enum
from typing import overload

import numpy.typing

import toccata._typing


class Error(ValueError):
    pass

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
        """Moves by (x, y, z), in the unit of the coordinates."""

    @staticmethod
    def rotation(axis: numpy.typing.ArrayLike, degrees: float) -> Pose:
        """
        Turns counter-clockwise about an axis through the origin, shape (3,), of any length but 0. Quarter turns about coordinate axes are exact.
        """

    @staticmethod
    def from_quaternion(quaternion: numpy.typing.ArrayLike, translation: numpy.typing.ArrayLike = (0.0, 0.0, 0.0)) -> Pose:
        """
        Of a quaternion in the order x, y, z, w, as scipy and ROS have it; trimesh's has w first. It need not have length 1.
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
        Where the pose brings a point, shape (3,), or points, shape (N, 3). Rounded as the truth page says (docs/truth.md).
        """

    def __mul__(self, inner: Pose) -> Pose:
        """The inner pose first, then this one; rounded."""

    def __matmul__(self, inner: Pose) -> Pose:
        """The same as *."""

    def __eq__(self, other: object, /) -> bool: ...

    def __hash__(self) -> int: ...

    def __repr__(self) -> str: ...

    def __array__(self, dtype: object | None = None, copy: object | None = None) -> toccata._typing.Floats:
        """What numpy.asarray makes of it: the matrix."""

    def __getstate__(self) -> tuple: ...

    def __setstate__(self, arg: tuple, /) -> None: ...

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

    def __eq__(self, other: object, /) -> bool: ...

    def __getstate__(self) -> tuple: ...

    def __setstate__(self, arg: tuple, /) -> None: ...

    __hash__: None = None

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

    def __copy__(self) -> Shape: ...

    def __deepcopy__(self, memo: dict[int, object]) -> Shape: ...

    def __eq__(self, other: object, /) -> bool: ...

class Point(Shape):
    """One point: a surface. Raises Error when a number is not finite."""

    def __init__(self, position: numpy.typing.ArrayLike = (0.0, 0.0, 0.0)) -> None: ...

    @property
    def position(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple: ...

class Segment(Shape):
    """
    A segment between two points: a surface. Raises Error when a number is not finite.
    """

    def __init__(self, start: numpy.typing.ArrayLike, end: numpy.typing.ArrayLike) -> None: ...

    @property
    def start(self) -> toccata._typing.Floats: ...

    @property
    def end(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple: ...

class Triangle(Shape):
    """
    A triangle, which may be a segment or a point: a surface. Vertices of the shape (3, 3), in any unit. Raises Error when a number is not finite.
    """

    def __init__(self, vertices: numpy.typing.ArrayLike) -> None: ...

    @property
    def vertices(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple: ...

    __hash__: None = None

class Sphere(Shape):
    """
    A solid ball. Its pose may not deform it. Raises Error when the radius is not positive.
    """

    def __init__(self, radius: float, centre: numpy.typing.ArrayLike = (0.0, 0.0, 0.0)) -> None: ...

    @property
    def radius(self) -> float: ...

    @property
    def centre(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple: ...

class Box(Shape):
    """
    A solid box along the axes of its own frame; half extents from the centre to the faces. Raises Error when one is not positive.
    """

    def __init__(self, half_extents: numpy.typing.ArrayLike, centre: numpy.typing.ArrayLike = (0.0, 0.0, 0.0)) -> None: ...

    @property
    def half_extents(self) -> toccata._typing.Floats: ...

    @property
    def centre(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple: ...

class Capsule(Shape):
    """
    All points within the radius of a segment. Its pose may not deform it. Raises Error when the radius is not positive.
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

    def __reduce__(self) -> tuple: ...

class HalfSpace(Shape):
    """
    All that lies on the side of a plane away from the normal, which may have any length but 0: solid, and without end. Its pose may not deform it.
    """

    def __init__(self, point: numpy.typing.ArrayLike, normal: numpy.typing.ArrayLike) -> None: ...

    @property
    def point(self) -> toccata._typing.Floats: ...

    @property
    def normal(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple: ...

class Cylinder(Shape):
    """
    A solid cylinder around the z axis from -half_height to half_height. Raises Error when a number is not positive.
    """

    def __init__(self, radius: float, half_height: float) -> None: ...

    @property
    def radius(self) -> float: ...

    @property
    def half_height(self) -> float: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple: ...

class Cone(Shape):
    """
    A solid cone around the z axis, its base at -half_height and its tip at half_height. Raises Error when a number is not positive.
    """

    def __init__(self, radius: float, half_height: float) -> None: ...

    @property
    def radius(self) -> float: ...

    @property
    def half_height(self) -> float: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple: ...

class Ellipsoid(Shape):
    """
    A solid ellipsoid around the origin, its half axes along the axes. Raises Error when one is not positive.
    """

    def __init__(self, half_axes: numpy.typing.ArrayLike) -> None: ...

    @property
    def half_axes(self) -> toccata._typing.Floats: ...

    def __repr__(self) -> str: ...

    def __hash__(self) -> int: ...

    def __reduce__(self) -> tuple: ...

class ConvexHull(Shape):
    """
    The convex hull of points of the shape (N, 3), in any unit; exact (C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The quickhull algorithm for convex hulls", 1996). It may be flat, and is a surface then. Raises Error when there is no point, or one is not finite.
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

    def __reduce__(self) -> tuple: ...

    __hash__: None = None

class Rounded(Shape):
    """
    A point, segment, triangle, box or convex hull grown by a ball: all points within the radius of it. Its pose may not deform it. Raises Error when the radius is not positive.
    """

    def __init__(self, core: Shape, radius: float) -> None: ...

    @property
    def core(self) -> Shape:
        """The shape within."""

    @property
    def radius(self) -> float: ...

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple: ...

    __hash__: None = None

class HeightField(Shape):
    """
    A surface above a grid in the x-y plane: the vertex of row j and column i is (i * spacing[0], j * spacing[1], heights[j, i]). Heights of the shape (rows, columns), at least two of each. Raises Error when a number is not finite, or a spacing is not positive.
    """

    def __init__(self, heights: numpy.typing.ArrayLike, spacing: numpy.typing.ArrayLike = (1.0, 1.0)) -> None: ...

    @property
    def heights(self) -> toccata._typing.Floats:
        """Shape (rows, columns): a new array."""

    @property
    def spacing(self) -> tuple[float, float]: ...

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple: ...

    __hash__: None = None

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
        Gives the mesh other vertices, as many as before, shape (N, 3): the boxes of its tree are put around them, and no question sees old ones. Copies, and scenes and worlds that hold the mesh, keep what they have. Raises Error for another number of vertices and where one is not finite; the mesh then stays as it was.
        """

    def write(self, path: str) -> None:
        """
        Writes OBJ, OFF, STL or PLY by the extension, so that the same numbers are read back.
        """

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple: ...

    __hash__: None = None

def load_mesh(path: str) -> Mesh:
    """
    Reads a mesh from an OBJ, STL, PLY or OFF file: every number as its nearest double, nothing repaired. Raises Error naming file and line.
    """

def generate_mesh(name: str, **parameters: float) -> Mesh:
    """
    A mesh by the name of its generator, such as 'torus-knot', 'gear' or 'noise-sphere', with its parameters (docs/guide/generated-meshes.md): the same bits everywhere. Raises Error for an unknown name.
    """

class Compound(Shape):
    """
    The union of shapes, each a shape or a pair (shape, pose); solid if all parts are. Raises Error when there is none, and for a pose that is not finite.
    """

    def __init__(self, parts: Iterable[Shape | tuple[Shape, toccata._typing.PoseLike | None]]) -> None: ...

    @property
    def parts(self) -> list[tuple[Shape, Pose]]:
        """Pairs (shape, pose)."""

    def __repr__(self) -> str: ...

    def __reduce__(self) -> tuple: ...

    __hash__: None = None

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

class IntersectionKind(enum.IntEnum):
    """What two triangles have in common."""

    none = 0

    point = 1

    segment = 2

    polygon = 3
    """They are coplanar and overlap."""

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

    def __eq__(self, other: object, /) -> bool: ...

    def __getstate__(self) -> tuple: ...

    def __setstate__(self, arg: tuple, /) -> None: ...

    __hash__: None = None

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

    def __eq__(self, other: object, /) -> bool: ...

    def __getstate__(self) -> tuple: ...

    def __setstate__(self, arg: tuple, /) -> None: ...

    __hash__: None = None

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

    def __eq__(self, other: object, /) -> bool: ...

    def __getstate__(self) -> tuple: ...

    def __setstate__(self, arg: tuple, /) -> None: ...

    __hash__: None = None

class ShapeHit:
    """
    Where a moving shape first meets another. True in a condition exactly when something is met.
    """

    @property
    def hit(self) -> bool:
        """Something is met; that nothing is met is proved."""

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

    def __eq__(self, other: object, /) -> bool: ...

    def __getstate__(self) -> tuple: ...

    def __setstate__(self, arg: tuple, /) -> None: ...

    __hash__: None = None

    def __bool__(self) -> bool: ...

def overlap(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> bool:
    """
    Have the two posed shapes a point in common? Exact; touching counts, and a shape inside a solid.

    Of cylinders, cones and ellipsoids a no is proved, and what is undecided counts as yes. Raises Error when a pose is not
    finite, or one that its shape may not have, and when an open mesh is asked about as a solid.
    """

def relation(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> Relation:
    """
    How the two posed shapes lie, exactly: apart, touching, overlapping or crossing, and which contains the other. Raises Error like overlap.
    """

def distance(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> Distance:
    """
    How far the two posed shapes are apart, certified: an interval that contains the exact distance, and the nearest points.

    0 when they meet, also when one lies within a solid. In the unit of the coordinates. Raises Error like overlap.
    """

def within_distance(a: Shape, b: Shape, tolerance: float, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> bool:
    """
    Is the exact distance at most the tolerance, in the unit of the coordinates? Decided exactly, and for less than the distance costs. Raises Error like overlap, and for a negative tolerance.
    """

def distance_within(a: Shape, b: Shape, limit: float, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> Distance | None:
    """
    What distance answers where it is at most the limit, else None, which is found out without it.
    """

def penetration(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> Penetration:
    """
    How deep two solids overlap, as an interval, and a short way to part them.

    Of convex shapes narrow; of meshes and compounds the bracket holds as well, and may be wide. In the unit of the
    coordinates. Raises Error like overlap, and where it is not defined: for surfaces, open meshes, two half-spaces.
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

def manifold(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> Manifold:
    """
    Where two convex shapes, or one and a half-space, touch or overlap: up to four points and a normal.

    Empty exactly when they are apart. Raises Error where it is not defined, as of meshes: there is one for each contact.
    """

def contacts(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 1) -> toccata._typing.Answers:
    """
    All pairs of triangles, or of other elements, that have a point in common; exact and in order.

    A structured array: triangle_a, triangle_b, face_a, face_b, kind (IntersectionKind), coplanar, crossing, point_count. A
    shape inside a solid mesh that does not touch its surface has none: ask relation. Raises Error like overlap.
    """

def contacts_with_points(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 1) -> toccata._typing.Answers:
    """
    The same, with the points in which the triangles meet.

    The array has a field more, points of the shape (6, 3): of each row the first point_count points are the corners of what
    the triangles have in common, in the world, every number the nearest double; the others are 0. Where a shape is no mesh
    there are none: ask manifold.
    """

def self_contacts(mesh: Shape, pose: toccata._typing.PoseLike | None = None) -> toccata._typing.Answers:
    """
    Where a mesh intersects itself: pairs of its triangles that have more in common than the corners they share. A structured array as of contacts, with triangle_a the lesser. Exact. Raises Error for what is no mesh.
    """

def self_overlap(mesh: Shape, pose: toccata._typing.PoseLike | None = None) -> bool:
    """Whether a mesh intersects itself. Exact."""

def cast_shape(a: Shape, motion: numpy.typing.ArrayLike, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic) -> ShapeHit:
    """
    Where A, moved from its pose by motion (shape (3,), in the world) without turning, first meets B, which stands.

    lower and upper are fractions of the way, from 0 to 1. That nothing is met is proved. Raises Error like overlap, and where
    it is not defined, as of two half-spaces.
    """

def cast_shape_each(a: Shape, motions: numpy.typing.ArrayLike, b: Shape, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    cast_shape of many motions, shape (N, 3), and poses, N or one of each: a structured array with the members of ShapeHit.
    """

def overlap_each(a: Shape, b: Shape, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Booleans:
    """
    overlap for many poses, on all cores: a bool for each.

    Poses are N matrices of the shape (N, 4, 4) or (N, 3, 4), N translations (N, 3), N poses of scipy or toccata, or one for
    all. Entry i is what overlap answers for pose i, whatever the number of threads. Raises Error naming the least query that
    is asked wrongly.
    """

def relation_each(a: Shape, b: Shape, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    relation for many poses, on all cores: a structured array with the members of Relation, kind and containment as numbers of their enumerations.
    """

def distance_each(a: Shape, b: Shape, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    distance for many poses, on all cores: a structured array with the members of Distance.
    """

def within_distance_each(a: Shape, b: Shape, tolerance: float, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Booleans:
    """within_distance for many poses, on all cores: a bool for each."""

def penetration_each(a: Shape, b: Shape, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    penetration for many poses, on all cores: a structured array with the members of Penetration.
    """

def count_contacts_each(a: Shape, b: Shape, poses_a: toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    How many triangles and faces meet, for many poses: a structured array with triangle_pairs and face_pairs.
    """

class RayHit:
    """
    What a ray meets first. True in a condition exactly when something is met.
    """

    @property
    def hit(self) -> bool:
        """Something is met; that nothing is met is proved."""

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

    def __eq__(self, other: object, /) -> bool: ...

    def __getstate__(self) -> tuple: ...

    def __setstate__(self, arg: tuple, /) -> None: ...

    __hash__: None = None

    def __bool__(self) -> bool: ...

class SurfacePoint:
    """
    The point of a surface that is nearest to a given one. True in a condition exactly when one was found.
    """

    @property
    def found(self) -> bool:
        """There is one within the greatest distance."""

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

    def __eq__(self, other: object, /) -> bool: ...

    def __getstate__(self) -> tuple: ...

    def __setstate__(self, arg: tuple, /) -> None: ...

    __hash__: None = None

    def __bool__(self) -> bool: ...

def nearest_point(point: numpy.typing.ArrayLike, surface: Shape, pose: toccata._typing.PoseLike | None = None, max_distance: float = float('inf')) -> SurfacePoint:
    """
    The nearest point of the surface of a posed shape, also from within.

    The point has the shape (3,), in the world. Nothing farther than max_distance is found, but for 1e-12 of it. Raises Error
    when a number is not finite, the greatest distance is negative, and for poses as overlap does.
    """

def nearest_points(point: numpy.typing.ArrayLike, k: int, surface: Shape, pose: toccata._typing.PoseLike | None = None, max_distance: float = float('inf')) -> toccata._typing.Answers:
    """
    The nearest points of the k nearest elements, the nearest first: a structured array with the members of SurfacePoint.
    """

def nearest_point_each(points: numpy.typing.ArrayLike, surface: Shape, pose: toccata._typing.PoseLike | None = None, max_distance: float = float('inf'), *, threads: int = 0) -> toccata._typing.Answers:
    """
    nearest_point of many points, shape (N, 3), on all cores: a structured array with the members of SurfacePoint.
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

    def __eq__(self, other: object, /) -> bool: ...

    def __getstate__(self) -> tuple: ...

    def __setstate__(self, arg: tuple, /) -> None: ...

    __hash__: None = None

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

    def __eq__(self, other: object, /) -> bool: ...

    def __getstate__(self) -> tuple: ...

    def __setstate__(self, arg: tuple, /) -> None: ...

    __hash__: None = None

def signed_distance(point: numpy.typing.ArrayLike, shape: Shape, pose: toccata._typing.PoseLike | None = None, sign_by: SignBy = SignBy.automatic) -> SignedDistance:
    """
    How far a point is from the surface of a posed shape, negative inside.

    The side is exact of closed meshes and of shapes that are none; of an open mesh it is that of the generalised winding
    number (A. Jacobson and others, 2013). In the unit of the coordinates. Raises Error when a number is not finite, or an open
    mesh is asked by SignBy.winding_number.
    """

def signed_distance_each(points: numpy.typing.ArrayLike, shape: Shape, pose: toccata._typing.PoseLike | None = None, sign_by: SignBy = SignBy.automatic, *, threads: int = 0) -> toccata._typing.Answers:
    """
    signed_distance of many points, shape (N, 3), on all cores: a structured array with the members of SignedDistance.
    """

def locate(point: numpy.typing.ArrayLike, solid: Shape, pose: toccata._typing.PoseLike | None = None) -> tuple[Side, int]:
    """
    Where a point lies relative to a closed mesh, exactly, and how often the surface winds around it. Raises Error for an open mesh.
    """

def generalized_winding_number(point: numpy.typing.ArrayLike, mesh: Shape, pose: toccata._typing.PoseLike | None = None, tolerance: float = 0.01) -> WindingNumber:
    """
    How much of the sphere of directions around a point a mesh covers: about 1 inside, 0 outside, and between where holes are. Off by at most the tolerance, as an interval. Raises Error for what is no mesh.
    """

def generalized_winding_number_each(points: numpy.typing.ArrayLike, mesh: Shape, pose: toccata._typing.PoseLike | None = None, tolerance: float = 0.01, *, threads: int = 0) -> toccata._typing.Answers:
    """
    The same of many points, shape (N, 3), on all cores: a structured array with the members of WindingNumber.
    """

def cast_ray(origin: numpy.typing.ArrayLike, motion: numpy.typing.ArrayLike, target: Shape, pose: toccata._typing.PoseLike | None = None, *, solid: Solid = Solid.automatic) -> RayHit:
    """
    Where the ray from origin to origin + motion first meets the posed shape; both of the shape (3,), in the world.

    lower and upper are fractions of the way, from 0 to 1: a ray ends at origin + motion. No ray passes between two triangles
    that share an edge. A solid is met at once from within; Solid.none asks its surface. Raises Error when a number is not
    finite or the motion is zero.
    """

def cast_ray_each(origins: numpy.typing.ArrayLike, motions: numpy.typing.ArrayLike, target: Shape, pose: toccata._typing.PoseLike | None = None, *, solid: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers:
    """
    cast_ray of many rays, origins and motions of the shape (N, 3), on all cores: a structured array with the members of RayHit.
    """

__all__: list = ['Box', 'Capsule', 'Compound', 'Cone', 'Containment', 'ConvexHull', 'Cylinder', 'Distance', 'Ellipsoid', 'Error', 'HalfSpace', 'HeightField', 'IntersectionKind', 'Manifold', 'Mesh', 'MeshHealth', 'Penetration', 'Point', 'Pose', 'RayHit', 'Relation', 'RelationKind', 'Rounded', 'Segment', 'Shape', 'ShapeHit', 'Side', 'SignBy', 'SignedDistance', 'Solid', 'Sphere', 'Status', 'SurfacePoint', 'Triangle', 'WindingNumber', 'cast_ray', 'cast_ray_each', 'cast_shape', 'cast_shape_each', 'contacts', 'contacts_with_points', 'count_contacts_each', 'distance', 'distance_each', 'distance_within', 'generalized_winding_number', 'generalized_winding_number_each', 'generate_mesh', 'load_mesh', 'locate', 'manifold', 'nearest_point', 'nearest_point_each', 'nearest_points', 'overlap', 'overlap_each', 'penetration', 'penetration_each', 'relation', 'relation_each', 'self_contacts', 'self_overlap', 'signed_distance', 'signed_distance_each', 'within_distance', 'within_distance_each', '__version__']

__version__: str
