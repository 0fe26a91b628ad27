#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "core/prefetch.hpp"
#include "math/constants.hpp"
#include "math/world_vertex.hpp"
#include "narrow/near.hpp"
#include "narrow/triangles/triangle_gaps.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "query/search_scratch.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "trees/near_front.hpp"
#include "trees/near_walk.hpp"

// Which triangles of two posed meshes are nearest, or near enough (docs/methods/mesh-distance.md).
namespace toccata {

/// No walk is given a lesser limit: it divides by it.
inline constexpr double least_limit = 1e-200;

/// World triangles for a loop over many.
class WorldTriangles {
 public:
  explicit WorldTriangles(const PosedMesh& mesh)
      : pose_(mesh.pose()), vertices_(mesh.model().mesh().vertices()), triangles_(mesh.model().mesh().triangles()) {
    numbers_.fill(std::numeric_limits<Index>::max());
  }

  [[nodiscard]] const Pose& pose() const { return pose_; }

  // Asks for the memory of a triangle: its corners' numbers, and when these have come, the corners.
  void prefetch_numbers(Index number) const { prefetch(triangles_[number]); }
  void prefetch_corners(Index number) const {
    for (const Index corner : triangles_[number]) prefetch(vertices_[corner]);
  }

  Triangle operator[](Index number) const {
    const auto& corner = triangles_[number];
    return {{world_vertex(pose_, vertices_[corner[0]]), world_vertex(pose_, vertices_[corner[1]]),
             world_vertex(pose_, vertices_[corner[2]])}};
  }

  /// The same for one that is likely to have been asked for lately; valid until the next one is.
  const Triangle& kept(Index number) {
    // Neighbours' numbers often differ by a power of two.
    const std::size_t place = (number * 0x9E3779B1U) >> (32 - log2_kept);
    if (numbers_[place] != number) {
      numbers_[place] = number;
      kept_[place] = (*this)[number];
    }
    return kept_[place];
  }

 private:
  static constexpr unsigned log2_kept = 6;
  static constexpr std::size_t kept_count = std::size_t{1} << log2_kept;

  Pose pose_;
  std::span<const Vec3> vertices_;
  std::span<const std::array<Index, 3>> triangles_;
  std::array<Index, kept_count> numbers_;
  std::array<Triangle, kept_count> kept_;
};

/// The distances of pairs of triangles of two posed meshes: what is said of a pair depends on its two alone.
class PairDistances {
 public:
  PairDistances(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch)
      : a_(a), b_(b), block_(scratch.main->blocks[0]) {}

  /// Calls `see(candidate)` for all of the pairs, in their order, until it returns false.
  template <class See>
  void bound(std::span<const ItemPair> pairs, const See& see) {
    for (const ItemPair& pair : pairs) prefetch_numbers(pair);
    for (const ItemPair& pair : first_of(pairs)) prefetch_corners(pair);
    while (!pairs.empty()) {
      const auto block = first_of(pairs);
      pairs = pairs.subspan(block.size());
      for (const ItemPair& pair : first_of(pairs)) prefetch_corners(pair);
      bound_block(block);
      for (std::size_t lane = 0; lane < block.size(); ++lane)
        if (!see(NearCandidate{gaps_.lower[lane], gaps_.upper[lane], block[lane], gaps_.points(lane)})) return;
    }
  }

  // Asks for the memory of two triangles before their turn comes: first for what tells their corners, then for these.
  void prefetch_numbers(const ItemPair& pair) const {
    a_.prefetch_numbers(pair.first);
    b_.prefetch_numbers(pair.second);
  }
  void prefetch_corners(const ItemPair& pair) const {
    a_.prefetch_corners(pair.first);
    b_.prefetch_corners(pair.second);
  }

  [[nodiscard]] Distance exact(const ItemPair& pair, SimplexCache* kept = nullptr) const;
  [[nodiscard]] bool meet(const ItemPair& pair) const { return overlap(a_[pair.first], b_[pair.second]); }

