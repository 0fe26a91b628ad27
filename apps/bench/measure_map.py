#!/usr/bin/env python3
"""Measures how fast Toccata is beside its peers, not at a point but over maps, and draws them.

usage: measure_map.py TOCCATA-BENCH [--folder DIR] [--map NAME]… [--peers NAMES] [--minutes M] [--count N] [--again]

A map is a table of cells; a cell is one call of a benchmark, which asks Toccata and the peers the same in one run and
compares the answers. What has been measured is kept in DIR/NAME.json after each cell, and not measured again by the same
call of the same version unless --again is given, so that a run may be stopped and goes on. DIR/NAME.svg is the picture.
Exits with 1 where an answer of Toccata is wrong, 2 for trouble, and where a cell has no answer. The machine has to do
nothing else meanwhile.
"""
import argparse
import html
import json
import pathlib
import subprocess
import sys
import time

RATIOS = [1000, 300, 100, 30, 10, 3, 1, 1 / 3, 0.1, 1 / 30, 0.01, 1 / 300, 0.001]
GAPS = [0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, -1e-6, -1e-4, -1e-3, -1e-2, -0.1, -0.3]
MESHES = {"knot": "gen:torus-knot", "rough": "gen:noise-sphere?subdivisions=5"}
BALLS = {20 * 4**n: f"gen:noise-sphere?subdivisions={n}" for n in range(2, 8)}
CONVEX_PAIRS = ["box", "sphere", "sphere-box", "sphere-capsule", "capsule", "capsule-box", "cylinder-box", "cone-box", "ellipsoid"]
HULLS = [8, 32, 128]


def ratio_name(ratio):
    return f"1/{round(1 / ratio)}" if ratio < 1 else f"{ratio:g}"


def cell(row, column, *command, ours=None):
    """`ours`: how the variant of Toccata's begins that is meant, where it has several."""
    return {"row": row, "column": column, "command": [str(word) for word in command], "ours": ours}


def mesh_cell(row, column, task, a, b, *more):
    return cell(row, column, "mesh", "--mesh-a", a, "--mesh-b", b, "--task", task, "--clock", "thread", *more)


def of_mesh_sizes():
    for task in ("overlap", "contacts", "distance"):
        for ratio in RATIOS:
            yield mesh_cell(task, ratio_name(ratio), task, MESHES["knot"], MESHES["rough"], "--size-b", ratio)


def of_mesh_depths():
    for task in ("overlap", "contacts", "distance"):
        for size in (1, 1 / 30):
            for gap in GAPS:
                if task == "distance" and gap < 0:
                    continue
                yield mesh_cell(f"{task}, {ratio_name(size)}", f"{gap:g}", task, MESHES["knot"], MESHES["rough"],
                                "--size-b", size, "--gap", gap)


def of_mesh_triangles():
    for task in ("overlap", "contacts", "distance"):
        for triangles, mesh in BALLS.items():
            yield mesh_cell(task, f"{triangles:,}", task, mesh, mesh)


def of_convex():
    named = [(pair, []) for pair in CONVEX_PAIRS] + [(f"hull {n}", ["--vertices", n]) for n in HULLS]
    for task in ("overlap", "distance", "penetration", "manifold"):
        for name, vertices in named:
            call = ["convex", "--pair", name.split()[0], *vertices, "--task", task, "--regime"]
            yield cell(f"{task}: {name}", "far", *call, "far")
            for gap in GAPS[1:-1]:
                yield cell(f"{task}: {name}", f"{gap:g}", *call, "near", "--gap", gap)
            yield cell(f"{task}: {name}", "deep", *call, "deep")
            yield cell(f"{task}: {name}", "coherent", *call, "coherent")


def of_casts():
    for pair in ("ray-cylinder", "ray-cone", "ray-ellipsoid", "cylinder-box", "cone-box", "ellipsoid"):
        for regime in ("hit", "graze", "miss"):
            yield cell(pair, regime, "casts", "--pair", pair, "--regime", regime)


def of_places():
    for triangles, mesh in BALLS.items():
        column = f"{triangles:,}"
        yield cell("rays, in arrays", column, "rays", "--mesh", mesh, ours="arrays")
        yield cell("one ray", column, "rays", "--mesh", mesh, ours="one ray")
        for where in ("near", "far"):
            yield cell(f"nearest point, {where}", column, "nearest", "--mesh", mesh, "--where", where)


