#!/usr/bin/env python3
"""Looks at clashes on the page of `check` in Chromium: what is framed, where labels are, the list with its filter, groups and
review, the section plane and the measure.

usage: check_clashes.py TOCCATA [FOLDER]     with FOLDER, what was seen is kept there

Exits with 77, which CTest takes for skipped, where Chromium is not installed.
"""
import json
import pathlib
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from browser import Browser, find_chromium  # noqa: E402
from check_pages import Checks, moved  # noqa: E402
from page_content import tells_depth  # noqa: E402

# The part of the screen that the place of the chosen clash takes, and the words over the picture.
PLACE = """(() => { const corners = toccata.marks.avoid.map(corner => toccata.stage.onScreen(corner));
  const [xs, ys] = [corners.map(p => p.x), corners.map(p => p.y)];
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)]; })()"""
WORDS = """[...document.querySelectorAll('#marks .mark')].filter(mark => !mark.hidden).map(mark => {
  const [box, stage] = [mark.getBoundingClientRect(), toccata.stage.canvas.getBoundingClientRect()];
  return [box.left - stage.left, box.top - stage.top, box.right - stage.left, box.bottom - stage.top]; })"""
LISTED = "[...document.querySelectorAll('#finding-list .row')].map(row => row.textContent)"
HEADINGS = "[...document.querySelectorAll('#finding-list .heading')].map(heading => heading.textContent)"


def write_files(checks):
    """Long beams that meet at one end, so that the clash is small beside its parts; a rod through a plate; bolts."""
    beam = {"type": "box", "half_extents": [100, 2, 2]}
    objects = [
        ("frame/beam 1", beam, moved(0)),
        ("frame/beam 2", {"type": "box", "half_extents": [2, 100, 2]}, moved(101, 101)),
        ("plate", {"type": "box", "half_extents": [20, 20, 1]}, moved(0, 60)),
        ("rod", {"type": "box", "half_extents": [1, 1, 9]}, moved(0, 60)),
        ("bolt", {"type": "box", "half_extents": [1, 1, 9]}, moved(50, 0, 10.95)),
    ]
    checks.write_scene("hall.json", [{"name": name, "shape": shape, "pose": pose} for name, shape, pose in objects], "mm")
    before = [*objects[:3], ("rod", objects[3][1], moved(0, 300)), ("bolt", objects[4][1], moved(0, 60, 2))]
    checks.write_scene("before.json", [{"name": name, "shape": shape, "pose": pose} for name, shape, pose in before], "mm")


def overlaps(one, other):
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def type_into(browser, element, text):
    browser.value(f"(() => {{ const field = document.getElementById('{element}'); field.value = {json.dumps(text)}; field.oninput?.(); field.onchange?.(); }})()")


# Its width and height.
ABOVE_CARD = """(() => {
  const canvas = toccata.stage.canvas.getBoundingClientRect(), card = document.getElementById('found').getBoundingClientRect();
  return [canvas.width, Math.min(canvas.height, card.top - canvas.top)];
})()"""


def check_framing(checks, browser):
    browser.value("document.querySelectorAll('#finding-list .row')[0].click()")
    browser.wait_for("toccata.stage.drawn > 1")
    for _ in range(len(browser.value(LISTED))):
        name = browser.value("document.getElementById('sentence').textContent")
        place = browser.value(PLACE)
        if place[0] is None:  # what is gone has no place
            browser.press("n")
            continue
        width, height = browser.value(ABOVE_CARD)
        share = max((place[2] - place[0]) / width, (place[3] - place[1]) / height)
        checks.expect(share > 0.15, f"{name}: the place takes only {share:.2f} of the picture above the card")
        checks.expect(0 <= place[0] and place[2] <= width and 0 <= place[1] and place[3] <= height, f"{name}: the place is behind the card: {place}")
        checks.expect(share < 1, f"{name}: the place is cut off")
        words = browser.value(WORDS)
        checks.expect(len(words) >= 2, f"{name}: {len(words)} labels")
        checks.expect(not any(overlaps(word, place) for word in words), f"{name}: a label covers the place: {words}, {place}")
        browser.press("n")