  /// A first try, which leaves infinity where more is needed, or all that is.
  enum class Effort { first, whole };

  /// The upper ends of the pairs' own intervals, of a block's worth at most. They do not meet.
  [[nodiscard]] TriangleGaps::Lanes uppers_of(std::span<const NearCandidate> candidates, Effort effort);

  /// How far apart the candidate is that was in that lane of the last block that was bounded.
  [[nodiscard]] FrontGap gap_in(std::size_t lane, const NearCandidate& candidate) const;

  /// Its exact distance is at most that.
  [[nodiscard]] bool is_within(const NearCandidate& candidate, double tolerance) const;

 private:
  static std::span<const ItemPair> first_of(std::span<const ItemPair> pairs) {
    return pairs.first(std::min(TrianglePairBlock::lanes, pairs.size()));
  }
  /// Ends of a pair's interval.
  struct Ends {
    double lower;
    double upper;
  };

  void put(std::size_t lane, const ItemPair& pair);
  void try_all_features(std::size_t count);
  [[nodiscard]] Ends precise_ends(const NearCandidate& candidate) const;
  void bound_block(std::span<const ItemPair> pairs);

  WorldTriangles a_;
  WorldTriangles b_;
  TrianglePairBlock& block_;
  TriangleGaps gaps_{};
  std::array<bool, TrianglePairBlock::lanes> swapped_{};  ///< the block's first triangle is of b
};

/// Keeps the pairs of triangles that may be the nearest; ends when two meet or are near enough. Pairs farther than
/// the search's limit are left out.
class NearestTriangles final : public NearQuestion, public FrontQuestion {
 public:
  NearestTriangles(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch, const WantedDistance& wanted = {})
      : pairs_(a, b, scratch), candidates_(scratch.candidates), wanted_(wanted), limit_(search_limit(wanted)) {
    candidates_.clear();
  }

  [[nodiscard]] double limit() const override { return limit_ < 0 ? -1 : std::max(limit_, least_limit); }
  void visit(std::span<const ItemPair> pairs) override {
    if (limit_ >= 0) pairs_.bound(pairs, [&](const NearCandidate& candidate) { return keep(candidate); });
  }

  void visit(std::span<const ItemPair> pairs, std::span<FrontGap> gaps) override {
    std::size_t seen = 0;
    pairs_.bound(pairs, [&](const NearCandidate& candidate) {
      if (candidate.lower > 0) gaps[seen] = pairs_.gap_in(seen % TrianglePairBlock::lanes, candidate);
      ++seen;
      return keep(candidate);
    });
  }

  [[nodiscard]] bool found_meeting() const { return limit_ < 0 && !near_enough_; }

  /// There is a pair within the limit, but for what intervals leave open.
  [[nodiscard]] bool found_any() const { return limit_ < 0 || !candidates_.empty(); }

  /// The distance of the nearest of all pairs that were seen and wanted; none of them meet, and there is one. Where two
  /// are near enough, it tells only this. What is kept of the nearest two saves time and changes nothing.
  [[nodiscard]] Distance nearest(SimplexCache* kept = nullptr);

  /// Whether one of the same pairs is at most that far apart.
  [[nodiscard]] bool any_within(double tolerance) const;

 private:
  /// The upper end of a pair's own interval, and the pair.
  struct Key {
    double upper = infinity;
    ItemPair pair{};
    bool operator<(const Key& other) const { return std::tie(upper, pair) < std::tie(other.upper, other.pair); }
  };

  bool keep(NearCandidate candidate);
  Key least();
  Key least_of(std::span<const NearCandidate> candidates, PairDistances::Effort effort,
               std::vector<NearCandidate>& untold);

  PairDistances pairs_;
  std::vector<NearCandidate>& candidates_;
  WantedDistance wanted_;
  double limit_;  ///< negative: nothing more is wanted
  std::optional<ItemPair> near_enough_;
};

}  // namespace toccata
