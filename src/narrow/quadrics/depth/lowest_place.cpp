#include "narrow/quadrics/depth/lowest_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/depth/quadric_cap.hpp"
#include "narrow/quadrics/distance/fast_refinement.hpp"
#include "narrow/quadrics/distance/quadric_proof.hpp"

// Let n be the axis of a cap of directions, at angles up to φ₀ with n, where no height of D = A − B is less than L
// (QuadricCap). Let x be a point of D beside n, and z = n · x. A direction m at the angle φ with n, which turns from it
// towards the unit vector α across n, has a height of at least
//
//   h(m) ≥ m · x = z cos φ + (α · x) sin φ.
//
// Where α · x is positive for two directions α that are less than a half turn apart, it is no less than the lesser of
// these, r, for all between them. And z cos φ + r sin φ is concave in φ where it is positive: what is at least L > 0 at
// two angles is so between them. So a few points around n show the heights of a ring, from φ₀ to π − β, or of two, from
// φ₀ to π / 2 and from there on. The rest lies around −n, where one point q of D does, with H = −n · q and at the
// distance s aside of it:
//
//   h(m) ≥ H cos β − s sin β.
//
// All of this holds by far or not at all, so that doubles do. Only the height of the cap has to be known as narrowly as
// the depth is told.
namespace toccata {
namespace {

/// How far apart the bodies are brought along a direction, in a pair of size 1, so that they have nearest points.
constexpr double gap_between = 0x1p-6;
constexpr int most_turns = 4;
/// A turn that is as small is not worth another one.
constexpr double small_turn_of_guess = 0x1p-7;
constexpr int most_settling_steps = 8;
/// Heights that differ by less are one, in a pair of size 1.
constexpr double indistinct_heights = 0x1p-46;
/// Points lie across from each other but for this, in a pair of size 1.
constexpr double rounding_across_axis = 0x1p-44;
/// Deeper than this, in a pair of size 1, little comes of it.
constexpr double deepest = 0.3;
/// What the interval of the depth is asked to be as narrow as.
constexpr double width_at_lowest = 0x1p-43;
/// More than what points in doubles are off by and products with them, as a part of all that they are made of.
constexpr double rounding_of_points = 0x1p-44;

/// A direction from A to B, and the pairs of generators whose points are highest along it.
struct PlaceGuess {
  Vec3 axis;
  std::array<GeneratorPair, 3> pairs{};
  std::size_t count = 0;
  std::array<bool, 2> on_round_face{};  ///< of A, of B: within a flat end, not on a rim
};

/// Pairs of weights that have the sides' weights in sum: the point between the sides' points is one between the pairs'.
/// False where it takes more than three.
bool take_pairs(PlaceGuess& guess, const FastSide& a, const FastSide& b) {
  guess.count = 0;
  double of_a = a.weight[0], of_b = b.weight[0];
  for (std::size_t i = 0, j = 0; i < a.size && j < b.size;) {
    if (guess.count == guess.pairs.size()) return false;
    guess.pairs[guess.count++] = {a.generator[i], b.generator[j]};
    const double common = std::fmin(of_a, of_b);
    of_a -= common;
    of_b -= common;
    const bool is_a_done = j + 1 == b.size || (i + 1 < a.size && of_a <= of_b);
    if (is_a_done && ++i < a.size) of_a += a.weight[i];
    if (!is_a_done && ++j < b.size) of_b += b.weight[j];
  }
  return guess.count > 0;
}

/// The bodies are brought apart along a direction, and their nearest points tell the next one: where D is bent less
/// than the origin is deep, one that is nearer to that of the lowest place.
std::optional<PlaceGuess> guess_along(const QuadricBody& a, const QuadricBody& b, const Vec3& axis) {
  const PlainBody moved = a.PlainBody::moved(-(HighestPoint(a, b, axis).height + gap_between) * axis);
  QuadricSearch search(moved, b, -axis);
  FastRefinement refinement(moved, b);
  for (const double part : {0.7, 0.1, 1e-2}) {
    search.run(part);
    if (search.inside()) return {};
    refinement.begin(search.simplex(), search.nearest());
    if (!refinement.run()) continue;
    PlaceGuess guess{unit_or_zero(-refinement.direction())};
    guess.on_round_face = {refinement.on_a().in_cap, refinement.on_b().in_cap};
    return take_pairs(guess, refinement.on_a(), refinement.on_b()) ? std::optional(guess) : std::nullopt;
  }
  return {};
}

/// By Newton's method on the heights that the pairs have in common.
std::optional<QuadricCap> settled_cap(const QuadricBody& a, const QuadricBody& b, const PlaceGuess& guess) {
  const std::span<const GeneratorPair> pairs(guess.pairs.data(), guess.count);
  QuadricCap cap(a, b, guess.axis, pairs);
  for (int i = 0; i < most_settling_steps; ++i) {
    const std::optional<Vec3> next = cap.lower_axis();
    if (!next) return {};
    const Vec3 way = *next - cap.axis();
    cap = QuadricCap(a, b, *next, pairs);
    if (dot(way, way) < 0x1p-98) break;
  }
  return cap;
}

/// A direction from n, by the tangent of the angle.
struct TurnFromAxis {
  double cosine;
  double sine;
};

TurnFromAxis turn_of(double tangent) {
  const double cosine = 1 / std::sqrt(1 + tangent * tangent);
  return {cosine, cosine * tangent};
}

/// Whether a point of D is at least L high along all directions up to an angle β, less than a right one, from −n.
bool is_high_behind(const Vec3& axis, const Vec3& opposite, const TurnFromAxis& back, double enough) {
  const double height = -dot(axis, opposite), aside = plain_length(opposite + height * axis);
  return height * back.cosine - aside * back.sine >= enough;
}

/// Whether all heights behind are at least L, where in each direction across n some point of D that is no higher than L
/// reaches so far aside: that one shows them up to an angle with −n, and the opposite point has to show the rest.
bool are_high_behind(const Vec3& axis, const Vec3& opposite, double reach, double enough) {
  if (!(reach > 2 * enough)) return false;
  // Where z is L, β is enough for reach sin β ≥ L (1 + cos β).
  const double half = enough / reach * (1 + 0x1p-10), squared = half * half;
  return is_high_behind(axis, opposite, {(1 - squared) / (1 + squared), 2 * half / (1 + squared)}, enough);
}

/// Of what points are made of.
double size_of(const HighestPoint& point) {
  return sum_of_magnitudes(point.on_a.point) + sum_of_magnitudes(point.on_b.point);
}
double size_of_columns(const QuadricBody& body) {
  double size = 0;
  for (std::size_t j = 0; j < 3; ++j) size += sum_of_magnitudes(body.plain_column(j));
  return size;
}

/// Points of D around a cap's axis: those of its pairs, and the highest ones along directions at its rim.
class CapSurroundings {
 public:
  CapSurroundings(const QuadricBody& a, const QuadricBody& b, const QuadricCap& cap, double tangent)
      : a_(a), b_(b), axis_(cap.axis()), x_(some_across(axis_)), y_(cross(axis_, x_)), turn_(turn_of(tangent)) {
    for (std::size_t i = 0; i < cap.generators().size(); ++i) {
      size_ = std::fmax(size_, sum_of_magnitudes(cap.on_a(i).point) + sum_of_magnitudes(cap.on_b(i).point));
      take(cap.point(i));
    }
    for (std::size_t i = 0; i < around.size(); i += 2) take_highest_towards(around[i], turn_);
    const HighestPoint opposite(a, b, -axis_);
    opposite_ = opposite.point;
    size_ += size_of(opposite) + size_of_columns(a) + size_of_columns(b);
  }

