#include <cmath>
#include <limits>
#include <optional>

#include "math/constants.hpp"
#include "narrow/convex/aligned_cores.hpp"
#include "narrow/convex/cached_simplex.hpp"
#include "narrow/convex/core_distance.hpp"
#include "narrow/convex/gjk.hpp"
#include "narrow/convex/likely_features.hpp"
#include "narrow/exact/exact_distance.hpp"
#include "narrow/exact/exact_nearest.hpp"
#include "narrow/exact/intersection_certificate.hpp"
#include "narrow/exact/nearest_certificate.hpp"
#include "narrow/exact/nearest_formula.hpp"
#include "narrow/near.hpp"
#include "narrow/primitives/closed_forms.hpp"
#include "narrow/primitives/pair_distances.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

void keep(SimplexCache& workspace, const VertexPairs& simplex, const Vec3& difference) {
  workspace.vertex_a = simplex.a;
  workspace.vertex_b = simplex.b;
  workspace.simplex_size = static_cast<int>(simplex.size);
  workspace.direction = -difference;
}

/// Positive is apart.
std::optional<bool> certain_meeting(const BoundedNumber& gap) {
  if (gap.is_positive()) return false;
  if (gap.is_negative()) return true;
  return {};
}

std::optional<Distance> rounded(const BoundedNumber& gap, const BoundedVector& on_a, const BoundedVector& on_b) {
  const auto neighbours = bracket(gap);
  const auto point_a = nearest_doubles(on_a), point_b = nearest_doubles(on_b);
  if (!neighbours || !point_a || !point_b) return {};
  return Distance{neighbours->lower, neighbours->upper, *point_a, *point_b, Status::exact};
}

std::optional<Distance> at_common_point(const BoundedVector& point) {
  const auto common = nearest_doubles(point);
  if (!common) return {};
  return Distance{0, 0, *common, *common, Status::exact};
}

bool are_exactly_within(const ExactNearest& nearest, const PosedPolytope& a, const PosedPolytope& b, double length) {
  return nearest.meet || compare_offset_distance(nearest, a.radius(), b.radius(), length) != Sign::positive;
}

/// One question about two shapes; of `is_within` and `certainly_beyond` with the length.
class ConvexQuestion {
 public:
  ConvexQuestion(const PosedPolytope& a, const PosedPolytope& b, SimplexCache& workspace,
                 const GjkOptions& options = {}, double length = 0)
      : kernels_(support_kernels()),
        options_(options),
        a_(a, kernels_, options.support),
        b_(b, kernels_, options.support),
        length_(length),
        reach_(length == 0 ? exactly(a.radius()) + exactly(b.radius())
                           : exactly(a.radius()) + exactly(b.radius()) + exactly(length)),
        workspace_(workspace) {
    a_.begin_at(workspace.vertex_a[0]);
    b_.begin_at(workspace.vertex_b[0]);
  }
  ConvexQuestion(const ConvexQuestion&) = delete;
  ConvexQuestion& operator=(const ConvexQuestion&) = delete;
  ~ConvexQuestion() { workspace_.counts.heights += a_.heights() + b_.heights(); }

  bool is_within() {
    GjkEnd end;
    if (const std::optional<bool> within = certainly_within(end)) return *within;
    ++workspace_.counts.exact;
    return are_exactly_within(exact(end.simplex.pairs), a_.shape(), b_.shape(), length_);
  }

  bool certainly_beyond() {
    if (is_beyond_as_before()) return certified(true);
    const GjkEnd end = search_to_reach();
    return !end.inside && is_beyond(direction_of(end)) && certified(true);
  }

  DirectedGap certain_gap() {
    const GjkEnd end = search_to_reach();
    if (end.inside) return {};
    const Vec3& direction = direction_of(end);
    const double radii = (a_.shape().radius() + b_.shape().radius()) * (1 + 0x1p-50);
    const double gap = (certain_gap_along(a_, b_, direction) - radii) * (1 - 0x1p-50);
    if (!(gap > 0)) return {};
    certified(true);
    return {gap, -direction};
  }

