"""The page of a walk: the path, the walker on it, and at each step what it stands on and met."""
import json
import time

from pixels import differing

LEVEL = """{"format": "toccata-scene", "version": 1, "unit": "m", "objects": [
  {"name": "floor", "shape": {"type": "box", "half_extents": [4, 2, 0.5]}, "pose": {"translation": [0, 0, -0.5]}},
  {"name": "step", "shape": {"type": "box", "half_extents": [1, 2, 0.1]}, "pose": {"translation": [2, 0, 0.1]}},
  {"name": "wall", "shape": {"type": "box", "half_extents": [0.1, 2, 1]}, "pose": {"translation": [3, 0, 1]}}]}"""
GO = "toccata.time.go({})"
LAYER = "toccata.data.header.layers.find((layer) => layer.role === '{}')"
# In the world: where the origin of the walker's frame is drawn, and what the layer has at this moment.
FOOT = """(() => {
  const { centre, size } = toccata.data.header.frame, box = toccata.boxOf(3);
  return [(box.min.x + box.max.x) / 2 * size + centre[0], (box.min.y + box.max.y) / 2 * size + centre[1], box.min.z * size + centre[2]];
})()"""
POINTS = """(() => {{
  const {{ centre, size }} = toccata.data.header.frame, layer = {}, [first, count] = layer.moments[toccata.state.moment];
  return [...toccata.data.floats(layer.data).subarray({} * first, {} * (first + count))].map((x, i) => x * size + centre[i % 3]);
}})()"""


def near(a, b, tolerance=1e-4):
    return len(a) == len(b) and all(abs(x - y) <= tolerance for x, y in zip(a, b))


def check_walk(checks, browser):
    (checks.folder / "hall.json").write_text(LEVEL)
    report = json.loads(checks.run("walk", "hall.json", "--from", "-2", "0", "0", "--to", "3.5", "0", "0.2", "--json", "--html", "walk.html"))
    (checks.folder / "walk.json").write_text(json.dumps(report))
    steps = report["steps"]
    checks.opened(browser, "walk.html", "#theme=light")
    moments = browser.value("toccata.data.header.time.moments")
    checks.expect(len(moments) == len(steps) + 1, f"{len(moments)} moments of {len(steps)} steps and the start")
    path = browser.value(POINTS.format(LAYER.format("path"), 6, 6))
    places = [report["walk"]["from"], *(step["position"] for step in steps)]
    ends = [x for a, b in zip(places, places[1:]) for x in [*a, *b]]
    checks.expect(near(path, ends), f"the path of {len(path)} numbers is that of the report")
    pictures = []
    for moment in [1, len(steps) // 2, len(steps)]:
        browser.value(GO.format(moment))
        time.sleep(0.3)
        step = steps[moment - 1]
        checks.expect(near(browser.value(FOOT), step["position"], 1e-3), f"step {moment}: the walker is drawn at {browser.value(FOOT)}, and is at {step['position']}")
        touched = [contact["point"] for contact in [step["ground"], *step["contacts"]] if contact]
        drawn = browser.value(POINTS.format(LAYER.format("contact"), 3, 3))
        checks.expect(near(drawn, [x for point in touched for x in point]), f"step {moment}: {drawn} are drawn of {touched}")
        told = browser.value("document.getElementById('moment-text').textContent")
        checks.expect(told.startswith(f"step {moment}: on {step['ground']['object']}"), f"step {moment}: {told}")
        pictures.append(browser.picture())
    checks.expect("meets wall" in told, f"at last it meets the wall: {told}")
    seen, _ = differing(pictures[0], pictures[-1])
    checks.expect(seen > 0.005, f"the walker is seen to move: {seen:.4f}")
    labels = browser.value("[...document.querySelectorAll('#layers label')].map((label) => label.textContent)")
    checks.expect({"Path", "Where they meet", "Normals"} <= set(labels), f"layers can be switched: {labels}")
    browser.value("[...document.querySelectorAll('#layers label')].find((label) => label.textContent === 'Path').querySelector('input').click()")
    time.sleep(0.3)
    without, _ = differing(pictures[-1], browser.picture())
    checks.expect(without > 0.0005, f"the path is seen: {without:.4f}")
    checks.run("view", "walk.json", "-o", "recorded.html")
    checks.opened(browser, "recorded.html", f"#moment={len(steps)}")
    checks.expect(near(browser.value(FOOT), report["position"], 1e-3), "a recorded walk is drawn the same")
    checks.quiet(browser, "walk")
