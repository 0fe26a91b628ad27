"""The page of a World: bodies that move with time, and the pairs that have begun, are kept and have ended."""
import json
import time

from page_content import tells_depth
from pixels import differing, is_blue, is_orange, share

GO = "toccata.time.go({})"
# How many pairs are in contact at this moment, and the largest gap between the boxes of the two as drawn.
SEEN = """(() => {
  const moment = toccata.state.moment, pairs = toccata.data.report.steps[moment].pairs.filter((pair) => pair.change !== 'end');
  const gap = (a, b) => Math.max(...[0, 1, 2].map((i) => Math.max(a.min.getComponent(i) - b.max.getComponent(i), b.min.getComponent(i) - a.max.getComponent(i))));
  const middles = toccata.data.report.objects.map((_, i) => toccata.boxOf(i).min.toArray().concat(toccata.boxOf(i).max.toArray()));
  return { pairs: pairs.length, gap: Math.max(-1, ...pairs.map(({ a_index, b_index }) => gap(toccata.boxOf(a_index), toccata.boxOf(b_index)))), places: middles };
})()"""


def check_world(checks, browser):
    words = ["crowd", "--world", "--count", "300", "--frames", "10", "--json"]
    run = json.loads(checks.run(*words, "--html", "world.html"))
    checks.opened(browser, "world.html", "#theme=light")
    steps = browser.value("toccata.data.report.steps")
    changes = [[sum(pair["change"] == change for pair in step["pairs"]) for change in ["begin", "persist", "end"]] for step in steps]
    checks.expect(len(steps) == 11, f"{len(steps)} steps of 10 and what was before")
    checks.expect(sum(step[0] for step in changes[1:]) == run["begin"] and sum(step[2] for step in changes) == run["end"], f"begun and ended: {changes}, {run}")
    checks.expect(sum(changes[10][:2]) == run["pairs"] > 0, f"pairs of the last step: {changes[10]}, {run['pairs']}")
    look_at_steps(checks, browser, changes)
    look_at_a_pair(checks, browser, steps)
    checks.quiet(browser, "world")


def look_at_steps(checks, browser, changes):
    first = browser.value(SEEN)
    pictures = {}
    for moment in [10, 4, 0]:
        browser.value(GO.format(moment))
        time.sleep(0.3)
        seen = browser.value(SEEN)
        begun, kept, ended = changes[moment]
        checks.expect(seen["pairs"] == begun + kept, f"step {moment}: {seen['pairs']} pairs")
        checks.expect(seen["gap"] < 1e-4, f"step {moment}: bodies in contact are drawn {seen['gap']} apart")
        told = browser.value("document.getElementById('moment-text').textContent")
        checks.expect(told.startswith(f"step {moment}: {begun + kept} pair") and f"{begun} begin, {kept} persist; {ended} end" in told, f"step {moment}: {told}")
        rows = browser.value("document.querySelectorAll('#finding-list .row').length")
        checks.expect(rows == begun + kept + ended, f"step {moment}: {rows} rows")
        pictures[moment] = browser.picture()
    checks.expect(seen == first, "what goes back is where it was")
    seen, _ = differing(pictures[0], pictures[10])
    checks.expect(seen > 0.02, f"bodies are seen to move: {seen:.4f}")
    checks.expect(share(pictures[0], is_blue) > 0.005 and share(pictures[0], is_orange) > 0.002, "those in contact are orange, the others blue")
    calls = browser.value("toccata.stage.renderer.info.render.calls")
    checks.expect(calls <= 12, f"300 bodies of many shapes in {calls} drawing calls")


def look_at_a_pair(checks, browser, steps):
    """A pair is told, and stays chosen while it is there."""
    pair = next(pair for pair in steps[4]["pairs"] if pair["change"] == "persist" and pair["in_contact"])
    browser.value(GO.format(4))
    number = browser.value(f"toccata.findings.all.findIndex((one) => one.moment === 4 && one.a === {pair['a_index']} && one.b === {pair['b_index']})")
    browser.value(f"toccata.choose({number})")
    sentence = browser.value("document.getElementById('sentence').textContent")
    checks.expect(sentence == f"body {pair['a_index']} {pair['verb']} body {pair['b_index']} {pair['remark']}: as at the step before.", f"the sentence: {sentence}")
    facts = browser.value("document.getElementById('facts').textContent")
    checks.expect(f"{pair['points']} point" in facts and f" deep; moving body {pair['b_index']} by " in facts, f"the facts: {facts}")
    checks.expect(tells_depth(facts, pair["penetration"]), f"the depth {pair['penetration']}: {facts}")
    browser.value(GO.format(3))
    there = browser.value("toccata.findings.all[toccata.state.finding]?.moment")
    checks.expect(there == 3, f"the pair stays chosen at the step before: {there}")
    link = browser.value("toccata.link()")
    browser.open("/", "")
    checks.opened(browser, "world.html", link)
    checks.expect(browser.value("toccata.state.moment") == 3 and browser.value("toccata.findings.all[toccata.state.finding].moment") == 3, "a link restores it")


def check_large_world(checks, browser):
    """10,000 bodies that fly: one drawing for all of them, each step as the report has it."""
    words = ["crowd", "--world", "--count", "10000", "--frames", "3", "--json"]
    run = json.loads(checks.run(*words, "--html", "large-world.html"))
    started = time.monotonic()
    browser.open("/", "")
    checks.opened(browser, "large-world.html")
    print(f"a World of 10,000 bodies: {(checks.folder / 'large-world.html').stat().st_size / 1e6:.1f} MB, drawn in {time.monotonic() - started:.2f} s")
    for moment in [0, 3]:
        browser.value(GO.format(moment))
        seen = browser.value(SEEN)
        checks.expect(len(seen["places"]) == 10_000 and seen["gap"] < 1e-4, f"step {moment}: bodies in contact are drawn {seen['gap']} apart")
    checks.expect(seen["pairs"] == run["pairs"] > 0, f"pairs of the last step: {seen['pairs']}, {run['pairs']}")
    browser.value("toccata.stage.drawNow()")
    layers = browser.value("toccata.stage.overlays.children.length")
    calls = browser.value("toccata.stage.renderer.info.render.calls")
    flat, smooth, grid = 1, 1, 1
    checks.expect(calls <= flat + smooth + grid + layers, f"10,000 bodies and {layers} layers in {calls} drawing calls")
    checks.quiet(browser, "large world")