  /// A common point of cores depends on the simplex in which it is found, and must not depend on what was asked before:
  /// there the search starts anew.
  Distance distance() {
    const VertexPairs kept = cached_simplex(workspace_, a_.shape(), b_.shape());
    if (kept.size > 0) {
      // Shapes that moved little often have the same nearest features.
      if (const auto distance = distance_by_formula(kept)) return *distance;
      if (const auto distance = distance_by(search(kept, to_the_end()), Cores::apart)) return *distance;
    } else if (const VertexPairs likely = likely_features(a_.shape(), b_.shape()); likely.size > 0) {
      if (const auto distance = distance_by_formula(likely)) return *distance;
      if (const auto distance = distance_from(certain_nearest(a_, b_, likely))) return *distance;
    }
    if (options_.acceleration != GjkAcceleration::none)
      if (const auto distance = distance_by(search({}, to_the_end()), Cores::apart)) return *distance;
    const GjkEnd end = search({}, {no_goal});
    const bool is_plain = end.size <= largest_of_plain;
    if (is_plain)
      if (const auto distance = distance_by(end, Cores::any)) return *distance;
    const ExactNearest nearest = exact(is_plain ? end.simplex.pairs : first_vertices());
    if (!nearest.meet)
      if (const auto distance = distance_by_formula(nearest.simplex)) return *distance;
    ++workspace_.counts.exact;
    return rounded_distance(nearest, a_.shape().radius(), b_.shape().radius());
  }

 private:
  /// Products overflow beyond, and then it depends on how many vertices are compared at a time where the search ends.
  static constexpr double largest_of_plain = 0x1p500;
  static constexpr double no_goal = std::numeric_limits<double>::quiet_NaN();

  /// Which answers are taken.
  enum class Cores { apart, any };

  /// Are the cores no farther apart than the radii and the length together? Tells where the search ended.
  std::optional<bool> certainly_within(GjkEnd& end) {
    if (is_beyond_as_before()) return certified(false);
    end = search_to_reach();
    const VertexPairs& simplex = end.simplex.pairs;
    if (!end.inside && is_beyond(direction_of(end))) return certified(false);
    if (end.inside && contains_origin(a_.shape(), b_.shape(), simplex)) return certified(true);
    if (!(reach_.value.high > 0) || end.inside) return {};
    if (length_ > 0 && certainly_nearer(a_.shape(), b_.shape(), simplex, std::nextafter(reach_.value.high, 0)))
      return certified(true);
    if (const auto found = certain_nearest(a_, b_, simplex))
      if (const auto meet = certain_meeting(found->distance - reach_)) return certified(*meet);
    return {};
  }

  /// What parted the shapes last time mostly does so again.
  [[nodiscard]] bool is_beyond_as_before() const {
    return !(workspace_.direction == Vec3{}) && is_beyond(-workspace_.direction);
  }

  [[nodiscard]] bool is_beyond(const Vec3& direction) const {
    return certainly_farther(a_, b_, direction, upper_reach());
  }

  GjkEnd search_to_reach() {
    return search(cached_simplex(workspace_, a_.shape(), b_.shape()), {reach_.value.high, options_.acceleration});
  }

  static const Vec3& direction_of(const GjkEnd& end) {
    const bool stopped_early = !(end.separating == Vec3{});
    return stopped_early ? end.separating : end.nearest;
  }

  [[nodiscard]] GjkGoal to_the_end() const { return {no_goal, options_.acceleration}; }

  GjkEnd search(const VertexPairs& start, const GjkGoal& goal) {
    const GjkEnd end = search_nearest(a_, b_, start, goal);
    workspace_.counts.steps += end.steps;
    workspace_.counts.support_points += end.support_points;
    keep(workspace_, end.simplex.pairs, end.nearest);
    return end;
  }

  template <class Answer>
  Answer certified(const Answer& answer) {
    ++workspace_.counts.certificates;
    return answer;
  }

