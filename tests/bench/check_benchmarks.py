#!/usr/bin/env python3
"""Runs tiny benchmarks: their JSON has the documented shape, and every answer is the truth. Times are not judged.

usage: check_benchmarks.py TOCCATA_BENCH
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

BENCH = sys.argv[1]
RESULT = {
    "library": str, "variant": str, "task": str, "threads": int, "queries": int,
    "median_us": float, "mean_us": float, "p99_us": float, "build_ms": float, "bytes_per_triangle": float,
    "disagreements": int, "wrong": int,
}
CONVEX_RESULT = {
    "library": str, "variant": str, "task": str, "queries": int, "median_ns": float, "mean_ns": float, "p99_ns": float,
    "bytes_per_vertex": float, "disagreements": int, "wrong": int, "worst_error": float,
}
CONVEX_RATIO = {
    "library": str, "variant": str, "task": str, "median": float, "mean": float, "p99": float, "best": bool,
}
MOTION_RESULT = {
    "library": str, "variant": str,
    "task": str, "scene": str, "queries": int, "hits": int, "missed": int, "false_alarms": int, "median_ns": float,
    "mean_ns": float, "p99_ns": float, "worst_ns": float,
}
RATIO = {
    "library": str, "variant": str, "task": str, "threads": int, "median": float, "mean": float, "p99": float,
    "best": bool,
}
LIBRARY = {"library": str, "variant": str, "version": str, "flags": str}
NOT_MEASURED = {"library": str, "variant": str, "task": str, "threads": int, "reason": str}
PEER_VARIANTS = {
    "fcl": {"OBB", "OBBRSS", "RSS"},
    "cgal": {"AABB_tree, EPICK"},
    "embree": {"rtcCollide, B built per query", "rtcCollide, B fitted per query"},
    "ode": {"trimesh, OPCODE's AABB tree"},
    "bullet": {"GImpact of doubles, quantised AABB tree"},
}
CONVEX_PEERS = ["fcl", "bullet", "ode"]
CONVEX_TASKS = ["overlap", "distance", "penetration", "manifold"]
TRIANGLE_PEERS = ["fcl", "cgal"]
# Who cannot be asked: peers on several threads, and ODE for the triangles that meet.
ONE_THREAD = {"embree", "ode"}
ROUND_PAIR = ["--mesh-a", "gen:noise-sphere?subdivisions=2", "--mesh-b", "gen:torus?around=12&sides=6"]
HELICES = ["--mesh-a", "gen:helix?pitch=4.002", "--mesh-b", "gen:helix?pitch=4.002"]


def run(*words):
    return subprocess.run([BENCH, *words], capture_output=True, text=True)


def report(*words):
    done = run(*words, "--json")
    assert done.returncode == 0, f"{words} ended with {done.returncode}: {done.stderr}"
    return json.loads(done.stdout)


def check_shape(rows, fields):
    for row in rows:
        assert set(row) == set(fields), f"fields {sorted(row)}"
        for name, kind in fields.items():
            number = isinstance(row[name], (int, float)) and kind is float
            assert number or isinstance(row[name], kind), f"{name} is {row[name]!r}"


def check_best(ratios):
    """Of each peer and number of threads one variant is the best: none has a smaller mean."""
    for row in ratios:
        others = [r for r in ratios if (r["library"], r["threads"]) == (row["library"], row["threads"])]
        if row["library"] != "toccata":
            assert row["best"] == (row["mean"] == min(r["mean"] for r in others)), ratios


def check(expected_queries, *words):
    """The report of a benchmark in which all of Toccata's answers are right and every result has the right form."""
    made = report(*words)
    assert made["format"] == "toccata-bench-1" and made["machine"]["compiler"]
    check_shape(made["results"], RESULT)
    check_shape(made["ratios"], RATIO)
    check_shape(made["libraries"], LIBRARY)
    check_shape(made["not_measured"], NOT_MEASURED)
    assert len(made["ratios"]) == len(made["results"]) - 1
    assert made["results"][0]["library"] == "toccata"
    check_best(made["ratios"])
    for row in made["results"]:
        assert row["queries"] == expected_queries, row
        assert row["library"] != "toccata" or row["wrong"] == 0, row
        assert 0 < row["median_us"] <= row["p99_us"], row
    return made


