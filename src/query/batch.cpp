#include "toccata/query/batch.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "query/ask_each.hpp"
#include "query/nearest/nearest_search.hpp"
#include "query/rays/ray_search.hpp"
#include "query/search_scratch.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"
#include "trees/chunks.hpp"

namespace toccata {
namespace {

ContactCount count_of(std::span<const Contact> contacts, std::vector<std::pair<Index, Index>>& faces) {
  faces.clear();
  for (const Contact& contact : contacts) faces.emplace_back(contact.face_a, contact.face_b);
  const std::size_t triangle_pairs = faces.size();
  std::sort(faces.begin(), faces.end());
  const auto last = std::unique(faces.begin(), faces.end());
  return {triangle_pairs, static_cast<std::size_t>(last - faces.begin())};
}

// The questions, each of two models, a query about them and a workspace. Every one is asked in two forms.

struct AskOverlapOfModels {
  using Answer = char;  // and no bit, because the threads write neighbours
  char operator()(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) const {
    return overlap(a, b, query, workspace) ? 1 : 0;
  }
};

struct AskRelationOfModels {
  using Answer = Relation;
  Relation operator()(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) const {
    return relation(a, b, query, workspace);
  }
};

struct AskContactsOfModels {
  using Answer = std::vector<Contact>;
  Answer operator()(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) const {
    const auto found = contacts(a, b, query, workspace);
    return {found.begin(), found.end()};
  }
};

struct AskContactCountOfModels {
  using Answer = ContactCount;
  ContactCount operator()(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) const {
    return count_of(contacts(a, b, query, workspace), workspace.scratch().faces);
  }
};

struct AskContactRegionsOfModels {
  using Answer = std::vector<ContactRegion>;
  Answer operator()(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) const {
    return contact_regions(a, b, query, workspace);
  }
};

struct AskDistanceOfModels {
  using Answer = Distance;
  Distance operator()(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) const {
    return distance(a, b, query, workspace);
  }
};

struct AskWithinDistanceOfModels {
  using Answer = char;
  char operator()(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) const {
    return within_distance(a, b, tolerance, query, workspace) ? 1 : 0;
  }
  double tolerance;
};

struct AskDistanceWithinOfModels {
  using Answer = std::optional<Distance>;
  Answer operator()(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) const {
    return distance_within(a, b, limit, query, workspace);
  }
  double limit;
};

struct AskPenetrationOfModels {
  using Answer = Penetration;
  Penetration operator()(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) const {
    return penetration(a, b, query, workspace);
  }
};

struct AskManifoldOfModels {
  using Answer = Manifold;
  Manifold operator()(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) const {
    return manifold(a, b, query, workspace);
  }
};

struct AskCastOfModels {
  using Answer = ShapeHit;
  ShapeHit operator()(const Model& a, const Model& b, const CastQuery& query, Workspace& workspace) const {
    return cast_shape(a, query.motion, b, query.poses, workspace);
  }
};

template <class Ask, class Query>
std::vector<typename Ask::Answer> ask_at_poses(const Model& a, const Model& b, std::span<const Query> queries,
                                               const BatchOptions& options, const Ask& ask = {}) {
  return ask_each<typename Ask::Answer>(
      queries, "query", options, [&](const Query& query, Workspace& workspace) { return ask(a, b, query, workspace); });
}

template <class Ask, class Pair>
std::vector<typename Ask::Answer> ask_of_pairs(std::span<const Pair> pairs, const BatchOptions& options,
                                               const Ask& ask = {}) {
  return ask_each<typename Ask::Answer>(pairs, "pair", options, [&](const Pair& pair, Workspace& workspace) {
    return ask(pair.a, pair.b, pair.query, workspace);
  });
}

/// What all rays are cast at, where that is one and the same.
std::unique_ptr<const RaySearch> common_search(std::span<const RayQuery> queries, const Model& target) {
  const auto same = [&](const RayQuery& query) {
    return query.pose == queries[0].pose && query.solid == queries[0].solid;
  };
  if (queries.size() < 2 || !std::all_of(queries.begin(), queries.end(), same)) return {};
  try {
    return std::make_unique<const RaySearch>(target, queries[0].pose, queries[0].solid);
  } catch (const Error&) {
    return {};  // query 0 will say why
  }
}

/// Throws for the first that is no ray.
std::vector<PreparedRay> prepared(std::span<const RayQuery> queries) {
  std::vector<PreparedRay> rays;
  rays.reserve(queries.size());
  for (const RayQuery& query : queries) try {
      rays.emplace_back(query.origin, query.motion);
    } catch (const Error& error) {
      throw Error(fmt::format("query {}: {}", rays.size(), error.what()));
    }
  return rays;
}

/// How many rays in a row one thread takes: they walk together, and the more there are the better.
std::size_t row_of_rays(std::size_t count, int threads) {
  constexpr std::size_t rows_per_thread = 4, shortest = 64, longest = 256;
  return std::clamp(count / (rows_per_thread * static_cast<std::size_t>(thread_count(threads))), shortest, longest);
}

/// Rows of rays, each on one thread.
std::vector<RayHit> hits_of(const RaySearch& search, const std::vector<PreparedRay>& rays,
                            const BatchOptions& options) {
  std::vector<RayHit> hits(rays.size());
  TaskReporter reporter(options.progress, rays.size());
  const Chunks rows{rays.size(), row_of_rays(rays.size(), options.threads)};
  parallel_for(rows.size(), options.threads, [&](std::size_t row) {
    if (reporter.cancelled()) return;
    const auto of_row = rows.of(std::span(hits), row);
    search.first_hits(rows.of(std::span(rays), row), of_row);
    for (std::size_t i = 0; i < of_row.size(); ++i) reporter.finished_one();
  });
  return hits;
}

std::vector<bool> as_bits(const std::vector<char>& bytes) { return {bytes.begin(), bytes.end()}; }

}  // namespace

std::vector<bool> overlap_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                               const BatchOptions& options) {
  return as_bits(ask_at_poses<AskOverlapOfModels>(a, b, queries, options));
}

