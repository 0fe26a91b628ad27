#!/usr/bin/env python3
"""What toccata-check-ranks writes, on several ranks, is what the command writes on one process, to the byte: tables, lines
of values and JSON, of files of many kinds and units, by rules and against baselines, with the same warnings and exit codes;
and so does the command with --distributed, which runs it.

check_ranks.py MPIEXEC RANKS TOCCATA TOCCATA_CHECK_RANKS
"""
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import zipfile

MPIEXEC, RANKS, COMMAND, OVER_RANKS = sys.argv[1:]
# On two ranks all is compared; each start of ranks takes a second, so on other numbers of them the least that needs them all.
IS_WHOLE = RANKS == "2"
TROUBLE = []
FACES = ((1, 3, 2), (2, 3, 4), (5, 6, 7), (6, 8, 7), (1, 2, 5), (2, 6, 5), (3, 7, 4), (4, 7, 8), (1, 5, 3), (3, 5, 7),
         (2, 4, 6), (4, 8, 6))


def corners(lower, upper):
    return [((lower, upper)[i & 1][0], (lower, upper)[i >> 1 & 1][1], (lower, upper)[i >> 2][2]) for i in range(8)]


def lines(word, rows):
    return "".join(word + " ".join(map(str, row)) + "\n" for row in rows)


def write_obj(path, lower, upper):
    path.write_text(lines("v ", corners(lower, upper)) + lines("f ", FACES))


def write_off(path, lower, upper, faces):
    """The first so many faces: with less than 12 it is open."""
    rows = [(3, *(corner - 1 for corner in face)) for face in FACES[:faces]]
    path.write_text(f"OFF\n8 {faces} 0\n" + lines("", corners(lower, upper)) + lines("", rows))


def write_with_gap(path, lower, upper):
    """A box whose lowest side is a thousandth away."""
    points = corners(lower, upper) + [(x, y, z - 0.001) for x, y, z in corners(lower, upper)[:4]]
    rows = [(3, *(corner + (7 if i < 2 else -1) for corner in face)) for i, face in enumerate(FACES)]
    path.write_text("OFF\n12 12 0\n" + lines("", points) + lines("", rows))


def write_ply(path, lower, upper):
    head = "ply\nformat ascii 1.0\nelement vertex 8\n" + lines("property double ", "xyz") + "element face 12\nproperty list uchar int vertex_indices\nend_header\n"
    path.write_text(head + lines("", corners(lower, upper)) + lines("3 ", [[corner - 1 for corner in face] for face in FACES]))


def write_stl(path, lower, upper):
    points = corners(lower, upper)
    facets = ["facet normal 0 0 0\nouter loop\n" + lines("vertex ", [points[corner - 1] for corner in face]) + "endloop\nendfacet\n" for face in FACES]
    path.write_text("solid box\n" + "".join(facets) + "endsolid box\n")


def write_three_mf(path, lower, upper):
    vertices = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in corners(lower, upper))
    triangles = "".join(f'<triangle v1="{a - 1}" v2="{b - 1}" v3="{c - 1}"/>' for a, b, c in FACES)
    kind = "http://schemas.microsoft.com/3dmanufacturing/"
    with zipfile.ZipFile(path, "w") as file:
        file.writestr("_rels/.rels", f'<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/a.model" Id="a" Type="{kind}2013/01/3dmodel"/></Relationships>')
        file.writestr("3D/a.model", f'<model unit="millimeter" xmlns="{kind}core/2015/02"><resources><object id="1" name="box" type="model"><mesh><vertices>{vertices}</vertices>'
                                    f'<triangles>{triangles}</triangles></mesh></object></resources><build><item objectid="1"/></build></model>')


def write_scene(path):
    """Shapes of many kinds, two of one group, a surface, and a mesh without an end to its scale."""
    shapes = [{"name": "ball", "shape": {"type": "sphere", "radius": 0.75}, "pose": {"translation": [1, 1, 1]}},
              {"name": "rod", "shape": {"type": "capsule", "start": [-1, 0, 0], "end": [5, 0.1, 0.3], "radius": 0.1}, "group": "frame"},
              {"name": "ground", "shape": {"type": "half-space", "normal": [0.1, 0, 1], "point": [0, 0, -0.2]}, "group": "frame"},
              {"name": "box", "generate": "box", "parameters": {"half-x": 0.4, "half-y": 0.4, "half-z": 0.4}, "solid": "none",
               "pose": {"translation": [2, 2, 2], "rotation": {"axis": [1, 2, 3], "degrees": 30}}},
              {"name": "town", "generate": "box", "parameters": {"half-x": 4000, "half-y": 1, "half-z": 1}, "pose": {"translation": [0, 0, 30]}}]
    path.write_text(json.dumps({"format": "toccata-scene", "version": 1, "unit": "mm", "objects": shapes}))


