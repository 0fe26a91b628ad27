#include "narrow/nearest_certificate.hpp"

#include <algorithm>
#include <cmath>

#include "math/filter.hpp"

namespace toccata {
namespace {

/// The vertices of a shape among the pairs, each once. `count` is 4 when there are more than three.
struct DistinctVertices {
  std::array<Index, 3> vertex{};
  std::size_t count = 0;
};

DistinctVertices distinct(const std::array<Index, 4>& vertices, std::size_t size) {
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
  const DistinctVertices a = distinct(simplex.a, simplex.size), b = distinct(simplex.b, simplex.size);
  const bool solvable = simplex.size <= 3 && a.count + b.count == simplex.size + 1;
  if (!solvable) return {};
  return NearestFeatures{a.vertex, b.vertex, a.count, b.count};
}

/// Pairs of which the features are made; for two edges some three of the four.
VertexPairs pairs_of(const NearestFeatures& f) {
  VertexPairs pairs;
  for (std::size_t i = 0; i < f.count_a; ++i) pairs.append(f.a[i], f.b[0]);
  for (std::size_t i = 1; i < f.count_b; ++i) pairs.append(f.a[0], f.b[i]);
  return pairs;
}

bool certainly_below(const BoundedNumber& a, const BoundedNumber& b) { return (b - a).is_positive(); }

/// What decides whether the foot of the origin on the plane first + span(u, w) lies within the triangle or the
/// parallelogram: its shares of u and w, and the square of the normal, which stands for a share of 1.
struct PlaneShares {
  Filtered u, w, whole;
};

/// A product of cross products: each term meets four differences, two products, two of their differences, a product and
/// two sums, eleven roundings, for which 16 · 2^-53 is enough. Underflow is within the floors of `FilteredCross`.
Filtered filtered_dot(const FilteredCross& p, const FilteredCross& q) {
  return {dot(p.value, q.value), 0x1p-49 * (dot(p.magnitude, q.magnitude) + filter::floor)};
}

PlaneShares plane_shares(const Vec3& first, const Vec3& u, const Vec3& w) {
  const FilteredCross normal = filtered_cross(u, w);
  return {filtered_dot(filtered_cross(w, first), normal), filtered_dot(filtered_cross(first, u), normal),
          filtered_dot(normal, normal)};
}

Filtered less(const Filtered& a, const Filtered& b) {
  // Twice what the numbers are off by is enough for the rounding of their difference, too.
  return {a.value - b.value, 2 * (a.error + b.error)};
}

/// Two features with their nearest points. The edges that spread them start at the first vertex of each; as vectors of
/// the Minkowski difference, those of B are turned round.
class FeaturePair {
 public:
  FeaturePair(const PosedConvex& a, const PosedConvex& b, const NearestFeatures& features)
      : features_(features), first_a_(a.vertex(features.a[0])), first_b_(b.vertex(features.b[0])) {
    for (std::size_t i = 1; i < features.count_a; ++i) edge_[edges_++] = {a.vertex(features.a[i]), first_a_};
    for (std::size_t i = 1; i < features.count_b; ++i) edge_[edges_++] = {first_b_, b.vertex(features.b[i])};
  }

  [[nodiscard]] const NearestFeatures& features() const { return features_; }
  [[nodiscard]] const Vec3& first_a() const { return first_a_; }
  [[nodiscard]] const Vec3& first_b() const { return first_b_; }
  [[nodiscard]] bool is_plane() const { return edges_ == 2; }

  /// Finds the nearest points of the features' affine hulls; tells whether they certainly are inner points of both.
  [[nodiscard]] bool solve() {
    const BoundedVector first = bounded_difference(first_a_, first_b_);
    if (edges_ == 0) return at_vertices(first);
    return edges_ == 1 ? on_edge(first) : on_plane(first);
  }

  [[nodiscard]] const BoundedVector& difference() const { return difference_; }
  [[nodiscard]] const BoundedNumber& distance() const { return distance_; }

  [[nodiscard]] BoundedVector on_a() const {
    if (features_.count_a == 1) return exactly(first_a_);
    if (features_.count_b == 1) return exactly(first_b_) + difference_;
    return exactly(first_a_) + share_ * along(0);
  }

  [[nodiscard]] BoundedVector on_b() const {
    if (features_.count_b == 1) return exactly(first_b_);
    return (features_.count_a == 1 ? exactly(first_a_) : on_a()) - difference_;
  }

  /// Of a plane: the exact sign of the height, along on_a − on_b, of a vector over the plane.
  [[nodiscard]] Sign height_sign(const Difference& vector) const {
    return side_ * triple_product_sign(edge_[0], edge_[1], vector);
  }

