#pragma once

#include <cstdint>
#include <vector>

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/voronoi_regions.hpp"

namespace toccata {

/// How questions about a tracked pair were answered.
struct VoronoiCounts {
  std::uint64_t questions = 0;
  std::uint64_t kept = 0;      ///< of them: the features of the time before were still the nearest
  std::uint64_t walked = 0;    ///< others, or the first, were found by walking
  std::uint64_t searched = 0;  ///< rounding left a doubt, or the cores meet: by GJK
  std::uint64_t steps = 0;     ///< from region to region
  friend constexpr bool operator==(const VoronoiCounts&, const VoronoiCounts&) = default;
};

/// Two convex shapes that move, and what the caller keeps of them from one question to the next: the last nearest
/// features. Anything may be in it; it saves time and changes no answer. One thread may use it at a time.
struct TrackedPair {
  ConvexFeature on_a{};
  ConvexFeature on_b{};
  enum class State : std::uint8_t {
    unknown,  ///< never asked: the first walk begins at the vertices that face each other
    apart,    ///< at the last question
    meeting,  ///< at the last question the shapes met; the features are what is known
  } state = State::unknown;
  bool cores_meet = false;  ///< at the last question, the shapes without their radii
  SimplexCache workspace{};
  VoronoiCounts counts{};
};

/// Where a walk has ended.
enum class WalkEnd : std::uint8_t {
  nearest,     ///< no plane of either region is violated
  tie,         ///< one is, but beyond it nothing is nearer in doubles
  below,       ///< a feature has come to lie behind a face: the shapes seem to meet
  not_walked,  ///< the cores met at the last question, so that GJK was asked at once
};

/// A place on the way of a walk: a feature of each shape, and their nearest points, which lie inside both, as far as
/// doubles tell; in the world.
struct VoronoiVisit {
  ConvexFeature on_a;
  ConvexFeature on_b;
  Vec3 point_a;
  Vec3 point_b;
  double distance_squared = 0;  ///< less at each visit than at the one before
};

/// The way of a walk, from the features it began at to those it ended at. Empty where it found itself below at once.
struct VoronoiPath {
  std::vector<VoronoiVisit> visits{};
  WalkEnd end = WalkEnd::not_walked;
};

/// The distance by walking from one Voronoi region to the next, from the nearest features of the last question: where
/// shapes move little, a few steps lead to the present ones, however many features there are (M. Lin, J. Canny, "A Fast
/// Algorithm for Incremental Distance Calculation", 1991; B. Mirtich, "V-Clip: Fast and Robust Polyhedral Collision
/// Detection", 1998). A walk cannot loop: each step counts only if the distance falls. What it finds is proved, with
/// the planes around the features; where that fails, and where shapes penetrate, GJK takes over.
///
/// All that `distance_by_gjk` promises, bit by bit. `regions_a` and `regions_b` are those of the shapes, without radii,
/// in their own frames; throws Error where they are of another number of vertices. Regions of another shape cost a
/// search and change nothing; those of an equal hull that was built apart, a look at its vertices.
[[nodiscard]] Distance distance_by_voronoi_walk(const PosedPolytope& a, const VoronoiRegions& regions_a,
                                                const PosedPolytope& b, const VoronoiRegions& regions_b,
                                                TrackedPair& tracked);

/// The same, and tells the way, for pictures and teaching. It is walked from what is kept even where a proof would have
/// told at once that nothing has changed; the answer is the same.
[[nodiscard]] Distance distance_by_voronoi_walk(const PosedPolytope& a, const VoronoiRegions& regions_a,
                                                const PosedPolytope& b, const VoronoiRegions& regions_b,
                                                TrackedPair& tracked, VoronoiPath& path);

}  // namespace toccata
