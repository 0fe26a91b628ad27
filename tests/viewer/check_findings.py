#!/usr/bin/env python3
"""Opens in Chromium the pages of saved reports of every question, and compares what they say and draw with these reports.

usage: check_findings.py TOCCATA [FOLDER]     with FOLDER, what was seen is kept there

Exits with 77, which CTest takes for skipped, where Chromium is not installed.
"""
import json
import math
import pathlib
import re
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from browser import Browser, find_chromium  # noqa: E402
from check_intersections import check_faces_drawn, check_sentences  # noqa: E402
from check_pages import BOX, Checks, WICKED, differing, is_blue, moved, share  # noqa: E402
from page_content import content_of, tells_depth  # noqa: E402

ROWS = "1 0 0 0 1 0 0 0 1 "


def drawn_report(checks, browser, name, *words):
    """The report; its page is open, and has been found to be that which `--html` writes beside the report."""
    text = checks.run(*words, "--json", "--html", "beside.html")
    (checks.folder / f"{name}.json").write_text(text)
    checks.run("view", f"{name}.json", "-o", f"{name}.html")
    beside, later = ((checks.folder / file).read_text() for file in ["beside.html", f"{name}.html"])
    headers = [{**json.loads(content_of(page, "header")), "title": ""} for page in [beside, later]]
    checks.expect(headers[0] == headers[1], f"{name}: the page of the report is the one that was written beside it")
    checks.expect(content_of(beside, "data") == content_of(later, "data"), f"{name}: both draw the same")
    checks.opened(browser, f"{name}.html", "#theme=light")
    browser.value("(() => { const order = document.getElementById('order'); order.value = 'listed'; order.onchange(); })()")
    return json.loads(text)


def rows(browser):
    return browser.value("[...document.querySelectorAll('#finding-list .row')].map(row => row.textContent)")


def told(browser, number):
    """The sentence and the facts of a finding that is clicked at."""
    browser.value(f"document.querySelectorAll('#finding-list .row')[{number}].click()")
    return browser.value("[document.getElementById('sentence').textContent, [...document.querySelectorAll('#facts li')].map(fact => fact.textContent)]")


def number_in(pattern, facts):
    found = re.search(pattern, " | ".join(facts))
    return float(found.group(1)) if found else None


def is_close(told_number, number):
    return told_number is not None and abs(told_number - number) <= 1e-5 * abs(number)


def segments_of(browser, finding, role):
    """Ends of the segments that are drawn of a finding, in the world."""
    expression = f"""(() => {{ const {{ header }} = toccata.data, found = [];
      for (const layer of header.layers) if (layer.finding === {finding} && layer.role === '{role}' && layer.kind === 'segments')
        found.push(...[...toccata.data.floats(layer.data)].map((x, i) => x * header.frame.size + header.frame.centre[i % 3]));
      return found; }})()"""
    numbers = browser.value(expression)
    return [numbers[i : i + 3] for i in range(0, len(numbers), 3)]


def is_near(place, other, size=1e-5):
    return all(abs(x - y) <= size for x, y in zip(place, other))


def check_rays(checks, browser):
    (checks.folder / "rays.txt").write_text("0 0 9  0 0 -9\n9 9 9, 9 9 10\n-3 0.125 0.25  3 0.125 0.25\n")
    report = drawn_report(checks, browser, "rays", "ray", "gen:icosphere", "gen:box", "--rays", "rays.txt")
    checks.expect(len(rows(browser)) == 3, f"a row for each ray: {rows(browser)}")
    for number, ray in enumerate(report["rays"]):
        sentence, facts = told(browser, number)
        ends = segments_of(browser, number, "ray")
        checks.expect(is_near(ends[0], ray["from"]), f"ray {number} starts at {ends[0]}")
        if not ray["hit"]:
            checks.expect(sentence == f"Ray {number} meets nothing.", sentence)
            continue
        checks.expect(sentence.startswith(f"Ray {number} meets {ray['object']} after "), sentence)
        checks.expect(is_close(number_in(r"after ([-\d.e]+) of its way", [sentence]), ray["upper"]), sentence)
        length = ray["upper"] * math.hypot(*ray["motion"])
        checks.expect(is_close(number_in(r"([-\d.e]+) from its start", facts), length), f"{facts}")
        checks.expect(f"face {ray['face']}" in facts, f"{facts}")
        checks.expect(is_near(ends[1], ray["point"]), f"ray {number} ends at {ends[1]}")
    checks.expect(browser.value("document.getElementById('tab-findings').textContent") == "Rays 3", "the tab")
    browser.press("Escape")
    time.sleep(0.3)
    calls = browser.value("toccata.stage.renderer.info.render.calls")
    checks.expect(calls <= 8, f"all rays in {calls} drawing calls")
    checks.quiet(browser, "rays")


