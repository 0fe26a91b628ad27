#!/usr/bin/env python3
"""Opens pages that the command wrote in Chromium, clicks through them, and compares what they say with the engine's JSON.

usage: check_pages.py TOCCATA [FOLDER]     with FOLDER, what was seen is kept there

Exits with 77, which CTest takes for skipped, where Chromium is not installed.
"""
import json
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from browser import Browser, find_chromium  # noqa: E402
from check_crowd import check_crowd, check_crowd_of_methods, check_large_crowd  # noqa: E402
from check_layers import check_creases, check_layer_calls, check_shown  # noqa: E402
from check_partitions import check_partitions, check_tracked_cells  # noqa: E402
from check_robot import check_robot  # noqa: E402
from check_subdivided import check_subdivided  # noqa: E402
from check_walk import check_walk  # noqa: E402
from check_world import check_large_world, check_world  # noqa: E402
from page_content import content_of, tells_depth, with_content  # noqa: E402
from pixels import differing, is_blue, is_orange, share  # noqa: E402

TURNED = "a\u202egnp.exe\x07"
WICKED = "</script><img src=x onerror=alert(1)><!--"
BOX = {"type": "box", "half_extents": [1, 1, 1]}


class Checks:
    def __init__(self, command, folder):
        self.command, self.folder, self.failures, self.count = command, folder, [], 0

    def expect(self, holds, what):
        self.count += 1
        if not holds:
            self.failures.append(what)
            print(f"FAILED: {what}")

    def run(self, *words):
        result = subprocess.run([self.command, *words], cwd=self.folder, capture_output=True, text=True)
        if result.returncode == 2:
            raise RuntimeError(result.stderr)
        return result.stdout

    def write_scene(self, name, objects, unit="m", **more):
        scene = {"format": "toccata-scene", "version": 1, "unit": unit, "objects": objects, **more}
        (self.folder / name).write_text(json.dumps(scene))

    def opened(self, browser, name, end=""):
        browser.open(self.folder / name, end)
        browser.wait_for("window.toccata && toccata.stage.drawn > 0 || !document.getElementById('notice').hidden")

    def quiet(self, browser, name):
        self.expect(browser.complaints() == [], f"{name}: {browser.complaints()}")


def moved(x, y=0.0, z=0.0):
    return [1, 0, 0, 0, 1, 0, 0, 0, 1, x, y, z]


def check_contacts(checks, browser):
    report = json.loads(checks.run("check", "scenes/gears/scene.json", "--penetration", "--faces", "--json", "--html", "gears.html"))
    checks.opened(browser, "gears.html")
    pairs = report["pairs"]
    rows = browser.value("[...document.querySelectorAll('#finding-list .row')].map(row => row.textContent)")
    checks.expect(len(rows) == len(pairs), f"{len(rows)} rows for {len(pairs)} pairs")
    browser.value("document.querySelector('#finding-list .row').click()")
    checks.expect(not browser.value("document.getElementById('found').hidden"), "a click tells the sentence")
    sentence = browser.value("document.getElementById('sentence').textContent")
    pair = pairs[0]
    checks.expect(sentence == f"{pair['a']} overlaps {pair['b']} (both solids).", f"the sentence: {sentence}")
    facts = browser.value("document.getElementById('facts').textContent")
    checks.expect(tells_depth(facts, pair["penetration"]), f"the depth {pair['penetration']}: {facts}")
    checks.expect(f"; moving {pair['b']} by " in facts, f"which of the two is moved: {facts}")
    checks.expect(f"{len(pair['faces'])} face pairs in contact" in facts, f"the face pairs: {facts}")
    checks.expect("decided exactly, by tree, exact pairs, winding numbers" in facts, f"the method: {facts}")
    time.sleep(0.3)
    picture = browser.picture()
    checks.expect(share(picture, is_blue) > 0.005, "the first object is blue")
    checks.expect(share(picture, is_orange) > 0.005, "the second object is orange")
    checks.quiet(browser, "gears")


