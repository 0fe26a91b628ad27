#!/usr/bin/env python3
"""Reads GLB files of the command with another program, Assimp, and compares what both say.

usage: check_glb.py TOCCATA     ends with 77 where Assimp is not installed (apt-get install assimp-utils)
"""
import json
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile

TOCCATA = str(pathlib.Path(sys.argv[1]).resolve())
CASES = {
    "gears": ["scenes/gears/scene.json", "--penetration", "--hierarchy", "obb"],
    "shelf": ["scenes/shelf/scene.json"],
    "knots": ["gen:torus-knot", "gen:torus", "--clearance", "all", "--hierarchy", "wide"],
}
# Reports that are kept and drawn; and how many nodes hold what was found.
REPORTS = {
    "ray": (["ray", "gen:torus", "--from", "1", "0", "9", "--to", "1", "0", "-9"], 1),
    "nearest": (["nearest", "gen:torus", "gen:box", "--point", "0.3", "0.2", "9", "--k", "2"], 2),
    "faces": (["faces", "gen:torus", "gen:box", "--box", "0", "0", "0", "1", "1", "1"], 2),
    "self": (["check", "bow.off", "gen:box", "--self"], 1),
    "poses": (["check", "gen:torus", "gen:box", "--poses", "poses.txt"], 2),
    "ways": (["distance", "gen:torus", "gen:box", "--poses", "poses.txt"], 2),
    "inspect": (["inspect", "bow.off", "gen:box"], 1),
    "hierarchy": (["inspect", "bow.off", "gen:box", "--hierarchy"], 6),
    "cost": (["cost", "gen:torus", "gen:box", "--quick", "--volumes", "obb"], 0),
    "distance": (["distance", "gen:torus", "gen:box", "--pose-b", *"1 0 0 0 1 0 0 0 1 9 0 0".split()], 1),
}
BOW = "OFF\n5 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 1\n1 1 -1\n3 0 1 2\n3 0 3 4\n"


def run(folder, *words):
    result = subprocess.run(words, cwd=folder, capture_output=True, text=True)
    assert result.returncode < 2, result.stderr
    return result.stdout


def check_reports(folder):
    (folder / "bow.off").write_text(BOW)
    (folder / "poses.txt").write_text("1 0 0 0 1 0 0 0 1 1 0 0\n0 -1 0 1 0 0 0 0 1 9 0 0\n")
    for name, (words, findings) in REPORTS.items():
        (folder / "report.json").write_text(run(folder, TOCCATA, *words, "--json"))
        run(folder, TOCCATA, "view", "report.json", "--glb", f"{name}.glb")
        expected = contents(folder / f"{name}.glb")
        text = run(folder, "assimp", "info", f"{name}.glb")
        found, _, _ = read_by_assimp(text)
        animations = int(re.search(r"^Animations:\s+(\d+)", text, re.M).group(1))
        assert animations == (name in ("poses", "ways")), f"{name}: {animations} animations"
        shares = name == "hierarchy"  # Assimp takes meshes that are equal for one, and so are those of trees that need no cure
        assert found["Nodes"] == expected["Nodes"] and (shares or found["Faces"] == expected["Faces"]), f"{name}: {found}, {expected}"
        data = (folder / f"{name}.glb").read_bytes()
        nodes = json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])["nodes"]
        told = [node for node in nodes if "extras" in node]
        assert len(told) == findings, f"{name}: {[node['name'] for node in told]}"


def contents(file):
    """Nodes, parts of meshes, materials and faces, as the file itself tells them."""
    data = file.read_bytes()
    size, = struct.unpack_from("<I", data, 12)
    top = json.loads(data[20:20 + size])
    parts = [part for mesh in top["meshes"] for part in mesh["primitives"]]
    corners = {0: 1, 1: 2, 4: 3}
    return {
        "Nodes": len(top["nodes"]),
        "Meshes": len(parts),
        "Materials": len(top["materials"]),
        "Faces": sum(top["accessors"][part["indices"]]["count"] // corners[part["mode"]] for part in parts),
    }


def read_by_assimp(text):
    keys = ["Nodes", "Meshes", "Materials", "Faces"]  # it joins some vertices and parts others
    found = {key: int(re.search(rf"^{key}:\s+(\d+)", text, re.M).group(1)) for key in keys}
    point = lambda name: [float(x) for x in re.search(rf"^{name} point\s+\(([^)]*)\)", text, re.M).group(1).split()]
    return found, point("Minimum"), point("Maximum")


def box(folder, file):
    """Around all that our own reader finds, in metres."""
    objects = json.loads(run(folder, TOCCATA, "inspect", file, "--json"))["objects"]
    boxes = [each["world_box"] for each in objects]
    return [min(b["lower"][i] for b in boxes) for i in range(3)], [max(b["upper"][i] for b in boxes) for i in range(3)]


def main():
    if shutil.which("assimp") is None:
        print("SKIPPED: Assimp is not installed, so no other program reads the GLB files (apt-get install assimp-utils)")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run(folder, TOCCATA, "demo", "--write", "scenes")
        for case, words in CASES.items():
            file = f"{case}.glb"
            # Assimp's box applies the poses of nested nodes in the wrong order: so the first node has none.
            run(folder, TOCCATA, "view", *words, "--up", "y", "--glb", file)
            found, lower, upper = read_by_assimp(run(folder, "assimp", "info", file))
            expected = contents(folder / file)
            # Assimp makes a mesh of lines of those triangles of a contact area that rounding has left as a line.
            assert found.pop("Meshes") >= expected.pop("Meshes"), f"{case}: parts of meshes are missing"
            assert found == expected, f"{case}: Assimp finds {found} instead of {expected}"
            own_lower, own_upper = box(folder, file)
            size = max(abs(x) for x in [*own_lower, *own_upper])
            for one, other in zip([*lower, *upper], [*own_lower, *own_upper]):
                assert abs(one - other) <= 2e-6 * size + 1e-6, f"{case}: Assimp's box is {lower}, {upper}, ours {own_lower}, {own_upper}"
            print(f"{case}: {found}")
        check_reports(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
