#!/usr/bin/env python3
"""Uses every control of a page in Chromium - mouse, wheel, keys, buttons, lists - and looks at what they change.

usage: check_controls.py TOCCATA [FOLDER]     with FOLDER, what was seen is kept there

Exits with 77, which CTest takes for skipped, where Chromium is not installed.
"""
import base64
import itertools
import json
import math
import pathlib
import re
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from browser import Browser, find_chromium  # noqa: E402
from check_pages import BOX, Checks, moved  # noqa: E402
from pixels import is_blue, is_orange, share  # noqa: E402

PLACE = "(({ target, distance, yaw, pitch }) => [target.x, target.y, target.z, distance, yaw, pitch])(toccata.stage.orbit.place)"
EYE = "(({ camera, place }) => camera.position.clone().sub(place.target).normalize().toArray())(toccata.stage.orbit)"
CANVAS = "(box => [box.left, box.top, box.width, box.height])(toccata.stage.canvas.getBoundingClientRect())"
LIGHT, DARK = (0xF4, 0xF6, 0xF8), (0x14, 0x18, 0x1D)  # backgrounds
PALETTE = {"objects": ((0x56, 0xB4, 0xE9), (0xE6, 0x9F, 0x00)), "contact faces": ((0x00, 0x72, 0xB2), (0xD5, 0x5E, 0x00))}


def on_screen(browser, right=0.0, up=0.0, towards=0.0):
    """Where a point near what is looked at is on the canvas: so far from it as the camera sees, in its distances."""
    return browser.value(f"""(() => {{ const {{ camera, place }} = toccata.stage.orbit, e = camera.matrixWorld.elements;
      const at = place.target.clone();
      [{right}, {up}, {towards}].forEach((far, axis) => {{ for (let k = 0; k < 3; ++k) at.setComponent(k, at.getComponent(k) + far * place.distance * e[4 * axis + k]); }});
      window.kept = at;
      return Object.values(toccata.stage.onScreen(at)); }})()""")


def kept_point(browser):
    """The point of the last `on_screen`, as it is seen now."""
    return browser.value("Object.values(toccata.stage.onScreen(kept))")


def mouse(browser, kind, x, y, **more):
    browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)


def drag(browser, right, down, button="left", modifiers=0):
    left, top, width, height = browser.value(CANVAS)
    x, y = left + width / 2, top + height / 2
    buttons = {"left": 1, "right": 2, "middle": 4}[button]
    mouse(browser, "mousePressed", x, y, button=button, buttons=buttons, modifiers=modifiers, clickCount=1)
    for part in [0.5, 1]:
        mouse(browser, "mouseMoved", x + part * right, y + part * down, button=button, buttons=buttons, modifiers=modifiers)
    mouse(browser, "mouseReleased", x + right, y + down, button=button, modifiers=modifiers, clickCount=1)


def is_close(numbers, others, most):
    return all(abs(x - y) <= most for x, y in zip(numbers, others))


def full_picture(browser):
    """What is seen of the canvas, point by point."""
    x, y, width, height = browser.value(CANVAS)
    clip = {"x": x, "y": y, "width": width, "height": height, "scale": 1}
    return browser.rows_of(browser.call("Page.captureScreenshot", format="png", clip=clip)["data"])


def write_files(checks):
    """Two cubes that meet deeply, two that meet a little in more faces, two that are near; in an order of its own."""
    near = [("near a", 0, 18, "cube"), ("near b", 2.5, 18, "cube"), ("nearer b", 0, 20.25, "cube")]
    objects = [*near, ("shallow a", 0, 0, "fine"), ("shallow b", 1.9, 0, "fine"), ("deep a", 0, 9, "cube"), ("deep b", 1.25, 9.25, "cube")]
    checks.write_scene("orders.json", [{"name": name, "file": f"{mesh}.off", "pose": moved(x, y)} for name, x, y, mesh in objects])
    for name, size in [("cube", 1), ("fine", 3)]:
        (checks.folder / f"{name}.off").write_text(cube(size))


