#include "query/penetration/separating_seeds.hpp"

#include <algorithm>
#include <array>

#include "math/vec3_measures.hpp"
#include "query/meshes/world_search.hpp"

namespace toccata {
namespace {

Vec3 plain_normal(const Triangle& t) { return plain_unit_or_zero(cross(t[1] - t[0], t[2] - t[0])); }

class SeedSearch {
 public:
  explicit SeedSearch(const MovedPair& pair) : pair_(pair) {
    common_ = {};
    const Aabb &a = pair.a.box(), &b = pair.b.box();
    for (int axis = 0; axis < 3; ++axis) {
      common_.lower[axis] = std::max(a.lower[axis], b.lower[axis] + pair.move[axis]);
      common_.upper[axis] = std::min(a.upper[axis], b.upper[axis] + pair.move[axis]);
    }
    size_ = plain_length(common_.upper - common_.lower);
  }

  /// From where the surfaces meet, to all four sides.
  void look_between(const SurfaceIntersection& intersection) {
    for (const Vec3& towards :
         {-intersection.normal_a - intersection.normal_b, intersection.normal_a + intersection.normal_b,
          intersection.normal_a - intersection.normal_b, intersection.normal_b - intersection.normal_a})
      look_along(intersection.point, towards);
  }

  /// From points on the surface of `own` inside the other: inwards.
  void look_below_surface(const SolidBody& own, const Vec3& moved) {
    for (const PosedPart& part : own.parts())
      if (const InnerPart* inner = own.within(part))
        look_into(inner->shape, moved);
      else if (const auto* triangles = std::get_if<PosedTriangles>(&part.shape))
        look_below(triangles->mesh, moved);
  }

  [[nodiscard]] std::vector<SeparatingSeed> deepest(std::size_t most) {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const SeparatingSeed& s, const SeparatingSeed& t) { return s.depth > t.depth; });
    std::vector<SeparatingSeed> chosen;
    for (const SeparatingSeed& seed : found_) {
      const bool far = std::all_of(chosen.begin(), chosen.end(), [&](const SeparatingSeed& other) {
        return plain_length(other.point - seed.point) >= seed.depth;
      });
      if (far) chosen.push_back(seed);
      if (chosen.size() == most) break;
    }
    return chosen;
  }

 private:
  [[nodiscard]] bool in_both(const Vec3& point) const {
    return overlap(common_, Aabb{point, point}) && pair_.a.contains(point) && pair_.b.contains(point - pair_.move);
  }

  void look_along(const Vec3& from, const Vec3& towards) {
    constexpr int most_halvings = 24;
    const double size = plain_length(towards);
    if (!(size > 0x1p-20)) return;
    double step = size_ / 2;
    for (int i = 0; i < most_halvings; ++i, step /= 2) {
      const Vec3 point = from + (step / size) * towards;
      if (!in_both(point)) continue;
      found_.push_back({point, step});
      return;
    }
  }

  void look_into(const PosedPolytope& convex, const Vec3& moved) {
    Vec3 middle;
    for (Index i = 0; i < convex.vertex_count(); ++i) middle = middle + convex.vertex(i);
    middle = (1.0 / convex.vertex_count()) * middle + moved;
    if (in_both(middle)) found_.push_back({middle, size_ / 2});
    for (Index i = 0; i < convex.vertex_count(); i += 1 + convex.vertex_count() / 16)
      look_along(convex.vertex(i) + moved, middle - convex.vertex(i) - moved);
  }

  void look_below(const PosedMesh& mesh, const Vec3& moved) {
    constexpr std::size_t most_samples = 24;
    std::vector<Index> near;
    visit_triangles_near(mesh, {common_.lower - moved, common_.upper - moved}, [&](Index i) {
      near.push_back(i);
      return true;
    });
    std::sort(near.begin(), near.end());
    const std::size_t stride = 1 + near.size() / most_samples;
    for (std::size_t i = 0; i < near.size(); i += stride) {
      const Triangle t = mesh.triangle(near[i]);
      const Vec3 normal = plain_normal(t), middle = (1.0 / 3) * (t[0] + t[1] + t[2]) + moved;
      for (const Vec3& from : {middle, t[0] + moved + 0x1p-10 * (middle - t[0] - moved)}) {
        look_along(from, -normal);
        look_along(from, normal);
      }
    }
  }

  const MovedPair& pair_;
  Aabb common_;
  double size_ = 0;
  std::vector<SeparatingSeed> found_;
};

}  // namespace

std::vector<SeparatingSeed> find_seeds(const MovedPair& pair, const std::vector<SurfaceIntersection>& intersections,
                                       std::size_t most) {
  SeedSearch search(pair);
  for (const SurfaceIntersection& intersection : intersections) search.look_between(intersection);
  search.look_below_surface(pair.a, {});
  search.look_below_surface(pair.b, pair.move);
  return search.deepest(most);
}

}  // namespace toccata
