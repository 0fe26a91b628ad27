#include "reports/view/view_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "reports/view/display_range.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata::io {
namespace {

/// The half axes of a quadric; zero for any other shape.
Vec3 half_axes_of(const Shape& shape) {
  return std::visit(
      []<class S>(const S& of_kind) -> Vec3 {
        if constexpr (QuadricShape<S>)
          return PosedQuadric(of_kind).half();
        else
          return {};
      },
      shape);
}

/// The same for shapes that are drawn alike; empty when the shape is drawn for one object alone.
std::string key_of(const Shape& shape) {
  const auto shared = [](const void* address) { return fmt::format("shared {}", address); };
  const auto numbers = [](const Vec3& v) { return fmt::format("{} {} {} ", v.x, v.y, v.z); };
  if (is_quadric(kind_of(shape))) return fmt::format("{} {}", name_of(shape), numbers(half_axes_of(shape)));
  switch (kind_of(shape)) {
    case ShapeKind::sphere:
      return "sphere";
    case ShapeKind::box:
      return "box";
    case ShapeKind::mesh:
    case ShapeKind::height_field:
      return shared(mesh_of(shape).get());
    case ShapeKind::convex_hull:
      return shared(std::get<ConvexHull>(shape).padded_coordinates(0).data());
    case ShapeKind::compound:
      return shared(std::get<Compound>(shape).parts().data());
    case ShapeKind::capsule: {
      const Capsule& capsule = std::get<Capsule>(shape);
      return "capsule " + numbers(capsule.start()) + numbers(capsule.end()) + fmt::format("{}", capsule.radius());
    }
    default:
      return {};
  }
}

Mat3 diagonal(const Vec3& d) { return Pose::from_numbers({d.x, 0, 0, 0, d.y, 0, 0, 0, d.z, 0, 0, 0}).linear; }

std::optional<Pose> fit_of(const Shape& shape) {
  if (const Sphere* sphere = std::get_if<Sphere>(&shape))
    return Pose{diagonal({sphere->radius(), sphere->radius(), sphere->radius()}), sphere->centre()};
  if (const Box* box = std::get_if<Box>(&shape)) return Pose{diagonal(box->half_extents()), box->centre()};
  return std::nullopt;
}

Aabb box_of(const DisplayMesh& mesh) { return fit_aabb(mesh.vertices); }

std::array<Vec3, 8> corners(const Aabb& box) {
  std::array<Vec3, 8> all;
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = {(i & 1U) != 0 ? box.upper.x : box.lower.x, (i & 2U) != 0 ? box.upper.y : box.lower.y,
              (i & 4U) != 0 ? box.upper.z : box.lower.z};
  return all;
}

bool is_half_space(const SceneInstance& posed) { return kind_of(posed.model.shape()) == ShapeKind::half_space; }

/// How round shapes are drawn: where there are many, each is small on the screen.
int circles_for(std::size_t objects) {
  if (objects < 500) return most_circles;
  return objects < 3000 ? 6 : 4;
}

/// The place of a world point in a frame that is at most turned and moved.
Vec3 in_frame(const Pose& pose, const Vec3& world) {
  const std::array<double, 12> n = pose.numbers();
  const Vec3 d = world - pose.offset;
  return {n[0] * d.x + n[3] * d.y + n[6] * d.z, n[1] * d.x + n[4] * d.y + n[7] * d.z,
          n[2] * d.x + n[5] * d.y + n[8] * d.z};
}

/// Meshes of fewer vertices keep 24 bits of each coordinate, larger ones 16.
constexpr std::size_t most_fine_vertices = 65'536;

/// Whether numbers up to 65,535 tell it: neither wider than the doubles nor as small as their least ones.
bool has_steps(const DisplayRange& range) { return range.is_whole && (range.step == 0 || range.step > 1e-290); }

Json written_vertices(const DisplayMesh& mesh, const Aabb& box, ViewData& data) {
  const std::array<DisplayRange, 3> ranges{DisplayRange(box.lower.x, box.upper.x),
                                           DisplayRange(box.lower.y, box.upper.y),
                                           DisplayRange(box.lower.z, box.upper.z)};
  constexpr double most = 65535;
  const bool fine = mesh.vertices.size() <= most_fine_vertices || !std::all_of(ranges.begin(), ranges.end(), has_steps);
  std::vector<float> floats;
  std::vector<std::uint16_t> shorts;
  for (const Vec3& v : mesh.vertices)
    for (int axis = 0; axis < 3; ++axis) {
      const double at = ranges[static_cast<std::size_t>(axis)].number(v[axis]);
      if (fine)
        floats.push_back(static_cast<float>(at));
      else
        shorts.push_back(static_cast<std::uint16_t>(std::clamp(std::round(at * most), 0.0, most)));
    }
  Json json = fine ? data.add(floats) : data.add(shorts);
  json["bytes"] = fine ? 4 : 2;
  json["lower"] = {box.lower.x, box.lower.y, box.lower.z};
  const double parts = fine ? 1 : most;
  json["step"] = {ranges[0].step / parts, ranges[1].step / parts, ranges[2].step / parts};
  return json;
}

Json written_triangles(const DisplayMesh& mesh, ViewData& data) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(mesh.triangles.size() * 3);
  for (const auto& triangle : mesh.triangles) numbers.insert(numbers.end(), triangle.begin(), triangle.end());
  if (mesh.vertices.size() > 65'536) {
    Json json = data.add(std::span<const std::uint32_t>(numbers));
    json["bytes"] = 4;
    return json;
  }
  std::vector<std::uint16_t> shorts;
  shorts.reserve(numbers.size());
  for (const std::uint32_t number : numbers) shorts.push_back(static_cast<std::uint16_t>(number));
  Json json = data.add(std::span<const std::uint16_t>(shorts));
  json["bytes"] = 2;
  return json;
}