# For each map: what it shows, its cells, the peers that can answer, and the option that says how many questions.
MAPS = {
    "mesh-sizes": ("Two meshes, B's size as a part of A's", of_mesh_sizes, "fcl,bullet,ode,embree", "--random", 200),
    "mesh-depths": ("Two meshes, the gap as a part of the smaller one (negative: so deep)", of_mesh_depths, "fcl,bullet,ode,embree", "--random", 200),
    "mesh-triangles": ("Two meshes of equal size, triangles of each", of_mesh_triangles, "fcl,bullet,ode,embree", "--random", 200),
    "convex": ("Two convex shapes, the gap as a part of the smaller one (negative: so deep)", of_convex, "fcl,bullet,ode", "--count", 1000),
    "casts": ("What moves on a straight way, at what", of_casts, "fcl,bullet,ode", "--count", 1000),
    "places": ("One mesh, its triangles", of_places, "embree", "--count", 20000),
}
PEERS_OF_NEAREST = "embree,cgal"
# Seconds after which a call is taken not to end: building millions of triangles takes long, a thousand questions about convex shapes do not.
LONGEST = {"mesh": 900, "convex": 15, "casts": 15, "rays": 900, "nearest": 900}


def median_us(row):
    return row["median_us"] if "median_us" in row else row["median_ns"] / 1000


def p99_us(row):
    return row["p99_us"] if "p99_us" in row else row["p99_ns"] / 1000


def whole_command(one, peers, count_option, count):
    command = one["command"] + [count_option, str(count), "--rounds", "3"]
    if peers:
        wanted = PEERS_OF_NEAREST if command[0] == "nearest" and "embree" in peers else peers
        command += ["--peer", wanted]
    return command


def ended(bench, command):
    """What the call answered; None where it did not end in time."""
    try:
        return subprocess.run([bench, *command, "--json"], capture_output=True, text=True, timeout=LONGEST[command[0]])
    except subprocess.TimeoutExpired:
        return None


def asked(bench, command):
    """What the call answered, and the peers it was asked without, as they do not end for all questions."""
    made = ended(bench, command)
    if made is not None or "--peer" not in command:
        return made, []
    alone, peers = command[:command.index("--peer")], command[-1].split(",")
    ending = [peer for peer in peers if ended(bench, [*alone, "--peer", peer]) is not None]
    return ended(bench, [*alone, *(["--peer", ",".join(ending)] if ending else [])]), [peer for peer in peers if peer not in ending]


def own_result(results, one):
    """Of Toccata's: what a single call costs with all that it needs, as the peers' calls do."""
    own = [r for r in results if r["library"] == "toccata" and r["variant"].startswith(one["ours"] or "")]
    whole = [r for r in own if not r["variant"].startswith("arrays") and not r["variant"].endswith("posed before")]
    return min(whole if not one["ours"] and whole else own, key=median_us)


def measured(bench, one, command):
    """The cell with what it took; `failed` where there is no answer."""
    made, without = asked(bench, command)
    filled = {"row": one["row"], "column": one["column"], "command": command}
    if without:
        filled["does_not_end"] = without
    if made is None or made.returncode == 2 or not made.stdout:
        return {**filled, "failed": (made.stderr.strip() if made else "") or "no answer"}
    report = json.loads(made.stdout)
    own = own_result(report["results"], one)
    others = [r for r in report["results"] if r["library"] != "toccata"]
    filled |= {"version": report["version"], "variant": own["variant"], "median_us": median_us(own), "p99_us": p99_us(own), "wrong": own["wrong"],
               "peers": [{"library": r["library"], "variant": r["variant"], "median_us": median_us(r), "wrong": r["wrong"]} for r in others]}
    if others:
        best = min(filled["peers"], key=lambda r: r["median_us"])
        filled |= {"best": f"{best['library']} {best['variant']}", "ratio": best["median_us"] / filled["median_us"]}
    return filled


def colour(one):
    """Red below the best peer, white as fast, green where faster; grey without a peer."""
    ratio = one.get("ratio")
    if ratio is None:
        return "#e8e8e8"
    for least, shade in ((10, "#3f9b57"), (4, "#74bd83"), (2, "#a9d9b0"), (1, "#dff1e1"), (0.5, "#f6c6b8"), (0, "#e5735c")):
        if ratio >= least:
            return shade
    return "#e5735c"


def short_time(us):
    return f"{1000 * us:.3g} ns" if us < 1 else f"{us:.3g} µs" if us < 1000 else f"{us / 1000:.3g} ms"


def labels(one):
    if "failed" in one:
        return "–", ""
    return short_time(one["median_us"]), f"{one['ratio']:.2g}×" if "ratio" in one else ""


