#pragma once

#include <span>

#include "math/world_vertex.hpp"
#include "narrow/convex/gjk_simplex.hpp"
#include "narrow/convex/support_scan.hpp"
#include "toccata/narrow/convex_convex.hpp"

// The search in doubles. What it finds is a guess; nearest_certificate.hpp proves it, or exact arithmetic takes over.
namespace toccata {

/// Vertices of one shape by direction. Large hulls are searched by walking along edges, which changes no answer; where
/// the walk begins is remembered, so that one thread may use it at a time.
class SupportSearch {
 public:
  SupportSearch(const PosedPolytope& shape, const SupportKernels& kernels, GjkSupport support = GjkSupport::automatic);

  [[nodiscard]] const PosedPolytope& shape() const { return *shape_; }

  /// In the world.
  [[nodiscard]] Vec3 vertex(Index i) const {
    const Vec3 stored{plain_.x[i], plain_.y[i], plain_.z[i]};
    return shape_->in_world() ? stored : world_vertex(shape_->pose(), stored);
  }

  /// The vertex of least height along a world direction, but for rounding.
  [[nodiscard]] Index least(const Vec3& direction) const;

  /// Heights along a direction of which every coordinate is known to within `slack`. Both include what rounding of
  /// world vertices and of heights adds, if the direction's greatest coordinate lies within the certain range.

  /// All vertices but `own` that may be as low as the given one is; ascending. As many as fit are written; returns how
  /// many there are.
  [[nodiscard]] Index close(const Vec3& direction, double slack, const Vec3& vertex, std::span<const Index> own,
                            std::span<Index> found) const;

  /// No world vertex is lower; NaN where nothing is certain.
  [[nodiscard]] double lower_bound(const Vec3& direction) const;

  /// Where the next walk along edges is to begin, if there is such a vertex.
  void begin_at(Index vertex) const { trail_.last = vertex < plain_.count ? vertex : 0; }

  /// How many heights of vertices `least` has computed.
  [[nodiscard]] std::uint64_t heights() const { return trail_.heights; }

 private:
  /// What is left by one search for the next.
  struct Trail {
    bool walks = false;
    Index last = 0;
    std::uint64_t heights = 0;
  };

  /// `spread` is what each coordinate of a world vertex lets its height be off by.
  [[nodiscard]] SupportScan scan(const Vec3& direction, double spread) const;
  /// The depth that is close to a vertex along a direction.
  [[nodiscard]] double close_depth(const Vec3& direction, double spread, const Vec3& vertex) const;
  [[nodiscard]] double least_depth(const SupportScan& scan) const;
  template <class Question>
  auto walked(const SupportScan& scan, Question question) const;
  [[nodiscard]] Index walked_least(const SupportScan& scan) const;
  [[nodiscard]] double walked_least_depth(const SupportScan& scan) const;
  [[nodiscard]] Index walked_close(const SupportScan& scan, double bound, std::span<const Index> own,
                                   std::span<Index> found) const;

  const PosedPolytope* shape_;
  const SupportKernels* kernels_;
  SupportScan plain_;    // without direction
  Mat3 world_in_local_;  // the transpose of the pose's R; of world coordinates the identity
  Vec3 stretch_;         // the sums of magnitudes of its rows
  Vec3 offset_;          // of the pose; of world coordinates 0
  double offset_magnitude_;
  mutable Trail trail_;
};

/// Directions for which the bounds of SupportSearch hold.
[[nodiscard]] bool in_certain_range(const Vec3& direction);

/// Where the search ended.
struct GjkEnd {
  GjkSimplex simplex;
  Vec3 nearest;         ///< the point of the simplex that is nearest to the origin
  bool inside = false;  ///< the origin seems to be in the simplex of four pairs
  Vec3 separating;      ///< the direction that reached the goal; else zero
  std::uint64_t steps = 0;
  std::uint64_t support_points = 0;  ///< searched for
  double size = 0;                   ///< the largest coordinate of a difference that was seen
};

/// When a search may end before it has the nearest points, and how it goes there.
struct GjkGoal {
  /// The shapes seem to be farther apart than this along the direction of the search; NaN: search to the end.
  double gap;
  GjkAcceleration acceleration = GjkAcceleration::none;
};

/// Starts with a simplex, or with the vertices along the way between the shapes' frames where it is empty.
///
/// Takes at most 69 steps, whatever the numbers are: no loop but over vertices and over steps.
[[nodiscard]] GjkEnd search_nearest(const SupportSearch& a, const SupportSearch& b, const VertexPairs& start,
                                    const GjkGoal& goal);

}  // namespace toccata
