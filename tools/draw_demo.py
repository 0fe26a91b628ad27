#!/usr/bin/env python3
"""Draws docs/pictures/demo.svg: the demo's a.obj and b.stl, with the faces in which they meet in a colour of their own.

usage: draw_demo.py TOCCATA [OUTPUT.svg]

The meshes and the faces come from the command TOCCATA; drawn are the triangles that face the viewer, far ones first.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

WIDTH, HEIGHT, BORDER = 760, 520, 20
COLOURS = {"a": (120, 160, 205), "b": (225, 200, 150), "meeting": (215, 60, 50)}
TURN, TILT = math.radians(-28), math.radians(58)  # about the z axis, then towards the viewer
LIGHT = (-0.4, 0.5, 0.77)


def subtract(p, q):
    return tuple(a - b for a, b in zip(p, q))


def normal(polygon):
    u, v = subtract(polygon[1], polygon[0]), subtract(polygon[2], polygon[0])
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    length = math.sqrt(sum(x * x for x in n)) or 1
    return tuple(x / length for x in n)


def read_obj(text):
    lines = [line.split() for line in text.splitlines()]
    points = [tuple(map(float, words[1:4])) for words in lines if words and words[0] == "v"]
    return [[points[int(w.split("/")[0]) - 1] for w in words[1:]] for words in lines if words and words[0] == "f"]


def read_ascii_stl(text):
    points = [tuple(map(float, line.split()[1:4])) for line in text.splitlines() if line.split()[:1] == ["vertex"]]
    return [points[i:i + 3] for i in range(0, len(points), 3)]


def to_view(p):
    """x to the right, y up, z towards the viewer."""
    x, y = p[0] * math.cos(TURN) - p[1] * math.sin(TURN), p[0] * math.sin(TURN) + p[1] * math.cos(TURN)
    return x, y * math.cos(TILT) + p[2] * math.sin(TILT), p[2] * math.cos(TILT) - y * math.sin(TILT)


def ask(command):
    """The faces of both meshes as polygons, and which of them meet."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([command, "demo", "--write", "scenes"], cwd=folder, check=True, capture_output=True)
        run = subprocess.run([command, "check", "scenes/a.obj", "scenes/b.stl", "--json", "--faces"], cwd=folder,
                             capture_output=True, text=True)
        scenes = pathlib.Path(folder) / "scenes"
        a, b = read_obj((scenes / "a.obj").read_text()), read_ascii_stl((scenes / "b.stl").read_text())
    faces = [face for pair in json.loads(run.stdout)["pairs"] for face in pair["faces"]]
    return a, b, {f["face_a"] for f in faces}, {f["face_b"] for f in faces}


def shade(colour, n):
    brightness = 0.45 + 0.55 * max(0.0, sum(x * y for x, y in zip(n, LIGHT)))
    return "#" + "".join(f"{min(255, round(c * brightness)):02x}" for c in colour)


def draw(a, b, meet_a, meet_b):
    drawn = []
    for polygons, colour, meet in ((a, COLOURS["a"], meet_a), (b, COLOURS["b"], meet_b)):
        for number, polygon in enumerate(polygons):
            seen = [to_view(p) for p in polygon]
            n = normal(seen)
            if n[2] > 0:
                drawn.append((sum(p[2] for p in seen) / len(seen), seen, shade(COLOURS["meeting"] if number in meet else colour, n)))
    drawn.sort(key=lambda entry: entry[0])
    xs, ys = [p[0] for _, s, _ in drawn for p in s], [p[1] for _, s, _ in drawn for p in s]
    scale = min((WIDTH - 2 * BORDER) / (max(xs) - min(xs)), (HEIGHT - 2 * BORDER) / (max(ys) - min(ys)))
    centre = (max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}">', '<g stroke-width="0.4">']
    for _, seen, colour in drawn:
        points = " ".join(f"{WIDTH / 2 + (p[0] - centre[0]) * scale:.1f},{HEIGHT / 2 - (p[1] - centre[1]) * scale:.1f}" for p in seen)
        lines.append(f'<path d="M{points}z" fill="{colour}" stroke="{colour}"/>')
    return "\n".join([*lines, "</g>", "</svg>", ""])


def main():
    output = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(__file__).resolve().parent.parent / "docs/pictures/demo.svg"
    output.parent.mkdir(parents=True, exist_ok=True)
    output.write_text(draw(*ask(str(pathlib.Path(sys.argv[1]).resolve()))))


if __name__ == "__main__":
    sys.exit(main())
