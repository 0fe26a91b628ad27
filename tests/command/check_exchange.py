#!/usr/bin/env python3
"""What `check` writes for other programs is as those read it: JUnit XML, SARIF 2.1.0, BCF 2.1 and 3.0.

usage: check_exchange.py TOCCATA [--reader | --schemas FOLDER]

With --reader the BCF files are read, saved and read again by bcf-client (PyPI: pip install bcf-client) instead; exit status 77
where that is not installed. With --schemas they are validated (PyPI: pip install xmlschema) by those of buildingSMART's
repository BCF-XML: the files of its folder Schemas of release_2_1 in FOLDER/2.1, of release_3_0 in FOLDER/3.0. The sources of
bcf-client 0.7.10 on PyPI hold them too (`add_bcf_reader` of tools/steps.sh).
"""
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
import zipfile

import bcf_round_trip

COMMAND = str(pathlib.Path(sys.argv[1]).resolve())
ENVIRONMENT = {**os.environ, "SOURCE_DATE_EPOCH": "1700000000"}

# Two boxes that overlap by 0.5, one that touches the first, one nearer than 2 mm; names that XML and JSON have to escape.
LARGE, SMALL = '"parameters": {"half-x": 1, "half-y": 1, "half-z": 1}', '"parameters": {"half-x": 0.4, "half-y": 1, "half-z": 1}'
SCENE = """{"format": "toccata-scene", "version": 1, "unit": "cm", "objects": [
  {"name": "a <&> \\"b\\"", "generate": "box", LARGE},
  {"name": "Wall [2O2Fr$t4X7Zf8NOew3FLOH]", "generate": "box", LARGE, "pose": {"translation": [1.5, 0, 0]}},
  {"name": "tabs\\tand ü", "generate": "box", SMALL, "pose": {"translation": [-0.5, 2, 0]}},
  {"name": "near", "generate": "box", SMALL, "pose": {"translation": [-0.5, -2.125, 0]}}]}""".replace("LARGE", LARGE).replace("SMALL", SMALL)


def run(folder, *words, code):
    result = subprocess.run([COMMAND, "check", *words], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True)
    assert result.returncode == code, (words, result)
    return result


def check_junit(folder):
    suites = ElementTree.parse(folder / "found.xml").getroot()
    suite = suites.find("testsuite")
    cases = suite.findall("testcase")
    assert suites.tag == "testsuites" and suites.get("errors") == "0", suites.attrib
    assert len(cases) == int(suite.get("tests")) == int(suites.get("tests")) == 3, suite.attrib
    failed = [case for case in cases if case.find("failure") is not None]
    assert len(failed) == int(suite.get("failures")) == int(suites.get("failures")) == 1, suite.attrib
    assert len({(case.get("classname"), case.get("name")) for case in cases}) == 3
    assert failed[0].get("name") == 'a <&> "b" – Wall [2O2Fr$t4X7Zf8NOew3FLOH]', failed[0].attrib
    failure = failed[0].find("failure")
    assert failure.get("type") == "overlapping" and "overlaps" in failure.get("message"), failure.attrib
    assert all(case.find("system-out") is not None for case in cases if case not in failed)


def check_sarif(folder):
    document = json.loads((folder / "found.sarif").read_text())
    assert document["version"] == "2.1.0" and document["$schema"].endswith("sarif-2.1.0.json")
    [run_of] = document["runs"]
    driver = run_of["tool"]["driver"]
    assert driver["name"] == "Toccata" and driver["rules"]
    rules = {rule["id"] for rule in driver["rules"]}
    assert run_of["invocations"][0]["executionSuccessful"] is True
    results = run_of["results"]
    assert [result["ruleId"] for result in results] == ["overlapping", "touching", "clearance"], results
    assert [result["level"] for result in results] == ["error", "note", "note"]
    for result in results:
        assert result["ruleId"] in rules and result["message"]["text"]
        assert len(result["partialFingerprints"]["toccataPair/v1"]) == 32
        for location in result["locations"]:
            assert location["physicalLocation"]["artifactLocation"]["uri"] == "the%20scene.json"
            assert location["logicalLocations"][0]["name"]
    assert results[2]["properties"]["distance"]["upper"] == 0.125, results[2]


