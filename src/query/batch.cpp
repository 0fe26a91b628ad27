#include "toccata/query/batch.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "query/ask_each.hpp"
#include "query/nearest/nearest_search.hpp"
#include "query/penetration/solid_penetration.hpp"
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

/// `ask(a, b, query, workspace)` for every pair.
template <class Query, class Ask>
auto ask_pairs(const Batch<Query>& batch, const BatchOptions& options, const Ask& ask) {
  return ask_each(batch.size(), batch.noun(), options, [&](std::size_t i, Workspace& workspace) {
    return batch.asked(i,
                       [&](const Model& a, const Model& b, const Query& query) { return ask(a, b, query, workspace); });
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
std::vector<std::optional<RayHit>> hits_of(const RaySearch& search, const std::vector<PreparedRay>& rays,
                                           const BatchOptions& options) {
  std::vector<std::optional<RayHit>> hits(rays.size());
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

}  // namespace

std::vector<std::uint8_t> overlap_each(const Batch<PairQuery>& batch, const BatchOptions& options) {
  return ask_pairs(batch, options, [](auto&... question) { return std::uint8_t{overlap(question...)}; });
}

std::vector<Relation> relation_each(const Batch<PairQuery>& batch, const BatchOptions& options) {
  return ask_pairs(batch, options, [](auto&... question) { return relation(question...); });
}

std::vector<std::vector<Contact>> contacts_each(const Batch<PairQuery>& batch, const BatchOptions& options) {
  return ask_pairs(batch, options, [](auto&... question) {
    const auto found = contacts(question...);
    return std::vector<Contact>(found.begin(), found.end());
  });
}

std::vector<ContactCount> count_contacts_each(const Batch<PairQuery>& batch, const BatchOptions& options) {
  return ask_pairs(batch, options, [](const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
    return count_of(contacts(a, b, query, workspace), workspace.scratch().faces);
  });
}

std::vector<std::vector<ContactRegion>> contact_regions_each(const Batch<PairQuery>& batch,
                                                             const BatchOptions& options) {
  return ask_pairs(batch, options, [](auto&... question) { return contact_regions(question...); });
}

std::vector<Distance> distance_each(const Batch<PairQuery>& batch, const BatchOptions& options) {
  return ask_pairs(batch, options, [](auto&... question) { return distance(question...); });
}

std::vector<std::uint8_t> within_distance_each(const Batch<PairQuery>& batch, double max_distance,
                                               const BatchOptions& options) {
  return ask_pairs(batch, options, [&](const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
    return std::uint8_t{within_distance(a, b, max_distance, query, workspace)};
  });
}

std::vector<std::optional<Distance>> distance_within_each(const Batch<PairQuery>& batch, double max_distance,
                                                          const BatchOptions& options) {
  return ask_pairs(batch, options, [&](const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
    return distance_within(a, b, max_distance, query, workspace);
  });
}

std::vector<DepthBracket> depth_bracket_each(const Batch<PairQuery>& batch, const DepthOptions& depth,
                                             const BatchOptions& options) {
  require_usable(depth);
  return ask_pairs(batch, options, [&](const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
    return depth_bracket(a, b, query, depth, workspace);
  });
}

std::vector<Penetration> penetration_each(const Batch<PairQuery>& batch, const BatchOptions& options) {
  return ask_pairs(batch, options, [](auto&... question) { return penetration(question...); });
}

std::vector<Manifold> manifold_each(const Batch<PairQuery>& batch, const BatchOptions& options) {
  return ask_pairs(batch, options, [](auto&... question) { return manifold(question...); });
}

std::vector<std::optional<ShapeHit>> cast_shape_each(const Batch<CastQuery>& batch, const BatchOptions& options) {
  return ask_pairs(batch, options, [](const Model& a, const Model& b, const CastQuery& query, Workspace& workspace) {
    return cast_shape(a, query.motion, b, query.poses, workspace);
  });
}

std::vector<std::optional<RayHit>> cast_ray_each(std::span<const RayQuery> queries, const Model& target,
                                                 const BatchOptions& options) {
  require_one_each(options.warm_start, queries.size(), "query");
  if (const std::unique_ptr<const RaySearch> common = common_search(queries, target))
    return hits_of(*common, prepared(queries), options);
  return ask_each(queries, "query", options, [&](const RayQuery& query, Workspace&) {
    return cast_ray(query.origin, query.motion, target, query.pose, query.solid);
  });
}

std::vector<std::optional<RayHit>> cast_ray_each(std::span<const RayPair> pairs, const BatchOptions& options) {
  return ask_each(pairs, "pair", options, [](const RayPair& pair, Workspace&) {
    const RayQuery& query = pair.query;
    return cast_ray(query.origin, query.motion, pair.target, query.pose, query.solid);
  });
}

std::vector<std::optional<SurfacePoint>> nearest_point_each(std::span<const Vec3> points, const Model& surface,
                                                            const NearestQuery& query, const BatchOptions& options) {
  const NearestSearch search(surface, query, points.size());
  return ask_in_rows<std::optional<SurfacePoint>>(
      points, options,
      [&](std::span<const Vec3> row, std::span<std::optional<SurfacePoint>> found, Workspace& workspace) {
        search.nearest(row, found, workspace.scratch());
      });
}

std::vector<std::vector<SurfacePoint>> nearest_points_each(std::span<const Vec3> points, std::size_t k,
                                                           const Model& surface, const NearestQuery& query,
                                                           const BatchOptions& options) {
  const NearestSearch search(surface, query, points.size());
  return ask_each(points, "point", options, [&](const Vec3& point, Workspace& workspace) {
    return search.nearest(point, k, workspace.scratch());
  });
}

}  // namespace toccata
