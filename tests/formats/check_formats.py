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
import re
import subprocess
import sys
import tempfile
import zipfile

FOLDER = pathlib.Path(sys.argv[1]).resolve()
COMMAND = FOLDER / "toccata"
MODELS = pathlib.Path("/usr/share/assimp/models")
IFC_MODEL = MODELS / "IFC/AC14-FZK-Haus.ifc"


# So that a reader that does not come to an end is told as one.
ENVIRONMENT = {**os.environ, "TOCCATA_READER_SECONDS": "300"}


def run(folder, *words, **options):
    return subprocess.run([COMMAND, *words], cwd=folder, capture_output=True, text=True, timeout=600, **{"env": ENVIRONMENT, **options})


def report(folder, *words):
    result = run(folder, *words, "--json")
    assert result.returncode in (0, 1), result
    return json.loads(result.stdout)


def refused(folder, name, said=""):
    result = run(folder, "check", name)
    assert result.returncode == 2 and result.stdout == "", (name, result)
    assert result.stderr.startswith(f"toccata: error: {name}: ") and said in result.stderr, (name, result.stderr)


def told_or_refused(folder, name, parts):
    """A damaged file of so many parts: refused by its name, or read, and then what is missing is told. Gives whether it was read."""
    result = run(folder, "inspect", name, "--json")
    if result.returncode == 2:
        assert result.stdout == "" and result.stderr.startswith(f"toccata: error: {name}: "), (name, result)
        assert "not come to an end" not in result.stderr, result.stderr
        return False
    assert result.returncode == 0, (name, result)
    found = json.loads(result.stdout)
    whole = len(found["objects"]) >= parts
    assert whole or any("missing" in warning or "damaged" in warning for warning in found["warnings"]), (name, found["warnings"])
    return True


def damaged(whole, seed, first=0):
    """The file with some of its bytes another, behind the first so many."""
    generator = random.Random(seed)
    bytes_of = bytearray(whole)
    for _ in range(generator.choice([1, 1, 5, 20])):
        bytes_of[generator.randrange(first, len(bytes_of))] = generator.choice(b"0123456789#(),*$ABC")
    return bytes_of


