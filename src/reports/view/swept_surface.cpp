#include "reports/view/swept_surface.hpp"

#include <algorithm>
#include <array>

#include "math/vec3_measures.hpp"
#include "query/posed_shape.hpp"
#include "reports/view/display_mesh.hpp"
#include "toccata/motion/swept_volume.hpp"

namespace toccata::io {
namespace {

/// More are slow to draw, and show no more to an eye.
constexpr std::size_t most_drawn_parts = 64;
constexpr int circles_of_parts = 4;

/// A part of a volume, as it is drawn and as it is asked.
struct DrawnPart {
  DisplayMesh mesh;
  PosedShape shape;
  Aabb box;

  DrawnPart(const Model& part, const Pose& pose)
      : mesh(display_mesh(part, circles_of_parts)),
        shape(pose_shape(part, pose, Solid::automatic, "a part of a swept volume")),
        box(world_box(shape)) {
    for (Vec3& vertex : mesh.vertices) vertex = transform(pose, vertex);
  }

  [[nodiscard]] bool contains(const Vec3& point) const {
    const auto* convex = std::get_if<PosedPolytope>(&shape);
    return convex != nullptr && overlap(box, Aabb{point, point}) && overlap(PosedPolytope(Point(point)), *convex);
  }
};

/// The triangles of the convex parts that can be seen: a triangle whose corners are inside another part, which is
/// convex, is inside it. The corners are lifted a little, so that of faces in one plane both stay.
class SurfaceOfParts {
 public:
  explicit SurfaceOfParts(const Model& volume) {
    const auto* compound = std::get_if<Compound>(&volume.shape());
    if (compound == nullptr) parts_.emplace_back(volume, Pose{});
    for (std::size_t i = 0; i < volume.parts().size(); ++i)
      if (!volume.parts()[i].has_mesh()) parts_.emplace_back(volume.parts()[i], compound->parts()[i].pose);
    Aabb box;
    for (const DrawnPart& part : parts_) box = merge(box, part.box);
    lift_ = 1e-6 * plain_length(box.upper - box.lower);
  }

  [[nodiscard]] std::vector<Vec3> corners() const {
    std::vector<Vec3> seen;
    for (const DrawnPart& part : parts_)
      for (const auto& [a, b, c] : part.mesh.triangles) {
        const std::array corners{part.mesh.vertices[a], part.mesh.vertices[b], part.mesh.vertices[c]};
        if (!is_hidden(part, corners)) seen.insert(seen.end(), corners.begin(), corners.end());
      }
    return seen;
  }

 private:
  [[nodiscard]] bool is_hidden(const DrawnPart& own, const std::array<Vec3, 3>& corners) const {
    const Vec3 up = lift_ * plain_unit_or_zero(cross(corners[1] - corners[0], corners[2] - corners[0]));
    return std::any_of(parts_.begin(), parts_.end(), [&](const DrawnPart& other) {
      return &other != &own && std::all_of(corners.begin(), corners.end(),
                                           [&](const Vec3& corner) { return other.contains(corner + up); });
    });
  }

  std::vector<DrawnPart> parts_;
  double lift_ = 0;
};

}  // namespace

std::vector<Vec3> swept_surface(const Model& body, const RigidMotion& motion, Solid solid) {
  if (std::holds_alternative<HalfSpace>(body.shape())) return {};
  const SweptVolume volume = swept_volume(body, motion, {.max_parts = most_drawn_parts, .solid = solid});
  return volume.rests ? std::vector<Vec3>() : SurfaceOfParts(volume.model).corners();
}

}  // namespace toccata::io
