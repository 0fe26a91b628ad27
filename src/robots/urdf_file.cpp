#include "toccata/robots/robot_files.hpp"

#include "toccata/core/error.hpp"

#ifndef TOCCATA_WITH_URDFDOM

namespace toccata {
namespace {

Error no_urdfdom(const std::string& path) {
  return Error(path +
               ": URDF and SRDF files are read with urdfdom, which this library was built without; `apt-get install "
               "liburdfdom-dev`, and build it again");
}

}  // namespace

bool reads_urdf() { return false; }
RobotFile read_urdf(const std::string& path, const UrdfOptions&) { throw no_urdfdom(path); }
std::vector<AllowedPair> read_srdf(const std::string& path, const Robot&) { throw no_urdfdom(path); }

}  // namespace toccata

#else

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <tinyxml.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <locale>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "io/formats/file_bytes.hpp"
#include "robots/mesh_place.hpp"
#include "robots/tree_building.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata {
namespace {

namespace fs = std::filesystem;

/// What urdfdom complains about goes here, and not to the terminal. One at a time: its place is the process's.
class UrdfdomComplaints : public console_bridge::OutputHandler {
 public:
  UrdfdomComplaints() : lock_(one_at_a_time()) { console_bridge::useOutputHandler(this); }
  ~UrdfdomComplaints() override { console_bridge::restorePreviousOutputHandler(); }
  UrdfdomComplaints(const UrdfdomComplaints&) = delete;
  UrdfdomComplaints& operator=(const UrdfdomComplaints&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) all_.push_back(text);
  }
  /// In the order in which they came: what is wrong comes first, and where that is may come later.
  [[nodiscard]] const std::vector<std::string>& all() const { return all_; }
  [[nodiscard]] std::string first() const {
    return all_.empty() ? "urdfdom does not read it, and does not say why" : all_.front();
  }

 private:
  static std::mutex& one_at_a_time() {
    static std::mutex mutex;
    return mutex;
  }

  std::lock_guard<std::mutex> lock_;
  std::vector<std::string> all_;
};

/// What iconv calls an encoding of more bytes a character: by the mark of their order, or by the "<" that XML begins
/// with. Empty for any other.
std::string_view wide_encoding(std::string_view text) {
  using namespace std::string_view_literals;
  // The longer ones begin as the shorter ones do.
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> beginnings{{{"\xff\xfe\0\0"sv, "UTF-32"},
                                                                                     {"\0\0\xfe\xff"sv, "UTF-32"},
                                                                                     {"<\0\0\0"sv, "UTF-32LE"},
                                                                                     {"\0\0\0<"sv, "UTF-32BE"},
                                                                                     {"\xff\xfe"sv, "UTF-16"},
                                                                                     {"\xfe\xff"sv, "UTF-16"},
                                                                                     {"<\0"sv, "UTF-16LE"},
                                                                                     {"\0<"sv, "UTF-16BE"}}};
  for (const auto& [beginning, name] : beginnings)
    if (text.starts_with(beginning)) return name;
  return {};
}

/// Where a comment begins that does not end; else npos.
std::size_t open_comment(std::string_view text) {
  for (std::size_t at = text.find("<!--"); at != std::string_view::npos; at = text.find("<!--", at)) {
    const std::size_t end = text.find("-->", at + 4);
    if (end == std::string_view::npos) return at;
    at = end;
  }
  return std::string::npos;
}