std::vector<bool> overlap_each(std::span<const ModelPair> pairs, const BatchOptions& options) {
  return as_bits(ask_of_pairs<AskOverlapOfModels>(pairs, options));
}

std::vector<Relation> relation_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                    const BatchOptions& options) {
  return ask_at_poses<AskRelationOfModels>(a, b, queries, options);
}

std::vector<Relation> relation_each(std::span<const ModelPair> pairs, const BatchOptions& options) {
  return ask_of_pairs<AskRelationOfModels>(pairs, options);
}

std::vector<std::vector<Contact>> contacts_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                                const BatchOptions& options) {
  return ask_at_poses<AskContactsOfModels>(a, b, queries, options);
}

std::vector<std::vector<Contact>> contacts_each(std::span<const ModelPair> pairs, const BatchOptions& options) {
  return ask_of_pairs<AskContactsOfModels>(pairs, options);
}

std::vector<ContactCount> count_contacts_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                              const BatchOptions& options) {
  return ask_at_poses<AskContactCountOfModels>(a, b, queries, options);
}

std::vector<ContactCount> count_contacts_each(std::span<const ModelPair> pairs, const BatchOptions& options) {
  return ask_of_pairs<AskContactCountOfModels>(pairs, options);
}

std::vector<std::vector<ContactRegion>> contact_regions_each(const Model& a, const Model& b,
                                                             std::span<const PairQuery> queries,
                                                             const BatchOptions& options) {
  return ask_at_poses<AskContactRegionsOfModels>(a, b, queries, options);
}

std::vector<std::vector<ContactRegion>> contact_regions_each(std::span<const ModelPair> pairs,
                                                             const BatchOptions& options) {
  return ask_of_pairs<AskContactRegionsOfModels>(pairs, options);
}

std::vector<Distance> distance_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                    const BatchOptions& options) {
  return ask_at_poses<AskDistanceOfModels>(a, b, queries, options);
}

std::vector<Distance> distance_each(std::span<const ModelPair> pairs, const BatchOptions& options) {
  return ask_of_pairs<AskDistanceOfModels>(pairs, options);
}

