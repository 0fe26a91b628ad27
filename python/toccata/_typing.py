"""What questions take and answer, for type checkers."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias, Union

import numpy
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from . import BodyId, Pose, RigidMotion, SceneInstance, Shape

Floats: TypeAlias = NDArray[numpy.float64]
Indices: TypeAlias = NDArray[numpy.uint32]
Booleans: TypeAlias = NDArray[numpy.bool_]
# A structured array: a field for each member of the answer.
Answers: TypeAlias = NDArray[numpy.void]


class HasMatrix(Protocol):
    """Rotations and transforms of scipy."""

    def as_matrix(self) -> Any: ...


class HasVerticesAndFaces(Protocol):
    """Meshes of trimesh and others."""

    @property
    def vertices(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


PoseLike: TypeAlias = Union["Pose", ArrayLike, HasMatrix, tuple[Union[ArrayLike, HasMatrix], ArrayLike]]
# One for all, or a list of them; of many rotations and translations also the two arrays.
PosesLike: TypeAlias = Union[PoseLike, Sequence[Union["Pose", ArrayLike, HasMatrix, tuple[Union[ArrayLike, HasMatrix], ArrayLike], None]]]
ShapesLike: TypeAlias = Union["Shape", Sequence["Shape"]]
ObjectsLike: TypeAlias = Iterable[Union["SceneInstance", "Shape", tuple["Shape", Union[PoseLike, None]]]]
MotionLike: TypeAlias = Union["RigidMotion", PoseLike]
BodiesLike: TypeAlias = Union["BodyId", Sequence["BodyId"], Answers]
# Pairs of names, as an answer of Robot.allowed_pairs has them, with a reason, or without.
AllowedPairs: TypeAlias = Iterable[Union[tuple[str, str], tuple[str, str, str]]]