/// An XML file of a robot: URDF or SRDF.
class RobotXml {
 public:
  explicit RobotXml(const std::string& path) : path_(path) {
    if (path.ends_with(".xacro")) throw Error(path + fault_of_macros());
    const io::FileBytes bytes = io::read_file(path);
    text_.assign(bytes.span().begin(), bytes.span().end());
    if (const std::string_view encoding = wide_encoding(text_); !encoding.empty())
      throw Error(fmt::format("{}: it is written in {}, and UTF-8 is read; convert it (iconv -f {} -t UTF-8)", path,
                              encoding, encoding));
    document_.Parse(text_.c_str());
    if (document_.Error()) throw Error(path + fault_of_xml());
    const TiXmlElement* root = document_.RootElement();
    if (root == nullptr && open_comment(text_) != std::string::npos) throw Error(path + fault_of_comment());
    if (root == nullptr || root->ValueStr() != "robot")
      throw Error(fmt::format("{}: its root element is {}, and that of a robot is <robot>", path,
                              root == nullptr ? "missing" : "<" + root->ValueStr() + ">"));
    if (const TiXmlElement* macro = first_macro(*root))
      throw error_at(*macro, "<" + macro->ValueStr() + ">" + fault_of_macros());
  }

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const TiXmlElement& robot() const { return *document_.RootElement(); }

  /// The elements of that name below another.
  [[nodiscard]] static std::vector<const TiXmlElement*> below(const TiXmlElement& parent, const char* name) {
    std::vector<const TiXmlElement*> found;
    for (const TiXmlElement* e = parent.FirstChildElement(name); e != nullptr; e = e->NextSiblingElement(name))
      found.push_back(e);
    return found;
  }

  /// Calls `visit(element, owner)` for each element below a link or a joint, in order; the owner is "joint 'turn'".
  template <class Visit>
  void visit_parts(const Visit& visit) const {
    for (const TiXmlElement* e = robot().FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
      const char* name = e->Attribute("name");
      if (name != nullptr && (e->ValueStr() == "link" || e->ValueStr() == "joint"))
        visit_below(*e, fmt::format("{} '{}'", e->ValueStr(), name), visit);
    }
  }

  [[nodiscard]] Error error_at(const TiXmlElement& element, std::string_view what) const {
    return Error(fmt::format("{}:{}: {}", path_, element.Row(), what));
  }

  [[nodiscard]] std::string attribute(const TiXmlElement& element, const char* name) const {
    if (const char* value = element.Attribute(name)) return value;
    throw error_at(element, fmt::format("<{}> has no attribute {}", element.ValueStr(), name));
  }

  /// An error that names a link or joint, with its line.
  [[nodiscard]] Error error_about(std::string_view what) const {
    if (const TiXmlElement* element = named_in(what)) return error_at(*element, what);
    return Error(fmt::format("{}: {}", path_, what));
  }

  /// The link or joint that a text names; null where it names none.
  [[nodiscard]] const TiXmlElement* named_in(std::string_view what) const {
    for (const char* kind : {"joint", "link"})
      for (const TiXmlElement* element : below(robot(), kind)) {
        const char* name = element->Attribute("name");
        if (name == nullptr) continue;
        for (const char* form : {"{} '{}'", "{} [{}]"})
          if (what.find(fmt::format(fmt::runtime(form), kind, name)) != std::string_view::npos ||
              what.find(fmt::format(fmt::runtime(form), kind == std::string_view("joint") ? "Joint" : "Link", name)) !=
                  std::string_view::npos)
            return element;
      }
    return nullptr;
  }

  /// Where an attribute is that a text tells, as "multiplier value (fast)", without saying of what: an error with its
  /// line; none where it is nowhere.
  [[nodiscard]] std::optional<Error> error_of_attribute_in(std::string_view what) const {
    std::optional<Error> found;
    visit_parts([&](const TiXmlElement& element, const std::string& owner) {
      for (const TiXmlAttribute* a = element.FirstAttribute(); a != nullptr && !found; a = a->Next())
        if (what.find(fmt::format("{} value ({})", a->Name(), a->ValueStr())) != std::string_view::npos)
          found = error_at(element, fmt::format("{}: <{}>: {}", owner, element.ValueStr(), what));
    });
    return found;
  }

