#include "robots/obstacle_tree.hpp"

#include <cmath>

#include "math/floats.hpp"
#include "math/vec3_measures.hpp"
#include "trees/wide_probe.hpp"

namespace toccata {
namespace {

// Floats are used for numbers up to this size; beyond, an axis is left out.
constexpr double most_of_floats = 1e30;

/// Makes the regions of turned boxes in a tree's frame, as query/meshes/wide_cull.hpp does of meshes: but here the tree
/// is in the world, and directions are about 1 long, so that little is left to be made.
class ProbeMaking {
 public:
  ProbeMaking(const WideBvh& tree, const TurnedBox& box, double distance)
      : centre_(box.centre - tree.origin),
        farther_(distance + 2 * box.slack + 0x1p-50 * sum_of_magnitudes(box.centre)),
        units_(1 / tree.unit) {
    for (int i = 0; i < 3; ++i) {
      SlantedForm form;
      form.own[static_cast<std::size_t>(i)] = form.size[static_cast<std::size_t>(i)] = 1;
      const double half = (std::fabs(box.edges[0][i]) + std::fabs(box.edges[1][i])) + std::fabs(box.edges[2][i]);
      add(form, 1, centre_[i], half);
    }
    for (const Vec3& axis : box.axes) {
      const double size = sum_of_magnitudes(axis);
      if (!(size < 4)) continue;
      double half = 0;
      for (const Vec3& edge : box.edges) half += std::fabs(dot(edge, axis));
      add(SlantedForm(as_floats(axis)), size, dot(centre_, axis), half);
    }
  }

  [[nodiscard]] const WideProbe& probe() const { return probe_; }

 private:
  /// `size` is what the direction's numbers add up to. 2⁻²⁰ of all numbers is more than floats and dot products are
  /// rounded by: coordinates within the tree are at most 2.
  void add(const SlantedForm& form, double size, double middle, double half) {
    const double at = units_ * middle, reach = units_ * (half + farther_ * size);
    if (!(std::fabs(at) < most_of_floats && reach < most_of_floats)) return;
    const double pad = 0x1p-20 * ((2 * size + std::fabs(at)) + reach) + 1e-30;
    probe_.axes[probe_.count++] = {form, static_cast<float>(at), static_cast<float>(reach + pad)};
  }

  Vec3 centre_;
  double farther_;
  double units_;
  WideProbe probe_;
};

}  // namespace

ObstacleTree::ObstacleTree(std::span<const Aabb> boxes) {
  std::vector<Aabb> finite;
  for (Index i = 0; i < boxes.size(); ++i) {
    if (is_empty(boxes[i])) continue;
    const bool is_finite_box = is_finite(boxes[i].lower) && is_finite(boxes[i].upper);
    (is_finite_box ? in_tree_ : outside_).push_back(i);
    if (is_finite_box) finite.push_back(boxes[i]);
  }
  tree_ = build_wide_bvh(finite);
}

void ObstacleTree::visit_near(const TurnedBox& box, double distance, FunctionRef<bool(Index)> see) const {
  for (const Index number : outside_)
    if (!see(number)) return;
  // Where numbers are too large for axes, none is there, and all are seen.
  if (tree_.blocks.empty()) return;
  const WideProbe probe = std::isfinite(box.slack) ? ProbeMaking(tree_, box, distance).probe() : WideProbe{};
  walk_probe(tree_, probe, [&](Index item) { return see(in_tree_[item]); });
}

}  // namespace toccata
