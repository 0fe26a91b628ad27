"""Every public class says what it is, compares or says why not, and is copied and pickled or says what to do instead."""

import copy
import enum
import pickle

import numpy
import pytest

import toccata
from conftest import one_of_each

BALL, BOX, CUBE = toccata.Sphere(1), toccata.Box((1, 1, 1)), toccata.generate_mesh("box")
NEAR = (0.25, 0.25, 0.9)


def arm(twist: float = 0.0) -> toccata.Robot:
    """Two links, of which the second holds a ball that may touch the first."""
    bones = {"base": [toccata.SceneInstance(BOX, name="foot")], "hand": [(toccata.Capsule((0, 0, 0), (0, 0, 2), 0.2), (0, 0, twist))]}
    joint = toccata.RobotJoint("turn", toccata.RobotJointKind.revolute, "base", "hand", (0, 0, 1), limits=(-1, 1))
    return toccata.Robot(bones, [joint], "arm", (1, 2, 3)).with_attached("ball", BALL, "hand", (0, 0, 3), ["base"])


def a_scene() -> toccata.RobotScene:
    obstacles = [toccata.SceneInstance(BOX, (0, 0, 4), name="shelf"), (BALL, (9, 9, 9))]
    return toccata.RobotScene(arm(), obstacles, allowed=[("ball", "shelf")], allow_adjacent=False)


def a_world() -> toccata.World:
    world = toccata.World(relation=True, distance=True, contacts=True, manifold=True, penetration=True)
    world.add_each([BOX, CUBE, CUBE, BALL, BALL], [(0, 0, 0), (0.5, 0, 0), (0.75, 0.5, 0), (0, 0, 3.5), (-1.5, 0, 0)], margins=1)
    world.step()
    moving = world.add(BALL, (-10, 0, 0))
    world.move_along(moving, toccata.RigidMotion.straight((-10, 0, 0), (20, 0, 0)))
    return world


def a_mover_step(level):
    return level.move_character(toccata.Sphere(0.5), KINDS[type(level).__name__](), (0, 0, -9))


KINDS = {"World": toccata.BodyMoverState, "SceneIndex": toccata.SceneMoverState}


def examples() -> dict[str, list]:
    """Of each class values that are all unlike each other."""
    world, index = a_world(), toccata.SceneIndex([(BOX, (0, 0, -3)), BALL])
    answer = toccata.check_all([CUBE, (CUBE, NEAR), (BALL, (2, 0, 0)), toccata.generate_mesh("icosphere", subdivisions=2)], contacts=True,
                               penetration=True, clearance=3, volume=True)
    ground = toccata.World()
    ground.add(BOX, (0, 0, -3))
    steps = [a_mover_step(ground), a_mover_step(toccata.SceneIndex([(BOX, (0, 0, -3))]))]
    step = world.step()
    ids = world.bodies
    first = world.nearest(BALL).body
    turning = toccata.RigidMotion(NEAR, translation=(1, 2, 3), turns=0.5, axis=(0, 1, 1))
    parts = toccata.decompose(toccata.generate_mesh("torus"), max_parts=3)
    open_box = toccata.Mesh(CUBE.vertices, CUBE.faces[:-2])
    deforming = toccata.DeformingMesh(CUBE, CUBE.vertices + (0, 0, 1))
    falling = toccata.DeformingMesh(CUBE, CUBE.vertices - (0, 0, 3))
    lower = toccata.DeformingMesh(toccata.Mesh(CUBE.vertices - (0, 0, 2), CUBE.faces))
    configuration = [0.5]
    robot_scene = a_scene()
    values = [
        *one_of_each(), toccata.Pose(), toccata.Pose.rotation((1, 2, 3), 40), toccata.SceneInstance(BALL), toccata.SceneInstance(BALL, NEAR, name="ball"),
        index, toccata.SceneIndex([BALL]), toccata.Body(BALL), toccata.Body(BALL, NEAR, margin=0.5, user_data=7, name="ball", category=2, mask=3),
        toccata.BodyFilter(), toccata.BodyFilter(mask=2, category=1), toccata.BodyFilter(except_bodies=[first]), first,
        toccata.RigidMotion(), turning, toccata.RigidMotion.through([0, 0.25, 1], [(0, 0, 0), NEAR, toccata.Pose.rotation((0, 0, 1), 90)]),
        turning.carrying((1, 0, 0)), answer, toccata.check_all([BALL]), step.begin, step.persist, step.end, step, world.pairs, ground.step(),
        parts, *parts.parts[:2], *toccata.mesh_faults(open_box), toccata.MoverOptions(), toccata.MoverOptions(skin=0.5), *steps,
        *(s.state for s in steps), *(s.state.ground for s in steps), toccata.BodyMoverState(NEAR), toccata.SceneMoverState(NEAR), arm(), arm(0.5),
        toccata.Robot.generated(0), robot_scene, *arm().joints, *arm().positions, deforming, toccata.show([BALL]), toccata.DistanceCache(),
        toccata.BroadPhase(), world, toccata.distance(BALL, BOX), toccata.penetration(BALL, BOX), toccata.relation(BALL, BOX),
        toccata.cast_ray((9, 0, 0), (-9, 0, 0), BALL), toccata.cast_shape(BALL, (9, 0, 0), BOX, pose_a=(-9, 0, 0)),
        toccata.nearest_point((9, 0, 0), BALL), toccata.signed_distance((9, 0, 0), CUBE), toccata.generalized_winding_number((0, 0, 0), CUBE),
        toccata.first_contact(CUBE, CUBE, pose_b=NEAR), CUBE.health(), toccata.close_mesh(open_box, 2)[1], toccata.overlap_volume(BALL, BOX),
        toccata.depth_bracket(CUBE, CUBE, pose_b=NEAR), toccata.manifold(BOX, BOX, pose_b=(0.5, 0, 1.75)), toccata.manifolds(CUBE, CUBE, pose_b=NEAR)[0],
        falling.first_impact(lower), world.cast_ray((0, 0, 90), (0, 0, -180)), world.cast_shape(BALL, (0, 0, -99), (0, 0, 99)), world.nearest(BALL),
        index.cast_ray((0, 0, 90), (0, 0, -180)), index.cast_shape(BALL, (0, 0, -99), (0, 0, 99)), index.nearest(BALL), ids,
        *toccata.RobotScene(arm(), [(BOX, (1, 2, 3))]).contacts(configuration)[:1], robot_scene.distance(configuration),
        robot_scene.edge([-1], [1]),
    ]
    of_class: dict[str, list] = {}
    for value in values:
        of_class.setdefault(type(value).__name__, []).append(value)
    return of_class