def cube(size):
    """A cube from -1 to 1, each side in so many times so many squares; corners shared within a side alone."""
    vertices, faces = [], []
    for axis, side in itertools.product(range(3), [-1, 1]):
        first = len(vertices)
        for i, j in itertools.product(range(size + 1), repeat=2):
            corner = [0.0] * 3
            corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3] = side, 2 * i / size - 1, 2 * j / size - 1
            vertices.append(corner)
        for i, j in itertools.product(range(size), repeat=2):
            at = first + i * (size + 1) + j
            square = [at, at + size + 1, at + size + 2, at + 1]
            faces.append(square if side > 0 else square[::-1])
    lines = [" ".join(map(repr, corner)) for corner in vertices] + [" ".join(map(str, [4, *face])) for face in faces]
    return f"OFF\n{len(vertices)} {len(faces)} 0\n" + "\n".join(lines) + "\n"


def check_orders(checks, browser):
    words = ["check", "orders.json", "--penetration", "--faces", "--clearance", "1", "--json"]
    pairs = json.loads(checks.run(*words, "--html", "orders.html"))["pairs"]
    near = [pair["relation"] == "apart" for pair in pairs]
    depth = [(pair.get("penetration") or {"upper": 0})["upper"] for pair in pairs]
    gap = [pair["distance"]["upper"] if is_near else 0 for pair, is_near in zip(pairs, near)]
    faces = [len(pair["faces"]) for pair in pairs]
    listed = list(range(len(pairs)))
    wanted = {
        "listed": listed,
        "deepest": sorted(listed, key=lambda i: (-depth[i], gap[i])),
        "largest": sorted(listed, key=lambda i: -faces[i]),
        "nearest": sorted(listed, key=lambda i: gap[i]),
    }
    checks.expect(len(set(map(tuple, wanted.values()))) == 4, f"the orders differ: {wanted}")
    checks.opened(browser, "orders.html", "#theme=light")
    for order, numbers in wanted.items():
        browser.value(f"(() => {{ const order = document.getElementById('order'); order.value = '{order}'; order.dispatchEvent(new Event('change')); }})()")
        shown = browser.value("[...document.querySelectorAll('#finding-list li')].map(row => Number(row.dataset.finding))")
        checks.expect(shown == numbers, f"{order}: {shown} for {numbers}")
        browser.press("n")
        checks.expect(browser.value("toccata.state.finding") == numbers[0], f"{order}: N goes to the first")
        browser.press("p")
        checks.expect(browser.value("toccata.state.finding") == numbers[-1], f"{order}: P goes round to the last")
        browser.press("Escape")
    checks.quiet(browser, "orders")


def check_mouse(checks, browser):
    """What is turned, moved and zoomed follows the mouse."""
    start = browser.value(PLACE)
    height = browser.value("toccata.stage.canvas.clientHeight")
    before = on_screen(browser, towards=0.2)
    drag(browser, 60, 45)
    place, after = browser.value(PLACE), kept_point(browser)
    checks.expect(place[:4] == start[:4], f"turning keeps the target and the distance: {start} {place}")
    checks.expect(is_close(place[4:], [start[4] - 4 * 60 / height, start[5] + 4 * 45 / height], 1e-9), f"it turns as far as dragged: {start} {place}")
    checks.expect(after[0] > before[0] + 10 and after[1] > before[1] + 10, f"what is before the target turns with the mouse: {before} {after}")
    for button, modifiers in [("left", 8), ("right", 0), ("middle", 0)]:
        start, before = browser.value(PLACE), on_screen(browser)
        drag(browser, 70, -40, button, modifiers)
        place, after = browser.value(PLACE), kept_point(browser)
        checks.expect(place[3:] == start[3:], f"{button}: moving turns and zooms nothing: {start} {place}")
        checks.expect(is_close(after, [before[0] + 70, before[1] - 40], 0.01), f"{button}: what is looked at stays under the mouse: {before} {after}")
    for way in [-240, 240]:
        start, before = browser.value(PLACE), on_screen(browser, 0.1, -0.07)
        left, top = browser.value(CANVAS)[:2]
        mouse(browser, "mouseWheel", left + before[0], top + before[1], deltaX=0, deltaY=way)
        browser.wait_for(f"toccata.stage.orbit.place.distance !== {start[3]!r}", 10)
        place, after = browser.value(PLACE), kept_point(browser)
        checks.expect(is_close([place[3] / start[3]], [math.exp(way * 0.0015)], 1e-6), f"the wheel comes nearer and goes away: {start} {place}")
        checks.expect(is_close(after, before, 1), f"what is under the pointer stays there: {before} {after}")
        checks.expect(place[4:] == start[4:], f"the wheel turns nothing: {start} {place}")


