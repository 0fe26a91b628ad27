#!/usr/bin/env python3
"""STEP and IFC files, and those of Assimp's formats, are read as what they hold by the programs that `./toccata formats` adds,
and what is broken is told.

usage: check_formats.py FOLDER

FOLDER holds toccata, and toccata-read-step, toccata-read-ifc and toccata-read-assimp where they are added. What is not there is
told, and skipped: exit status 77 where nothing is. The STEP file is made by toccata_write_step (apps/formats), the others are
Debian's (assimp-testmodels) or written here.
"""
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import zipfile

FOLDER = pathlib.Path(sys.argv[1]).resolve()
COMMAND = FOLDER / "toccata"
MODELS = pathlib.Path("/usr/share/assimp/models")
IFC_MODEL = MODELS / "IFC/AC14-FZK-Haus.ifc"


def run(folder, *words, **options):
    return subprocess.run([COMMAND, *words], cwd=folder, capture_output=True, text=True, timeout=600, **options)


def report(folder, *words):
    result = run(folder, *words, "--json")
    assert result.returncode in (0, 1), result
    return json.loads(result.stdout)


def refused(folder, name, said=""):
    result = run(folder, "check", name)
    assert result.returncode == 2 and result.stdout == "", (name, result)
    assert result.stderr.startswith(f"toccata: error: {name}: ") and said in result.stderr, (name, result.stderr)


def check_missing(folder):
    """Without the programs the one line is told that adds them."""
    (folder / "a.step").write_text("ISO-10303-21;")
    bare = folder / "bare"
    bare.mkdir()
    (bare / "toccata").write_bytes(COMMAND.read_bytes())
    (bare / "toccata").chmod(0o755)
    environment = {**os.environ, "TOCCATA_CALLED_AS": "./toccata", "PATH": "/usr/bin:/bin"}
    for name, words in (("a.step", "`./toccata formats step`"), ("a.ifc", "`./toccata formats ifc`"), ("a.fbx", "`./toccata formats assimp`")):
        result = subprocess.run([bare / "toccata", "check", name], cwd=folder, env=environment, capture_output=True, text=True)
        assert result.returncode == 2 and words in result.stderr, result


def check_step(folder):
    writer = FOLDER.parent / "formats/toccata_write_step"
    subprocess.run([writer, folder / "machine.step"], check=True, capture_output=True)
    machine = report(folder, "check", "machine.step")
    piped = subprocess.run([COMMAND, "check", "-", "--format", "step", "--json"], cwd=folder, input=(folder / "machine.step").read_bytes(), capture_output=True)
    from_pipe = json.loads(piped.stdout)
    assert from_pipe["pairs"] == machine["pairs"] and {one["source"] for one in from_pipe["objects"]} == {"standard input"}, from_pipe
    assert machine["unit"] == "mm"
    assert [one["name"] for one in machine["objects"]] == [f"{arm}/{part}" for arm in ("front", "back") for part in ("plate", "left pin", "right pin")]
    assert all(one["closed"] and one["solid"] for one in machine["objects"]), "meshes of neighbouring faces do not meet"
    assert machine["objects"][0]["faces"] == 6 and machine["objects"][1]["faces"] == 3, "faces are those of the file"
    pairs = {(pair["a"], pair["b"]): pair["relation"] for pair in machine["pairs"]}
    assert pairs == {("front/plate", "front/left pin"): "overlapping", ("back/plate", "back/left pin"): "overlapping"}, pairs
    assert machine["objects"][5]["pose"][11] == 530, machine["objects"][5]
    assert any("within 0.1 mm" in warning and "6 parts of 2 shapes" in warning for warning in machine["warnings"]), machine["warnings"]
    # A cylinder of radius 5 and height 40: between the volume of what is 0.01 smaller and the whole.
    fine = report(folder, "inspect", "machine.step", "--tessellation", "0.01mm")["objects"][1]
    assert 3.14159 * 4.99**2 * 40 < fine["signed_volume"] <= 3.14160 * 25 * 40, fine["signed_volume"]
    assert fine["triangles"] > report(folder, "inspect", "machine.step", "--tessellation", "1mm")["objects"][1]["triangles"]
    assert "no length above 0" in run(folder, "check", "machine.step", "--tessellation", "much").stderr
    subprocess.run([writer, folder / "inch.step", "INCH"], check=True, capture_output=True)
    inch = report(folder, "check", "inch.step")  # the same numbers in inches
    assert inch["unit"] == "mm" and abs(inch["objects"][5]["pose"][11] - 25.4 * 530) < 1e-9, inch["objects"][5]["pose"]
    assert any("its unit is the INCH" in warning for warning in inch["warnings"]), inch["warnings"]


