"""What trimesh's tests share, as far as those of collisions need it: their own file is not among the published sources,
and neither are their models, so these are made."""

import logging
import unittest

import numpy as np
import trimesh

__all__ = ["get_mesh", "log", "np", "random", "trimesh", "unittest"]

log = logging.getLogger("trimesh")


def random(shape: tuple) -> np.ndarray:
    return np.random.default_rng(0).random(shape)


def get_mesh(name: str) -> object:
    if name == "unit_cube.STL":
        return trimesh.creation.box()
    if name == "cycloidal.3DXML":  # parts that meet, in a scene
        parts = [trimesh.creation.cylinder(radius=1, height=1, sections=30).apply_translation((i, 0, 0)) for i in range(8)]
        return trimesh.Scene(parts)
    raise FileNotFoundError(name)