 private:
  template <class Visit>
  static void visit_below(const TiXmlElement& parent, const std::string& owner, const Visit& visit) {
    for (const TiXmlElement* e = parent.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
      visit(*e, owner);
      visit_below(*e, owner, visit);
    }
  }

  /// The first element that xacro, a tool of ROS, has to expand; null where there is none.
  [[nodiscard]] static const TiXmlElement* first_macro(const TiXmlElement& parent) {
    for (const TiXmlElement* e = parent.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
      if (e->ValueStr().starts_with("xacro:")) return e;
      if (const TiXmlElement* within = first_macro(*e)) return within;
    }
    return nullptr;
  }

  [[nodiscard]] std::string fault_of_macros() const {
    std::string plain = path_.ends_with(".xacro") ? path_.substr(0, path_.rfind('.')) : "expanded";
    if (!plain.ends_with(".urdf")) plain += ".urdf";
    return fmt::format(": xacro macros are not expanded here; expand them first (`xacro {} > {}`) and give that file",
                       path_, plain);
  }

  [[nodiscard]] std::string fault_of_comment() const {
    const auto begin = static_cast<std::ptrdiff_t>(open_comment(text_));
    return fmt::format(":{}: the comment that begins here is not closed by -->",
                       1 + std::count(text_.begin(), text_.begin() + begin, '\n'));
  }

  /// What follows the path: the line, and what is wrong. TinyXML tells line 0 of what goes wrong where the text ends.
  [[nodiscard]] std::string fault_of_xml() const {
    if (document_.ErrorId() == TiXmlBase::TIXML_ERROR_DOCUMENT_EMPTY) return ": this is no XML: no element is in it";
    if (document_.ErrorRow() > 0)
      return fmt::format(":{}: this is no XML: {}", document_.ErrorRow(), document_.ErrorDesc());
    if (open_comment(text_) != std::string::npos) return fault_of_comment();
    const auto lines = 1 + std::count(text_.begin(), text_.end(), '\n') - (text_.ends_with('\n') ? 1 : 0);
    return fmt::format(":{}: the XML ends here, and an element is still open; export it again", lines);
  }

  std::string path_, text_;
  TiXmlDocument document_;
};

RobotJointKind kind_of_joint(const RobotXml& xml, const TiXmlElement& joint) {
  constexpr std::size_t kinds = 6;
  const std::string type = xml.attribute(joint, "type");
  std::vector<std::string> known;
  for (std::size_t i = 0; i < kinds; ++i) {
    const auto kind = static_cast<RobotJointKind>(i);
    if (name_of(kind) == type) return kind;
    known.emplace_back(name_of(kind));
  }
  throw xml.error_at(joint, fmt::format("joint '{}' is of the type '{}', which there is not{}",
                                        xml.attribute(joint, "name"), type, suggestion(type, known)));
}

std::string linked(const RobotXml& xml, const TiXmlElement& joint, const char* end) {
  const TiXmlElement* element = joint.FirstChildElement(end);
  if (element == nullptr)
    throw xml.error_at(joint, fmt::format("joint '{}' has no <{} link=\"…\"/>", xml.attribute(joint, "name"), end));
  return xml.attribute(*element, "link");
}

/// The first of such elements of a robot; none where there is none.
const TiXmlElement* first_of(const RobotXml& xml, std::initializer_list<const char*> names) {
  for (const TiXmlElement* e = xml.robot().FirstChildElement(); e != nullptr; e = e->NextSiblingElement())
    for (const char* name : names)
      if (e->ValueStr() == name) return e;
  return nullptr;
}

/// Both formats have <robot> as their root.
void require_urdf(const RobotXml& xml) {
  if (first_of(xml, {"link", "joint"}) != nullptr) return;
  const TiXmlElement* found = first_of(xml, {"disable_collisions", "disable_default_collisions", "enable_collisions",
                                             "group", "group_state", "virtual_joint", "end_effector", "passive_joint"});
  if (found != nullptr)
    throw xml.error_at(*found,
                       fmt::format("<{}> is of an SRDF file, which tells what is not looked at; the robot, with "
                                   "its links and joints, is in a URDF file: name that one",
                                   found->ValueStr()));
}

