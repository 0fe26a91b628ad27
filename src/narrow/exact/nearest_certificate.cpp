#include "narrow/exact/nearest_certificate.hpp"

#include <algorithm>
#include <cmath>

#include "narrow/exact/distinct_vertices.hpp"
#include "narrow/exact/feature_pair.hpp"

namespace toccata {
namespace {

/// `count` is 4 when there are more than three.
DistinctVertices distinct_as_paired(const std::array<Index, 4>& vertices, std::size_t size) {
  DistinctVertices result;
  for (std::size_t i = 0; i < size; ++i) {
    const auto end = result.vertex.begin() + static_cast<std::ptrdiff_t>(result.count);
    if (std::find(result.vertex.begin(), end, vertices[i]) != end) continue;
    if (result.count == 3) return {{}, 4};
    result.vertex[result.count++] = vertices[i];
  }
  return result;
}

/// A pair of features is solved when they are spread by the right number of independent edges.
std::optional<NearestFeatures> features_of(const VertexPairs& simplex) {
  const DistinctVertices a = distinct_as_paired(simplex.a, simplex.size),
                         b = distinct_as_paired(simplex.b, simplex.size);
  const bool solvable = simplex.size <= 3 && a.count + b.count == simplex.size + 1;
  if (!solvable) return {};
  return NearestFeatures{a.vertex, b.vertex, a.count, b.count};
}

/// The side of the planes through two features on which all other vertices have to be: beyond them for nearest features
/// of shapes that are apart, behind it for a facet of shapes that overlap.
enum class OthersAre { beyond, behind };

/// What is known of all other vertices; a vertex is before a plane on whose wrong side it is.
enum class OtherVertices { beyond, one_before, some_level, unknown };

struct Verification {
  OtherVertices others = OtherVertices::unknown;
  bool of_a = false;  ///< whose vertex lies before the plane
  Index vertex = 0;
};

/// The vertices of one shape that may lie as near as the feature does.
struct CloseVertices {
  std::array<Index, most_face_vertices> vertex{};
  Index count = 0;
};

CloseVertices close_vertices(const SupportSearch& search, const Vec3& direction, double slack, const Vec3& first,
                             std::span<const Index> own) {
  CloseVertices close;
  close.count = search.close(direction, slack, first, own, close.vertex);
  return close;
}

std::span<const Index> own_a(const NearestFeatures& f) { return std::span(f.a).first(f.count_a); }
std::span<const Index> own_b(const NearestFeatures& f) { return std::span(f.b).first(f.count_b); }

/// Positive where a vertex is on the side of the plane where it has to be.
Sign height_of(const FeaturePair& pair, OthersAre others, bool of_a, const Vec3& vertex) {
  const Sign beyond = of_a ? pair.beyond_a(vertex) : pair.beyond_b(vertex);
  return others == OthersAre::beyond ? beyond : -beyond;
}

/// Looks at the close vertices of one shape that are not of the feature, and adds those in its plane to the face.
Verification verify_others(const FeaturePair& pair, OthersAre others, const PosedPolytope& shape,
                           const CloseVertices& close, bool of_a, FaceVertices& face) {
  if (close.count > close.vertex.size()) return {};
  const std::span<const Index> own = of_a ? own_a(pair.features()) : own_b(pair.features());
  for (const Index vertex : own) face.vertex[face.count++] = vertex;
  for (Index i = 0; i < close.count; ++i) {
    const Index vertex = close.vertex[i];
    if (!pair.is_plane()) return {};
    const Sign height = height_of(pair, others, of_a, shape.vertex(vertex));
    if (height == Sign::negative) return {OtherVertices::one_before, of_a, vertex};
    if (height == Sign::zero && face.count == face.vertex.size()) return {};
    if (height == Sign::zero) face.vertex[face.count++] = vertex;
  }
  return {face.count == own.size() ? OtherVertices::beyond : OtherVertices::some_level};
}

/// All vertices of either shape in the planes through the features.
struct LevelVertices {
  FaceVertices a, b;
};

Verification verify(const SupportSearch& a, const SupportSearch& b, const FeaturePair& pair, OthersAre others,
                    LevelVertices& level) {
  level = {};
  const Vec3 difference = high_parts(pair.difference());
  const Vec3 direction = others == OthersAre::beyond ? difference : -difference;
  if (!in_certain_range(direction)) return {};
  double slack = 0;
  for (const BoundedNumber& coordinate : pair.difference()) slack = std::max(slack, distance_from_high(coordinate));
  const NearestFeatures& f = pair.features();
  const Verification of_a = verify_others(pair, others, a.shape(),
                                          close_vertices(a, direction, slack, pair.first_a(), own_a(f)), true, level.a);
  if (of_a.others == OtherVertices::unknown || of_a.others == OtherVertices::one_before) return of_a;
  const Verification of_b = verify_others(
      pair, others, b.shape(), close_vertices(b, -direction, slack, pair.first_b(), own_b(f)), false, level.b);
  if (of_b.others != OtherVertices::beyond) return of_b;
  return of_a;
}

/// A vertex is nearest to one point of a face, however many vertices the face has; all else that has more vertices in
/// the two planes may have more nearest points.
CertainNearest certain(const FeaturePair& pair, const LevelVertices& level, OtherVertices others) {
  const bool unique = others == OtherVertices::beyond || level.a.count == 1 || level.b.count == 1;
  const VertexPairs pairs = pairs_of(pair.features());
  if (!unique) return {pairs, pair.difference(), pair.distance(), {}, {}, level.a, level.b};
  return {pairs, pair.difference(), pair.distance(), pair.on_a(), pair.on_b(), {}, {}};
}

/// The features without their vertex number i, those of A counted first, and with another vertex of A or of B.
NearestFeatures exchanged(const NearestFeatures& features, std::size_t i, const Verification& added) {
  NearestFeatures f = features;
  if (i < f.count_a)
    f.a[i] = f.a[--f.count_a];
  else
    f.b[i - f.count_a] = f.b[f.count_b - 1], --f.count_b;
  if (added.of_a && f.count_a < 3) f.a[f.count_a++] = added.vertex;
  if (!added.of_a && f.count_b < 3) f.b[f.count_b++] = added.vertex;
  return f;
}

/// The pair of features with the vertex that lies before the plane of the present ones, in place of one of theirs,
/// which must lie beyond the new plane: on faces that rounding has bent, the next nearest pair.
std::optional<FeaturePair> nearer_pair(const PosedPolytope& a, const PosedPolytope& b, const NearestFeatures& present,
                                       OthersAre others, const Verification& before) {
  for (std::size_t i = 0; i < 4; ++i) {
    const NearestFeatures other = exchanged(present, i, before);
    if (other.count_a == 0 || other.count_b == 0 || other.count_a + other.count_b != 4) continue;
    FeaturePair pair(a, b, other);
    if (!pair.solve()) continue;
    const Sign left_out = i < present.count_a
                              ? height_of(pair, others, true, a.vertex(present.a[i]))
                              : height_of(pair, others, false, b.vertex(present.b[i - present.count_a]));
    if (left_out == Sign::positive) return pair;
  }
  return {};
}

/// Exchanges are few where they help at all.
constexpr int most_exchanges = 16;

/// The pair is solved.
std::optional<CertainNearest> certain_from(const SupportSearch& a, const SupportSearch& b, FeaturePair pair,
                                           OthersAre others = OthersAre::beyond) {
  for (int exchange = 0; exchange <= most_exchanges; ++exchange) {
    LevelVertices level;
    const Verification found = verify(a, b, pair, others, level);
    if (found.others == OtherVertices::unknown) return {};
    // Any of a facet's points will do.
    if (found.others != OtherVertices::one_before)
      return certain(pair, level, others == OthersAre::behind ? OtherVertices::beyond : found.others);
    const std::optional<FeaturePair> nearer = nearer_pair(a.shape(), b.shape(), pair.features(), others, found);
    if (!nearer) return {};
    pair = *nearer;
  }
  return {};
}

/// Vertices nearly as near as can be; none when they are more than a few.
class Pool {
 public:
  Pool(const SupportSearch& search, const Vec3& direction) {
    if (!in_certain_range(direction)) return;
    const double loose = 0x1p-44 * std::sqrt(dot(direction, direction));
    const Vec3 nearest = search.shape().vertex(search.least(direction));
    const Index close = search.close(direction, loose, nearest, {}, vertex_);
    if (close <= vertex_.size()) size_ = close;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Index operator[](std::size_t i) const { return vertex_[i]; }

 private:
  std::array<Index, 6> vertex_{};
  std::size_t size_ = 0;
};

/// Calls `visit` with all choices of `count` members until it returns true.
template <class Visit>
bool any_choice(const Pool& pool, std::size_t count, const Visit& visit) {
  for (std::size_t i = 0; i < pool.size(); ++i) {
    if (count == 1 && visit(std::array<Index, 3>{pool[i]})) return true;
    for (std::size_t j = i + 1; count > 1 && j < pool.size(); ++j) {
      if (count == 2 && visit(std::array<Index, 3>{pool[i], pool[j]})) return true;
      for (std::size_t k = j + 1; count > 2 && k < pool.size(); ++k)
        if (visit(std::array<Index, 3>{pool[i], pool[j], pool[k]})) return true;
    }
  }
  return false;
}

/// A vertex and a face, or two edges, solved.
std::optional<FeaturePair> any_plane_pair(const SupportSearch& a, const SupportSearch& b, const Vec3& direction) {
  const Pool pool_a(a, direction), pool_b(b, -direction);
  std::optional<FeaturePair> found;
  for (std::size_t count = 1; count <= 3 && !found; ++count)
    any_choice(pool_a, count, [&](const std::array<Index, 3>& of_a) {
      return any_choice(pool_b, 4 - count, [&](const std::array<Index, 3>& of_b) {
        FeaturePair pair(a.shape(), b.shape(), {of_a, of_b, count, 4 - count});
        if (pair.solve()) found = pair;
        return found.has_value();
      });
    });
  return found;
}

}  // namespace

std::optional<CertainNearest> certain_nearest(const SupportSearch& a, const SupportSearch& b,
                                              const VertexPairs& simplex) {
  const std::optional<NearestFeatures> features = features_of(simplex);
  if (!features) return {};
  FeaturePair pair(a.shape(), b.shape(), *features);
  if (!pair.solve()) return {};
  return certain_from(a, b, pair);
}

std::optional<CertainNearest> certain_facet(const SupportSearch& a, const SupportSearch& b,
                                            const VertexPairs& simplex) {
  const std::optional<NearestFeatures> features = features_of(simplex);
  if (!features) return {};
  FeaturePair pair(a.shape(), b.shape(), *features);
  if (!pair.is_plane() || !pair.solve()) return {};
  return certain_from(a, b, pair, OthersAre::behind);
}

std::optional<CertainNearest> certain_nearest_along(const SupportSearch& a, const SupportSearch& b,
                                                    const Vec3& direction) {
  const std::optional<FeaturePair> pair = any_plane_pair(a, b, direction);
  if (!pair) return {};
  return certain_from(a, b, *pair);
}

bool certainly_farther(const SupportSearch& a, const SupportSearch& b, const Vec3& direction, double gap) {
  if (!in_certain_range(direction)) return false;
  const double between = a.lower_bound(direction) + b.lower_bound(-direction);
  // The sign of a sum of two doubles is right; its size and the length are off by some last places.
  return between > gap * std::sqrt(dot(direction, direction)) * (1 + 0x1p-40);
}

double certain_gap_along(const SupportSearch& a, const SupportSearch& b, const Vec3& direction) {
  if (!in_certain_range(direction)) return 0;
  const double between = a.lower_bound(direction) + b.lower_bound(-direction);
  return between / std::sqrt(dot(direction, direction)) * (1 - 0x1p-40);
}

}  // namespace toccata