  /// More than what heights that are known in doubles may be off by.
  [[nodiscard]] double rounding() const { return rounding_of_points * size_; }

  /// All heights beyond the cap are at least `least`: shown by points that reach far aside, or else by others behind.
  [[nodiscard]] bool are_higher(double least) {
    // Points that are still to be found may be larger.
    const double allowed = 2 * rounding();
    return are_high(least + allowed) && rounding() <= allowed;
  }

 private:
  /// A direction across the axis.
  using Across = std::array<double, 2>;

  static constexpr std::size_t most_points = 32;
  static constexpr int most_halvings = 3;
  static constexpr double diagonal = std::numbers::sqrt2 / 2, eighth = 0.92387953251128674, other = 0.38268343236508977;
  static constexpr std::array<Across, 8> around{{{1, 0},
                                                 {diagonal, diagonal},
                                                 {0, 1},
                                                 {-diagonal, diagonal},
                                                 {-1, 0},
                                                 {-diagonal, -diagonal},
                                                 {0, -1},
                                                 {diagonal, -diagonal}}};

  void take(const Vec3& point) { point_[count_++] = {dot(point, x_), dot(point, y_), dot(point, axis_)}; }

  /// Directions between two angles with n, and one where their points are looked for.
  struct Ring {
    TurnFromAxis first, last, towards;
  };