def check_list(checks, browser):
    everything = browser.value(LISTED)
    type_into(browser, "clash-filter", "rod pierce")
    checks.expect(len(browser.value(LISTED)) == 1, f"filtered: {browser.value(LISTED)}")
    type_into(browser, "clash-filter", "no such thing")
    checks.expect(browser.value(LISTED) == [], "nothing holds these words")
    type_into(browser, "clash-filter", "")
    checks.expect(browser.value(LISTED) == everything, "all are back")
    for grouping, headings in [("kind", 3), ("since", 3), ("part", 3), ("asked", 3)]:
        type_into(browser, "grouping", grouping)
        found = browser.value(HEADINGS)
        checks.expect(len(found) >= headings - 1, f"{grouping}: {found}")
        checks.expect(len(browser.value(LISTED)) == len(everything), f"{grouping}: every clash is in one group")
    type_into(browser, "grouping", "none")
    checks.expect(any("gone" in row for row in everything), f"what is gone is listed: {everything}")
    checks.expect(any("new" in row for row in everything), f"what is new is told: {everything}")


def write_remark(browser, status, comment):
    """As somebody at the keyboard does."""
    type_into(browser, "review-status", status)
    browser.value("document.getElementById('review-comment').focus()")
    browser.call("Input.insertText", text=comment)
    browser.value("document.getElementById('review-comment').blur()")


def saved(checks, browser):
    """The file that the button makes the browser download."""
    folder = checks.folder / "downloads"
    folder.mkdir(exist_ok=True)
    browser.call("Page.setDownloadBehavior", behavior="allow", downloadPath=str(folder))
    browser.value("document.getElementById('save-review').click()")
    for _ in range(200):
        files = [file for file in folder.iterdir() if file.suffix == ".json"]
        if files and files[0].stat().st_size > 0:
            return files[0]
        time.sleep(0.05)
    raise TimeoutError("no review was downloaded")


def open_review(browser, file):
    document = browser.call("DOM.getDocument")["root"]["nodeId"]
    chosen = browser.call("DOM.querySelector", nodeId=document, selector="#review-file")["nodeId"]
    browser.value("document.getElementById('review-told').textContent = ''")
    browser.call("DOM.setFileInputFiles", nodeId=chosen, files=[str(file)])
    browser.wait_for("document.getElementById('review-told').textContent !== ''")
    return browser.value("document.getElementById('review-told').textContent")


def check_review(checks, browser):
    """A status and a comment, the file that is downloaded, and the same page opened anew with it."""
    told = "document.getElementById('review-told').textContent"
    browser.value("document.querySelectorAll('#finding-list .row')[0].click()")
    write_remark(browser, "reviewed", "moved by Anna")
    checks.expect(browser.value(told) == "not saved yet", f"what is not saved is told: {browser.value(told)}")
    checks.expect(browser.value("window.onbeforeunload !== null"), "and the page asks before it is left")
    file = saved(checks, browser)
    checks.expect(file.name.endswith("-review.json"), f"called {file.name}")
    checks.expect(browser.value(told) == f"1 clash in {file.name}", f"that it is saved is told: {browser.value(told)}")
    checks.expect(browser.value("window.onbeforeunload === null"), "then the page can be left")
    text = file.read_text()
    said = json.loads(text)
    checks.expect(said["format"] == "toccata-review" and len(said["clashes"]) == 1, f"the review: {text}")
    checks.expect("reviewed" in browser.value(LISTED)[0] and "moved by Anna" in browser.value(LISTED)[0], "the list tells it")
    checks.opened(browser, "hall.html", "#theme=light")
    checks.expect(not any("moved by Anna" in row for row in browser.value(LISTED)), "a page opened anew knows nothing of it")
    checks.expect(open_review(browser, file) == "1 clash of the file", "the file is opened")
    checks.expect(any("moved by Anna" in row for row in browser.value(LISTED)), "and it is there again")
    type_into(browser, "clash-filter", "anna")
    checks.expect(len(browser.value(LISTED)) == 1, "the filter knows comments")
    type_into(browser, "clash-filter", "")
    type_into(browser, "grouping", "status")
    checks.expect(any(heading.startswith("reviewed · 1") for heading in browser.value(HEADINGS)), f"groups by status: {browser.value(HEADINGS)}")
    type_into(browser, "grouping", "none")
    for wrong in ["{", "{}", text.replace("reviewed", "forgotten"), text.replace('"version": 1', '"version": 9')]:
        broken = checks.folder / "broken.json"
        broken.write_text(wrong)
        checks.expect("not read" in open_review(browser, broken), f"refused: {wrong[:30]}")
    checks.expect(any("moved by Anna" in row for row in browser.value(LISTED)), "what was there stays")
    browser.value("document.querySelectorAll('#finding-list .row')[1].click()")
    write_remark(browser, "active", "to do")
    open_review(browser, file)
    checks.expect(browser.value("window.onbeforeunload !== null"), "what was not saved still is not, after a file was opened")
    file.unlink()
    saved(checks, browser)


