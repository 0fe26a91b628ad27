"""A corner of a plant, in metres: a tank whose pipe goes through a beam of the steel frame around it. Meshes as OBJ files and the scene
that places them."""
import json
import math

AROUND = 40  # sides of a pipe
UPRIGHT = [1, 0, 0, 0, 1, 0, 0, 0, 1]
ALONG_Y = [0, -1, 0, 1, 0, 0, 0, 0, 1]
STANDING = [0, 0, -1, 0, 1, 0, 1, 0, 0]


def write_obj(file, points, faces):
    lines = ["v " + " ".join(f"{x:.6f}" for x in point) for point in points] + ["f " + " ".join(str(i + 1) for i in face) for face in faces]
    file.write_text("\n".join(lines) + "\n", encoding="ascii")


def profile(height, width, web, flange, steps):
    """The outline of an I, from its upper left corner, against the clock as seen along −x; its web in steps."""
    h, w, t = height / 2, width / 2, web / 2
    inner = h - flange
    levels = [inner - 2 * inner * i / steps for i in range(steps + 1)]
    left, right = [(-t, z) for z in levels], [(t, z) for z in reversed(levels)]
    return [(-w, h), (-w, inner), *left, (-w, -inner), (-w, -h), (w, -h), (w, -inner), *right, (w, inner), (w, h)]


def end_of_profile(steps):
    """The triangles and squares of an end, by the numbers of the outline."""
    count = 2 * (steps + 1) + 8
    upper_left, lower_left = 2, 2 + steps
    lower_right, upper_right = lower_left + 5, lower_left + 5 + steps
    upper = [(0, 1, upper_left), (0, upper_left, upper_right), (0, upper_right, count - 1), (count - 1, upper_right, count - 2)]
    lower = [(lower_left, lower_left + 1, lower_left + 2), (lower_left, lower_left + 2, lower_left + 3), (lower_left, lower_left + 3, lower_right), (lower_right, lower_left + 3, lower_left + 4)]
    return upper + [(upper_left + i, upper_left + i + 1, upper_right - i - 1, upper_right - i) for i in range(steps)] + lower


def write_beam(file, length, height=0.6, width=0.26, cells=7):
    """Along x, around the origin; cells of its web from edge to edge, as wide as high, so that those that meet something are few."""
    outline = profile(height, width, 0.03, 0.04, cells)
    steps, count = max(1, round(length * cells / height)), len(outline)
    points = [(length * (i / steps - 0.5), y, z) for i in range(steps + 1) for y, z in outline]
    end = end_of_profile(cells)
    faces = [tuple(reversed(face)) for face in end] + [tuple(i + steps * count for i in face) for face in end]
    for i in range(steps):
        for k in range(count):
            a, b = i * count + k, i * count + (k + 1) % count
            faces.append((a, b, b + count, a + count))
    write_obj(file, points, faces)


def bent(corners, radius):
    """Points of a way in the plane and the directions there, its corners rounded."""
    ways = [(b[0] - a[0], b[1] - a[1]) for a, b in zip(corners, corners[1:])]
    units = [(x / math.hypot(x, y), y / math.hypot(x, y)) for x, y in ways]
    told = [(corners[0], units[0])]
    for corner, before, after in zip(corners[1:], units, units[1:]):
        for i in range(13):
            turn = math.pi / 2 * i / 12  # all corners are right angles
            middle = (corner[0] + radius * (after[0] - before[0]), corner[1] + radius * (after[1] - before[1]))
            at = tuple(m + radius * (math.sin(turn) * b - math.cos(turn) * a) for m, b, a in zip(middle, before, after))
            told.append((at, tuple(math.cos(turn) * b + math.sin(turn) * a for b, a in zip(before, after))))
    return told + [(corners[-1], units[-1])]


def write_pipe(file, corners, radius, bend, step=0.12):
    """In the plane of y and z."""
    ways = bent(corners, bend)
    stations = [ways[0]]
    for (a, along), (b, next_along) in zip(ways, ways[1:]):
        count = max(1, round(math.dist(a, b) / step))
        for i in range(1, count + 1):
            t = i / count
            stations.append(((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])), next_along if i == count else along))
    points, faces = [], []
    for (y, z), (dy, dz) in stations:
        for k in range(AROUND):
            angle = 2 * math.pi * (k + 0.5) / AROUND
            c, s = radius * math.cos(angle), radius * math.sin(angle)
            points.append((c, y - s * dz, z + s * dy))
    for i in range(len(stations) - 1):
        for k in range(AROUND):
            a, b = i * AROUND + k, i * AROUND + (k + 1) % AROUND
            faces.append((a, b, b + AROUND, a + AROUND))
    last = (len(stations) - 1) * AROUND
    faces += [tuple(reversed(range(AROUND))), tuple(range(last, last + AROUND))]
    write_obj(file, points, faces)


def prism(radius, height, sides=48):
    return {"generate": "prism", "parameters": {"sides": sides, "radius": radius, "height": height}}


def box(x, y, z):
    return {"generate": "box", "parameters": {"half-x": x, "half-y": y, "half-z": z}}


def write_plant(folder):
    """The scene `plant.json` and its meshes."""
    write_beam(folder / "girder.obj", 4.4)
    write_beam(folder / "cross.obj", 2.87, height=0.5)  # from web to web, between the flanges
    write_beam(folder / "column.obj", 2.2, height=0.26)
    write_pipe(folder / "outlet.obj", [(0.5, 1.6), (0.5, 2.49), (-2.3, 2.49), (-2.3, 0.6)], 0.16, 0.36)
    parts = [("slab", box(3, 2.6, 0.08), UPRIGHT, (0, -0.3, -0.08)), ("tank", prism(0.75, 1.4), UPRIGHT, (0, 0.5, 0.2)),
             ("pump", box(0.35, 0.3, 0.3), UPRIGHT, (0, -2.3, 0.3)), ("beam", {"file": "girder.obj"}, UPRIGHT, (0, -1.2, 2.5)),
             ("rear beam", {"file": "girder.obj"}, UPRIGHT, (0, 1.7, 2.5)), ("pipe", {"file": "outlet.obj"}, UPRIGHT, (0, 0, 0))]
    parts += [(f"cross beam {i}", {"file": "cross.obj"}, ALONG_Y, (x, 0.25, 2.5)) for i, x in enumerate((-2.2, 2.2))]
    parts += [(f"column {i}", {"file": "column.obj"}, STANDING, (x, y, 1.1)) for i, (x, y) in enumerate((x, y) for x in (-2.2, 2.2) for y in (-1.2, 1.7))]
    objects = [{"name": name, **shape, "pose": [*turn, *place]} for name, shape, turn, place in parts]
    (folder / "plant.json").write_text(json.dumps({"format": "toccata-scene", "version": 1, "unit": "m", "objects": objects}), encoding="utf-8")