EXAMPLES = examples()
CLASSES = sorted(name for name in toccata.__all__ if isinstance(getattr(toccata, name), type) and not issubclass(getattr(toccata, name), BaseException))
# Two of these are equal when they are the same object, and why.
BY_IDENTITY = {
    "BroadPhase": "it changes", "DeformingMesh": "it changes", "DistanceCache": "it changes", "World": "it changes",
    "RobotScene": "it is made ready for questions: compare its robot and its obstacles",
    "SceneIndex": "it is made ready for questions: compare its objects",
}
# These are not pickled, and what their TypeError says to do.
REFUSED = {"BroadPhase": "pickled or copied: .* add them", "DistanceCache": "pickled or copied: make a new one", "World": "pickled: copy.copy .* add them"}
COPIED_ONLY = {"World"}


@pytest.mark.parametrize("name", CLASSES)
def test_a_class_says_what_it_is_and_whether_two_are_equal(name):
    kind = getattr(toccata, name)
    assert kind.__repr__ is not object.__repr__
    if not issubclass(kind, enum.Enum):
        assert (kind.__eq__ is object.__eq__) == (name in BY_IDENTITY), "equality, or a reason why not"
    if not issubclass(kind, enum.Enum) and name != "Shape":
        assert name in EXAMPLES, "the test knows no example of it"
    for value in EXAMPLES.get(name, []):
        text = repr(value)
        assert name in text and " at 0x" not in text, text
        assert value == value and value != None and not value == "a text"  # noqa: E711
        assert [value == other for other in EXAMPLES[name]] == [value is other for other in EXAMPLES[name]]


@pytest.mark.parametrize("name", sorted(EXAMPLES.keys() - {"ndarray"}))
def test_it_is_copied_and_pickled_or_says_what_to_do(name):
    for value in EXAMPLES[name]:
        again = [pickle.loads(pickle.dumps(value, protocol)) for protocol in range(pickle.HIGHEST_PROTOCOL + 1)] if name not in REFUSED else []
        again += [copy.copy(value), copy.deepcopy(value)] if name not in REFUSED or name in COPIED_ONLY else []
        for other in again:
            assert type(other) is type(value) and repr(other) == repr(value)
            assert other is not value and (other == value) == (name not in BY_IDENTITY)
        if name in REFUSED:
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                with pytest.raises(TypeError, match=REFUSED[name]):
                    pickle.dumps(value, protocol)
            if name not in COPIED_ONLY:
                with pytest.raises(TypeError, match=REFUSED[name]):
                    copy.copy(value)


def made_by_users() -> list:
    """One of each class of which users derive their own: no answers, which the library makes alone."""
    return [value for name, (value, *_) in sorted(EXAMPLES.items()) if name not in {*REFUSED, "Page"} and value.__reduce__()[0].__name__ == "remade"]


