"""Exact collision detection: do these shapes touch, how far apart are they, how deep do they overlap, what is hit first?

Shapes are made once and asked about under any pose; `overlap(a, b, pose_b=matrix)` answers one question, `overlap_each(a,
b, poses_b=matrices)` many, on all cores. Numbers have no unit: lengths come back in that of what was given. Every yes or no
is exact, and every length an interval that contains the exact one. What is asked wrongly raises `toccata.Error`, a
ValueError that says what to do. Many posed shapes are a SceneIndex, or a World when they move. `toccata.trimesh` and
`toccata.fcl` stand in for trimesh's collision manager and for python-fcl. See docs/guide/python.md.
"""

import copyreg

from . import _core
from ._core import *  # noqa: F403
from ._core import __version__
from ._show import Page, show

# So that a function is handed to another process by its name, as those of Python are.
copyreg.pickle(type(_core.overlap), lambda function: function.__name__)

Page.__module__ = show.__module__ = "toccata"
__all__ = sorted(name for name in vars(_core) if not name.startswith("_")) + ["Page", "show", "__version__"]