def check_points(checks, browser):
    (checks.folder / "points.txt").write_text("0 0 9\n0.125 0 0\n900 900 900\n")
    report = drawn_report(checks, browser, "points", "nearest", "gen:box", "gen:icosphere", "--points", "points.txt", "--k", "2", "--signed", "--within", "20")
    for number, point in enumerate(report["points"]):
        sentence, facts = told(browser, number)
        checks.expect(len(segments_of(browser, number, "distance")) == 2 * len(point["nearest"]), f"point {number}: its segments")
        if not point["nearest"]:
            checks.expect("nothing within the greatest distance" in sentence, sentence)
            continue
        first = point["nearest"][0]
        checks.expect(f" from {first['object']}, {first['side']} it." in sentence, sentence)
        checks.expect(is_close(number_in(r"signed distance ([-\d.e]+)", facts), first["signed_upper"]), f"{facts}")
        holder = f"inside of {point['inside_of']}" if point["inside_of"] else "inside of no object"
        checks.expect(holder in facts, f"{holder}: {facts}")
        ends = segments_of(browser, number, "distance")
        checks.expect(is_near(ends[0], point["point"]) and is_near(ends[1], first["at"]), f"point {number}: {ends}")
    checks.quiet(browser, "points")


def check_faces(checks, browser):
    report = drawn_report(checks, browser, "faces", "faces", "gen:icosphere", "gen:torus-knot", "--box", *"0 0 0 9 9 9".split())
    count = {}
    for face in report["faces"]:
        count[face["object"]] = count.get(face["object"], 0) + 1
    for number, name in enumerate(count):
        sentence, _ = told(browser, number)
        checks.expect(sentence.startswith(f"{count[name]:,} faces of {name} have a point in the box from (0, 0, 0) to (9, 9, 9)"), sentence)
        drawn = browser.value(f"toccata.data.header.layers.find(layer => layer.finding === {number} && layer.kind === 'faces').data.count")
        found = sum(len(face["triangles"]) for face in report["faces"] if face["object"] == name)
        checks.expect(found <= drawn <= 2 * count[name], f"whole faces are drawn: {drawn} triangles of {name}, {found} of them in the box")
    browser.press("Escape")
    time.sleep(0.3)
    checks.expect(share(browser.picture(), is_blue) > 0.005, "the faces are blue")
    checks.quiet(browser, "faces")


def check_self(checks, browser):
    (checks.folder / "bow.off").write_text("OFF\n5 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 1\n1 1 -1\n3 0 1 2\n3 0 3 4\n")
    report = drawn_report(checks, browser, "self", "check", "bow.off", "gen:box", "--self")
    for number, one in enumerate(report["self_contacts"]):
        sentence, facts = told(browser, number)
        meets = one["face_pairs"] > 0
        checks.expect(sentence == f"{one['object']} {'intersects' if meets else 'does not intersect'} itself.", sentence)
        checks.expect(not meets or "1 face pair in contact" in facts, f"{facts}")
        checks.expect((len(segments_of(browser, number, "contact")) > 0) == meets, f"{sentence} and its curves")
    checks.quiet(browser, "self")