class Named:
    """What classes of users have beside: attributes, and an __init__ of their own."""

    def __init__(self, *made_of, **named):
        raise AssertionError("nobody calls it again")


DERIVED: dict[str, type] = {}
for value in made_by_users():
    DERIVED[type(value).__name__] = globals()[f"Derived{type(value).__name__}"] = type(f"Derived{type(value).__name__}", (Named, type(value)), {})


@pytest.mark.parametrize("kind", sorted(DERIVED))
def test_a_derived_class_keeps_its_class_and_what_it_has(kind):
    plain, derived = EXAMPLES[kind][0], DERIVED[kind]
    _, (made_by, _, arguments, named), _ = plain.__reduce__()
    value = derived.__new__(derived)
    made_by.__init__(value, *arguments, **named)
    value.label, value.list = "mine", [[1, 2]]
    value.itself = value
    for again in (pickle.loads(pickle.dumps(value)), copy.copy(value), copy.deepcopy(value)):
        assert type(again) is derived and again.label == "mine" and again.list == [[1, 2]]
        assert repr(again) == repr(value) and (kind in BY_IDENTITY or again == value)
    shallow, deep = copy.copy(value), copy.deepcopy(value)
    assert shallow.list is value.list and shallow.itself is value
    assert deep.list is not value.list and deep.itself is deep


class Slotted(toccata.Sphere):
    __slots__ = ("label",)


class WithState(toccata.Sphere):
    """It says itself what is kept."""

    def __getstate__(self):
        return "kept"

    def __setstate__(self, state):
        self.state = state


def test_slots_and_states_of_a_derived_class_are_kept():
    slotted = Slotted(2)
    slotted.label = "mine"
    said = WithState(2)
    for again in (pickle.loads(pickle.dumps(slotted)), copy.copy(slotted), copy.deepcopy(slotted)):
        assert type(again) is Slotted and again.label == "mine" and again == slotted
    for again in (pickle.loads(pickle.dumps(said)), copy.copy(said), copy.deepcopy(said)):
        assert type(again) is WithState and again.state == "kept" and again.radius == 2


def test_what_python_3_10_keeps_is_what_later_ones_do():
    class Both(Slotted):
        """With slots and with attributes."""

    from toccata._values import _state_before_python_3_11

    both, plain, slotted = Both(1), DERIVED["Sphere"].__new__(DERIVED["Sphere"]), Slotted(2)
    both.label, both.number, plain.name = "mine", 3, "plain"
    for value in (both, plain, slotted, BALL):
        told = _state_before_python_3_11(value)
        assert told == (value.__getstate__() if hasattr(object, "__getstate__") else told)
    assert _state_before_python_3_11(both) == ({"number": 3}, {"label": "mine"}) and _state_before_python_3_11(BALL) is None


class WithSecret(toccata.Sphere):
    __slots__ = ("__secret",)

    def keep(self, secret):
        self.__secret = secret
        return self

    def told(self):
        return self.__secret


class WithoutSlots(toccata.Sphere):
    __slots__ = ()

    def __setstate__(self, state):
        raise AssertionError("it has no state")


def test_private_slots_are_kept_and_no_state_is_not_given():
    value = WithSecret(1).keep(7)
    for again in (copy.copy(value), copy.deepcopy(value), pickle.loads(pickle.dumps(value))):
        assert again.told() == 7
    for again in (copy.copy(WithoutSlots(1)), pickle.loads(pickle.dumps(WithoutSlots(1)))):
        assert type(again) is WithoutSlots and again == WithoutSlots(1)


def test_robots_whose_links_are_in_another_order_differ():
    ball = toccata.Sphere(1)
    joints = [toccata.RobotJoint(f"to {name}", toccata.RobotJointKind.fixed, "base", name) for name in ("x", "y")]
    one = toccata.Robot({"base": [], "x": [ball], "y": [ball]}, joints)
    other = toccata.Robot({"base": [], "y": [ball], "x": [ball]}, joints)
    assert one == toccata.Robot({"base": [], "x": [ball], "y": [ball]}, joints) and one != other and one.links != other.links


def test_what_a_derived_mesh_shares_is_not_copied():
    class Part(toccata.Mesh):
        pass

    part = Part(CUBE.vertices, CUBE.faces)
    assert numpy.shares_memory(copy.copy(part).vertices, part.vertices)


def test_a_derived_world_is_copied_with_its_class():
    class Level(toccata.World):
        name = "none"

    level = Level()
    level.add(BOX)
    level.name = "first"
    for again in (copy.copy(level), copy.deepcopy(level)):
        assert type(again) is Level and again.name == "first" and len(again) == 1
        again.add(BOX)
        assert len(level) == 1


