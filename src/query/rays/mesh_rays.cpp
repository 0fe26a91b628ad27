#include "query/rays/mesh_rays.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/prefetch.hpp"
#include "math/world_vertex.hpp"
#include "narrow/triangles/passing_rays.hpp"
#include "query/meshes/world_search.hpp"

// The names and bounds are those of docs/design/rays.md.
namespace toccata {
namespace {

/// How much longer the ray is than the part; infinite where it is that by too
/// much.
inline double per_length(double from, double to) { return to - from > 0x1p-60 ? 1 / (to - from) : HUGE_VAL; }

/// A search for the first of the triangles that it is told of.
class FirstHit {
 public:
  /// Limits are told as parts of the way between two times.
  explicit FirstHit(const PreparedRay& ray, double from = 0, double to = 1)
      : ray_(ray), from_(from), per_length_(per_length(from, to)) {}

  /// `passes`: the ray's line is known to pass through the triangle.
  void consider(const Triangle& triangle, Index number, bool passes = false) {
    take(passes ? ray_time_of_passing(ray_, triangle) : ray_time(ray_, triangle), number);
  }

  /// True where that is the first now.
  bool take(const RayTime& time, Index number) {
    if (!time.hit) return false;
    lower_ = std::min(lower_, time.lower);
    if (time.upper > time_.upper) return false;
    if (time.upper == time_.upper && time_.hit && triangle_ < number) return false;
    time_ = time;
    triangle_ = number;
    // Not less, and so that every triangle whose interval begins before this
    // one's is told of on any way to it: the answer's lower end must not depend
    // on the way.
    const double part = (time.upper + widest_time - from_) * per_length_;
    limit_ = part < 1 ? static_cast<float>(std::max(part, 0.0)) + 0x1p-19F : 1;
    return true;
  }

  /// What is met later than at this part of the way is of no interest.
  [[nodiscard]] float limit() const { return limit_; }
  [[nodiscard]] TriangleHit best() const { return {time_, triangle_, time_.hit ? lower_ : 0}; }