def check_poses(checks, browser):
    """A click moves the object to the pose."""
    (checks.folder / "poses.txt").write_text(f"{ROWS} 0.25 0 0\n{ROWS} 3 0 0\n0 -1 0 1 0 0 0 0 1 0 -4 0\n")
    report = drawn_report(checks, browser, "poses", "check", "gen:box", "gen:icosphere", "--poses", "poses.txt", "--penetration", "--faces")
    checks.expect(len(rows(browser)) == 3, f"{rows(browser)}")
    for number, query in enumerate(report["queries"]):
        sentence, facts = told(browser, number)
        depth = query["penetration"]
        checks.expect(sentence.startswith(f"At pose {number} box "), sentence)
        checks.expect(depth["upper"] == 0 or tells_depth(" | ".join(facts), depth), f"{depth}: {facts}")
        if query["face_pairs"] > 0:
            checks.expect(f"{query['face_pairs']} face pairs in contact" in facts, f"{facts}")
            faces = browser.value(f"toccata.data.header.layers.filter(layer => layer.finding === {number} && layer.kind === 'faces').map(layer => layer.object)")
            checks.expect(faces == [0, 1] and segments_of(browser, number, "contact"), f"pose {number}: the faces of {faces} that meet are drawn")
        at = browser.value("(() => { const { frame } = toccata.data.header; const box = toccata.boxOf(1); const v = box.min.clone().add(box.max).multiplyScalar(0.5); return [v.x * frame.size + frame.centre[0], v.y * frame.size + frame.centre[1]]; })()")
        checks.expect(is_near(at, query["pose_b"][9:11], 1e-3), f"pose {number}: the object is at {at}")
        browser.wait_for(f"toccata.state.finding === {number}")
    pictures = []
    for number in [0, 2]:
        checks.opened(browser, "poses.html", f"#finding={number}&theme=light&labels=0&camera=0,0,0,3,-0.9,0.45")
        time.sleep(0.3)
        pictures.append(browser.picture())
        browser.open("/", "")
    seen, much = differing(*pictures)
    checks.expect(seen > 0.005 and much > 60, f"poses are seen to differ: {seen:.4f}, {much}")
    checks.quiet(browser, "poses")


def check_distances(checks, browser):
    words = ["gen:box", "gen:icosphere", "--poses", "poses.txt"]
    for name, report, key in [
        ("far", drawn_report(checks, browser, "far", "distance", "gen:box", "gen:icosphere", "--pose-b", *f"{ROWS} 9 0.25 0".split()), "pairs"),
        ("ways", drawn_report(checks, browser, "ways", "distance", *words), "queries"),
    ]:
        checks.opened(browser, f"{name}.html")
        for number, found in enumerate(report[key]):
            sentence, facts = told(browser, number)
            if found["upper"] == 0:
                checks.expect("meet" in sentence, sentence)
                continue
            checks.expect(is_close(number_in(r"([-\d.e]+) apart", facts), found["upper"]), f"{facts}")
            ends = segments_of(browser, number, "distance")
            checks.expect(is_near(ends[0], found["on_a"]) and is_near(ends[1], found["on_b"]), f"{name} {number}: {ends}")
            checks.expect(any(fact.startswith(f"face {found['face_a']} of ") for fact in facts), f"{facts}")
        checks.quiet(browser, name)


def check_inspect(checks, browser):
    """Objects in words, and each fault where it is."""
    box = "OFF\n9 11 0\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n3 3 3\n"
    faces = ["0 2 1", "0 3 2", "4 5 6", "4 6 7", "0 1 5", "0 5 4", "2 3 7", "2 7 6", "3 0 4", "3 0 4", "0 0 1"]
    (checks.folder / "open-box.off").write_text(box + "".join(f"3 {face}\n" for face in faces))
    report = drawn_report(checks, browser, "inspect", "inspect", "open-box.off", "gen:icosphere", "--faults")
    broken, whole = report["objects"]
    kinds = [fault["kind"] for fault in broken["faults"]]
    checks.expect("boundary_edges" in kinds and "duplicate_triangles" in kinds and "degenerate_triangles" in kinds and "unused_vertices" in kinds, f"{kinds}")
    checks.expect(len(rows(browser)) == 2 + len(kinds), f"a row for each object and fault: {rows(browser)}")
    sentence, facts = told(browser, 0)
    checks.expect(sentence == f"open-box is open: {broken['unbalanced_edges']} unbalanced edges; taken as a surface.", sentence)
    checks.expect(f"{broken['vertices']} vertices, {broken['distinct_vertices']} distinct" in facts, f"{facts}")
    sentence, facts = told(browser, 1 + len(kinds))
    checks.expect(sentence == "icosphere is closed: may be a solid." and is_close(number_in(r"volume ([-\d.e]+)", facts), whole["signed_volume"]), f"{sentence} {facts}")
    vertices = [[float(x) for x in line.split()] for line in box.splitlines()[2:]]
    for number, fault in enumerate(broken["faults"], start=1):
        sentence, _ = told(browser, number)
        checks.expect(sentence.startswith(f"open-box has {fault['count']} "), sentence)
        drawn = segments_of(browser, number, fault["kind"])
        wanted = [vertices[vertex] for edge in fault.get("edges", []) for vertex in edge]
        if wanted:
            checks.expect(len(drawn) == len(wanted) and all(map(is_near, drawn, wanted)), f"{fault['kind']}: {drawn}")
        checks.expect(fault["kind"] == "unused_vertices" or drawn, f"{fault['kind']} is drawn")
    checks.quiet(browser, "inspect")


