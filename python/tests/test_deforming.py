"""Meshes that deform: exact times, and no question sees an old box."""

import math

import numpy
import pytest

import toccata
from test_robustness import REFUSED

TRIANGLE = toccata.Mesh([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]])


def falling(height: float, depth: float) -> toccata.DeformingMesh:
    """A small triangle whose lowest vertex is so high above the other at the time 0, and so deep under it at 1."""
    mesh = toccata.Mesh([[1, 1, height], [1.1, 1, height + 1], [1, 1.1, height + 1]], [[0, 1, 2]])
    return toccata.DeformingMesh(mesh, mesh.vertices - (0, 0, height + depth))


def test_two_meshes_first_meet_at_the_exact_time():
    still, moving = toccata.DeformingMesh(TRIANGLE), falling(1, 1)
    impact = moving.first_impact(still)
    assert impact.lower <= 0.5 <= impact.upper <= impact.lower + 2**-40 and impact.status == toccata.Status.exact
    assert (impact.kind_a, impact.number_a, impact.kind_b) == (toccata.FeatureKind.vertex, 0, toccata.FeatureKind.face)
    assert moving.meets(still) and len(moving.impacts(still)) >= 1 and moving.impacts(still)[0]["upper"] == impact.upper
    fraction, limit = moving.free_step(still)
    assert limit == impact and 0.5 - 2**-39 < fraction <= 0.5
    of_moving, of_still = moving.free_steps(still)
    assert of_moving.shape == of_still.shape == (3,) and (0 < of_still).all() and (of_moving <= 1).all()
    reached = moving.start + of_moving[:, None] * (moving.end - moving.start)
    moving.move_to(reached)
    assert not moving.meets(still)
    near = falling(1, 1).first_impact(still, separation=0.5)
    assert math.isclose(near.upper, 0.25, abs_tol=1e-6)
    moving.move_to(moving.start - (0, 0, 0.9))
    assert not moving.meets(still) and moving.first_impact(still) is None and moving.free_step(still) == (1.0, None)


def test_a_mesh_with_itself():
    square = toccata.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.2, 0.2, 1], [0.3, 0.2, 2], [0.2, 0.3, 2]], [[0, 1, 2], [0, 2, 3], [4, 5, 6]])
    end = square.vertices.copy()
    end[4:, 2] -= 2
    mesh = toccata.DeformingMesh(square, end)
    assert mesh.meets() and math.isclose(mesh.first_impact().upper, 0.5, abs_tol=1e-9)
    steps, none = mesh.free_steps()
    assert none is None and steps.shape == (7,) and mesh.edges.shape == (8, 2)
    with pytest.raises(toccata.Error, match="same mesh"):
        mesh.meets(mesh)


def test_a_promise_that_is_broken():
    """Questions of times say so where they find it; what pierces something is not looked for, as the docstring says."""
    still, touching = toccata.DeformingMesh(TRIANGLE), falling(0, 1)
    for ask in (touching.first_impact, touching.impacts, touching.free_step):
        assert ask(still) is not None
        with pytest.raises(toccata.Error, match="promised to be free"):
            ask(still, starts_free=True)
    assert touching.meets(still, starts_free=True) and (touching.free_steps(still, starts_free=True)[0] == 0).any()
    pierced = toccata.DeformingMesh(toccata.Mesh([[1, 1, -1], [1.1, 1, 1], [1, 1.1, 1]], [[0, 1, 2]]))
    assert pierced.meets(still) and not pierced.meets(still, starts_free=True)


def test_no_question_sees_an_old_box(knot):
    """After any number of moves the answers are those of a mesh that is made anew."""
    rng = numpy.random.default_rng(3)
    ball = toccata.DeformingMesh(toccata.generate_mesh("icosphere", radius=0.3, subdivisions=2))
    kept = toccata.DeformingMesh(knot)
    found = []
    for step in range(12):
        start = kept.end
        end = start + rng.normal(size=3) * 1.5 + rng.normal(size=start.shape) * 0.003
        kept.advance(end)
        if step % 3 == 2:
            end = start + 0.3 * (end - start)
            kept.move_to(end)
        anew = toccata.DeformingMesh(toccata.Mesh(start, knot.faces), end)
        assert numpy.array_equal(kept.start, anew.start) and numpy.array_equal(kept.end, anew.end)
        found.append(kept.meets(ball))
        assert found[-1] == anew.meets(ball) and kept.first_impact(ball) == anew.first_impact(ball)
        assert numpy.array_equal(kept.impacts(ball), anew.impacts(ball))
    assert 0 < sum(found) < 12


def test_what_is_given_wrongly_leaves_it_as_it_was(knot):
    mesh = toccata.DeformingMesh(TRIANGLE)
    nan = TRIANGLE.vertices.copy()
    nan[1, 1] = math.nan
    for wrong in (knot.vertices, nan, "x", None, 5, numpy.zeros((3, 2))):
        for change in (mesh.move_to, mesh.advance):
            with pytest.raises(REFUSED):
                change(wrong)
        assert numpy.array_equal(mesh.end, TRIANGLE.vertices)
    for wrong in (toccata.Sphere(1), 5, toccata.Compound([TRIANGLE])):
        with pytest.raises(REFUSED):
            toccata.DeformingMesh(wrong)
    for separation in (-1, math.nan, math.inf):
        with pytest.raises(toccata.Error):
            mesh.meets(separation=separation)