def is_built_in(peer):
    done = run("mesh", *ROUND_PAIR, "--task", "build", "--peer", peer)
    if done.returncode == 0:
        return True
    assert done.returncode == 2 and "./toccata bench --with-peers" in done.stderr, done.stderr
    return False


def is_unasked(library, variant, task):
    if task == "distance":
        return library != "fcl" or variant == "OBB"
    return variant == "RSS" or (library == "ode" and task == "contacts")


MESH_RUNS = [(task, more, threads) for task in ("overlap", "contacts")
             for more, threads in ((["--near"], [1]), (["--threads", "1,2"], [1, 2]), (["--clock", "thread"], [1]))]
MESH_RUNS.append(("distance", ["--clock", "thread"], [1]))


def check_meshes(peers):
    variants = {(p, v) for p in peers for v in PEER_VARIANTS[p]}
    named = ["--peer", ",".join(peers)] if peers else []
    words = ["mesh", *ROUND_PAIR, "--random", "5", "--verify", "--rounds", "1", *named]
    for task, more, threads in MESH_RUNS:
        made = check(5, *words, "--task", task, *more)
        rows = {(r["library"], r["variant"], r["threads"]) for r in made["results"] if r["library"] != "toccata"}
        missing = {(r["library"], r["variant"], r["threads"]) for r in made["not_measured"]}
        assert rows | missing == {(*v, t) for v in variants for t in threads} and not rows & missing
        assert missing == {m for m in rows | missing
                           if (m[0] in ONE_THREAD and m[2] > 1) or is_unasked(m[0], m[1], task)}
        assert [r["threads"] for r in made["results"] if r["library"] == "toccata"] == threads
    made = check(3, "mesh", *ROUND_PAIR, "--task", "build", *named)
    assert {(r["library"], r["variant"]) for r in made["results"][1:]} == variants
    assert all(r["build_ms"] > 0 and r["bytes_per_triangle"] > 0 for r in made["results"])


def check_levels():
    """Every SIMD level that there is gives the same answers; another is an error that says so."""
    seen = set()
    for level in ("scalar", "sse4", "avx2", "avx512"):
        words = ["mesh", *ROUND_PAIR, "--random", "20", "--rounds", "1", "--simd", level]
        done = run(*words, "--json")
        if done.returncode == 0:
            made = json.loads(done.stdout)
            assert made["results"][0]["variant"] == level
            seen.add(made["question"]["touching"])
        else:
            assert done.returncode == 2 and level in done.stderr, done.stderr
    assert len(seen) == 1


def check_files(folder):
    """Poses of a file, given and moved: helices 0.001 apart, and 0.001 into each other. A pose that is not rigid."""
    poses, answers = folder / "poses.txt", folder / "answers.txt"
    poses.write_text("# apart, meeting\n1 0 0 0 1 0 0 0 1 0 0 2.001\n" + "1 0 0 0 1 0 0 0 1 0,0,0 " + "1 0 0 0 1 0 0 0 1 0 0 1.9\n")
    words = ["mesh", *HELICES, "--poses", str(poses), "--answers", str(answers), "--rounds", "1"]
    check(2, *words)
    assert answers.read_text() == "0 0\n1 1\n"
    check(4, *words, "--random", "4", "--verify")
    assert answers.read_text() == "0 0\n1 1\n2 0\n3 1\n"
    poses.write_text("2 0 0 0 1 0 0 0 1 0 0 2.001\n")
    check(1, *words)
    poses.write_text("\n1 0 0 0 1\n")
    done = run(*words)
    assert done.returncode == 2 and "poses.txt:2" in done.stderr, done.stderr


def check_triangles(peers):
    named = [word for peer in peers if peer in TRIANGLE_PEERS for word in ("--peer", peer)]
    for family in ("random", "shared", "coplanar", "ulp"):
        check(200, "triangle", "--count", "200", "--verify", "--family", family, *named)


