"""Questions are asked without the interpreter's lock, and Ctrl-C ends a batch."""

import copy
import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import threading
import time

import numpy
import pytest

import toccata
from conftest import SLICE, matrices


def test_two_threads_are_in_the_library_at_once(knot):
    """Whole questions of one thread begin and end while another thread is within a single call."""
    poses = matrices(1000 if SLICE else 3000, 6, 1)
    ball = toccata.Sphere(0.1)
    within, started, ended = [], threading.Event(), threading.Event()

    def one_long_call() -> None:
        started.set()
        begin = time.perf_counter()
        toccata.distance_each(knot, knot, poses_b=poses, threads=1)
        within.append((begin, time.perf_counter()))
        ended.set()

    toccata.distance(knot, ball)
    thread = threading.Thread(target=one_long_call)
    thread.start()
    started.wait()
    answered = []
    while not ended.is_set():
        toccata.distance(knot, ball, pose_b=(0, 0, 3))
        answered.append(time.perf_counter())
    thread.join()
    begin, end = within[0]
    assert sum(begin < moment < end for moment in answered) >= 20


def test_poses_that_are_written_to_meanwhile_are_old_or_new(knot):
    """They are read where they lie: what is wrong then is told as ever, and the array stays as long as it is asked about."""
    poses, ended = matrices(300 if SLICE else 2000, 1, 4), threading.Event()
    kept, other, nowhere = poses.copy(), poses.copy(), poses.copy()
    other[:, 0, 3] += 100
    nowhere[:, :3] = numpy.nan
    answers: list = []

    def ask() -> None:
        try:
            for given in (poses, numpy.array(poses)):
                answers.append(toccata.overlap_each(knot, knot, poses_b=given))
        except toccata.Error as error:
            answers.append(error)
        finally:
            ended.set()

    asking = threading.Thread(target=ask)
    asking.start()
    while not ended.is_set():
        for written in (other, nowhere, kept):
            poses[:] = written
    asking.join()
    met = toccata.overlap_each(knot, knot, poses_b=kept)
    assert met.any() and not toccata.overlap_each(knot, knot, poses_b=other).any()
    for found in answers:
        assert "finite" in str(found) if isinstance(found, toccata.Error) else not (found & ~met).any()
    assert answers


