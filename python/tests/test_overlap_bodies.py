"""What two solids have in common, as closed meshes."""

import numpy
import pytest

import toccata

BOX, BALL = toccata.Box((1, 1, 1)), toccata.Sphere(0.5)


def enclosed(mesh):
    a, b, c = (mesh.vertices[mesh.faces[:, corner]] for corner in range(3))
    return numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6


def test_of_two_boxes_it_is_the_box_in_which_they_are_both():
    (mesh,), volume = toccata.overlap_bodies(BOX, BOX, pose_b=(1.5, 0.5, 0))
    assert isinstance(mesh, toccata.Mesh) and mesh.closed
    assert mesh.vertices.min(axis=0).tolist() == [0.5, -0.5, -1] and mesh.vertices.max(axis=0).tolist() == [1, 1, 1]
    assert volume.lower <= 0.5 * 1.5 * 2 <= volume.upper and volume == toccata.overlap_volume(BOX, BOX, pose_b=(1.5, 0.5, 0))
    assert enclosed(mesh) == pytest.approx(1.5, rel=1e-12)
    (turned,), _ = toccata.overlap_bodies(BOX, BOX, pose_a=(1.5, 0.5, 0))
    assert enclosed(turned) == pytest.approx(1.5, rel=1e-12)


def test_of_meshes_it_has_the_volume_of_the_bracket():
    knot = toccata.generate_mesh("torus-knot")
    (mesh,), volume = toccata.overlap_bodies(knot, BOX, pose_b=(0.5, 0.25, 0.125))
    assert mesh.closed and len(mesh.faces) > 100
    assert volume.lower * (1 - 1e-9) <= enclosed(mesh) <= volume.upper * (1 + 1e-9)


def test_what_is_round_is_told_by_polyhedra_within():
    (mesh,), volume = toccata.overlap_bodies(BALL, BOX)
    assert 0.9 * volume.upper < enclosed(mesh) <= volume.upper


def test_of_a_compound_there_is_one_for_each_part():
    pair = toccata.Compound([BOX, (BOX, (5, 0, 0))])
    meshes, _ = toccata.overlap_bodies(pair, toccata.Box((4, 0.5, 0.5)), pose_b=(2.5, 0, 0))
    assert len(meshes) == 2 and sum(map(enclosed, meshes)) == pytest.approx(4, rel=1e-12)


def test_what_is_apart_or_merely_touches_has_none():
    for x in (2, 5):
        meshes, volume = toccata.overlap_bodies(BOX, BOX, pose_b=(x, 0, 0))
        assert meshes == [] and volume.upper < 1e-15


def test_what_has_no_body_is_refused_with_the_reason():
    flat = toccata.Triangle([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    ground = toccata.HalfSpace((0, 0, 0), (0, 0, 1))
    for a, b, reason in ((BOX, flat, "is taken as a surface"), (ground, ground, "two half-spaces"), (flat, BOX, "is taken as a surface")):
        with pytest.raises(toccata.Error, match=reason):
            toccata.overlap_bodies(a, b)
    with pytest.raises(toccata.Error, match="thinner|passes through itself"):
        loop = toccata.generate_mesh("torus-knot")
        twice = toccata.Mesh(numpy.vstack([loop.vertices, loop.vertices + [0.03, 0.02, 0.01]]), numpy.vstack([loop.faces, loop.faces + len(loop.vertices)]))
        toccata.overlap_bodies(twice, BOX, pose_b=(0.5, 0.25, 0.125))