def check_sarif_baseline(folder):
    """States against a baseline: one stays, one is new, one has gone."""
    (folder / "old.json").write_text(run(folder, "the scene.json", "--json", code=1).stdout)
    (folder / "moved.json").write_text(SCENE.replace("[-0.5, 2, 0]", "[0, 9, 0]").replace("-2.125", "-2"))
    run(folder, "moved.json", "--baseline", "old.json", "--sarif", "since.sarif", code=1)
    states = [result["baselineState"] for result in json.loads((folder / "since.sarif").read_text())["runs"][0]["results"]]
    assert states == ["unchanged", "new", "absent"], states


def numbers(node):
    return [float(node.find(axis).text) for axis in "XYZ"]


def check_bcf(folder):
    check_bcf_of(folder, "2.1", "Labels", "Viewpoints", "Components/Coloring/Color/Component")
    check_bcf_of(folder, "3.0", "Labels/Label", "Topic/Viewpoints/ViewPoint", "Components/Coloring/Color/Components/Component")


def check_bcf_of(folder, version, label, viewpoint, coloured):
    """A file of a version, and where that has what the versions do not have in the same place."""
    with zipfile.ZipFile(folder / f"found-{version}.bcf") as bcf:
        assert bcf.testzip() is None
        names = bcf.namelist()
        assert names[0] == "bcf.version", names
        assert ElementTree.fromstring(bcf.read("bcf.version")).get("VersionId") == version
        assert ("extensions.xml" in names) == (version == "3.0"), names
        topics = {name.split("/")[0] for name in names if "/" in name}
        assert len(topics) == 3, names
        titles = {}
        for guid in topics:
            markup = ElementTree.fromstring(bcf.read(f"{guid}/markup.bcf"))
            topic = markup.find("Topic")
            assert topic.get("Guid") == guid and len(guid) == 36
            # In the order of the schema.
            assert [one.tag for one in topic][:5] == ["Title", "Index", "Labels", "CreationDate", "CreationAuthor"]
            assert topic.find("CreationDate").text == "2023-11-14T22:13:20Z"
            assert topic.find(label).text in ("overlapping", "touching", "clearance")
            if version == "3.0":
                known = ElementTree.fromstring(bcf.read("extensions.xml"))
                assert topic.get("TopicType") in [one.text for one in known.findall("TopicTypes/TopicType")]
                assert topic.get("TopicStatus") in [one.text for one in known.findall("TopicStatuses/TopicStatus")]
                assert topic.find(label).text in [one.text for one in known.findall("TopicLabels/TopicLabel")]
            view = ElementTree.fromstring(bcf.read(f"{guid}/{markup.find(viewpoint).find('Viewpoint').text}"))
            assert view.get("Guid") == markup.find(viewpoint).get("Guid")
            assert [one.tag for one in view.find("Components")] == ["Selection", "Visibility", "Coloring"]
            titles[topic.find("Title").text] = view
    [overlap] = [view for title, view in titles.items() if "overlaps" in title]
    selected = overlap.findall("Components/Selection/Component")
    assert [one.get("IfcGuid") for one in selected] == [None, "2O2Fr$t4X7Zf8NOew3FLOH"]
    assert [one.get("IfcGuid") for one in overlap.findall(coloured)] == [None, "2O2Fr$t4X7Zf8NOew3FLOH"]
    camera = overlap.find("PerspectiveCamera")
    assert (camera.find("AspectRatio") is not None) == (version == "3.0")
    place, direction = numbers(camera.find("CameraViewPoint")), numbers(camera.find("CameraDirection"))
    assert math.isclose(math.hypot(*direction), 1, rel_tol=1e-9)
    # It looks at the middle of where the two meet, in metres: (0.75, 0, 0) cm.
    way = [middle - at for middle, at in zip([0.0075, 0, 0], place)]
    along = sum(a * b for a, b in zip(way, direction))
    assert math.hypot(*(a - along * b for a, b in zip(way, direction))) < 1e-9 and along > 0, (place, direction)