std::vector<bool> within_distance_each(const Model& a, const Model& b, double tolerance,
                                       std::span<const PairQuery> queries, const BatchOptions& options) {
  return as_bits(ask_at_poses(a, b, queries, options, AskWithinDistanceOfModels{tolerance}));
}

std::vector<bool> within_distance_each(std::span<const ModelPair> pairs, double tolerance,
                                       const BatchOptions& options) {
  return as_bits(ask_of_pairs(pairs, options, AskWithinDistanceOfModels{tolerance}));
}

std::vector<std::optional<Distance>> distance_within_each(const Model& a, const Model& b, double limit,
                                                          std::span<const PairQuery> queries,
                                                          const BatchOptions& options) {
  return ask_at_poses(a, b, queries, options, AskDistanceWithinOfModels{limit});
}

std::vector<std::optional<Distance>> distance_within_each(std::span<const ModelPair> pairs, double limit,
                                                          const BatchOptions& options) {
  return ask_of_pairs(pairs, options, AskDistanceWithinOfModels{limit});
}

std::vector<Penetration> penetration_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                          const BatchOptions& options) {
  return ask_at_poses<AskPenetrationOfModels>(a, b, queries, options);
}

std::vector<Penetration> penetration_each(std::span<const ModelPair> pairs, const BatchOptions& options) {
  return ask_of_pairs<AskPenetrationOfModels>(pairs, options);
}

std::vector<Manifold> manifold_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                    const BatchOptions& options) {
  return ask_at_poses<AskManifoldOfModels>(a, b, queries, options);
}

std::vector<Manifold> manifold_each(std::span<const ModelPair> pairs, const BatchOptions& options) {
  return ask_of_pairs<AskManifoldOfModels>(pairs, options);
}

std::vector<ShapeHit> cast_shape_each(const Model& a, const Model& b, std::span<const CastQuery> queries,
                                      const BatchOptions& options) {
  return ask_at_poses<AskCastOfModels>(a, b, queries, options);
}

std::vector<ShapeHit> cast_shape_each(std::span<const CastPair> pairs, const BatchOptions& options) {
  return ask_of_pairs<AskCastOfModels>(pairs, options);
}

std::vector<RayHit> cast_ray_each(std::span<const RayQuery> queries, const Model& target, const BatchOptions& options) {
  require_one_each(options.warm_start, queries.size(), "query");
  if (const std::unique_ptr<const RaySearch> common = common_search(queries, target))
    return hits_of(*common, prepared(queries), options);
  return ask_each<RayHit>(queries, "query", options, [&](const RayQuery& query, Workspace&) {
    return cast_ray(query.origin, query.motion, target, query.pose, query.solid);
  });
}

std::vector<RayHit> cast_ray_each(std::span<const RayPair> pairs, const BatchOptions& options) {
  return ask_each<RayHit>(pairs, "pair", options, [](const RayPair& pair, Workspace&) {
    const RayQuery& query = pair.query;
    return cast_ray(query.origin, query.motion, pair.target, query.pose, query.solid);
  });
}

std::vector<SurfacePoint> nearest_point_each(std::span<const Vec3> points, const Model& surface,
                                             const NearestQuery& query, const BatchOptions& options) {
  const NearestSearch search(surface, query, points.size());
  return ask_in_rows<SurfacePoint>(points, options,
                                   [&](std::span<const Vec3> row, std::span<SurfacePoint> found, Workspace& workspace) {
                                     search.nearest(row, found, workspace.scratch());
                                   });
}

std::vector<std::vector<SurfacePoint>> nearest_points_each(std::span<const Vec3> points, std::size_t k,
                                                           const Model& surface, const NearestQuery& query,
                                                           const BatchOptions& options) {
  const NearestSearch search(surface, query, points.size());
  return ask_each<std::vector<SurfacePoint>>(points, "point", options, [&](const Vec3& point, Workspace& workspace) {
    return search.nearest(point, k, workspace.scratch());
  });
}

}  // namespace toccata