def drawn(title, cells):
    """An SVG: a row and a column of the map each, the median of Toccata's times and how many times as long the best peer takes."""
    rows = list(dict.fromkeys(one["row"] for one in cells))
    columns = list(dict.fromkeys(one["column"] for one in cells))
    left, top, width, height = 8 + 7 * max(map(len, rows)), 46, 70, 32
    size = left + width * len(columns) + 8, top + height * len(rows) + 30
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{size[0]}" height="{size[1]}" font-family="sans-serif" font-size="11">',
             f'<rect width="{size[0]}" height="{size[1]}" fill="white"/>', f'<text x="8" y="18" font-size="14">{html.escape(title)}</text>']
    for i, column in enumerate(columns):
        parts.append(f'<text x="{left + (i + 0.5) * width}" y="38" text-anchor="middle">{html.escape(column)}</text>')
    for i, row in enumerate(rows):
        parts.append(f'<text x="8" y="{top + (i + 0.6) * height}">{html.escape(row)}</text>')
    for one in cells:
        x, y = left + columns.index(one["column"]) * width, top + rows.index(one["row"]) * height
        time_text, ratio_text = labels(one)
        parts.append(f'<rect x="{x}" y="{y}" width="{width - 2}" height="{height - 2}" fill="{colour(one)}"/>'
                     f'<text x="{x + width / 2 - 1}" y="{y + 13}" text-anchor="middle">{time_text}</text>'
                     f'<text x="{x + width / 2 - 1}" y="{y + 26}" text-anchor="middle" font-weight="bold">{ratio_text}</text>')
    parts.append(f'<text x="8" y="{size[1] - 10}">the median of Toccata, and below how many times as long the best peer takes; red: a peer is faster</text></svg>')
    return "\n".join(parts) + "\n"


def summary(cells):
    ratios = [one["ratio"] for one in cells if "ratio" in one]
    slower = sum(r < 1 for r in ratios)
    return {"cells": len(cells), "with_a_peer": len(ratios), "slower_than_the_best_peer": slower, "below_half": sum(r < 0.5 for r in ratios),
            "wrong": sum(one.get("wrong", 0) for one in cells), "failed": sum("failed" in one for one in cells)}


def write_map(folder, name, cells):
    title = MAPS[name][0]
    told = {"format": "toccata-map-1", "name": name, "title": title, "summary": summary(cells), "cells": cells}
    (folder / f"{name}.json").write_text(json.dumps(told, indent=1, ensure_ascii=False) + "\n")
    if cells:
        (folder / f"{name}.svg").write_text(drawn(title, cells))


def measure(name, options, until):
    _, cells_of, peers, count_option, count = MAPS[name]
    if options.peers is not None:
        peers = ",".join(one for one in peers.split(",") if one in options.peers.split(","))
    file, version, known = options.folder / f"{name}.json", version_of(options.bench), {}
    if file.exists() and not options.again:
        known = {(one["row"], *one["command"]): one for one in json.loads(file.read_text())["cells"] if one.get("version") == version}
    cells = []
    for one in cells_of():
        command = whole_command(one, peers, count_option, options.count or count)
        kept = known.get((one["row"], *command))
        if kept is None and time.monotonic() < until:
            kept = measured(options.bench, one, command)
            print(f"{name}: {kept['row']}, {kept['column']}: {' '.join(labels(kept))}", file=sys.stderr)
        if kept is not None:
            cells.append(kept)
            write_map(options.folder, name, cells)
    write_map(options.folder, name, cells)
    return summary(cells)


def version_of(bench):
    report = subprocess.run([bench, "triangle", "--count", "1", "--rounds", "1", "--json"], capture_output=True, text=True, check=True)
    return json.loads(report.stdout)["version"]


def main():
    parser = argparse.ArgumentParser(prog="./toccata bench map", description="Measures Toccata beside its peers over maps, and draws them.")
    parser.add_argument("bench", help=argparse.SUPPRESS)
    parser.add_argument("--folder", type=pathlib.Path, required=True, help="where maps are kept")
    parser.add_argument("--map", choices=list(MAPS), action="append", help="only this one; may be given several times")
    parser.add_argument("--peers", help="only these of the peers, by commas; empty: none")
    parser.add_argument("--minutes", type=float, default=1e9, help="begin no cell after so many")
    parser.add_argument("--count", type=int, help="questions of each cell")
    parser.add_argument("--again", action="store_true", help="measure also what has been measured")
    options = parser.parse_args()
    if options.count is not None and options.count < 1:
        parser.error("--count: at least 1 is needed")
    every_peer = {peer for one in MAPS.values() for peer in one[2].split(",")}
    for peer in filter(None, (options.peers or "").split(",")):
        if peer not in every_peer:
            parser.error(f"--peers: there is no {peer}; known are {', '.join(sorted(every_peer))}")
    options.folder.mkdir(parents=True, exist_ok=True)
    until = time.monotonic() + 60 * options.minutes
    wrong = failed = 0
    for name in options.map or MAPS:
        found = measure(name, options, until)
        wrong, failed = wrong + found["wrong"], failed + found["failed"]
        print(f"{name}: " + ", ".join(f"{key.replace('_', ' ')} {value}" for key, value in found.items()))
    return 1 if wrong else 2 if failed else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (OSError, ValueError, KeyError, subprocess.CalledProcessError) as error:
        print(f"bench map: {type(error).__name__}: {error}", file=sys.stderr)
        sys.exit(2)