def check_convex(peers):
    """Every pair, task and regime, each once; every answer of Toccata is compared with rational arithmetic."""
    named = ["--peer", ",".join(p for p in peers if p in CONVEX_PEERS)] if set(peers) & set(CONVEX_PEERS) else []
    pairs = ["hull", "box", "sphere", "sphere-box", "sphere-triangle", "sphere-capsule", "capsule", "capsule-box"]
    for i, pair in enumerate(pairs):
        for j, task in enumerate(CONVEX_TASKS):
            regime = ["far", "near", "deep", "coherent"][(i + j) % 4]
            words = ["convex", "--pair", pair, "--task", task, "--regime", regime, "--count", "30", "--rounds", "1"]
            if (pair, task) == ("sphere-triangle", "penetration"):
                assert run(*words).returncode == 2
                continue
            check_convex_report(report(*words, "--vertices", "12", "--verify", *named), pair)
    for pair, regime in (("cylinder-box", "deep"), ("cone-box", "coherent"), ("ellipsoid", "deep")):
        words = ["convex", "--pair", pair, "--task", "manifold", "--regime", regime, "--count", "30", "--rounds", "1"]
        made = report(*words, "--verify", *named)
        check_convex_report(made, pair)
        if "bullet" in peers and pair != "ellipsoid":
            rows = [row for row in made["results"] if row["library"] == "bullet"]
            assert len(rows) == 1 and rows[0]["wrong"] == 0 and rows[0]["worst_error"] < 1e-4, rows


def check_convex_report(made, pair):
    assert made["format"] == "toccata-bench-1" and made["benchmark"] == "convex"
    for row in made["results"]:
        row["worst_error"] = row["worst_error"] or 0.0  # null: not a number
    check_shape(made["results"], CONVEX_RESULT)
    check_shape(made["ratios"], CONVEX_RATIO)
    check_shape(made["libraries"], LIBRARY)
    assert sum(row["best"] for row in made["ratios"]) == (1 if any(r["library"] != "toccata" for r in made["ratios"]) else 0)
    for row in made["results"]:
        assert row["queries"] == 30 and 0 < row["median_ns"] <= row["p99_ns"], row
        assert row["library"] != "toccata" or row["wrong"] == 0, row
        if row["library"] == "toccata" and pair == "hull":
            assert 0 < row["bytes_per_vertex"] <= 128 + 1000 / 12, row


def check_builders():
    """Every builder makes the same tree on any number of threads."""
    made = check(2, "build", "--mesh", "gen:torus?around=12&sides=6", "--threads", "1,2,3", "--rounds", "2")
    variants = {r["variant"] for r in made["results"]}
    assert len(variants) == 15 and len(made["results"]) == 45, variants
    gains = made["question"]["gains"]
    assert len(gains) == 45 and all(g["gain"] > 0 for g in gains), gains


def check_proximity():
    """Balls of any number of triangles are apart in every way; boxes that bounce swap more ends than those that float."""
    sizes = report("proximity", "--task", "size", "--rounds", "1")["results"]
    assert len(sizes) == 11 and not any(r["meet"] or r["wrong"] for r in sizes), sizes
    rows = {r["scene"]: r for r in report("broad", "--task", "swaps", "--count", "1000", "--frames", "3")["results"]}
    assert rows["bounce"]["swaps_per_box"] > rows["uniform"]["swaps_per_box"] > rows["static"]["swaps_per_box"], rows
    assert rows["pile"]["swaps_per_box"] > rows["uniform"]["swaps_per_box"], rows


def check_process():
    made = report("process", "--mesh", "gen:icosphere", "--objects", "20", "--repeat", "1")
    assert [r["task"] for r in made["results"]] == ["process"] * 2
    for name in ("median_seconds", "median_processor_seconds", "peak_megabytes"):
        assert all(r[name] > 0 for r in made["results"])


def check_world(peers):
    named = ["--peer", ",".join(p for p in peers if p in ("bullet", "fcl"))] if {"bullet", "fcl"} & set(peers) else []
    made = report("world", "--count", "400", "--contact", "0.3", "--frames", "3", *named)
    assert {r["library"] for r in made["results"]} == {"toccata"} | ({"bullet", "fcl"} & set(peers)), made["results"]
    for row in made["results"]:
        assert row["median_ms"] > 0 and row["contacts"] > 20, row
        assert row["library"] != "toccata" or row["missing"] == row["invented"] == 0, row


