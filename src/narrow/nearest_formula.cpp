#include "narrow/nearest_formula.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace toccata {
namespace {

// Errors are in units of u = 2^-53. World vertices are exact; a difference x of two of them is off by u|x|. All bounds
// below are of first order and rounded up by some per cent: terms of second order are 2^-20 of them at most, as
// `nearly` asks, and computing a bound takes less than fifty roundings. Lengths are between 2^-100 and 2^100 and
// squares of areas not less than 2^-400, so that what underflow takes, at most 2^-1074 times a few lengths, is less
// than 2^-300 of any bound.
constexpr double u = 0x1p-53;

bool in_range(double squared_length) { return squared_length >= 0x1p-200 && squared_length <= 0x1p200; }

/// An error is small enough for its square to be left aside.
bool nearly(double relative_error) { return relative_error <= 0x1p-20; }

/// A direction of the features' exact difference, each coordinate off by `slack` at most.
struct Across {
  Vec3 direction;
  double slack = 0;
  Sign side = Sign::positive;  ///< of a plane: whether the direction is its normal, or its opposite
};

struct Solution {
  FormulaNearest nearest;
  Across across;
};

/// Two features as FeaturePair has them: edges start at the first vertex of each shape, those of B turned round, so
/// that exchanging the shapes turns the first difference and all edges round, exactly.
class PlainPair {
 public:
  PlainPair(const SupportSearch& a, const SupportSearch& b, const NearestFeatures& features)
      : features_(features), first_a_(a.vertex(features.a[0])), first_b_(b.vertex(features.b[0])) {
    for (std::size_t i = 1; i < features.count_a; ++i) edge_[edges_++] = {a.vertex(features.a[i]), first_a_};
    for (std::size_t i = 1; i < features.count_b; ++i) edge_[edges_++] = {first_b_, b.vertex(features.b[i])};
    first_ = first_a_ - first_b_;
  }

  [[nodiscard]] std::optional<Solution> solve() const {
    if (edges_ == 0) return at_vertices();
    return edges_ == 1 ? on_edge() : on_plane();
  }

  [[nodiscard]] bool is_plane() const { return edges_ == 2; }
  [[nodiscard]] const Vec3& first_a() const { return first_a_; }
  [[nodiscard]] const Vec3& first_b() const { return first_b_; }

  /// Of a plane: the exact sign of the normal's product with a difference of vertices.
  [[nodiscard]] Sign height_sign(const Difference& vector) const {
    return triple_product_sign(edge_[0], edge_[1], vector);
  }

 private:
  [[nodiscard]] Vec3 along(std::size_t i) const { return edge_[i].head - edge_[i].tail; }

  [[nodiscard]] std::optional<Solution> at_vertices() const {
    const double squared = dot(first_, first_);
    if (!in_range(squared)) return {};
    const double distance = std::sqrt(squared);
    return Solution{{first_a_, first_b_, 0, first_, 2 * u * distance, distance, 4 * u * distance},
                    {first_, 2 * u * distance}};
  }

  /// The share t = −first · e / e · e is off by 12u |first| / |e|. Off along the edge, the difference changes its
  /// length in second order only; what rounds apart from that is `other`.
  [[nodiscard]] std::optional<Solution> on_edge() const {
    const Vec3 edge = along(0);
    const double squared = dot(edge, edge), first_squared = dot(first_, first_);
    if (!in_range(squared) || !in_range(first_squared)) return {};
    const double share = -dot(first_, edge) / squared;
    const double length = std::sqrt(squared), first_length = std::sqrt(first_squared);
    const double share_error = 13 * u * (first_length / length);
    if (!(share > share_error && 1 - share > share_error + 2 * u)) return {};
    const Vec3 moved = share * edge, difference = first_ + moved;
    const double distance = std::sqrt(dot(difference, difference));
    const double other = 1.25 * u * (first_length + 2 * length + distance), aside = 1.0625 * share_error * length;
    if (!(distance >= 0x1p-100) || !nearly((aside + other) / distance)) return {};
    const double off = 1.0625 * (aside + other);
    const bool of_a = features_.count_a == 2;
    return Solution{{of_a ? first_a_ + moved : first_a_, of_a ? first_b_ : first_b_ - moved, aside, difference, off,
                     distance, other + aside * (aside / distance) + 5 * u * distance},
                    {difference, off}};
  }