def check_sorting(checks, browser):
    """The deepest first; what is within its tolerance is no clash and dimmed."""
    everything = sorted(browser.value(LISTED))
    for order in browser.value("[...document.getElementById('order').options].map(option => option.value)"):
        type_into(browser, "order", order)
        checks.expect(sorted(browser.value(LISTED)) == everything, f"{order}: all are listed")
    type_into(browser, "order", "deepest")
    depths = browser.value("toccata.panels.order.map(i => toccata.findings.all[i].depth)")
    checks.expect(depths == sorted(depths, reverse=True), f"the deepest first: {depths}")
    dimmed = browser.value("[...document.querySelectorAll('#finding-list li.dim')].map(row => row.textContent)")
    checks.expect(any("bolt" in row for row in dimmed), f"what is within the tolerance is dimmed: {dimmed}")


def check_baseline(checks, browser):
    """New, known and gone are told in the rows and as groups."""
    type_into(browser, "grouping", "since")
    headings = browser.value(HEADINGS)
    report = json.loads(checks.run("check", "hall.json", "--tolerance", "0.1", "--baseline", "old.json", "--json"))
    told = report["baseline"]
    for state in ["new", "known", "moved", "graver"]:
        if told[state]:
            checks.expect(f"{state} · {told[state]}" in headings, f"{state}: {headings}")
    checks.expect(f"gone · {len(told['gone'])}" in headings, f"gone: {headings}")
    checks.expect(told["new"] > 0 and told["known"] > 0 and len(told["gone"]) > 0, f"the files have all kinds: {told}")
    type_into(browser, "grouping", "none")


def check_keys(checks, browser):
    chosen = "toccata.state.finding"
    order = browser.value("toccata.panels.order")
    browser.value("document.getElementById('canvas').focus()")
    browser.press("Escape")
    checks.expect(browser.value(f"{chosen} === undefined"), "Escape goes back to all")
    browser.press("n")
    checks.expect(browser.value(chosen) == order[0], "N goes to the first")
    browser.press("j")
    checks.expect(browser.value(chosen) == order[1], "J to the next")
    browser.press("p")
    checks.expect(browser.value(chosen) == order[0], "P to the one before")
    browser.press("k")
    checks.expect(browser.value(chosen) == order[-1], "and around")
    browser.press("/")
    checks.expect(browser.value("document.activeElement.id") == "clash-filter", "/ goes to the filter")
    browser.call("Input.insertText", text="n")
    browser.press("n")
    checks.expect(browser.value(chosen) == order[-1], "letters typed there are no keys")
    type_into(browser, "clash-filter", "")
    browser.value("document.getElementById('canvas').focus()")
    for key, button in [("b", "labels"), ("r", "grid"), ("x", "through")]:
        before = browser.value(f"document.getElementById('{button}').getAttribute('aria-pressed')")
        browser.press(key)
        checks.expect(browser.value(f"document.getElementById('{button}').getAttribute('aria-pressed')") != before, f"{key} switches {button}")
        browser.press(key)


def check_tools(checks, browser):
    browser.value("document.querySelectorAll('#finding-list .row')[0].click()")
    before = browser.picture()
    browser.press("c")
    checks.expect(browser.value("toccata.stage.renderer.clippingPlanes.length") == 1, "a plane cuts")
    checks.expect(not browser.value("document.getElementById('section').hidden"), "its slider is there")
    browser.wait_for("toccata.stage.drawn > 2")
    checks.expect(browser.picture() != before, "something is cut away")
    browser.value("(() => { const axis = document.getElementById('section-axis'); axis.value = '2'; axis.onchange(); })()")
    checks.expect(browser.value("Math.abs(toccata.stage.renderer.clippingPlanes[0].normal.z)") == 1, "across Z")
    planes = "toccata.stage.renderer.clippingPlanes[0]"
    where = browser.value(f"{planes}.constant")
    browser.value("(() => { const at = document.getElementById('section-at'); at.value = '900'; at.oninput(); })()")
    checks.expect(browser.value(f"{planes}.constant") != where, "the slider moves the plane")
    side = browser.value(f"{planes}.normal.z")
    browser.value("document.getElementById('section-flip').click()")
    checks.expect(browser.value(f"{planes}.normal.z") == -side, "the other side is kept")
    browser.press("c")
    checks.expect(browser.value("toccata.stage.renderer.clippingPlanes.length") == 0, "no longer")
    browser.press("m")
    x, y, width, height = browser.value("(box => [box.left, box.top, box.width, box.height])(toccata.stage.canvas.getBoundingClientRect())")
    for right in [0.48, 0.52]:
        browser.click(x + right * width, y + 0.5 * height)
    told = browser.value("document.getElementById('measured').textContent")
    checks.expect("mm" in told and "along the axes" in told, f"the measure: {told}")
    browser.press("m")
    checks.expect(browser.value("document.getElementById('measured').textContent") == "", "no longer")