 private:
  [[nodiscard]] BoundedVector along(std::size_t edge) const {
    return bounded_difference(edge_[edge].head, edge_[edge].tail);
  }

  bool at_vertices(const BoundedVector& first) {
    difference_ = first;
    distance_ = square_root(dot(first, first));
    return distance_.is_positive();
  }

  bool on_edge(const BoundedVector& first) {
    const BoundedVector edge = along(0);
    const BoundedNumber squared = dot(edge, edge), forth = -dot(first, edge);
    if (!forth.is_positive() || !certainly_below(forth, squared)) return false;
    share_ = forth / squared;
    difference_ = first + share_ * edge;
    distance_ = square_root(dot(difference_, difference_));
    return distance_.is_positive();
  }

  bool on_plane(const BoundedVector& first) {
    const Inside inside = likely_inside();
    if (inside == Inside::no) return false;
    const BoundedVector u = along(0), w = along(1), normal = cross(u, w);
    const BoundedNumber squared = dot(normal, normal), height = dot(normal, first);
    if (!height.is_positive() && !height.is_negative()) return false;
    if (inside == Inside::unknown && !certainly_inside(first, normal, squared)) return false;
    side_ = height.is_positive() ? Sign::positive : Sign::negative;
    difference_ = (height / squared) * normal;
    distance_ = (height.is_positive() ? height : -height) / square_root(squared);
    if (features_.count_a == 2) share_ = dot(cross(w, first), normal) / squared;
    return distance_.is_positive();
  }

  enum class Inside { no, unknown, yes };

  /// Whether the nearest points are within the triangle, or within both edges, as far as doubles can tell.
  [[nodiscard]] Inside likely_inside() const {
    const auto edge = [this](std::size_t i) { return edge_[i].head - edge_[i].tail; };
    const PlaneShares share = plane_shares(first_a_ - first_b_, edge(0), edge(1));
    const Filtered not_u = less(share.whole, share.u);
    const bool edges = features_.count_a == 2;
    const std::array<Filtered, 4> conditions = {share.u, share.w, edges ? not_u : less(not_u, share.w),
                                                edges ? less(share.whole, share.w) : share.u};
    if (std::ranges::all_of(conditions, &Filtered::is_positive)) return Inside::yes;
    return std::ranges::any_of(conditions, &Filtered::is_negative) ? Inside::no : Inside::unknown;
  }

  /// The same with bounded numbers.
  [[nodiscard]] bool certainly_inside(const BoundedVector& first, const BoundedVector& normal,
                                      const BoundedNumber& whole) const {
    const BoundedNumber u = dot(cross(along(1), first), normal), w = dot(cross(first, along(0)), normal);
    if (!u.is_positive() || !w.is_positive()) return false;
    if (features_.count_a == 2) return certainly_below(u, whole) && certainly_below(w, whole);
    return certainly_below(u + w, whole);
  }