def test_robots_with_all_that_they_hold():
    robot = arm().with_attached("second", toccata.Box((0.1, 0.1, 0.1)), "ball", (0, 0, 1.05))
    again = pickle.loads(pickle.dumps(robot))
    assert again == robot and hash(again) == hash(robot) and again != arm() and robot != arm().with_attached("second", BALL, "ball", (0, 0, 1.05))
    assert again.links == ["base", "hand", "ball", "second"] and len(again.joints) == len(robot.joints) == 3
    # A robot that may touch other links is another one.
    alone = toccata.Robot({"base": [BOX], "hand": [BALL]}, arm().joints[:1])
    assert alone.with_attached("ball", BALL, "hand") != alone.with_attached("ball", BALL, "hand", touch_links=["base"])
    for configuration in ([0.0], [0.9]):
        assert (again.link_poses(configuration) == robot.link_poses(configuration)).all()
        assert toccata.RobotScene(again).contacts(configuration) == toccata.RobotScene(robot).contacts(configuration)


def test_scenes_of_robots_answer_the_same_again():
    scene = a_scene()
    again = pickle.loads(pickle.dumps(scene))
    assert again.robot == scene.robot and again.obstacles == scene.obstacles
    asked = arm().sampled(50)
    assert (again.distance_each(asked) == scene.distance_each(asked)).all()
    links, obstacles = len(arm().links), len(scene.obstacles)
    looked = [[s.looks_at(a, b, True) for a in range(links) for b in range(obstacles)] for s in (scene, again)]
    looked_between = [[s.looks_at(a, b) for a in range(links) for b in range(a + 1, links)] for s in (scene, again)]
    assert looked[0] == looked[1] and False in looked[0] and looked_between[0] == looked_between[1]


def test_answers_of_many_keep_all_their_arrays():
    answer = EXAMPLES["CheckAnswer"][0]
    again = pickle.loads(pickle.dumps(answer))
    for name in ("pairs", "contacts", "regions", "distances", "penetrations", "volumes"):
        assert len(getattr(answer, name)) > 0, name
        assert repr(getattr(again, name)) == repr(getattr(answer, name))
    assert again.candidate_pairs == answer.candidate_pairs
    pairs = EXAMPLES["WorldPairs"][1]
    again = pickle.loads(pickle.dumps(pairs))
    for name in ("pairs", "relations", "distances", "penetrations", "contacts"):
        assert len(getattr(pairs, name)) > 0, name
        assert repr(getattr(again, name)) == repr(getattr(pairs, name))
    assert [again.manifold(i) for i in range(len(again))] == [pairs.manifold(i) for i in range(len(pairs))]
    assert any(again.manifold(i) is not None for i in range(len(again)))
    met = EXAMPLES["WorldStep"][0].begin
    assert len(met.first_contacts) > 0 and pickle.loads(pickle.dumps(met)) == met


def test_motions_are_made_of_their_pieces():
    for motion in EXAMPLES["RigidMotion"]:
        again = toccata.RigidMotion(pieces=motion.pieces)
        assert again == motion and hash(again) == hash(motion)
        assert [again.at(t) for t in (0, 0.3, 1)] == [motion.at(t) for t in (0, 0.3, 1)]
    for wrong in ([], [(0, 0.5, toccata.Pose(), ((0, 0, 0), (0, 0, 1), 0, (0, 0, 0)))], "text", [(0, 1)]):
        with pytest.raises(toccata.Error, match="piece"):
            toccata.RigidMotion(pieces=wrong)
    with pytest.raises(TypeError, match="pieces"):
        toccata.RigidMotion((1, 2, 3), pieces=toccata.RigidMotion().pieces)


def test_motions_by_functions_are_copied_and_not_pickled():
    motion = toccata.RigidMotion.of(lambda t: (t, 0, 0), speed=1)
    with pytest.raises(TypeError, match="function"):
        pickle.dumps(motion)
    assert copy.copy(motion).at(0.5) == copy.deepcopy(motion).at(0.5) == motion.at(0.5)
    assert motion == motion and motion != toccata.RigidMotion.of(lambda t: (t, 0, 0), speed=1) and motion != toccata.RigidMotion()


def test_pickles_that_are_not_theirs_are_refused():
    answer = EXAMPLES["CheckAnswer"][0]
    make, (kind,), state = answer.__reduce__()
    for wrong in ((), state[:-1], (*state[1:], state[0]), (state[0], *state[1:6], "text")):
        with pytest.raises((toccata.Error, TypeError)):
            make(kind).__setstate__(wrong)
    rows = state[1].copy()
    rows["pair"] = 99
    with pytest.raises(toccata.Error, match="pair"):
        make(kind).__setstate__((state[0], rows, *state[2:]))
