#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "narrow/convex/support_scan.hpp"

namespace toccata {

/// Supports of a hull by walking along its edges: the same answers as those of the kernels that scan all vertices.
///
/// The vertices of a convex polytope that are no higher than some level along a direction hang together by edges, and a
/// hull is convex exactly, in its own frame. So a walk downhill from anywhere gets near the lowest vertices, and one
/// outwards from there, over vertices that rounding does not exclude, meets every vertex that may be as low. Among
/// these few the answer is chosen just as a scan would. Where they are many, as on a face of many vertices that lies
/// across the direction, or the way is long, there is no answer, and the vertices are to be scanned.
///
/// It ends: every step downhill is to a strictly lower rounded height, every step outwards to a vertex not met before,
/// and all ends when some `count / 8` heights have been computed.
class EdgeWalk {
 public:
  /// Along the direction of the scan, whose spread is used by `least_depth` and `close` only. The vertices of the scan
  /// are those of the hull, in its own frame.
  EdgeWalk(const PosedPolytope& hull, const SupportScan& scan);

  /// As in SupportKernels. The walk begins at `start` or where the hull's guide says, whichever is lower.
  [[nodiscard]] std::optional<Index> least(Index start);
  [[nodiscard]] std::optional<double> least_depth(Index start);
  [[nodiscard]] std::optional<Index> close(double bound, std::span<const Index> own, std::span<Index> found,
                                           Index start);

  /// Where the way downhill ended.
  [[nodiscard]] Index lowest() const { return lowest_; }
  /// How many heights were computed.
  [[nodiscard]] std::uint64_t heights() const { return heights_; }

 private:
  static constexpr std::size_t most_low = 64;

  [[nodiscard]] double height(Index i) const;
  [[nodiscard]] double depth(Index i) const;
  [[nodiscard]] bool is_spent() const { return heights_ > budget_; }
  [[nodiscard]] bool is_low(Index i) const;
  /// Calls `visit` with each neighbour of a vertex and its height, while heights may be computed.
  template <class Visit>
  void visit_neighbours(Index vertex, Visit visit);
  [[nodiscard]] Index lower_start(Index start);
  [[nodiscard]] bool descend(Index start);
  /// Finds all vertices whose exact height may be no more than `level`, and those on the way to them; after `descend`.
  [[nodiscard]] bool find_low(double level);
  [[nodiscard]] bool find_as_deep(double bound);

  const SupportScan& scan_;
  HullTopology topology_;
  double extent_;  // at least the magnitude of any coordinate
  double reach_;   // and of any height
  double error_;   // at least what any rounded height is off by
  std::uint64_t budget_;
  std::uint64_t heights_ = 0;
  Index lowest_ = 0;
  double lowest_height_ = 0;
  double rim_ = 0;  // the least height of its neighbours
  std::array<Index, most_low> low_;
  std::size_t low_count_ = 0;
};

}  // namespace toccata