  [[nodiscard]] double upper_reach() const { return std::nextafter(reach_.value.high, infinity); }

  std::optional<Distance> distance_by(const GjkEnd& end, Cores cores) {
    const VertexPairs& simplex = end.simplex.pairs;
    if (!end.inside) {
      std::optional<Distance> distance = distance_by_formula(simplex);
      if (!distance) distance = distance_from(certain_nearest(a_, b_, simplex));
      return distance ? distance : distance_from(certain_nearest_along(a_, b_, end.nearest));
    }
    if (cores != Cores::any) return {};
    if (const std::optional<Vec3> point = plain_common_point(a_.shape(), b_.shape(), simplex))
      return certified(Distance{0, 0, *point, *point, Status::exact});
    if (!contains_origin(a_.shape(), b_.shape(), simplex)) return {};
    const std::optional<Distance> distance = at_common_point(common_point(a_.shape(), b_.shape(), simplex));
    return distance ? certified(distance) : distance;
  }

  /// Every way that ends at nearest features asks this of them before it answers with more digits: so the answer does
  /// not tell which way it was.
  std::optional<Distance> distance_by_formula(const VertexPairs& simplex) {
    const std::optional<NearestFeatures> features = canonical_features(simplex);
    if (!features || (asked_ && *features == *asked_)) return {};
    asked_ = features;
    const FeaturePoints points = points_of(*features, a_, b_);
    NearestFormula formula(*features, points);
    if (formula.prove(a_, b_)) return distance_by(formula);
    if (!formula.before()) return {};
    for (std::size_t i = 0; i < features->count_a + features->count_b; ++i) {
      const std::optional<NearestFeatures> others = exchanged(*features, i, *formula.before());
      if (!others) continue;
      const FeaturePoints other_points = points_of(*others, a_, b_);
      NearestFormula other(*others, other_points);
      if (other.prove(a_, b_)) return distance_by(other);
    }
    return {};
  }

  std::optional<Distance> distance_by(const NearestFormula& formula) {
    const std::optional<Distance> distance = formula.distance(a_.shape().radius(), b_.shape().radius());
    if (!distance) return {};
    keep(workspace_, pairs_of(formula.features()), formula.nearest().difference);
    return certified(distance);
  }

  std::optional<Distance> distance_from(const std::optional<CertainNearest>& found) {
    if (!found) return {};
    keep(workspace_, found->pairs, high_parts(found->difference));
    if (!found->unique()) return exact_on_faces(*found);
    if (const std::optional<Distance> distance = distance_by_formula(found->pairs)) return distance;
    const std::optional<Distance> distance = offset_distance(*found);
    return distance ? certified(distance) : distance;
  }

  [[nodiscard]] std::optional<Distance> offset_distance(const CertainNearest& found) const {
    if (reach_.value.high == 0) return rounded(found.distance, found.on_a, found.on_b);
    const BoundedNumber gap = found.distance - reach_;
    const BoundedNumber radius_a = exactly(a_.shape().radius()), radius_b = exactly(b_.shape().radius());
    const auto meet = certain_meeting(gap);
    if (!meet) return {};
    if (*meet) return at_common_point(found.on_a - (radius_a / reach_) * found.difference);
    return rounded(gap, found.on_a - (radius_a / found.distance) * found.difference,
                   found.on_b + (radius_b / found.distance) * found.difference);
  }

  /// Which of the nearest points of two faces is meant is a matter of exact arithmetic.
  Distance exact_on_faces(const CertainNearest& found) {
    ++workspace_.counts.exact;
    const std::span<const Index> face_a(found.face_a.vertex.data(), found.face_a.count);
    const std::span<const Index> face_b(found.face_b.vertex.data(), found.face_b.count);
    return rounded_distance(exact_nearest_of_faces(a_.shape(), b_.shape(), found.pairs, face_a, face_b),
                            a_.shape().radius(), b_.shape().radius());
  }

