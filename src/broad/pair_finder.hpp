#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "toccata/broad/broad_phase.hpp"

namespace toccata {

using PairList = std::vector<IndexPair>;

/// What a method is shown in an update.
struct BoxesNow {
  std::span<const Aabb> boxes;  ///< empty where a number is not in use
  std::span<const Index>
      changed;  ///< the numbers whose boxes are not those of the last update, in any order, each once
  std::span<const IndexPair> before;  ///< the pairs of the last update
  int threads = own_thread;
  /// What is not wanted may be left out of the pairs. Only of those that are shown one set of boxes.
  const PairFilter* wanted = nullptr;
  bool is_only = false;  ///< no other update will follow
};

/// One way to find all pairs of boxes that overlap. It is shown every update of one set of boxes, in order, from the
/// first or a later one: then it makes what it keeps from all boxes.
class PairFinder {
 public:
  PairFinder() = default;
  PairFinder(const PairFinder&) = delete;
  PairFinder& operator=(const PairFinder&) = delete;
  virtual ~PairFinder() = default;

  /// All pairs, ascending, each once, in a list whose memory is that of `storage`, whatever it holds.
  [[nodiscard]] virtual PairList find(const BoxesNow& now, PairList storage) = 0;
  /// Memory kept between updates.
  [[nodiscard]] virtual std::size_t bytes() const = 0;

  /// Into what space was divided by the last `find`, of these boxes.
  [[nodiscard]] virtual BroadPhaseCells cells(std::span<const Aabb> /*boxes*/) const { return {}; }

  /// What `automatic` tells of its choice; the other methods are what they are.
  [[nodiscard]] virtual BroadPhaseMethod chosen() const { return BroadPhaseMethod::automatic; }
  [[nodiscard]] virtual std::string reason() const { return {}; }
};

[[nodiscard]] std::unique_ptr<PairFinder> make_pair_finder(const BroadPhaseOptions& options);

}  // namespace toccata