def check_cameras(folder):
    """A finding whose place no answer tells is looked at all the same: where both may be, or, of what has no end, somewhere."""
    cylinder = '{"name": "%s", "shape": {"type": "cylinder", "radius": 1, "half_height": 1}, "pose": {"translation": [%s, 0, 0]}}'
    half_space = '{"name": "%s", "shape": {"type": "half-space", "normal": [%s, 0, 1]}}'
    for shape, middle in ((cylinder, 0.5), (half_space, 0)):
        objects = ", ".join(shape % named for named in (("one", 0), ("other", 1)))
        (folder / "vague.json").write_text('{"format": "toccata-scene", "version": 1, "unit": "m", "objects": [%s]}' % objects)
        run(folder, "vague.json", "--bcf", "vague.bcf", "--bcf-version", "3.0", code=1)
        with zipfile.ZipFile(folder / "vague.bcf") as bcf:
            [view] = [ElementTree.fromstring(bcf.read(name)) for name in bcf.namelist() if name.endswith(".bcfv")]
        camera = view.find("PerspectiveCamera")
        place, direction = numbers(camera.find("CameraViewPoint")), numbers(camera.find("CameraDirection"))
        far = -place[2] / direction[2]
        assert math.isclose(place[0] + far * direction[0], middle, abs_tol=1e-9), (objects, place, direction)


def scene_of(*objects):
    parts = [{"name": name, "shape": {"type": "box", "half_extents": half}, "pose": {"translation": at}} for name, half, at in objects]
    return json.dumps({"format": "toccata-scene", "version": 1, "unit": "mm", "objects": parts})


def check_tolerance(folder):
    """What lies within its tolerance is told, and is nothing to act on."""
    row = scene_of(("a", [1, 1, 1], [0, 0, 0]), ("shallow", [1, 1, 1], [1.9375, 0, 0]), ("deep", [1, 1, 1], [-1.5, 0, 0]))
    (folder / "row.json").write_text(row)
    told = run(folder, "row.json", "--tolerance", "0.1", "--sarif", "row.sarif", "--bcf", "row.bcf", "--junit", "row.xml", code=1)
    assert "row.bcf: 2 findings, 1 of them within the tolerance." in told.stdout, told.stdout
    shallow, deep = json.loads((folder / "row.sarif").read_text())["runs"][0]["results"]
    assert (shallow["level"], shallow["properties"]["tolerance"]) == ("note", "within"), shallow
    assert (deep["level"], deep["properties"]["tolerance"]) == ("error", "beyond"), deep
    assert "within the tolerance: no clash" in shallow["message"]["text"] and "beyond the tolerance" in deep["message"]["text"]
    with zipfile.ZipFile(folder / "row.bcf") as bcf:
        topics = [ElementTree.fromstring(bcf.read(name)).find("Topic") for name in bcf.namelist() if name.endswith("markup.bcf")]
    assert {topic.find("Title").text.split(",")[0]: topic.get("TopicStatus") for topic in topics} == {"a overlaps shallow": "Closed", "a overlaps deep": "Open"}
    cases = ElementTree.parse(folder / "row.xml").getroot().findall("testsuite/testcase")
    assert [case.find("failure") is None for case in cases] == [True, False]
    assert "within the tolerance" in cases[0].find("system-out").text


