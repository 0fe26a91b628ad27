#!/usr/bin/env python3
"""Opens pages that the command wrote in Chromium, clicks through them, and compares what they say with the engine's JSON.

usage: check_pages.py TOCCATA [FOLDER]     with FOLDER, what was seen is kept there

Exits with 77, which CTest takes for skipped, where Chromium is not installed.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from browser import Browser, find_chromium  # noqa: E402

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

    def opened(self, browser, name, end=""):
        browser.open(self.folder / name, end)
        browser.wait_for("window.toccata && toccata.stage.drawn > 0 || !document.getElementById('notice').hidden")

    def quiet(self, browser, name):
        self.expect(browser.complaints() == [], f"{name}: {browser.complaints()}")


def share(picture, is_colour):
    pixels = [pixel for row in picture for pixel in row]
    return sum(map(is_colour, pixels)) / len(pixels)


def is_blue(pixel):
    red, green, blue = pixel
    return blue > 110 and blue > red + 50 and blue > green + 20


def is_orange(pixel):
    red, green, blue = pixel
    return red > 110 and red > blue + 90 and green > blue + 20


def check_contacts(checks, browser):
    report = json.loads(checks.run("check", "scenes/gears/scene.json", "--penetration", "--faces", "--json", "--html", "gears.html"))
    checks.opened(browser, "gears.html")
    pairs = report["pairs"]
    rows = browser.value("[...document.querySelectorAll('#pair-list .row')].map(row => row.textContent)")
    checks.expect(len(rows) == len(pairs), f"{len(rows)} rows for {len(pairs)} pairs")
    browser.value("document.querySelector('#pair-list .row').click()")
    checks.expect(not browser.value("document.getElementById('found').hidden"), "a click tells the sentence")
    sentence = browser.value("document.getElementById('sentence').textContent")
    pair = pairs[0]
    checks.expect(sentence == f"{pair['a']} overlaps {pair['b']} (both solids).", f"the sentence: {sentence}")
    facts = browser.value("document.getElementById('facts').textContent")
    depth = float(re.search(r"([-\d.e]+) m deep", facts).group(1))
    checks.expect(abs(depth / pair["penetration"]["upper"] - 1) < 1e-5, f"the depth: {depth}")
    checks.expect(f"{len(pair['faces'])} face pairs in contact" in facts, f"the face pairs: {facts}")
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
    calls = browser.value("toccata.stage.renderer.info.render.calls")
    checks.expect(calls <= 3 * 2 + 2 * 8 + 1, f"{calls} drawing calls")
    browser.press("ArrowLeft")
    browser.wait_for(f"toccata.stage.drawn > {drawn}")
    link = browser.value("toccata.link()")
    checks.opened(browser, "gears.html", link)
    browser.wait_for("toccata.state.pair === 0")
    checks.expect(browser.value("toccata.link()") == link, "a link restores the view")
    before = browser.value("toccata.stage.orbit.place.distance")
    browser.click(700, 400, 2)
    browser.wait_for(f"toccata.stage.orbit.place.distance < {before}", 10)
    browser.press("Escape")
    checks.expect(browser.value("document.getElementById('found').hidden"), "Escape leaves the pair")
    browser.press("n")
    checks.expect(browser.value("toccata.state.pair") == 0, "N goes to the next pair")
    browser.value("document.getElementById('tab-objects').click()")
    browser.value("document.querySelector('#object-list .small').click()")
    checks.expect(browser.value("[...toccata.state.hidden]") == [0], "an object can be hidden")
    checks.quiet(browser, "gears again")


def check_wicked_names(checks, browser):
    objects = [{"name": WICKED, "shape": BOX}, {"name": "b", "shape": BOX, "pose": [1, 0, 0, 0, 1, 0, 0, 0, 1, 1.5, 0, 0]}]
    scene = {"format": "toccata-scene", "version": 1, "unit": "mm", "objects": objects}
    (checks.folder / "wicked.json").write_text(json.dumps(scene))
    checks.run("view", "wicked.json", "-o", "wicked.html")
    checks.opened(browser, "wicked.html", "#pair=0")
    browser.wait_for("!document.getElementById('found').hidden")
    checks.expect(browser.value("document.images.length") == 0, "a name made an image")
    checks.expect(WICKED in browser.value("document.getElementById('sentence').textContent"), "a name is shown as it is")
    checks.quiet(browser, "wicked")


def check_many(checks, browser):
    poses = ([1, 0, 0, 0, 1, 0, 0, 0, 1, 3.0 * (i % 100), 3.0 * (i // 100), 0] for i in range(10_000))
    objects = [{"name": f"box {i}", "shape": BOX, "pose": pose} for i, pose in enumerate(poses)]
    scene = {"format": "toccata-scene", "version": 1, "unit": "m", "objects": objects}
    (checks.folder / "many.json").write_text(json.dumps(scene))
    checks.run("view", "many.json", "-o", "many.html")
    checks.opened(browser, "many.html")
    calls = browser.value("toccata.stage.renderer.info.render.calls")
    checks.expect(calls <= 6, f"10,000 boxes in {calls} drawing calls")
    checks.quiet(browser, "many")


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
    checks.opened(browser, "shapes.html", "#pair=0")
    browser.wait_for("!document.getElementById('found').hidden")
    facts = browser.value("[...document.querySelectorAll('#facts li')].map(fact => fact.textContent)")
    checks.expect(facts == ["0.5 m deep; moving B by it along (1, 0, 0) parts them", "1 point of contact", "decided exactly"], f"{facts}")
    checks.quiet(browser, "shapes")


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
    time.sleep(0.3)
    picture = browser.picture()
    checks.expect(share(picture, is_blue) > 0.01 and share(picture, is_orange) > 0.01, "nodes have colours of their own")
    for place in range(300, 1200, 30):
        browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=place, y=420)
        lit = browser.value("document.getElementById('hover').textContent")
        if lit:
            break
    checks.expect(re.fullmatch(r"node \d+ of level 5: [\d,]+ triangles?", lit) is not None, f"a node lights up: {lit}")
    checks.quiet(browser, "levels")


def check_empty(checks, browser):
    text = (checks.folder / "wicked.html").read_text()
    header = json.loads(re.search(r'id="toccata-header"[^>]*>(.*?)</script>', text).group(1))
    report = json.loads(re.search(r'id="toccata-report"[^>]*>(.*?)</script>', text, re.DOTALL).group(1))
    header.update(objects=[], meshes=[], layers=[], words=[])
    report.update(objects=[], pairs=[])
    for name, value in [("header", header), ("report", report)]:
        written = json.dumps(value).replace("<", "\\u003c")
        text = re.sub(rf'(id="toccata-{name}"[^>]*>).*?(</script>)', lambda m, w=written: m[1] + w + m[2], text, flags=re.DOTALL)
    (checks.folder / "empty.html").write_text(text)
    checks.opened(browser, "empty.html")
    checks.expect("empty" in browser.value("document.getElementById('notice').textContent"), "an empty scene says so")
    checks.quiet(browser, "empty")


def main():
    if find_chromium() is None:
        print("SKIPPED: no Chromium is installed (apt-get install chromium)")
        return 77
    with tempfile.TemporaryDirectory() as name, Browser() as browser:
        folder = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else pathlib.Path(name)
        checks = Checks(pathlib.Path(sys.argv[1]).resolve(), folder)
        checks.run("demo", "--write", "scenes")
        for check in [check_contacts, check_view, check_wicked_names, check_many, check_large, check_shapes, check_hierarchy, check_empty]:
            check(checks, browser)
    print(f"pages: {checks.count} checks, {len(checks.failures)} failures")
    return 1 if checks.failures else 0


if __name__ == "__main__":
    sys.exit(main())
