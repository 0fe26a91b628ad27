#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "toccata/core/function_ref.hpp"
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
template <class Query>
struct PairOf {
  Model a;
  Model b;
  Query query{};
};

using ModelPair = PairOf<PairQuery>;

/// What is asked about: two models for many queries, `distance_each({a, b, queries})`, or an array of pairs,
/// `distance_each(pairs)`. The queries or pairs are referred to.
template <class Query>
class Batch {
 public:
  Batch(Model a, Model b, std::span<const Query> queries)
      : models_{{std::move(a), std::move(b)}}, queries_(queries), count_(queries.size()) {}
  /// `make(i)` makes query i when its turn comes, for who has the poses of a million in another form and no use for a
  /// second array of them. It is referred to, called once for each query, and from many threads at once.
  Batch(Model a, Model b, std::size_t count, FunctionRef<Query(std::size_t)> make)
      : models_{{std::move(a), std::move(b)}}, make_(make), count_(count) {}
  template <class Pairs>
  requires std::convertible_to<const Pairs&, std::span<const PairOf<Query>>> Batch(const Pairs& pairs)
      : pairs_(pairs), count_(pairs_.size()) {}

  [[nodiscard]] std::size_t size() const { return count_; }
  /// `ask(a, b, query)` of entry i.
  template <class Ask>
  auto asked(std::size_t i, const Ask& ask) const {
    if (!models_) return ask(pairs_[i].a, pairs_[i].b, pairs_[i].query);
    const auto& [a, b] = *models_;
    return make_ ? ask(a, b, (*make_)(i)) : ask(a, b, queries_[i]);
  }
  /// What an error calls one of them.
  [[nodiscard]] const char* noun() const { return models_ ? "query" : "pair"; }

 private:
  std::optional<std::pair<Model, Model>> models_{};
  std::span<const Query> queries_{};
  std::optional<FunctionRef<Query(std::size_t)>> make_{};
  std::span<const PairOf<Query>> pairs_{};
  std::size_t count_ = 0;
};

/// How many triangles, and how many faces of the files, meet. A face that was cut into triangles meets a face once,
/// however many of these do.
struct ContactCount {
  std::size_t triangle_pairs = 0;
  std::size_t face_pairs = 0;
  friend constexpr bool operator==(const ContactCount&, const ContactCount&) = default;
};

/// 1 where they have a point in common, else 0.
[[nodiscard]] std::vector<std::uint8_t> overlap_each(const Batch<PairQuery>& batch, const BatchOptions& options = {});
[[nodiscard]] std::vector<Relation> relation_each(const Batch<PairQuery>& batch, const BatchOptions& options = {});

[[nodiscard]] std::vector<std::vector<Contact>> contacts_each(const Batch<PairQuery>& batch,
                                                              const BatchOptions& options = {});
/// The contacts counted and not kept.
[[nodiscard]] std::vector<ContactCount> count_contacts_each(const Batch<PairQuery>& batch,
                                                            const BatchOptions& options = {});
[[nodiscard]] std::vector<std::vector<ContactRegion>> contact_regions_each(const Batch<PairQuery>& batch,
                                                                           const BatchOptions& options = {});

[[nodiscard]] std::vector<Distance> distance_each(const Batch<PairQuery>& batch, const BatchOptions& options = {});
/// 1 where they are at most so far from each other, else 0.
[[nodiscard]] std::vector<std::uint8_t> within_distance_each(const Batch<PairQuery>& batch, double max_distance,
                                                             const BatchOptions& options = {});
[[nodiscard]] std::vector<std::optional<Distance>> distance_within_each(const Batch<PairQuery>& batch,
                                                                        double max_distance,
                                                                        const BatchOptions& options = {});

[[nodiscard]] std::vector<Penetration> penetration_each(const Batch<PairQuery>& batch,
                                                        const BatchOptions& options = {});
/// A time limit is that of each question.
[[nodiscard]] std::vector<DepthBracket> depth_bracket_each(const Batch<PairQuery>& batch, const DepthOptions& depth,
                                                           const BatchOptions& options = {});
[[nodiscard]] std::vector<Manifold> manifold_each(const Batch<PairQuery>& batch, const BatchOptions& options = {});

/// A question for `cast_shape`: A moves by `motion` (world), from where `poses` places it.
struct CastQuery {
  Vec3 motion;
  PairQuery poses{};
};

using CastPair = PairOf<CastQuery>;

[[nodiscard]] std::vector<std::optional<ShapeHit>> cast_shape_each(const Batch<CastQuery>& batch,
                                                                   const BatchOptions& options = {});

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

[[nodiscard]] std::vector<std::optional<RayHit>> cast_ray_each(std::span<const RayQuery> queries, const Model& target,
                                                               const BatchOptions& options = {});
[[nodiscard]] std::vector<std::optional<RayHit>> cast_ray_each(std::span<const RayPair> pairs,
                                                               const BatchOptions& options = {});

// The same surface is asked about many points. An error's message begins with "point i: ".

[[nodiscard]] std::vector<std::optional<SurfacePoint>> nearest_point_each(std::span<const Vec3> points,
                                                                          const Model& surface,
                                                                          const NearestQuery& query = {},
                                                                          const BatchOptions& options = {});
[[nodiscard]] std::vector<std::vector<SurfacePoint>> nearest_points_each(std::span<const Vec3> points, std::size_t k,
                                                                         const Model& surface,
                                                                         const NearestQuery& query = {},
                                                                         const BatchOptions& options = {});

}  // namespace toccata
