#pragma once

#include <span>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "broad.hpp"
#include "broad_truth.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata::bench {

/// The crowd with coordinates that are sums of few bits, so that a centre and a size tell them exactly too.
class PlainCrowd {
 public:
  explicit PlainCrowd(const BroadArguments& arguments);
  std::span<const Index> step();
  [[nodiscard]] const std::vector<Aabb>& boxes() const { return boxes_; }

 private:
  Crowd crowd_;
  std::vector<Aabb> boxes_;
};

struct BroadRow {
  Description who{};
  int threads = 1;
  std::size_t frames = 0;
  double median_ms = 0;
  double mean_ms = 0;  ///< what a frame costs in the long run: those that keep something pay now and then
  double worst_ms = 0;
  std::size_t pairs = 0;         ///< of the last frame
  double bytes_per_body = 0;     ///< at most in a frame
  std::size_t wrong_frames = 0;  ///< in which a pair is missing, or, of Toccata, one is too many
  std::string reason{};
};

/// All frames, or, but of two at least, those until `seconds` have passed.
BroadRow measured(BroadLibrary& library, const BroadArguments& arguments, const BroadTruth& truth, double seconds);

/// A peer in a process of its own, which is ended after eight times as long, with what it needs to add the boxes.
/// Without frames where that happened.
BroadRow measured_apart(BroadLibrary& library, const BroadArguments& arguments, const BroadTruth& truth,
                        double seconds);

BroadLibraries peers_asked(const BroadArguments& arguments);

/// Whether a method finds the pairs of so many boxes in a time that one would wait for.
bool is_sensible(BroadPhaseMethod method, std::size_t count);

/// What cells of the spatial hash cost, by their size; and each claim about the broad phase, with what was measured.
int run_broad_cell_size(const BroadArguments& arguments);
int run_broad_swaps(const BroadArguments& arguments);
int run_broad_table(const BroadArguments& arguments);

}  // namespace toccata::bench
