#include "reports/glb/glb_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/formats/utf8.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata::io {
namespace {

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

/// Pose i is frame i of a program that shows 24 a second, as Blender does unless told otherwise.
float moment_of(std::size_t pose) {
  constexpr double per_second = 24;
  return static_cast<float>(static_cast<double>(pose) / per_second);
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
  const std::optional<Pose>& fit = meshes_->drawn()[object].fit;
  return fit ? models_[object].pose * *fit : models_[object].pose;
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

std::size_t GlbScene::add_node(const std::string& name, const Pose& pose, const GlbFrame& own, const Json& more) {
  return node_at(name, pose_between(frame_, pose, own), more);
}

std::size_t GlbScene::node_at(const std::string& name, const Pose& pose, const Json& more) {
  Json node = {{"name", name}};
  if (!(pose == Pose{})) node["matrix"] = matrix_of(pose);
  node.update(more);
  return writer_.add_node(node);
}

std::size_t GlbScene::add_parent(const std::string& name, const std::vector<std::size_t>& children) {
  return writer_.add_node({{"name", name}, {"children", children}});
}

void GlbScene::add_group(const std::string& name, const std::vector<std::size_t>& children) {
  if (!children.empty()) groups_.push_back(add_parent(name, children));
}

void GlbScene::add_stopped(std::size_t unfinished) {
  const std::string name = fmt::format("stopped: {} pair{} not looked at", unfinished, unfinished == 1 ? "" : "s");
  add_group("not all", {add_node(name, {}, {}, {{"extras", {{"unfinished", unfinished}}}})});
}

std::size_t GlbScene::add_moved(const std::string& name, const Pose& pose, const GlbFrame& own, const Json& more) {
  return node_at(name, pose_between({}, pose, own), more);
}

void GlbScene::animate(std::size_t node, const char* path, const std::vector<float>& times, std::span<const float> keys,
                       std::size_t width) {
  if (times.size() < 2) return;  // the node rests as it is
  const auto [known, is_new] = times_.try_emplace(times);
  if (is_new) known->second = writer_.add_keys(times, 1);
  channels_.push_back({{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", path}}}});
  samplers_.push_back({{"input", known->second}, {"output", writer_.add_keys(keys, width)}, {"interpolation", "STEP"}});
}

GlbTurn GlbScene::turn_at(const std::string& name, const GlbKey& key) const {
  if (!can_be_a_node(*key.pose))
    throw Error(
        fmt::format("a GLB file cannot shear or flatten what moves, as '{}' is at pose {}; a page shows it: "
                    "view_page, or -o FILE.html",
                    name, key.frame));
  return turn_of(pose_between(frame_, *key.pose, {}));
}

std::size_t GlbScene::add_moving(const std::string& name, std::size_t child, std::span<const GlbKey> keys) {
  const auto has_pose = [](const GlbKey& key) { return key.pose.has_value(); };
  GlbTurn turn = turn_at(name, *std::find_if(keys.begin(), keys.end(), has_pose));
  std::vector<float> times, translations, rotations, scales;
  for (const GlbKey& key : keys) {
    if (key.pose) turn = turn_at(name, key);
    times.push_back(moment_of(key.frame));
    translations.insert(translations.end(), turn.translation.begin(), turn.translation.end());
    rotations.insert(rotations.end(), turn.rotation.begin(), turn.rotation.end());
    for (const float scale : turn.scale) scales.push_back(key.pose ? scale : 0);
  }
  const auto first = [](const std::vector<float>& numbers, std::size_t count) {
    return std::vector<float>(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count));
  };
  Json moving = {{"name", name}, {"children", {child}}};  // which rests at the first key
  moving.update(
      {{"translation", first(translations, 3)}, {"rotation", first(rotations, 4)}, {"scale", first(scales, 3)}});
  const std::size_t node = writer_.add_node(moving);
  animate(node, "translation", times, translations, 3);
  animate(node, "rotation", times, rotations, 4);
  animate(node, "scale", times, scales, 3);
  return node;
}

std::size_t GlbScene::add_at_pose(const std::string& name, const std::vector<std::size_t>& children, std::size_t pose,
                                  std::size_t poses, const Json& more) {
  Json node = {{"name", name}, {"children", children}};
  node.update(more);
  const std::size_t number = writer_.add_node(node);
  std::vector<float> times, scales;
  const auto add = [&](std::size_t i, float scale) {
    times.push_back(moment_of(i));
    scales.insert(scales.end(), 3, scale);
  };
  if (pose > 0) add(0, 0);
  add(pose, 1);
  if (pose + 1 < poses) add(pose + 1, 0);
  animate(number, "scale", times, scales, 3);
  return number;
}

std::size_t GlbScene::add_root(const ViewOptions& options, const std::string& unit) {
  const Pose world = to_metres(metres_of(unit), options.up);
  Pose pose{world.linear, transform(world, frame_.origin)};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) pose.linear[i][j] = std::ldexp(pose.linear[i][j], frame_.exponent);
  if (!is_finite(pose)) throw Error("the scene reaches beyond the largest double in metres: scale it down");
  Json root = {{"name", as_utf8(options.title)}};
  if (!(pose == Pose{})) root["matrix"] = matrix_of(pose);
  if (!groups_.empty()) root["children"] = groups_;
  if (!samplers_.empty())
    writer_.add_animation({{"name", "poses"}, {"samplers", std::move(samplers_)}, {"channels", std::move(channels_)}});
  return writer_.add_node(root);
}

std::string GlbScene::file(const ViewOptions& options, const std::string& unit) {
  return writer_.file(add_root(options, unit));
}

std::pair<GlbWriter, std::size_t> GlbScene::take(const ViewOptions& options, const std::string& unit) && {
  const std::size_t root = add_root(options, unit);
  return {std::move(writer_), root};
}

std::vector<GlbKey> keys_of(std::span<const Pose> poses) {
  std::vector<GlbKey> keys;
  for (const Pose& pose : poses) keys.push_back({keys.size(), pose});
  return keys;
}

GlbPart edges_part(std::span<const Aabb> boxes, const GlbPlace& place, const GlbFrame& frame) {
  constexpr std::array<std::array<Index, 2>, 12> edges{
      {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  GlbPart part;
  std::vector<Vec3> corners;
  for (const Aabb& box : boxes) {
    for (const auto& edge : edges)
      for (const Index end : edge) part.corners.push_back(static_cast<Index>(corners.size()) + end);
    for (unsigned i = 0; i < 8; ++i)
      corners.push_back({(i & 1U) != 0 ? box.upper.x : box.lower.x, (i & 2U) != 0 ? box.upper.y : box.lower.y,
                         (i & 4U) != 0 ? box.upper.z : box.lower.z});
  }
  for (const Vec3& corner : place.placed(corners)) part.points.push_back(frame.counted(corner));
  return part;
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
