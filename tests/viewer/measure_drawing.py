#!/usr/bin/env python3
"""Measures how long pages of `view` take from their address to a picture of what is on them, and how many frames a second it has while it turns.

usage: measure_drawing.py TOCCATA [--page two|million|clashes] [--mesh MESH] [--size 1200x800] [--runs N] [--json]
                          [--evidence FILE]

Each run is a fresh Chromium without a window and without a graphics card. The clock starts when it is told the address
of the page, and stops when it has handed over the picture of all triangles; a page of very many shows fewer first. That
both objects are seen in it is then checked. Exits with 1 where they are not, 2 for trouble.
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent.parent / "apps/bench")]
from browser import Browser, find_chromium  # noqa: E402
from evidence import told_by, what_was_run, write_evidence  # noqa: E402
from pixels import is_blue, is_orange, share  # noqa: E402
from racks import Rack, write_meshes  # noqa: E402

MESH = "gen:uv-sphere?around=264&along=133"  # of 69,696 triangles, the bunny has 69,451
MILLION = "gen:uv-sphere?around=1000&along=501"
RACK = Rack(layers=24, pipes=21, around=12, along=80)  # 504 pipes, 10,143 clashes
# What is asked of a page of ten thousand clashes in five hundred parts.
MOST_UNTIL_FIRST, LEAST_FRAMES = 2, 30
DRAWN = "window.toccata && toccata.stage.drawn > 0"
WHOLE = "toccata.stage.isWhole"
# With each frame that the browser gives, as a hand turns it, for so many milliseconds.
TURNED = """new Promise((done) => {
  const { stage } = toccata, from = performance.now(), drawn = stage.drawn;
  const step = () => {
    const took = performance.now() - from;
    if (took > %d) return done((1000 * (stage.drawn - drawn)) / took);
    stage.orbit.turn(0.01, 0.002);
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
})"""
LEAST_SHARE = 0.005  # of the picture, for each of the two colours
LEAST_SHARE_OF_MANY = 0.002  # where parts have more colours than these


def processor_seconds(process):
    """What a process and all that it started have taken so far; those that ended are counted with their parents."""
    ticks, parents = {}, {}
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            fields = (folder / "stat").read_text().rsplit(")", 1)[1].split()
        except OSError:
            continue  # it ended meanwhile
        parents[int(folder.name)] = int(fields[1])
        ticks[int(folder.name)] = sum(map(int, fields[11:15]))

    def is_of_it(one):
        while one in parents and one != process:
            one = parents[one]
        return one == process

    return sum(count for one, count in ticks.items() if is_of_it(one)) / os.sysconf("SC_CLK_TCK")


def wait_for_rest(process):
    """Chromium loads hundreds of files of its own when it starts, which no page waits for in a browser that a person has open."""
    before = processor_seconds(process)
    for _ in range(100):
        time.sleep(0.25)
        now = processor_seconds(process)
        if now - before < 0.03:
            return
        before = now


def turned(browser, milliseconds):
    return browser.call("Runtime.evaluate", expression=TURNED % milliseconds, awaitPromise=True, returnByValue=True)["result"]["value"]


def opened_once(page, size):
    width, height = size
    with Browser(width, height) as browser:
        browser.resize(width, height)
        wait_for_rest(browser.process.pid)
        before, started = processor_seconds(browser.process.pid), time.monotonic()
        browser.call("Page.navigate", url=f"file://{page}#theme=light")
        while not browser.value(DRAWN):
            time.sleep(0.01)
        drawn, of_first = time.monotonic() - started, processor_seconds(browser.process.pid) - before
        while not browser.value(WHOLE):
            time.sleep(0.01)
        picture = browser.call("Page.captureScreenshot", format="png")["data"]
        wall = time.monotonic() - started
        processor = processor_seconds(browser.process.pid) - before
        turned(browser, 1500)  # until it is known what can be drawn while it moves
        frames = turned(browser, 3000)
        complaints = browser.complaints()
        rows = browser.rows_of(picture)
    if complaints:
        raise RuntimeError(f"{page.name}: {complaints}")
    if (len(rows[0]), len(rows)) != size:
        raise RuntimeError(f"{page.name}: the picture is of {len(rows[0])}x{len(rows)} points")
    return {"drawn_s": drawn, "first_processor_s": of_first, "picture_s": wall, "processor_s": processor, "frames_per_s": frames, "blue": share(rows, is_blue), "orange": share(rows, is_orange)}


def width_of(command, mesh):
    text = subprocess.run([command, "inspect", mesh, "--json"], check=True, capture_output=True, text=True).stdout
    box = json.loads(text)["objects"][0]["box"]
    return box["upper"][0] - box["lower"][0]


def write_page(command, name, first, second, shift, folder):
    """Of two meshes, the second moved along x."""
    page = folder / f"{name}.html"
    pose = f"1 0 0 0 1 0 0 0 1 {shift!r} 0 0".split()
    report = subprocess.run([command, "check", first, second, "--pose-b", *pose, "--faces", "--json", "--html", str(page)], capture_output=True, text=True)
    if report.returncode == 2:
        raise RuntimeError(report.stderr)
    found = json.loads(report.stdout)
    return page, {"triangles": sum(one["triangles"] for one in found["objects"]), "face_pairs": sum(len(pair["faces"]) for pair in found["pairs"]),
                  "megabytes": page.stat().st_size / 1e6}


def write_clashes(command, folder):
    """Of a rack of pipes, with all that is told of clashes."""
    rack, page = folder / "rack", folder / "clashes.html"
    rack.mkdir()
    write_meshes(rack, RACK)
    report = subprocess.run([command, "check", str(rack), "--penetration", "--volume", "--json", "--html", str(page)], capture_output=True, text=True)
    if report.returncode == 2:
        raise RuntimeError(report.stderr)
    found = json.loads(report.stdout)
    clashes = {(pair["a"], pair["b"]) for pair in found["pairs"]}
    if clashes != set(RACK.depths()):
        raise RuntimeError(f"the page has {len(clashes)} clashes, and not the {len(RACK.depths())} that there are")
    return page, {"parts": RACK.parts(), "clashes": len(clashes), "triangles": sum(one["triangles"] for one in found["objects"]), "face_pairs": sum(region["face_pairs"] for pair in found["pairs"] for region in pair["regions"]),
                  "megabytes": page.stat().st_size / 1e6}


def measured(command, name, meshes, shift, arguments, folder):
    page, what = write_page(command, name, *meshes, shift, folder) if meshes else write_clashes(command, folder)
    runs = [opened_once(page, arguments.size) for _ in range(arguments.runs)]
    median = {key: statistics.median(run[key] for run in runs) for key in ["drawn_s", "first_processor_s", "picture_s", "processor_s", "frames_per_s"]}
    shown = all(min(run["blue"], run["orange"]) >= (LEAST_SHARE if meshes else LEAST_SHARE_OF_MANY) for run in runs)
    asked = {f"first after at most {MOST_UNTIL_FIRST} s, {LEAST_FRAMES} frames a second or more": median["drawn_s"] <= MOST_UNTIL_FIRST and median["frames_per_s"] >= LEAST_FRAMES}
    return {"page": name, **what, **median, **({} if meshes else asked), "least_s": min(run["picture_s"] for run in runs), "most_s": max(run["picture_s"] for run in runs), "both_seen": shown}


def size_of(text):
    width, height = map(int, text.split("x"))
    if not (64 <= width <= 4096 and 64 <= height <= 4096):
        raise ValueError(text)
    return width, height


def arguments_of(words):
    parser = argparse.ArgumentParser(prog="toccata bench drawing", description="How long pages of view take to a picture of what is on them.")
    parser.add_argument("command", help=argparse.SUPPRESS)
    parser.add_argument("--page", choices=["two", "million", "clashes"], help="this one alone: the mesh twice, a mesh of a million triangles with a small one, or 504 pipes with 10,143 clashes")
    parser.add_argument("--mesh", default=MESH, help="a file or gen:NAME; the page shows it twice, the second one moved by a half of its width (%(default)s)")
    parser.add_argument("--size", type=size_of, default=(1200, 800), help="of the picture (1200x800)")
    parser.add_argument("--runs", type=int, default=5, help="of each page, whose median is told (%(default)s)")
    parser.add_argument("--json", action="store_true", help="write JSON")
    parser.add_argument("--evidence", type=pathlib.Path, metavar="FILE", help="write JSON there, with what was run and by which browser")
    arguments = parser.parse_args(words)
    if arguments.runs < 1:
        parser.error("--runs: at least 1 is needed")
    return arguments


def row_of(result):
    seen = "" if result["both_seen"] else "  NOT BOTH ARE SEEN"
    return (f"{result['page']:<10}{result['triangles']:>11,}{result['face_pairs']:>12,}{result['megabytes']:>8.2f}{result['drawn_s']:>10.2f}{result['first_processor_s']:>13.2f}"
            f"{result['picture_s']:>11.2f}{result['least_s']:>8.2f}{result['most_s']:>8.2f}{result['processor_s']:>13.2f}{result['frames_per_s']:>10.1f}{seen}")


def words_of(arguments):
    width, height = arguments.size
    return ["bench", "drawing", *(["--page", arguments.page] if arguments.page else []), "--size", f"{width}x{height}", "--runs", str(arguments.runs)]


def main():
    arguments = arguments_of(sys.argv[1:])
    if find_chromium() is None:
        print("bench drawing: no Chromium is installed (apt-get install chromium)", file=sys.stderr)
        return 2
    command = str(pathlib.Path(arguments.command).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        meshes = {"two": ((arguments.mesh, arguments.mesh), 0.5 * width_of(command, arguments.mesh)), "million": ((MILLION, "gen:torus"), 1.0), "clashes": (None, 0)}
        wanted = [arguments.page] if arguments.page else ["two", "million"]
        results = [measured(command, page, *meshes[page], arguments, folder) for page in wanted]
    report = {"schema": "toccata/bench/drawing/1", "mesh": arguments.mesh, "size": arguments.size, "runs": arguments.runs, "pages": results}
    if arguments.evidence:
        write_evidence(arguments.evidence, {**what_was_run(words_of(arguments), command), "browser": told_by(find_chromium(), "--version"), **report})
    if arguments.json:
        print(json.dumps(report, indent=1))
    else:
        print(f"{arguments.size[0]}x{arguments.size[1]}, median of {arguments.runs}, a fresh Chromium each, seconds")
        print(f"{'page':<10}{'triangles':>11}{'face pairs':>12}{'MB':>8}{'drawn':>10}{'of processor':>13}{'picture':>11}{'least':>8}{'most':>8}{'of processor':>13}{'frames/s':>10}")
        print("\n".join(map(row_of, results)))
    return 0 if all(result["both_seen"] for result in results) else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (RuntimeError, OSError, subprocess.CalledProcessError) as trouble:
        print(f"bench drawing: {trouble}", file=sys.stderr)
        sys.exit(2)