def check_camera_keys(checks, browser):
    browser.value("toccata.stage.canvas.focus()")
    for key, change in [("ArrowLeft", (-0.12, 0)), ("ArrowRight", (0.12, 0)), ("ArrowUp", (0, 0.12)), ("ArrowDown", (0, -0.12))]:
        start = browser.value(PLACE)
        browser.press(key)
        place = browser.value(PLACE)
        checks.expect(is_close(place, [*start[:4], start[4] + change[0], start[5] + change[1]], 1e-9), f"{key}: {start} {place}")
    for key, factor in [("+", 0.85), ("-", 1 / 0.85)]:
        start = browser.value(PLACE)
        browser.press(key)
        checks.expect(is_close([browser.value(PLACE)[3]], [start[3] * factor], 1e-9), f"{key} zooms")
    browser.press("f")
    framed = browser.value(PLACE)
    browser.value("toccata.stage.orbit.zoom(0.3, 0.2, 0.1)")
    browser.press("f")
    checks.expect(is_close(browser.value(PLACE), framed, 1e-9), "F shows everything again")
    for key, eye in [("1", [1, 0, 0]), ("2", [0, -1, 0]), ("3", [0, 0, 1])]:
        browser.press(key)
        checks.expect(is_close(browser.value(EYE), eye, 2e-3), f"{key}: the eye is at {browser.value(EYE)}")


def check_keys(checks, browser):
    for rest in ["hidden", "shown", "ghost"]:
        browser.press("g")
        told = browser.value("[toccata.state.rest, document.getElementById('rest').textContent]")
        checks.expect(told == [rest, f"Rest: {rest}"], f"G: {told}")
    browser.press("n")
    time.sleep(0.3)
    pictures = {"": browser.picture()}
    for key, name in [("x", "through"), ("r", "grid"), ("b", "labels")]:
        was = browser.value(f"document.getElementById('{name}').getAttribute('aria-pressed')")
        browser.press(key)
        now = browser.value(f"document.getElementById('{name}').getAttribute('aria-pressed')")
        checks.expect({was, now} == {"true", "false"}, f"{key}: from {was} to {now}")
        time.sleep(0.25)
        pictures[key] = browser.picture()
        checks.expect(sum(p != q for row, line in zip(pictures[key], pictures[""]) for p, q in zip(row, line)) > 200, f"{key} is seen")
        if key == "b":
            checks.expect(browser.value("document.getElementById('marks').children.length") == 0, "B takes the names away")
        browser.press(key)
        checks.expect(browser.value(f"document.getElementById('{name}').getAttribute('aria-pressed')") == was, f"{key} and back")
    checks.expect(browser.value("document.getElementById('marks').textContent").count(" ") >= 2, "names and numbers are in the picture")
    wide = browser.value(CANVAS)[2]
    browser.press("h")
    browser.wait_for(f"toccata.stage.canvas.clientWidth > {wide} + 100", 10)
    checks.expect(browser.value("document.getElementById('side').offsetParent === null"), "H hides the panels")
    browser.press("h")
    browser.wait_for(f"toccata.stage.canvas.clientWidth === {wide}", 10)
    check_help(checks, browser)
    check_tabs(checks, browser)
    check_link(checks, browser)


