"""The page of a crowd: boxes that move, their pairs, the cells of the method, and the slider over time."""
import json
import time

from pixels import differing, is_orange, share

SEEN = """(() => {
  const parts = {};
  for (const { name, geometry } of toccata.stage.overlays.children) {
    if (name === 'links') parts.pairs = geometry.attributes.end ? geometry.index.count / 12 : geometry.attributes.position.count / 2;
    else if (name === 'bodies') parts.boxes = geometry.index.count / 36;
    else if (name === 'cells') parts.cells = geometry.index.count / 24;
  }
  return parts;
})()"""
CORNERS = """(() => {
  const { geometry } = toccata.stage.overlays.children.find(({ name }) => name === 'bodies');
  return [...geometry.attributes.position.array];
})()"""
SLIDE = "(() => {{ const slider = document.getElementById('moment'); slider.value = {}; slider.dispatchEvent(new Event('input')); }})()"
TOGGLE = "[...document.querySelectorAll('#layers label')].find((label) => label.textContent === '{}').querySelector('input').click()"


def check_crowd(checks, browser):
    words = ["crowd", "--scene", "static", "--count", "200", "--method", "grid", "--json"]
    report = json.loads(checks.run(*words, "--frames", "9", "--html", "crowd.html"))
    checks.opened(browser, "crowd.html", "#theme=light")
    moments = browser.value("toccata.data.header.time.moments")
    checks.expect(len(moments) == 10, f"{len(moments)} moments for 9 frames and what was before")
    for frame in [1, 4, 9]:
        found = json.loads(checks.run(*words, "--frames", str(frame)))["methods"][0]["pairs"]
        browser.value(SLIDE.format(frame))
        seen = browser.value(SEEN)
        checks.expect(seen.get("pairs") == found, f"frame {frame}: {seen} drawn of {found} pairs")
        checks.expect(seen.get("boxes") == 200, f"frame {frame}: {seen} drawn of 200 boxes")
        told = browser.value("document.getElementById('moment-text').textContent")
        checks.expect(told.startswith(f"frame {frame}: {found} pairs, "), f"frame {frame}: {told}")
        checks.expect(f"; grid, {seen.get('cells')} cells" in told, f"frame {frame}: {told}, drawn {seen}")
    checks.expect(report["methods"][0]["pairs"] == found, "the page is of the same run")
    look_at_time(checks, browser)
    look_at_layers(checks, browser)
    use_keys(checks, browser)
    checks.quiet(browser, "crowd")


def look_at_time(checks, browser):
    browser.value(SLIDE.format(0))
    before, places = browser.picture(), browser.value(CORNERS)
    browser.value(SLIDE.format(9))
    time.sleep(0.3)
    after, later = browser.picture(), browser.value(CORNERS)
    moved = sum(places[i : i + 24] != later[i : i + 24] for i in range(0, len(places), 24))
    checks.expect(3 <= moved <= 20, f"{moved} of 200 boxes moved, where one in twenty does")
    seen, _ = differing(before, after)
    checks.expect(seen > 0.0005, f"what moves is seen to: {seen:.4f}")
    checks.expect(share(after, is_orange) > 0.0005, "movers in a pair are orange")
    grey = share(after, lambda pixel: max(pixel) - min(pixel) < 30 and 70 < max(pixel) < 215)
    checks.expect(grey > 0.02, f"what rests is grey: {grey:.4f}")


def look_at_layers(checks, browser):
    calls = browser.value("toccata.stage.renderer.info.render.calls")
    checks.expect(calls <= 4, f"boxes, cells, grid and pairs in {calls} drawing calls")
    for name, what in [("Cells", "cells"), ("Pairs", "pairs"), ("Boxes", "boxes")]:
        shown = browser.picture()
        browser.value(TOGGLE.format(name))
        time.sleep(0.3)
        checks.expect(what not in browser.value(SEEN), f"{name} can be hidden")
        seen, _ = differing(shown, browser.picture())
        checks.expect(seen > 0.001, f"{name} cover {seen:.4f} of the picture")
        browser.value(TOGGLE.format(name))
        checks.expect(what in browser.value(SEEN), f"{name} can be shown again")
    key = browser.value("[...document.querySelectorAll('.classes')][0].innerText.split('\\n')")
    checks.expect(key == ["at rest", "moving", "moving, in a pair"], f"the colours are told: {key}")