void require_srdf(const RobotXml& xml) {
  if (const TiXmlElement* found = first_of(xml, {"link", "joint"}))
    throw xml.error_at(*found, fmt::format("<{}> is of a URDF file, a robot; pairs of links that are not looked at are "
                                           "in an SRDF file: name that one",
                                           found->ValueStr()));
}

/// What hangs on what, without shapes and numbers.
RobotDescription skeleton_of(const RobotXml& xml) {
  RobotDescription robot;
  if (const char* name = xml.robot().Attribute("name")) robot.name = name;
  for (const TiXmlElement* link : RobotXml::below(xml.robot(), "link"))
    robot.links.push_back({xml.attribute(*link, "name")});
  for (const TiXmlElement* joint : RobotXml::below(xml.robot(), "joint"))
    robot.joints.push_back({.name = xml.attribute(*joint, "name"),
                            .kind = kind_of_joint(xml, *joint),
                            .parent = linked(xml, *joint, "parent"),
                            .child = linked(xml, *joint, "child")});
  return robot;
}

/// Throws Error with the line where links and joints are no tree.
void require_tree(const RobotXml& xml, const RobotDescription& skeleton) {
  try {
    static_cast<void>(robot_tree_of(skeleton, own_thread));
  } catch (const Error& error) {
    throw xml.error_about(error.what());
  }
}

/// urdfdom leaves out a <collision> that it does not understand, complains, and goes on.
void require_collisions(const RobotXml& xml, const urdf::ModelInterface& model, const std::string& complaint) {
  for (const TiXmlElement* element : RobotXml::below(xml.robot(), "link")) {
    const std::string name = xml.attribute(*element, "name");
    const std::size_t written = RobotXml::below(*element, "collision").size();
    if (written != model.getLink(name)->collision_array.size())
      throw xml.error_at(*element, fmt::format("not each <collision> of link '{}' is understood: {}", name, complaint));
  }
}

/// What urdfdom complained about first, and with the line of what it names then or later.
Error error_of(const RobotXml& xml, const UrdfdomComplaints& complaints) {
  const std::string first = complaints.first();
  for (const std::string& complaint : complaints.all())
    if (const TiXmlElement* element = xml.named_in(complaint))
      return xml.error_at(*element, complaint == first ? first : fmt::format("{}: {}", complaint, first));
  if (const std::optional<Error> error = xml.error_of_attribute_in(first)) return *error;
  return xml.error_about(first);
}

urdf::ModelInterfaceSharedPtr model_of(const RobotXml& xml) {
  UrdfdomComplaints complaints;
  urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(xml.text());
  if (!model) throw error_of(xml, complaints);
  require_collisions(xml, *model, complaints.first());
  return model;
}