  NearestFeatures features_;
  Vec3 first_a_, first_b_;
  std::array<Difference, 2> edge_;
  std::size_t edges_ = 0;
  BoundedNumber share_;  // of the first edge
  BoundedVector difference_;
  BoundedNumber distance_;
  Sign side_ = Sign::positive;
};

/// What is known of all other vertices.
enum class Others { beyond, one_before, unknown };

struct Verification {
  Others others = Others::unknown;
  bool of_a = false;  ///< whose vertex lies before the plane
  Index vertex = 0;
};

constexpr std::size_t most_close = 12;

/// The vertices of one shape that may lie as near as the feature does.
struct CloseVertices {
  std::array<Index, most_close> vertex{};
  Index count = 0;
};

CloseVertices close_vertices(const SupportSearch& search, const Vec3& direction, const Vec3& slack, const Vec3& first) {
  CloseVertices close;
  close.count = search.close(direction, slack, first, close.vertex);
  return close;
}

/// Looks at the close vertices of one shape that are not of the feature.
Verification verify_others(const FeaturePair& pair, const PosedConvex& shape, const CloseVertices& close, bool of_a) {
  if (close.count > most_close) return {};
  const NearestFeatures& f = pair.features();
  const std::span<const Index> own = of_a ? std::span(f.a).first(f.count_a) : std::span(f.b).first(f.count_b);
  const bool alone = (of_a ? f.count_b : f.count_a) == 1;
  for (Index i = 0; i < close.count; ++i) {
    const Index vertex = std::min(close.vertex[i], shape.vertex_count() - 1);
    if (std::find(own.begin(), own.end(), vertex) != own.end()) continue;
    if (!pair.is_plane()) return {};
    const Vec3 place = shape.vertex(vertex);
    const Sign height = pair.height_sign(of_a ? Difference{place, pair.first_a()} : Difference{pair.first_b(), place});
    if (height == Sign::negative) return {Others::one_before, of_a, vertex};
    // In the plane: the face has more vertices. The nearest points stay what they are if one of them is a vertex.
    if (height == Sign::zero && !(own.size() == 3 && alone)) return {};
  }
  return {Others::beyond};
}

Verification verify(const SupportSearch& a, const SupportSearch& b, const FeaturePair& pair) {
  const Vec3 direction = high_parts(pair.difference());
  if (!in_certain_range(direction)) return {};
  Vec3 slack;
  for (int axis = 0; axis < 3; ++axis)
    slack[axis] = distance_from_high(pair.difference()[static_cast<std::size_t>(axis)]);
  const Verification of_a = verify_others(pair, a.shape(), close_vertices(a, direction, slack, pair.first_a()), true);
  if (of_a.others != Others::beyond) return of_a;
  return verify_others(pair, b.shape(), close_vertices(b, -direction, slack, pair.first_b()), false);
}

CertainNearest certain(const FeaturePair& pair, const VertexPairs& pairs) {
  return {pairs, pair.difference(), pair.distance(), pair.on_a(), pair.on_b()};
}

/// A face that rounding has bent: the other triangles with the vertex that lies before the plane of the first.
std::optional<CertainNearest> across_bend(const SupportSearch& a, const SupportSearch& b, const FeaturePair& bent,
                                          const Verification& found) {
  const NearestFeatures& f = bent.features();
  if ((found.of_a ? f.count_a : f.count_b) != 3) return {};
  for (std::size_t i = 0; i < 3; ++i) {
    NearestFeatures other = f;
    (found.of_a ? other.a : other.b)[i] = found.vertex;
    FeaturePair pair(a.shape(), b.shape(), other);
    if (pair.solve() && verify(a, b, pair).others == Others::beyond) return certain(pair, pairs_of(other));
  }
  return {};
}

BoundedNumber volume(const BoundedVector& p, const BoundedVector& q, const BoundedVector& r) {
  return dot(cross(p, q), r);
}

}  // namespace

std::optional<CertainNearest> certain_nearest(const SupportSearch& a, const SupportSearch& b,
                                              const VertexPairs& simplex) {
  const std::optional<NearestFeatures> features = features_of(simplex);
  if (!features) return {};
  FeaturePair pair(a.shape(), b.shape(), *features);
  if (!pair.solve()) return {};
  const Verification found = verify(a, b, pair);
  if (found.others == Others::beyond) return certain(pair, simplex);
  if (found.others == Others::one_before) return across_bend(a, b, pair, found);
  return {};
}

bool certainly_farther(const SupportSearch& a, const SupportSearch& b, const Vec3& direction, double gap) {
  if (!in_certain_range(direction)) return false;
  const double between = a.lower_bound(direction) + b.lower_bound(-direction);
  // The sign of a sum of two doubles is right; its size and the length are off by some last places.
  return between > gap * std::sqrt(dot(direction, direction)) * (1 + 0x1p-40);
}

bool contains_origin(const PosedConvex& a, const PosedConvex& b, const VertexPairs& simplex) {
  if (simplex.size != 4) return false;
  std::array<Difference, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = {a.vertex(simplex.a[i]), b.vertex(simplex.b[i])};
  const std::array<Sign, 4> weight = {triple_product_sign(p[1], p[2], p[3]), -triple_product_sign(p[0], p[2], p[3]),
                                      triple_product_sign(p[0], p[1], p[3]), -triple_product_sign(p[0], p[1], p[2])};
  const auto has = [&weight](Sign sign) { return std::find(weight.begin(), weight.end(), sign) != weight.end(); };
  return has(Sign::positive) != has(Sign::negative);
}

BoundedVector common_point(const PosedConvex& a, const PosedConvex& b, const VertexPairs& simplex) {
  std::array<Vec3, 4> on_a;
  std::array<BoundedVector, 4> p;
  for (std::size_t i = 0; i < 4; ++i) {
    on_a[i] = a.vertex(simplex.a[i]);
    p[i] = bounded_difference(on_a[i], b.vertex(simplex.b[i]));
  }
  const std::array<BoundedNumber, 4> weight = {volume(p[1], p[2], p[3]), -volume(p[0], p[2], p[3]),
                                               volume(p[0], p[1], p[3]), -volume(p[0], p[1], p[2])};
  const BoundedNumber total = (weight[0] + weight[1]) + (weight[2] + weight[3]);
  BoundedVector sum = weight[0] * exactly(on_a[0]);
  for (std::size_t i = 1; i < 4; ++i) sum = sum + weight[i] * exactly(on_a[i]);
  return {sum[0] / total, sum[1] / total, sum[2] / total};
}

}  // namespace toccata
