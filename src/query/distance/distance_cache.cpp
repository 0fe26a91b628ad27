#include "toccata/query/distance_cache.hpp"

#include <fmt/format.h>

#include "query/ask.hpp"
#include "query/ask_each.hpp"
#include "query/distance/coherent_distance.hpp"
#include "query/numbered.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// Two models of which nothing is kept between questions are the same to a cache.
bool is_same(const Model& kept, const Model& given) {
  return kept.has_mesh() ? given.has_mesh() && &kept.wide_bvh() == &given.wide_bvh() : !given.has_mesh();
}

void bind(CoherentState& state, const Model& a, const Model& b) {
  if (!state.a) {
    state.a = a;
    state.b = b;
  }
  if (!is_same(*state.a, a) || !is_same(*state.b, b))
    throw Error(
        "the distance cache was used with other models before, or one of them was deformed since: keep one cache for "
        "each pair of models, asked in one order, or clear() it");
}

/// The distance of two convex shapes of which one is a quadric; nothing for other models.
std::optional<Distance> quadric_distance(const Model& a, const Model& b, const PairQuery& query, CoherentState& state) {
  const PosedModelPair models(a, b, query, state.workspace.scratch());
  if (models.a.parts.size() != 1 || models.b.parts.size() != 1) return {};
  const PosedPart &part_a = models.a.parts[0], &part_b = models.b.parts[0];
  const bool is_kept = !(state.quadric_direction == Vec3{});
  const auto found = coherent_quadric_distance(part_a.shape, part_b.shape, state.quadric_direction);
  if (!found) return {};
  state.counts.searches += is_kept ? 0 : 1;
  state.counts.last = {};
  return numbered(*found, part_a, part_b);
}

}  // namespace

DistanceCache::DistanceCache() : state_(std::make_unique<CoherentState>()) {}
DistanceCache::~DistanceCache() = default;
DistanceCache::DistanceCache(DistanceCache&&) noexcept = default;
DistanceCache& DistanceCache::operator=(DistanceCache&&) noexcept = default;

void DistanceCache::clear() { *state_ = CoherentState{}; }

const DistanceCacheCounts& DistanceCache::counts() const { return state_->counts; }

Distance distance(const Model& a, const Model& b, const PairQuery& query, DistanceCache& cache) {
  CoherentState& state = cache.state();
  bind(state, a, b);
  if (!a.has_mesh() || !b.has_mesh()) {
    ++state.counts.questions;
    if (const auto found = quadric_distance(a, b, query, state)) return *found;
    ++state.counts.searches;
    const Distance found = distance(a, b, query, state.workspace);
    state.counts.last = state.workspace.counts();
    return found;
  }
  const PosedModelPair models(a, b, query, state.workspace.scratch());
  return coherent_distance(std::get<PosedTriangles>(models.a.parts[0].shape),
                           std::get<PosedTriangles>(models.b.parts[0].shape), state);
}

std::vector<Distance> distance_each(std::span<const ModelPair> pairs, std::span<DistanceCache> caches,
                                    const BatchOptions& options) {
  if (caches.size() != pairs.size())
    throw Error(
        fmt::format("{} distance caches are given for {} pairs; give one for each", caches.size(), pairs.size()));
  BatchOptions plain;
  plain.threads = options.threads;
  plain.progress = options.progress;
  return ask_each(pairs.size(), "pair", plain, [&](std::size_t i, Workspace&) {
    return distance(pairs[i].a, pairs[i].b, pairs[i].query, caches[i]);
  });
}

}  // namespace toccata