def check_robot(peers):
    made = report("robot", "--count", "60", "--rounds", "1", "--subdivisions", "1", *(["--peer", "fcl"] if "fcl" in peers else []))
    rows = made["results"]
    assert [row["task"] for row in rows[:4]] == ["configurations", "edges", "first contacts", "distances"], rows
    for row in rows:
        assert row["mean_us"] > 0 and row["per_second"] > 0 and row["ratio"] > 0 and row["count"] == 60, row
        assert 0 < row["found"] < 60 and (row["library"] != "toccata" or row["disagreements"] == 0), row


def check_parts(peers):
    made = report("parts", "--count", "300", "--rounds", "1", *(["--peer", "fcl"] if "fcl" in peers else []))
    assert [r["variant"] for r in made["results"]][:2] == ["check_all", "every pair"], made["results"]
    for row in made["results"]:
        assert row["median_ms"] > 0 and row["pairs"] > 5, row
        assert row["library"] != "toccata" or row["missing"] == row["invented"] == 0, row
    for name in ("broad", "world", "parts"):
        refused = run(name, "--count", "10", "--seed", "-1")
        assert refused.returncode == 2 and "whole number" in refused.stderr, refused.stderr


def check_world_queries(peers):
    """Every question, verified body by body; Bullet tells no nearest body and FCL meets no rays."""
    answering = {"ray": {"bullet"}, "nearest": {"fcl"}, "overlap": {"bullet", "fcl"}}
    for task, libraries in answering.items():
        asked = sorted({"bullet", "fcl"} & set(peers))
        named = ["--peer", ",".join(asked)] if asked else []
        made = report("world-queries", "--task", task, "--bodies", "200", "--count", "200", "--rounds", "1", "--verify", *named)
        assert {r["library"] for r in made["results"]} == {"toccata"} | (libraries & set(asked)), made["results"]
        for row in made["results"]:
            assert row["queries"] == 200 and row["median_us"] > 0, row
            assert row["library"] != "toccata" or row["wrong"] == 0, row
    check_moving_shapes("bullet" in peers)


def check_moving_shapes(with_bullet):
    """Shapes of any kind are moved at a mesh; Bullet has no ellipsoid, and rays have no shape."""
    at_mesh = ("--mesh", "gen:torus?around=12&sides=6", "--count", "20", "--rounds", "1", "--verify")
    for shape in ("hull", "cylinder", "cone", "ellipsoid"):
        named = ["--peer", "bullet"] if with_bullet and shape != "ellipsoid" else []
        made = report("world-queries", "--task", "cast", "--shape", shape, *at_mesh, *named)
        assert made["question"]["shape"] == shape and made["results"][0]["wrong"] == 0, made
    refused = run("world-queries", "--task", "ray", "--shape", "cone")
    assert refused.returncode == 2 and "--task cast" in refused.stderr, refused.stderr


def check_mover(peers):
    """Characters of Toccata never catch, overlap or pass through anything; a file may be the level; Bullet walks too."""
    named = ["--peer", "bullet"] if "bullet" in peers else []
    few = ("--triangles", "2000", "--walks", "2", "--steps", "40", "--rounds", "1")
    made = report("mover", *few, *named)
    levels = ["terrain", "crowd", "rooms", "seams"]
    libraries = ["toccata"] + (["bullet"] if named else [])
    assert [(r["level"], r["library"]) for r in made["results"]] == [(w, n) for w in levels for n in libraries], made["results"]
    for row in made["results"]:
        assert 0 < row["median_us"] <= row["p99_us"] <= row["worst_us"] and row["walked"] > 0, row
        assert row["library"] != "toccata" or row["catches"] == row["overlaps"] == row["tunnels"] == 0, row
    made = report("mover", "--mesh", "gen:height-field?cells-x=30&cells-y=30", "--scale", "3", *few)
    assert [r["level"] for r in made["results"]] == ["mesh"] and made["results"][0]["overlaps"] == 0, made["results"]
    refused = run("mover", "--level", "nowhere", *few)
    assert refused.returncode == 2 and "nowhere" in refused.stderr, refused.stderr