def check_places(folder):
    """Where a finding is, is told as what it is: a box only where it is one."""
    def places(scene, *options):
        (folder / "places.json").write_text(scene)
        run(folder, "places.json", "--junit", "places.xml", "--bcf", "places.bcf", *options, code=1)
        cases = ElementTree.parse(folder / "places.xml").getroot().findall("testsuite/testcase")
        return [(case.find("failure").text or "").split("\n")[1] for case in cases]

    a = ("a", [1, 1, 1], [0, 0, 0])
    meshes = SCENE.replace('"cm"', '"mm"')
    assert places(meshes, "--clearance", "0.2") == [
        "the surfaces meet within the box from (0.5, -1, -1) to (1, 1, 1)",
        "the surfaces meet within the rectangle from (-0.9, 1, -1) to (-0.1, 1, 1)",
        "the nearest points are (-0.9, -1, -1) and (-0.9, -1.125, -1)"], places(meshes, "--clearance", "0.2")
    assert places(meshes, "--penetration")[1].startswith("the surfaces meet within the rectangle")
    # What is as thin as rounding makes it is a rectangle, as its digits are.
    large = '"generate": "box", "parameters": {"half-x": 1, "half-y": 1, "half-z": 1}'
    thin = """{"format": "toccata-scene", "version": 1, "unit": "mm", "objects": [{"name": "a", BOX},
      {"name": "b", BOX, "pose": {"translation": [0.5, 0, 1.9999999999999996]}}]}""".replace("BOX", large)
    assert places(thin) == ["the surfaces meet within the rectangle from (-0.5, -1, 1) to (1, 1, 1)"], places(thin)
    edge = ("b", [1, 1, 1], [2, 2, 0])
    assert places(scene_of(a, edge), "--penetration") == ["they are in contact on the segment from (1, 1, -1) to (1, 1, 1)"]
    corner = ("b", [1, 1, 1], [2, 2, 2])
    assert places(scene_of(a, corner), "--penetration") == ["they are in contact at (1, 1, 1)"]
    assert places(scene_of(a, ("b", [0.5, 0.5, 0.5], [0, 0, 0]))) == ["the one inside lies within the box from (-0.5, -0.5, -0.5) to (0.5, 0.5, 0.5)"]
    assert places(scene_of(a, ("b", [1, 1, 1], [1.5, 0.25, 0])), "--tolerance", "0.1") == ["the deepest points are (1, 0.125, 0) and (0.5, 0.125, 0)"]


# A plate with a rod through it, a block into it and a ball within it, and a box on it; and what each has in common with the plate.
CLASHES = """{"format": "toccata-scene", "version": 1, "unit": "mm", "objects": [
  {"name": "plate", "generate": "box", "parameters": {"half-x": 4, "half-y": 4, "half-z": 0.5}},
  {"name": "rod", "generate": "box", "parameters": {"half-x": 0.5, "half-y": 0.5, "half-z": 4}},
  {"name": "block", "generate": "box", "parameters": {"half-x": 1, "half-y": 1, "half-z": 1}, "pose": {"translation": [4.5, 0, 0]}},
  {"name": "ball", "shape": {"type": "sphere", "radius": 0.25}, "pose": {"translation": [2, 0, 0]}},
  {"name": "box", "generate": "box", "parameters": {"half-x": 1, "half-y": 1, "half-z": 1}, "pose": {"translation": [-2, -2, 1.5]}}]}"""
IN_COMMON = {"rod": ("pierce", 1, [(-0.5, 0.5)] * 3), "block": ("protrude", 1, [(3.5, 4), (-1, 1), (-0.5, 0.5)]),
             "ball": ("contains", 4 / 3 * math.pi * 0.25**3, [(1.75, 2.25), (-0.25, 0.25), (-0.25, 0.25)])}


