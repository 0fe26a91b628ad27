"""Every kind of layer is one drawing call, curves in creases are seen, and a page says what it shows where nothing was asked."""
import pathlib
import re
import time


DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs/reference/view-page.md"
# How many calls fewer there are without each layer that is drawn, by kind.
CALLS = """(() => {
  const { stage } = toccata, calls = () => (stage.drawNow(), stage.renderer.info.render.calls), all = calls();
  return stage.overlays.children.map((layer) => {
    layer.visible = false;
    const without = calls();
    layer.visible = true;
    return [layer.name, all - without];
  });
})()"""


def layer_kinds():
    """As the table of the documentation names them."""
    table = DOCS.read_text().split("| kind | an item | numbers |")[1].split("\n\n")[0]
    return set(re.findall(r"^\| `(\w+)` \|", table, re.MULTILINE))


def check_layer_calls(checks, browser):
    away = ["--pose-b", *"1 0 0 0 1 0 0 0 1 0.7 0.1 0".split()]
    checks.run("check", "gen:torus", "gen:torus", *away, "--faces", "--penetration", "--html", "layer-contact.html")
    checks.run("faces", "gen:torus", "--box", *"-1 -1 -1 1 0 1".split(), "--html", "layer-region.html")
    checks.run("view", "gen:torus-knot", "--hierarchy", "obb", "-o", "layer-level.html")
    checks.run("view", "gen:torus-knot", "--hierarchy", "ball", "-o", "layer-round.html")
    checks.run("view", "gen:torus-knot", "--partition", "octree", "-o", "layer-cells.html")
    checks.run("view", "gen:box", "--voronoi", "-o", "layer-voronoi.html")
    checks.run("crowd", "--count", "200", "--frames", "3", "--html", "layer-crowd.html")
    seen = set()
    for name in ["contact", "region", "level", "round", "cells", "voronoi", "crowd"]:
        for through in ["", "&through=1"]:
            browser.open("/", "")
            end = "#finding=0" if name in ("contact", "region") else ""
            checks.opened(browser, f"layer-{name}.html", end + (through if end else ""))
            if through:
                browser.value("toccata.change((state) => (state.through = true))")
            counted = browser.value(CALLS)
            seen |= {kind for kind, _ in counted}
            checks.expect(counted and all(calls == 1 for _, calls in counted), f"{name}{through}: drawing calls of each layer: {counted}")
            total = browser.value("toccata.stage.renderer.info.render.calls")
            objects = browser.value("toccata.data.report.objects.length")
            checks.expect(total <= len(counted) + objects + 1, f"{name}{through}: {total} calls for layers, {objects} objects and the grid")
    seen.discard("object")  # in the colours of a level
    seen.discard("")  # the frame of a place is no layer
    checks.expect(seen == layer_kinds(), f"kinds of layers that were drawn: {sorted(seen)}, and of the documentation: {sorted(layer_kinds())}")
    checks.quiet(browser, "layers")


# The middles of the segments of contact on the screen, and whether the two balls leave them to be seen.
MIDDLES = """(() => {
  const { stage, data } = toccata, eye = stage.orbit.camera.position.toArray(), { frame } = data.header;
  const centres = data.report.objects.map(({ pose }) => [0, 1, 2].map((k) => (pose[9 + k] - frame.centre[k]) / frame.size));
  const ends = data.floats(data.header.layers.find(({ kind, role }) => kind === 'segments' && role === 'contact').data);
  const made = [];
  for (let i = 0; i < ends.length; i += 6) {
    const middle = [0, 1, 2].map((k) => (ends[i + k] + ends[i + 3 + k]) / 2);
    const facing = centres.map((centre) => {
      const out = middle.map((x, k) => x - centre[k]), to = eye.map((x, k) => x - middle[k]);
      return out.reduce((sum, x, k) => sum + x * to[k], 0) / Math.hypot(...out) / Math.hypot(...to);
    });
    const at = stage.onScreen(toccata.boxOf(0).min.clone().set(...middle)), box = stage.canvas.getBoundingClientRect();
    made.push([Math.round(at.x + box.left), Math.round(at.y + box.top), Math.min(...facing)]);
  }
  return made;
})()"""


