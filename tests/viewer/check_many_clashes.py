#!/usr/bin/env python3
"""Looks in Chromium at the page of a rack of pipes with a thousand clashes: that what is made only where it is seen, the rows of
the list, curves and all triangles, is right wherever one goes.

usage: check_many_clashes.py TOCCATA [FOLDER]     with FOLDER, what was seen is kept there

Exits with 77, which CTest takes for skipped, where Chromium is not installed.
"""
import json
import pathlib
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent.parent / "apps/bench")]
from browser import Browser, find_chromium  # noqa: E402
from check_clashes import type_into  # noqa: E402
from check_pages import Checks  # noqa: E402
from page_content import tells_depth  # noqa: E402
from racks import Rack, write_meshes  # noqa: E402

RACK = Rack(layers=16, pipes=8, around=12, along=100)
CLASHES, PARTS, TRIANGLES = len(RACK.depths()), RACK.parts(), RACK.triangles()
ORDER = "toccata.panels.order"
CHOSEN = """(() => { const list = document.getElementById('finding-list'), rows = [...list.querySelectorAll('li.chosen')];
  const [seen, box] = [list.getBoundingClientRect(), rows[0]?.getBoundingClientRect()];
  return [rows.map(row => Number(row.dataset.finding)), rows[0]?.textContent, box && box.top >= seen.top - 1 && box.bottom <= seen.bottom + 1]; })()"""
DRAWN = """toccata.stage.overlays.children.filter(drawn => drawn.name === 'segments').map(drawn => [...drawn.geometry.attributes.position.array])"""


def check_chosen(checks, browser, pairs, finding, how):
    """The chosen clash in the list, in the sentence and in the picture is the one of the report."""
    pair = pairs[finding]
    rows, text, is_seen = browser.value(CHOSEN)
    checks.expect(rows == [finding] and is_seen, f"{how}: the row of {finding} is marked and seen: {rows}, {is_seen}")
    checks.expect(text is not None and text.startswith(f"{pair['a']} – {pair['b']}"), f"{how}: the row of {pair['a']} and {pair['b']}: {text}")
    sentence = browser.value("document.getElementById('sentence').textContent")
    checks.expect(pair["a"] in sentence and pair["b"] in sentence, f"{how}: the sentence: {sentence}")
    facts = browser.value("document.getElementById('facts').textContent")
    checks.expect(tells_depth(facts, pair["penetration"]), f"{how}: the depth {pair['penetration']}: {facts}")
    checks.expect(tells_depth(text or "", pair["penetration"]), f"{how}: the depth {pair['penetration']}: {text}")
    drawn = browser.value(DRAWN)
    wanted = browser.value(f"toccata.data.layersOf({finding}).filter(layer => layer.kind === 'segments').length")
    checks.expect(len(drawn) == wanted == 2, f"{how}: curve and depth are drawn: {len(drawn)} of {wanted}")
    centre, size = browser.value("(frame => [frame.centre, frame.size])(toccata.data.header.frame)")
    (lower, upper), middle = (pair["regions"][0][end] for end in ("lower", "upper")), [sum(axis) / len(axis) for axis in (drawn[0][i::3] for i in range(3))]
    at = [c + size * x for c, x in zip(centre, middle)]
    checks.expect(all(a - 1e-3 < x < b + 1e-3 for a, x, b in zip(lower, at, upper)), f"{how}: the curve is at {at}, between {lower} and {upper}")


def check_list(checks, browser, pairs):
    """Only the rows that are seen are there, and the list goes on for all of them."""
    order = browser.value(ORDER)
    checks.expect(sorted(order) == list(range(CLASHES)), f"all are listed: {len(order)}")
    checks.expect(browser.value("document.querySelectorAll('#finding-list .row').length") < 100, "few rows are made")
    browser.value("(list => list.scrollTop = list.scrollHeight)(document.getElementById('finding-list'))")
    last = f"[...document.querySelectorAll('#finding-list li[data-finding]')].pop()?.dataset.finding === '{order[-1]}'"
    browser.wait_for(last, 10)
    checks.expect(browser.value("document.querySelectorAll('#finding-list .row').length") < 100, "and few at the end")
    browser.value("[...document.querySelectorAll('#finding-list .row')].pop().click()")
    check_chosen(checks, browser, pairs, order[-1], "the last of the list")
    at = [int(x) for x in browser.value("(row => [row.getAttribute('aria-posinset'), row.getAttribute('aria-setsize')])(document.querySelector('li.chosen'))")]
    checks.expect(at == [CLASHES, CLASHES], f"readers of the screen are told where it is: {at}")


