#include "narrow/quadrics/distance/fast_pair.hpp"

#include "math/vec3_measures.hpp"
#include "narrow/convex/close_rise.hpp"
#include "narrow/quadrics/distance/axial_box.hpp"
#include "narrow/quadrics/distance/ellipsoid_pair.hpp"
#include "narrow/quadrics/distance/fast_overlap.hpp"

namespace toccata {
namespace {

/// The search ends early: what it leaves, Newton's method gains faster, and where that fails it goes on.
constexpr double fast_parts[] = {0.7, 0.1, 1e-2, 1e-3};

/// What gaps in a pair's frame may be off by, with u = 2⁻⁵³. All coordinates of centres and columns are at most 2
/// there, and off by 6 u and 2 u. So the height of a generator is off by 21 u for its centre and 37 u for its growth,
/// and the gap of two support points differs from what their heights leave by 100 u: 216 u in all.
constexpr double rounding_in_pair = 0x1p-44;

double gap_rounding(const PosedQuadric&, const PairFrame&) { return rounding_in_pair; }

/// The farthest vertex of a hull that is looked at in its own frame is found there: in the world any two may change
/// their places by what rounding does to them there (close_rise.hpp), which is much where the hull is far from the
/// origin.
double gap_rounding(const PosedPolytope& b, const PairFrame& frame) {
  if (b.in_world()) return rounding_in_pair;
  return rounding_in_pair + frame.factor * most_close_rise(b.pose(), b.stored_extent(), height_rounding);
}

/// In a pair's frame: the intervals of greater distances are narrow.
constexpr double least_wide_distance = 0x1p-29;

bool is_fast(const PosedQuadric& shape) {
  return is_moderate(shape.half().x) && is_moderate(shape.half().y) && is_moderate(shape.half().z);
}
bool is_fast(const PosedPolytope& shape) { return shape.radius() == 0 || is_moderate(shape.radius()); }

template <class B>
bool are_fast(const PosedQuadric& a, const B& b, const PairFrame& frame) {
  return is_moderate(frame.factor) && is_fast(a) && is_fast(b);
}

}  // namespace

bool is_fast(const PosedQuadric& a, const PosedQuadric& b, const PairFrame& frame) { return are_fast(a, b, frame); }
bool is_fast(const PosedQuadric& a, const PosedPolytope& b, const PairFrame& frame) { return are_fast(a, b, frame); }

template <class B>
FastPair<B>::FastPair(const PosedQuadric& a, const B& b, const PairFrame& frame, const Vec3& first_direction)
    : a_(a),
      b_(b),
      body_a_(a, frame),
      body_b_(b, frame),
      search_(body_a_, body_b_, first_direction == Vec3{} ? body_a_.middle() - body_b_.middle() : first_direction),
      refinement_(body_a_, body_b_),
      gap_rounding_(gap_rounding(b, frame)) {}

template <class B>
std::optional<FastDistance> FastPair<B>::distance() {
  for (const double part : fast_parts) {
    search_.run(part);
    if (search_.inside()) return {};
    refinement_.begin(search_.simplex(), search_.nearest());
    if (refinement_.run()) {
      is_guess_ = true;
      const auto found = proved_distance(a_, b_, refinement_);
      return found || !refinement_.refine() ? found : proved_distance(a_, b_, refinement_);
    }
    if (search_.stalled()) return {};
  }
  return {};
}

template <class B>
std::optional<Vec3> FastPair<B>::common_point() const {
  if (!search_.inside()) return {};
  const QuadricSearch::Simplex around = search_.simplex();
  return are_surely_around_origin(around) ? std::optional(common_point_of(around)) : std::nullopt;
}

template <class B>
std::optional<QuadricContact> FastPair<B>::contact() {
  if (is_apart()) return QuadricContact::apart;
  if (search_.inside() && are_surely_around_origin(search_.simplex())) return QuadricContact::contact;
  return {};
}

template <class B>
bool FastPair<B>::is_apart() {
  search_.run_until_apart();
  if (search_.best_gap() > gap_rounding_) return true;
  return search_.best_gap() > 0 && lower_along(search_.best_direction()) > 0;
}

template <class B>
std::optional<bool> FastPair<B>::is_within(double tolerance, double factor) {
  search_.run_until_compared(factor * tolerance);
  // By so much more that the tolerance lies below the interval of the distance too, which is wider for tiny gaps only.
  const double length = (1 + 0x1p-38) * plain_length(search_.best_direction());
  if (search_.best_gap() > length * (factor * tolerance) + (least_wide_distance + gap_rounding_)) return false;
  refinement_.begin(search_.simplex(), search_.nearest());
  if (proved_interval(a_, b_, refinement_.on_a(), refinement_.on_b(), refinement_.direction()).upper <= tolerance)
    return true;
  return {};
}

template <class B>
double FastPair<B>::lower_along(const Vec3& direction) {
  const std::array<QuadricSearch::Corner, 1> corner{
      QuadricSearch::Corner{body_a_.support(-direction), body_b_.support(direction), 1}};
  refinement_.begin(corner, direction);
  return proved_interval(a_, b_, refinement_.on_a(), refinement_.on_b(), direction).lower;
}

template class FastPair<PosedQuadric>;
template class FastPair<PosedPolytope>;

namespace {

template <class B>
std::optional<QuadricContact> contact_in_doubles(const PosedQuadric& a, const B& b) {
  const PairFrame frame = pair_frame(a, b);
  return is_fast(a, b, frame) ? FastPair(a, b, frame).contact() : std::nullopt;
}

}  // namespace

std::optional<QuadricContact> fast_contact(const PosedQuadric& a, const PosedQuadric& b) {
  if (const auto found = ellipsoid_contact(a, b)) return found;
  return contact_in_doubles(a, b);
}
std::optional<QuadricContact> fast_contact(const PosedQuadric& a, const PosedPolytope& b) {
  if (const auto found = axial_box_contact(a, b)) return found;
  return contact_in_doubles(a, b);
}

namespace {

bool are_ellipsoids(const PosedQuadric& a, const PosedQuadric& b) {
  constexpr PosedQuadric::Kind ellipsoid = PosedQuadric::kind_of<Ellipsoid>;
  return a.kind() == ellipsoid && b.kind() == ellipsoid;
}

}  // namespace

std::optional<QuadricContact> contact_before_depth(const PosedQuadric& a, const PosedQuadric& b) {
  return are_ellipsoids(a, b) ? ellipsoid_contact(a, b) : fast_contact(a, b);
}
std::optional<QuadricContact> contact_before_depth(const PosedQuadric& a, const PosedPolytope& b) {
  return fast_contact(a, b);
}
std::optional<QuadricContact> contact_after_depth(const PosedQuadric& a, const PosedQuadric& b) {
  return are_ellipsoids(a, b) ? contact_in_doubles(a, b) : std::nullopt;
}
std::optional<QuadricContact> contact_after_depth(const PosedQuadric&, const PosedPolytope&) { return {}; }

}  // namespace toccata
