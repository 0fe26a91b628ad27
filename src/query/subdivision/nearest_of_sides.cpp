#include <array>
#include <utility>

#include "bounds/box_bounds.hpp"
#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "query/subdivision/limit_search.hpp"
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
  FacePairs(const CageSide& first, const CageSide& second, const LimitDistance& best)
      : sides_{&first, &second}, trees_{FaceTree(first), FaceTree(second)} {
    found_.best = best;
    for (std::size_t i = 0; i < 2; ++i) found_.lowers[i].assign(sides_[i]->mesh.face_count(), infinity);
  }

  [[nodiscard]] double bound(const Aabb& a, const Aabb& b) const { return box_gap(a, b); }
  [[nodiscard]] double limit() const { return found_.best.upper; }
  void visit(std::span<const ItemPair> pairs) {
    for (const ItemPair& pair : pairs) {
      const bool is_near = bound(trees_[0].boxes[pair.first], trees_[1].boxes[pair.second]) <= limit();
      const Index a = trees_[0].faces[pair.first], b = trees_[1].faces[pair.second];
      if (is_near && ends_[1][b] - ends_[0][a] <= limit()) look_at(a, b);
    }
  }

  PairOfSides found() && {
    look_at_some();
    measure_along(found_.best.on_model - found_.best.on_mesh);
    walk_pair(trees_[0].tree, trees_[1].tree, *this);
    return std::move(found_);
  }

 private:
  void look_at(Index a, Index b);
  void look_at_some();
  void measure_along(const Vec3& way);

  std::array<const CageSide*, 2> sides_;
  std::array<FaceTree, 2> trees_;
  /// Of each face how far it and its limit reach along a direction, of the first side towards the second, and of the
  /// second back: two are no nearer than what is between. Where they are nearest, faces are nearly parallel and boxes
  /// tell little.
  std::array<std::vector<double>, 2> ends_;
  PairOfSides found_;
  Workspace workspace_;
};

void FacePairs::look_at(Index a, Index b) {
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

void FacePairs::measure_along(const Vec3& way) {
  const Vec3 unit = unit_or_zero(way) * (1 - 0x1p-50);
  for (std::size_t i = 0; i < 2; ++i) {
    const LevelMesh& mesh = sides_[i]->mesh;
    const double sign = i == 0 ? 1 : -1;
    ends_[i].assign(mesh.face_count(), 0);
    for (const Index f : trees_[i].faces) {
      double most = -infinity;
      for (const Index corner : mesh.face(f)) most = std::max(most, sign * dot(mesh.points[corner], unit));
      // With room for the rounding of the sums.
      ends_[i][f] = sign * (most + up_by_sum * sides_[i]->within[f] + 16 * unit_roundoff * mesh.largest_coordinate);
    }
  }
}

}  // namespace

PairOfSides nearest_of_sides(const CageSide& first, const CageSide& second, const LimitDistance& best) {
  return FacePairs(first, second, best).found();
}

}  // namespace toccata