def write_boxes(folder):
    numbers = random.Random(3)
    files = []
    for i in range(30):
        lower = [numbers.uniform(0, 4) for _ in range(3)]
        upper = [at + numbers.uniform(0.3, 1.5) for at in lower]
        files.append(folder / f"part{i}" / "box.obj")  # all of one name
        files[-1].parent.mkdir()
        write_obj(files[-1], lower, upper)
    return [str(file) for file in files]


def write_mixed(folder):
    """Files of many kinds, of units that differ, with open meshes, boxes that touch exactly, and one that is named twice."""
    write_obj(folder / "box.obj", (0, 0, 0), (1, 1, 1))
    write_with_gap(folder / "gap.off", (3, 0, 0), (4, 1, 1))
    write_off(folder / "open.off", (0.5, 0.5, 0.5), (2.5, 2.5, 2.5), 10)
    write_off(folder / "beside.off", (1, 0, 0), (2, 1, 1), 12)
    write_ply(folder / "box.ply", (0.1, 0.1, 0.1), (0.9, 0.9, 0.9))
    write_stl(folder / "far.stl", (4, 4, 4), (5, 5, 5))
    write_three_mf(folder / "printed.3mf", (0.25, -1, 0.25), (0.75, 3, 0.75))
    write_scene(folder / "scene.json")
    names = ["box.obj", "gap.off", "open.off", "scene.json", "beside.off", "box.ply", "far.stl", "printed.3mf", "box.obj"]
    return [str(folder / name) for name in names] + ["gen:torus?radius=2&tube-radius=0.25"]


def run(*words, text=""):
    return subprocess.run(words, capture_output=True, text=True, check=False, input=text)


def over_ranks(*words, text=""):
    return run(MPIEXEC, "-np", RANKS, OVER_RANKS, *words, text=text)


def check(is_right, what, *runs):
    if not is_right:
        TROUBLE.append("\n".join([what, *(f"exit code {one.returncode}\n{one.stdout[:4000]}\n{one.stderr}" for one in runs)]))


def compare(files, options, least_lines, code=1, forms=([], ["--json"])):
    """The text in each form; returns the JSON of the last."""
    for form in forms:
        words = [*files, *options, *form]
        one = run(COMMAND, "check", *words)
        many = over_ranks(*words) if form else run(MPIEXEC, "-np", RANKS, COMMAND, "check", "--distributed", *words)
        check(one.stdout == many.stdout and one.returncode == many.returncode == code, f"{options} {form}", one, many)
        check(one.stdout.count("\n") >= least_lines, f"{options} {form}: too little is told", one)
        check(all(many.stderr.count(line) == 1 for line in one.stderr.splitlines()), f"{options} {form}: warnings", one, many)
    return json.loads(one.stdout)


ALL_FORMS = [], ["--csv"], ["--json"]


def compare_rules(folder, files):
    """Rules of names, tolerances and clearances, against what was told before a part went on."""
    baseline, rules = folder / "before.json", folder / "rules.txt"
    before = run(COMMAND, "check", *files, "--json", "--penetration")
    baseline.write_text(before.stdout)
    for file in range(8):
        by = 9 if file < 3 else 0.25
        corner = [float(x) for x in pathlib.Path(files[file]).read_text().splitlines()[0].split()[1:]]
        write_obj(pathlib.Path(files[file]), [x + by for x in corner], [x + by + 1 for x in corner])
    rules.write_text("few = */part1*/*, */part2/*\nignore few, */part7*\ntolerance few, few = 0.2\nclearance *part3*, * = 0.4\nignore nobody\n")
    report = compare(files, ["--rules", str(rules), "--penetration", "--baseline", str(baseline)], 10)
    since = report["baseline"]
    check(report["left_out"] > 0 and report["warnings"] and since["moved"] > 0 and since["gone"], f"rules: {since}")
    report = compare(files, ["--rules", str(rules), "--volume", "--sort", "severity", "--group", "part", "--tolerance", "0.1"], 10)
    check({"within", "beyond"} <= {pair.get("tolerance") for pair in report["pairs"]} and report["groups"], "tolerances and groups")
    compare(files, ["--baseline", str(baseline), "--fail-on", "new"], 5)
    compare(files, ["--between", "*part4*,*part5*", "--clearance", "9", "--fail-on", "hard", "--group", "region", "--precision", "none", "--penetration"], 2, 0)


