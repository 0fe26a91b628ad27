"""Docstrings say what a question takes, in which unit and frame, what it raises, and where its method comes from.

Read in the stubs, which test_types.py compares with the compiled part.
"""

import ast
import pathlib
import re

import pytest

import toccata

STUB = ast.parse(pathlib.Path(toccata.__file__).with_suffix(".pyi").read_text())
# What may be given wrongly, by how the stubs call it.
MAY_BE_WRONG = re.compile(r"ArrayLike|PoseLike|PosesLike|ShapesLike|ObjectsLike|MotionLike|BodiesLike|AllowedPairs|\bShape\b|\bMesh\b|RigidMotion")
# Numbers that are lengths, and answers that hold some.
LENGTHS = {"distance", "max_distance", "limit", "clearance", "gap", "radius", "radii", "edge", "stop_before", "excess", "margin", "margins", "concavity",
           "nearest", "farthest", "half_height", "half_extents", "half_axes", "spacing", "translation", "motion", "motions", "separation"}
HAVE_LENGTHS = re.compile(r"Distance|Penetration|DepthBracket|OverlapVolume|Manifold|SurfacePoint|ShapeHit|RayHit")
# A frame, or what tells it: another question, or that something is where its pose puts it.
FRAME = re.compile(r"\bworld\b|\bframe\b|\bposed\b|\b[Ll]ike \w|\b[Aa]s \w|\b\w+_each takes|\bof many")
# Whose method it is.
SOURCES = {
    "distance": "Gilbert", "penetration": "van den Bergen", "overlap_volume": "Edelsbrunner", "contacts": "Möller", "manifolds": "Canny",
    "nearest_point": "Roussopoulos", "signed_distance": "Jacobson", "generalized_winding_number": "Jacobson", "cast_shape": "Mirtich", "sweep": "Mirtich",
    "vertex_face_impacts": "Provot", "decompose": "Lien", "ConvexHull": "Barber", "Pose.nearest_rigid": "Higham", "RigidMotion.screw": "Chasles",
    "RobotScene.edge": "Mirtich", "DistanceCache": "Basch",
}


def documented() -> dict:
    """Functions, classes and methods by name: the docstring, the functions that are called (overloads), whether it is a class."""
    found: dict = {}

    def add(name: str, calls: list, text: str, is_class: bool = False) -> None:
        known = found.setdefault(name, {"calls": [], "text": "", "class": is_class})
        known["calls"] += calls
        known["text"] += " ".join(text.split())

    for node in STUB.body:
        if isinstance(node, ast.FunctionDef):
            add(node.name, [node], ast.get_docstring(node) or "")
        elif isinstance(node, ast.ClassDef) and not any("enum" in ast.unparse(base) for base in node.bases):
            functions = [member for member in node.body if isinstance(member, ast.FunctionDef)]
            add(node.name, [f for f in functions if f.name == "__init__"], ast.get_docstring(node) or "", True)
            for function in functions:
                is_property = any(ast.unparse(d) == "property" for d in function.decorator_list)
                if not function.name.startswith("_") and not is_property:
                    add(f"{node.name}.{function.name}", [function], ast.get_docstring(function) or "")
    return found


DOCUMENTED = documented()


def arguments(entry: dict) -> dict[str, str]:
    """Of all ways to call it, the types by name."""
    every = [argument for call in entry["calls"] for argument in call.args.args + call.args.kwonlyargs if argument.arg != "self"]
    return {argument.arg: ast.unparse(argument.annotation) for argument in every}


def with_its_class(name: str) -> str:
    """A method's docstring and that of its class, which may say for all how lengths are told."""
    return DOCUMENTED[name]["text"] + DOCUMENTED.get(name.rpartition(".")[0], {"text": ""})["text"]


def answered(entry: dict) -> str:
    return " ".join(ast.unparse(call.returns) for call in entry["calls"] if call.returns)


@pytest.mark.parametrize("name", DOCUMENTED)
def test_a_docstring_says_what_has_to_be_known(name):
    entry = DOCUMENTED[name]
    text, given = entry["text"], arguments(entry)
    assert text, "it has none"
    if any(MAY_BE_WRONG.search(kind) for kind in given.values()):
        assert re.search(r"[Rr]aises Error", text), f"it does not say what it raises: {text}"
    if any("ArrayLike" in kind for kind in given.values()):
        assert re.search(r"shapes? \(|\(N,|three numbers", text), f"it does not say which shapes its arrays have: {text}"
    if any(re.search(r"ArrayLike|Poses?Like", kind) for kind in given.values()):
        assert FRAME.search(with_its_class(name)), f"it does not say in which frame its arguments are: {text}"
    if LENGTHS & set(given) or (not entry["class"] and HAVE_LENGTHS.search(answered(entry))):
        assert re.search(r"\bunits?\b|metres", with_its_class(name)), f"it does not say in which unit lengths are: {text}"


@pytest.mark.parametrize("name", SOURCES)
def test_a_method_has_its_source(name):
    text = DOCUMENTED[name]["text"]
    assert SOURCES[name] in text and re.search(r"\b(1[89]|20)\d\d\b", text), text


def test_batches_say_that_they_are():
    for name, entry in DOCUMENTED.items():
        if "threads" in arguments(entry) and name.endswith("_each"):
            assert "on all cores" in entry["text"] or "many" in entry["text"], name
