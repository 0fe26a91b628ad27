#!/usr/bin/env python3
"""Measures `check` of an assembly: a rack of bent pipes, layer across layer, each of which is pressed a little into every
pipe of the layer below. How long all clashes take with their depths, regions and volumes, and when the first is told.

usage: measure_clashes.py TOCCATA [--layers 62] [--pipes 8] [--around 50] [--along 100] [--threads N] [--peer ifcclash]
                          [--folder FOLDER] [--json]

With --peer ifcclash the same parts are written as IFC, and IfcClash (PyPI: pip install ifcclash) looks for intersections;
it has to be installed for the Python that runs this. Processor seconds are those of all threads together, user and system.
Exits with 1 where Toccata does not tell the clashes that there are by construction, 2 for trouble.
"""
import argparse
import json
import math
import pathlib
import random
import resource
import struct
import subprocess
import sys
import tempfile
import time

RADIUS = 0.3
SPACING = 0.54  # of layers: what is nominally 0.06 deep, and by how the pipes are bent from 0.01 to 0.11


def pipe_points(layer, number, sizes, chance):
    """Vertices ring by ring and then the middle of each end; layers lie across each other in turns."""
    bend, wave, height = chance.uniform(0, 7), chance.uniform(0, 7), layer * SPACING
    for j in range(sizes.along + 1):
        t = j / sizes.along
        x, y = (t - 0.5) * sizes.pipes, number - (sizes.pipes - 1) / 2 + 0.02 * math.sin(9 * t + bend)
        z = height + 0.02 * math.sin(7 * t + wave)
        for i in range(sizes.around):
            angle = 2 * math.pi * (i + 0.5 * (j % 2)) / sizes.around
            radius = RADIUS * (1 + 0.01 * math.sin(5 * angle + 40 * t))
            yield x, y + radius * math.cos(angle), z + radius * math.sin(angle)
    for end in (-0.5, 0.5):
        t = end + 0.5
        yield end * sizes.pipes, number - (sizes.pipes - 1) / 2 + 0.02 * math.sin(9 * t + bend), height + 0.02 * math.sin(7 * t + wave)


def pipe_vertices(layer, number, sizes, chance):
    points = list(pipe_points(layer, number, sizes, chance))
    return points if layer % 2 == 0 else [(-y, x, z) for x, y, z in points]


def pipe_triangles(sizes):
    around, along = sizes.around, sizes.along
    first, last = around * (along + 1), around * (along + 1) + 1
    for j in range(along):
        for i in range(around):
            a, b = j * around + i, j * around + (i + 1) % around
            c, d = a + around, b + around
            yield from ((a, b, c), (b, d, c)) if j % 2 == 0 else ((a, d, c), (a, b, d))
    for i in range(around):
        yield first, (i + 1) % around, i
        yield last, along * around + i, along * around + (i + 1) % around


def all_pipes(sizes):
    chance = random.Random(1)
    for layer in range(sizes.layers):
        for number in range(sizes.pipes):
            yield f"pipe-{layer:02}-{number}", pipe_vertices(layer, number, sizes, chance)


def clashes_there_are(sizes):
    return {(f"pipe-{layer:02}-{i}", f"pipe-{layer + 1:02}-{k}") for layer in range(sizes.layers - 1) for i in range(sizes.pipes) for k in range(sizes.pipes)}