# How many corners of what is drawn over the objects are outside of the picture.
OUTSIDE = """(() => {
  const { stage } = toccata, { clientWidth, clientHeight } = stage.canvas, corner = toccata.boxOf(0).min.clone();
  let outside = 0;
  for (const drawn of stage.overlays.children) {
    const { array } = drawn.geometry.attributes.position;
    for (let i = 0; i < array.length; i += 3) {
      const at = stage.onScreen(corner.fromArray(array, i).applyMatrix4(drawn.matrixWorld));
      if (!at || at.x < 0 || at.y < 0 || at.x > clientWidth || at.y > clientHeight) ++outside;
    }
  }
  return outside;
})()"""


def full_picture(browser):
    time.sleep(0.3)
    return browser.rows_of(browser.call("Page.captureScreenshot", format="png")["data"])


def darkest(picture, x, y):
    """Of the pixels at a place: the curve is three wide, and its middle may lie between two."""
    return min(max(picture[y + dy][x + dx]) for dy in (-1, 0, 1) for dx in (-1, 0, 1))


def check_creases(checks, browser):
    """Where two balls cross, the curve lies in a crease: what the balls leave to be seen of it is dark, and what they hide is faint."""
    apart = ["--pose-b", *"1 0 0 0 1 0 0 0 1 1.2 0.3 0".split()]
    checks.run("check", "gen:icosphere", "gen:icosphere", *apart, "--html", "crease.html")
    for end in ["#finding=0&theme=light&labels=0&grid=0&camera=0,0,0,4,-0.9,0.45", "#theme=light&labels=0&grid=0&camera=0,0,0,4,-0.9,0.45"]:
        browser.open("/", "")
        checks.opened(browser, "crease.html", end)
        with_it, middles = full_picture(browser), browser.value(MIDDLES)
        browser.value("toccata.change((state) => { state.off.add('contact'); })")
        without = full_picture(browser)
        seen = [darkest(with_it, x, y) for x, y, facing in middles if facing > 0.1]
        hidden = [(darkest(with_it, x, y), darkest(without, x, y)) for x, y, facing in middles if facing < -0.3]
        checks.expect(len(seen) > 20 and len(hidden) > 20, f"{len(seen)} segments before and {len(hidden)} behind")
        dark = sum(value < 70 for value in seen) / max(len(seen), 1)
        checks.expect(dark > 0.97, f"{end}: {dark:.2f} of the curve in the crease is dark")
        faint = sum(value > 70 and plain - value > 12 for value, plain in hidden) / max(len(hidden), 1)
        checks.expect(faint > 0.9, f"{end}: {faint:.2f} of what is hidden is seen faintly")
    checks.quiet(browser, "creases")


def check_shown(checks, browser):
    """One object alone: nothing was asked, and the page says what it shows."""
    for words, name in [(["--voronoi"], "box: Voronoi regions"), (["--partition", "octree"], "box: cells of the octree"), (["--hierarchy", "obb"], "box: hierarchy of obb"), ([], "")]:
        checks.run("view", "gen:box", *words, "-o", "shown.html")
        browser.open("/", "")
        checks.opened(browser, "shown.html")
        summary, tab, listed = browser.value("['summary', 'tab-findings', 'finding-list'].map((id) => document.getElementById(id).textContent)")
        checks.expect("pair" not in summary and "collides" not in listed, f"{words}: {summary}; {listed}")
        checks.expect(tab == "Shown", f"{words}: the tab is {tab}")
        checks.expect(browser.value(OUTSIDE) == 0, f"{words}: all that is drawn is within the picture at first")
        told = f"{name}: " if name else "One object alone"
        checks.expect(name in summary and listed.startswith(told), f"{words}: {summary}; {listed}")
    checks.run("view", "gen:box", "gen:box", "--pose-b", *"1 0 0 0 1 0 0 0 1 5 0 0".split(), "-o", "shown.html")
    browser.open("/", "")
    checks.opened(browser, "shown.html")
    summary, listed = browser.value("['summary', 'finding-list'].map((id) => document.getElementById(id).textContent)")
    checks.expect("0 pairs in contact" in summary and listed == "Nothing collides.", f"two apart: {summary}; {listed}")
    checks.quiet(browser, "shown")
