#include "query/manifolds/limited_manifold.hpp"

#include <algorithm>
#include <optional>
#include <variant>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/contact/manifold_along.hpp"
#include "query/contacts/part_contacts.hpp"

namespace toccata {
namespace {

struct AskAlong {
  Manifold operator()(const PosedPolytope& a, const PosedPolytope& b) const { return manifold_along(a, b, direction); }
  Manifold operator()(const PosedQuadric& a, const PosedPolytope& b) const { return manifold_along(a, b, direction); }
  Manifold operator()(const PosedPolytope& a, const PosedQuadric& b) const {
    return flipped(manifold_along(b, a, -direction));
  }
  /// No triangle is one of the two, and nothing limits their normal.
  template <class A, class B>
  Manifold operator()(const A&, const B&) const {
    return {};
  }

  const Vec3& direction;
};

struct AskOverlapAlong {
  double operator()(const PosedPolytope& a, const PosedPolytope& b) const { return overlap_along(a, b, direction); }
  double operator()(const PosedQuadric& a, const PosedPolytope& b) const { return overlap_along(a, b, direction); }
  double operator()(const PosedPolytope& a, const PosedQuadric& b) const { return overlap_along(b, a, -direction); }
  template <class A, class B>
  double operator()(const A&, const B&) const {
    return 0;
  }

  const Vec3& direction;
};

Manifold points_along(const ContactElement& a, const ContactElement& b, const Vec3& normal) {
  return std::visit(AskAlong{normal}, a.part().shape, b.part().shape);
}

double overlap_of(const ContactElement& a, const ContactElement& b, const Vec3& normal) {
  return std::visit(AskOverlapAlong{normal}, a.part().shape, b.part().shape);
}

/// The allowed one of the normals that the two elements propose along which they overlap the least.
class LeastAllowed {
 public:
  LeastAllowed(const ContactElement& a, const ContactElement& b, SearchScratch& scratch)
      : a_(a), b_(b), scratch_(scratch) {
    a.visit_normals([&](const Vec3& normal) { consider(normal); });
    b.visit_normals([&](const Vec3& normal) { consider(-normal); });
    // Where an edge or a vertex of one is in the other, the shortest way out of that.
    a.visit_ridges([&](const PosedPart& ridge) { consider(ridge, b_.part()); });
    b.visit_ridges([&](const PosedPart& ridge) { consider(a_.part(), ridge); });
  }

  [[nodiscard]] const std::optional<Vec3>& normal() const { return normal_; }
  [[nodiscard]] double overlap() const { return overlap_; }

 private:
  /// One of the two is a part of an element: if that is what the element has farthest along the direction, they
  /// overlap along it as deep.
  void consider(const PosedPart& a, const PosedPart& b) {
    constexpr double same_depth = 1 + 0x1p-20;
    scratch_.convex = {};  // it was another pair's
    if (const Manifold found = manifold_of(a, b, scratch_); found.count > 0)
      consider(found.normal, same_depth * found.points[0].depth);
  }

  void consider(const Vec3& direction, double most = infinity) {
    const double overlap = overlap_of(a_, b_, direction);
    if (overlap > most || (normal_ && overlap >= overlap_)) return;
    if (!a_.allows(direction) || !b_.allows(-direction)) return;
    normal_ = direction;
    overlap_ = overlap;
  }

  const ContactElement& a_;
  const ContactElement& b_;
  SearchScratch& scratch_;
  std::optional<Vec3> normal_;
  double overlap_ = 0;
};

/// How far a point is within a triangle, seen along its normal: from the nearest side, negative outside.
double depth_inside(const Triangle& triangle, const Vec3& normal, const Vec3& point) {
  double least = infinity;
  for (int i = 0; i < 3; ++i) {
    const Vec3 inwards = cross(normal, unit_or_zero(triangle[(i + 1) % 3] - triangle[i]));
    least = std::min(
        least, dot(inwards, point - triangle[i]) * (dot(inwards, triangle[(i + 2) % 3] - triangle[i]) < 0 ? -1 : 1));
  }
  return least;
}

/// The middle of the points that are as deep as any.
Vec3 middle_of_deepest(const Manifold& manifold, double depth) {
  Vec3 sum;
  int count = 0;
  for (int i = 0; i < manifold.count; ++i)
    if (manifold.points[static_cast<std::size_t>(i)].depth >= (1 - 0x1p-20) * depth) {
      sum = sum + manifold.points[static_cast<std::size_t>(i)].position;
      ++count;
    }
  return count > 0 ? (1.0 / count) * sum : Vec3{};
}

/// A triangle of a mesh and something that needs no tree, which is on the side to which `outwards` · normal leads. The
/// normal is the answer where nothing else is allowed. It is, too, where that is deepest over a point of the triangle
/// and the sides are as far from there as it is deep: along a direction at an angle θ up to a right one the two
/// overlap by r sin θ + d cos θ at least, with the distance r to the nearest side and the depth d, and that is no less
/// than d where r is not.
std::optional<Manifold> over_face(const ContactElement& a, const ContactElement& b) {
  const bool is_of_a = a.around().has_value();
  const TriangleSurroundings& around = is_of_a ? *a.around() : *b.around();
  if (around.normal() == Vec3{}) return {};
  Vec3 normal = is_of_a ? around.normal() : -around.normal();
  double depth = overlap_of(a, b, normal);
  if (!around.is_of_solid())
    if (const double other = overlap_of(a, b, -normal); other < depth) {
      normal = -normal;
      depth = other;
    }
  Manifold manifold = points_along(a, b, normal);
  const auto is_deep_within = [&] {
    double deepest = -infinity;
    for (int i = 0; i < manifold.count; ++i)
      deepest = std::max(deepest, manifold.points[static_cast<std::size_t>(i)].depth);
    return deepest >= (1 - 0x1p-20) * depth &&
           depth_inside(around.corners(), normal, middle_of_deepest(manifold, deepest)) >= depth;
  };
  if (manifold.count > 0 && is_deep_within()) return manifold;
  return around.is_flat() ? std::optional(manifold) : std::nullopt;
}

}  // namespace

Manifold limited_manifold(const ContactElement& a, const ContactElement& b, SearchScratch& scratch) {
  if (a.around().has_value() != b.around().has_value())
    if (const std::optional<Manifold> found = over_face(a, b)) return *found;
  scratch.convex = {};  // it was another pair's
  const Manifold shortest = manifold_of(a.part(), b.part(), scratch);
  if (shortest.count == 0 || (a.allows(shortest.normal) && b.allows(-shortest.normal))) return shortest;
  const LeastAllowed best(a, b, scratch);
  return best.normal() ? points_along(a, b, *best.normal()) : Manifold{};
}

LoneContact lone_contact(const ContactElement& a, const ContactElement& b, SearchScratch& scratch) {
  scratch.convex = {};  // it was another pair's
  LoneContact lone{manifold_of(a.part(), b.part(), scratch)};
  if (lone.manifold.count == 0) return lone;
  lone.manifold.count = 1;
  lone.depth = lone.manifold.points[0].depth;
  if (const LeastAllowed best(a, b, scratch); best.normal()) {
    lone.manifold.normal = *best.normal();
    lone.manifold.points[0].depth = lone.depth = best.overlap();
  }
  return lone;
}

}  // namespace toccata