def test_threads_get_the_answers_of_one(knot):
    poses = matrices(60, 1.5, 9)
    expected = [toccata.distance(knot, knot, pose_b=pose) for pose in poses]
    found = [None] * len(poses)

    def ask(first: int) -> None:
        for i in range(first, len(poses), 4):
            found[i] = toccata.distance(knot, knot, pose_b=poses[i])

    threads = [threading.Thread(target=ask, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == expected


def test_a_mesh_may_be_updated_while_it_is_asked(knot):
    """An answer is that of the vertices before or after, never of some of both."""
    near, far = knot.vertices.copy(), knot.vertices + (5, 0, 0)
    mesh, ball = toccata.Mesh(near, knot.faces), toccata.Sphere(0.1)
    allowed = [toccata.distance(toccata.Mesh(v, knot.faces), ball, pose_b=(0, 0, 2)) for v in (near, far)]
    stop, wrong, asked = threading.Event(), [], []

    def ask() -> None:
        while not stop.is_set():
            answer = toccata.distance(mesh, ball, pose_b=(0, 0, 2))
            asked.append(answer.upper)
            if answer not in allowed:
                wrong.append(answer)

    threads = [threading.Thread(target=ask) for _ in range(3)]
    for thread in threads:
        thread.start()
    for step in range(200):
        mesh.update(far if step % 2 else near)
        time.sleep(0)
    stop.set()
    for thread in threads:
        thread.join()
    assert not wrong and asked


INTERRUPTED = """
import os, signal, threading, time, numpy, toccata
signal.signal(signal.SIGINT, signal.default_int_handler)  # which what runs in the background of a shell lacks
knot = toccata.generate_mesh("torus-knot")
poses = numpy.tile(numpy.eye(4), (200_000, 1, 1))
poses[:, 0, 3] = 3.5
threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
begin = time.perf_counter()
try:
    toccata.distance_each(knot, knot, poses_b=poses)
    print("not interrupted")
except KeyboardInterrupt:
    print("interrupted", toccata.overlap(knot, knot))
"""


def test_ctrl_c_ends_a_batch():
    run = subprocess.run([sys.executable, "-c", INTERRUPTED], capture_output=True, text=True, timeout=300)
    assert run.stdout.split() == ["interrupted", "True"], run.stdout + run.stderr


# The second signal ends it. Where nobody looks for signals while it is asked, both are one, after it.
INTERRUPTED_WITHIN = """
import signal, numpy, toccata
come = []
def stop(*_):
    come.append(1)
    if len(come) == 2:
        raise KeyboardInterrupt
signal.signal(signal.SIGALRM, stop)
knot = toccata.generate_mesh("torus-knot")
ball = toccata.generate_mesh("icosphere", subdivisions=4)
robot = toccata.Robot.generated(1)
GIVEN
signal.setitimer(signal.ITIMER_REAL, 0.1, 0.1)
try:
    answer = ASKED
    signal.setitimer(signal.ITIMER_REAL, 0)
    print("not interrupted")
except KeyboardInterrupt:
    print("interrupted")
"""


@pytest.mark.parametrize(("given", "asked"), [
    ("many = robot.sampled(300_000)", "robot.link_poses_each(many, threads=1)"),
    ("", "robot.allowed_pairs(500_000, threads=1)"),
    ("mesh, other = toccata.DeformingMesh(ball, -ball.vertices), toccata.DeformingMesh(ball)", "mesh.free_steps(other)"),
    ("ways = [toccata.RigidMotion(None, translation=(9, 0, 0), turns=2)] * 2_000", "toccata.sweep_each(knot, ways, knot, (4.5, 0, 0), threads=1)"),
    ("poses = numpy.tile(numpy.eye(4), (2_000_000, 1, 1)); poses[:, 0, 3] = numpy.linspace(2.5, 3, 2_000_000)",
     "toccata.relation_each(toccata.Ellipsoid((1, 2, 3)), toccata.Cylinder(1, 1), poses_b=poses, threads=1)"),
    ("world = toccata.World(contacts=True, penetration=True); world.add_each(knot, [(0.01 * i, 0, 0) for i in range(60)])", "world.step()"),
    ("low = numpy.random.default_rng(1).uniform(0, 1, (40_000, 3)); boxes = numpy.stack([low, low + 0.25], axis=1)",
     "toccata.overlapping_pairs(boxes, threads=1)"),
    ("low = numpy.random.default_rng(1).uniform(0, 1, (40_000, 3)); boxes = numpy.stack([low, low + 0.25], axis=1)", "toccata.overlapping_pairs(boxes)"),
    ("starts = numpy.random.default_rng(1).normal(size=(400_000, 4, 3))", "toccata.edge_edge_impacts(starts, -starts, threads=1)"),
], ids=["link_poses_each", "allowed_pairs", "free_steps", "sweep_each", "plain_shapes", "step", "overlapping_pairs", "overlapping_pairs_on_threads",
        "impacts"])
def test_ctrl_c_ends_what_takes_long(given, asked):
    program = INTERRUPTED_WITHIN.replace("GIVEN", given).replace("ASKED", asked)
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
    assert run.stdout.split() == ["interrupted"], run.stdout + run.stderr


AFTER_CTRL_C = """
import copy, signal, toccata
knot = toccata.generate_mesh("torus-knot")
places = [(0.01 * i, 0, 0) for i in range(16)]
def world():
    made = toccata.World(contacts=True)
    made.add_each(knot, places)
    return made
ended, undisturbed = world(), world()
def stop(*_):
    raise KeyboardInterrupt
signal.signal(signal.SIGALRM, stop)
signal.setitimer(signal.ITIMER_REAL, 0.05)
try:
    ended.step()
except KeyboardInterrupt:
    print("interrupted", len(ended.pairs))
print((ended.step().begin.pairs["in_contact"] == undisturbed.step().begin.pairs["in_contact"]).all(), len(ended.pairs))
def use(*_):
    told = []
    for way in (len, copy.copy, copy.deepcopy):
        try:
            way(ended)
        except toccata.Error as error:
            told.append(str(error))
    raise RuntimeError(f"{len(told)} times: {told[0]}")
signal.signal(signal.SIGALRM, use)
ended.move(ended.bodies, places[::-1])
signal.setitimer(signal.ITIMER_REAL, 0.05)
try:
    ended.step()
except RuntimeError as error:
    print(error)
"""


def test_a_world_whose_step_was_ended_goes_on():
    """And what a signal calls within a step gets an error where it uses the World, and does not wait for itself."""
    run = subprocess.run([sys.executable, "-c", AFTER_CTRL_C], capture_output=True, text=True, timeout=120)
    first, second, third = run.stdout.splitlines()
    assert (first, second) == ("interrupted 0", "True 120") and third.startswith("3 times: it is being asked"), run.stdout + run.stderr


OF_A_FUNCTION = """
import numpy, toccata
world = toccata.World(threads=2)
body = world.add(toccata.Sphere(1))
world.add_each(toccata.Sphere(1), [(3, 0.1 * i, 0) for i in range(50)])
told = set()
def pose_at(time):
    try:
        len(world)
    except toccata.Error as error:
        told.add(str(error)[:20])
    pose = numpy.eye(4)
    pose[0, 3] = 4 * time
    return pose
world.move_along(body, toccata.RigidMotion.of(pose_at, speed=4))
world.step()
print(told)
"""


def test_a_motion_that_uses_its_world_gets_an_error():
    """On whichever thread it is asked: it would wait for the World, which waits for it."""
    run = subprocess.run([sys.executable, "-c", OF_A_FUNCTION], capture_output=True, text=True, timeout=120)
    assert run.stdout.split("\n")[0] == "{'it is being asked: w'}", run.stdout + run.stderr


def child(results: multiprocessing.Queue) -> None:
    results.put(toccata.overlap_each(toccata.Sphere(1), toccata.Box((1, 1, 1)), poses_b=matrices(500, 4, 1)).tolist())


def test_processes_that_are_forked_or_spawned():
    expected = toccata.overlap_each(toccata.Sphere(1), toccata.Box((1, 1, 1)), poses_b=matrices(500, 4, 1)).tolist()
    for way in ("fork", "spawn"):
        context = multiprocessing.get_context(way)
        results = context.Queue()
        process = context.Process(target=child, args=(results,))
        process.start()
        assert results.get(timeout=60) == expected
        process.join(60)
        assert process.exitcode == 0


def test_functions_are_handed_to_processes():
    ball, box = toccata.Sphere(1), toccata.Box((1, 1, 1))
    for function in (toccata.overlap, toccata.distance_each, toccata.check_all):
        assert pickle.loads(pickle.dumps(function)) is function and copy.deepcopy(function) is function
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.starmap(toccata.overlap, [(ball, box, None, (x, 0, 0)) for x in (0, 9)]) == [True, False]


# What it needs of Python beside numpy, all of it small.
OF_PYTHON = {"__future__", "atexit", "html", "html.entities"}


def test_import_brings_nothing_but_numpy():
    """It is as quick as numpy and its own module, because of what it leaves alone."""
    script = "import sys, numpy; known = set(sys.modules); import toccata; print(*set(sys.modules) - known)"
    brought = set(subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout.split())
    assert {"toccata", "toccata._core"} <= brought and {name for name in brought - OF_PYTHON if not name.startswith("toccata")} == set(), brought
