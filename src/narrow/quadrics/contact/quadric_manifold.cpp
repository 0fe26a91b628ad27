#include "toccata/narrow/quadrics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/vec3_measures.hpp"
#include "narrow/convex/canonical_order.hpp"
#include "narrow/convex/contact_choices.hpp"
#include "narrow/quadrics/contact/patch_overlap.hpp"
#include "narrow/quadrics/contact/quadric_separation.hpp"
#include "narrow/quadrics/distance/fast_pair.hpp"
#include "narrow/quadrics/quadric_order.hpp"

// Both shapes have a patch along the normal: a face, a line or a point. What the patches have in common, seen along it,
// is the region of contact, and up to four points of its boundary stand for it.
namespace toccata {
namespace {

/// Points are as deep as each other within this, in a pair of size 1, and within this part of the depth.
constexpr double same_depth = 0x1p-40;
constexpr double same_part_of_depth = 0x1p-20;

/// Another point has to be so much better than one that was seen before, and to add so much to what the others span.
constexpr double better = 1 + 0x1p-30;
constexpr double least_share = 0x1p-20;

using CommonPoints = std::pmr::vector<CommonPoint>;

double squared_length(const Vec3& v) { return v.x * v.x + v.y * v.y; }
double twice_area(const Vec3& u, const Vec3& v) { return u.x * v.y - u.y * v.x; }

double squared_span(const CommonPoints& points, const Vec3& from) {
  double span = 0;
  for (const CommonPoint& p : points) span = std::fmax(span, squared_length(p.at - from));
  return span;
}

double greatest_depth(const CommonPoints& points) {
  double depth = -HUGE_VAL;
  for (const CommonPoint& p : points) depth = std::fmax(depth, p.depth);
  return depth;
}

Vec3 mean_of(const CommonPoints& points) {
  Vec3 sum;
  for (const CommonPoint& p : points) sum = sum + p.at;
  return (1.0 / static_cast<double>(points.size())) * sum;
}

/// Of those as deep as any the first that is farthest from the middle.
std::size_t deepest_of(const CommonPoints& points) {
  const double depth = greatest_depth(points);
  const double enough = depth - std::fmax(same_depth, same_part_of_depth * std::fabs(depth));
  const Vec3 middle = mean_of(points);
  std::size_t best = points.size();
  double farthest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double squared = squared_length(points[i].at - middle);
    if (points[i].depth < enough || (best < points.size() && squared <= better * farthest)) continue;
    best = i;
    farthest = squared;
  }
  return best;
}

/// Takes the deepest point, the farthest from it, the farthest from the line through these, and the one that adds the
/// most to the triangle of these.
class FourPoints {
 public:
  explicit FourPoints(CommonPoints& points) : points_(points) {}

  std::pmr::vector<CommonPoint> taken() {
    CommonPoints four(points_.get_allocator());
    std::swap(points_.front(), points_[deepest_of(points_)]);
    const Vec3 first = points_.front().at;
    const double span = squared_span(points_, first);
    four.push_back(points_.front());
    const auto add = [&](const auto& measure, double least) {
      const CommonPoint* best = nullptr;
      double greatest = least;
      for (const CommonPoint& p : points_)
        if (const double here = measure(p.at); here > (best == nullptr ? greatest : better * greatest)) {
          best = &p;
          greatest = here;
        }
      if (best != nullptr) four.push_back(*best);
      return best != nullptr;
    };
    if (!add([&](const Vec3& p) { return squared_length(p - first); }, least_share * least_share)) return four;
    const Vec3 way = four[1].at - first;
    if (!add([&](const Vec3& p) { return std::fabs(twice_area(way, p - first)); }, least_share * span)) return four;
    add([&](const Vec3& p) { return area_added(four, p); }, least_share * span);
    return four;
  }

 private:
  /// By a point to a triangle, twice: over the side that it sees best.
  static double area_added(const CommonPoints& triangle, const Vec3& p) {
    const Vec3 &a = triangle[0].at, &b = triangle[1].at, &c = triangle[2].at;
    const double turn = twice_area(b - a, c - a) > 0 ? -1 : 1;
    return std::max(
        {turn * twice_area(b - a, p - a), turn * twice_area(c - b, p - b), turn * twice_area(a - c, p - c)});
  }