def write_meshes(folder, sizes):
    """Binary PLY files of doubles."""
    triangles = list(pipe_triangles(sizes))
    faces = b"".join(struct.pack("<B3i", 3, *triangle) for triangle in triangles)
    for name, points in all_pipes(sizes):
        header = ("ply\nformat binary_little_endian 1.0\n" f"element vertex {len(points)}\n" + "".join(f"property double {axis}\n" for axis in "xyz")
                  + f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n")
        numbers = struct.pack(f"<{3 * len(points)}d", *(x for point in points for x in point))
        (folder / f"{name}.ply").write_bytes(header.encode() + numbers + faces)


def guid(number):
    """A GlobalId of IFC: 22 digits to the base of 64."""
    digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$"
    text = ""
    for _ in range(22):
        number, digit = divmod(number, 64)
        text = digits[digit] + text
    return text


IFC_HEAD = """ISO-10303-21;
HEADER;FILE_DESCRIPTION((''),'2;1');FILE_NAME('','',(''),(''),'','','');FILE_SCHEMA(('IFC4'));ENDSEC;
DATA;
#1=IFCCARTESIANPOINT((0.,0.,0.));
#2=IFCAXIS2PLACEMENT3D(#1,$,$);
#3=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-9,#2,$);
#4=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);
#5=IFCUNITASSIGNMENT((#4));
#6=IFCPROJECT('%s',$,'rack',$,$,$,$,(#3),#5);
#7=IFCLOCALPLACEMENT($,#2);
"""


def write_ifc(file, sizes):
    faces = ",".join("(%d,%d,%d)" % tuple(corner + 1 for corner in triangle) for triangle in pipe_triangles(sizes))
    with open(file, "w", encoding="ascii") as ifc:
        ifc.write(IFC_HEAD % guid(1))
        for number, (name, points) in enumerate(all_pipes(sizes)):
            line = 10 + 5 * number
            corners = ",".join("(%r,%r,%r)" % tuple(x + 0.0 for x in point) for point in points)
            ifc.write(f"#{line}=IFCCARTESIANPOINTLIST3D(({corners}));\n#{line + 1}=IFCTRIANGULATEDFACESET(#{line},$,.T.,({faces}),$);\n"
                      f"#{line + 2}=IFCSHAPEREPRESENTATION(#3,'Body','Tessellation',(#{line + 1}));\n#{line + 3}=IFCPRODUCTDEFINITIONSHAPE($,$,(#{line + 2}));\n"
                      f"#{line + 4}=IFCBUILDINGELEMENTPROXY('{guid(number + 2)}',$,'{name}',$,$,#7,#{line + 3},$,$);\n")
        ifc.write("ENDSEC;\nEND-ISO-10303-21;\n")


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def measured_check(command, folder, threads):
    words = [command, "check", str(folder), "--penetration", "--volume", "--stream", *(["--threads", str(threads)] if threads else [])]
    before, started, first, pairs, depths = processor_seconds(), time.monotonic(), None, set(), []
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
        for line in process.stdout:
            told = json.loads(line)
            if "relation" not in told:
                continue
            first = first if first is not None else time.monotonic() - started
            pairs.add((told["a"], told["b"]))
            depths.append((told["penetration"]["lower"], told["penetration"]["upper"], told["volume"]["upper"], len(told["regions"])))
    if process.returncode not in (0, 1):
        raise RuntimeError(f"check ended with {process.returncode}")
    return {"library": "toccata", "seconds": time.monotonic() - started, "first_result_s": first, "processor_s": processor_seconds() - before,
            "pairs": pairs, "regions": sum(row[3] for row in depths), "widest": max((row[1] / row[0] for row in depths if row[0] > 0), default=None)}


def ifc_clash(file):
    """In a process of its own: what IfcClash finds in the file."""
    import logging

    from ifcclash import ifcclash

    settings = ifcclash.ClashSettings()
    settings.logger = logging.getLogger("ifcclash")
    clasher = ifcclash.Clasher(settings)
    clasher.clash_sets = [{"name": "rack", "a": [{"file": file}], "mode": "intersection", "tolerance": 0.0, "check_all": False}]
    clasher.clash()
    clashes = clasher.clash_sets[0]["clashes"].values()
    print(json.dumps(sorted({tuple(sorted((clash["a_name"], clash["b_name"]))) for clash in clashes})))


def measured_ifc_clash(file):
    before, started = processor_seconds(), time.monotonic()
    run = subprocess.run([sys.executable, __file__, "--ifc-clash", str(file)], capture_output=True, text=True)
    if run.returncode != 0:
        raise RuntimeError("IfcClash: " + (run.stderr.strip().splitlines() or ["it says nothing"])[-1])
    return {"library": "ifcclash", "seconds": time.monotonic() - started, "first_result_s": None, "processor_s": processor_seconds() - before,
            "pairs": {tuple(pair) for pair in json.loads(run.stdout.splitlines()[-1])}}


def told(row, expected, first):
    row = dict(row, missing=len(expected - row["pairs"]), invented=len(row["pairs"] - expected), ratio=row["processor_s"] / first["processor_s"])
    return dict(row, pairs=len(row["pairs"]))


def parsed():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("command", help="the program toccata")
    for name, standard in (("layers", 62), ("pipes", 8), ("around", 50), ("along", 100), ("threads", 0)):
        parser.add_argument(f"--{name}", type=int, default=standard)
    parser.add_argument("--peer", choices=["ifcclash"])
    parser.add_argument("--folder", type=pathlib.Path)
    parser.add_argument("--json", action="store_true")
    arguments = parser.parse_args()
    if arguments.layers < 2 or arguments.pipes < 1 or arguments.around < 8 or arguments.along < 8:
        parser.error("a rack has 2 layers or more, and a pipe 8 sides and rings or more")
    return arguments


def main():
    if sys.argv[1:2] == ["--ifc-clash"]:
        return ifc_clash(sys.argv[2])
    sizes = parsed()
    with tempfile.TemporaryDirectory() as temporary:
        folder = sizes.folder or pathlib.Path(temporary)
        meshes = folder / "rack"
        meshes.mkdir(parents=True, exist_ok=True)
        write_meshes(meshes, sizes)
        rows = [measured_check(sizes.command, meshes, sizes.threads)]
        if sizes.peer:
            write_ifc(folder / "rack.ifc", sizes)
            rows.append(measured_ifc_clash(folder / "rack.ifc"))
    expected = clashes_there_are(sizes)
    rows = [told(row, expected, rows[0]) for row in rows]
    scene = {"parts": sizes.layers * sizes.pipes, "triangles": sizes.layers * sizes.pipes * 2 * sizes.around * (sizes.along + 1), "clashes": len(expected)}
    if sizes.json:
        print(json.dumps({"benchmark": "clashes", **scene, "results": rows}, indent=1))
    else:
        print("{parts} parts, {triangles:,} triangles, {clashes:,} clashes".format(**scene))
        for row in rows:
            first = f"{row['first_result_s']:.2f}" if row["first_result_s"] is not None else "-"
            print(f"  {row['library']:<9} {row['seconds']:8.2f} s, first result after {first} s, processor {row['processor_s']:.2f} s ({row['ratio']:.2f}); "
                  f"{row['pairs']:,} pairs, {row['missing']} missing, {row['invented']} invented")
    return 1 if rows[0]["missing"] + rows[0]["invented"] > 0 else 0


if __name__ == "__main__":
    sys.exit(main())