Vec3 vector_of(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Pose pose_of_urdf(const urdf::Pose& pose) {
  const auto& [x, y, z, w] = pose.rotation;
  return Pose::rigid({x, y, z, w}, vector_of(pose.position));
}

/// Reads the shapes of one URDF file.
class UrdfShapes {
 public:
  UrdfShapes(const RobotXml& xml, const UrdfOptions& options, std::vector<std::string>& warnings)
      : folder_(fs::path(xml.path()).parent_path()), options_(options), warnings_(warnings) {}

  std::vector<LinkShape> of(const urdf::Link& link) {
    std::vector<LinkShape> shapes;
    for (const urdf::CollisionSharedPtr& collision : link.collision_array) {
      if (!collision || !collision->geometry)
        throw Error(fmt::format("link '{}' has a collision element without a geometry", link.name));
      const Pose origin = pose_of_urdf(collision->origin);
      for (LinkShape& shape : of(*collision->geometry, link.name)) {
        shape.pose = origin * shape.pose;
        if (link.collision_array.size() > 1 && !collision->name.empty())
          shape.name = fmt::format("{}, {}", link.name, collision->name);
        shapes.push_back(std::move(shape));
      }
    }
    if (shapes.empty() && !link.visual_array.empty())
      warnings_.push_back(fmt::format(
          "link '{}' has a picture and no collision shape: it meets nothing; give it a <collision>", link.name));
    return shapes;
  }

 private:
  std::vector<LinkShape> of(const urdf::Geometry& geometry, const std::string& link) {
    if (geometry.type == urdf::Geometry::SPHERE) return {{Sphere(static_cast<const urdf::Sphere&>(geometry).radius)}};
    if (geometry.type == urdf::Geometry::BOX)
      return {{Box(0.5 * vector_of(static_cast<const urdf::Box&>(geometry).dim))}};
    if (geometry.type == urdf::Geometry::CYLINDER) {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
      return {{Cylinder(cylinder.radius, 0.5 * cylinder.length)}};
    }
    return of_mesh(static_cast<const urdf::Mesh&>(geometry), link);
  }

  std::vector<LinkShape> of_mesh(const urdf::Mesh& mesh, const std::string& link) {
    const fs::path place = mesh_place(mesh.filename, folder_, options_.package_folders);
    const std::string extension = io::lower_case_extension(place);
    if (extension == ".dae")
      throw Error(fmt::format("'{}' is COLLADA, which is not read; convert it to STL, OBJ or glTF", place.string()));
    if (extension == ".json") throw Error(fmt::format("'{}' is no mesh", place.string()));
    const Vec3 scale = vector_of(mesh.scale);
    if (!is_finite(scale) || scale.x == 0 || scale.y == 0 || scale.z == 0)
      throw Error(fmt::format("the scale of '{}' is {} {} {}; no number of it may be 0", mesh.filename, scale.x,
                              scale.y, scale.z));
    if ((extension == ".gltf" || extension == ".glb") && told_.insert(place.string()).second)
      warnings_.push_back(
          fmt::format("'{}' is glTF, whose y axis points up by its standard: its numbers are taken as "
                      "they are",
                      place.string()));
    std::vector<LinkShape> shapes;
    for (const SceneObject& object : scene_of(place).objects)
      shapes.push_back({object.shape, pose_of({}, {}, scale) * object.pose, object.solid});
    warn_of_size(shapes, link, place.string());
    return shapes;
  }

  /// A file that several links name is read once.
  const Scene& scene_of(const fs::path& place) {
    const auto found = scenes_.find(place.string());
    return found != scenes_.end() ? found->second
                                  : scenes_.emplace(place.string(), read_scene(place.string())).first->second;
  }

  void warn_of_size(const std::vector<LinkShape>& shapes, const std::string& link, const std::string& place) {
    constexpr double large = 20, small = 0.0005;
    Aabb box;
    for (const LinkShape& shape : shapes)
      for (const Vec3& vertex : mesh_of(shape.shape)->vertices()) box = merge(box, shape.pose * vertex);
    if (is_empty(box)) return;
    const double across = length(box.upper - box.lower);
    if (across > large)
      warnings_.push_back(
          fmt::format("link '{}': its mesh '{}' is {:.3g} m across; if its numbers are millimetres, "
                      "write scale=\"0.001 0.001 0.001\"",
                      link, place, across));
    if (across < small)
      warnings_.push_back(fmt::format("link '{}': its mesh '{}' is only {:.3g} mm across; is its scale right?", link,
                                      place, 1000 * across));
  }

  fs::path folder_;
  const UrdfOptions& options_;
  std::vector<std::string>& warnings_;
  std::map<std::string, Scene> scenes_;
  std::set<std::string> told_;
};

void add_numbers(const urdf::Joint& from, RobotJoint& joint) {
  joint.origin = pose_of_urdf(from.parent_to_joint_origin_transform);
  joint.axis = vector_of(from.axis);
  const bool has_limits = joint.kind == RobotJointKind::revolute || joint.kind == RobotJointKind::prismatic;
  if (from.limits && has_limits) joint.limits = JointLimits{from.limits->lower, from.limits->upper};
  if (from.mimic) joint.mimic = JointMimic{from.mimic->joint_name, from.mimic->multiplier, from.mimic->offset};
}

/// Whether this urdfdom reads the rotation of an origin from the attribute quat_xyzw, as later ones do.
bool reads_quaternions() {
  const UrdfdomComplaints complaints;
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(
      "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" type=\"fixed\"><parent link=\"a\"/>"
      "<child link=\"b\"/><origin quat_xyzw=\"1 0 0 0\"/></joint></robot>");
  return model && model->getJoint("j")->parent_to_joint_origin_transform.rotation.x != 0;
}

/// What of an element is read, or says nothing about shapes and places; empty: nothing is known of it.
std::vector<std::string> attributes_of(std::string_view element) {
  if (element == "origin") return {"xyz", "rpy"};
  if (element == "axis") return {"xyz"};
  if (element == "limit") return {"lower", "upper", "effort", "velocity", "acceleration", "deceleration", "jerk"};
  if (element == "mimic") return {"joint", "multiplier", "offset"};
  if (element == "box") return {"size"};
  if (element == "sphere") return {"radius"};
  if (element == "cylinder") return {"radius", "length"};
  if (element == "mesh") return {"filename", "scale"};
  return {};
}

/// Attributes that nobody reads, which the writer may have meant: of each kind the first is told.
void warn_of_attributes(const RobotXml& xml, std::vector<std::string>& warnings) {
  std::set<std::pair<std::string, std::string> > told;
  xml.visit_parts([&](const TiXmlElement& element, const std::string& owner) {
    const std::vector<std::string> known = attributes_of(element.ValueStr());
    for (const TiXmlAttribute* a = element.FirstAttribute(); a != nullptr && !known.empty(); a = a->Next()) {
      const std::string name = a->Name();
      if (std::ranges::find(known, name) != known.end() || name.find(':') != std::string::npos) continue;
      const bool is_quaternion = name == "quat_xyzw";
      if ((is_quaternion && reads_quaternions()) || !told.emplace(element.ValueStr(), name).second) continue;
      warnings.push_back(fmt::format(
          "line {}: {}: the attribute {} of <{}> is not read{}", element.Row(), owner, name, element.ValueStr(),
          is_quaternion ? "; write the rotation as rpy=\"roll pitch yaw\", in radians" : suggestion(name, known)));
    }
  });
}

/// Angles of more than a whole turn are most likely degrees: the first is told.
void warn_of_degrees(const RobotXml& xml, std::vector<std::string>& warnings) {
  constexpr double whole_turn = 6.2831853071795865;
  bool is_told = false;
  xml.visit_parts([&](const TiXmlElement& element, const std::string& owner) {
    const char* angles = element.ValueStr() == "origin" ? element.Attribute("rpy") : nullptr;
    if (angles == nullptr || is_told) return;
    std::istringstream numbers(angles);
    numbers.imbue(std::locale::classic());
    for (double angle = 0; numbers >> angle && !is_told;) {
      if (!(std::fabs(angle) > whole_turn * (1 + 0x1p-20))) continue;
      is_told = true;
      warnings.push_back(
          fmt::format("line {}: {}: rpy=\"{}\" turns by more than a whole turn; URDF has radians, so if "
                      "these are degrees, write {:.6g} for {:.6g}",
                      element.Row(), owner, angles, angle * whole_turn / 360, angle));
    }
  });
}

/// How far it reaches at most tells whether lengths are metres.
void warn_of_reach(const RobotDescription& robot, std::vector<std::string>& warnings) {
  constexpr double far = 100;
  double reach = 0;
  for (const RobotJoint& joint : robot.joints) reach += length(joint.origin.offset);
  if (reach > far)
    warnings.push_back(
        fmt::format("the origins of the joints are {:.3g} m long, all together; URDF is in metres", reach));
}

AllowedReason reason_of_srdf(const char* reason) {
  const std::string_view word = reason == nullptr ? "" : reason;
  if (word == "Adjacent") return AllowedReason::adjacent;
  if (word == "Always") return AllowedReason::always;
  if (word == "Default") return AllowedReason::at_rest;
  if (word == "Never") return AllowedReason::never;
  return AllowedReason::given;
}

/// Which pairs an SRDF file disables.
class DisabledPairs {
 public:
  DisabledPairs(const RobotXml& xml, const Robot& robot) : xml_(xml), robot_(robot) {}

  std::vector<AllowedPair> found() {
    for (const TiXmlElement* element : RobotXml::below(xml_.robot(), "disable_default_collisions")) {
      const Index link = link_at(*element, "link");
      for (Index other = 0; other < robot_.links().size(); ++other)
        if (other != link) pairs_[std::minmax(link, other)] = AllowedReason::given;
    }
    for (const TiXmlElement* element : RobotXml::below(xml_.robot(), "enable_collisions"))
      pairs_.erase(pair_at(*element));
    for (const TiXmlElement* element : RobotXml::below(xml_.robot(), "disable_collisions"))
      pairs_[pair_at(*element)] = reason_of_srdf(element->Attribute("reason"));
    std::vector<AllowedPair> list;
    for (const auto& [pair, reason] : pairs_)
      list.push_back({robot_.links()[pair.first].name, robot_.links()[pair.second].name, reason});
    return list;
  }

 private:
  [[nodiscard]] Index link_at(const TiXmlElement& element, const char* attribute) const {
    try {
      return robot_.link_of(xml_.attribute(element, attribute));
    } catch (const Error& error) {
      const std::string what = error.what();
      throw what.starts_with(xml_.path()) ? error : xml_.error_at(element, what);
    }
  }

  [[nodiscard]] std::pair<Index, Index> pair_at(const TiXmlElement& element) const {
    const Index a = link_at(element, "link1"), b = link_at(element, "link2");
    if (a == b) throw xml_.error_at(element, "a pair of links is of two different ones");
    return std::minmax(a, b);
  }

  const RobotXml& xml_;
  const Robot& robot_;
  std::map<std::pair<Index, Index>, AllowedReason> pairs_;
};

}  // namespace