  CommonPoints& points_;
};

/// The points of a contact in its frame, of two patches. Along the normal the shapes are as deep as `separation` tells.
CommonPoints chosen_points(const ContactPatch& a, const ContactPatch& b, double depth,
                           std::pmr::memory_resource& memory) {
  CommonPoints points = common_points(a, b, memory);
  for (CommonPoint& p : points) p.depth = std::fmin(p.depth, depth);
  if (!points.empty()) {
    const double gap = gap_of_resting * std::sqrt(squared_span(points, points[deepest_of(points)].at));
    std::erase_if(points, [=](const CommonPoint& p) { return !(p.depth >= -gap); });
  }
  // Where they would touch last: all there is of a single point, and it may lie amid a contact.
  if (!(greatest_depth(points) >= depth - std::fmax(same_depth, same_part_of_depth * depth)))
    points.insert(points.begin(), {{0, 0, 0}, depth, a.whole, b.whole});
  return FourPoints(points).taken();
}

/// A contact in the pair's frame, and what its points are made to in the world.
struct PairContact {
  const PairFrame& frame;
  ContactFrame at;
  double depth;

  [[nodiscard]] Manifold told(const CommonPoints& points) const {
    Manifold result;
    result.normal = at.z;
    for (const CommonPoint& p : points)
      result.points[static_cast<std::size_t>(result.count++)] = {frame.back(at.back(p.at)), p.depth / frame.factor,
                                                                 p.on_a, p.on_b};
    return result;
  }
};

ContactPatch patch_of_second(const PosedQuadric&, const QuadricBody& body, const PairContact& contact, const Vec3&,
                             std::pmr::memory_resource& memory) {
  return patch_of(body, contact.at, -1, memory);
}

ContactPatch patch_of_second(const PosedPolytope& shape, const QuadricBody&, const PairContact& contact,
                             const Vec3& touching, std::pmr::memory_resource& memory) {
  const PairFrame& frame = contact.frame;
  const PosedPolytope scaled = shape.scaled(std::ilogb(frame.factor));
  return patch_of(scaled, frame.factor * frame.origin, contact.at, -1, touching, memory);
}

/// Most of what is apart: it needs no contact, and the longer way may leave it undecided.
template <class B>
bool is_apart_fast(const PosedQuadric& a, const B& b, const PairFrame& frame) {
  return is_fast(a, b, frame) && FastPair(a, b, frame).is_apart();
}

template <class B>
Manifold manifold_of(const PosedQuadric& a, const B& b) {
  const PairFrame frame = pair_frame(a, b);
  if (is_apart_fast(a, b, frame)) return {};
  const QuadricBody body_a(a, frame), body_b(b, frame);
  const QuadricNearest met = nearest_of(a, body_a, b, body_b, QuadricQuestion::meeting);
  if (met.contact == QuadricContact::apart) return {};
  std::array<std::byte, 8192> buffer;
  std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
  const QuadricSeparation separation = separation_of(body_a, body_b, met);
  const PairContact contact{
      frame, {separation.on_a + 0.5 * (separation.on_b - separation.on_a), separation.normal}, separation.depth};
  const ContactPatch patch_a = patch_of(body_a, contact.at, 1, memory);
  const ContactPatch patch_b = patch_of_second(b, body_b, contact, separation.on_b, memory);
  return contact.told(chosen_points(patch_a, patch_b, contact.depth, memory));
}

Manifold manifold_over(const PosedQuadric& a, const PosedHalfSpace& b) {
  const QuadricContact how = quadric_contact(a, b);
  if (how == QuadricContact::apart) return {};
  const PairFrame frame = pair_frame(a, a);
  const QuadricBody body(a, frame);
  const Vec3 normal = -unit_or_zero(b.normal);
  const double depth = how == QuadricContact::contact ? frame.factor * penetration(a, b).upper : 0;
  const PairContact contact{frame, {body.support(normal).point - 0.5 * depth * normal, normal}, depth};
  std::array<std::byte, 8192> buffer;
  std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
  ContactPatch plane(memory);
  plane.kind = ContactPatch::Kind::plane;
  plane.whole = {ConvexFeature::Kind::face, 0};
  plane.centre.z = -0.5 * depth;
  return contact.told(chosen_points(patch_of(body, contact.at, 1, memory), plane, depth, memory));
}

}  // namespace

Manifold manifold(const PosedQuadric& a, const PosedQuadric& b) {
  return comes_before(b, a) ? flipped(manifold_of(b, a)) : manifold_of(a, b);
}
Manifold manifold(const PosedQuadric& a, const PosedPolytope& b) { return manifold_of(a, b); }
Manifold manifold(const PosedPolytope& a, const PosedQuadric& b) { return flipped(manifold_of(b, a)); }
Manifold manifold(const PosedQuadric& a, const PosedHalfSpace& b) { return manifold_over(a, b); }
Manifold manifold(const PosedHalfSpace& a, const PosedQuadric& b) { return flipped(manifold_over(b, a)); }

}  // namespace toccata