  [[nodiscard]] bool are_high(double enough) {
    const double reach = least_reach({turn_, {0, 1}, turn_}, enough);
    if (!(reach > 0)) return false;
    if (are_high_behind(axis_, opposite_, reach, enough)) return true;
    take(opposite_);
    return is_high_behind(axis_, opposite_, {diagonal, diagonal}, enough) &&
           least_reach({{0, 1}, {-diagonal, diagonal}, {-other, eighth}}, enough) > 0;
  }

  void take_highest_towards(const Across& across, const TurnFromAxis& turn) {
    const HighestPoint found(a_, b_, turn.cosine * axis_ + turn.sine * (across[0] * x_ + across[1] * y_));
    size_ = std::fmax(size_, size_of(found));
    take(found.point);
  }

  /// In each direction across n some point shows the heights of the ring: how far aside these reach at least; 0 where
  /// there are none.
  double least_reach(const Ring& ring, double enough) {
    double reach = HUGE_VAL;
    for (std::size_t i = 0; i < around.size() && reach > 0; ++i)
      reach = std::fmin(reach, reach_between(around[i], around[(i + 1) % around.size()], ring, enough, most_halvings));
    return reach;
  }

  /// The same between two directions. Where no point does for all, the directions are halved.
  double reach_between(const Across& from, const Across& to, const Ring& ring, double enough, int halvings) {
    double most = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      const Vec3& p = point_[k];
      const double reach = std::fmin(from[0] * p.x + from[1] * p.y, to[0] * p.x + to[1] * p.y);
      const auto is_high = [&](const TurnFromAxis& turn) { return p.z * turn.cosine + reach * turn.sine >= enough; };
      if (is_high(ring.first) && is_high(ring.last) && p.z <= enough) most = std::fmax(most, reach);
    }
    if (most > 0 || halvings == 0 || count_ + 1 >= most_points) return most;
    const double x = from[0] + to[0], y = from[1] + to[1], part = 1 / std::sqrt(x * x + y * y);
    const Across middle{part * x, part * y};
    take_highest_towards(middle, ring.towards);
    const double first = reach_between(from, middle, ring, enough, halvings - 1);
    return first > 0 ? std::fmin(first, reach_between(middle, to, ring, enough, halvings - 1)) : 0;
  }

  const QuadricBody& a_;
  const QuadricBody& b_;
  Vec3 axis_, x_, y_;
  TurnFromAxis turn_;
  Vec3 opposite_;
  std::array<Vec3, most_points> point_;  ///< across the axis, twice, and along it
  std::size_t count_ = 0;
  double size_ = 0;  ///< of what points are made of
};

/// A flat end of a cylinder or a cone, over which a point of the other body lies: a face of D. With d for its height, D
/// has a disc around its point d n, of the radius r, and as in precise_facet.cpp no direction m at the angle φ with n
/// where tan(φ / 2) ≤ r / d has a lower height than d.
std::optional<LowestPlace> proved_round_face(const QuadricBody& a, const QuadricBody& b, const PlaceGuess& guess) {
  const bool is_of_a = guess.on_round_face[0];
  const QuadricBody &body = is_of_a ? a : b, &other = is_of_a ? b : a;
  if (body.column_count() != 2) return {};
  const BoundedVector across = cross(body.column(0), body.column(1));
  const double sign = dot(plain(across), guess.axis) < 0 ? -1 : 1;
  const Vec3 axis = unit_or_zero(sign * plain(across));
  const HighestPoint highest(a, b, axis), opposite(a, b, -axis);
  const Index end = is_of_a ? guess.pairs[0].a : guess.pairs[0].b;
  const BoundedVector from_other =
      body.centre(end) - point_of<BoundedNumber>(other, body_point(is_of_a ? highest.on_b : highest.on_a));
  const BoundedNumber height = dot(from_other, across) / square_root(dot(across, across));
  const double lower = floor_of((sign < 0) == is_of_a ? -height : height);
  if (!(lower > 0) || highest.height > lower + indistinct_heights) return {};
  // Where the foot of the origin lies in the end, in units of the columns.
  const Vec3 foot = (is_of_a ? lower : -lower) * axis - plain(from_other);
  const Vec3 &u = body.plain_column(0), &v = body.plain_column(1);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), area = uu * vv - uv * uv;
  const double x = (vv * dot(u, foot) - uv * dot(v, foot)) / area, y = (uu * dot(v, foot) - uv * dot(u, foot)) / area;
  const double half = 0.5 * (uu - vv), least = 0.5 * (uu + vv) - std::sqrt(half * half + uv * uv);
  const double rounding =
      rounding_of_points * (size_of(highest) + size_of(opposite) + size_of_columns(a) + size_of_columns(b));
  const double reach = (1 - 0x1p-10 - std::sqrt(x * x + y * y)) * std::sqrt(least) - rounding;
  // Asked so that NaN is no proof.
  if (!(least > 0x1p-20 * (uu + vv)) || !are_high_behind(axis, opposite.point, reach, lower + rounding)) return {};
  const Vec3 way = lower * axis;
  if (is_of_a) return LowestPlace{axis, lower, highest.on_b.point + way, highest.on_b.point};
  return LowestPlace{axis, lower, highest.on_a.point, highest.on_a.point - way};
}

