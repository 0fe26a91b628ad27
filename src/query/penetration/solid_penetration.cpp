#include "query/penetration/solid_penetration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string_view>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "query/penetration/local_depth.hpp"
#include "query/penetration/separating_search.hpp"
#include "query/penetration/solid_body.hpp"
#include "query/penetration/whole_bodies.hpp"
#include "query/relation/relation_posed.hpp"
#include "query/search_scratch.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/quadrics.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/relation.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata {
namespace {

bool has_open_mesh(const Model& model) {
  if (model.has_mesh()) return !model.closed();
  return std::any_of(model.parts().begin(), model.parts().end(), has_open_mesh);
}

void require_solid(const Model& model, const PosedModel& posed, std::string_view who) {
  if (posed.solid) return;
  if (has_open_mesh(model))
    throw Error(
        fmt::format("penetration: {} is an open mesh, which encloses nothing that another could leave; close it "
                    "(`inspect` names the open edges), take its convex hull instead, or ask for the contacts",
                    who));
  throw Error(
      fmt::format("penetration: {} is taken as a surface, which has no interior that another could leave; take "
                  "it as a solid (solid = auto), or ask for the contacts",
                  who));
}

bool is_half_space(const PosedModel& model) {
  return model.parts.size() == 1 && std::holds_alternative<PosedHalfSpace>(model.parts[0].shape);
}

bool has_parts_without_end(const PosedModel& posed) {
  return !is_half_space(posed) && std::any_of(posed.parts.begin(), posed.parts.end(), [](const PosedPart& part) {
    return std::holds_alternative<PosedHalfSpace>(part.shape);
  });
}

/// The vertices of its triangles or of its core, or the numbers of a quadric; none of a half-space.
std::vector<Vec3> numbers_of(const PosedShape& shape) {
  std::vector<Vec3> vertices;
  if (const auto* triangles = std::get_if<PosedTriangles>(&shape)) {
    for (Index t = 0; t < triangles->mesh.model().element_count(); ++t)
      for (const Vec3& corner : triangles->mesh.triangle(t).vertex) vertices.push_back(corner);
  } else if (const auto* convex = std::get_if<PosedPolytope>(&shape)) {
    for (Index i = 0; i < convex->vertex_count(); ++i) vertices.push_back(convex->vertex(i));
  } else if (const auto* quadric = std::get_if<PosedQuadric>(&shape)) {
    const Mat3& linear = quadric->pose().linear;
    vertices = {quadric->half(), linear[0], linear[1], linear[2], quadric->pose().offset};
  }
  return vertices;
}

/// An order that is the same whichever of the two comes first in the question.
bool is_canonical_order(const PosedModel& a, const PosedModel& b) {
  if (a.parts.size() != b.parts.size()) return a.parts.size() > b.parts.size();
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    if (a.parts[i].kind != b.parts[i].kind) return a.parts[i].kind > b.parts[i].kind;
    const Aabb s = world_box(a.parts[i].shape), t = world_box(b.parts[i].shape);
    if (s.lower != t.lower) return lexicographically_less(s.lower, t.lower);
    if (s.upper != t.upper) return lexicographically_less(s.upper, t.upper);
    const std::vector<Vec3> p = numbers_of(a.parts[i].shape), q = numbers_of(b.parts[i].shape);
    if (p.size() != q.size()) return p.size() > q.size();
    for (std::size_t k = 0; k < p.size(); ++k)
      if (p[k] != q[k]) return lexicographically_less(p[k], q[k]);
  }
  return true;
}

PairQuery moved(PairQuery query, const Vec3& move) {
  query.pose_b.offset = query.pose_b.offset + move;
  return query;
}

Vec3 normal_at(const Model& model, const Pose& pose, Index element) {
  const Triangle t = world_triangle(model, pose, element);
  return unit_or_zero(cross(t[1] - t[0], t[2] - t[0]));
}

/// Those of a mesh and a shape that lies as told.
template <class Shape>
std::vector<SurfaceIntersection> intersections_with_shape(const Model& a, const Shape& shape, const PairQuery& query,
                                                          std::span<const Contact> found) {
  constexpr std::size_t most = 12;
  std::vector<SurfaceIntersection> intersections;
  const std::size_t stride = 1 + found.size() / most;
  for (std::size_t i = stride / 2; i < found.size(); i += stride) {
    const Index element = found[i].element_a;
    const Distance at = distance(PosedPolytope(world_triangle(a, query.pose_a, element)), shape);
    intersections.push_back({at.on_a, normal_at(a, query.pose_a, element), {}});
  }
  return intersections;
}

