"""What docs/guide/from-coal.md says is different: asked of coal, where it is installed, and of Toccata, row by row."""

import threading
import time
import warnings

import numpy
import pytest

import toccata

coal = pytest.importorskip("coal", reason="coal is not installed: pip install coal")
warnings.filterwarnings("ignore", category=DeprecationWarning)


def at(*translation: float, rotation: numpy.ndarray | None = None):
    return coal.Transform3s(numpy.eye(3) if rotation is None else rotation, numpy.array(translation, dtype=float))


HERE = at(0, 0, 0)


def collides(a, b, pose, most=100, **request):
    """The contacts."""
    asked, found = coal.CollisionRequest(coal.CollisionRequestFlag.CONTACT, most), coal.CollisionResult()
    for name, value in request.items():
        setattr(asked, name, value)
    assert coal.collide(a, HERE, b, pose, asked, found) == found.numContacts()
    return list(found.getContacts())


def distance(a, b, pose):
    return coal.distance(a, HERE, b, pose, coal.DistanceRequest(), coal.DistanceResult())


def patches(a, b, pose):
    """How many points each has."""
    found, told = coal.CollisionResult(), coal.ContactPatchResult()
    coal.collide(a, HERE, b, pose, coal.CollisionRequest(coal.CollisionRequestFlag.CONTACT, 100), found)
    coal.computeContactPatch(a, HERE, b, pose, found, coal.ContactPatchRequest(), told)
    return [told.getContactPatch(i).size() for i in range(told.numContactPatches())]


def surface(mesh: toccata.Mesh):
    model = coal.BVHModelOBBRSS()
    model.beginModel(len(mesh.faces), len(mesh.vertices))
    model.addVertices(numpy.array(mesh.vertices))
    model.addTriangles(mesh.faces.astype(numpy.int32))
    model.endModel()
    return model


def ball_of(radius: float, subdivisions: int = 1) -> toccata.Mesh:
    return toccata.generate_mesh("icosphere", radius=radius, subdivisions=subdivisions)


LARGE, SMALL = ball_of(3), ball_of(0.3)


def test_names_and_sizes():
    """A ball is as far from each shape of one name as from that of the other."""
    x, y, z = 0.4, 0.6, 0.8
    pairs = [
        (coal.Box(x, y, z), toccata.Box((x / 2, y / 2, z / 2))),
        (coal.Ellipsoid(x, y, z), toccata.Ellipsoid((x, y, z))),
        (coal.Capsule(x, z), toccata.Capsule((0, 0, -z / 2), (0, 0, z / 2), x)),
        (coal.Cylinder(x, z), toccata.Cylinder(x, z / 2)),
        (coal.Cone(x, z), toccata.Cone(x, z / 2)),
        (coal.Halfspace(numpy.array([0, 0.6, 0.8]), 0.5), toccata.HalfSpace(0.5 * numpy.array([0, 0.6, 0.8]), (0, 0.6, 0.8))),
    ]
    rounded = coal.Box(x, y, z)
    rounded.setSweptSphereRadius(0.25)
    pairs.append((rounded, toccata.Rounded(toccata.Box((x / 2, y / 2, z / 2)), 0.25)))
    for theirs, ours in pairs:
        for place in ((3, 0.1, 0.2), (0.1, 4, -0.2), (0.2, 0.1, 5), (0.1, 0.2, 2.5)):
            ball, told = toccata.Sphere(0.1), distance(theirs, coal.Sphere(0.1), at(*place))
            assert abs(toccata.distance(ours, ball, pose_b=place).upper - max(0, told)) < 1e-4, (ours, place)


def test_meshes_are_surfaces_or_solids():
    assert not collides(surface(LARGE), surface(SMALL), HERE) and not collides(surface(LARGE), coal.Sphere(0.3), HERE)
    assert toccata.overlap(LARGE, SMALL) and toccata.overlap(LARGE, toccata.Sphere(0.3))
    assert not toccata.overlap(LARGE, SMALL, solid_a=toccata.Solid.none)