  ExactNearest exact(const VertexPairs& start) {
    ExactNearest nearest = exact_nearest(a_.shape(), b_.shape(), start);
    keep(workspace_, nearest.simplex, nearest.meet ? Vec3{} : rounded_direction(nearest.direction));
    return nearest;
  }

  SupportKernels kernels_;
  GjkOptions options_;
  SupportSearch a_, b_;
  double length_;
  BoundedNumber reach_;                   // the sum of the radii and the length
  std::optional<NearestFeatures> asked_;  // of the formula, in vain
  SimplexCache& workspace_;
};

/// Sums of longer ones overflow.
constexpr double greatest_asked_length = 0x1p1000;

std::optional<Distance> distance_by_closed_form(const PosedPolytope& a, const PosedPolytope& b,
                                                SimplexCache* workspace) {
  std::optional<Distance> found;
  if (const Distance distance = distance_of_primitives(a, b); is_known(distance)) found = distance;
  if (!found) found = distance_of_aligned_cores(a, b);
  if (found && workspace != nullptr) ++workspace->counts.closed_forms;
  return found;
}

/// Is the exact distance at most the length, which is not negative?
bool is_within(const PosedPolytope& a, const PosedPolytope& b, double length, SimplexCache* workspace) {
  if (length == 0) return overlap(a, b, workspace);
  std::optional<Distance> known = distance_by_closed_form(a, b, workspace);
  if (!known && !(length < greatest_asked_length)) known = distance_by_gjk(a, b, {}, workspace);
  if (known) {
    if (known->upper <= length) return true;
    return known->lower <= length && are_exactly_within(exact_nearest(a, b, first_vertices()), a, b, length);
  }
  SimplexCache alone;
  return ConvexQuestion(a, b, workspace != nullptr ? *workspace : alone, {}, length).is_within();
}

}  // namespace

bool overlap(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace) {
  if (const Nearness nearness = nearness_by_formula(a, b); nearness != Nearness::unknown) {
    if (workspace != nullptr) ++workspace->counts.closed_forms;
    return nearness == Nearness::meet;
  }
  if (const std::optional<bool> meet = aligned_cores_meet(a, b)) {  // those that touch
    if (workspace != nullptr) ++workspace->counts.closed_forms;
    return *meet;
  }
  return overlap_by_gjk(a, b, {}, workspace);
}

Distance distance(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace) {
  if (const auto found = distance_by_closed_form(a, b, workspace)) return *found;
  return distance_by_gjk(a, b, {}, workspace);
}

std::optional<Nearby> nearby(const PosedPolytope& a, const PosedPolytope& b, const WantedDistance& wanted,
                             SimplexCache* kept) {
  return nearby_by(
      wanted, Quicker::distance, [&](double length) { return is_within(a, b, length, kept); },
      [&] { return distance(a, b, kept); });
}

bool certainly_beyond(const PosedPolytope& a, const PosedPolytope& b, double length, SimplexCache* kept) {
  if (!(length < greatest_asked_length)) return false;
  SimplexCache alone;
  return ConvexQuestion(a, b, kept != nullptr ? *kept : alone, {}, length).certainly_beyond();
}

DirectedGap certain_gap(const PosedPolytope& a, const PosedPolytope& b, double enough, SimplexCache* kept) {
  if (!(enough < greatest_asked_length)) return {};
  SimplexCache alone;
  return ConvexQuestion(a, b, kept != nullptr ? *kept : alone, {}, enough).certain_gap();
}

bool overlap_by_gjk(const PosedPolytope& a, const PosedPolytope& b, const GjkOptions& options,
                    SimplexCache* workspace) {
  SimplexCache alone;
  return ConvexQuestion(a, b, workspace != nullptr ? *workspace : alone, options).is_within();
}

Distance distance_by_gjk(const PosedPolytope& a, const PosedPolytope& b, const GjkOptions& options,
                         SimplexCache* workspace) {
  SimplexCache alone;
  return ConvexQuestion(a, b, workspace != nullptr ? *workspace : alone, options).distance();
}

}  // namespace toccata