def check_view(checks, browser):
    """Drawing on demand, the link, keys, and a double click, on the page that is open."""
    drawn = browser.value("toccata.stage.drawn")
    time.sleep(0.6)
    checks.expect(browser.value("toccata.stage.drawn") == drawn, "nothing is drawn while nothing changes")
    check_calls(checks, browser)
    browser.press("ArrowLeft")
    browser.wait_for(f"toccata.stage.drawn > {drawn}")
    link = browser.value("toccata.link()")
    checks.opened(browser, "gears.html", link)
    browser.wait_for("toccata.state.finding === 0")
    checks.expect(browser.value("toccata.link()") == link, "a link restores the view")
    before = browser.value("toccata.stage.orbit.place.distance")
    x, y = browser.value("(() => { for (let x = 500; x < 1000; x += 10) for (let y = 200; y < 700; y += 10) if (toccata.stage.hit(x, y)) return [x, y]; })()")
    browser.click(x, y, 2)
    browser.wait_for(f"toccata.stage.orbit.place.distance < {before}", 10)
    browser.press("Escape")
    checks.expect(browser.value("document.getElementById('found').hidden"), "Escape leaves the pair")
    browser.press("n")
    checks.expect(browser.value("toccata.state.finding") == 0, "N goes to the next pair")
    browser.value("document.getElementById('tab-objects').click()")
    browser.value("document.querySelector('#object-list .small').click()")
    checks.expect(browser.value("[...toccata.state.hidden]") == [0], "an object can be hidden")
    checks.quiet(browser, "gears again")


def check_calls(checks, browser):
    """A call for each layer of the finding that is looked at, and one for the frame of its place."""
    kinds = browser.value("toccata.data.header.layers.filter(layer => layer.finding === toccata.state.finding).map(layer => layer.kind)")
    checks.expect({"segments", "arrows", "triangles", "faces", "points"} <= set(kinds), f"layers of many kinds: {kinds}")
    drawn = browser.value("toccata.stage.overlays.children.length")
    checks.expect(drawn == len(kinds) + 1, f"{drawn} drawings for {len(kinds)} layers and a frame")
    gears, ghosts, grid, frame = 1, 1, 1, 1
    calls = browser.value("toccata.stage.renderer.info.render.calls")
    checks.expect(calls == gears + ghosts + grid + frame + len(kinds), f"{calls} drawing calls for gears, ghosts, grid, frame and {kinds}")


def check_wicked_names(checks, browser):
    objects = [{"name": WICKED, "shape": BOX}, {"name": "b", "shape": BOX, "pose": [1, 0, 0, 0, 1, 0, 0, 0, 1, 1.5, 0, 0]}]
    scene = {"format": "toccata-scene", "version": 1, "unit": "mm", "objects": objects}
    (checks.folder / "wicked.json").write_text(json.dumps(scene))
    checks.run("view", "wicked.json", "-o", "wicked.html")
    checks.opened(browser, "wicked.html", "#finding=0")
    browser.wait_for("!document.getElementById('found').hidden")
    checks.expect(browser.value("document.images.length") == 0, "a name made an image")
    checks.expect(WICKED in browser.value("document.getElementById('sentence').textContent"), "a name is shown as it is")
    checks.quiet(browser, "wicked")