def check_keys(checks, browser, pairs):
    order = browser.value(ORDER)
    browser.value("document.getElementById('canvas').focus()")
    browser.press("n")
    check_chosen(checks, browser, pairs, order[0], "N at the last goes to the first")
    browser.press("p")
    check_chosen(checks, browser, pairs, order[-1], "P at the first to the last")
    browser.value(f"toccata.choose({ORDER}[700])")
    check_chosen(checks, browser, pairs, order[700], "far down the list")
    browser.press("j")
    check_chosen(checks, browser, pairs, order[701], "J from there")


def check_ways(checks, browser, pairs):
    """Orders, filter and groups are of all clashes, not of those whose rows are there."""
    type_into(browser, "order", "deepest")
    depths = [pairs[i]["penetration"]["upper"] for i in browser.value(ORDER)]
    checks.expect(depths == sorted(depths, reverse=True), "the deepest first")
    type_into(browser, "order", "listed")
    checks.expect(browser.value(ORDER) == list(range(CLASHES)), "as listed")
    type_into(browser, "clash-filter", "pipe-14-7")
    wanted = [i for i, pair in enumerate(pairs) if "pipe-14-7" in (pair["a"], pair["b"])]
    checks.expect(browser.value(ORDER) == wanted, "filtered")
    type_into(browser, "clash-filter", "")
    type_into(browser, "grouping", "part")
    listed = browser.value("toccata.panels.listed.map(({ heading, finding }) => heading ?? finding)")
    counts = [int(entry.rsplit(" · ", 1)[1]) for entry in listed if isinstance(entry, str)]
    checks.expect(sum(counts) == CLASHES and counts == sorted(counts, reverse=True), f"groups: {counts}")
    at, members = 0, set()
    for count in counts:
        part = listed[at].rsplit(" · ", 1)[0]
        group = listed[at + 1:at + 1 + count]
        checks.expect(all(part in (pairs[i]["a"], pairs[i]["b"]) for i in group), f"{part}: the clashes of its group are its own")
        members.update(group)
        at += 1 + count
    checks.expect(len(members) == CLASHES, "each clash is in one group")
    browser.value(f"toccata.choose({ORDER}[650])")
    check_chosen(checks, browser, pairs, browser.value(ORDER)[650], "under headings")
    type_into(browser, "grouping", "none")
    browser.value("document.getElementById('tab-objects').click()")
    type_into(browser, "filter", "pipe-15-7")
    rows = browser.value("[...document.querySelectorAll('#object-list .row')].map(row => row.textContent)")
    checks.expect(len(rows) == 1 and rows[0].startswith("pipe-15-7"), f"one object is called so: {rows}")
    type_into(browser, "filter", "")
    checks.expect(browser.value("toccata.panels.objectRows.items.length") == PARTS, "all objects are listed")
    browser.value("document.getElementById('tab-findings').click()")


