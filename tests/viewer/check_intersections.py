"""What is said and drawn of two objects that meet, by the engine's JSON: sentences of every relation, and face by face, curve by curve, the points of the picture."""
import json
import time

from check_controls import cube, full_picture
from check_pages import moved

VERBS = {"overlapping": "overlaps", "crossing": "intersects", "touching": "touches", "apart": "is closer than its clearance to"}
CONTAINING = {"a_in_b": "lies inside", "b_in_a": "contains", "equal": "equals"}
SHEET = "OFF\n4 1 0\n-3 -3 0\n3 -3 0\n3 3 0\n-3 3 0\n4 0 1 2 3\n"
CURVE = (0x11, 0x14, 0x18)


def write_files(checks):
    for name, text in [("cube", cube(1)), ("fine", cube(4)), ("sheet", SHEET)]:
        (checks.folder / f"{name}.off").write_text(text)


def remark(report, pair):
    kinds = ["solid" if report["objects"][pair[side]]["solid"] else "surface" for side in ["a_index", "b_index"]]
    return f"both {kinds[0]}s" if kinds[0] == kinds[1] else f"a {kinds[0]}, a {kinds[1]}"


def check_sentences(checks, browser):
    """Every relation, each with the number that the engine gave."""
    write_files(checks)
    big = {"type": "box", "half_extents": [4, 4, 4]}
    cube_file, sheet_file = {"file": "cube.off"}, {"file": "sheet.off"}
    objects = [("overlapping", cube_file, -4.5), ("inner", cube_file, 0), ("block", {"shape": big}, 0), ("twin", cube_file, 0), ("beside", cube_file, 5), ("sheet", sheet_file, 7), ("near", cube_file, -6.75)]
    checks.write_scene("relations.json", [{"name": name, **what, "pose": moved(x)} for name, what, x in objects], "mm")
    report = json.loads(checks.run("check", "relations.json", "--clearance", "0.5", "--faces", "--json", "--html", "relations.html"))
    checks.opened(browser, "relations.html", "#theme=light&order=listed")
    seen = set()
    for number, pair in enumerate(report["pairs"]):
        browser.value(f"document.querySelectorAll('#finding-list .row')[{number}].click()")
        sentence, facts = browser.value("[document.getElementById('sentence').textContent, [...document.querySelectorAll('#facts li')].map(fact => fact.textContent)]")
        verb = CONTAINING.get(pair["containment"]) or VERBS[pair["relation"]]
        seen.add(verb)
        wanted = f"{pair['a']} {verb} {pair['b']} ({remark(report, pair)})."
        checks.expect(sentence == wanted, f"{sentence} for {wanted}")
        apart = [fact for fact in facts if " mm apart, from " in fact]
        checks.expect(len(apart) == (pair["relation"] == "apart"), f"how near: {facts}")
        if apart:
            checks.expect(abs(float(apart[0].split()[0]) / pair["distance"]["upper"] - 1) < 1e-5, f"{pair['distance']}: {apart}")
    checks.expect(seen == {*VERBS.values(), *CONTAINING.values()}, f"every relation is there: {sorted(seen)}")
    checks.quiet(browser, "relations")


def looked_at(browser, points):
    """Where points of the world are on the canvas, the object that is seen there, and how far that is from the point."""
    return browser.value(f"""{json.dumps(points)}.map((point) => {{
      const {{ stage, data }} = toccata, {{ centre, size }} = data.header.frame, at = stage.orbit.place.target.clone();
      at.set(...point.map((x, axis) => (x - centre[axis]) / size));
      const box = stage.canvas.getBoundingClientRect(), {{ x, y }} = stage.onScreen(at), hit = stage.hit(box.left + x, box.top + y);
      return [Math.round(x), Math.round(y), hit ? hit.object : -1, hit ? hit.point.distanceTo(at) : 9];
    }})""")


def is_face_of_a(pixel):
    return pixel[2] > 60 and pixel[0] < 0.15 * pixel[2]


def is_face_of_b(pixel):
    return pixel[0] > 80 and pixel[2] < 0.15 * pixel[0] and pixel[1] < 0.56 * pixel[0]


def middles_of_faces(text, shift):
    lines = text.splitlines()
    count = int(lines[1].split()[0])
    vertices = [[float(x) for x in line.split()] for line in lines[2 : 2 + count]]
    faces = [[int(x) for x in line.split()[1:]] for line in lines[2 + count :]]
    return [[sum(vertices[i][k] for i in face) / len(face) + shift[k] for k in range(3)] for face in faces]


def check_faces_drawn(checks, browser):
    """Faces that meet are blue and vermilion, the others have the colours of their objects; the curve lies over both."""
    shift = [1.2, 0.3, 0.4]
    report = json.loads(checks.run("check", "fine.off", "fine.off", "--pose-b", *map(str, moved(*shift)), "--faces", "--json", "--html", "meeting.html"))
    pair = report["pairs"][0]
    camera = "camera=0,0,0,3.4,-0.9,0.6"
    checks.opened(browser, "meeting.html", f"#finding=0&theme=light&labels=0&grid=0&{camera}")
    browser.value("for (const id of ['found', 'layers', 'axes', 'scale']) document.getElementById(id).style.visibility = 'hidden'")
    time.sleep(0.4)
    picture = full_picture(browser)
    for object_, (key, is_meeting) in enumerate([("face_a", is_face_of_a), ("face_b", is_face_of_b)]):
        meeting = {one[key] for one in pair["faces"]}
        middles = middles_of_faces(cube(4), shift if object_ else [0, 0, 0])
        counts = [0, 0]
        for face, (x, y, seen, far) in enumerate(looked_at(browser, middles)):
            if seen != object_ or far > 1e-3:
                continue
            counts[face in meeting] += 1
            checks.expect(is_meeting(picture[y][x]) == (face in meeting), f"{key} {face}, which is {'' if face in meeting else 'not '}among those that meet, is {picture[y][x]}")
        checks.expect(min(counts) >= 2, f"faces of both kinds are seen: {counts}")
    check_curve(checks, browser, pair, picture)
    checks.quiet(browser, "meeting")


def check_curve(checks, browser, pair, picture):
    """Along every part of it that is not behind something, the picture is darker than without it, and has the curve's colour."""
    browser.value("toccata.stage.overlays.children.forEach((drawn) => { if (drawn.name === 'segments') drawn.visible = false; }), toccata.stage.drawNow()")
    time.sleep(0.4)
    without = full_picture(browser)
    segments = [meeting["points"] for one in pair["faces"] for meeting in one["intersections"] if meeting["kind"] == "segment"]
    middles = [[(p + q) / 2 for p, q in zip(*ends)] for ends in segments]
    visible = [(x, y) for x, y, _, far in looked_at(browser, middles) if far < 1e-2]
    checks.expect(len(visible) >= 10, f"{len(visible)} of {len(middles)} parts of the curve are seen")
    for x, y in visible:
        near = [(i, j) for j in range(y - 2, y + 3) for i in range(x - 2, x + 3)]
        darker = max(sum(without[j][i]) - sum(picture[j][i]) for i, j in near)
        off = min(max(abs(p - q) for p, q in zip(picture[j][i], CURVE)) for i, j in near)
        checks.expect(darker > 40 and off < 24, f"the curve is drawn at {x}, {y}: by {darker} darker, {off} from its colour")
