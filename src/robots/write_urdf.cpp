#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <system_error>

#include "io/formats/file_bytes.hpp"
#include "io/formats/file_error.hpp"
#include "io/formats/mesh_text.hpp"
#include "toccata/core/error.hpp"
#include "toccata/robots/robot_files.hpp"

namespace toccata {
namespace {

std::string urdf_words(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    const bool is_blank = c == '\t' || c == '\n' || c == '\r';
    if (static_cast<unsigned char>(c) < ' ' && !is_blank)
      throw Error(fmt::format("a name, '{}' up to there, has the character {}, which XML cannot hold; give it another",
                              escaped, static_cast<int>(c)));
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string urdf_words(const Vec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

/// About the fixed axes x, y and z, one after the other.
Vec3 roll_pitch_yaw(const Mat3& m) {
  const double pitch = std::asin(std::clamp(-m[2].x, -1.0, 1.0));
  return {std::atan2(m[2].y, m[2].z), pitch, std::atan2(m[1].x, m[0].x)};
}

std::string origin_in_xml(const Pose& pose) {
  return fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", urdf_words(pose.offset),
                     urdf_words(roll_pitch_yaw(pose.linear)));
}

/// Writes one robot.
class UrdfWriting {
 public:
  UrdfWriting(const RobotDescription& robot, const std::string& folder) : robot_(robot), folder_(folder) {
    std::error_code code;
    std::filesystem::create_directories(folder_, code);
    if (code) io::fail_in_file(folder, {"the folder cannot be made: " + code.message(), "choose another"});
  }

  void write() {
    std::string xml = fmt::format("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n", urdf_words(robot_.name));
    for (const RobotLink& link : robot_.links) xml += link_in_xml(link);
    for (const RobotJoint& joint : robot_.joints) xml += joint_in_xml(joint);
    for (const auto& [name, text] : meshes_) write_file(name, text);
    write_file("robot.urdf", xml + "</robot>\n");
  }

 private:
  void write_file(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder_ / name;
    std::error_code code;
    if (std::filesystem::exists(path, code)) {
      const io::FileBytes there = io::read_file(path);
      if (std::string_view(there.data.get(), there.size) == text) return;
      io::fail_in_file(path.string(), {"there is another file already", "choose another folder or remove it"});
    }
    io::write_file(path, text);
  }

  std::string link_in_xml(const RobotLink& link) {
    std::string xml = fmt::format("  <link name=\"{}\">\n", urdf_words(link.name));
    for (const LinkShape& shape : link.shapes) {
      const std::string body = fmt::format("{}<geometry>{}</geometry>", origin_in_xml(shape.pose), of(shape, link));
      for (const char* kind : {"visual", "collision"}) xml += fmt::format("    <{0}>{1}</{0}>\n", kind, body);
    }
    return xml + "  </link>\n";
  }

  std::string of(const LinkShape& shape, const RobotLink& link) {
    if (const auto* sphere = std::get_if<Sphere>(&shape.shape); sphere && sphere->centre() == Vec3{})
      return fmt::format("<sphere radius=\"{}\"/>", sphere->radius());
    if (const auto* box = std::get_if<Box>(&shape.shape); box && box->centre() == Vec3{})
      return fmt::format("<box size=\"{}\"/>", urdf_words(2 * box->half_extents()));
    if (const auto* cylinder = std::get_if<Cylinder>(&shape.shape))
      return fmt::format("<cylinder radius=\"{}\" length=\"{}\"/>", cylinder->radius(), 2 * cylinder->half_height());
    if (const auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&shape.shape)) {
      const std::string name = fmt::format("mesh{}.obj", meshes_.size());
      meshes_.emplace(name, io::obj_text(**mesh));
      return fmt::format("<mesh filename=\"{}\"/>", name);
    }
    throw Error(fmt::format("link '{}': URDF has no {} like this one; it has meshes, spheres, boxes and cylinders",
                            link.name, name_of(shape.shape)));
  }

  static std::string joint_in_xml(const RobotJoint& joint) {
    std::string xml = fmt::format(
        "  <joint name=\"{}\" type=\"{}\">\n    {}<parent link=\"{}\"/><child link=\"{}\"/><axis xyz=\"{}\"/>",
        urdf_words(joint.name), name_of(joint.kind), origin_in_xml(joint.origin), urdf_words(joint.parent),
        urdf_words(joint.child), urdf_words(joint.axis));
    if (joint.limits)
      xml += fmt::format("<limit lower=\"{}\" upper=\"{}\" effort=\"0\" velocity=\"0\"/>", joint.limits->lower,
                         joint.limits->upper);
    if (joint.mimic)
      xml += fmt::format("<mimic joint=\"{}\" multiplier=\"{}\" offset=\"{}\"/>", urdf_words(joint.mimic->joint),
                         joint.mimic->multiplier, joint.mimic->offset);
    return xml + "\n  </joint>\n";
  }

  const RobotDescription& robot_;
  std::filesystem::path folder_;
  std::map<std::string, std::string> meshes_;
};

}  // namespace

void write_urdf(const RobotDescription& robot, const std::string& folder) { UrdfWriting(robot, folder).write(); }

}  // namespace toccata
