"""Racks of bent pipes, layer across layer, each of which is pressed into every pipe of the layer below: assemblies whose clashes
are known by construction, written as meshes or as IFC."""
import dataclasses
import math
import random
import struct

RADIUS = 0.3
UNEVEN = 0.05  # by how much the way from pipe to pipe differs at most from that of their layers
SHALLOW = (0.54,)  # every clash is some 0.06 deep, which is a tenth of a pipe
# Every fourth layer lies with its axes near those of the layer below: pipes that go through each other, three quarters and two fifths of
# their thickness deep in turns. Two steps together are more than that thickness, so no layer reaches the next but one.
MIXED = (0.54, 0.15, 0.54, 0.54, 0.54, 0.35, 0.54, 0.54)


@dataclasses.dataclass
class Rack:
    layers: int
    pipes: int  # of each layer
    around: int  # sides of a pipe
    along: int  # rings of a pipe, but for the first
    steps: tuple = SHALLOW  # from layer to layer, over and over

    def parts(self):
        return self.layers * self.pipes

    def triangles(self):
        return self.parts() * 2 * self.around * (self.along + 1)

    def step(self, layer):
        """From that layer to the next."""
        return self.steps[layer % len(self.steps)]

    def depths(self):
        """The clashes that there are, by their parts, and how deep each is, give or take UNEVEN."""
        return {(pipe_name(layer, i), pipe_name(layer + 1, k)): 2 * RADIUS - self.step(layer)
                for layer in range(self.layers - 1) for i in range(self.pipes) for k in range(self.pipes)}


def pipe_name(layer, number):
    return f"pipe-{layer:02}-{number}"


def pipe_points(height, number, rack, chance):
    """Vertices ring by ring and then the middle of each end; layers lie across each other in turns."""
    bend, wave = chance.uniform(0, 7), chance.uniform(0, 7)
    for j in range(rack.along + 1):
        t = j / rack.along
        x, y = (t - 0.5) * rack.pipes, number - (rack.pipes - 1) / 2 + 0.02 * math.sin(9 * t + bend)
        z = height + 0.02 * math.sin(7 * t + wave)
        for i in range(rack.around):
            angle = 2 * math.pi * (i + 0.5 * (j % 2)) / rack.around
            radius = RADIUS * (1 + 0.01 * math.sin(5 * angle + 40 * t))
            yield x, y + radius * math.cos(angle), z + radius * math.sin(angle)
    for end in (-0.5, 0.5):
        t = end + 0.5
        yield end * rack.pipes, number - (rack.pipes - 1) / 2 + 0.02 * math.sin(9 * t + bend), height + 0.02 * math.sin(7 * t + wave)


def pipe_triangles(rack):
    around, along = rack.around, rack.along
    first, last = around * (along + 1), around * (along + 1) + 1
    for j in range(along):
        for i in range(around):
            a, b = j * around + i, j * around + (i + 1) % around
            c, d = a + around, b + around
            yield from ((a, b, c), (b, d, c)) if j % 2 == 0 else ((a, d, c), (a, b, d))
    for i in range(around):
        yield first, (i + 1) % around, i
        yield last, along * around + i, along * around + (i + 1) % around


def all_pipes(rack):
    """The name and the vertices of each."""
    chance, height = random.Random(1), 0
    for layer in range(rack.layers):
        for number in range(rack.pipes):
            points = list(pipe_points(height, number, rack, chance))
            yield pipe_name(layer, number), points if layer % 2 == 0 else [(-y, x, z) for x, y, z in points]
        height += rack.step(layer)


def write_meshes(folder, rack):
    """Binary PLY files of doubles."""
    triangles = list(pipe_triangles(rack))
    faces = b"".join(struct.pack("<B3i", 3, *triangle) for triangle in triangles)
    for name, points in all_pipes(rack):
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


def write_ifc(file, rack):
    faces = ",".join("(%d,%d,%d)" % tuple(corner + 1 for corner in triangle) for triangle in pipe_triangles(rack))
    with open(file, "w", encoding="ascii") as ifc:
        ifc.write(IFC_HEAD % guid(1))
        for number, (name, points) in enumerate(all_pipes(rack)):
            line = 10 + 5 * number
            corners = ",".join("(%r,%r,%r)" % tuple(x + 0.0 for x in point) for point in points)
            ifc.write(f"#{line}=IFCCARTESIANPOINTLIST3D(({corners}));\n#{line + 1}=IFCTRIANGULATEDFACESET(#{line},$,.T.,({faces}),$);\n"
                      f"#{line + 2}=IFCSHAPEREPRESENTATION(#3,'Body','Tessellation',(#{line + 1}));\n#{line + 3}=IFCPRODUCTDEFINITIONSHAPE($,$,(#{line + 2}));\n"
                      f"#{line + 4}=IFCBUILDINGELEMENTPROXY('{guid(number + 2)}',$,'{name}',$,$,#7,#{line + 3},$,$);\n")
        ifc.write("ENDSEC;\nEND-ISO-10303-21;\n")