Json written(const DisplayMesh& mesh, ViewData& data) {
  return {{"smooth", mesh.smooth},
          {"vertices", written_vertices(mesh, box_of(mesh), data)},
          {"triangles", written_triangles(mesh, data)}};
}

}  // namespace

ViewMeshes::ViewMeshes(std::span<const SceneInstance> models, std::span<const Place> places)
    : circles_(circles_for(models.size())) {
  for (const SceneInstance& posed : models) drawn_.push_back(drawn_of(posed));
  Aabb world;
  std::vector<Aabb> boxes;
  for (const DisplayMesh& mesh : meshes_) boxes.push_back(box_of(mesh));
  const auto add = [&](std::size_t i, const Pose& pose) {
    if (!is_half_space(models[i])) world = merge(world, box_at(i, boxes[drawn_[i].mesh], pose, models[i].name));
  };
  for (std::size_t i = 0; i < models.size(); ++i) add(i, models[i].pose);
  for (const Place& place : places) add(place.model, place.pose);
  frame_ = DisplayFrame::around(world);
  for (std::size_t i = 0; i < models.size(); ++i)
    if (const HalfSpace* half_space = std::get_if<HalfSpace>(&models[i].model.shape()))
      meshes_[drawn_[i].mesh] = display_mesh(*half_space, in_frame(models[i].pose, frame_.centre), 2 * frame_.size);
}

Aabb ViewMeshes::box_at(std::size_t model, const Aabb& mesh_box, const Pose& pose, const std::string& name) const {
  Aabb box;
  for (Vec3 corner : corners(mesh_box)) {
    if (drawn_[model].fit) corner = transform(*drawn_[model].fit, corner);
    const Vec3 placed = transform(pose, corner);
    if (!is_finite(placed))
      throw Error(fmt::format("'{}' reaches beyond the largest double in the world: scale it down", name));
    box = merge(box, placed);
  }
  return box;
}

ViewMeshes::Drawn ViewMeshes::drawn_of(const SceneInstance& posed) {
  const Shape& shape = posed.model.shape();
  return {mesh_number(key_of(shape), posed.model), fit_of(shape)};
}

std::size_t ViewMeshes::mesh_number(const std::string& key, const Model& model) {
  if (const auto found = number_of_.find(key); !key.empty() && found != number_of_.end()) return found->second;
  if (!key.empty()) number_of_[key] = meshes_.size();
  meshes_.push_back(mesh_for(key, model));
  return meshes_.size() - 1;
}

DisplayMesh ViewMeshes::mesh_for(const std::string& key, const Model& model) const {
  if (key == "sphere") return unit_sphere(circles_);
  return key == "box" ? unit_box() : display_mesh(model, circles_);
}

std::vector<Index> ViewMeshes::triangles_of(std::size_t model, std::span<const Index> faces) const {
  const std::vector<Index>& face_of = meshes_[drawn_[model].mesh].faces;
  std::vector<Index> triangles;
  if (face_of.empty() || face_of.back() == 0) return triangles;
  for (const Index face : faces) {
    const auto [first, end] = std::equal_range(face_of.begin(), face_of.end(), face);
    for (auto triangle = first; triangle != end; ++triangle)
      triangles.push_back(static_cast<Index>(triangle - face_of.begin()));
  }
  return triangles;
}

void ViewMeshes::write(Json& header, ViewData& data) const {
  header["frame"] = {{"centre", {frame_.centre.x, frame_.centre.y, frame_.centre.z}}, {"size", frame_.size}};
  Json& meshes = header["meshes"] = Json::array();
  for (const DisplayMesh& mesh : meshes_) meshes.push_back(written(mesh, data));
  Json& objects = header["objects"] = Json::array();
  for (const Drawn& drawn : drawn_) {
    Json object = {{"mesh", drawn.mesh}};
    if (drawn.fit) object["fit"] = drawn.fit->numbers();
    objects.push_back(std::move(object));
  }
}

std::vector<ViewMeshes::Place> places_of(std::span<const PairQuery> queries) {
  std::vector<ViewMeshes::Place> places;
  for (const PairQuery& query : queries) places.insert(places.end(), {{0, query.pose_a}, {1, query.pose_b}});
  return places;
}

}  // namespace toccata::io
