#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <initializer_list>
#include <pugixml.hpp>
#include <sstream>
#include <string_view>

#include "exchange.hpp"
#include "finding_words.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/scene_file.hpp"
#include "words.hpp"
#include "zip_file.hpp"

// buildingSMART, "BIM Collaboration Format" (BCF-XML), versions 2.1 and 3.0: a zip with a folder for each topic, which
// holds its text and a place to look from.
namespace toccata::command {
namespace {

enum class BcfVersion { v2_1, v3_0 };

/// The kinds of topics, and where they stand: of 3.0 a file tells beforehand which it has.
constexpr const char *clash_type = "Clash", *remark_type = "Remark", *open_status = "Open", *closed_status = "Closed";
constexpr const char* author = "Toccata";

std::string text_of(const pugi::xml_document& document) {
  std::ostringstream text;
  document.save(text, " ", pugi::format_default, pugi::encoding_utf8);
  return text.str();
}

void add_text_node(pugi::xml_node node, const char* name, const std::string& text) {
  node.append_child(name).text().set(text.c_str());
}

/// As BCF writes one.
std::string guid_of(const std::string& words) {
  const std::string d = digits_of(words);
  return d.substr(0, 8) + "-" + d.substr(8, 4) + "-" + d.substr(12, 4) + "-" + d.substr(16, 4) + "-" + d.substr(20, 12);
}

std::time_t seconds_of(std::string_view text) {
  constexpr std::time_t end_of_9999 = 253402300799;
  std::time_t seconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (error != std::errc() || end != text.data() + text.size() || seconds < 0 || seconds > end_of_9999)
    throw Error(fmt::format("SOURCE_DATE_EPOCH is '{}': give seconds since 1970, as a whole number", text));
  return seconds;
}

/// The date of now, or of what SOURCE_DATE_EPOCH says, so that a file can be made twice.
std::string date_text() {
  std::time_t seconds = std::time(nullptr);
  if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH"); fixed != nullptr && *fixed != '\0')
    seconds = seconds_of(fixed);
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

double metres_of(const std::string& unit) {
  if (unit == "unit") return 1;
  return metres_per_unit(unit.ends_with(" m") ? unit.substr(0, unit.size() - 2) : unit);
}

/// Empty but for what XML begins with.
pugi::xml_document begun_document() {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version").set_value("1.0");
  declaration.append_attribute("encoding").set_value("UTF-8");
  return document;
}

std::string version_xml(BcfVersion version) {
  pugi::xml_document document = begun_document();
  document.append_child(pugi::node_comment).set_value(" BCF of Toccata ");
  pugi::xml_node version_node = document.append_child("Version");
  version_node.append_attribute("VersionId").set_value(version == BcfVersion::v2_1 ? "2.1" : "3.0");
  if (version == BcfVersion::v2_1) add_text_node(version_node, "DetailedVersion", "2.1");
  return text_of(document);
}

/// Which words the topics of a file have, where their version asks for them.
std::string extensions_xml() {
  pugi::xml_document document = begun_document();
  pugi::xml_node extensions = document.append_child("Extensions");
  const auto add_list = [&](const char* list, const char* entry, std::initializer_list<const char*> words) {
    pugi::xml_node node = extensions.append_child(list);
    for (const char* word : words) add_text_node(node, entry, word);
  };
  add_list("TopicTypes", "TopicType", {clash_type, remark_type});
  add_list("TopicStatuses", "TopicStatus", {open_status, closed_status});
  add_list(
      "TopicLabels", "TopicLabel",
      {"overlapping", "crossing", "touching", "clearance", "undecided", "protrude", "pierce", "contains", "equal"});
  add_list("Users", "User", {author});
  return text_of(document);
}

/// What every topic begins with.
pugi::xml_node begin_topic(pugi::xml_node markup, const std::string& guid, const char* type, const char* status) {
  pugi::xml_node topic = markup.append_child("Topic");
  topic.append_attribute("Guid").set_value(guid.c_str());
  topic.append_attribute("TopicType").set_value(type);
  topic.append_attribute("TopicStatus").set_value(status);
  return topic;
}

void add_creation(pugi::xml_node topic) {
  add_text_node(topic, "CreationDate", date_text());
  add_text_node(topic, "CreationAuthor", author);
}

constexpr const char* viewpoint_file = "viewpoint.bcfv";

std::string viewpoint_guid(const std::string& topic) { return guid_of("viewpoint of " + topic); }

void add_viewpoint(pugi::xml_node parent, const char* name, const std::string& topic) {
  pugi::xml_node viewpoint = parent.append_child(name);
  viewpoint.append_attribute("Guid").set_value(viewpoint_guid(topic).c_str());
  add_text_node(viewpoint, "Viewpoint", viewpoint_file);
}

void add_labels(BcfVersion version, pugi::xml_node topic, const std::vector<std::string>& labels) {
  const bool is_list = version == BcfVersion::v3_0;
  pugi::xml_node parent = is_list ? topic.append_child("Labels") : topic;
  for (const std::string& label : labels) add_text_node(parent, is_list ? "Label" : "Labels", label);
}

std::string markup_xml(BcfVersion version, const Findings& findings, const ReportedPair& pair, std::size_t number,
                       const std::string& guid) {
  const Scene& scene = findings.input.loaded.scene;
  pugi::xml_document document = begun_document();
  pugi::xml_node markup = document.append_child("Markup");
  pugi::xml_node topic = begin_topic(markup, guid, clash_type, is_clash(pair) ? open_status : closed_status);
  add_text_node(topic, "Title", sentence_of(scene, pair));
  add_text_node(topic, "Index", fmt::format("{}", number));
  add_labels(version, topic, labels_of(pair, findings.report.has_volume));
  add_creation(topic);
  const std::vector<std::string> details = details_of(scene, pair, findings.report.baseline.has_value());
  if (!details.empty()) add_text_node(topic, "Description", fmt::format("{}", fmt::join(details, "\n")));
  if (version == BcfVersion::v2_1)
    add_viewpoint(markup, "Viewpoints", guid);
  else
    add_viewpoint(topic.append_child("Viewpoints"), "ViewPoint", guid);
  return text_of(document);
}

/// A topic that says that the others are not all.
std::string unfinished_markup_xml(std::size_t unfinished, const std::string& guid) {
  pugi::xml_document document = begun_document();
  pugi::xml_node topic = begin_topic(document.append_child("Markup"), guid, remark_type, open_status);
  add_text_node(topic, "Title",
                fmt::format("The check was stopped: {} not looked at, these are not all", counted(unfinished, "pair")));
  add_creation(topic);
  return text_of(document);
}

/// The identifier of an IFC element that a name ends with in brackets, "Wall [2O2Fr$t4X7Zf8NOew3FLOH]"; or empty.
std::string ifc_guid_in(const std::string& name) {
  constexpr std::size_t length = 22;
  if (name.size() < length + 2 || name.back() != ']' || name[name.size() - length - 2] != '[') return {};
  const std::string guid = name.substr(name.size() - length - 1, length);
  const bool is_one = std::all_of(guid.begin(), guid.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$';
  });
  return is_one ? guid : "";
}

void add_component(pugi::xml_node parent, const std::string& name) {
  pugi::xml_node component = parent.append_child("Component");
  if (const std::string guid = ifc_guid_in(name); !guid.empty())
    component.append_attribute("IfcGuid").set_value(guid.c_str());
  add_text_node(component, "OriginatingSystem", "Toccata");
  add_text_node(component, "AuthoringToolId", printable(name));
}

void add_vector(pugi::xml_node parent, const char* name, const Vec3& v) {
  pugi::xml_node node = parent.append_child(name);
  add_text_node(node, "X", fmt::format("{}", v.x));
  add_text_node(node, "Y", fmt::format("{}", v.y));
  add_text_node(node, "Z", fmt::format("{}", v.z));
}

/// From the south-east and above, so far that the place takes about a third of the picture.
void add_camera(BcfVersion version, pugi::xml_node parent, const Aabb& place) {
  constexpr double third = 2.6;  // of the half diagonal, at 60 degrees
  const Vec3 middle = 0.5 * (place.lower + place.upper), half = 0.5 * (place.upper - place.lower);
  const double size = std::max(length(half), 1e-3);
  const Vec3 direction = normalized(Vec3{-1, 1, -0.8});
  pugi::xml_node camera = parent.append_child("PerspectiveCamera");
  add_vector(camera, "CameraViewPoint", middle - 2 * third * size * direction);
  add_vector(camera, "CameraDirection", direction);
  const Vec3 side = normalized(cross(direction, Vec3{0, 0, 1}));
  add_vector(camera, "CameraUpVector", cross(side, direction));
  add_text_node(camera, "FieldOfView", "60");
  if (version == BcfVersion::v3_0) add_text_node(camera, "AspectRatio", "1");
}

std::string viewpoint_xml(BcfVersion version, const Scene& scene, const ReportedPair& pair, const std::string& guid) {
  const std::string &a = scene.objects[pair.a].name, &b = scene.objects[pair.b].name;
  pugi::xml_document document = begun_document();
  pugi::xml_node view = document.append_child("VisualizationInfo");
  view.append_attribute("Guid").set_value(viewpoint_guid(guid).c_str());
  pugi::xml_node components = view.append_child("Components");
  pugi::xml_node selection = components.append_child("Selection");
  add_component(selection, a);
  add_component(selection, b);
  components.append_child("Visibility").append_attribute("DefaultVisibility").set_value("true");
  pugi::xml_node colouring = components.append_child("Coloring");
  for (const auto& [colour, name] : {std::pair("FF56B4E9", &a), std::pair("FFE69F00", &b)}) {
    pugi::xml_node one = colouring.append_child("Color");
    one.append_attribute("Color").set_value(colour);
    add_component(version == BcfVersion::v2_1 ? one : one.append_child("Components"), *name);
  }
  const double metres = metres_of(scene.unit);
  const Aabb place = place_of(scene, pair);
  add_camera(version, view, {metres * place.lower, metres * place.upper});
  return text_of(document);
}

}  // namespace

std::string bcf_zip(const Findings& findings) {
  const Scene& scene = findings.input.loaded.scene;
  const BcfVersion version = findings.arguments.exchange.bcf_version == "3.0" ? BcfVersion::v3_0 : BcfVersion::v2_1;
  // First, and not compressed: by its comment a file of Toccata is known again.
  std::vector<ZipEntry> entries{{"bcf.version", version_xml(version), ZipStored::as_it_is}};
  if (version == BcfVersion::v3_0) entries.push_back({"extensions.xml", extensions_xml()});
  for (std::size_t i = 0; i < findings.report.pairs.size(); ++i) {
    const ReportedPair& pair = findings.report.pairs[i];
    const std::string guid = guid_of(scene.objects[pair.a].name + '\0' + scene.objects[pair.b].name);
    entries.push_back({guid + "/markup.bcf", markup_xml(version, findings, pair, i, guid)});
    entries.push_back({guid + "/" + viewpoint_file, viewpoint_xml(version, scene, pair, guid)});
  }
  if (findings.report.unfinished > 0) {
    const std::string guid = guid_of("stopped");
    entries.push_back({guid + "/markup.bcf", unfinished_markup_xml(findings.report.unfinished, guid)});
  }
  return zip_of(entries);
}

}  // namespace toccata::command
