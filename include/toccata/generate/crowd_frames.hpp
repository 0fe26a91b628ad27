#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "toccata/core/index_pair.hpp"

namespace toccata {

/// Pairs in one number, whatever their order: other pairs have another one, but for one chance in 2^64.
struct PairDigest {
  std::size_t count = 0;
  std::uint64_t sum = 0;
  friend bool operator==(const PairDigest&, const PairDigest&) = default;
};

[[nodiscard]] PairDigest digest_of(std::span<const IndexPair> pairs);

/// What each frame of a crowd took, and its pairs.
struct CrowdFrames {
  std::vector<double> milliseconds;
  std::vector<PairDigest> pairs;

  [[nodiscard]] double median_ms() const;
  [[nodiscard]] double worst_ms() const { return *std::max_element(milliseconds.begin(), milliseconds.end()); }
};

/// Moves a crowd (`Crowd`, or what has its `step` and `boxes`) through its frames, at least one. `find` is given the
/// numbers of the boxes that moved, finds all pairs of the crowd's boxes and returns the milliseconds that it took;
/// `pairs` returns the digest of what it found.
template <class AnyCrowd, class Find, class Pairs>
CrowdFrames run_frames(AnyCrowd& crowd, std::size_t frames, const Find& find, const Pairs& pairs) {
  CrowdFrames run;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const std::span<const Index> moved = crowd.step();
    run.milliseconds.push_back(find(moved));
    run.pairs.push_back(pairs());
  }
  return run;
}

}  // namespace toccata
