#!/usr/bin/env python3
"""Writes a scene file of what an IFC file (ISO 16739) holds: each element with a shape an object, called by where it is in the
building, its class, name and GlobalId ("House/Level 1/IfcWall/outer wall [2O2Fr$t4X7Zf8NOew3FLOH]"), each shape once however often
it is placed, in metres. By IfcOpenShell.

usage: toccata-read-ifc FILE.ifc SCENE.json [--tessellation LENGTH]

What is to be told about the reading goes to standard output, a line each; why it failed, to standard error.
"""
import array
import base64
import json
import re
import sys

METRES = {"": 1, "mm": 0.001, "cm": 0.01, "m": 1, "in": 0.0254, "ft": 0.3048}
# What is no thing that could collide: openings are cut out of walls, spaces are the air in rooms.
LEFT_OUT = ("IfcOpeningElement", "IfcSpace", "IfcAnnotation", "IfcGrid", "IfcVirtualElement")


class Trouble(Exception):
    pass


def metres_of(text):
    parts = re.fullmatch(r"([0-9.]+(?:[eE][-+]?[0-9]+)?)(mm|cm|m|in|ft|)", text)
    if not parts or not float(parts[1]) > 0:
        raise Trouble(f"--tessellation {text} is no length above 0: write 1mm, say")
    return float(parts[1]) * METRES[parts[2]]


def text_of(kind, numbers):
    return base64.b64encode(array.array(kind, numbers).tobytes()).decode()


def pose_of(matrix):
    """Of a 4 × 4 matrix column by column."""
    m = list(matrix.data if hasattr(matrix, "data") else matrix)
    if len(m) == 12:  # earlier versions leave the last row out
        return [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8], m[9], m[10], m[11]]
    return [m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10], m[12], m[13], m[14]]


# By which relations an element hangs on what holds it: what it is in, what it is a part of, what it fills.
PARENTS = (("ContainedInStructure", "RelatingStructure"), ("Decomposes", "RelatingObject"), ("Nests", "RelatingObject"),
           ("FillsVoids", "RelatingOpeningElement"), ("VoidsElements", "RelatingBuildingElement"))


def parent_of(element):
    for relation, parent in PARENTS:
        for one in getattr(element, relation, None) or ():
            if getattr(one, parent, None) is not None:
                return getattr(one, parent)
    return None


def is_place(element):
    """A building, a storey, a space, a part of a bridge. Project and site are around everything."""
    return element.is_a("IfcSpatialStructureElement") and not element.is_a("IfcSite")


def places_of(element):
    """The names of the places that hold it, from the largest on."""
    names, seen = [], set()
    while (element := parent_of(element)) is not None and element.id() not in seen:
        seen.add(element.id())  # a damaged file may lead round
        if is_place(element):
            names.append(element.Name or getattr(element, "LongName", None) or element.is_a())
    return names[::-1]


def whole_of(element):
    """What it is a part of."""
    return next((one.RelatingObject for one in getattr(element, "Decomposes", None) or () if hasattr(one, "RelatingObject")), None)


# What IfcOpenShell follows to its end, wherever that is.
WAYS = (("IfcLocalPlacement", lambda placement: getattr(placement, "PlacementRelTo", None), "placed by way of itself"),
        ("IfcObjectDefinition", whole_of, "a part of itself"))


def require_ends(model):
    """Raises Trouble where a way leads round; each element is passed once, whoever comes by it."""
    for kind, next_of, what in WAYS:
        ending = set()
        for one in model.by_type(kind):
            way = set()
            while one is not None and one.id() not in ending and one.id() not in way:
                way.add(one.id())
                one = next_of(one)
            if one is not None and one.id() in way:
                raise Trouble(f"#{one.id()} ({one.is_a()}) in it is {what}; export it again")
            ending |= way


class Scene:
    def __init__(self, source):
        self.source, self.objects, self.meshes, self.taken = source, [], {}, set()

    def free_name(self, name):
        free, number = name, 2
        while free in self.taken:
            free, number = f"{name} #{number}", number + 1
        self.taken.add(free)
        return free

    def add(self, element, shape):
        key = str(shape.geometry.id)
        if key not in self.meshes:
            if not shape.geometry.faces:
                return
            self.meshes[key] = {"vertices": text_of("d", shape.geometry.verts), "triangles": text_of("I", shape.geometry.faces)}
        name = "/".join([*places_of(element), element.is_a(), f"{element.Name or 'unnamed'} [{element.GlobalId}]"])
        self.objects.append({"name": self.free_name(name), "mesh": key, "pose": pose_of(shape.transformation.matrix), "source": self.source})

    def json(self):
        return {"format": "toccata-scene", "version": 1, "unit": "m", "objects": self.objects, "meshes": self.meshes}


