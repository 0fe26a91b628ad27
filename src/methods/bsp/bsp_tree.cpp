#include "toccata/methods/bsp_tree.hpp"

#include <algorithm>
#include <optional>

#include "methods/bsp/bsp_point.hpp"
#include "query/inside/inside_point.hpp"

namespace toccata {
namespace {

class PointSearch {
 public:
  PointSearch(const BspTree::Parts& parts, const Vec3& point) : parts_(parts), point_(point), walk_(parts, point) {}

  [[nodiscard]] BspLocation from_root() {
    const BspChild end = walk_.descend(0);
    if (is_leaf(end)) return located(winding_of_leaf(end));
    return in_planes(end);
  }

 private:
  /// A triangle on which the point lies has a fragment on which it lies, in the plane of a node or on one of its sides:
  /// so all cells are looked at that have the point on their border. If it is on none, all of them are of one kind.
  [[nodiscard]] BspLocation in_planes(BspChild first) {
    std::vector<BspChild> waiting{first};
    std::optional<Index> least;
    int winding = 0;
    while (!waiting.empty()) {
      const BspChild end = walk_.descend(waiting.back());
      waiting.pop_back();
      if (is_leaf(end)) {
        winding = winding_of_leaf(end);
        continue;
      }
      take_touched(end, least);
      const BspNode& node = parts_.nodes[static_cast<std::size_t>(end)];
      waiting.push_back(node.back());
      waiting.push_back(node.front());
    }
    if (!least) return located(winding);
    return {{Side::boundary, 0}, *least};
  }

  void take_touched(BspChild node, std::optional<Index>& least) const {
    for (const StoredFragment& fragment : parts_.fragments_of(node)) {
      if (least && *least <= fragment.triangle) continue;
      if (lies_on(ExactPoint(point_), parts_.planes.triangle(fragment.triangle))) least = fragment.triangle;
    }
  }

  [[nodiscard]] static BspLocation located(int winding) { return {located_by(winding), 0}; }

  const BspTree::Parts& parts_;
  Vec3 point_;
  BspPointWalk walk_;
};

}  // namespace

BspChild BspPointWalk::descend(BspChild at) const {
  while (!is_leaf(at)) {
    const BspNode& node = parts_.nodes[static_cast<std::size_t>(at)];
    const float height = node.floats.height(floats_);
    // Not so for NaN and infinities.
    if (std::fabs(height) > node.floats.bound) {
      at = node.child[height > 0];
      continue;
    }
    const Sign side = side_of(node.plane);
    if (side == Sign::zero) return at;
    at = node.child[side == Sign::positive];
  }
  return at;
}

Sign BspPointWalk::side_of(BspPlane plane) const {
  const RoundedBspPlane rounded = parts_.planes.rounded(plane);
  const double height = rounded.height(local_);
  if (height > rounded.bound) return Sign::positive;
  if (height < -rounded.bound) return Sign::negative;
  return parts_.planes.side(point_, plane);
}

FloatBspPlane as_floats(const RoundedBspPlane& plane) {
  const double largest = largest_magnitude(plane.normal);
  FloatBspPlane result;
  if (!(largest > 0) || !std::isfinite(largest)) return result;
  const int scale = -std::ilogb(largest);  // of the normal, to be about 1
  const Vec3 normal = near_unit(plane.normal);
  result.normal = as_floats(normal);
  result.offset = static_cast<float>(std::ldexp(plane.offset, scale));
  const double rounding = FloatBspPlane::share * sum_of_magnitudes(normal);
  result.bound = up_to_float((std::ldexp(plane.bound, scale) + rounding) + FloatBspPlane::least);
  return result;
}

BspTree::Parts::Parts(const Model& solid) : model(solid), frame(model.bounds()), planes(model.mesh(), frame) {}

BspTree::BspTree(const Model& solid, const BspOptions& options) {
  require_possible(options);
  require_solid_for_bsp(solid);
  auto parts = std::make_shared<Parts>(solid);
  build_bsp(*parts, options, [](const CutBspCell&, const BspFragments&, const BspChoice&) {});
  parts_ = std::move(parts);
}

BspLocation BspTree::locate(const Vec3& point) const {
  require_finite_point(point);
  if (!parts_->frame.contains(point)) return {};
  return PointSearch(*parts_, point).from_root();
}

const BspStatistics& BspTree::statistics() const { return parts_->statistics; }

std::vector<BspFragment> BspTree::back_to_front(const Vec3& eye) const {
  require_finite_point(eye);
  const Parts& parts = *parts_;
  std::vector<BspFragment> order;
  order.reserve(parts.statistics.fragments);
  struct Step {
    BspChild node = 0;
    bool fragments = false;
  };
  std::vector<Step> waiting{{0, false}};
  while (!waiting.empty()) {
    const Step step = waiting.back();
    waiting.pop_back();
    if (is_leaf(step.node)) continue;
    const BspNode& node = parts.nodes[static_cast<std::size_t>(step.node)];
    if (!step.fragments) {
      // Fragments that are seen edge-on hide nothing, whichever side is near.
      const bool front_is_near = parts.planes.side(eye, node.plane) != Sign::negative;
      waiting.push_back({front_is_near ? node.front() : node.back(), false});
      waiting.push_back({step.node, true});
      waiting.push_back({front_is_near ? node.back() : node.front(), false});
      continue;
    }
    for (const StoredFragment& fragment : parts.fragments_of(step.node)) {
      const Index end = (&fragment + 1)->first_corner;
      order.push_back(
          {fragment.triangle, std::span(parts.corners).subspan(fragment.first_corner, end - fragment.first_corner)});
    }
  }
  return order;
}

}  // namespace toccata
