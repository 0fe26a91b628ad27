"""The cells of partitions over a mesh, depth by depth, and the cells that moving boxes enter and leave."""
import json
import time

from pixels import differing, is_blue, is_orange, share

SLIDE = "(() => {{ const slider = document.querySelector('#layers input[type=range]'); slider.value = {}; slider.oninput(); }})()"
DRAWN = "toccata.stage.overlays.children.map((drawn) => drawn.geometry.index.count / 24)"
# How far the box of what is drawn sticks out of the object's, and the reverse, in shown lengths.
REACH = """(() => {
  const cells = toccata.stage.overlays.children[0];
  cells.updateMatrixWorld();
  cells.geometry.computeBoundingBox();
  const around = cells.geometry.boundingBox.clone().applyMatrix4(cells.matrixWorld), object = toccata.boxOf(0);
  return [...object.min.toArray().map((x, i) => x - around.min.toArray()[i]), ...object.max.toArray().map((x, i) => around.max.toArray()[i] - x)];
})()"""
PLACE, AWAY = "1 0 0 0 0 -1 0 1 0 5 0 0".split(), "1 0 0 0 1 0 0 0 1 5 6 0".split()  # the first one turned about x
# For each body whether its middle lies in a cell that it has entered or kept, and how many cells are of which class.
HELD = """(() => {
  const layers = toccata.data.header.layers, moment = toccata.state.moment;
  const boxes = (layer) => {
    const { lower, step } = layer.data, [first, count] = layer.moments[moment];
    const numbers = toccata.data.shorts(layer.data).subarray(7 * first, 7 * (first + count));
    const at = (box, side, axis) => lower[axis] + step[axis] * numbers[7 * box + 3 * side + axis];
    return Array.from({ length: count }, (_, i) => ({ of: numbers[7 * i + 6], lower: [0, 1, 2].map((k) => at(i, 0, k)), upper: [0, 1, 2].map((k) => at(i, 1, k)) }));
  };
  const bodies = boxes(layers.find((layer) => layer.kind === 'bodies')), cells = boxes(layers.find((layer) => layer.kind === 'cells'));
  const holds = (cell, body) => [0, 1, 2].every((k) => { const x = (body.lower[k] + body.upper[k]) / 2; return x > cell.lower[k] - 1e-3 && x < cell.upper[k] + 1e-3; });
  const now = cells.filter((cell) => cell.of < 2);
  return { held: bodies.map((body) => now.some((cell) => holds(cell, body))), of: [0, 1, 2, 3].map((one) => cells.filter((cell) => cell.of === one).length) };
})()"""


def check_partitions(checks, browser):
    measured = json.loads(checks.run("inspect", "gen:torus-knot", "--partitions", "--json"))["objects"][0]["partitions"]
    for cost in measured:
        kind = cost["partition"]
        checks.run("view", "gen:torus-knot", "gen:box", "--pose-a", *PLACE, "--pose-b", *AWAY, "--partition", kind, "-o", "partition.html")
        browser.open("/", "")
        checks.opened(browser, "partition.html", "#hidden=1&theme=light")
        look_at_cells(checks, browser, kind, cost)
    checks.quiet(browser, "partitions")


def look_at_cells(checks, browser, kind, cost):
    steps = browser.value("toccata.data.header.layers.find((layer) => layer.object === 0 && layer.role === 'partition').steps")
    last = steps[-1]
    checks.expect(last["count"] == cost["cells"], f"{kind}: {last['count']} of {cost['cells']} cells")
    told = f"{cost['cells']} cells with {cost['items_per_cell']:.1f} triangles on average, {cost['most_in_a_cell']} at most; a triangle is in {cost['copies_per_item']:.2f}"
    checks.expect(last["note"] == told, f"{kind}: {last['note']} is told, not {told}")
    is_looked_at = kind in {"octree", "r-tree"}  # pictures take their time
    without = browser.picture() if is_looked_at else None
    step = max(i for i, one in enumerate(steps) if one["count"] < 1000 or i == 0)
    browser.value(SLIDE.format(step))
    time.sleep(0.3)
    shown = browser.value("document.querySelector('#layers output').textContent")
    checks.expect(shown == f"{steps[step]['label']}: {steps[step]['note']}", f"{kind}: {shown}")
    checks.expect(browser.value(DRAWN) == [steps[step]["count"]], f"{kind}: {browser.value(DRAWN)} drawn of {steps[step]['count']}")
    checks.expect(browser.value("toccata.stage.renderer.info.render.calls") <= 3, f"{kind}: cells, mesh and grid, one call each")
    checks.expect(min(browser.value(REACH)) > -1e-4, f"{kind}: the mesh sticks out of its cells: {browser.value(REACH)}")
    if not is_looked_at:
        return
    seen, _ = differing(without, browser.picture())
    checks.expect(seen > 0.005, f"{kind}: cells cover {seen:.4f} of the picture")


def check_tracked_cells(checks, browser):
    checks.run("crowd", "--scene", "fast", "--count", "60", "--frames", "6", "--method", "grid", "--cells", "tracked", "--html", "tracked.html")
    browser.open("/", "")
    checks.opened(browser, "tracked.html", "#moment=4&off=pairs&theme=light")
    names = browser.value("[...document.querySelectorAll('.classes')].pop().innerText.split('\\n')")
    checks.expect(names == ["entered in this frame", "kept", "passed on the way", "left in this frame"], f"the classes: {names}")
    for moment in [0, 3, 6]:
        browser.value(f"toccata.time.go({moment})")
        seen = browser.value(HELD)
        checks.expect(len(seen["held"]) == 60 and all(seen["held"]), f"moment {moment}: {seen['held'].count(False)} bodies are in no cell")
        checks.expect(seen["of"][0] > 0 and (moment == 0) == (sum(seen["of"][1:]) == 0), f"moment {moment}: cells of each class {seen['of']}")
    time.sleep(0.3)
    picture = browser.picture()
    checks.expect(share(picture, is_blue) > 0.001 and share(picture, is_orange) > 0.001, "cells and boxes are seen")
    checks.quiet(browser, "tracked")