  /// With the normal n = e × f of the edges, height h = n · first, the difference is (h / n · n) n. n is off by
  /// 6u |e||f|, as a vector, h by 11u |e||f||first|.
  [[nodiscard]] std::optional<Solution> on_plane() const {
    const Vec3 e = along(0), f = along(1), normal = cross(e, f);
    const double e_squared = dot(e, e), f_squared = dot(f, f), first_squared = dot(first_, first_);
    const double squared = dot(normal, normal), height = dot(normal, first_);
    if (!in_range(e_squared) || !in_range(f_squared) || !in_range(first_squared) || !(squared >= 0x1p-400)) return {};
    const double e_length = std::sqrt(e_squared), f_length = std::sqrt(f_squared);
    const double first_length = std::sqrt(first_squared), normal_length = std::sqrt(squared);
    const double area = e_length * f_length, normal_off = 6 * u * (area / normal_length);
    const double height_off = 11 * u * (area * first_length) / std::fabs(height);
    if (!nearly(height_off + 2 * normal_off)) return {};  // NaN included
    // The shares of e and f, times `squared`; off by 16u |first||e||f| times |f| and |e|.
    const Vec3 from_f = cross(f, first_), from_e = cross(first_, e);
    const double of_e = dot(from_f, normal), of_f = dot(from_e, normal);
    const double share_off = 17 * u * (first_length * area), whole_off = squared * (2 * normal_off + 6 * u);
    const double e_off = share_off * f_length, f_off = share_off * e_length;
    if (!(of_e > e_off && of_f > f_off)) return {};
    const bool two_edges = features_.count_a == 2;
    const double rest = two_edges ? squared - std::fmax(of_e, of_f) : (squared - of_e) - of_f;
    if (!(rest > 1.0625 * (whole_off + (e_off + f_off)))) return {};

    const double distance = std::fabs(height) / normal_length;
    const Vec3 difference = (height / squared) * normal;
    const double off = 1.0625 * distance * (height_off + 3 * normal_off + 8 * u);
    Solution solution{{{}, {}, off, difference, off, distance, 1.0625 * distance * (height_off + normal_off + 6 * u)},
                      {height > 0 ? normal : -normal, 6 * u * area, height > 0 ? Sign::positive : Sign::negative}};
    FormulaNearest& nearest = solution.nearest;
    if (two_edges) {
      nearest.on_a = first_a_ + (of_e / squared) * e;
      nearest.on_b = first_b_ - (of_f / squared) * f;
      const double skew = area / normal_length;
      nearest.point_error =
          1.0625 * (17 * u * first_length * skew * skew + std::fmax(e_length, f_length) * (2 * normal_off + 8 * u));
    } else if (features_.count_a == 1) {
      nearest.on_a = first_a_;
      nearest.on_b = first_a_ - difference;
    } else {
      nearest.on_a = first_b_ + difference;
      nearest.on_b = first_b_;
    }
    return solution;
  }

