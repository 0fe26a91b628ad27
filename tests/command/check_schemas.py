#!/usr/bin/env python3
"""The command's JSON, and the scenes that it writes, are as the schemas of docs/reference say.

usage: check_schemas.py TOCCATA
"""
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("jsonschema is not installed (apt-get install python3-jsonschema)")
    sys.exit(77)

COMMAND = str(pathlib.Path(sys.argv[1]).resolve())
REFERENCE = pathlib.Path(__file__).resolve().parents[2] / "docs/reference"
ROWS = "1 0 0 0 1 0 0 0 1 "


def validator(name):
    schema = json.loads((REFERENCE / name).read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


SHAPES = """{"format": "toccata-scene", "version": 1, "objects": [
  {"name": "crate", "shape": {"type": "box", "half_extents": [1, 1, 1]}},
  {"name": "ball", "shape": {"type": "sphere", "radius": 1, "centre": [1.5, 0, 0]}},
  {"name": "needle", "shape": {"type": "segment", "start": [0, 0, -9], "end": [0, 0, 9]}},
  {"name": "ground", "shape": {"type": "half-space", "normal": [0, 0, 1]}}]}"""

ROUND = """{"format": "toccata-scene", "version": 1, "objects": [
  {"name": "can", "shape": {"type": "cylinder", "radius": 1, "half_height": 1}},
  {"name": "hat", "shape": {"type": "cone", "radius": 1, "half_height": 0.5}, "pose": {"translation": [0, 0, 1.5]}},
  {"name": "egg", "shape": {"type": "ellipsoid", "half_axes": [1, 1, 2]}, "pose": {"translation": [3, 0, 0]}}]}"""


ZOO = """{"format": "toccata-scene", "version": 1, "objects": [
  {"name": "point", "shape": {"type": "point"}},
  {"name": "triangle", "shape": {"type": "triangle", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}},
  {"name": "capsule", "shape": {"type": "capsule", "start": [0, 0, 0], "end": [0, 0, 1], "radius": 0.1}},
  {"name": "hull", "shape": {"type": "convex-hull", "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}},
  {"name": "rounded", "shape": {"type": "rounded", "core": {"type": "box", "half_extents": [1, 1, 1]}, "radius": 0.5}},
  {"name": "field", "shape": {"type": "height-field", "columns": 2, "rows": 2, "spacing": [1, 1], "heights": [0, 1, 2, 3]}},
  {"name": "compound", "shape": {"type": "compound", "parts": [
     {"shape": {"type": "sphere", "radius": 1}}, {"shape": {"type": "box", "half_extents": [1, 1, 1]}}]}},
  {"name": "flat", "shape": {"type": "box", "half_extents": [1, 1, 1]}, "pose": [1,0,0, 0,1,0, 0,0,0, 0,0,0]}]}"""


def asked(folder, *words):
    """The JSON that the command writes."""
    result = subprocess.run([COMMAND, *words, "--json"], cwd=folder, capture_output=True, text=True)
    assert result.returncode in (0, 1), result.stderr
    return json.loads(result.stdout)


def distances(folder):
    """The JSON of every kind of distance."""
    (folder / "arm.json").write_text('{"format": "toccata-scene", "version": 1, "objects": ['
                                     '{"name": "arm", "shape": {"type": "capsule", "start": [0, 0, 0], "end": [0, 0, 1], "radius": 0.1}}]}')
    yield asked(folder, "distance", "shapes.json")
    yield asked(folder, "distance", "round.json", "gen:box")
    yield asked(folder, "distance", "arm.json", "arm.json", "--poses", "poses.txt")


def rays(folder):
    """What rays meet, of shapes and of meshes."""
    (folder / "rays.txt").write_text("0 0 9  0 0 -9\n9 9 9, 9 9 10\n")
    yield asked(folder, "ray", "shapes.json", "--rays", "rays.txt")
    yield asked(folder, "ray", "round.json", "--rays", "rays.txt")
    yield asked(folder, "ray", "scenes/a.obj", "--from", "0", "0", "9", "--to", "0", "0", "-9")


def sweeps(folder):
    """What is met on the way, of shapes and of meshes, through two poses and many."""
    (folder / "motion.txt").write_text("0 0 0 0\n3 translation=0,0,5\n4 translation=0,0,5 axis=0,0,1 degrees=90\n")
    yield asked(folder, "sweep", "round.json", "--to", "9 0 0")
    met = asked(folder, "sweep", "gen:icosphere", "gen:box", "--from", "0 0 9", "--to", "euler=xyz:0,90,0")
    assert met["meeting"] == 1, met
    yield met
    yield asked(folder, "sweep", "gen:box", "gen:torus", "--motion", "motion.txt", "--stop-before", "0.125")


def walks(folder):
    """To a place and by motions, on meshes and on shapes."""
    (folder / "steps.txt").write_text("0 0 -9\n1 0 0\n0 0 9\n")
    (folder / "ground.json").write_text('{"format": "toccata-scene", "version": 1, "objects": ['
                                        '{"name": "ground", "shape": {"type": "half-space", "normal": [0, 0, 1]}},'
                                        '{"name": "post", "shape": {"type": "cylinder", "radius": 0.5, "half_height": 3}, "pose": {"translation": [3, 0, 0]}}]}')
    hindered = asked(folder, "walk", "ground.json", "--from", "0", "0", "0", "--to", "6", "0", "0")
    assert hindered["end"] == "hindered", hindered
    yield hindered
    yield asked(folder, "walk", "ground.json", "--from", "0", "0", "1", "--motion", "steps.txt")
    yield asked(folder, "walk", "gen:box", "--from", "0", "0", "0.5", "--to", "9", "0", "0", "--radius", "0.2", "--fall", "0.1")


def faces(folder):
    """What lies in a box and in a ball, and in one where there is nothing."""
    yield asked(folder, "faces", "shapes.json", "scenes/a.obj", "--box", "-1", "-1", "-1", "1", "1", "1")
    yield asked(folder, "faces", "shapes.json", "--ball", "0", "0", "9", "0.5")
    yield asked(folder, "faces", "round.json", "--ball", "0", "0", "1", "0.5")
    yield asked(folder, "faces", "scenes/a.obj", "--ball", "90", "90", "90", "0")


def sums(folder):
    """A sum and a difference, of solids, of a segment and a ball, and of points."""
    (folder / "pair.json").write_text('{"format": "toccata-scene", "version": 1, "objects": ['
                                      '{"name": "needle", "shape": {"type": "segment", "start": [0, 0, -9], "end": [0, 0, 9]}},'
                                      '{"name": "ball", "shape": {"type": "sphere", "radius": 1}}]}')
    yield asked(folder, "minkowski", "gen:box", "gen:tetrahedron")
    yield asked(folder, "minkowski", "gen:torus", "gen:box", "--hull")
    yield asked(folder, "minkowski", "pair.json", "--difference", "--point", "0", "0", "9")


def costs(folder):
    """What volumes and hierarchies cost, in every task."""
    (folder / "poses.txt").write_text(f"{ROWS} 0.1 0 0\n{ROWS} 100 0 0 {ROWS} 0 0 0\n")
    for task in ["overlap", "contacts", "distance"]:
        yield asked(folder, "cost", "scenes/a.obj", "scenes/b.stl", "--poses", "poses.txt", "--quick", "--task", task)


def nearest_points(folder):
    """Points near surfaces, and too far from them."""
    (folder / "points.txt").write_text("0 0 9\n900 900 900\n")
    yield asked(folder, "nearest", "scenes/a.obj", "--points", "points.txt", "--k", "3", "--within", "100")
    yield asked(folder, "nearest", "scenes/a.obj", "bow.off", "--points", "points.txt", "--k", "3", "--signed")
    yield asked(folder, "nearest", "shapes.json", "scenes/a.obj", "--points", "points.txt", "--signed")
    yield asked(folder, "nearest", "round.json", "--points", "points.txt", "--signed")


def reports(folder):
    """The JSON of every kind of check, with and without what options add."""
    def check(*words):
        return asked(folder, "check", *words)

    (folder / "poses.txt").write_text(f"{ROWS} 0.1 0 0\n{ROWS} 100 0 0 {ROWS} 0 0 0\n")
    (folder / "bow.off").write_text("OFF\n5 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 1\n1 1 -1\n3 0 1 2\n3 0 3 4\n")
    yield check("scenes/shelf/scene.json", "--faces")
    yield check("scenes/a.obj", "scenes/b.stl", "--touching=ignore")
    yield check("scenes/a.obj", "scenes/b.stl", "--poses", "poses.txt")
    yield check("scenes/a.obj", "bow.off", "--poses", "poses.txt", "--faces")
    yield check("scenes/a.obj", "bow.off", "--self")
    yield check("bow.off", "bow.off", "--self", "--faces")
    (folder / "shapes.json").write_text(SHAPES)
    with_depths = check("shapes.json", "--penetration", "--faces")
    assert [p["penetration"] is None for p in with_depths["pairs"]] == [False, True, False, False, True], with_depths
    yield with_depths
    solids = check("scenes/a.obj", "scenes/b.stl", "--penetration")
    assert solids["pairs"] and all(p["penetration"] and p["regions"] for p in solids["pairs"]), solids
    yield solids
    yield check("shapes.json", "--clearance", "1cm", "--clearance-of", "ball,ground=3", "--faces")
    (folder / "rules.txt").write_text("balls = ball, b*l\nbetween balls, *\nignore needle\n")
    (folder / "old.json").write_text(json.dumps(check("shapes.json")))
    compared = check("shapes.json", "--rules", "rules.txt", "--baseline", "old.json", "--sort", "severity", "--clearance", "all")
    assert compared["left_out"] > 0 and compared["baseline"]["gone"] and compared["baseline"]["known"], compared
    yield compared
    (folder / "old.json").write_text(json.dumps(check("shapes.json", "--touching", "ignore", "--clearance", "all")))
    yield check("shapes.json", "--baseline", "old.json")
    yield check("round.json", "--penetration", "--faces")
    yield check("round.json", "--clearance", "all")
    yield check("shapes.json", "--clearance", "all")
    yield check("shapes.json", "--clearance", "0")
    (folder / "near.txt").write_text("tolerance ball, crate = 0.01\nclearance b*l, * = 3\n")
    moved = (folder / "shapes.json").read_text().replace('"half_extents": [1, 1, 1]', '"half_extents": [1, 1, 1.25]')
    (folder / "moved.json").write_text(moved)
    compared = check("moved.json", "--rules", "near.txt", "--baseline", "old.json")
    assert compared["baseline"]["moved"] > 0 and compared["asked"]["query"]["clearances"], compared
    yield compared
    yield check("shapes.json", "--clearance-of", "ball,ground=all", "--clearance-of", "crate,ball=2")
    (folder / "ball.json").write_text('{"format": "toccata-scene", "version": 1, "objects": ['
                                      '{"name": "ball", "shape": {"type": "sphere", "radius": 1}}]}')
    yield check("ball.json", "ball.json", "--poses", "poses.txt", "--penetration")
    on_the_way = check("gen:box", "gen:box", "--poses", "poses.txt", "--penetration")
    assert [len(q["regions"]) for q in on_the_way["queries"]] == [1, 0], on_the_way
    yield on_the_way


def inspections(folder):
    """What meshes and shapes are, with all volumes and partitions and without."""
    yield asked(folder, "inspect", "shapes.json", "scenes/a.obj", "bow.off", "scenes/shelf/scene.json")
    yield asked(folder, "inspect", "zoo.json")
    yield asked(folder, "inspect", "round.json")
    with_faults = asked(folder, "inspect", "bow.off", "--faults")
    assert with_faults["objects"][0]["faults"], with_faults
    yield with_faults
    with_volumes = asked(folder, "inspect", "gen:box", "--volumes")
    assert with_volumes["objects"][0]["volumes"], with_volumes
    yield with_volumes
    with_partitions = asked(folder, "inspect", "gen:box", "--partitions")
    assert len(with_partitions["objects"][0]["partitions"]) == 6, with_partitions
    yield with_partitions


def hierarchies(folder):
    """The tree of nodes of a scene file."""
    yield asked(folder, "inspect", "scenes/shelf/scene.json", "--hierarchy")
    yield asked(folder, "inspect", "shapes.json", "--hierarchy")
    yield asked(folder, "inspect", "round.json", "--hierarchy")


def crowds(folder):
    """Moving boxes, by the method chosen and by all."""
    chosen = asked(folder, "crowd", "--count", "50", "--frames", "2", "--scene", "static", "--seed", "18446744073709551615")
    assert [one["method"] for one in chosen["methods"]] == ["auto"] and chosen["methods"][0]["reason"], chosen
    yield chosen
    yield asked(folder, "crowd", "--count", "50", "--frames", "1", "--compare", "--threads", "0")
    for bounds in ["balls", "oriented"]:
        report = asked(folder, "crowd", "--count", "50", "--frames", "1", "--bounds", bounds)
        assert report["bounds"] == bounds and report["asked"]["query"]["bounds"] == bounds, report
        yield report


def worlds(folder):
    """Bodies that fly, by the method chosen and by one that is named."""
    yield asked(folder, "crowd", "--world", "--count", "50", "--frames", "2", "--seed", "18446744073709551615")
    named = asked(folder, "crowd", "--world", "--count", "1", "--frames", "1", "--method", "kd-tiles", "--threads", "0")
    assert (named["method"], named["used_method"], named["pairs"], named["threads"]) == ("kd-tiles", "kd-tiles", 0, 0), named
    yield named


def decompositions(folder):
    """Parts with corners and faces."""
    report = asked(folder, "decompose", "gen:gear", "--parts", "4")
    assert len(report["parts"]) == 4 and report["excess"] > 0, report
    yield report


def locations(folder):
    """Points in a solid, on it and outside, by each tree, and of the trees alone."""
    (folder / "places.txt").write_text("0 0 0\n0.5 0.5 0.5\n0 0.5 0.5\n0.1 0 0.5\n9 0 0\n")
    for by in ["mesh", "bsp", "msp"]:
        report = asked(folder, "locate", "gen:box", "--points", "places.txt", "--by", by)
        assert [p["side"] for p in report["points"]] == ["inside"] + 3 * ["boundary"] + ["outside"], report
        yield report
    for by in ["bsp", "msp"]:
        yield asked(folder, "locate", "gen:torus-knot", "--by", by)


def robots(folder):
    """An arm at rest, at configurations with edges and distances, and its pairs by samples."""
    (folder / "q.csv").write_text("0 0 0 0 0 0 0\n0 1.5 0 1.9 0 1 0\n0.1 0 0 0 0 0 0\n")
    yield asked(folder, "robot", "gen:arm")
    report = asked(folder, "robot", "gen:arm", "--scene", "gen:torus?radius=0.5", "--configurations", "q.csv", "--edges", "--distance")
    assert [c["meets"] for c in report["configurations"]] == [False, True, False] and len(report["edges"]) == 2, report
    yield report
    yield asked(folder, "robot", "gen:arm", "--find-allowed", "100")


def subdivisions(folder):
    """The mesh of a cage, and how far its limit is from another object and another limit."""
    (folder / "creases.txt").write_text("crease 0 2\ncorner 7 1.5\n")
    mesh = asked(folder, "subdivide", "scenes/a.obj", "--within", "0.3", "--levels", "1", "--crease-angle", "170")
    assert mesh["status"] == "exact" and mesh["triangles"], mesh["status"]
    yield mesh
    yield asked(folder, "subdivide", "gen:icosphere?subdivisions=0", "--scheme", "loop", "--triangles", "100", "--creases",
                "creases.txt")
    away = ["--pose-b", *"1 0 0 0 1 0 0 0 1 9 0 0".split()]
    for second in [[], ["--both"]]:
        apart = asked(folder, "subdivide", "gen:box", "gen:box", "--within", "0.01", *away, *second)
        assert apart["gap"]["lower"] > 0, apart
        yield apart


EVERY_REPORT = {
    "check": reports,
    "distance": distances,
    "cost": costs,
    "ray": rays,
    "sweep": sweeps,
    "walk": walks,
    "faces": faces,
    "nearest": nearest_points,
    "inspect": inspections,
    "hierarchy": hierarchies,
    "crowd": crowds,
    "crowd-world": worlds,
    "minkowski": sums,
    "decompose": decompositions,
    "subdivide": subdivisions,
}


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([COMMAND, "demo", "--write", "scenes"], cwd=folder, check=True, capture_output=True)
        (folder / "zoo.json").write_text(ZOO)
        (folder / "round.json").write_text(ROUND)
        for kind, made in EVERY_REPORT.items():
            schema = validator(f"{kind}-report.schema.json")
            for report in made(folder):
                schema.validate(report)
                check_asked(kind, report)
                assert not schema.is_valid({**report, "unknown": 1}), "the schema takes anything"
        for kind, made in {"locate": locations, "robot": robots}.items():
            schema = validator(f"{kind}-report.schema.json")
            for report in made(folder):
                schema.validate(report)
                assert not schema.is_valid({**report, "unknown": 1}), "the schema takes anything"
        scene = validator("scene.schema.json")
        scenes = list(folder.rglob("scene.json"))
        assert scenes
        for file in scenes:
            scene.validate(json.loads(file.read_text()))
        for text in [SHAPES, ZOO, ROUND]:
            scene.validate(json.loads(text))
        check_cases(scene)


def check_asked(kind, report):
    """A report of a question says what was asked."""
    validator("asked.schema.json").validate(report["asked"])
    scene = json.loads((REFERENCE / "scene.schema.json").read_text())
    jsonschema.Draft202012Validator({"$ref": "#/$defs/query", "$defs": scene["$defs"]}).validate(report["asked"]["query"])


def check_cases(scene):
    """The cases that are kept are scenes; their answers are reports."""
    files = sorted((REFERENCE.parents[1] / "tests/cases").rglob("*.json"))
    assert files
    for file in files:
        case = json.loads(file.read_text())
        scene.validate(case)
        assert not scene.is_valid({**case, "query": {**case["query"], "unknown": 1}}), file
        kind = case["query"]["question"].split("-")[0]
        if "error" not in case["answer"]:
            validator(f"{kind}-report.schema.json").validate(case["answer"])


main()