def check_broken_step(folder):
    whole = (folder / "machine.step").read_bytes()
    for size in (0, 1, 100, len(whole) // 2, len(whole) - 20):
        (folder / "short.step").write_bytes(whole[:size])
        refused(folder, "short.step")
    refused(folder, "gone.step", "no such file")
    (folder / "text.stp").write_text("solid")
    refused(folder, "text.stp", "no whole STEP file")
    # Whatever a byte says instead, the command answers or names the file; Open CASCADE itself breaks down over a third of these.
    random.seed(1)
    answered = 0
    for _ in range(12):
        bytes_of = bytearray(whole)
        for _ in range(random.choice([1, 5, 30])):
            bytes_of[random.randrange(len(bytes_of))] = random.choice(b"0123456789#(),*$ABC")
        (folder / "bad.step").write_bytes(bytes_of)
        result = run(folder, "check", "bad.step")
        answered += result.returncode in (0, 1)
        assert result.returncode in (0, 1) or "toccata: error: bad.step" in result.stderr, result
    assert answered > 0


def ifc_guid(number):
    return f"{number:022d}"


class IfcText:
    """An IFC file in the making: entities of boxes, 1000 mm along each edge, in places."""

    def __init__(self):
        self.lines = []
        unit = self.add("IFCUNITASSIGNMENT((#%d))" % self.add("IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.)"))
        self.axes = self.axes_at(0, 0, 0)
        self.context = self.add(f"IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#{self.axes},$)")
        self.project = self.add(f"IFCPROJECT('{self.guid()}',$,'Project',$,$,$,$,(#{self.context}),#{unit})")

    def add(self, entity):
        self.lines.append(f"#{len(self.lines) + 1}={entity};")
        return len(self.lines)

    def guid(self):
        return ifc_guid(len(self.lines) + 1)

    def axes_at(self, x, y, z):
        return self.add("IFCAXIS2PLACEMENT3D(#%d,$,$)" % self.add(f"IFCCARTESIANPOINT(({x:.1f},{y:.1f},{z:.1f}))"))

    def place(self, kind, name, parent, more):
        placement = self.add(f"IFCLOCALPLACEMENT($,#{self.axes})")
        place = self.add(f"{kind}('{self.guid()}',$,{name},$,$,#{placement},$,{more})")
        self.add(f"IFCRELAGGREGATES('{self.guid()}',$,$,$,#{parent},(#{place}))")
        return place

    def box(self, kind, name, x):
        """Gives the element and its GlobalId."""
        corner = self.add("IFCAXIS2PLACEMENT2D(#%d,$)" % self.add("IFCCARTESIANPOINT((0.,0.))"))
        profile = self.add(f"IFCRECTANGLEPROFILEDEF(.AREA.,$,#{corner},1000.,1000.)")
        solid = self.add(f"IFCEXTRUDEDAREASOLID(#{profile},#{self.axes},#%d,1000.)" % self.add("IFCDIRECTION((0.,0.,1.))"))
        shape = self.add("IFCPRODUCTDEFINITIONSHAPE($,$,(#%d))" % self.add(f"IFCSHAPEREPRESENTATION(#{self.context},'Body','SweptSolid',(#{solid}))"))
        placement = self.add(f"IFCLOCALPLACEMENT($,#{self.axes_at(x, 0, 0)})")
        guid = self.guid()
        return self.add(f"{kind}('{guid}',$,'{name}',$,$,#{placement},#{shape},$,$)"), guid

    def contain(self, element, place):
        self.add(f"IFCRELCONTAINEDINSPATIALSTRUCTURE('{self.guid()}',$,$,$,(#{element}),#{place})")

    def text(self):
        return "\n".join(["ISO-10303-21;", "HEADER;", "FILE_DESCRIPTION((''),'2;1');", "FILE_NAME('','',(''),(''),'','','');",
                          "FILE_SCHEMA(('IFC4'));", "ENDSEC;", "DATA;", *self.lines, "ENDSEC;", "END-ISO-10303-21;", ""])


def ifc_of_two_storeys():
    """Its text, and the names that its elements are to have: on storeys, in a room, a part of an assembly, and nowhere."""
    ifc = IfcText()
    site = ifc.place("IFCSITE", "'Site'", ifc.project, "$,$,$,$,$,$,$")
    house = ifc.place("IFCBUILDING", "'House'", site, "$,$,$,$,$")
    first, second = (ifc.place("IFCBUILDINGSTOREY", f"'Level {i}'", house, "$,$,0.") for i in (1, 2))
    room = ifc.place("IFCSPACE", "$", second, "'Room 7',$,$,$")
    wall, wall_guid = ifc.box("IFCWALL", "wall", 0)
    ifc.contain(wall, first)
    pipe, pipe_guid = ifc.box("IFCPIPESEGMENT", "pipe", 990)
    ifc.contain(pipe, second)
    desk, desk_guid = ifc.box("IFCFURNITURE", "desk", 1980)
    ifc.contain(desk, room)
    truss = ifc.add(f"IFCELEMENTASSEMBLY('{ifc.guid()}',$,'truss',$,$,$,$,$,$,$)")
    ifc.contain(truss, first)
    beam, beam_guid = ifc.box("IFCBEAM", "beam", -990)
    ifc.add(f"IFCRELAGGREGATES('{ifc.guid()}',$,$,$,#{truss},(#{beam}))")
    _, lost_guid = ifc.box("IFCSLAB", "lost", 9000)
    return ifc.text(), [f"House/Level 1/IfcWall/wall [{wall_guid}]", f"House/Level 2/IfcPipeSegment/pipe [{pipe_guid}]",
                        f"House/Level 2/Room 7/IfcFurniture/desk [{desk_guid}]", f"House/Level 1/IfcBeam/beam [{beam_guid}]", f"IfcSlab/lost [{lost_guid}]"]


def check_ifc_places(folder):
    text, names = ifc_of_two_storeys()
    (folder / "storeys.ifc").write_text(text)
    found = report(folder, "check", "storeys.ifc")
    assert {one["name"] for one in found["objects"]} == set(names), ([one["name"] for one in found["objects"]], names)
    wall, pipe, desk, beam, _ = names
    pairs = lambda *words: {frozenset((pair["a"], pair["b"])) for pair in report(folder, "check", "storeys.ifc", *words)["pairs"]}
    assert pairs() == {frozenset(pair) for pair in ((wall, pipe), (pipe, desk), (wall, beam))}, pairs()
    assert pairs("--between", "*/Level 1/*,*/Level 1/*") == {frozenset((wall, beam))}
    assert pairs("--between", "*/Level 2/*,*/Level 2/*") == {frozenset((pipe, desk))}
    assert pairs("--ignore", "*/Room 7/*") == {frozenset((wall, pipe)), frozenset((wall, beam))}
    assert pairs("--between", "*/IfcBeam/*") == {frozenset((wall, beam))}
    result = run(folder, "check", "storeys.ifc", "--between", "*/IfcBeam/*", "--bcf", "beam.bcf")
    assert result.returncode == 1, result
    with zipfile.ZipFile(folder / "beam.bcf") as bcf:
        view = next(bcf.read(name).decode() for name in bcf.namelist() if name.endswith(".bcfv"))
    for name in (wall, beam):
        assert f'IfcGuid="{name[-23:-1]}"' in view, view


def check_ifc(folder):
    check_ifc_places(folder)
    if not IFC_MODEL.exists():
        return
    (folder / "house.ifc").write_bytes(IFC_MODEL.read_bytes())
    house = report(folder, "check", "house.ifc", "--touching", "ignore")
    assert house["unit"] == "m" and len(house["objects"]) > 100, len(house["objects"])
    assert any(one["name"] == "AC14-FZK-Haus/0. Erdgeschoss/IfcWallStandardCase/Wand-Ext-ERDG-1 [3rPX_Juz59peXXY6wDJl18]" for one in house["objects"])
    assert any("left out" in warning for warning in house["warnings"]), house["warnings"]
    walls = run(folder, "check", "house.ifc", "--between", "*/IfcDoor*,*/IfcWall*", "--bcf", "house.bcf")
    assert walls.returncode in (0, 1), walls
    (folder / "short.ifc").write_bytes(IFC_MODEL.read_bytes()[:5000])
    refused(folder, "short.ifc")
    (folder / "empty.ifc").write_bytes(b"")
    refused(folder, "empty.ifc")


# Two boxes of a unit's edge under a node that moves them, and a unit of half a metre.
COLLADA = """<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><unit meter="0.5" name="half"/><up_axis>Y_UP</up_axis></asset>
 <library_geometries><geometry id="box" name="box"><mesh>
  <source id="p"><float_array id="pa" count="24">0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1</float_array>
   <technique_common><accessor source="#pa" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <polylist count="6"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4 4 4 4 4 4</vcount>
   <p>0 2 3 1 4 5 7 6 0 1 5 4 2 6 7 3 0 4 6 2 1 3 7 5</p></polylist></mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="s"><node id="arm" name="arm"><translate>8 0 0</translate>
  <node id="left" name="left"><instance_geometry url="#box"/></node>
  <node id="right" name="right"><translate>TRANSLATION</translate><instance_geometry url="#box"/></node></node></visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
"""


def check_assimp(folder):
    (folder / "arm.dae").write_text(COLLADA.replace("TRANSLATION", "0.5 0 0"))
    arm = report(folder, "check", "arm.dae")
    assert arm["unit"] == "m" and [one["name"] for one in arm["objects"]] == ["arm/left", "arm/right"], arm["objects"]
    assert all(one["closed"] and one["solid"] for one in arm["objects"]), "corners in one place are one vertex"
    assert [(pair["a"], pair["b"], pair["relation"]) for pair in arm["pairs"]] == [("arm/left", "arm/right", "overlapping")], arm["pairs"]
    assert any("2 parts of 1 shape as Assimp reads them, with numbers of 32 bits" in warning for warning in arm["warnings"]), arm["warnings"]
    inspected = report(folder, "inspect", "arm.dae")["objects"][0]
    assert inspected["world_box"] == {"lower": [4, 0, 0], "upper": [4.5, 0.5, 0.5]} and inspected["vertices"] == 8, inspected
    (folder / "upright.dae").write_text(COLLADA.replace("TRANSLATION", "0.5 0 0").replace("Y_UP", "Z_UP"))
    assert report(folder, "inspect", "upright.dae")["objects"][1]["world_box"] == report(folder, "inspect", "arm.dae")["objects"][1]["world_box"], "nothing is turned"
    (folder / "nowhere.dae").write_text(COLLADA.replace("0 0 0 1 0 0 0", "nan 0 0 1 0 0 0"))
    refused(folder, "nowhere.dae")
    (folder / "apart.dae").write_text(COLLADA.replace("TRANSLATION", "1.5 0 0"))
    assert report(folder, "check", "apart.dae", "--clearance", "250mm")["pairs"][0]["distance"]["upper"] == 0.25
    cube = MODELS / "3DS/test1.3ds"
    if cube.exists():
        (folder / "cubes.3ds").write_bytes(cube.read_bytes())
        unknown, known = (report(folder, "inspect", "cubes.3ds", *words) for words in ((), ("--unit", "cm")))
        assert unknown["unit"] == "unit" and known["unit"] == "m", (unknown["unit"], known["unit"])
        ends = [one["objects"][0]["world_box"]["upper"][0] for one in (known, unknown)]
        assert abs(ends[0] - 0.01 * ends[1]) <= 1e-15 * abs(ends[1]), ends
        assert "states its unit" in run(folder, "check", "arm.dae", "--unit", "cm").stderr
        whole = cube.read_bytes()
        (folder / "short.3ds").write_bytes(whole[:200])
        refused(folder, "short.3ds")
    box = MODELS / "FBX/box.fbx"
    if box.exists():
        (folder / "box.fbx").write_bytes(box.read_bytes())
        found = report(folder, "inspect", "box.fbx")
        [one] = found["objects"]
        assert found["unit"] == "m" and one["closed"] and abs(one["world_box"]["upper"][2] - 0.46466) < 1e-5, found
    for name, bytes_of in (("empty.fbx", b""), ("text.dae", b"solid"), ("flat.dxf", b"0\nEOF\n")):
        (folder / name).write_bytes(bytes_of)
        refused(folder, name)


def main():
    skipped = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        check_missing(folder)
        if (FOLDER / "toccata-read-step").exists() and (FOLDER.parent / "formats/toccata_write_step").exists():
            check_step(folder)
            check_broken_step(folder)
        else:
            skipped.append("STEP: ./toccata formats step adds what reads it; toccata_write_step makes the test's file")
        if (FOLDER / "toccata-read-ifc").exists():
            check_ifc(folder)
        else:
            skipped.append("IFC: ./toccata formats ifc adds what reads it")
        if not IFC_MODEL.exists():
            skipped.append("a real IFC file: it is of Debian's assimp-testmodels")
        if (FOLDER / "toccata-read-assimp").exists():
            check_assimp(folder)
        else:
            skipped.append("FBX, Collada and others: ./toccata formats assimp adds what reads them")
    for what in skipped:
        print(f"skipped {what}")
    return 77 if skipped else 0


if __name__ == "__main__":
    sys.exit(main())