  const NearestFeatures& features_;
  Vec3 first_a_, first_b_;
  Vec3 first_;
  std::array<Difference, 2> edge_;
  std::size_t edges_ = 0;
};

constexpr Index most_close = 12;

/// All vertices of a shape but those of the feature certainly lie beyond the plane through the feature, of which
/// `first` is a vertex. `beyond` tells the exact sign for those that rounding does not tell apart.
template <class Beyond>
bool others_beyond(const SupportSearch& shape, const Across& across, const Vec3& first, std::span<const Index> own,
                   const Beyond& beyond) {
  std::array<Index, most_close> close;
  const Index count = shape.close(across.direction, {across.slack, across.slack, across.slack}, first, own, close);
  return count <= most_close && std::all_of(close.begin(), close.begin() + count,
                                            [&](Index i) { return beyond(shape.vertex(i)) == Sign::positive; });
}

bool only_nearest(const SupportSearch& a, const SupportSearch& b, const PlainPair& pair, const NearestFeatures& f,
                  const Across& across) {
  const auto beyond = [&](const Difference& vector) {
    return pair.is_plane() ? across.side * pair.height_sign(vector) : Sign::zero;
  };
  return others_beyond(a, across, pair.first_a(), std::span(f.a).first(f.count_a),
                       [&](const Vec3& vertex) {
                         return beyond({vertex, pair.first_a()});
                       }) &&
         others_beyond(b, {-across.direction, across.slack, across.side}, pair.first_b(),
                       std::span(f.b).first(f.count_b), [&](const Vec3& vertex) {
                         return beyond({pair.first_b(), vertex});
                       });
}

/// Exact arithmetic does better there: distances along an axis are often doubles.
bool is_along_axis(const Vec3& v) { return (v.x == 0) + (v.y == 0) + (v.z == 0) > 1; }

double largest(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// The interval around a gap that is off by at most `error`.
std::optional<Distance> interval(double gap, double error) {
  if (!(error <= 0.45e-12 * gap)) return {};
  const double off = 1.0625 * error + 4 * u * gap;
  return Distance{gap - off, gap + off, {}, {}, Status::exact};
}

/// What the promise lets points be off by: more than this for the greatest coordinate that is not known here. The rest
/// is for what rounds by that coordinate.
bool points_are_good(const FormulaNearest& nearest, double error, double radius_a, double radius_b) {
  return error <= 0.9e-12 * std::max({largest(nearest.on_a), largest(nearest.on_b), radius_a, radius_b});
}

}  // namespace

std::optional<NearestFeatures> canonical_features(const VertexPairs& simplex) {
  NearestFeatures f;
  const auto insert = [](std::array<Index, 3>& vertices, std::size_t& count, Index vertex) {
    std::size_t at = 0;
    while (at < count && vertices[at] < vertex) ++at;
    if (at < count && vertices[at] == vertex) return true;
    if (count == 3) return false;
    for (std::size_t i = count++; i > at; --i) vertices[i] = vertices[i - 1];
    vertices[at] = vertex;
    return true;
  };
  for (std::size_t i = 0; i < simplex.size; ++i)
    if (!insert(f.a, f.count_a, simplex.a[i]) || !insert(f.b, f.count_b, simplex.b[i])) return {};
  if (f.count_a == 0 || f.count_a + f.count_b > 4) return {};
  return f;
}

std::optional<FormulaNearest> nearest_by_formula(const SupportSearch& a, const SupportSearch& b,
                                                 const NearestFeatures& features) {
  const PlainPair pair(a, b, features);
  const std::optional<Solution> solution = pair.solve();
  if (!solution || is_along_axis(solution->nearest.difference)) return {};
  if (!in_certain_range(solution->across.direction)) return {};
  if (!only_nearest(a, b, pair, features, solution->across)) return {};
  return solution->nearest;
}

std::optional<Distance> formula_distance(const FormulaNearest& nearest, double radius_a, double radius_b) {
  if (radius_a + radius_b == 0) {
    if (!points_are_good(nearest, nearest.point_error, 0, 0)) return {};
    std::optional<Distance> result = interval(nearest.distance, nearest.distance_error);
    if (!result) return {};
    result->on_a = nearest.on_a;
    result->on_b = nearest.on_b;
    return result;
  }
  const double reach = radius_a + radius_b, gap = nearest.distance - reach;
  const double error = nearest.distance_error + 1.0625 * u * (reach + std::fabs(gap));
  const double turned = 2.125 * (nearest.difference_error / nearest.distance) + 8 * u;
  if (!points_are_good(nearest, nearest.point_error + turned * std::fmax(radius_a, radius_b), radius_a, radius_b))
    return {};
  if (gap < -error) {
    // As seen from both sides, so that exchanging the shapes does not show.
    const Vec3 of_a = nearest.on_a - (radius_a / reach) * nearest.difference;
    const Vec3 of_b = nearest.on_b + (radius_b / reach) * nearest.difference;
    const Vec3 common = 0.5 * of_a + 0.5 * of_b;
    return Distance{0, 0, common, common, Status::exact};
  }
  std::optional<Distance> result = interval(gap, error);
  if (!result) return {};
  result->on_a = nearest.on_a - (radius_a / nearest.distance) * nearest.difference;
  result->on_b = nearest.on_b + (radius_b / nearest.distance) * nearest.difference;
  return result;
}

}  // namespace toccata