def check_mixed(folder):
    files = write_mixed(folder)
    if not IS_WHOLE:
        compare(files, ["--clearance", "0.3", "--clearance-of", "far,ball=9"], 20, forms=ALL_FORMS)
        return
    for solid in ([], ["--solid", "auto"], ["--solid", "none"]):
        compare(files, solid, 20)
    report = compare(files, ["--clearance", "0.3", "--clearance-of", "far,ball=9"], 20)
    check({"overlapping", "touching", "apart"} <= {pair["relation"] for pair in report["pairs"]}, f"relations in {report['pairs']}")
    warnings = " ".join(report["warnings"])
    check(all(words in warnings for words in ("are open", "closed by --close", "as large as", "states no unit")), f"warnings: {warnings}")
    compare(files, ["--penetration", "--volume", "--tolerance", "0.05", "--touching", "ignore"], 20, forms=ALL_FORMS)
    compare([file for file in files if not file.endswith((".json", ".3mf"))], ["--unit", "in", "--scale", "2", "--clearance", "1mm"], 9)
    compare([str(folder), "gen:box"], [], 9)  # the mesh files in it
    compare(write_units(folder), ["--clearance", "1cm"], 2)


def write_units(folder):
    """Boxes in inches and in millimetres, which become metres."""
    files = []
    for unit, half, at in (("in", 1, 0), ("mm", 20, 30), ("in", 1, 4)):
        files.append(str(folder / f"{unit}{at}.json"))
        box = {"name": unit, "generate": "box", "parameters": {"half-x": half, "half-y": half, "half-z": half}, "pose": {"translation": [at, 0, 0]}}
        pathlib.Path(files[-1]).write_text(json.dumps({"format": "toccata-scene", "version": 1, "unit": unit, "objects": [box]}))
    return files


def check_refusals(folder, files):
    broken = folder / "broken.obj"
    broken.write_text("v 0 0 zero\n")
    case = folder / "case.json"
    run(COMMAND, "check", *files[:2], "--penetration", "--save-case", str(case))
    of_units = write_units(folder)
    for words, told in (([*files, str(broken)], "broken.obj"), ([*of_units, files[0]], "say with --unit what its numbers are"), ([*files, "--clearance", "nan"], "--clearance"), ([*files, "--threads", "-3"], "--threads"),
                        ([*files, "--ignore", "*"], "nothing would be checked"), ([*files, "--baseline", str(broken)], "broken.obj"), ([*files, "--fail-on", "new"], "--baseline"), ([*files, "--precision", "0.2"], "--penetration"),
                        ([*files, "--faces"], "--faces is for one process"), ([*files, "--poses", "p.txt"], "two objects"), ([*files, "--patience", "0"], "--patience"), ([*files, "--solid", "by-winding"], "--solid"),
                        ([*files, "--clearance", "2mm"], "--clearance"), (files[:1], "a check needs two"), ([*files, "--unit", "inch"], "inch"),
                        ([*files, "--cache", "trees"], "--cache"), ([*files, "-", "--format", "obj"], "standard input"), ([*files, "--html", "page.html"], "--html is for one process"),
                        ([str(case)], "holds a question of its own"), ([*files, "--rules", "/dev/stdin"], "rank 1 has other rules"), (["--names", "/dev/stdin"], "rank 1: --names")):
        many = over_ranks(*words, text="ignore *part7*\n")
        check(many.returncode == 2 and many.stderr.count(told) == 1 and not many.stdout, f"{words[-2:]}", many)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "mixed").mkdir()
        files = write_boxes(folder)
        all_options = [], ["--clearance", "0.3"], ["--touching", "ignore", "--solid", "none"], ["--penetration", "--volume"]
        for options in all_options if IS_WHOLE else all_options[-1:]:
            compare(files, options, 10, forms=ALL_FORMS if options == all_options[0] else ([], ["--json"]))
        check_mixed(folder / "mixed")
        if IS_WHOLE:
            check_refusals(folder, files)
            compare_rules(folder, files)
    print("\n".join(TROUBLE) or f"{RANKS} ranks write the same bytes")
    return 1 if TROUBLE else 0


if __name__ == "__main__":
    sys.exit(main())