def check_many(checks, browser):
    ball = {"type": "sphere", "radius": 1}
    capsules = [{"type": "capsule", "radius": 1 - i / 4, "start": [0, 0, 0], "end": [0, 0, 1]} for i in range(3)]
    for name, shapes in [("boxes", [BOX]), ("balls", [ball]), ("capsules", capsules), ("mixed", [BOX, ball, *capsules])]:
        poses = (moved(3.0 * (i % 100), 3.0 * (i // 100)) for i in range(10_000))
        checks.write_scene("many.json", [{"name": f"{i}", "shape": shapes[i % len(shapes)], "pose": pose} for i, pose in enumerate(poses)])
        checks.run("view", "many.json", "-o", "many.html")
        size = (checks.folder / "many.html").stat().st_size / 1e6
        started = time.monotonic()
        checks.opened(browser, "many.html")
        print(f"10,000 {name}: {size:.2f} MB, drawn in {time.monotonic() - started:.2f} s")
        calls = browser.value("toccata.stage.renderer.info.render.calls")
        checks.expect(calls <= 6, f"10,000 {name} in {calls} drawing calls")
        checks.expect(size < 6, f"10,000 {name}: {size:.2f} MB")
        triangles = browser.value("toccata.stage.renderer.info.render.triangles")
        checks.expect(triangles < 700_000, f"10,000 {name}: {triangles} triangles")
    browser.value("toccata.toggle([0, 1], 'ghosts')")
    time.sleep(0.3)
    checks.expect(browser.value("toccata.stage.renderer.info.render.calls") <= 6, "with ghosts as well")
    checks.quiet(browser, "many")


def check_writing(checks, browser):
    """A page is written in less than a second for each million triangles: beside reading the mesh and looking at it."""

    def seconds(*words):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        checks.run(*words)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime

    mesh = "gen:uv-sphere?around=1000&along=501"
    without, whole = seconds("check", mesh, "gen:box"), seconds("check", mesh, "gen:box", "--html", "million.html")
    size = (checks.folder / "million.html").stat().st_size / 1e6
    print(f"a million triangles: {size:.1f} MB, written in {whole - without:.2f} s of a processor, with {without:.2f} s of everything before")
    checks.expect(whole - without < 1, f"written in {whole - without:.2f} s")
    checks.expect(size < 40, f"a million triangles in {size:.1f} MB")


def check_large(checks, browser):
    """Two meshes of the size of the bunny, at one place of a file."""
    moved = ["--pose-b", *"1 0 0 0 1 0 0 0 1 0.5 0.1 0".split()]
    started = time.monotonic()
    checks.run("view", "gen:uv-sphere?around=264&along=133", "gen:uv-sphere?around=264&along=133", *moved, "-o", "large.html")
    wrote = time.monotonic() - started
    size = (checks.folder / "large.html").stat().st_size / 1e6
    started = time.monotonic()
    checks.opened(browser, "large.html")
    print(f"two meshes of 69,696 triangles: {size:.2f} MB, checked and written in {wrote:.2f} s, drawn in {time.monotonic() - started:.2f} s")
    checks.expect(size < 3, f"{size:.2f} MB")
    checks.quiet(browser, "large")


def check_shapes(checks, browser):
    """Shapes that are no meshes have no faces; nothing wrong may be said of them."""
    objects = [{"name": "a", "shape": BOX}, {"name": "b", "shape": {"type": "sphere", "radius": 1}, "pose": [1, 0, 0, 0, 1, 0, 0, 0, 1, 1.5, 0, 0]}]
    scene = {"format": "toccata-scene", "version": 1, "unit": "m", "objects": objects}
    (checks.folder / "shapes.json").write_text(json.dumps(scene))
    checks.run("view", "shapes.json", "--penetration", "-o", "shapes.html")
    checks.opened(browser, "shapes.html", "#finding=0")
    browser.wait_for("!document.getElementById('found').hidden")
    facts = browser.value("[...document.querySelectorAll('#facts li')].map(fact => fact.textContent)")
    told = ["0.5 m deep; moving b by it along (1, 0, 0) parts them", "1 point of contact", "decided exactly, by exact signs of separating normals"]
    checks.expect(facts == [*told, "depth by expanding polytope, certified bracket"], f"{facts}")
    checks.quiet(browser, "shapes")


def check_rest(checks, browser):
    """What is not of the chosen pair is there as a ghost: seen, and faint."""
    shapes = [("a", 0), ("b", 1.5), ("c", -2.5), ("d", 4)]
    objects = [{"name": name, "shape": BOX, "pose": moved(x)} for name, x in shapes]
    checks.write_scene("rest.json", objects)
    checks.run("view", "rest.json", "--clearance", "1", "-o", "rest.html")
    camera = "camera=0,0,0,6,-0.9,0.45"
    pictures = {}
    for rest in ["ghost", "shown", "hidden"]:
        checks.opened(browser, "rest.html", f"#finding=1&labels=0&rest={rest}&{camera}")
        browser.wait_for(f"toccata.state.rest === '{rest}' && toccata.state.finding === 1")
        time.sleep(0.3)
        pictures[rest] = browser.picture()
        browser.open("/", "")  # so that another end of the link opens the page anew
    seen, much = differing(pictures["ghost"], pictures["hidden"])
    checks.expect(seen > 0.004, f"ghosts cover {seen:.4f} of the picture")
    checks.expect(much < 90, f"ghosts differ by {much} from what is behind them")
    seen, much = differing(pictures["shown"], pictures["hidden"])
    checks.expect(seen > 0.004 and much > 60, f"the rest can be shown: {seen:.4f}, {much}")
    report = json.loads(checks.run("check", "rest.json", "--clearance", "1", "--json"))
    checks.opened(browser, "rest.html", "#finding=0")
    for number, pair in enumerate(report["pairs"]):
        browser.value(f"toccata.choose({number})")
        facts = browser.value("document.getElementById('facts').textContent")
        apart = re.match(r"([-\d.e+]+) m apart", facts)
        checks.expect((float(apart.group(1)) if apart else 0) == pair["distance"]["upper"], f"the distance: {facts}")
    tab = browser.value("document.getElementById('tab-findings').textContent")
    checks.expect(tab == "Contacts 1 · near 2", f"the tab counts: {tab}")
    checks.quiet(browser, "rest")


def check_links(checks, browser):
    """What a link asks for in vain is told."""
    complaint = "document.getElementById('complaint').hidden ? '' : document.getElementById('complaint-text').textContent"
    browser.open("/", "")
    checks.opened(browser, "rest.html", "#finding=7&colour=red&hidden=0-2,9&steps=0:4&theme=loud&camera=1,2&finding=0")
    told = browser.value(complaint)
    for words in ["no finding “7”: here findings are 0 to 2", "“colour”", "no object “9”", "no slider “0”", "“theme” is one of", "“camera”", "“finding” is said twice"]:
        checks.expect(words in told, f"{words} is not told: {told}")
    checks.expect(browser.value("[...toccata.state.hidden]") == [0, 1, 2], "what is understood is done")
    browser.value("document.getElementById('complaint-seen').click()")
    checks.expect(browser.value(complaint) == "", "the complaint can be closed")
    browser.open("/", "")
    checks.opened(browser, "levels.html", "#steps=0:99")
    checks.expect("no step “99”: here steps are 0 to" in browser.value(complaint), "a step that is not there is told")
    checks.expect(browser.value("toccata.state.steps.size") == 0, "a step that is not there hides nothing")
    browser.open("/", "")
    checks.opened(browser, "levels.html", "#steps=0:2")
    checks.expect(browser.value("toccata.state.steps.get(0)") == 2 and browser.value(complaint) == "", "a step is shown")
    checks.expect("steps=0:2" in browser.value("toccata.link()"), "a step is in the link")
    checks.quiet(browser, "links")


def check_turned_names(checks, browser):
    """Names that turn the writing round stay within themselves; a unit that is a number multiplies."""
    checks.write_scene("turned.json", [{"name": TURNED, "shape": BOX}, {"name": "שלום 1", "shape": BOX, "pose": moved(1.5)}], 0.3)
    checks.run("view", "turned.json", "--penetration", "-o", "turned.html")
    checks.opened(browser, "turned.html", "#finding=0")
    sentence = browser.value("document.getElementById('sentence').textContent")
    checks.expect(sentence == "a\\u202egnp.exe\\u0007 overlaps שלום 1 (both solids).", f"the sentence: {sentence}")
    edges = browser.value("[...document.querySelectorAll('#sentence bdi')].map(name => [name.getBoundingClientRect().left, name.getBoundingClientRect().right])")
    checks.expect(len(edges) == 2 and edges[0][1] < edges[1][0], f"the names stand in their order: {edges}")
    shown = browser.value("document.body.innerText + document.title")
    checks.expect(not re.search("[\u202a-\u202e\x07]", shown), "no name turns the writing round")
    checks.expect("0.5 × 0.3 m deep" in shown and "in units of 0.3 m" in shown, f"the unit: {shown}")
    checks.quiet(browser, "turned")


def check_extremes(checks, browser):
    """Scenes at the ends of the doubles are drawn, and depths beyond them told."""
    balls = [{"name": name, "shape": {"type": "sphere", "radius": 1.7e308}, "pose": moved(x)} for name, x in [("a", 0), ("b", 1)]]
    checks.write_scene("huge.json", balls)
    for name, far, near in [("wide.off", "1.7e308", "-1.7e308"), ("tiny.off", "5e-324", "0")]:
        (checks.folder / name).write_text(f"OFF\n4 4 0\n{near} 0 0\n{far} 0 0\n0 {far} 0\n0 0 {far}\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
    for name, what in [("huge.json", "--penetration"), ("wide.off", "--penetration"), ("tiny.off", "--penetration")]:
        checks.run("view", name, what, "-o", f"{name}.html")
        checks.opened(browser, f"{name}.html")
        time.sleep(0.3)
        with_it = browser.picture()
        browser.value("toccata.toggle(toccata.data.report.objects.map((_, i) => i), 'hidden')")
        time.sleep(0.3)
        seen, _ = differing(with_it, browser.picture())
        checks.expect(seen > 0.05, f"{name} covers {seen:.4f} of the picture")
        bar = browser.value("document.getElementById('scale').textContent")
        checks.expect(re.fullmatch(r"[\d.]+(e[-+]\d+)?( m)?", bar) is not None, f"{name}: the bar tells {bar}")
    checks.opened(browser, "huge.json.html", "#finding=0")
    browser.wait_for("toccata.state.finding === 0")
    facts = browser.value("document.getElementById('facts').textContent")
    checks.expect(facts.startswith("at least 1.79769e+308 m deep; moving b far enough along"), f"an infinite depth: {facts}")
    checks.quiet(browser, "extremes")


def check_tree(checks, browser):
    frames = [{"name": "arm"}, {"name": "hand", "parent": "arm", "pose": moved(3)}]
    parts = [("base", None), ("upper", "arm"), ("finger", "hand"), ("thumb", "hand")]
    objects = [{"name": name, "shape": BOX, "pose": moved(3 * i)} | ({"parent": parent} if parent else {}) for i, (name, parent) in enumerate(parts)]
    checks.write_scene("tree.json", objects, frames=frames)
    checks.run("view", "tree.json", "-o", "tree.html")
    checks.opened(browser, "tree.html")
    rows = "[...document.querySelectorAll('#object-list li')].map(row => [row.getAttribute('aria-level'), row.querySelector('.row bdi').textContent].join(' '))"
    listed = browser.value(rows)
    checks.expect(sorted(listed) == sorted(["1 base", "1 arm", "2 hand", "3 finger", "3 thumb", "2 upper"]), f"the tree: {listed}")
    press = "[...document.querySelectorAll('#object-list li')].find(row => row.querySelector('.row bdi').textContent === '{}').querySelectorAll('.small')[{}].click()"
    browser.value(press.format("hand", 0))
    checks.expect(browser.value("[...toccata.state.hidden].sort()") == [2, 3], "a node is hidden with all under it")
    browser.value(press.format("hand", 0))
    checks.expect(browser.value("toccata.state.hidden.size") == 0, "and shown again")
    browser.value(press.format("arm", 1))
    checks.expect(browser.value("[...toccata.state.ghosts].sort()") == [1, 2, 3], "a node becomes a ghost")
    browser.value(press.format("arm", 2))
    checks.expect(browser.value("[...toccata.state.only].sort()") == [1, 2, 3], "a node is shown alone")
    link = browser.value("toccata.link()")
    checks.expect("only=1-3" in link and "ghosts=1-3" in link, f"the link holds it: {link}")
    browser.value("document.querySelector('#object-list .fold').click()")
    checks.expect(len(browser.value(rows)) == 2, "a node can be folded")
    browser.value("document.getElementById('filter').value = 'thumb'; document.getElementById('filter').oninput()")
    checks.expect(browser.value(rows) == ["1 arm", "2 hand", "3 thumb"], "what is found is listed with what it is under")
    checks.quiet(browser, "tree")


def check_narrow(checks, browser):
    """A telephone: everything is within the window, and the picture has its share of it."""
    browser.resize(480, 800)
    checks.opened(browser, "gears.html", "#finding=0")
    time.sleep(0.3)
    wide = browser.value("document.documentElement.scrollWidth")
    canvas = browser.value("[toccata.stage.canvas.clientWidth, toccata.stage.canvas.clientHeight]")
    found = browser.value("(box => [box.left, box.right, box.bottom])(document.getElementById('found').getBoundingClientRect())")
    checks.expect(wide <= 480, f"the page is {wide} pixels wide")
    checks.expect(canvas[0] >= 460 and canvas[1] >= 250, f"the picture has {canvas}")
    checks.expect(found[0] >= 0 and found[1] <= 480 and found[2] <= 800, f"the sentence is at {found}")
    covered = browser.value("document.getElementById('found').getBoundingClientRect().top < toccata.stage.canvas.getBoundingClientRect().bottom - 1")
    checks.expect(not covered, "the sentence covers nothing of the picture")
    browser.resize(1300, 800)
    checks.opened(browser, "gears.html")
    told = browser.value("document.getElementById('summary').textContent")
    checks.expect(told.startswith("in m · 3 objects"), f"the summary: {told}")
    checks.quiet(browser, "narrow")
    browser.resize(1200, 800)


def check_hierarchy(checks, browser):
    checks.run("view", "gen:torus-knot", "--hierarchy", "obb", "-o", "levels.html")
    checks.opened(browser, "levels.html")
    steps = browser.value("toccata.data.header.layers[0].steps")
    browser.wait_for("toccata.state.steps.get(0) === 3")
    slide = "const slider = document.querySelector('#layers input[type=range]'); slider.value = 5; slider.oninput();"
    browser.value(f"(() => {{ {slide} }})()")
    told = browser.value("document.querySelector('#layers output').textContent")
    checks.expect(told == f"level 5: {steps[5]['note']}", f"the level tells {told}")
    checks.expect(f"{steps[5]['count']} volumes" in told, f"the level tells {told}")
    look_at_level(checks, browser, 5, "oriented boxes")
    for volume in ["ball", "lss", "rss", "ellipsoid"]:
        checks.run("view", "gen:torus-knot", "--hierarchy", volume, "-o", "round.html")
        browser.open("/", "")
        checks.opened(browser, "round.html", "#steps=0:4&theme=light")
        checks.expect(browser.value("toccata.data.header.layers[0].rounds.count % 18 === 0"), f"{volume}: the volumes as they are")
        look_at_level(checks, browser, 4, volume)
    checks.quiet(browser, "levels")


def look_at_level(checks, browser, level, what):
    time.sleep(0.3)
    picture = browser.picture()
    checks.expect(share(picture, is_blue) > 0.01 and share(picture, is_orange) > 0.01, f"{what}: nodes have colours of their own")
    calls = browser.value("toccata.stage.renderer.info.render.calls")
    checks.expect(calls <= 3, f"{what}: volumes, triangles and grid in {calls} drawing calls")
    dark = picture
    for place in range(300, 1200, 30):
        browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=place, y=420)
        lit = browser.value("document.getElementById('hover').textContent")
        if lit:
            break
    checks.expect(re.fullmatch(rf"node \d+ of level {level}: [\d,]+ triangles?", lit) is not None, f"{what}: a node lights up: {lit}")
    time.sleep(0.3)
    seen, much = differing(dark, browser.picture())
    checks.expect(seen > 0.001 and much > 60, f"{what}: its triangles are seen to: {seen:.4f}, {much}")


def check_empty(checks, browser):
    text = (checks.folder / "wicked.html").read_text()
    header, report = (json.loads(content_of(text, name)) for name in ("header", "report"))
    header.update(objects=[], meshes=[], layers=[], words=[])
    report.update(objects=[], pairs=[])
    text = with_content(with_content(text, "header", header), "report", report)
    (checks.folder / "empty.html").write_text(text)
    checks.opened(browser, "empty.html")
    checks.expect("empty" in browser.value("document.getElementById('notice').textContent"), "an empty scene says so")
    checks.quiet(browser, "empty")


def check_case(checks, browser):
    """A case that asks for a distance: the page says the number that was recorded."""
    away = ["--pose-b", *"1 0 0 0 1 0 0 0 1 9 0.25 0".split()]
    checks.run("distance", "gen:box", "gen:icosphere", *away, "--save-case", "far.json")
    recorded = json.loads((checks.folder / "far.json").read_text())["answer"]["pairs"][0]["upper"]
    checks.run("view", "far.json", "-o", "far.html")
    checks.opened(browser, "far.html", "#finding=0")
    browser.wait_for("!document.getElementById('found').hidden")
    facts = browser.value("document.getElementById('facts').textContent")
    told = re.search(r"([-\d.e]+) apart", facts)
    checks.expect(told and abs(float(told.group(1)) / recorded - 1) < 1e-5, f"the distance {recorded}: {facts}")
    checks.quiet(browser, "far")


def check_measuring(checks, browser):
    """The benchmark of drawing sees both meshes, and tells what it measured; times are not judged."""
    script = pathlib.Path(__file__).resolve().parent / "measure_drawing.py"
    words = ["--page", "two", "--mesh", "gen:torus", "--runs", "1", "--size", "1000x700", "--json"]
    result = subprocess.run([sys.executable, script, checks.command, *words], capture_output=True, text=True)
    checks.expect(result.returncode == 0, f"the benchmark of drawing: {result.returncode} {result.stderr}")
    page = json.loads(result.stdout)["pages"][0]
    checks.expect(page["triangles"] == 3072 and page["face_pairs"] > 0 and page["both_seen"], f"what was drawn: {page}")
    checks.expect(0 < page["drawn_s"] <= page["picture_s"] and page["processor_s"] > 0, f"what was measured: {page}")


def main():
    if find_chromium() is None:
        print("SKIPPED: no Chromium is installed (apt-get install chromium)")
        return 77
    with tempfile.TemporaryDirectory() as name, Browser() as browser:
        folder = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else pathlib.Path(name)
        checks = Checks(pathlib.Path(sys.argv[1]).resolve(), folder)
        checks.run("demo", "--write", "scenes")
        for check in [check_contacts, check_view, check_wicked_names, check_many, check_writing, check_large, check_shapes, check_hierarchy, check_rest, check_links, check_turned_names, check_extremes, check_tree, check_narrow, check_case, check_crowd, check_crowd_of_methods, check_large_crowd, check_partitions, check_tracked_cells, check_layer_calls, check_creases, check_shown, check_world, check_large_world, check_walk, check_robot, check_subdivided, check_empty, check_measuring]:
            check(checks, browser)
    print(f"pages: {checks.count} checks, {len(checks.failures)} failures")
    return 1 if checks.failures else 0


if __name__ == "__main__":
    sys.exit(main())