def test_distances_of_what_meets():
    assert distance(surface(LARGE), surface(LARGE), at(1, 0, 0)) == 0
    assert distance(surface(LARGE), coal.Sphere(1), at(2.5, 0, 0)) < -0.5
    ground, ours, rng = coal.Halfspace(numpy.array([0, 0, 1.0]), 0.0), toccata.HalfSpace((0, 0, 0), (0, 0, 1)), numpy.random.default_rng(1)
    less = 0
    for _ in range(20):
        pose = toccata.Pose.from_quaternion(rng.normal(size=4), (0, 0, rng.uniform(0, 2.5)))
        theirs, depth = coal.Transform3s(pose.linear, pose.offset), toccata.penetration(ours, LARGE, pose_b=pose).lower
        told = -distance(ground, surface(LARGE), theirs)
        assert 0 <= told < depth + 1e-6 and abs(-min(c.penetration_depth for c in collides(ground, surface(LARGE), theirs)) - depth) < 1e-6
        less += told < 0.9 * depth
    assert less > 10
    for a, b, pose in ((LARGE, LARGE, (1, 0, 0)), (LARGE, toccata.Sphere(1), (2.5, 0, 0)), (toccata.HalfSpace((0, 0, 0), (0, 0, 1)), LARGE, None)):
        assert toccata.distance(a, b, pose_b=pose).upper == 0 and toccata.penetration(a, b, pose_b=pose).lower > 0


def test_touching_is_decided():
    apart, touching = (2 + 1e-9, 0, 0), (2, 0, 0)
    (contact,) = collides(coal.Box(2, 2, 2), coal.Box(2, 2, 2), at(*apart))
    assert contact.penetration_depth == 0
    box = toccata.Box((1, 1, 1))
    assert not toccata.overlap(box, box, pose_b=apart) and toccata.overlap(box, box, pose_b=touching)


def test_distances_depend_on_what_they_should_not():
    cylinder, cone = coal.Cylinder(0.5, 1), coal.Cone(0.4, 1.2)
    cached = coal.DistanceRequest()
    cached.gjk_initial_guess = coal.GJKInitialGuess.CachedGuess
    swapped = by_guess = wide = 0
    rng = numpy.random.default_rng(1)
    ours = toccata.Cylinder(0.5, 0.5), toccata.Cone(0.4, 0.6)
    for _ in range(200):
        pose = toccata.Pose.from_quaternion(rng.normal(size=4), rng.uniform(-2, 2, 3))
        theirs, result = coal.Transform3s(pose.linear, pose.offset), coal.DistanceResult()
        one = distance(cylinder, cone, theirs)
        swapped += one != coal.distance(cone, theirs, cylinder, HERE, coal.DistanceRequest(), coal.DistanceResult())
        by_guess += one != coal.distance(cylinder, HERE, cone, theirs, cached, result)
        cached.updateGuess(result)
        told = toccata.distance(*ours, pose_b=pose)
        wide += one > 0 and not told.lower * (1 - 1e-9) <= one <= told.upper * (1 + 1e-9)
        assert told.upper - told.lower <= 1e-12 * told.upper
    assert swapped > 100 and by_guess > 100 and wide > 50


def test_contacts_and_patches():
    box, pose = coal.Box(2, 2, 1), at(0.5, 0, 0.75)
    assert coal.CollisionRequest().num_max_contacts == 1
    assert len(collides(box, box, pose)) == 1 and patches(box, box, pose) == [4]
    large = surface(LARGE)
    assert len(collides(large, large, at(1, 0, 0))) > 10 and patches(large, large, at(1, 0, 0)) == [1]
    assert len(collides(large, large, at(1, 0, 0), most=3)) == 3
    ours = toccata.Box((1, 1, 0.5))
    assert len(toccata.manifold(ours, ours, pose_b=(0.5, 0, 0.75))) == 4
    assert len(toccata.contact_regions(LARGE, LARGE, pose_b=(1, 0, 0))) == 1 and toccata.manifolds(LARGE, LARGE, pose_b=(1, 0, 0))


def test_margins():
    box, ball, place = coal.Box(2, 2, 1), coal.Sphere(0.25), (0.25, 0, 1)
    for margin in (0.2, 0.25, 0.3):
        near = toccata.within_distance(toccata.Box((1, 1, 0.5)), toccata.Sphere(0.25), margin, pose_b=place)
        assert bool(collides(box, ball, at(*place), security_margin=margin)) == near


def test_height_fields():
    heights = numpy.array([[0, 0, 0], [0, 1, 0], [0, 0, 0.0]])
    theirs, ours = coal.HeightFieldAABB(4.0, 4.0, heights, -1.0), toccata.HeightField(heights, (2, 2))
    assert theirs.getXGrid().tolist() == [-2, 0, 2] and theirs.getYGrid().tolist() == [2, 0, -2]
    assert collides(theirs, coal.Sphere(0.1), at(0, 0, -0.5)) and not collides(theirs, coal.Sphere(0.1), at(0, 0, -1.5))
    ball = toccata.Sphere(0.1)
    assert not toccata.overlap(ours, ball, pose_b=(2, 2, 0.5)) and toccata.overlap(ours, ball, pose_b=(2, 2, 0.95))
    for ask in (distance, collides):
        for other in (surface(LARGE), theirs, coal.Halfspace(numpy.array([0, 0, 1.0]), 0.0)):
            with pytest.raises((ValueError, RuntimeError)):
                ask(theirs, other, at(0, 0, 5))
    with pytest.raises(ValueError):
        distance(theirs, coal.Sphere(0.1), at(0, 0, 5))
    for other in (LARGE, ours, toccata.Sphere(1)):
        assert toccata.distance(ours, other, pose_b=(0, 0, 5)).lower > 0


