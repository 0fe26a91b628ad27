#!/usr/bin/env python3
"""3MF files are read as they say, to the nearest double, and broken and hostile ones are refused by name.

usage: check_three_mf.py TOCCATA
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import zipfile

COMMAND = str(pathlib.Path(sys.argv[1]).resolve())
CORE = 'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06"'
RELATIONS = """<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/main.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>"""
FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def mesh(size="1"):
    """A box from the origin to (size, size, size)."""
    corners = [tuple(size if i >> axis & 1 else "0" for axis in range(3)) for i in range(8)]
    vertices = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in corners)
    triangles = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/><triangle v1="{a}" v2="{c}" v3="{d}"/>' for a, b, c, d in FACES)
    return f"<mesh><vertices>{vertices}</vertices><triangles>{triangles}</triangles></mesh>"


def model(resources, build, unit="millimeter"):
    return f'<?xml version="1.0"?><model unit="{unit}" {CORE}><resources>{resources}</resources><build>{build}</build></model>'


# An arm of two bolts, one of them turned by a quarter about z and moved; and the arm once more.
BOLT = f'<object id="1" name="bolt" type="model">{mesh()}</object>'
ARM = """<object id="2" name="arm"><components><component objectid="1"/>
<component objectid="1" transform="0 1 0 -1 0 0 0 0 1 0.5 0.25 0"/></components></object>"""
BUILD = '<item objectid="2"/><item objectid="2" transform="1 0 0 0 1 0 0 0 1 100 0 0"/>'


def write(folder, name, parts, **options):
    with zipfile.ZipFile(folder / name, "w", zipfile.ZIP_DEFLATED) as file:
        for part, text in parts.items():
            file.writestr(part, text)
    return name


def package(text):
    return {"_rels/.rels": RELATIONS, "3D/main.model": text}


def run(folder, *words):
    return subprocess.run([COMMAND, *words], cwd=folder, capture_output=True, text=True)


def refused(folder, name, *said):
    result = run(folder, "check", name)
    assert result.returncode == 2 and result.stdout == "", (name, result)
    assert result.stderr.startswith(f"toccata: error: {name}: "), result.stderr
    for words in said:
        assert words in result.stderr, (name, words, result.stderr)


def check_reading(folder):
    write(folder, "arm.3mf", package(model(BOLT + ARM, BUILD)))
    result = run(folder, "check", "arm.3mf", "--json")
    report = json.loads(result.stdout)
    assert result.returncode == 1 and report["unit"] == "mm", report
    assert [one["name"] for one in report["objects"]] == ["bolt", "bolt #2", "bolt #3", "bolt #4"]
    assert report["objects"][1]["pose"] == [0, -1, 0, 1, 0, 0, 0, 0, 1, 0.5, 0.25, 0]
    assert report["objects"][2]["pose"][9:] == [100, 0, 0] and report["objects"][0]["solid"]
    assert [(pair["a_index"], pair["b_index"], pair["relation"]) for pair in report["pairs"]] == [(0, 1, "overlapping"), (2, 3, "overlapping")]
    # The unit of the file is that of lengths, and the scale multiplies all.
    assert json.loads(run(folder, "check", "arm.3mf", "--scale", "2", "--json").stdout)["objects"][2]["pose"][9:] == [200, 0, 0]
    assert "states its unit itself" in run(folder, "check", "arm.3mf", "--unit", "m").stderr
    # --unit is of what stands beside it and states none; the world is in metres then.
    (folder / "plate.obj").write_text("v 0 0 0\nv 100 0 0\nv 0 100 0\nf 1 2 3\n")
    beside = json.loads(run(folder, "check", "plate.obj", "arm.3mf", "--unit", "cm", "--json").stdout)
    assert beside["unit"] == "m" and [one["pose"][0] for one in beside["objects"][:2]] == [0.01, 0.001], beside["objects"]
    # Standard input, too.
    piped = subprocess.run([COMMAND, "check", "-", "--format", "3mf"], cwd=folder, input=(folder / "arm.3mf").read_bytes(), capture_output=True)
    assert piped.returncode == 1 and piped.stdout.decode() == run(folder, "check", "arm.3mf").stdout, piped
    broken = subprocess.run([COMMAND, "check", "-", "--format", "3mf"], cwd=folder, input=b"solid", capture_output=True)
    assert broken.returncode == 2 and broken.stderr.startswith(b"toccata: error: standard input: "), broken


def check_doubles(folder):
    """More digits than a float has: 0.1 is the double nearest to it."""
    write(folder, "fine.3mf", package(model(f'<object id="7">{mesh("+0.1")}</object>', '<item objectid="7"/>', "inch")))
    result = json.loads(run(folder, "inspect", "fine.3mf", "--json").stdout)
    assert result["objects"][0]["health"]["box"]["upper"] == [0.1, 0.1, 0.1] if "health" in result["objects"][0] else True
    assert "0.1" in run(folder, "inspect", "fine.3mf", "--json").stdout and "0.10000000149" not in run(folder, "inspect", "fine.3mf", "--json").stdout
    assert result["unit"] == "in", result["unit"]


def check_other_parts(folder):
    """Objects of another part of the package (the production extension), and supports, which are left out."""
    parts = package(model(f'<object id="3" type="support">{mesh()}</object><object id="2"><components><component objectid="1" p:path="/3D/other.model"/></components></object>',
                          '<item objectid="2"/><item objectid="3"/><item objectid="1" p:path="/3D/other.model"/>'))
    write(folder, "parts.3mf", {**parts, "3D/other.model": model(BOLT, "")})
    result = run(folder, "check", "parts.3mf")
    assert result.returncode == 1 and "bolt  equals  bolt #2" in result.stdout, result
    assert "1 support left out" in result.stderr, result.stderr


def check_broken(folder):
    whole = (folder / "arm.3mf").read_bytes()
    (folder / "short.3mf").write_bytes(whole[: len(whole) // 2])
    refused(folder, "short.3mf", "cannot be unpacked")
    (folder / "empty.3mf").write_bytes(b"")
    refused(folder, "empty.3mf")
    (folder / "text.3mf").write_text("solid")
    refused(folder, "text.3mf")
    refused(folder, "gone.3mf", "no such file")
    refused(folder, write(folder, "no-model.3mf", {"readme.txt": "nothing"}), "no 3MF file")
    for name, text, said in [
        ("no-xml", "<model", "is no XML"),
        ("no-build", model(BOLT, ""), "its build has no mesh"),
        ("no-object", model(BOLT, '<item objectid="9"/>'), "there is no object 9"),
        ("itself", model('<object id="5"><components><component objectid="6"/></components></object><object id="6"><components><component objectid="5"/></components></object>',
                         '<item objectid="5"/>'), "contains itself"),
        ("corner", model(BOLT.replace('v1="0"', 'v1="8"', 1), '<item objectid="1"/>'), "a triangle at vertex '8'"),
        ("number", model(BOLT.replace('x="0"', 'x="nan"', 1), '<item objectid="1"/>'), "'nan' where a number has to be"),
        ("transform", model(BOLT, '<item objectid="1" transform="1 0 0"/>'), "a transform of 3 numbers"),
        ("unit", model(BOLT, '<item objectid="1"/>', "parsec"), "the unit 'parsec' is not known"),
        ("no-triangles", model('<object id="1"><mesh><vertices/><triangles/></mesh></object>', '<item objectid="1"/>'), "without triangles"),
    ]:
        refused(folder, write(folder, f"{name}.3mf", package(text)), said)


def check_hostile(folder):
    refused(folder, write(folder, "outside.3mf", {**package(model(BOLT, '<item objectid="1"/>')), "../../evil": "x"}), "'../../evil' leads out of the file")
    refused(folder, write(folder, "bomb.3mf", package(" " * 200_000_000)), "to fill the memory")
    # Each holds the one before ten times: a thousand million bolts.
    levels = "".join(f'<object id="{i + 1}"><components>{f"<component objectid={chr(34)}{i}{chr(34)}/>" * 10}</components></object>' for i in range(1, 10))
    refused(folder, write(folder, "many.3mf", package(model(BOLT + levels, '<item objectid="10"/>'))), "nested so often")


def main():
    with tempfile.TemporaryDirectory() as name:
        for check in (check_reading, check_doubles, check_other_parts, check_broken, check_hostile):
            check(pathlib.Path(name))


if __name__ == "__main__":
    main()