def check_kinds(folder):
    """With --volume: which kind of clash it is, how much they have in common, and a point of both; without, none of it."""
    (folder / "clashes.json").write_text(CLASHES)
    run(folder, "clashes.json", "--volume", "--junit", "k.xml", "--sarif", "k.sarif", "--bcf", "k.bcf", "--bcf-version", "3.0", code=1)
    sentences = ["plate is pierced by rod (both solids)", "plate protrudes into block (both solids)", "plate contains ball (both solids)",
                 "plate touches box (both solids)"]
    results = json.loads((folder / "k.sarif").read_text())["runs"][0]["results"]
    assert [one["message"]["text"] for one in results] == sentences, results
    told = [one["properties"] for one in results]
    assert [one.get("piercing") for one in told] == ["b_through_a", None, None, None], told
    assert told[3]["kind"] == "touching" and told[3]["volume"]["upper"] == 0 and "point" not in told[3], told[3]
    for one, (kind, volume, box) in zip(told, IN_COMMON.values()):
        assert one["kind"] == kind and one["volume"]["lower"] <= volume <= one["volume"]["upper"], one
        assert all(lower < x < upper for x, (lower, upper) in zip(one["point"], box)), one
    failures = [case.find("failure") for case in ElementTree.parse(folder / "k.xml").getroot().iter("testcase")]
    assert [one.get("message") for one in failures] == sentences
    assert failures[0].text.split("\n")[2:] == ["the volume that they have in common is 1", "both hold a point at (0, 0, 0)"], failures[0].text
    assert "in common is 0.065" in failures[2].text and "volume" not in failures[3].text, (failures[2].text, failures[3].text)
    topics = sorted(bcf_round_trip.record_of_xml(folder / "k.bcf").values(), key=lambda topic: topic["Index"])
    assert [topic["Title"] for topic in topics] == sentences
    assert [topic["Labels"] for topic in topics] == [["overlapping", "pierce"], ["overlapping", "protrude"], ["overlapping", "contains"], ["touching"]]
    assert [topic["Description"] for topic in topics] == [one.text.partition("\n")[2] for one in failures]
    with zipfile.ZipFile(folder / "k.bcf") as bcf:
        known = {one.text for one in ElementTree.fromstring(bcf.read("extensions.xml")).findall("TopicLabels/TopicLabel")}
    assert {label for topic in topics for label in topic["Labels"]} <= known, known
    run(folder, "clashes.json", "--junit", "k.xml", "--sarif", "k.sarif", code=1)
    told = [one["properties"] for one in json.loads((folder / "k.sarif").read_text())["runs"][0]["results"]]
    assert not any({"kind", "volume", "point"} & one.keys() for one in told), told
    assert "in common" not in (folder / "k.xml").read_text()


OPEN_BOX = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\nf 1 3 4 2\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
SCREW = "v 0.4 0.4 0.4\nv 0.6 0.4 0.4\nv 0.4 0.6 0.4\nv 0.4 0.4 0.6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"


def check_by_winding(folder):
    """What a winding number decides is told as such, in all three."""
    (folder / "open.obj").write_text(OPEN_BOX)
    (folder / "screw.obj").write_text(SCREW)
    run(folder, "open.obj", "screw.obj", "--solid", "by-winding", "--junit", "w.xml", "--sarif", "w.sarif", "--bcf", "w.bcf", code=1)
    words = "open contains screw (the mesh around it is open: by its generalised winding number, 0."
    [case] = ElementTree.parse(folder / "w.xml").getroot().findall("testsuite/testcase")
    assert case.find("failure").get("message").startswith(words) and case.find("failure").get("type") == "undecided", case.find("failure").attrib
    [result] = json.loads((folder / "w.sarif").read_text())["runs"][0]["results"]
    assert result["message"]["text"].startswith(words) and result["properties"]["winding"]["lower"] > 0.5, result
    with zipfile.ZipFile(folder / "w.bcf") as bcf:
        [topic] = [ElementTree.fromstring(bcf.read(name)).find("Topic") for name in bcf.namelist() if name.endswith("markup.bcf")]
    assert topic.find("Title").text.startswith(words), topic.find("Title").text