def check_casts(peers):
    """Every pair and regime, every answer of Toccata judged with 60 digits; who cannot be asked is told with the reason."""
    asked = [peer for peer in ("bullet", "fcl", "ode") if peer in peers]
    named = ["--peer", ",".join(asked)] if asked else []
    answering = {"ray-cylinder": {"bullet", "ode"}, "ray-cone": {"bullet"}, "ray-ellipsoid": set(),
                 "cylinder-box": {"bullet", "fcl"}, "cone-box": {"bullet", "fcl"}, "ellipsoid": {"fcl"}}
    for pair, libraries in answering.items():
        for regime, hits in (("hit", 20), ("graze", None), ("miss", 0)):
            made = check(20, "casts", "--pair", pair, "--regime", regime, "--count", "20", "--rounds", "1", "--verify", *named)
            assert {r["library"] for r in made["results"]} == {"toccata"} | (libraries & set(asked)), made["results"]
            assert {r["library"] for r in made["not_measured"]} == set(asked) - libraries, made["not_measured"]
            told = made["question"]["hits"]
            assert 0 < told < 20 if hits is None else told == hits, made["question"]


def check_cells():
    """Kept cells are those of a grid made anew, and moving little costs the cells that change only."""
    made = report("partitions", "--mesh", "gen:torus?around=12&sides=6", "--task", "cells", "--rounds", "2")
    assert made["wrong"] == 0 and all(row["wrong"] == 0 for row in made["tracks"] + made["walks"]), made
    assert all(row["changed"] < row["cells"] for row in made["tracks"] if row["step_cells"] < 0.2), made["tracks"]
    assert all(1 <= row["walked"] <= row["in_box"] for row in made["walks"]), made["walks"]


def check_points():
    """Three trees tell the same of where points lie, and a vertex is on the surface."""
    made = report("partitions", "--mesh", "gen:torus?around=12&sides=6", "--task", "points", "--queries", "50", "--rounds", "1")
    assert [tree["tree"] for tree in made["trees"]] == ["mesh's own", "BSP", "MSP"], made["trees"]
    assert all(tree["growth"] >= 1 and tree["depth"] >= 1 and tree["bytes"] > 0 for tree in made["trees"]), made["trees"]
    assert all(row["wrong"] == 0 for row in made["results"]), made["results"]
    assert [row["on_surface"] for row in made["results"] if row["points"] == "vertices"] == [50], made["results"]


def check_sums(peers):
    """Every way makes sums of as many vertices, and tells the same of every point."""
    named = ["--peer", "cgal"] if "cgal" in peers else []
    for task in ("sum", "point"):
        made = report("sums", "--task", task, "--vertices", "12", "--count", "40", "--rounds", "1", *named)
        assert {r["library"] for r in made["results"]} == {"toccata", *(["cgal"] if named else [])}, made["results"]
        for row in made["results"]:
            assert row["median_us"] > 0 and row["disagreements"] == 0, row


def check_motion():
    """None of the public questions is missed, and none is a false alarm."""
    if not os.environ.get("TOCCATA_DATA"):
        print("check_motion is skipped: TOCCATA_DATA is not set")
        return
    rows = report("motion", "--rounds", "1")["results"]
    check_shape(rows, MOTION_RESULT)
    assert {row["task"] for row in rows} == {"vertex-face", "edge-edge"}
    for row in rows:
        assert row["missed"] == 0 and row["false_alarms"] == 0, f"wrong answers: {row}"


def check_sweeps():
    made = report("motion", "--task", "bodies", "--count", "20", "--rounds", "1")
    assert [row["set"] for row in made["results"]] == [
        "translations", "rotations", "thin boxes", "thin walls", "rods", "spinning round"]
    for row in made["results"]:
        assert row["library"] == "toccata" and row["queries"] == 20 and 0 < row["hits"] <= 20, row
        assert row["missed"] == row["false_alarms"] == row["late"] == row["early"] == row["wrong"] == 0, row
        assert 0 < row["median_us"] <= row["p99_us"], row
    meshes = report("motion", "--task", "meshes", "--data", "", "--most", "1280", "--rounds", "1")
    for row in meshes["in_contact"]:
        assert row["overlaps"] and row["met_at_once"], row
    assert all(row["wrong"] == 0 for row in meshes["results"]) and meshes["results"], meshes