def check_trees(checks, browser):
    """The tree of nodes of a scene as it is and rebalanced: numbers of the report, and as many boxes as nodes."""
    checks.run("demo", "--write", "scenes")
    report = drawn_report(checks, browser, "trees", "inspect", "scenes/robot/scene.json", "--hierarchy")
    checks.expect(len(rows(browser)) == 3, f"{rows(browser)}")
    for number, name in enumerate(["as_is", "cured", "rebuilt"]):
        tree = report[name]
        sentence, facts = told(browser, number)
        checks.expect(sentence.startswith(f"The tree of nodes {name.replace('_', ' ').replace('as is', 'as it is')} finds all pairs"), sentence)
        checks.expect(is_close(number_in(r"F = ([-\d.e]+)", [sentence]), tree["F"]), f"{tree['F']}: {sentence}")
        checks.expect(any(fact.startswith(f"{tree['nodes']} nodes over {tree['leaves']} objects, {tree['depth']} deep") for fact in facts), f"{facts}")
        layers = browser.value(f"toccata.data.header.layers.filter(layer => layer.kind === 'boxes').slice({2 * number}, {2 * number + 2})")
        checks.expect(layers[0]["finding"] == number and layers[0]["data"]["count"] == 6 * tree["nodes"], f"{layers[0]}")
        checks.expect([step["count"] for step in layers[1]["steps"]] == [level["nodes"] for level in tree["levels"]], f"{layers[1]['steps']}")
    before = browser.picture()
    browser.press("Escape")
    browser.value("(() => { const slider = document.querySelector('#layers input[type=range]'); slider.value = '2'; slider.oninput(); })()")
    time.sleep(0.3)
    checks.expect(differing(before, browser.picture())[0] > 0.001, "a level is drawn")
    checks.quiet(browser, "trees")


def check_costs(checks, browser):
    """Measured again each time, so the page is compared with the report that it holds, and that with the kept one."""
    report = json.loads(checks.run("cost", "gen:torus", "gen:icosphere", "--poses", "poses.txt", "--volumes", "aabb,obb,ball", "--quick", "--json"))
    (checks.folder / "cost.json").write_text(json.dumps(report))
    checks.run("view", "cost.json", "-o", "cost.html")
    checks.opened(browser, "cost.html", "#theme=light")
    now = browser.value("toccata.data.report")
    key = lambda row: (row["workload"], row["volume"], row["arity"], row["builder"], row["N_u"], row["N_bv"], row["N_p"])
    checks.expect(sorted(map(key, now["rows"])) == sorted(map(key, report["rows"])), "the same counts")
    checks.expect(len(rows(browser)) == len(report["rows"]), f"a row for each hierarchy: {len(rows(browser))}")
    for number in (0, len(now["rows"]) - 1):
        row = now["rows"][number]
        sentence, facts = told(browser, number)
        checks.expect(sentence.startswith(f"With {row['volume']}, {row['arity']} children a node, built by {row['builder']}"), sentence)
        checks.expect(is_close(number_in(r"([-\d.e]+) pairs of volumes compared", facts), row["N_bv"] / row["queries"]), f"{facts}")
    at = [now["objects"][1]["pose"][9:12], [0.25, 0, 0]]
    checks.expect(is_near(*at), f"the first pose is drawn: {at}")
    volumes = {row["volume"] for i, row in enumerate(now["rows"]) if i == 0 or row["workload"] != now["rows"][i - 1]["workload"]}
    names = browser.value("toccata.data.header.layers.filter(layer => layer.kind === 'hierarchy').map(layer => layer.name)")
    checks.expect(len(names) == 2 * len(volumes) and all(any(volume in name for name in names) for volume in volumes), f"{names}")
    checks.quiet(browser, "cost")


