#include "io/glb/glb_scene.hpp"

#include <cmath>
#include <utility>

#include "io/formats/utf8.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata::io {
namespace {

using Json = GlbWriter::Json;

/// glTF writes matrices by columns.
Json matrix_of(const Pose& pose) {
  Json matrix = Json::array();
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) matrix.push_back(pose.linear[i][j]);
    matrix.push_back(0);
  }
  for (int i = 0; i < 3; ++i) matrix.push_back(pose.offset[i]);
  matrix.push_back(1);
  return matrix;
}

double metres_of(const std::string& unit) {
  try {
    return metres_per_unit(unit);
  } catch (const Error&) {
    return 1;
  }
}

/// What brings a world of this unit and this axis to metres and Y up: Z to Y, and Y to −Z.
Pose to_metres(double metres, UpAxis up) {
  if (up == UpAxis::y) return Pose::from_numbers({metres, 0, 0, 0, metres, 0, 0, 0, metres, 0, 0, 0});
  return Pose::from_numbers({metres, 0, 0, 0, 0, metres, 0, -metres, 0, 0, 0, 0});
}

}  // namespace

GlbPlace GlbPlace::of(const Pose& pose) {
  if (can_be_a_node(pose)) return {pose, {}};
  return {{{}, pose.offset}, {pose.linear, {}}};
}

std::vector<Vec3> GlbPlace::placed(std::span<const Vec3> points) const {
  if (is_plain()) return {points.begin(), points.end()};
  return transform(vertices, points);
}

std::string GlbScene::name_of(std::size_t object) const { return as_utf8(models_[object].name); }

Pose GlbScene::pose_of(std::size_t object) const {
  const std::optional<Pose>& fit = meshes_.drawn()[object].fit;
  return fit ? compose(models_[object].pose, *fit) : models_[object].pose;
}

std::size_t GlbScene::material(const GlbPaint& paint) {
  const auto [found, is_new] = materials_.try_emplace(paint.name);
  if (is_new) found->second = writer_.add_material(paint.name, paint.colour, paint.cover);
  return found->second;
}

Json GlbScene::painted(Json part, const GlbPaint& paint) {
  part["material"] = material(paint);
  return part;
}

Json GlbScene::part(const GlbPart& part, GlbMode mode, const GlbPaint& paint) {
  return painted(writer_.add_part(part, mode), paint);
}

std::size_t GlbScene::add_mesh(const std::string& name, Json parts) {
  return writer_.add_mesh({{"name", name}, {"primitives", std::move(parts)}});
}

std::size_t GlbScene::add_node(const std::string& name, const Pose& pose, const GlbFrame& own, Json more) {
  Json node = {{"name", name}};
  if (const Pose own_pose = pose_between(frame_, pose, own); !(own_pose == Pose{}))
    node["matrix"] = matrix_of(own_pose);
  node.update(more);
  return writer_.add_node(std::move(node));
}

std::size_t GlbScene::add_parent(const std::string& name, const std::vector<std::size_t>& children) {
  return writer_.add_node({{"name", name}, {"children", children}});
}

void GlbScene::add_group(const std::string& name, const std::vector<std::size_t>& children) {
  if (!children.empty()) groups_.push_back(add_parent(name, children));
}

std::string GlbScene::file(const ViewOptions& options, const std::string& unit) {
  const Pose world = to_metres(metres_of(unit), options.up);
  Pose pose{world.linear, transform(world, frame_.origin)};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) pose.linear[i][j] = std::ldexp(pose.linear[i][j], frame_.exponent);
  if (!is_finite(pose)) throw Error("the scene reaches beyond the largest double in metres: scale it down");
  Json root = {{"name", as_utf8(options.title)}};
  if (!(pose == Pose{})) root["matrix"] = matrix_of(pose);
  if (!groups_.empty()) root["children"] = groups_;
  return writer_.file(writer_.add_node(std::move(root)));
}

GlbPart joined_part(std::span<const Vec3> points, const GlbFrame& frame) {
  GlbPart part;
  std::map<std::array<float, 3>, Index> known;
  for (const Vec3& point : points) {
    const auto [found, is_new] = known.try_emplace(frame.counted(point), static_cast<Index>(part.points.size()));
    if (is_new) part.points.push_back(found->first);
    part.corners.push_back(found->second);
  }
  return part;
}

}  // namespace toccata::io