def check_refusals(folder):
    """What is not one of Toccata's is not written over, and nothing is written where the check fails."""
    (folder / "mine.xml").write_text("<mine/>")
    assert "not a JUnit report of Toccata" in run(folder, "the scene.json", "--junit", "mine.xml", code=2).stderr
    assert "--sarif" in run(folder, "the scene.json", "--sarif", "x.xml", "--junit", "x.xml", code=2).stderr
    run(folder, "the scene.json", "--clearance-of", "no,one=1", "--bcf", "none.bcf", code=2)
    assert not (folder / "none.bcf").exists()
    run(folder, "gen:box", "gen:box", "--pose-b", "9 0 0", "--junit", "nothing.xml", "--bcf", "nothing.bcf", code=0)
    [case] = ElementTree.parse(folder / "nothing.xml").getroot().iter("testcase")
    assert case.get("name") == "nothing collides" and len(case) == 0
    assert zipfile.ZipFile(folder / "nothing.bcf").namelist() == ["bcf.version"]
    assert "--bcf" in run(folder, "the scene.json", "--bcf-version", "3.0", code=2).stderr
    assert "3.0" in run(folder, "the scene.json", "--bcf", "none.bcf", "--bcf-version", "1.0", code=2).stderr


def read_by_another(folder):
    try:
        from bcf.bcfxml import load
    except ImportError:
        print("bcf-client is not installed (pip install bcf-client): BCF files are read by no second reader")
        sys.exit(77)
    for version in BCF_VERSIONS:
        with load(folder / f"found-{version}.bcf") as bcf:
            assert bcf.version.version_id == version
        topics = bcf_round_trip.check_round_trip(folder / f"found-{version}.bcf")
        assert len(topics) == 3 and any("protrudes into" in topic["Title"] for topic in topics.values()), topics
        assert all(len(topic["Viewpoints"]) == 1 and topic["Description"] for topic in topics.values()), topics
    print(f"bcf-client reads and saves the three topics of BCF {' and '.join(BCF_VERSIONS)}, and nothing they say is lost")


def validate(folder, schemas):
    """Every file of the zips, by the schema for its name."""
    import xmlschema
    of_name = {"bcf.version": "version", "extensions.xml": "extensions", "markup.bcf": "markup", "viewpoint.bcfv": "visinfo"}
    for version in BCF_VERSIONS:
        known = {name: xmlschema.XMLSchema(schemas / version / f"{of_name[name]}.xsd") for name in of_name
                 if version == "3.0" or name != "extensions.xml"}
        with zipfile.ZipFile(folder / f"found-{version}.bcf") as bcf:
            for name in bcf.namelist():
                known[name.rpartition("/")[2]].validate(bcf.read(name).decode())
            print(f"BCF {version}: {len(bcf.namelist())} files are valid")
        # What buildingSMART's schema of 2.1 demands and a copy of it with wider limits does not.
        for topic in bcf_round_trip.record_of_xml(folder / f"found-{version}.bcf").values():
            for view in topic["Viewpoints"].values():
                assert 45 <= view["FieldOfView"] <= 60, view
                assert all(re.fullmatch("([0-9A-F]{2})?[0-9A-F]{6}", colour) for colour in view["Coloring"]), view


BCF_VERSIONS = ("2.1", "3.0")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "the scene.json").write_text(SCENE)
        words = ["the scene.json", "--clearance", "2mm", "--fail-on", "hard", "--junit", "found.xml", "--sarif", "found.sarif"]
        more = ["--volume"] if len(sys.argv) > 2 else []
        for version in BCF_VERSIONS:
            run(folder, *words, *more, "--bcf", f"found-{version}.bcf", "--bcf-version", version, code=1)
        if "--reader" in sys.argv:
            return read_by_another(folder)
        if "--schemas" in sys.argv:
            return validate(folder, pathlib.Path(sys.argv[-1]))
        files = ["found.xml", "found.sarif", "found-2.1.bcf"]
        before = [(folder / file).read_bytes() for file in files]
        run(folder, *words, "--bcf", "found-2.1.bcf", "--threads", "1", code=1)
        assert before == [(folder / file).read_bytes() for file in files], "not the same twice"
        for check in (check_junit, check_sarif, check_sarif_baseline, check_bcf, check_cameras, check_tolerance, check_places,
                      check_kinds, check_by_winding, check_refusals):
            check(folder)


if __name__ == "__main__":
    main()
