#include "query/mesh_rays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "math/world_vertex.hpp"
#include "query/world_search.hpp"

// The names and bounds are those of docs/design/rays.md.
namespace toccata {
namespace {

inline double greatest_of(const Vec3& v) { return std::max(std::max(std::fabs(v.x), std::fabs(v.y)), std::fabs(v.z)); }

/// The part of the way on which a line is within a box, up to what rounding adds; empty when it never is.
struct PartOfWay {
  double from = 0;
  double to = 1;
  [[nodiscard]] bool empty() const { return from > to; }
};

inline PartOfWay stretch_within(const Aabb& box, double around, const Vec3& origin, const Vec3& motion) {
  constexpr double slack = 0x1p-50;
  PartOfWay stretch;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = (box.lower[axis] - around) - origin[axis], high = (box.upper[axis] + around) - origin[axis];
    if (motion[axis] == 0) {
      if (low > 0 || high < 0) return {1, 0};
      continue;
    }
    const double inverse = 1 / motion[axis];
    const double s = low * inverse, t = high * inverse;
    const double enter = std::min(s, t), leave = std::max(s, t);
    stretch.from = std::max(stretch.from, enter - slack * std::fabs(enter));
    stretch.to = std::min(stretch.to, leave + slack * std::fabs(leave));
  }
  return stretch;
}

/// How much longer the ray is than the stretch; infinite where it is that by too much.
inline double per_length(const PartOfWay& stretch) {
  return stretch.to - stretch.from > 0x1p-60 ? 1 / (stretch.to - stretch.from) : HUGE_VAL;
}

/// A search for the first of the triangles that it is told of.
class FirstHit {
 public:
  FirstHit(const PreparedRay& ray, const PartOfWay& stretch)
      : ray_(ray), from_(stretch.from), per_length_(per_length(stretch)) {}

  /// `passes`: the ray's line is known to pass through the triangle.
  void consider(const Triangle& triangle, Index number, bool passes = false) {
    const RayTime time = passes ? ray_time_of_passing(ray_, triangle) : ray_time(ray_, triangle);
    if (!time.hit || time.upper > best_.time.upper) return;
    if (time.upper == best_.time.upper && best_.time.hit && best_.triangle < number) return;
    best_ = {time, number};
    // As a part of the stretch; not less.
    const double part = std::fmax(0, (time.upper - from_) * per_length_);
    limit_ = part < 1 ? static_cast<float>(part) + 0x1p-19F : 1;
  }

  /// What is met later than at this part of the stretch is of no interest.
  [[nodiscard]] float limit() const { return limit_; }
  [[nodiscard]] const TriangleHit& best() const { return best_; }

 private:
  const PreparedRay& ray_;
  double from_;
  double per_length_;
  float limit_ = 1;
  TriangleHit best_{{false, 0, HUGE_VAL}};
};

Aabb region_of(const PreparedRay& ray) {
  Aabb region;
  for (int axis = 0; axis < 3; ++axis) {
    const double from = ray.origin[axis], to = from + ray.motion[axis];
    region.lower[axis] = std::min(from, std::nextafter(to, -HUGE_VAL));
    region.upper[axis] = std::max(from, std::nextafter(to, HUGE_VAL));
  }
  return region;
}

}  // namespace

RayTarget::RayTarget(const PosedMesh& mesh)
    : posed_(mesh),
      mesh_(mesh.model().mesh()),
      tree_(mesh.model().wide_tree()),
      way_(mesh),
      stands_(mesh.pose() == Pose{}) {
  const double scale = 1 / tree_.unit;
  const Vec3 origin = scale * tree_.origin;
  box_ = {scale * tree_.box.lower - origin, scale * tree_.box.upper - origin};
}

/// A ray in the tree's units.
struct RayTarget::InTree {
  PartOfWay stretch;  ///< of the ray: what is within the tree's box
  WideRay ray;        ///< that stretch
};

