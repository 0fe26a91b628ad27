#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "toccata/query/batch.hpp"
#include "toccata/query/distance.hpp"

namespace toccata {

struct CoherentState;

/// What the questions asked with a cache cost.
struct DistanceCacheCounts {
  std::size_t questions = 0;
  std::size_t searches = 0;  ///< those questions that were searched as without a cache
  WalkCounts last{};         ///< boxes compared and pairs of triangles looked at by the last
};

/// What is kept of one question of distance for the next about the same two meshes or height fields, which have moved
/// little in between: where the search stopped, and how far everything that it left out is at least. The next looks
/// only at what can have come near by the motion since, which it computes from the poses. It changes no bit of any
/// answer, and any motion is allowed; the smaller the motion, the less is looked at. While surfaces meet, and under
/// poses that shear, a question costs what it costs without. For two convex shapes of which one is a quadric the
/// direction between them is kept: there numbers may move within their interval.
///
/// It holds on to the models. One thread may use it at a time.
class DistanceCache {
 public:
  DistanceCache();
  ~DistanceCache();
  DistanceCache(DistanceCache&&) noexcept;
  DistanceCache& operator=(DistanceCache&&) noexcept;

  /// Forgets everything, also which models it was used for.
  void clear();

  [[nodiscard]] const DistanceCacheCounts& counts() const;

  /// For the library itself.
  [[nodiscard]] CoherentState& state() { return *state_; }

 private:
  std::unique_ptr<CoherentState> state_;
};

/// What `distance` answers without a cache, to the last bit (but see above). The first question binds the cache to the
/// meshes and height fields among its two models, in their order; with another mesh it throws Error, and so it does for
/// copies made before one was deformed. Nothing that binds is kept of other shapes, so they may change; where one of
/// the two is such, and neither is a quadric, it costs what `distance` costs with a Workspace. Throws like that else.
[[nodiscard]] Distance distance(const Model& a, const Model& b, const PairQuery& query, DistanceCache& cache);

/// The same of many pairs, as in batch.hpp, on several threads: caches[i] is that of pairs[i], step by step. (Of one
/// pair at many poses each question waits for the one before: ask them in turn.) `warm_start` of the options is not
/// looked at. Throws like it ("pair i: "; what other pairs' caches know then differs, and no answer), and Error when
/// there is not one cache for each pair.
[[nodiscard]] std::vector<Distance> distance_each(std::span<const ModelPair> pairs, std::span<DistanceCache> caches,
                                                  const BatchOptions& options = {});

}  // namespace toccata
