#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "math/vec3_measures.hpp"
#include "narrow/casts_checks.hpp"
#include "query/casts/mesh_casts.hpp"
#include "query/posed_shape.hpp"
#include "query/shape_pairs_checks.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/query/casts.hpp"

// What casts of meshes have to be: by the cast of every pair of triangles, and by the oracle's sets.
namespace toccata::test {

/// A model's elements at their place, as convex shapes: triangles of a mesh, else the shape itself.
inline std::vector<PosedPolytope> elements_of(const Model& model, const Pose& pose) {
  if (!model.has_mesh()) return {std::get<PosedPolytope>(pose_shape(model, pose, Solid::automatic, "the shape"))};
  std::vector<PosedPolytope> elements;
  for (Index i = 0; i < model.element_count(); ++i) elements.emplace_back(world_triangle(model, pose, i));
  return elements;
}

/// The cast of every pair of elements, by no tree; faces are left 0.
inline std::optional<ShapeHit> cast_of_all_elements(const Model& a, const Vec3& motion, const Model& b,
                                                    const PairQuery& query) {
  const std::vector<PosedPolytope> of_a = elements_of(a, query.pose_a), of_b = elements_of(b, query.pose_b);
  std::optional<ShapeHit> first;
  for (Index i = 0; i < of_a.size(); ++i)
    for (Index j = 0; j < of_b.size(); ++j)
      if (const std::optional<Cast> found = cast_shape(of_a[i], motion, of_b[j]))
        keep_first(first, {*found, i, j, 0, 0});
  return first;
}

/// What is wrong with the cast of two models of which one is a mesh at least, and neither a compound.
inline std::string mesh_cast_fault(const Model& a, const Vec3& motion, const Model& b, const PairQuery& query) {
  std::optional<ShapeHit> found = cast_shape(a, motion, b, query);
  const std::optional<ShapeHit> all = cast_of_all_elements(a, motion, b, query);
  if (overlap(a, b, query)) {
    if (!found || found->upper != 0) return "they meet at the start";
    const bool surfaces_meet = all.has_value() && all->upper == 0;
    const bool named_meet =
        overlap(elements_of(a, query.pose_a)[found->element_a], elements_of(b, query.pose_b)[found->element_b]);
    if (surfaces_meet && !named_meet) return "the elements named do not meet at the start";
    if (surfaces_meet && !(std::fabs(plain_length(found->normal) - 1) < 1e-12)) return "no normal at the start";
    return "";
  }
  if (!found || !all) return found.has_value() == all.has_value() ? "" : "met by one";
  if (a.has_mesh() && found->face_a != a.mesh().face_of(found->element_a)) return "face of a";
  if (b.has_mesh() && found->face_b != b.mesh().face_of(found->element_b)) return "face of b";
  found->face_a = found->face_b = 0;
  return found == all ? "" : "not the first of all pairs";
}

/// The same of a convex shape and one that is the mesh of its own hull, by the oracle.
inline std::string hull_cast_fault(const ConvexCase& pair, const Vec3& motion) {
  const std::optional<Model> mesh_a = as_mesh(pair.a), mesh_b = as_mesh(pair.b);
  const oracle::ConvexSet set_a = set_of(pair.a), set_b = set_of(pair.b);
  const auto solid = [](const PlacedPolytope& placed) { return is_solid(placed) ? Solid::all : Solid::none; };
  const Model a = model_of(pair.a.shape), b = model_of(pair.b.shape);
  if (mesh_a) {
    const PairQuery query{.pose_b = pair.b.pose, .solid_a = solid(pair.a)};
    const std::string fault = cast_fault(cast_shape(*mesh_a, motion, b, query), set_a, motion, set_b);
    if (!fault.empty()) return "a mesh moves: " + fault;
  }
  if (mesh_b) {
    const PairQuery query{.pose_a = pair.a.pose, .solid_b = solid(pair.b)};
    const std::string fault = cast_fault(cast_shape(a, motion, *mesh_b, query), set_a, motion, set_b);
    if (!fault.empty()) return "a mesh stands: " + fault;
  }
  if (!mesh_a || !mesh_b) return "";
  const PairQuery query{.solid_a = solid(pair.a), .solid_b = solid(pair.b)};
  const std::string fault = cast_fault(cast_shape(*mesh_a, motion, *mesh_b, query), set_a, motion, set_b);
  return fault.empty() ? "" : "two meshes: " + fault;
}

/// How a shape comes to a mesh.
inline const std::vector<std::string>& mesh_cast_families() {
  static const std::vector<std::string> all{
      "anywhere", "at a face", "along a face", "ends on a corner", "starts on a corner", "away",
      "far",      "long",      "still",        "two meshes"};
  return all;
}

struct MeshCastCase {
  Model a;
  Model b;
  PairQuery query;
  Vec3 motion;
};

inline Vec3 vector_within(Random& random, double size) {
  const double x = random.between(-size, size), y = random.between(-size, size);
  return {x, y, random.between(-size, size)};
}

/// A convex shape of a random kind moves at a soup of triangles, or a soup at another.
inline MeshCastCase mesh_cast_case(const std::string& family, Random& random) {
  const bool snapped = random.below(3) == 0;
  const Model b(random_soup(random, 14, 0.4, snapped ? 8 : 0));
  const std::string& poses = snapped ? "snapped" : pose_families()[random.below(pose_families().size())];
  const std::string& kind = convex_kinds()[random.below(convex_kinds().size())];
  MeshCastCase c{Point(), b, random_poses(poses, random), {}};
  if (family == "two meshes") {
    c.a = Model(random_soup(random, 8, 0.4, snapped ? 8 : 0));
  } else {
    c.a = snapped ? Model(Box({0.125, 0.25, 0.5})) : model_of(random_convex(kind, random));
    c.query.pose_a.linear = snapped ? Mat3{} : random_rotation(random);
  }
  const Triangle t = world_triangle(b, c.query.pose_b, static_cast<Index>(random.below(b.element_count())));
  const PosedPolytope first = elements_of(c.a, c.query.pose_a)[0];
  const Vec3 from = first.vertex(0);
  const double reach = sum_of_magnitudes(t[1] - t[0]) + sum_of_magnitudes(t[2] - t[0]);
  const Vec3 inside = 0.25 * t[0] + 0.25 * t[1] + 0.5 * t[2];
  c.motion = inside - from + vector_within(random, 2 * reach);
  if (family == "at a face") c.motion = 2 * (inside - from);
  if (family == "ends on a corner") c.motion = t[1] - from;
  if (family == "away") c.motion = from - inside;
  if (family == "short") c.motion = 1e-6 * c.motion;
  if (family == "long") c.motion = 1e6 * c.motion;
  if (family == "still") c.motion = {};
  if (family == "along a face" || family == "starts on a corner")
    c.query.pose_a.offset = c.query.pose_a.offset + (t[0] - from);
  if (family == "along a face") {
    c.query.pose_a.offset = c.query.pose_a.offset - 2 * (t[1] - t[0]);
    c.motion = 4 * (t[1] - t[0]);
  }
  return c;
}

}  // namespace toccata::test