/// All of D is no higher along the axis than the cap's pairs are, as far as doubles tell.
bool is_highest(const QuadricBody& a, const QuadricBody& b, const QuadricCap& cap) {
  return HighestPoint(a, b, cap.axis()).height <= cap.height() + indistinct_heights;
}

/// Proves that the axis of a cap whose pairs are the highest is that of the lowest place. What doubles tell comes
/// first.
std::optional<LowestPlace> proved(const QuadricBody& a, const QuadricBody& b, QuadricCap& cap) {
  if (!(cap.height() > 0 && cap.height() < deepest)) return {};
  const double tangent = cap.widest_tangent(cap.height() * (1 - width_at_lowest));
  if (!(tangent > 0)) return {};
  CapSurroundings around(a, b, cap, tangent * (1 - 0x1p-10));
  const double level = cap.height() + around.rounding();
  if (!around.are_higher(level)) return {};
  cap.refine();
  const double least = cap.height() * (1 - width_at_lowest);
  if (!(least < level)) return {};
  const double lower = std::fmin(least, cap.proved_height(tangent, least));
  const Vec3 on_a = cap.between_on_a(), on_b = cap.between_on_b(), between = on_a - on_b;
  const bool are_across = plain_length(between - dot(between, cap.axis()) * cap.axis()) <= rounding_across_axis;
  return lower > 0 && are_across ? std::optional(LowestPlace{cap.axis(), lower, on_a, on_b}) : std::nullopt;
}

}  // namespace

std::optional<LowestPlace> lowest_place(const QuadricBody& a, const QuadricBody& b) {
  PlaceGuess guess{unit_or_zero(b.middle() - a.middle())};
  if (guess.axis == Vec3{}) return {};
  if (a.generator_count() == 1 && b.generator_count() == 1) {
    guess.count = 1;
    std::optional<QuadricCap> cap = settled_cap(a, b, guess);
    return cap ? proved(a, b, *cap) : std::nullopt;  // of its only generators
  }
  for (int turn = 0; turn < most_turns; ++turn) {
    const std::optional<PlaceGuess> next = guess_along(a, b, guess.axis);
    if (!next) return {};
    const Vec3 way = next->axis - guess.axis;
    guess = *next;
    if (HighestPoint(a, b, guess.axis).height > 1.25 * deepest) return {};
    if (guess.on_round_face[0] || guess.on_round_face[1]) {
      if (const std::optional<LowestPlace> found = proved_round_face(a, b, guess)) return found;
    } else if (std::optional<QuadricCap> cap = settled_cap(a, b, guess)) {
      // The next turn would find the same place again.
      if (is_highest(a, b, *cap)) return proved(a, b, *cap);
    }
    if (dot(way, way) < small_turn_of_guess * small_turn_of_guess) return {};
  }
  return {};
}

}  // namespace toccata