def check_tabs(checks, browser):
    """The arrows go from tab to tab, and nothing else; Tab has one of them to stop at."""
    browser.value("document.getElementById('tab-findings').focus()")
    was = browser.value("toccata.link()")
    for key, opened in [("ArrowRight", "objects"), ("ArrowRight", "findings"), ("ArrowLeft", "objects"), ("Home", "findings"), ("End", "objects"), ("Home", "findings")]:
        browser.press(key)
        checks.expect(browser.value("document.activeElement.id") == f"tab-{opened}", f"{key} goes to the tab {opened}")
        shown = browser.value("[...document.querySelectorAll('[role=tabpanel]')].filter((one) => !one.hidden).map((one) => one.id).join()")
        checks.expect(shown == opened, f"{key} opens {shown}, not {opened}")
        stops = browser.value("[...document.querySelectorAll('[role=tab]')].filter((one) => one.tabIndex === 0).map((one) => one.id).join()")
        checks.expect(stops == f"tab-{opened}", f"Tab stops at {stops}")
    checks.expect(browser.value("toccata.link()") == was, "the scene stays as it is")
    browser.value("document.activeElement.blur()")


def check_help(checks, browser):
    browser.press("?")
    checks.expect(browser.value("document.getElementById('keys').open"), "? opens the keys")
    listed = " ".join(browser.value("[...document.querySelectorAll('#keys dt')].map(key => key.textContent)")).split()
    for key in "N P Esc F 1 2 3 G X R B H T S L Space + ?".split():
        checks.expect(key in listed, f"{key} is among the keys: {listed}")
    browser.press("t")
    checks.expect(browser.value("toccata.state.theme") == "light", "no key acts behind the list of keys")
    browser.value("document.querySelector('#keys button').click()")
    checks.expect(not browser.value("document.getElementById('keys').open"), "the list of keys can be closed")


def check_link(checks, browser):
    """L puts into the clipboard what restores the view."""
    browser.value("Object.defineProperty(navigator, 'clipboard', { configurable: true, value: { writeText: async text => { window.copied = text; } } })")
    browser.press("l")
    browser.wait_for("window.copied !== undefined", 10)
    copied = browser.value("window.copied")
    checks.expect(copied == browser.value("location.href.split('#')[0] + toccata.link()"), f"L copies {copied}")
    checks.expect(browser.value("document.getElementById('link').textContent") == "Copied", "and says so")


def check_theme(checks, browser):
    """Light and dark, by their points: background, panels, and both objects in each."""
    for theme, background in [("light", LIGHT), ("dark", DARK)]:
        if theme == "dark":
            browser.press("t")
        time.sleep(0.3)
        checks.expect(browser.value("document.documentElement.dataset.theme") == theme, theme)
        picture = browser.picture()
        covered = share(picture, lambda pixel, wanted=background: is_close(pixel, wanted, 1))
        checks.expect(covered > 0.3, f"{theme}: {covered:.3f} of the picture is the background")
        checks.expect(share(picture, is_blue) > 0.005 and share(picture, is_orange) > 0.005, f"{theme}: both objects are seen")
        paper, ink = browser.value("(style => [style.backgroundColor, style.color])(getComputedStyle(document.getElementById('side')))")
        contrast = contrast_of(colour_in(paper), colour_in(ink))
        checks.expect(contrast >= 7, f"{theme}: words {ink} on {paper} have a contrast of {contrast:.1f}")
        checks.expect((sum(colour_in(paper)) < 200) == (theme == "dark"), f"{theme}: panels are {paper}")
    browser.press("t")
    checks.expect(browser.value("toccata.state.theme") == "light", "T goes back")


def colour_in(text):
    return tuple(int(number) for number in re.findall(r"\d+", text)[:3])


def linear(colour):
    return [x / 255 / 12.92 if x <= 10 else ((x / 255 + 0.055) / 1.055) ** 2.4 for x in colour]


def contrast_of(one, other):
    """Of WCAG 2.1, section 1.4.3."""
    light, dark = sorted((sum(w * x for w, x in zip([0.2126, 0.7152, 0.0722], linear(c))) for c in [one, other]), reverse=True)
    return (light + 0.05) / (dark + 0.05)


def cones(colour):
    """What the long, middle and short cones see: F. Viénot, H. Brettel, J. Mollon, "Digital video colourmaps", 1999."""
    rows = [(17.8824, 43.5161, 4.11935), (3.45565, 27.1554, 3.86714), (0.0299566, 0.184309, 1.46709)]
    return [sum(w * x for w, x in zip(row, linear(colour))) for row in rows]