std::optional<RayTarget::InTree> RayTarget::in_tree(const PreparedRay& ray) const {
  constexpr double longest = 0x1p46, most_off = 1, most_off_for_triangles = 0x1p-5;
  const Vec3 motion = way_.direction(ray.motion);
  const double off = way_.off(greatest_of(ray.origin) + ray.largest);
  if (!way_.usable() || !(greatest_of(motion) < longest) || !(off < most_off)) return {};
  const Vec3 origin = way_.place(ray.origin - posed_.pose().offset);
  InTree found{stretch_within(box_, off + 0x1p-40, origin, motion), {}};
  // Floats, and the doubles here, round less than 2^-20 of what is at most 8, and 2^-50 of what cancels.
  found.ray.pad = static_cast<float>(off + 0x1p-20 + 0x1p-50 * (greatest_of(origin) + greatest_of(motion)));
  if (off <= most_off_for_triangles && tree_.unit < 0x1p1023)
    found.ray.lean =
        static_cast<float>(way_.off_of_direction(ray.largest) * (1 + 0x1p-20) / greatest_of(motion)) + 0x1p-40F;
  // As wide as a time may be told to be.
  found.ray.late = static_cast<float>(0x1p-40 * per_length(found.stretch));
  const double length = found.stretch.to - found.stretch.from;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    found.ray.origin[i] = static_cast<float>(origin[axis] + found.stretch.from * motion[axis]);
    found.ray.motion[i] = static_cast<float>(length * motion[axis]);
  }
  return found;
}

template <class Search>
void RayTarget::consider(const RayCandidate& candidate, Search& search) const {
  if (!(candidate.lower > search.limit()))
    search.consider(world_triangle(candidate.triangle), candidate.triangle, candidate.certain);
}

TriangleHit RayTarget::first_hit(const PreparedRay& ray) const {
  const std::optional<InTree> way = in_tree(ray);
  if (!way) return search_in_world(ray);
  if (way->stretch.empty()) return {};
  FirstHit hit(ray, way->stretch);
  walk_rays(tree_, posed_.model().leaf_triangles_for(1), {&way->ray, 1},
            [&](std::size_t, std::span<const RayCandidate> candidates, bool) {
              for (const RayCandidate& one : candidates) consider(one, hit);
              return hit.limit();
            });
  return hit.best();
}

void RayTarget::first_hits(std::span<const PreparedRay> rays, std::span<TriangleHit> hits) const {
  for (std::size_t first = 0; first < rays.size(); first += together) {
    const std::size_t count = std::min(together, rays.size() - first);
    search_together(rays.subspan(first, count), hits.subspan(first, count));
  }
}

/// Rays on their way together, and what they have met.
struct RayTarget::Together {
  struct Last {
    std::size_t ray;
    RayCandidate candidate;
  };
  explicit Together(std::size_t count) {
    walking.reserve(count);
    found.reserve(count);
    number_of.reserve(count);
    last.reserve(count);
  }
  std::vector<WideRay> walking;
  std::vector<FirstHit> found;
  std::vector<std::size_t> number_of;
  std::vector<Last> last;  ///< what is looked at when all have walked, and is asked for in the meantime
};

void RayTarget::search_together(std::span<const PreparedRay> rays, std::span<TriangleHit> hits) const {
  Together all(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::optional<InTree> way = in_tree(rays[i]);
    hits[i] = way ? TriangleHit{} : search_in_world(rays[i]);
    if (!way || way->stretch.empty()) continue;
    all.walking.push_back(way->ray);
    all.found.emplace_back(rays[i], way->stretch);
    all.number_of.push_back(i);
  }
  walk_rays(tree_, posed_.model().leaf_triangles_for(all.walking.size()), all.walking,
            [&](std::size_t i, std::span<const RayCandidate> candidates, bool last) {
              if (last && candidates.size() == 1) {
                __builtin_prefetch(&mesh_.triangles()[candidates[0].triangle]);
                all.last.push_back({i, candidates[0]});
              } else {
                for (const RayCandidate& one : candidates) consider(one, all.found[i]);
              }
              return all.found[i].limit();
            });
  for (const auto& [ray, candidate] : all.last)
    for (const Index corner : mesh_.triangles()[candidate.triangle]) __builtin_prefetch(&mesh_.vertices()[corner]);
  for (const auto& [ray, candidate] : all.last) consider(candidate, all.found[ray]);
  for (std::size_t i = 0; i < all.found.size(); ++i) hits[all.number_of[i]] = all.found[i].best();
}

Triangle RayTarget::world_triangle(Index number) const {
  const auto& corner = mesh_.triangles()[number];
  const Vec3* vertices = mesh_.vertices().data();
  if (stands_) return {{vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]}};
  const Pose& pose = posed_.pose();
  return {{world_vertex(pose, vertices[corner[0]]), world_vertex(pose, vertices[corner[1]]),
           world_vertex(pose, vertices[corner[2]])}};
}

TriangleHit RayTarget::search_in_world(const PreparedRay& ray) const {
  FirstHit hit(ray, {});
  visit_triangles_near(posed_, region_of(ray), [&](Index triangle) {
    hit.consider(world_triangle(triangle), triangle);
    return true;
  });
  return hit.best();
}

}  // namespace toccata
