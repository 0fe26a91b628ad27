#include "reports/by_winding.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>
#include <vector>

#include "query/posed_shape.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata::io {
namespace {

bool is_open_mesh(const SceneInstance& posed) {
  return kind_of(posed.model.shape()) == ShapeKind::mesh && posed.solid == Solid::automatic && !posed.model.closed();
}

/// A point of each connected part; none of quadrics and half-spaces.
std::vector<Vec3> points_of(const SceneInstance& posed, const PosedModel& at) {
  std::vector<Vec3> points;
  for (const PosedPart& part : at.parts)
    if (const auto* polytope = std::get_if<PosedPolytope>(&part.shape)) points.push_back(polytope->vertex(0));
  if (!posed.model.has_mesh() || at.parts.size() != 1) return points;
  const TriangleMesh& mesh = posed.model.mesh();
  for (const Index triangle : posed.model.mesh_parts().first_triangle)
    points.push_back(transform(posed.pose, mesh.vertices()[mesh.triangles()[triangle][0]]));
  return points;
}

double magnitude(const WindingNumber& winding) { return std::max(std::abs(winding.lower), std::abs(winding.upper)); }

/// What the surface of the outer winds about the points, where that may be more than a half for some.
struct Inside {
  WindingNumber winding;  ///< the greatest
  bool all = false;
};

std::optional<Inside> inside_of(const SceneInstance& outer, const std::vector<Vec3>& points) {
  std::optional<Inside> found;
  std::size_t count = 0;
  for (const Vec3& point : points) {
    const WindingNumber winding = generalized_winding_number(point, outer.model, outer.pose);
    if (magnitude(winding) <= 0.5) continue;
    ++count;
    if (!found || magnitude(winding) > magnitude(found->winding)) found = Inside{winding, false};
  }
  if (found) found->all = count == points.size();
  return found;
}

bool is_before(const ReportedPair& pair, const IndexPair& other) {
  return pair.a != other.first ? pair.a < other.first : pair.b < other.second;
}

/// What is told of a pair whose faces do not meet, of which one is inside the other, somewhere in `place`: a distance
/// of surfaces is none of solids.
void set_contained(ReportedPair& pair, const Inside& inside, Containment containment, const Aabb& place) {
  pair.relation.kind = RelationKind::overlapping;
  pair.relation.containment = inside.all ? containment : Containment::none;
  pair.relation.status = Status::undecided;
  pair.kind = inside.all ? ClashKind::contains : ClashKind::overlap;
  pair.place = place;
  pair.distance.reset();
  pair.winding = inside.winding;
}

void add(CheckReport& report, const IndexPair& pair, const Inside& inside, Containment containment, const Aabb& box) {
  auto place = std::lower_bound(report.pairs.begin(), report.pairs.end(), pair, is_before);
  const bool is_there = place != report.pairs.end() && place->a == pair.first && place->b == pair.second;
  if (is_there && place->relation.kind != RelationKind::apart) return;  // its faces meet
  if (!is_there) {
    place = report.pairs.insert(place, ReportedPair{});
    place->a = pair.first;
    place->b = pair.second;
  }
  set_contained(*place, inside, containment, box);
  if (report.tolerance) place->tolerance = ToleranceVerdict::undecided;
}

}  // namespace

void add_contained_by_winding(std::span<const SceneInstance> models, const PairFilter& wanted, CheckReport& report) {
  std::vector<PosedModel> posed;
  std::vector<Aabb> boxes;
  for (const SceneInstance& one : models) {
    posed.push_back(pose_model(one.model, one.pose, one.solid, one.name));
    boxes.push_back(world_box(posed.back()));
  }
  for (Index outer = 0; outer < models.size(); ++outer) {
    if (!is_open_mesh(models[outer])) continue;
    for (Index inner = 0; inner < models.size(); ++inner) {
      const IndexPair pair{std::min(outer, inner), std::max(outer, inner)};
      const bool is_of_group = !models[outer].group.empty() && models[outer].group == models[inner].group;
      if (outer == inner || is_of_group || (wanted && !wanted(pair)) || !contains(boxes[outer], boxes[inner])) continue;
      const Containment containment = outer < inner ? Containment::b_in_a : Containment::a_in_b;
      if (const auto inside = inside_of(models[outer], points_of(models[inner], posed[inner])))
        add(report, pair, *inside, containment, boxes[inner]);
    }
  }
}

}  // namespace toccata::io
