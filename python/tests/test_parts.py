"""Broad phases, convex parts, caches: what is used by itself."""

import numpy
import pytest

import toccata
from conftest import matrices


def boxes(count: int, seed: int) -> numpy.ndarray:
    rng = numpy.random.default_rng(seed)
    lower = rng.uniform(-5, 5, (count, 3))
    return numpy.stack([lower, lower + rng.uniform(0, 2, (count, 3))], axis=1)


def brute_force(given: numpy.ndarray) -> list:
    meets = (given[:, None, 0] <= given[None, :, 1]).all(-1)
    meets &= meets.T
    return [[int(i), int(j)] for i, j in zip(*numpy.nonzero(numpy.triu(meets, 1)))]


@pytest.mark.parametrize("method", ["auto", "brute-force", "sort-and-sweep", "r-tree"])
def test_pairs_of_boxes(method):
    given = boxes(150, 3)
    assert toccata.overlapping_pairs(given, method=method).tolist() == brute_force(given)
    phase = toccata.BroadPhase(method=method)
    numbers = phase.add(given)
    assert phase.update().tolist() == brute_force(given) and phase.method != "auto"
    moved = boxes(150, 4)
    phase.move(numbers[:75], moved[:75])
    now = numpy.concatenate([moved[:75], given[75:]])
    before, after = brute_force(given), brute_force(now)
    assert phase.update().tolist() == after
    begin, end = phase.changes()
    assert begin.tolist() == [p for p in after if p not in before] and end.tolist() == [p for p in before if p not in after]
    phase.remove(numbers[:75])
    assert phase.update().tolist() == [[i + 75, j + 75] for i, j in brute_force(given[75:])]


def test_what_is_no_box():
    for wrong in (numpy.zeros((3, 6)), [[[0, 0, 0], [numpy.nan, 1, 1]]], [[[1, 0, 0], [0, 1, 1]]], "boxes"):
        with pytest.raises(toccata.Error):
            toccata.overlapping_pairs(wrong)
    with pytest.raises(toccata.Error, match="did you mean|known are"):
        toccata.overlapping_pairs(boxes(3, 1), method="best")
    assert toccata.overlapping_pairs(numpy.zeros((0, 2, 3))).shape == (0, 2)


def test_convex_parts_contain_the_solid():
    ring = toccata.generate_mesh("torus")
    parts = toccata.decompose(ring, max_parts=6)
    assert 2 <= len(parts) == len(parts.parts) <= 6
    assert parts.excess == pytest.approx(parts.hull_volume - parts.mesh_volume) and parts.excess > 0
    compound = parts.compound()
    assert len(compound.parts) == len(parts)
    for point in ring.vertices[::37]:
        assert toccata.overlap(toccata.Point(point), compound)
    assert sum(len(part.faces) for part in parts.parts) >= ring.face_count
    assert all(part.concavity_found <= part.concavity and isinstance(part.hull, toccata.ConvexHull) for part in parts.parts)
    for wrong in (toccata.Sphere(1), toccata.Mesh(ring.vertices, ring.faces[1:])):
        with pytest.raises(toccata.Error):
            toccata.decompose(wrong)


def test_a_cache_changes_no_bit(knot):
    cache = toccata.DistanceCache()
    for x in numpy.linspace(3, 4, 40):
        pose = (x, 0.3, 0)
        assert cache.distance(knot, knot, pose_b=pose) == toccata.distance(knot, knot, pose_b=pose)
    assert cache.questions == 40 and cache.searches < 40
    with pytest.raises(toccata.Error):
        cache.distance(toccata.generate_mesh("torus"), knot)
    cache.clear()
    assert cache.distance(toccata.generate_mesh("torus"), knot, pose_b=matrices(1, 9, 1)[0]).upper >= 0