def check_swept_volumes():
    """No point that is passed is outside, and what the volume says can never meet no sweep meets."""
    made = report("motion", "--task", "volumes", "--data", "", "--rounds", "1")
    assert len(made["results"]) == 5, made["results"]
    for row in made["results"]:
        assert row["outside"] == row["contradictions"] == 0 and row["hits"] <= row["maybe"] < row["asked"], row
        assert row["make_us"] > 0 and row["parts"] >= 1 and row["excess"] >= 0, row
    assert run("motion", "--task", "bodies", "--peer", "ipctk").returncode == 2


def check_deforming():
    """One step of a cloth is told alike on any number of threads; the first of all impacts is the first."""
    made = report("deforming", "--most", "3200", "--threads", "1,2", "--rounds", "1")
    assert {(r["triangles"], r["threads"]) for r in made["results"]} == {(1058, 1), (3200, 1), (1058, 2), (3200, 2)}, made["results"]
    for row in made["results"]:
        assert row["same"] and row["impacts"] > 0 and row["step_ms"] > 0, row
    assert {row["threads"] for row in made["growth"]} == {1, 2}
    assert {(r["triangles"], r["separation"]) for r in made["passing"]} == {(1280, 0), (1280, 0.001)}, made["passing"]
    for row in made["passing"]:
        assert row["same"] and row["impacts"] > 0 and row["first_ms"] > 0 and row["free_step_ms"] > 0, row


def check_walker():
    """The generic walkers answer as loops written by hand, with at most a tenth more instructions."""
    made = report("walker", "--rounds", "1")
    assert {r["variant"] for r in made["results"]} == {"two trees", "a tree with itself", "one tree"}
    for row in made["results"]:
        assert row["same"] and row["items"] > 0 and row["volume_tests"] > 0, row
        if row["instruction_ratio"] is None:
            assert shutil.which("valgrind") is None, "instructions were not counted"
        else:
            assert row["instruction_ratio"] <= 1.1, row


def check_map(folder):
    """A map has every cell, Toccata's answers are right, what is kept is not measured again, and the picture has it all."""
    script = pathlib.Path(__file__).resolve().parents[2] / "apps/bench/measure_map.py"
    call = [sys.executable, script, BENCH, "--folder", folder, "--map", "casts", "--peers", "", "--count", "10"]
    first = subprocess.run([*call, "--minutes", "0"], capture_output=True, text=True)
    assert first.returncode == 0 and "cells 0," in first.stdout, first
    done = subprocess.run(call, capture_output=True, text=True)
    assert done.returncode == 0, done
    made = json.loads((folder / "casts.json").read_text())
    assert made["summary"] == {"cells": 18, "with_a_peer": 0, "slower_than_the_best_peer": 0, "below_half": 0, "wrong": 0, "failed": 0}, made["summary"]
    assert all(cell["median_us"] > 0 and cell["command"][0] == "casts" for cell in made["cells"]), made
    assert (folder / "casts.svg").read_text().count("<rect") == 18 + 1
    again = subprocess.run(call, capture_output=True, text=True)
    assert again.returncode == 0 and not again.stderr and json.loads((folder / "casts.json").read_text()) == made, again


def main():
    peers = [peer for peer in PEER_VARIANTS if is_built_in(peer)]
    print("peers:", ", ".join(peers) or "none")
    check_meshes(peers)
    check_levels()
    check_triangles(peers)
    check_convex(peers)
    check_process()
    check_proximity()
    check_builders()
    check_world(peers)
    check_parts(peers)
    check_robot(peers)
    check_world_queries(peers)
    check_mover(peers)
    check_casts(peers)
    check_cells()
    check_points()
    check_sums(peers)
    check_motion()
    check_sweeps()
    check_swept_volumes()
    check_deforming()
    check_walker()
    with tempfile.TemporaryDirectory() as folder:
        check_files(pathlib.Path(folder))
        check_map(pathlib.Path(folder))
    assert run("mesh", *ROUND_PAIR, "--peer", "nobody").returncode == 2
    none = run("nearest", "--mesh", "gen:torus", "--count", "0")
    assert none.returncode == 2 and "--count: 0 is too small: at least 1 is needed" in none.stderr, none.stderr


main()