def check_depths(checks, browser):
    """A depth is told as the bracket it is, in the row, in the sentence and in the picture, by the rule of the command."""
    checks.run("check", "gen:torus-knot?around=40&sides=6", "gen:torus-knot?around=40&sides=6", "--pose-b", "0.7", "0.1", "0",
               "--penetration", "--precision", "0.5", "--html", "knots.html")
    checks.opened(browser, "knots.html", "#finding=0&theme=light")
    depth = browser.value("toccata.data.report.pairs[0].penetration")
    checks.expect(depth["upper"] > 1.01 * depth["lower"], f"this depth is known as a bracket: {depth}")
    told = {"the row": LISTED, "the facts": "[document.getElementById('facts').textContent]",
            "the picture": "[...document.querySelectorAll('#marks .mark')].map(mark => mark.textContent + ' deep')"}
    for where, words in told.items():
        said = browser.value(words)
        checks.expect(any(" to " in text and tells_depth(text, depth) for text in said), f"{where} tells {depth}: {said}")
    name = browser.value("toccata.data.report.objects[1].name")
    facts = browser.value("document.getElementById('facts').textContent")
    checks.expect(f"; moving {name} by " in facts, f"the object that is moved is named: {facts}")
    for case in json.loads((HERE.parent / "reports" / "bracket_texts.json").read_text()):
        said = browser.value(f"(Object.assign(toccata.data.report.pairs[0].penetration, {{ lower: {case['lower']!r}, upper: {case['upper']!r} }}), toccata.findings.all[0].what)")
        wanted = f" · {case['text']} deep" if case["upper"] > 0 else ""
        checks.expect(said.endswith(wanted) and (wanted or "deep" not in said), f"{case}: {said}")
    checks.quiet(browser, "knots.html")


def check_stopped(checks, browser):
    """Of a check that was stopped the picture says that it is not all, without panels, too."""
    said = "(() => { const said = document.getElementById('partial'); return said.offsetHeight > 0 ? said.textContent : ''; })()"
    checks.expect(browser.value(said) == "", "a check of all pairs says nothing of it")
    checks.run("check", "hall.json", "--stop-after", "1e-9", "--html", "stopped.html")
    checks.opened(browser, "stopped.html", "#panels=0")
    told = browser.value(said)
    checks.expect(told.startswith("Stopped: ") and told.endswith(" not looked at"), f"stopped: {told!r}")
    checks.quiet(browser, "stopped.html")


def main():
    command = str(pathlib.Path(sys.argv[1]).resolve())
    if not find_chromium():
        print("Chromium is not installed")
        return 77
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else temporary)
        folder.mkdir(parents=True, exist_ok=True)
        checks = Checks(command, folder)
        write_files(checks)
        (folder / "old.json").write_text(checks.run("check", "before.json", "--json"))
        checks.run("check", "hall.json", "--penetration", "--volume", "--tolerance", "0.1", "--group", "region",
                   "--baseline", "old.json", "--html", "hall.html")
        with Browser() as browser:
            checks.opened(browser, "hall.html", "#theme=light")
            check_framing(checks, browser)
            check_list(checks, browser)
            check_sorting(checks, browser)
            check_baseline(checks, browser)
            check_keys(checks, browser)
            check_tools(checks, browser)
            check_review(checks, browser)
            checks.quiet(browser, "hall.html")
            check_stopped(checks, browser)
            check_depths(checks, browser)
    print(f"{checks.count} checks, {len(checks.failures)} failed")
    return 1 if checks.failures else 0


if __name__ == "__main__":
    sys.exit(main())