 private:
  const PreparedRay& ray_;
  double from_;
  double per_length_;
  float limit_ = 1;
  RayTime time_{false, 0, HUGE_VAL};
  double lower_ = HUGE_VAL;  ///< of all that are met
  Index triangle_ = 0;
};

RayTime time_of(const Cast& cast) { return {true, cast.lower, cast.upper}; }

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
    : model_(mesh.model()),
      posed_(&mesh),
      mesh_(model_.mesh()),
      tree_(model_.wide_bvh()),
      leaves_(nullptr),
      own_frame_(ray_frame(tree_, WayIntoTree(mesh), mesh.pose().offset)),
      stands_(mesh.pose() == Pose{}) {}

RayTarget::RayTarget(const Model& standing, const LeafTriangles* leaves)
    : model_(standing),
      posed_(nullptr),
      mesh_(standing.mesh()),
      tree_(standing.wide_bvh()),
      leaves_(leaves),
      stands_(true) {
  if (leaves == nullptr) own_frame_ = ray_frame(tree_, WayIntoTree(tree_), {});
}

template <class Search>
void RayTarget::consider(const RayCandidate& candidate, Search& search) const {
  if (!(candidate.lower > search.limit()))
    search.consider(world_triangle(candidate.triangle), candidate.triangle, candidate.certain);
}

TriangleHit RayTarget::first_hit(const PreparedRay& ray) const {
  if (!frame().usable) return search_in_world(ray);
  const RayInTree way = ray_into_tree(frame(), ray);
  if (!way.known) return search_in_world(ray);
  if (way.misses()) return {};
  FirstHit hit(ray, way.from, way.to);
  // Nearly always one triangle is left at the end, and certain: all of the answer is told at once.
  PassingHit last_one;
  walk_rays(tree_, leaves_for(1), {&way.ray, 1}, [&](std::size_t, std::span<const RayCandidate> candidates, bool last) {
    if (last && candidates.size() == 1 && candidates[0].certain)
      last_one = hit_of_passing({&ray, world_triangle(candidates[0].triangle)});
    if (last_one.told)
      last_one.told = hit.take(time_of(last_one.cast), candidates[0].triangle);
    else
      for (const RayCandidate& one : candidates) consider(one, hit);
    return hit.limit();
  });
  TriangleHit first = hit.best();
  if (last_one.told) first.cast = last_one.cast;
  return first;
}

void RayTarget::first_hits(std::span<const PreparedRay> rays, std::span<TriangleHit> hits) const {
  if (!frame().usable) {
    std::transform(rays.begin(), rays.end(), hits.begin(),
                   [&](const PreparedRay& ray) { return search_in_world(ray); });
    return;
  }
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
  explicit Together(std::size_t count) : ways(count) {
    walking.reserve(count);
    found.reserve(count);
    number_of.reserve(count);
    last.reserve(count);
    passing.reserve(count);
  }
  std::vector<RayInTree> ways;
  std::vector<WideRay> walking;
  std::vector<FirstHit> found;
  std::vector<std::size_t> number_of;
  std::vector<Last> last;  ///< what is looked at when all have walked, and is
                           ///< asked for in the meantime
  std::vector<PassingRay> passing;
  std::vector<PassingHit> told;
};

void RayTarget::search_together(std::span<const PreparedRay> rays, std::span<TriangleHit> hits) const {
  Together all(rays.size());
  rays_into_tree(frame(), rays, all.ways);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const RayInTree& way = all.ways[i];
    hits[i] = way.known ? TriangleHit{} : search_in_world(rays[i]);
    if (!way.known || way.misses()) continue;
    all.walking.push_back(way.ray);
    all.found.emplace_back(rays[i], way.from, way.to);
    all.number_of.push_back(i);
  }
  walk_rays(tree_, leaves_for(all.walking.size()), all.walking,
            [&](std::size_t i, std::span<const RayCandidate> candidates, bool last) {
              if (last && candidates.size() == 1) {
                prefetch(mesh_.triangles()[candidates[0].triangle]);
                all.last.push_back({i, candidates[0]});
              } else {
                for (const RayCandidate& one : candidates) consider(one, all.found[i]);
              }
              return all.found[i].limit();
            });
  for (const auto& [ray, candidate] : all.last)
    for (const Index corner : mesh_.triangles()[candidate.triangle]) prefetch(mesh_.vertices()[corner]);
  for (const auto& [ray, candidate] : all.last)
    if (candidate.certain)
      all.passing.push_back({&rays[all.number_of[ray]], world_triangle(candidate.triangle)});
    else
      consider(candidate, all.found[ray]);
  for (std::size_t i = 0; i < all.found.size(); ++i) hits[all.number_of[i]] = all.found[i].best();
  take_passing(all, hits);
}

void RayTarget::take_passing(Together& all, std::span<TriangleHit> hits) const {
  all.told.resize(all.passing.size());
  hits_of_passing(all.passing, all.told);
  std::size_t next = 0;
  for (const auto& [ray, candidate] : all.last) {
    if (!candidate.certain) continue;
    const PassingHit& told = all.told[next++];
    FirstHit& found = all.found[ray];
    TriangleHit& hit = hits[all.number_of[ray]];
    const bool first = told.told && found.take(time_of(told.cast), candidate.triangle);
    if (!told.told) consider(candidate, found);
    hit = found.best();
    if (first) hit.cast = told.cast;
  }
}

Triangle RayTarget::world_triangle(Index number) const {
  const auto& corner = mesh_.triangles()[number];
  const Vec3* vertices = mesh_.vertices().data();
  if (stands_) return {{vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]}};
  const Pose& pose = posed_->pose();
  return {{world_vertex(pose, vertices[corner[0]]), world_vertex(pose, vertices[corner[1]]),
           world_vertex(pose, vertices[corner[2]])}};
}

TriangleHit RayTarget::search_in_world(const PreparedRay& ray) const {
  FirstHit hit(ray);
  const PosedMesh& posed = posed_ != nullptr ? *posed_ : PosedMesh(model_, Pose{});
  visit_triangles_near(posed, region_of(ray), [&](Index triangle) {
    hit.consider(world_triangle(triangle), triangle);
    return true;
  });
  return hit.best();
}

}  // namespace toccata