def test_what_is_no_rotation_and_no_number():
    twice, ball = at(0, 0, 0, rotation=2 * numpy.eye(3)), coal.Sphere(0.1)
    told = coal.distance(coal.Box(1, 1, 1), twice, ball, at(3, 0, 0), coal.DistanceRequest(), coal.DistanceResult())
    assert abs(told - 1.9) < 1e-9  # from a box of the sides 2
    assert coal.collide(coal.Box(1, 1, 1), twice, ball, at(0.8, 0, 0), coal.CollisionRequest(), coal.CollisionResult()) == 0
    box, scaled = toccata.Box((0.5, 0.5, 0.5)), (2 * numpy.eye(3), (0, 0, 0))
    assert toccata.overlap(box, toccata.Sphere(0.1), scaled, (0.8, 0, 0))
    with pytest.raises(toccata.Error):
        toccata.overlap(toccata.Sphere(1), box, scaled)
    assert collides(coal.Box(1, 1, 1), ball, at(numpy.nan, 0, 0)) and distance(coal.Box(1, 1, 1), ball, at(numpy.nan, 0, 0)) < -1e308
    with pytest.raises(toccata.Error):
        toccata.overlap(box, toccata.Sphere(0.1), pose_b=(numpy.nan, 0, 0))
    assert coal.Sphere(-1).radius == -1
    with pytest.raises(toccata.Error):
        toccata.Sphere(-1)


def test_half_spaces():
    ground, wall = coal.Halfspace(numpy.array([0, 0, 1.0]), 0.0), coal.Halfspace(numpy.array([1.0, 0, 0]), 0.0)
    for other in (wall, coal.Plane(numpy.array([1.0, 0, 0]), 0.0)):
        assert distance(ground, other, HERE) < -1e308
    ours = toccata.HalfSpace((0, 0, 0), (0, 0, 1)), toccata.HalfSpace((0, 0, 0), (1, 0, 0))
    assert toccata.overlap(*ours) and toccata.distance(*ours).upper == 0
    with pytest.raises(toccata.Error):
        toccata.penetration(*ours)


def test_managers_and_worlds():
    manager = coal.DynamicAABBTreeCollisionManager()
    one, other = coal.CollisionObject(coal.Sphere(1), HERE), coal.CollisionObject(coal.Sphere(1), at(5, 0, 0))
    manager.registerObject(one), manager.registerObject(other), manager.setup()

    def found() -> bool:
        callback = coal.CollisionCallBackDefault()
        manager.collide(callback)
        return callback.data.result.isCollision()

    other.setTranslation(numpy.array([1.0, 0, 0]))
    assert not found()
    manager.update()
    assert not found()
    other.computeAABB()
    manager.update()
    assert found()
    world = toccata.World()
    world.add(toccata.Sphere(1), type=toccata.BodyType.static_body)
    moving = world.add(toccata.Sphere(1), (5, 0, 0))
    assert len(world.step().begin) == 0
    world.move(moving, (1, 0, 0))
    assert len(world.step().begin) == 1


def test_the_lock_is_kept():
    """Another thread goes on while Toccata is asked, and not while coal is."""
    mesh = ball_of(1, 6)
    theirs, poses = surface(mesh), numpy.tile(numpy.eye(4), (4000, 1, 1))
    poses[:, 0, 3] = 1.99
    within = {}
    for name, ask in (("coal", lambda: collides(theirs, theirs, at(0.02, 0, 0), most=10**7)),
                      ("toccata", lambda: toccata.distance_each(mesh, mesh, poses_b=poses, threads=1))):
        moments, stop = [], threading.Event()

        def go_on() -> None:
            while not stop.is_set():
                moments.append(time.perf_counter())
                time.sleep(0.001)

        thread = threading.Thread(target=go_on)
        thread.start()
        begin = time.perf_counter()
        ask()
        end = time.perf_counter()
        stop.set()
        thread.join()
        within[name] = sum(begin + 0.01 < moment < end - 0.01 for moment in moments)
    # Python makes a list of coal's contacts before and after its call: a moment may fall there.
    assert within["coal"] <= 2 and within["toccata"] > 5 * (1 + within["coal"]), within