def check_patience(folder):
    """A reader that does not come to an end is ended, and told; the file is not."""
    endless = folder / "endless"
    endless.mkdir()
    (endless / "toccata-read-ifc").write_text("#!/bin/sh\nexec sleep 1000\n")
    (endless / "toccata-read-ifc").chmod(0o755)
    (endless / "toccata").write_bytes(COMMAND.read_bytes())
    (endless / "toccata").chmod(0o755)
    (folder / "a.ifc").write_text("ISO-10303-21;")
    ask = lambda seconds: subprocess.run([endless / "toccata", "check", "a.ifc"], cwd=folder, capture_output=True, text=True, timeout=600,
                                         env={**os.environ, "TOCCATA_READER_SECONDS": seconds})
    result = ask("0.2")
    assert result.returncode == 2 and result.stdout == "", result
    assert result.stderr.startswith("toccata: error: a.ifc: IfcOpenShell has not come to an end with it") and "0.2 s" in result.stderr, result.stderr
    assert "TOCCATA_READER_SECONDS is 'soon'" in ask("soon").stderr


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
    for size in (0, 1, 100, len(whole) // 2, whole.rindex(b";", 0, len(whole) // 2) + 2, len(whole) - 20):
        (folder / "short.step").write_bytes(whole[:size])
        refused(folder, "short.step")
    refused(folder, "gone.step", "no such file")
    (folder / "text.stp").write_text("solid")
    refused(folder, "text.stp", "no whole STEP file")
    # Whatever a byte says instead, the command answers or names the file; Open CASCADE itself breaks down over a third of these.
    answered = []
    for seed in range(16):
        (folder / f"bad {seed}.step").write_bytes(damaged(whole, seed))
        answered.append(told_or_refused(folder, f"bad {seed}.step", 6))
    assert True in answered and False in answered, answered


def check_endless_step(folder):
    """Assemblies that hold themselves, at once and by way of others: Open CASCADE leaves out what hangs on them and says nothing."""
    whole = (folder / "machine.step").read_text()
    uses = re.findall(r"#\d+ = NEXT_ASSEMBLY_USAGE_OCCURRENCE\([^#]*#(\d+),#(\d+),\$\);", whole)
    machine, arm = uses[0]
    plate = next(part for assembly, part in uses if assembly == arm)
    for assembly, part in ((machine, machine), (arm, machine), (arm, arm), (plate, machine)):
        use = f"#9001 = NEXT_ASSEMBLY_USAGE_OCCURRENCE('9','again','',#{assembly},#{part},$);"
        (folder / "endless.step").write_text(whole.replace("ENDSEC;\nEND-ISO", f"{use}\nENDSEC;\nEND-ISO"))
        refused(folder, "endless.step", "is a part of itself, so that it has no end")
    # Other circles are damage: told where Open CASCADE sees it, refused where it breaks down over it.
    for kind, begin in (("MANIFOLD_SOLID_BREP", "'',"), ("EDGE_LOOP", "'',("), ("SURFACE_CURVE", "'',")):
        circle = re.sub(rf"#(\d+) = {kind}\({re.escape(begin)}#\d+", rf"#\1 = {kind}({begin}#\1", whole, count=1)
        assert circle != whole, kind
        (folder / "circle.step").write_text(circle)
        told_or_refused(folder, "circle.step", 6)


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


def with_entities(text, *entities):
    return text.replace("ENDSEC;\nEND-ISO", "\n".join([*entities, "ENDSEC;\nEND-ISO"]))


def numbers_of(text, kind):
    return re.findall(rf"#(\d+)={kind}\(", text)


def placed_in(text, placement, other):
    return text.replace(f"#{placement}=IFCLOCALPLACEMENT($,", f"#{placement}=IFCLOCALPLACEMENT(#{other},")


def check_endless_ifc(folder):
    """Placements and parts that lead round; by some of these IfcOpenShell breaks down, or does not come to an end."""
    text, _ = ifc_of_two_storeys()
    *_, one, other = numbers_of(text, "IFCLOCALPLACEMENT")
    [truss], [beam] = numbers_of(text, "IFCELEMENTASSEMBLY"), numbers_of(text, "IFCBEAM")
    is_part = f"#9001=IFCRELAGGREGATES('{ifc_guid(9001)}',$,$,$,#%s,(#%s));"
    for circle, said in ((placed_in(text, one, one), "(IfcLocalPlacement) in it is placed by way of itself"),
                         (placed_in(placed_in(text, one, other), other, one), "(IfcLocalPlacement) in it is placed by way of itself"),
                         (with_entities(text, is_part % (beam, truss)), "in it is a part of itself"),
                         (with_entities(text, is_part % (truss, truss)), "in it is a part of itself")):
        (folder / "endless.ifc").write_text(circle)
        refused(folder, "endless.ifc", said)
    # A place within itself and a storey in two places: the elements are all there, under the names by the first.
    [site], storey, [house] = numbers_of(text, "IFCSITE"), numbers_of(text, "IFCBUILDINGSTOREY")[0], numbers_of(text, "IFCBUILDING")
    for whole, part in ((site, site), (storey, house)):
        (folder / "round.ifc").write_text(with_entities(text, is_part % (whole, part)))
        assert len(report(folder, "check", "round.ifc")["objects"]) == 5
    contained = text.replace(f"(#{truss}),#{storey});", f"(#{truss}),#{truss});")
    assert contained != text
    (folder / "contained.ifc").write_text(contained)
    assert told_or_refused(folder, "contained.ifc", 5)
    # A shape that is made of itself.
    [first, *_], solid = numbers_of(text, "IFCSHAPEREPRESENTATION"), numbers_of(text, "IFCEXTRUDEDAREASOLID")[0]
    shape = text.replace(f"(#{solid}))", "(#9001))", 1)
    (folder / "solid.ifc").write_text(with_entities(shape, f"#9001=IFCBOOLEANRESULT(.UNION.,#9001,#{solid});"))
    told_or_refused(folder, "solid.ifc", 5)
    axes = numbers_of(text, "IFCAXIS2PLACEMENT3D")[0]
    (folder / "map.ifc").write_text(with_entities(
        shape, "#9001=IFCMAPPEDITEM(#9002,#9003);", f"#9002=IFCREPRESENTATIONMAP(#{axes},#{first});",
        "#9003=IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#9004,$,$);", "#9004=IFCCARTESIANPOINT((0.,0.,0.));"))
    told_or_refused(folder, "map.ifc", 5)


def check_broken_ifc(folder):
    text, _ = ifc_of_two_storeys()
    (folder / "unknown.ifc").write_text(text.replace("=IFCSLAB(", "=IFCSL*B("))
    found = report(folder, "inspect", "unknown.ifc")
    assert len(found["objects"]) == 4 and any("1 entity in it is damaged" in warning for warning in found["warnings"]), found["warnings"]
    (folder / "kind.ifc").write_text(re.sub(r"(CONTAINEDIN\w+\('\d+',\$,\$,\$,\(#\d+\),)#", r"\1'", text, count=1).replace("'14)", "'14')"))
    refused(folder, "kind.ifc", "what it holds is not as the standard says")
    for size in (0, 1, 100, len(text) // 2, text.rindex(";", 0, len(text) // 2) + 2, len(text) - 20):
        (folder / "short.ifc").write_text(text[:size])
        refused(folder, "short.ifc")
    answered = []
    for seed in range(16):
        (folder / f"bad {seed}.ifc").write_bytes(damaged(text.encode(), seed, text.index("DATA;")))
        answered.append(told_or_refused(folder, f"bad {seed}.ifc", 5))
    assert True in answered and False in answered, answered


def check_ifc(folder):
    check_ifc_places(folder)
    check_endless_ifc(folder)
    check_broken_ifc(folder)
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
        check_patience(folder)
        if (FOLDER / "toccata-read-step").exists() and (FOLDER.parent / "formats/toccata_write_step").exists():
            check_step(folder)
            check_broken_step(folder)
            check_endless_step(folder)
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
