#include "query/manifolds/limited_manifold.hpp"

#include <variant>

#include "math/constants.hpp"
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

/// Of the normals that the two elements propose, the allowed one along which they overlap the least.
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
    const double overlap = std::visit(AskOverlapAlong{direction}, a_.part().shape, b_.part().shape);
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

}  // namespace

LimitedManifold limited_manifold(const ContactElement& a, const ContactElement& b, SearchScratch& scratch) {
  scratch.convex = {};  // it was another pair's
  const Manifold shortest = manifold_of(a.part(), b.part(), scratch);
  if (shortest.count == 0 || (a.allows(shortest.normal) && b.allows(-shortest.normal))) return {shortest};
  const LeastAllowed best(a, b, scratch);
  LimitedManifold result;
  result.alone = shortest;
  result.alone.count = 1;
  result.depth_alone = shortest.points[0].depth;
  if (!best.normal()) return result;
  result.manifold = std::visit(AskAlong{*best.normal()}, a.part().shape, b.part().shape);
  result.alone.normal = *best.normal();
  result.alone.points[0].depth = result.depth_alone = best.overlap();
  return result;
}

}  // namespace toccata
