"""What a BCF file says, read from its XML and by bcf-client (PyPI), so that the two and what that one saves can be compared."""
import pathlib
import xml.etree.ElementTree as ElementTree
import zipfile

AXES = "XYZ"
CAMERA = ("CameraViewPoint", "CameraDirection", "CameraUpVector")


def record_of_xml(path):
    """The topics of a file by their identifiers, as the file itself says, in what both versions have."""
    with zipfile.ZipFile(path) as bcf:
        return {name.split("/")[0]: topic_of_xml(bcf, name) for name in bcf.namelist() if name.endswith("/markup.bcf")}


def texts(node, *paths):
    """Of the first of the paths that is there."""
    return next((found for path in paths if (found := [one.text for one in node.findall(path)])), [])


def topic_of_xml(bcf, name):
    markup = ElementTree.fromstring(bcf.read(name))
    topic = markup.find("Topic")
    said = {field: topic.findtext(field) for field in ("Title", "Description", "CreationDate", "CreationAuthor")}
    viewpoints = markup.findall("Viewpoints") + topic.findall("Viewpoints/ViewPoint")
    return {**said, "Guid": topic.get("Guid"), "TopicType": topic.get("TopicType"), "TopicStatus": topic.get("TopicStatus"),
            "Index": int(topic.findtext("Index")),
            "Labels": texts(topic, "Labels/Label", "Labels"),
            "Comments": texts(markup, "Topic/Comments/Comment/Comment", "Comment/Comment"),
            "Viewpoints": {one.get("Guid"): viewpoint_of_xml(bcf, f"{name.split('/')[0]}/{one.findtext('Viewpoint')}") for one in viewpoints}}


def viewpoint_of_xml(bcf, name):
    view = ElementTree.fromstring(bcf.read(name))
    camera = view.find("PerspectiveCamera")
    aspect = camera.findtext("AspectRatio")
    colours = view.findall("Components/Coloring/Color")
    return {"Guid": view.get("Guid"),
            **{part: [float(camera.findtext(f"{part}/{axis}")) for axis in AXES] for part in CAMERA},
            "FieldOfView": float(camera.findtext("FieldOfView")),
            "AspectRatio": None if aspect is None else float(aspect),
            "Selection": [component_of_xml(one) for one in view.findall("Components/Selection/Component")],
            "DefaultVisibility": view.find("Components/Visibility").get("DefaultVisibility") == "true",
            "Coloring": {one.get("Color"): [component_of_xml(part) for part in one.iter("Component")] for one in colours}}


def component_of_xml(component):
    return component.get("IfcGuid"), component.findtext("OriginatingSystem"), component.findtext("AuthoringToolId")


def record_of_reader(bcf):
    """The same of a file that bcf-client has loaded, which keeps the two versions apart."""
    return {guid: topic_of_reader(handler) for guid, handler in bcf.topics.items()}


def topic_of_reader(handler):
    topic = handler.topic
    labels = topic.labels if isinstance(topic.labels, list) else topic.labels.label
    references = handler.markup.viewpoints if hasattr(handler.markup, "viewpoints") else topic.viewpoints.view_point
    return {"Title": topic.title, "Description": topic.description, "CreationDate": str(topic.creation_date), "CreationAuthor": topic.creation_author,
            "Guid": topic.guid, "TopicType": topic.topic_type, "TopicStatus": topic.topic_status,
            "Index": topic.index, "Labels": labels, "Comments": [one.comment for one in handler.comments],
            "Viewpoints": {one.guid: viewpoint_of_reader(handler.viewpoints[one.viewpoint].visualization_info) for one in references}}


def viewpoint_of_reader(view):
    camera, components = view.perspective_camera, view.components
    vectors = (camera.camera_view_point, camera.camera_direction, camera.camera_up_vector)
    return {"Guid": view.guid,
            **{part: [vector.x, vector.y, vector.z] for part, vector in zip(CAMERA, vectors)},
            "FieldOfView": camera.field_of_view,
            "AspectRatio": getattr(camera, "aspect_ratio", None),
            "Selection": [component_of_reader(one) for one in components.selection.component],
            "DefaultVisibility": components.visibility.default_visibility,
            "Coloring": {one.color: [component_of_reader(part) for part in (one.components.component if hasattr(one, "components") else one.component)]
                         for one in components.coloring.color}}


def component_of_reader(component):
    return component.ifc_guid, component.originating_system, component.authoring_tool_id


def with_comment(handler, text):
    """As who works through the list in another program leaves one; what their version of the format names it."""
    import importlib
    from xsdata.models.datatype import XmlDateTime
    model = importlib.import_module(type(handler).__module__.rpartition(".")[0] + ".model")
    handler.comments = [model.Comment(date=XmlDateTime.from_string("2026-01-02T03:04:05Z"), author="someone", comment=text,
                                      guid="01234567-89ab-4def-8123-456789abcdef")]


def check_round_trip(path):
    """Read, saved, and read again by bcf-client, a file says what it said, and one comment more where that was added."""
    from bcf.bcfxml import load
    written = record_of_xml(path)
    saved, remarked = (pathlib.Path(path).with_suffix(f".{word}.bcf") for word in ("saved", "remarked"))
    with load(path) as bcf:
        assert_same(record_of_reader(bcf), written, "as bcf-client reads it")
        bcf.save(saved)
    assert_same(record_of_xml(saved), written, "as bcf-client saves it")
    with load(saved) as bcf:
        assert_same(record_of_reader(bcf), written, "as bcf-client reads what it saved")
        guid = next(iter(bcf.topics))
        with_comment(bcf.topics[guid], "moved the pipe <up>")
        bcf.save(remarked)
    with load(remarked) as bcf:
        assert_same(record_of_reader(bcf), {**written, guid: {**written[guid], "Comments": ["moved the pipe <up>"]}}, "with a comment")
    return written


def assert_same(found, written, how):
    """All that differs is told, by topic and field."""
    assert found.keys() == written.keys(), (how, found.keys(), written.keys())
    differing = [(how, guid, field, found[guid][field], written[guid][field]) for guid in written for field in written[guid]
                 if found[guid][field] != written[guid][field]]
    assert not differing, differing