def require_end(file):
    """IfcOpenShell reads what is there of a file that was cut off between two entities."""
    with open(file, "rb") as stream:
        begin = stream.read(64)
        stream.seek(max(0, stream.seek(0, 2) - 65536))
        if b"ISO-10303-21" in begin and b"END-ISO-10303-21" not in stream.read():
            raise Trouble("this is no whole IFC file: its last line, END-ISO-10303-21, is missing; export it again")


def opened(ifcopenshell, file):
    """The model, and what could not be read of it, by the log, whose form differs by version."""
    logged = getattr(ifcopenshell, "get_log", str)
    logged()  # what was there before
    try:
        model, trouble = ifcopenshell.open(file), None
    except Exception as error:  # its kinds, too, differ by version
        model, trouble = None, error
    damages = [re.sub(r"^(\[[^]]*\] *)+", "", line) for line in logged().splitlines()
               if re.search(r"^\[error\]|\"level\": *\"error\"|Overwriting instance", line, re.IGNORECASE)]
    if trouble:
        said = damages[-1] if damages else " ".join(str(trouble).split())
        raise Trouble(f"this is no whole IFC file: {said}; export it again") from trouble
    return model, damages


def convert(file, scene_file, tessellation):
    try:
        import ifcopenshell
        import ifcopenshell.geom
    except ImportError as error:
        raise Trouble(f"to read it takes IfcOpenShell, which is not there ({error}): pip install ifcopenshell") from error
    require_end(file)
    model, damages = opened(ifcopenshell, file)
    require_ends(model)
    settings = ifcopenshell.geom.settings()
    for name in ("mesher-linear-deflection", "MESHER_LINEAR_DEFLECTION"):
        try:
            settings.set(name, tessellation)
            break
        except (RuntimeError, KeyError, TypeError, AttributeError):
            pass
    left_out = [element for kind in LEFT_OUT for element in (model.by_type(kind) if kind_is_known(model, kind) else [])]
    iterator = ifcopenshell.geom.iterator(settings, model, 1, exclude=left_out) if left_out else ifcopenshell.geom.iterator(settings, model, 1)
    scene = Scene(file)
    if iterator.initialize():
        while True:
            shape = iterator.get()
            scene.add(model.by_id(shape.id), shape)
            if not iterator.next():
                break
    if not scene.objects:
        raise Trouble("no element in it has a shape; export it with its geometry")
    with open(scene_file, "w", encoding="utf-8") as out:
        json.dump(scene.json(), out)
    if damages:
        one = len(damages) == 1
        print(f"{'1 entity' if one else f'{len(damages)} entities'} in it {'is' if one else 'are'} damaged ({damages[0]}): "
              f"what {'it describes' if one else 'they describe'} may be missing or another")
    tell(model, scene, len(left_out), tessellation)


def kind_is_known(model, kind):
    try:
        model.by_type(kind)
        return True
    except RuntimeError:
        return False


def tell(model, scene, left_out, tessellation):
    print(f"{model.schema}: {len(scene.objects)} elements of {len(scene.meshes)} shapes in metres, curved faces as triangles within "
          f"{1000 * tessellation:g} mm of them (--tessellation)")
    if left_out:
        print(f"{left_out} openings, spaces, annotations and grids are left out")
    with_shape = {element.GlobalId for element in model.by_type("IfcElement") if element.Representation and not element.is_a("IfcOpeningElement")}
    missing = len(with_shape - {name.rpartition('[')[2][:22] for name in scene.taken})
    if missing > 0:
        print(f"{missing} elements with a shape could not be meshed, and are missing")


def main(words):
    try:
        if len(words) != 2 and not (len(words) == 4 and words[2] == "--tessellation"):
            raise Trouble("usage: toccata-read-ifc FILE.ifc SCENE.json [--tessellation LENGTH]")
        convert(words[0], words[1], metres_of(words[3]) if len(words) == 4 else 0.001)
        return 0
    except Trouble as trouble:
        print(trouble, file=sys.stderr)
    except (OSError, MemoryError) as trouble:
        print(" ".join(str(trouble).split()) or "there is not enough memory for it", file=sys.stderr)
    except Exception as error:  # any attribute of a damaged file may be of another kind than the standard says
        print(f"what it holds is not as the standard says ({type(error).__name__}: {' '.join(str(error).split())}); export it again", file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