/// The points of some contacts of meshes, spread over all of them.
std::vector<SurfaceIntersection> some_intersections(const Model& a, const Model& b, const PairQuery& query,
                                                    Workspace& workspace) {
  constexpr std::size_t most = 12;
  std::vector<SurfaceIntersection> intersections;
  if (!a.has_mesh() || kind_of(b.shape()) == ShapeKind::compound) return intersections;
  const PosedShape other = pose_shape(b, query.pose_b, query.solid_b, "model b");
  if (const auto* quadric = std::get_if<PosedQuadric>(&other))
    return intersections_with_shape(a, *quadric, query, contacts(a, b, query, workspace));
  if (!b.has_mesh()) return intersections;
  const auto found = contacts(a, b, query, workspace);
  const std::size_t stride = 1 + found.size() / most;
  for (std::size_t i = stride / 2; i < found.size(); i += stride) {
    const Contact& contact = found[i];
    const IntersectionPoints points =
        intersection_points(contact.intersection, world_triangle(a, query.pose_a, contact.element_a),
                            world_triangle(b, query.pose_b, contact.element_b));
    Vec3 middle;
    for (std::size_t k = 0; k < points.count; ++k) middle = middle + points.points[k];
    intersections.push_back({(1.0 / points.count) * middle, normal_at(a, query.pose_a, contact.element_a),
                             normal_at(b, query.pose_b, contact.element_b)});
  }
  return intersections;
}

/// The same, and those of a mesh and a convex shape.
std::vector<SurfaceIntersection> places_of_contact(const Model& a, const Model& b, const PairQuery& query,
                                                   Workspace& workspace) {
  if (!a.has_mesh() || b.has_mesh() || kind_of(b.shape()) == ShapeKind::compound)
    return some_intersections(a, b, query, workspace);
  const PosedShape other = pose_shape(b, query.pose_b, query.solid_b, "model b");
  const auto* convex = std::get_if<PosedPolytope>(&other);
  if (convex == nullptr) return some_intersections(a, b, query, workspace);
  return intersections_with_shape(a, *convex, query, contacts(a, b, query, workspace));
}

Penetration depth_of_part(const PosedPart& part, const PosedHalfSpace& b) {
  if (const auto* quadric = std::get_if<PosedQuadric>(&part.shape)) return penetration(*quadric, b);
  const PosedModel alone{{part}, true};
  WholeBodies wholes;
  const SolidBody body(alone, wholes);
  return penetration(body.outer(), b);
}

Penetration of_half_space(const PosedModel& a, const PosedHalfSpace& b) {
  Penetration deepest;
  for (const PosedPart& part : a.parts) {
    const Penetration depth = depth_of_part(part, b);
    if (deepest.direction == Vec3{} || depth.upper > deepest.upper) deepest = depth;
  }
  return deepest;
}

/// The bounds of two convex meshes are those of exact arithmetic: a little more, where the moved vertices are rounded
/// to an overlap.
void part_in_doubles(Penetration& depth, const SolidBody& body_a, const SolidBody& body_b,
                     const std::function<bool(const Vec3& move)>& overlapping) {
  for (double more = 0x1p-48 * (body_a.extent() + body_b.extent()) + least_step;
       overlapping(depth.upper * depth.direction); more *= 2)
    depth.upper += more;
}

/// Where they come apart: the points that are the nearest to each other then, moved back.
void add_points(Penetration& depth, const Distance& after) {
  depth.on_a = after.on_a;
  depth.on_b = after.on_b - depth.upper * depth.direction;
}

/// The answer for solids whose interiors do not meet, or not for sure: then the status says so.
Penetration without_overlap(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace,
                            Status status) {
  const Distance between = distance(a, b, query, workspace);
  const Vec3 across = unit_or_zero(between.on_b - between.on_a);
  return {0, 0, across == Vec3{} ? Vec3{0, 0, 1} : across, between.on_a, between.on_b, status};
}

std::size_t triangle_count(const PosedModel& model) {
  std::size_t count = 0;
  for (const PosedPart& part : model.parts)
    if (const auto* triangles = std::get_if<PosedTriangles>(&part.shape))
      count += triangles->mesh.model().element_count();
  return count;
}

/// The narrower of two brackets at each end.
void combine(Penetration& bracket, const Penetration& other) {
  bracket.lower = std::min(std::max(bracket.lower, other.lower), bracket.upper);
  if (!(other.upper < bracket.upper)) return;
  bracket.upper = other.upper;
  bracket.direction = other.direction;
}

/// Those that the workspace keeps from question to question.
WholeBodies& wholes_of(Workspace& workspace) {
  auto& kept = workspace.scratch().whole_bodies;
  if (!kept) kept = std::make_shared<WholeBodies>();
  return *kept;
}

/// The depth of two bounded solids that overlap.
class BodyDepth {
 public:
  BodyDepth(const Model& a, const Model& b, const PairQuery& query, const PosedModelPair& models, Workspace& workspace,
            const DepthOptions& options)
      : a_(a),
        b_(b),
        query_(query),
        models_(models),
        workspace_(workspace),
        limit_(options, &workspace.scratch()),
        is_local_first_(options.precision > DepthOptions{}.precision),
        questions_{[this](const Vec3& move) { return distance_after(move); },
                   [this](const Vec3& move) { return some_intersections(a_, b_, moved(query_, move), workspace_); }} {}
  // The questions refer to it.
  BodyDepth(const BodyDepth&) = delete;
  BodyDepth& operator=(const BodyDepth&) = delete;