bool reads_urdf() { return true; }

RobotFile read_urdf(const std::string& path, const UrdfOptions& options) {
  const RobotXml xml(path);
  require_urdf(xml);
  RobotFile file;
  file.description = skeleton_of(xml);
  require_tree(xml, file.description);
  const urdf::ModelInterfaceSharedPtr model = model_of(xml);
  UrdfShapes shapes(xml, options, file.warnings);
  for (RobotLink& link : file.description.links) try {
      link.shapes = shapes.of(*model->getLink(link.name));
    } catch (const Error& error) {
      throw xml.error_about(fmt::format("link '{}': {}", link.name, error.what()));
    }
  for (RobotJoint& joint : file.description.joints) add_numbers(*model->getJoint(joint.name), joint);
  RobotDescription without_shapes = file.description;
  for (RobotLink& link : without_shapes.links) link.shapes.clear();
  require_tree(xml, without_shapes);
  warn_of_reach(file.description, file.warnings);
  warn_of_degrees(xml, file.warnings);
  warn_of_attributes(xml, file.warnings);
  return file;
}

std::vector<AllowedPair> read_srdf(const std::string& path, const Robot& robot) {
  const RobotXml xml(path);
  require_srdf(xml);
  return DisabledPairs(xml, robot).found();
}

}  // namespace toccata

#endif