def check_crowd_again(checks, browser):
    report = checks.run("crowd", "--count", "60", "--frames", "5", "--seed", "7", "--method", "grid", "--json")
    (checks.folder / "crowd.json").write_text(report)
    checks.run("view", "crowd.json", "-o", "again.html")
    checks.opened(browser, "again.html", "#theme=light&moment=5")
    pairs = json.loads(report)["methods"][0]["pairs"]
    note = browser.value("toccata.data.header.time.moments[5].note")
    checks.expect(note.startswith(f"{pairs} pair"), f"{pairs} pairs: {note}")
    checks.quiet(browser, "crowd")


def check_made(checks, browser):
    """Convex parts, and a sum, are objects of the page."""
    report = drawn_report(checks, browser, "decompose", "decompose", "gen:gear", "--parts", "3")
    checks.expect(len(rows(browser)) == 3, f"a row for each part: {rows(browser)}")
    for number, part in enumerate(report["parts"]):
        sentence, facts = told(browser, number)
        checks.expect(sentence.startswith(part["name"] + " lies "), sentence)
        checks.expect(is_close(number_in(r"volume ([-\d.e]+)", facts), part["volume"]), f"{facts}")
    checks.quiet(browser, "decompose")
    report = drawn_report(checks, browser, "minkowski", "minkowski", "gen:box", "gen:icosphere?subdivisions=1", "--difference", "--point", "0", "0", "0")
    sentence, facts = told(browser, 0)
    checks.expect(sentence == f"box − icosphere is a solid of {len(report['vertices'])} vertices.", sentence)
    of_edges = sum(face["kind"] == "of edges" for face in report["faces"])
    checks.expect(of_edges > 1 and f"{of_edges} faces of edges" in facts, f"{facts}")
    checks.expect("(0, 0, 0) lies inside" in facts and report["point"]["side"] == "inside", f"{facts}")
    checks.quiet(browser, "minkowski")


def check_names(checks, browser):
    """Names are text, whatever was asked."""
    checks.write_scene("wicked.json", [{"name": WICKED, "shape": BOX}, {"name": "b", "shape": BOX, "pose": moved(3)}])
    for name, words in [
        ("ray", ["ray", "wicked.json", "--from", "0", "0", "9", "--to", "0", "0", "-9"]),
        ("nearest", ["nearest", "wicked.json", "--point", "0", "0", "9", "--signed"]),
        ("faces", ["faces", "wicked.json", "--ball", "0", "0", "0", "1.5"]),
        ("self", ["check", "wicked.json", "--self"]),
        ("distance", ["distance", "wicked.json"]),
        ("inspect", ["inspect", "wicked.json"]),
        ("trees", ["inspect", "wicked.json", "--hierarchy"]),
    ]:
        drawn_report(checks, browser, f"wicked-{name}", *words)
        sentence, _ = told(browser, 0)
        checks.expect((name == "trees" or WICKED in sentence) and browser.value("document.images.length") == 0, f"{name}: a name is shown as it is: {sentence}")
        checks.quiet(browser, f"wicked {name}")


def main():
    if find_chromium() is None:
        print("SKIPPED: no Chromium is installed (apt-get install chromium)")
        return 77
    with tempfile.TemporaryDirectory() as name, Browser() as browser:
        folder = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else pathlib.Path(name)
        checks = Checks(pathlib.Path(sys.argv[1]).resolve(), folder)
        for check in [check_rays, check_points, check_faces, check_self, check_poses, check_distances, check_inspect, check_made, check_trees, check_costs, check_crowd_again, check_names, check_sentences, check_faces_drawn]:
            check(checks, browser)
    print(f"findings: {checks.count} checks, {len(checks.failures)} failures")
    return 1 if checks.failures else 0


if __name__ == "__main__":
    sys.exit(main())
