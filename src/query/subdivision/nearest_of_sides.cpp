#include <array>
#include <utility>

#include "bounds/box_bounds.hpp"
#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "query/subdivision/limit_search.hpp"
#include "query/subdivision/refinement_rules.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/trees/builders.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {
namespace {

/// A tree over the faces of a side, in boxes that hold their limits.
struct FaceTree {
  explicit FaceTree(const CageSide& side) {
    for (Index f = 0; f < side.mesh.face_count(); ++f) {
      if (!side.mesh.whole[f]) continue;
      Aabb box;
      for (const Index corner : side.mesh.face(f)) box = merge(box, side.mesh.points[corner]);
      // With room for the rounding of the differences.
      const double grown = up_by_sum * side.within[f] + 4 * unit_roundoff * side.mesh.largest_coordinate;
      box = {box.lower - Vec3{grown, grown, grown}, box.upper + Vec3{grown, grown, grown}};
      faces.push_back(f);
      boxes.push_back(box);
    }
    tree = build_bvh(boxes, {.leaf_size = 1});
  }

  std::vector<Index> faces;
  std::vector<Aabb> boxes;
  Bvh<Aabb> tree;
};

/// The nearest pairs of faces, as a question that a walk asks (trees/walk.hpp).
class FacePairs {
 public:
  FacePairs(const CageSide& first, const CageSide& second, const LimitDistance& best, FaceComparisons& comparisons)
      : sides_{&first, &second}, trees_{FaceTree(first), FaceTree(second)}, comparisons_(comparisons) {
    found_.best = best;
    for (std::size_t i = 0; i < 2; ++i) found_.lowers[i].assign(sides_[i]->mesh.face_count(), infinity);
  }

  [[nodiscard]] double bound(const Aabb& a, const Aabb& b) const { return box_gap(a, b); }
  [[nodiscard]] double limit() const { return comparisons_.are_spent() ? -1 : found_.best.upper; }
  void visit(std::span<const ItemPair> pairs) {
    for (const ItemPair& pair : pairs) {
      const bool is_near = bound(trees_[0].boxes[pair.first], trees_[1].boxes[pair.second]) <= limit();
      const Index a = trees_[0].faces[pair.first], b = trees_[1].faces[pair.second];
      if (is_near && gap_between(a, b) <= limit()) look_at(a, b);
    }
  }

  PairOfSides found() && {
    look_at_some();
    walk_pair(trees_[0].tree, trees_[1].tree, *this);
    return std::move(found_);
  }

 private:
  void look_at(Index a, Index b);
  void look_at_some();
  [[nodiscard]] double gap_between(Index a, Index b) const;

  std::array<const CageSide*, 2> sides_;
  std::array<FaceTree, 2> trees_;
  PairOfSides found_;
  FaceComparisons& comparisons_;
  Workspace workspace_;
};

void FacePairs::look_at(Index a, Index b) {
  comparisons_.count();
  const CageSide &first = *sides_[0], &second = *sides_[1];
  const double both = sum_up(first.within[a], second.within[b]);
  double lower = infinity;
  for (const Triangle& of_a : first.triangles_of(a))
    for (const Triangle& of_b : second.triangles_of(b)) {
      const std::optional<Distance> found =
          distance_within(of_a, of_b, sum_up(found_.best.upper, both), {}, workspace_);
      if (!found) continue;
      lower = std::min(lower, difference_down(found->lower, both));
      const double upper = sum_up(found->upper, both);
      if (upper < found_.best.upper)
        found_.best = {.upper = upper,
                       .on_mesh = found->on_a,
                       .on_model = found->on_b,
                       .distance_to_limit = first.within[a],
                       .cage_face = first.mesh.cage_face[a],
                       .element = second.mesh.cage_face[b],
                       .level = first.mesh.level};
    }
  found_.lowers[0][a] = std::min(found_.lowers[0][a], lower);
  found_.lowers[1][b] = std::min(found_.lowers[1][b], lower);
}

/// From one face to that of the nearest corner and back, so that the walk begins with some distance, and a good one.
void FacePairs::look_at_some() {
  const auto nearest = [](const CageSide& side, const FaceTree& tree, const Vec3& p) {
    std::pair<double, Index> least{infinity, tree.faces.front()};
    for (const Index f : tree.faces)
      for (const Index corner : side.mesh.face(f)) least = std::min(least, {length(side.mesh.points[corner] - p), f});
    return least.second;
  };
  const auto place = [](const CageSide& side, Index face) { return side.mesh.points[side.mesh.face(face)[0]]; };
  Index a = trees_[0].faces.front(), b = 0;
  for (int round = 0; round < 2; ++round) {
    b = nearest(*sides_[1], trees_[1], place(*sides_[0], a));
    a = nearest(*sides_[0], trees_[0], place(*sides_[1], b));
  }
  look_at(a, b);
}

/// What is between their limits along the way from the middle of the one to that of the other, at least. Where faces
/// are small and far apart, boxes tell much less.
double FacePairs::gap_between(Index a, Index b) const {
  const CageSide &first = *sides_[0], &second = *sides_[1];
  const Vec3 way = point_for_face(second.mesh, b) - point_for_face(first.mesh, a);
  const Vec3 unit = unit_or_zero(way) * (1 - 0x1p-50);
  double end = -infinity, begin = infinity;
  for (const Index corner : first.mesh.face(a)) end = std::max(end, dot(first.mesh.points[corner], unit));
  for (const Index corner : second.mesh.face(b)) begin = std::min(begin, dot(second.mesh.points[corner], unit));
  // With room for the rounding of the sums.
  const double largest = std::max(first.mesh.largest_coordinate, second.mesh.largest_coordinate);
  return begin - end - up_by_sum * (first.within[a] + second.within[b]) - 32 * unit_roundoff * largest;
}

}  // namespace

PairOfSides nearest_of_sides(const CageSide& first, const CageSide& second, const LimitDistance& best,
                             FaceComparisons& comparisons) {
  return FacePairs(first, second, best, comparisons).found();
}

}  // namespace toccata