def check_palette(checks, browser):
    """The two colours stay apart for those who lack one kind of cone: to the other two, or by how these compare."""
    fold = lambda x, y: max(x, y) / min(x, y)  # noqa: E731
    for what, (one, other) in PALETTE.items():
        a, b = cones(one), cones(other)
        for lacking in range(3):
            i, j = (cone for cone in range(3) if cone != lacking)
            apart = max(fold(a[i], b[i]), fold(a[j], b[j]), fold(a[i] / a[j], b[i] / b[j]))
            checks.expect(apart > 1.5, f"{what}: without cone {lacking} they are {apart:.2f} apart")
    colours = browser.value("[...document.querySelectorAll('#sentence bdi')].map(name => name.className)")
    checks.expect(colours == ["a", "b"], f"the sentence names A and B in their colours: {colours}")
    browser.value("document.getElementById('tab-objects').click()")
    browser.value("toccata.panels.listObjects()")
    swatches = browser.value("[...document.querySelectorAll('#object-list .swatch')].map(swatch => swatch.style.background)")
    shown = {colour_in(colour) for colour in swatches}
    checks.expect(set(PALETTE["objects"]) <= shown, f"A and B have the colours of the palette: {shown}")
    browser.value("document.getElementById('tab-findings').click()")


def check_picture(checks, browser):
    """S saves the canvas, point by point, and the button does so too."""
    browser.resize(800, 500)
    checks.opened(browser, "orders.html", "#finding=4&theme=light&labels=0")
    time.sleep(0.4)
    browser.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(checks.folder / "saved"))
    name = checks.folder / "saved" / "orders.json.png"
    for save in [lambda: browser.press("s"), lambda: browser.value("document.getElementById('picture').click()")]:
        name.unlink(missing_ok=True)
        save()
        end = time.monotonic() + 20
        while not name.exists() and time.monotonic() < end:
            browser.value("1")
            time.sleep(0.05)
        checks.expect(name.exists(), f"a picture was saved: {sorted(p.name for p in name.parent.glob('*'))}")
        if not name.exists():
            return
    browser.value("for (const id of ['found', 'layers', 'axes', 'scale']) document.getElementById(id).style.visibility = 'hidden'")
    saved, seen = browser.rows_of(base64.b64encode(name.read_bytes()).decode()), full_picture(browser)
    width, height = browser.value("[toccata.stage.canvas.clientWidth, toccata.stage.canvas.clientHeight]")
    checks.expect((len(saved[0]), len(saved)) == (width, height), f"the picture has {len(saved[0])} x {len(saved)} points")
    places = list(itertools.product(range(0, height, 2), range(0, width, 2)))
    same = sum(is_close(saved[row][column], seen[row][column], 12) for row, column in places) / len(places)
    checks.expect(same > 0.97, f"{same:.4f} of the saved points are those that are seen")
    checks.expect(share(saved, is_blue) > 0.005 and share(saved, is_orange) > 0.005, "the picture shows both objects")
    checks.quiet(browser, "pictures")
    browser.resize(1200, 800)


def check_names(checks, browser, page, end=""):
    """Whatever can be used has a name that a screen reader tells."""
    checks.opened(browser, page, end)
    browser.call("Accessibility.enable")
    roles = {"button", "slider", "searchbox", "textbox", "combobox", "checkbox", "radio", "tab", "menuitem", "switch"}
    nodes = [node for node in browser.call("Accessibility.getFullAXTree")["nodes"] if not node["ignored"]]
    named = [(node["role"]["value"], node.get("name", {}).get("value", "").strip()) for node in nodes]
    used = [entry for entry in named if entry[0] in roles]
    checks.expect([entry for entry in used if not entry[1]] == [], f"{page}: every control has a name: {used}")
    shown = browser.value("[...document.querySelectorAll('button, input, select, canvas')].filter(control => control.checkVisibility()).length")
    checks.expect(len(used) >= shown - 1 and shown > 8, f"{page}: {len(used)} of {shown} controls are told to screen readers")
    browser.call("Accessibility.disable")
    checks.expect(any("three dimensions" in name for _, name in named), f"{page}: the picture has a name")
    return [name for _, name in used]