  [[nodiscard]] DepthBracket answer() {
    // Whether what has few triangles is convex is soon told, and then its depth is known to the last digits.
    constexpr std::size_t few_triangles = 1000;
    const bool has_few = triangle_count(models_.a) + triangle_count(models_.b) < few_triangles;
    if (has_few || !is_local_first_ || !look_at_the_place()) search();
    bracket_.status = bracket_.upper <= 1.5 * bracket_.lower ? Status::exact : Status::not_converged;
    const DepthEnd end = has_points_ ? DepthEnd::precise : limit_.end_of(bracket_);
    if (!has_points_)
      add_points(bracket_, distance(a_, b_, moved(query_, bracket_.upper * bracket_.direction), workspace_));
    return {bracket_, end};
  }

 private:
  /// What meets needs no distance, for which all triangles that meet a shape are looked at.
  [[nodiscard]] double distance_after(const Vec3& move) const {
    const PairQuery there = moved(query_, move);
    return overlap(a_, b_, there, workspace_) ? 0 : distance(a_, b_, there, workspace_).lower;
  }

  /// Says whether that is enough.
  bool look_at_the_place() {
    was_looked_at_ = true;
    const auto meeting = places_of_contact(a_, b_, query_, workspace_);
    combine(bracket_, local_depth(a_, b_, query_, models_, questions_, meeting, limit_, workspace_.scratch()));
    return limit_.is_narrow(bracket_);
  }

  void search() {
    if (bracket_.upper < infinity && limit_.is_over()) return;
    WholeBodies& wholes = wholes_of(workspace_);
    SolidBody body_a(models_.a, wholes), body_b(models_.b, wholes);
    if (is_known_as_one(body_a, body_b)) return;
    if (is_local_first_ && !was_looked_at_ && look_at_the_place()) return;
    bracket_ = SeparatingSearch(body_a, body_b, questions_, limit_).answer(bracket_);
    if (!was_looked_at_ && !limit_.is_narrow(bracket_) && !limit_.is_over()) look_at_the_place();
  }

  /// Finds the depth of two solids that are each convex or a quadric; false for any others, and where they do not
  /// overlap.
  bool is_known_as_one(const SolidBody& body_a, const SolidBody& body_b) {
    const InnerPart *one_a = body_a.as_one(), *one_b = body_b.as_one();
    if (one_a == nullptr || one_b == nullptr) return false;
    Penetration depth = depth_between(*one_a, *one_b);
    if (!(depth.upper > 0)) return false;
    part_in_doubles(depth, body_a, body_b, [&](const Vec3& move) {
      return relation(a_, b_, moved(query_, move), workspace_).kind == RelationKind::overlapping;
    });
    bracket_ = depth;
    return has_points_ = true;
  }

  const Model& a_;
  const Model& b_;
  const PairQuery& query_;
  const PosedModelPair& models_;
  Workspace& workspace_;
  DepthLimit limit_;
  bool is_local_first_;
  SeparatingQuestions questions_;
  Penetration bracket_{.upper = infinity};
  bool was_looked_at_ = false;
  bool has_points_ = false;
};

DepthBracket in_order(const Model& a, const Model& b, const PairQuery& query, const PosedModelPair& models,
                      const DepthOptions& options, Workspace& workspace) {
  const Relation lie = relation_of(models.a, models.b, workspace.scratch());
  if (lie.kind != RelationKind::overlapping) return {without_overlap(a, b, query, workspace, lie.status)};
  if (is_half_space(models.b)) return {of_half_space(models.a, std::get<PosedHalfSpace>(models.b.parts[0].shape))};
  if (is_half_space(models.a))
    return {flipped(of_half_space(models.b, std::get<PosedHalfSpace>(models.a.parts[0].shape)))};
  return BodyDepth(a, b, query, models, workspace, options).answer();
}

}  // namespace

bool may_be_parted(const PosedModel& a, const PosedModel& b) {
  return !has_parts_without_end(a) && !has_parts_without_end(b) && !(is_half_space(a) && is_half_space(b));
}

DepthBracket depth_of_solids(const Model& a, const Model& b, const PairQuery& query, const PosedModelPair& models,
                             const DepthOptions& options, Workspace& workspace) {
  require_solid(a, models.a, "model a");
  require_solid(b, models.b, "model b");
  if (!may_be_parted(models.a, models.b))
    throw Error(
        "penetration: a compound has a half-space among its parts, which has no end, so that no translation parts it "
        "from another for sure; ask about its parts");
  if (is_canonical_order(models.a, models.b)) return in_order(a, b, query, models, options, workspace);
  const PairQuery other{query.pose_b, query.pose_a, query.solid_b, query.solid_a, query.threads};
  const PosedModelPair exchanged(b, a, other, workspace.scratch());
  DepthBracket found = in_order(b, a, other, exchanged, options, workspace);
  found.penetration = flipped(found.penetration);
  return found;
}

}  // namespace toccata