def use_keys(checks, browser):
    browser.value(f"{SLIDE.format(4)}; document.activeElement.blur()")
    browser.press(".")
    checks.expect(browser.value("toccata.state.moment") == 5, "a full stop goes to the next moment")
    browser.press(",")
    checks.expect(browser.value("toccata.state.moment") == 4, "a comma goes to the one before")
    label = browser.value("[...document.querySelectorAll('#time [aria-label], #time')].map((one) => one.getAttribute('aria-label'))")
    checks.expect(label == ["Time", "Previous moment", "Next moment", "Moment"], f"the bar is named: {label}")
    spoken = browser.value("document.getElementById('moment').getAttribute('aria-valuetext')")
    checks.expect(spoken.startswith("frame 4: "), f"the slider is spoken: {spoken}")
    checks.expect("moment=4" in browser.value("toccata.link()"), "the moment is in the link")
    browser.press(" ")
    checks.expect(browser.value("document.getElementById('play').textContent") == "Pause", "Space plays")
    browser.wait_for("toccata.state.moment === 9")
    browser.wait_for("document.getElementById('play').textContent === 'Play'")
    time.sleep(0.5)
    drawn = browser.value("toccata.stage.drawn")
    time.sleep(0.5)
    checks.expect(browser.value("toccata.stage.drawn") == drawn, "nothing is drawn when it has been played")
    browser.value("document.getElementById('play').click()")
    checks.expect(browser.value("toccata.state.moment") < 9, "played again from the beginning")
    browser.value("document.getElementById('play').click()")
    checks.opened(browser, "crowd.html", "#moment=3")
    browser.wait_for("toccata.state.moment === 3")
    browser.open("/", "")
    checks.opened(browser, "crowd.html", "#moment=77&off=cells")
    told = browser.value("document.getElementById('complaint-text').textContent")
    checks.expect("no moment “77”: here moments are 0 to 9" in told, f"a moment that is not there: {told}")
    checks.expect("cells" not in browser.value(SEEN), "a link can switch cells off")


def check_crowd_of_methods(checks, browser):
    """Each method shows what it divided space into."""
    kinds = {"kd-tiles": "tiles", "hierarchical-hash": "cells of side", "loose-octree": "cells of side", "morton-tree": "tree, level 0",
             "layers": "intervals along", "sort-and-sweep": "intervals along", "rectangle-sweeps": "rectangles in xy"}
    for method, kind in kinds.items():
        checks.run("crowd", "--scene", "static" if method == "layers" else "sizes", "--count", "600", "--frames", "2", "--method", method, "--html", "method.html")
        browser.open("/", "")
        checks.opened(browser, "method.html", "#moment=2")
        classes = browser.value("toccata.data.header.layers[2].classes")
        checks.expect(any(name.startswith(kind) for name in classes), f"{method} shows {classes}")
        drawn = browser.value(SEEN)
        checks.expect(drawn.get("cells", 0) == browser.value("toccata.data.header.layers[2].moments[2][1]") > 0, f"{method} draws {drawn}")
    checks.quiet(browser, "methods")


def check_large_crowd(checks, browser):
    checks.run("crowd", "--count", "10000", "--frames", "10", "--method", "grid", "--html", "large-crowd.html")
    size = (checks.folder / "large-crowd.html").stat().st_size / 1e6
    started = time.monotonic()
    checks.opened(browser, "large-crowd.html")
    opened = time.monotonic() - started
    started, drawn = time.monotonic(), browser.value("toccata.stage.drawn")
    for frame in range(1, 3):
        browser.value(SLIDE.format(frame))
        browser.wait_for(f"toccata.stage.drawn >= {drawn + frame}")
    print(f"a crowd of 10,000: {size:.1f} MB, drawn in {opened:.2f} s, and a moment in {(time.monotonic() - started) / 2:.2f} s")
    calls = browser.value("toccata.stage.renderer.info.render.calls")
    checks.expect(calls <= 4, f"a crowd of 10,000 in {calls} drawing calls")
    checks.expect(size < 24, f"a crowd of 10,000: {size:.1f} MB")
    checks.quiet(browser, "large crowd")
