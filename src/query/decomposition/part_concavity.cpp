#include "query/decomposition/part_concavity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "math/vec3_measures.hpp"
#include "toccata/query/inside.hpp"
#include "toccata/query/relation.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata {
namespace {

constexpr int most_questions = 10'000;
constexpr double fraction = 0.05;

using Tetrahedron = std::array<Vec3, 4>;

struct Region {
  Tetrahedron corners;  ///< local
  double upper = 0;     ///< no point of it is farther from the solid
  friend bool operator<(const Region& a, const Region& b) { return a.upper < b.upper; }
};

Vec3 middle_of(const ConvexHull& hull) {
  Vec3 sum{};
  for (Index v = 0; v < hull.vertex_count(); ++v) sum = sum + (1.0 / hull.vertex_count()) * hull.vertex(v);
  return sum;
}

double square_of(const Vec3& v) { return dot(v, v); }

double largest_of(const Aabb& box) { return std::fmax(largest_magnitude(box.lower), largest_magnitude(box.upper)); }

class ConcavitySearch {
 public:
  ConcavitySearch(const ConvexHull& hull, const Model& solid, const SolidFrame& frame)
      : solid_(solid), frame_(frame), slack_(0x1p-46 * largest_of(solid.vertex_box()) + 0x1p-1070) {
    const Vec3 middle = frame.local(middle_of(hull));
    const HullTopology topology = hull.topology();
    for (Index f = 0; f < topology.face_count(); ++f) {
      const Index first = topology.face_start[f], end = topology.face_start[f + 1];
      const auto corner = [&](Index h) { return frame.local(hull.vertex(topology.origin[h])); };
      if (end - first == 2) add({middle, corner(first), corner(first), corner(first + 1)}, HUGE_VAL);
      for (Index h = first + 2; h < end; ++h) add({middle, corner(first), corner(h - 1), corner(h)}, HUGE_VAL);
    }
  }

  Concavity narrowed(double resolution, std::optional<double> limit) {
    while (!regions_.empty() && questions_ < most_questions) {
      const double upper = regions_.top().upper;
      if (upper - lower_ <= std::max(resolution, fraction * lower_)) break;
      if (limit && (upper <= *limit || lower_ > *limit)) break;
      const Region widest = regions_.top();
      regions_.pop();
      halve(widest);
    }
    return {lower_, regions_.empty() ? 0 : std::max(lower_, regions_.top().upper)};
  }

 private:
  /// The slack is for what rounding leaves between two halves, and between a point and its place in the frame.
  void add(const Tetrahedron& t, double most) {
    const Vec3 at = 0.25 * ((t[0] + t[1]) + (t[2] + t[3]));
    const SignedDistance distance = signed_distance(frame_.world(at), solid_, {}, SignBy::automatic, workspace_);
    ++questions_;
    double square = 0;
    for (const Vec3& corner : t) square = std::max(square, square_of(corner - at));
    const double radius = frame_.length(std::sqrt(square));
    lower_ = std::max(lower_, distance.lower);
    const double upper = (distance.upper + radius) + (slack_ + 0x1p-48 * radius);
    regions_.push({t, std::min(most, upper)});
  }

  void halve(const Region& region) {
    std::size_t from = 0, to = 1;
    double longest = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (const double square = square_of(region.corners[j] - region.corners[i]); square > longest) {
          longest = square;
          from = i;
          to = j;
        }
    const Vec3 middle = 0.5 * (region.corners[from] + region.corners[to]);
    for (const std::size_t replaced : {from, to}) {
      Tetrahedron half = region.corners;
      half[replaced] = middle;
      add(half, region.upper);
    }
  }

  const Model& solid_;
  const SolidFrame& frame_;
  Workspace workspace_;
  std::priority_queue<Region> regions_;
  double slack_;
  double lower_ = 0;
  int questions_ = 0;
};

/// No surface within it, and a point of it inside.
bool lies_within(const ConvexHull& hull, const Model& solid) {
  if (hull.dimension() < 3) return false;
  if (locate(middle_of(hull), solid).side != Side::inside) return false;
  PairQuery query;
  query.solid_b = Solid::none;
  return relation(Model(hull), solid, query).kind != RelationKind::crossing;
}

}  // namespace

Concavity concavity_of(const ConvexHull& hull, const Model& solid, const SolidFrame& frame, double resolution,
                       std::optional<double> limit) {
  if (lies_within(hull, solid)) return {};
  return ConcavitySearch(hull, solid, frame).narrowed(resolution, limit);
}

}  // namespace toccata