def check_slow_frames(checks, browser, moving):
    """Three slow frames in turn, and less is drawn from there on; never less than the least."""
    def after(*waits):  # before the browser gives a frame
        told = "[toccata.stage.level, toccata.stage.renderer.info.render.triangles, toccata.stage.renderer.info.render.points, toccata.stage.canvas.width]"
        return browser.value(f"({moving}, toccata.stage.setLevel(0), {''.join(f'toccata.stage.waited({wait}), ' for wait in waits)}toccata.stage.drawNow(), {told})")
    level, triangles, points, width = after(100, 100, 10, 100, 100)
    checks.expect(level == 0 and points == CLASHES, f"a quick frame between slow ones is enough: {level}")
    slower = after(100, 100, 100)
    checks.expect(slower[0] == 1 and 500 < slower[1] < triangles and slower[2] == points / 2 and slower[3] < width, f"after slow frames: {slower} for {triangles}")
    slowest = after(*[100] * 20)
    checks.expect(slowest[0] == 2 and slowest[1] < slower[1] and slowest[2] == points / 4, f"the last level stays: {slowest}")
    sides = "[...new Set(toccata.objects.closedMaterials.map(material => material.side))]"
    checks.expect(browser.value(sides) == [0], "without the backs of closed meshes")
    browser.wait_for("toccata.stage.isWhole")
    checks.expect(browser.value(sides) == [2], "and with them when it rests")


def check_picture(checks, browser):
    """None chosen: a point for each clash. While the picture moves fewer triangles are drawn, and all when it rests."""
    browser.value("toccata.choose(undefined)")
    whole, triangles = "toccata.stage.isWhole", "toccata.stage.renderer.info.render.triangles"
    browser.wait_for(whole)
    browser.value("toccata.stage.drawNow()")
    calls, points = browser.value("[toccata.stage.renderer.info.render.calls, toccata.stage.renderer.info.render.points]")
    checks.expect(points == CLASHES, f"{points} points for {CLASHES} clashes")
    checks.expect(calls <= 4, f"{calls} drawing calls")
    checks.expect(browser.value(triangles) == TRIANGLES, f"all triangles: {browser.value(triangles)}")
    width = browser.value("toccata.stage.canvas.width")
    hit = "(box => toccata.stage.hit(box.left + box.width / 2, box.top + box.height / 2)?.object)(toccata.stage.canvas.getBoundingClientRect())"
    under = browser.value(hit)
    moving = "toccata.stage.isSlow = true, toccata.stage.orbit.turn(0, 0), toccata.stage.drawNow()"
    fewer, narrow, is_whole = browser.value(f"({moving}, [{triangles}, toccata.stage.canvas.width, {whole}])")
    checks.expect(500 < fewer < TRIANGLES / 4 and not is_whole, f"while it moves: {fewer} triangles")
    checks.expect(narrow <= width / 2 + 1, f"and half as fine: {narrow} of {width}")
    checks.expect(under is not None and browser.value(f"({moving}, {hit})") == under, "what is under a place is told by all triangles")
    check_slow_frames(checks, browser, moving)
    browser.wait_for(whole)
    checks.expect(browser.value(f"[{triangles}, toccata.stage.canvas.width, toccata.stage.renderer.info.render.points]") == [TRIANGLES, width, CLASHES], "all again when it rests")
    browser.value(f"({moving}, toccata.stage.drawAll())")
    checks.expect(browser.value(f"[{triangles}, {whole}]") == [TRIANGLES, True], "a picture that is saved has all of them")


def main():
    command = str(pathlib.Path(sys.argv[1]).resolve())
    if not find_chromium():
        print("Chromium is not installed")
        return 77
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else temporary)
        (folder / "rack").mkdir(parents=True, exist_ok=True)
        checks = Checks(command, folder)
        write_meshes(folder / "rack", RACK)
        pairs = json.loads(checks.run("check", "rack", "--penetration", "--json", "--html", "rack.html"))["pairs"]
        checks.expect(len(pairs) == CLASHES, f"{len(pairs)} clashes")
        with Browser() as browser:
            checks.opened(browser, "rack.html", "#theme=light&finding=400")
            check_chosen(checks, browser, pairs, 400, "by a link")
            check_list(checks, browser, pairs)
            check_keys(checks, browser, pairs)
            check_ways(checks, browser, pairs)
            check_picture(checks, browser)
            checks.quiet(browser, "rack.html")
    print(f"{checks.count} checks, {len(checks.failures)} failed")
    return 1 if checks.failures else 0


if __name__ == "__main__":
    sys.exit(main())
