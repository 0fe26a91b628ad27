"""The page of a robot: its links where each configuration puts them, worked out from its URDF file, and who meets whom."""
import itertools
import json
import math
import time
import xml.etree.ElementTree

from pixels import differing, is_blue, is_orange, share

CONFIGURATIONS = [[0, 0, 0, 0, 0, 0, 0], [0, 1.5, 0, 1.9, 0, 1, 0], [1, -0.5, 0.5, 0.75, 0, -1, 0.25]]
GO = "toccata.time.go({})"
# In the world: the least and the greatest corner of each object as drawn.
BOXES = """(() => {
  const { centre, size } = toccata.data.header.frame;
  const world = (corner) => corner.toArray().map((x, k) => x * size + centre[k]);
  return Object.fromEntries(toccata.data.report.objects.map((object, i) => [object.name, [world(toccata.boxOf(i).min), world(toccata.boxOf(i).max)]]));
})()"""


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def turned(axis, angle):
    """About an axis of length 1 (O. Rodrigues, 1840)."""
    x, y, z = axis
    c, s = math.cos(angle), math.sin(angle)
    rows = [[c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s], [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
            [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)]]
    return [[*row, 0] for row in rows] + [[0, 0, 0, 1]]


def origin_of(element):
    """xyz, and roll, pitch and yaw about the fixed axes."""
    origin = element.find("origin")
    told = {} if origin is None else origin.attrib
    x, y, z = map(float, told.get("xyz", "0 0 0").split())
    roll, pitch, yaw = map(float, told.get("rpy", "0 0 0").split())
    place = [[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]]
    for axis, angle in [((0, 0, 1), yaw), ((0, 1, 0), pitch), ((1, 0, 0), roll)]:
        place = product(place, turned(axis, angle))
    return place


class Arm:
    """What a URDF file says: a chain of joints that turn, and a mesh for each link."""

    def __init__(self, folder):
        root = xml.etree.ElementTree.parse(folder / "robot.urdf").getroot()
        self.joints = root.findall("joint")
        self.links = {link.get("name"): (origin_of(collision), corners_of(folder / collision.find("geometry/mesh").get("filename")))
                      for link in root.findall("link") for collision in link.findall("collision")}

    def boxes(self, configuration):
        """Of each link, the box around the turned box of its mesh, which is what the page draws it in."""
        identity = [[float(i == j) for j in range(4)] for i in range(4)]
        poses = {self.joints[0].find("parent").get("link"): identity}
        for joint, angle in zip(self.joints, configuration):
            axis = list(map(float, joint.find("axis").get("xyz").split()))
            length = math.hypot(*axis)
            local = product(origin_of(joint), turned([x / length for x in axis], angle))
            poses[joint.find("child").get("link")] = product(poses[joint.find("parent").get("link")], local)
        boxes = {}
        for name, (origin, corners) in self.links.items():
            pose = product(poses[name], origin)
            moved = [[sum(pose[i][k] * corner[k] for k in range(3)) + pose[i][3] for i in range(3)] for corner in corners]
            boxes[name] = [[least(values) for values in zip(*moved)] for least in (min, max)]
        return boxes


def corners_of(path):
    """Of the box around the vertices of an OBJ file."""
    vertices = [list(map(float, line.split()[1:4])) for line in path.read_text().splitlines() if line.startswith("v ")]
    return list(itertools.product(*([min(values), max(values)] for values in zip(*vertices))))


def check_robot(checks, browser):
    checks.run("robot", "gen:arm", "--write-urdf", "arm")
    (checks.folder / "q.csv").write_text("".join(" ".join(map(str, row)) + "\n" for row in CONFIGURATIONS))
    words = ["robot", "gen:arm", "--scene", "gen:torus?radius=0.5", "--configurations", "q.csv", "--edges"]
    report = json.loads(checks.run(*words, "--json", "--html", "robot.html"))
    checks.opened(browser, "robot.html", "#theme=light")
    arm, moments = Arm(checks.folder / "arm"), browser.value("toccata.data.header.time.moments")
    checks.expect(len(moments) == 17, f"{len(moments)} moments of 3 configurations and 7 between each two")
    pictures = []
    for number, told in enumerate(report["configurations"]):
        browser.value(GO.format(8 * number))
        time.sleep(0.3)
        look_at_links(checks, browser.value(BOXES), arm.boxes(CONFIGURATIONS[number]), f"configuration {number}")
        rows = browser.value("[...document.querySelectorAll('#finding-list .row')].map((row) => row.textContent)")
        for contact in told["contacts"]:
            checks.expect(any(contact["link"] in row and contact["other"] in row for row in rows), f"configuration {number}: {contact} is in {rows}")
        checks.expect(len([row for row in rows if "end" not in row]) >= len(told["contacts"]), f"configuration {number}: {rows}")
        pictures.append(browser.picture())
    checks.expect(len(report["configurations"][0]["contacts"]) == 0 < len(report["configurations"][1]["contacts"]), "the second configuration meets the ring")
    browser.value(GO.format(4))
    half = [(a + b) / 2 for a, b in zip(*CONFIGURATIONS[:2])]
    look_at_links(checks, browser.value(BOXES), arm.boxes(half), "half way")
    seen, _ = differing(pictures[0], pictures[1])
    checks.expect(seen > 0.01, f"the arm is seen to move: {seen:.4f}")
    checks.expect(share(pictures[0], is_blue) > 0.002, "an arm that meets nothing is blue")
    checks.expect(share(pictures[1], is_orange) > 0.002 > share(pictures[0], is_orange), "links that meet the ring are orange")
    checks.quiet(browser, "robot")


def look_at_links(checks, drawn, boxes, when):
    for name, box in boxes.items():
        there = drawn.get(name)
        off = math.inf if there is None else max(abs(x - y) for one, other in zip(there, box) for x, y in zip(one, other))
        checks.expect(off < 1e-3, f"{when}: {name} is drawn in {there}, and is in {box}")
