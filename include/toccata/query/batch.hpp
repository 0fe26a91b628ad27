#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "toccata/core/parallel.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/manifold.hpp"
#include "toccata/query/nearest.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {

// The questions asked many times at once: about two models for many poses, or about an array of pairs. Entry i of an
// answer is what the question of the same name answers for queries[i] or pairs[i]; it depends neither on the others nor
// on the number of threads. Throws Error as that question does, the message beginning with "query i: " or "pair i: ",
// of the least such i.

struct BatchOptions {
  int threads = all_threads;
  Progress progress{};
  /// None, or one for each query or pair: where its search ended. A caller who asks about the same ones step by step
  /// keeps them; that saves time, and changes no answer. Throws Error when there are more or fewer.
  std::span<SimplexCache> warm_start{};
};

/// An entry of an array of pairs. A Model is cheap to copy: copies share what is large.
struct ModelPair {
  Model a;
  Model b;
  PairQuery query{};
};

/// How many triangles, and how many faces of the files, meet. A face that was cut into triangles meets a face once,
/// however many of these do.
struct ContactCount {
  std::size_t triangle_pairs = 0;
  std::size_t face_pairs = 0;
  friend constexpr bool operator==(const ContactCount&, const ContactCount&) = default;
};

[[nodiscard]] std::vector<bool> overlap_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                             const BatchOptions& options = {});
[[nodiscard]] std::vector<bool> overlap_each(std::span<const ModelPair> pairs, const BatchOptions& options = {});

[[nodiscard]] std::vector<Relation> relation_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                                  const BatchOptions& options = {});
[[nodiscard]] std::vector<Relation> relation_each(std::span<const ModelPair> pairs, const BatchOptions& options = {});

[[nodiscard]] std::vector<std::vector<Contact>> contacts_each(const Model& a, const Model& b,
                                                              std::span<const PairQuery> queries,
                                                              const BatchOptions& options = {});
[[nodiscard]] std::vector<std::vector<Contact>> contacts_each(std::span<const ModelPair> pairs,
                                                              const BatchOptions& options = {});

/// The contacts counted and not kept.
[[nodiscard]] std::vector<ContactCount> count_contacts_each(const Model& a, const Model& b,
                                                            std::span<const PairQuery> queries,
                                                            const BatchOptions& options = {});
[[nodiscard]] std::vector<ContactCount> count_contacts_each(std::span<const ModelPair> pairs,
                                                            const BatchOptions& options = {});

[[nodiscard]] std::vector<std::vector<ContactRegion>> contact_regions_each(const Model& a, const Model& b,
                                                                           std::span<const PairQuery> queries,
                                                                           const BatchOptions& options = {});
[[nodiscard]] std::vector<std::vector<ContactRegion>> contact_regions_each(std::span<const ModelPair> pairs,
                                                                           const BatchOptions& options = {});

[[nodiscard]] std::vector<Distance> distance_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                                  const BatchOptions& options = {});
[[nodiscard]] std::vector<Distance> distance_each(std::span<const ModelPair> pairs, const BatchOptions& options = {});

[[nodiscard]] std::vector<bool> within_distance_each(const Model& a, const Model& b, double tolerance,
                                                     std::span<const PairQuery> queries,
                                                     const BatchOptions& options = {});
[[nodiscard]] std::vector<bool> within_distance_each(std::span<const ModelPair> pairs, double tolerance,
                                                     const BatchOptions& options = {});

[[nodiscard]] std::vector<std::optional<Distance>> distance_within_each(const Model& a, const Model& b, double limit,
                                                                        std::span<const PairQuery> queries,
                                                                        const BatchOptions& options = {});
[[nodiscard]] std::vector<std::optional<Distance>> distance_within_each(std::span<const ModelPair> pairs, double limit,
                                                                        const BatchOptions& options = {});

[[nodiscard]] std::vector<Penetration> penetration_each(const Model& a, const Model& b,
                                                        std::span<const PairQuery> queries,
                                                        const BatchOptions& options = {});
[[nodiscard]] std::vector<Penetration> penetration_each(std::span<const ModelPair> pairs,
                                                        const BatchOptions& options = {});

[[nodiscard]] std::vector<Manifold> manifold_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                                  const BatchOptions& options = {});
[[nodiscard]] std::vector<Manifold> manifold_each(std::span<const ModelPair> pairs, const BatchOptions& options = {});

/// A question for `cast_shape`: A moves by `motion` (world), from where `poses` places it.
struct CastQuery {
  Vec3 motion;
  PairQuery poses{};
};

struct CastPair {
  Model a;
  Model b;
  CastQuery query;
};

[[nodiscard]] std::vector<ShapeHit> cast_shape_each(const Model& a, const Model& b, std::span<const CastQuery> queries,
                                                    const BatchOptions& options = {});
[[nodiscard]] std::vector<ShapeHit> cast_shape_each(std::span<const CastPair> pairs, const BatchOptions& options = {});

/// A question for `cast_ray`: from `origin` to `origin + motion` (world), at a target where `pose` places it.
struct RayQuery {
  Vec3 origin;
  Vec3 motion;
  Pose pose{};
  Solid solid = Solid::automatic;
};

struct RayPair {
  RayQuery query;
  Model target;
};

[[nodiscard]] std::vector<RayHit> cast_ray_each(std::span<const RayQuery> queries, const Model& target,
                                                const BatchOptions& options = {});
[[nodiscard]] std::vector<RayHit> cast_ray_each(std::span<const RayPair> pairs, const BatchOptions& options = {});

// The same surface is asked about many points. An error's message begins with "point i: ".

[[nodiscard]] std::vector<SurfacePoint> nearest_point_each(std::span<const Vec3> points, const Model& surface,
                                                           const NearestQuery& query = {},
                                                           const BatchOptions& options = {});
[[nodiscard]] std::vector<std::vector<SurfacePoint>> nearest_points_each(std::span<const Vec3> points, std::size_t k,
                                                                         const Model& surface,
                                                                         const NearestQuery& query = {},
                                                                         const BatchOptions& options = {});

}  // namespace toccata
