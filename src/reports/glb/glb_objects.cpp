#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "reports/glb/glb_scene.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/view/asked_poses.hpp"

namespace toccata::io {
namespace {

enum class ObjectRole { alone, first, second, part };

/// Parts differ from those beside them.
GlbPaint paint_of(ObjectRole role, std::size_t object) {
  constexpr double seen_through = 0.5;
  const std::size_t colour = object % colours_in_turn.size();
  if (role == ObjectRole::part) return {fmt::format("parts in colour {}", colour), colours_in_turn[colour], 1};
  if (role == ObjectRole::alone) return {"object", 0xa9b2bb, 1};
  return role == ObjectRole::first ? GlbPaint{"first of a pair", 0x56b4e9, seen_through}
                                   : GlbPaint{"second of a pair", 0xe69f00, seen_through};
}

/// The role of each object is that in the first of the findings that name it.
std::vector<ObjectRole> roles_of(std::size_t objects, const SceneAnswer& answer) {
  if (std::holds_alternative<DecomposeReport>(answer)) return std::vector<ObjectRole>(objects, ObjectRole::part);
  std::vector<std::optional<ObjectRole>> roles(objects);
  if (const QuestionKind& kind = question_kind_of(answer); kind.named != nullptr)
    for (const auto& [first, second] : kind.named(answer)) {
      if (!roles[first]) roles[first] = ObjectRole::first;
      if (!roles[second]) roles[second] = ObjectRole::second;
    }
  std::vector<ObjectRole> known;
  for (const auto& role : roles) known.push_back(role.value_or(ObjectRole::alone));
  return known;
}

/// A point and a segment have no triangles.
GlbMode mode_of(const DisplayMesh& mesh) {
  if (!mesh.triangles.empty()) return GlbMode::triangles;
  return mesh.vertices.size() == 2 ? GlbMode::lines : GlbMode::points;
}

/// The meshes of objects: what several show is there once.
class ObjectMeshes {
 public:
  explicit ObjectMeshes(GlbScene& glb) : glb_(glb) {}

  void add(std::size_t object, ObjectRole role) {
    const GlbPlace place = GlbPlace::of(glb_.pose_of(object));
    const GlbFrame frame = frame_of(glb_.meshes().drawn()[object].mesh, place);
    nodes_.push_back(
        glb_.add_node(glb_.name_of(object), place.node, frame, {{"mesh", mesh_number(object, role, place, frame)}}));
  }

  /// The same of an object that moves through the keys; models of such objects are at their own places.
  void add_moving(std::size_t object, ObjectRole role, std::span<const GlbKey> keys) {
    const GlbPlace place = GlbPlace::of(glb_.pose_of(object));
    const GlbFrame frame = frame_of(glb_.meshes().drawn()[object].mesh, place);
    const std::string name = glb_.name_of(object);
    const std::size_t node =
        glb_.add_moved(name, place.node, frame, {{"mesh", mesh_number(object, role, place, frame)}});
    nodes_.push_back(glb_.add_moving(name + " moving", node, keys));
  }

  [[nodiscard]] const std::vector<std::size_t>& nodes() const { return nodes_; }

 private:
  GlbFrame frame_of(std::size_t number, const GlbPlace& place) {
    const DisplayMesh& drawn = glb_.meshes().meshes()[number];
    if (!place.is_plain()) return GlbFrame::around(place.placed(drawn.vertices));
    const auto [frame, is_new] = frames_.try_emplace(number);
    if (is_new) frame->second = GlbFrame::around(drawn.vertices);
    return frame->second;
  }

  std::size_t mesh_number(std::size_t object, ObjectRole role, const GlbPlace& place, const GlbFrame& frame) {
    if (!place.is_plain()) return new_mesh(object, role, new_part(object, role, place, frame));
    const std::size_t drawn = glb_.meshes().drawn()[object].mesh;
    const auto [mesh, is_new] = meshes_.try_emplace({drawn, role});
    if (!is_new) return mesh->second;
    const auto [part, is_new_part] = parts_.try_emplace(drawn);
    if (is_new_part) part->second = new_part(object, role, place, frame);
    return mesh->second = new_mesh(object, role, part->second);
  }

  std::size_t new_mesh(std::size_t object, ObjectRole role, Json part) {
    return glb_.add_mesh(glb_.name_of(object), Json::array({glb_.painted(std::move(part), paint_of(role, object))}));
  }

  Json new_part(std::size_t object, ObjectRole role, const GlbPlace& place, const GlbFrame& frame) {
    const DisplayMesh& drawn = glb_.meshes().meshes()[glb_.meshes().drawn()[object].mesh];
    GlbPart part;
    part.points.reserve(drawn.vertices.size());
    for (const Vec3& vertex : place.placed(drawn.vertices)) part.points.push_back(frame.counted(vertex));
    part.corners.reserve(3 * drawn.triangles.size());
    for (const auto& triangle : drawn.triangles)
      part.corners.insert(part.corners.end(), triangle.begin(), triangle.end());
    return glb_.part(part, mode_of(drawn), paint_of(role, object));
  }

  GlbScene& glb_;
  std::map<std::pair<std::size_t, ObjectRole>, std::size_t> meshes_;
  std::map<std::size_t, Json> parts_;  ///< of the drawn meshes
  std::map<std::size_t, GlbFrame> frames_;
  std::vector<std::size_t> nodes_;
};

std::vector<GlbKey> keys_of_queries(std::span<const PairQuery> queries, std::size_t object) {
  std::vector<Pose> poses;
  for (const PairQuery& query : queries) poses.push_back(object == 0 ? query.pose_a : query.pose_b);
  return keys_of(poses);
}

}  // namespace

void add_objects(GlbScene& glb, const SceneAnswer& answer) {
  ObjectMeshes meshes(glb);
  const std::vector<ObjectRole> roles = roles_of(glb.models().size(), answer);
  const std::span<const PairQuery> queries = queries_of(answer);
  for (std::size_t object = 0; object < roles.size(); ++object)
    if (queries.empty())
      meshes.add(object, roles[object]);
    else
      meshes.add_moving(object, object == 0 ? ObjectRole::first : ObjectRole::second, keys_of_queries(queries, object));
  glb.add_group("objects", meshes.nodes());
}

void add_moving_objects(GlbScene& glb, const std::vector<std::vector<GlbKey>>& keys,
                        const std::vector<bool>& is_named) {
  ObjectMeshes meshes(glb);
  const auto has_pose = [](const GlbKey& key) { return key.pose.has_value(); };
  for (std::size_t object = 0; object < keys.size(); ++object)
    if (std::any_of(keys[object].begin(), keys[object].end(), has_pose))
      meshes.add_moving(object, is_named[object] ? ObjectRole::first : ObjectRole::alone, keys[object]);
  glb.add_group("objects", meshes.nodes());
}

}  // namespace toccata::io