def check_all_names(checks, browser):
    names = check_names(checks, browser, "orders.html", "#finding=0")
    for name in ["Sort", "Next", "Previous", "Back to all", "Picture", "Grid"]:
        checks.expect(name in names, f"{name}: {names}")
    browser.value("document.getElementById('tab-objects').click()")
    objects = "[...document.querySelectorAll('#object-list .small')].map(button => button.getAttribute('aria-label').replace(/[\u2068\u2069]/g, ''))"
    checks.expect("Hide: deep a" in browser.value(objects), f"buttons name their object: {browser.value(objects)}")
    checks.run("view", "cube.off", "--hierarchy", "aabb", "-o", "boxes.html")
    checks.expect(any("hierarchy" in name for name in check_names(checks, browser, "boxes.html")), "a slider has a name")
    checks.run("crowd", "--scene", "static", "--count", "40", "--method", "grid", "--frames", "3", "--html", "moments.html")
    names = check_names(checks, browser, "moments.html")
    checks.expect({"Moment", "Previous moment", "Next moment", "Play"} <= set(names), f"time has names: {names}")
    checks.quiet(browser, "names")


def check_up(checks, browser):
    """A tall tower stands in a scene with Z up, and lies in one with Y up; the axes say which is which."""
    checks.write_scene("tower.json", [{"name": "tower", "shape": {"type": "box", "half_extents": [1, 1, 5]}}])
    ends = "Object.fromEntries([...document.querySelectorAll('#axes text')].map(text => [text.textContent, [Number(text.getAttribute('x')), Number(text.getAttribute('y'))]]))"
    for up, other in [("z", "y"), ("y", "z")]:
        checks.run("view", "tower.json", "--up", up, "-o", f"{up}.html")
        checks.opened(browser, f"{up}.html", "#theme=light&grid=0")
        axes = browser.value(ends)
        x, y = axes[up.upper()]
        checks.expect(set(axes) == {"X", "Y", "Z"} and abs(x) < 1e-6 and y < -20, f"{up} goes up: {axes}")
        browser.press("1")
        time.sleep(0.3)
        checks.expect(is_close(browser.value(EYE), [1, 0, 0], 1e-6), f"{up} up: the eye is on the side of X")
        x, y = browser.value(ends)[other.upper()]
        checks.expect(abs(y) < 1e-6 and (x > 20) == (up == "z"), f"{other} goes sideways, right-handed: {x}, {y}")
        picture = full_picture(browser)
        row, column = picture[len(picture) // 2], [line[len(line) // 2] for line in picture]
        tall, wide = (sum(not is_close(pixel, LIGHT, 1) for pixel in line) for line in [column, row])
        checks.expect(tall > 3 * wide if up == "z" else wide > 3 * tall, f"{up} up: the tower is {tall} tall and {wide} wide")
        browser.press({"z": "3", "y": "2"}[up])
        eye = browser.value(EYE)
        checks.expect(eye["xyz".index(up)] > 0.999, f"{up} up: from above, the eye is at {eye}")
    checks.quiet(browser, "up")


def check_keys_of_orders(checks, browser):
    checks.opened(browser, "orders.html", "#theme=light")
    for check in [check_mouse, check_camera_keys, check_keys, check_theme, check_palette]:
        check(checks, browser)
    checks.quiet(browser, "keys")


def main():
    if find_chromium() is None:
        print("SKIPPED: no Chromium is installed (apt-get install chromium)")
        return 77
    with tempfile.TemporaryDirectory() as name, Browser() as browser:
        folder = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else pathlib.Path(name)
        checks = Checks(pathlib.Path(sys.argv[1]).resolve(), folder)
        write_files(checks)
        for check in [check_orders, check_keys_of_orders, check_picture, check_all_names, check_up]:
            started = time.monotonic()
            check(checks, browser)
            print(f"{check.__name__}: {time.monotonic() - started:.1f} s")
    print(f"controls: {checks.count} checks, {len(checks.failures)} failures")
    return 1 if checks.failures else 0


if __name__ == "__main__":
    sys.exit(main())
