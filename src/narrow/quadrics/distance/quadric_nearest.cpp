#include "narrow/quadrics/distance/quadric_nearest.hpp"

#include <cmath>
#include <span>

#include "narrow/quadrics/distance/common_point.hpp"
#include "narrow/quadrics/distance/fine_search.hpp"
#include "narrow/quadrics/distance/separating_plane.hpp"
#include "narrow/quadrics/distance/simplex_around.hpp"
#include "narrow/quadrics/exact_place.hpp"

namespace toccata {
namespace {

/// In a pair of size 1, points that are no farther apart may be those of shapes that touch.
constexpr double close = 0x1p-36;

Vec3 plain_point(const VectorOf<BoundedDouble>& p) { return {p[0].value, p[1].value, p[2].value}; }
Vec3 plain_point(const VectorOf<BoundedNumber>& p) { return plain(p); }

/// One question.
class QuadricNearestSearch {
 public:
  QuadricNearestSearch(const QuadricBody& a, const QuadricBody& b)
      : a_(a), b_(b), search_(a, b, plain(a.middle_point()) - plain(b.middle_point())), refinement_(a, b) {}

  /// Whether the first plane that the search comes across proves the two apart.
  bool proves_apart() {
    search_.run_until_apart();
    return search_.best_gap() > 0 && improve_lower<BoundedDouble>(fine(search_.best_direction()));
  }

  /// Where the guess is as good as it seems.
  bool proves(const FastRefinement& guess) {
    refinement_.begin(guess);
    refinement_.refine();
    return prove<BoundedNumber>();
  }

  [[nodiscard]] const QuadricNearest& best() const { return best_; }

  /// Whether the search and Newton's method have decided, so that nothing more is to be asked.
  bool is_decided() {
    for (const double part : {1e-3, 1e-7, 1e-11, 0.0}) {
      search_.run(part);
      if (search_.inside() && is_meeting_proved()) return true;
      if (try_refined(search_, search_.nearest())) return true;
      if (search_.inside() || search_.stalled()) break;
    }
    const QuadricSearch::Simplex simplex = search_.simplex();
    improve_upper<BoundedNumber>(joined(simplex, true), joined(simplex, false));
    return false;
  }

  /// What is left open then.
  void decide_at_length() {
    if (best_.contact != QuadricContact::apart && is_meeting_proved()) return;
    if (try_refined(search_, search_.best_direction()) || is_decided_from_elsewhere()) return;
    if (best_.contact != QuadricContact::apart && is_meeting_found_finely()) return;
    improve_lower<BoundedNumber>(fine(search_.best_direction()));
  }

 private:
  /// The corners of the simplex as points of a body, joined with the weights.
  [[nodiscard]] BodyPoint joined(std::span<const QuadricSearch::Corner> corners, bool of_a) const {
    BodyPoint point;
    Vec3 round;
    double grown = 0;
    for (const QuadricSearch::Corner& corner : corners) {
      const QuadricSupport& support = of_a ? corner.a : corner.b;
      point.append(support.generator, {corner.weight, 0});
      if (!(of_a ? a_ : b_).grown(support.generator)) continue;
      round = round + corner.weight * support.round;
      grown += corner.weight;
    }
    for (std::size_t j = 0; j < 3; ++j) point.round[j] = {grown > 0 ? round[static_cast<int>(j)] / grown : 0, 0};
    return point;
  }

  /// Newton's method from here, and what it proves. True when nothing more is to be asked.
  bool try_refined(const QuadricSearch& search, const Vec3& direction) {
    if (direction == Vec3{}) return false;
    return attempt(search, direction, NewtonRefinement::Attempt::first) ||
           (refinement_.doubtful() && attempt(search, direction, NewtonRefinement::Attempt::second));
  }

  bool attempt(const QuadricSearch& search, const Vec3& direction, NewtonRefinement::Attempt which) {
    refinement_.begin(search.simplex(), direction, which);
    // Where the distance is small, doubles do not tell what is the direction.
    const bool settled = refinement_.settle();
    if (!settled && !(std::fabs(refinement_.signed_distance()) < 0x1p-16)) return false;
    if (settled && refinement_.signed_distance() > 0x1p-12 && prove<BoundedDouble>()) return true;
    refinement_.refine();
    return prove<BoundedNumber>() || is_shallow_meeting();
  }

  template <class Number>
  bool prove() {
    improve_lower<Number>(refinement_.direction());
    if (best_.contact == QuadricContact::apart || refinement_.signed_distance() < 0x1p-40)
      improve_upper<Number>(refinement_.on_a(), refinement_.on_b());
    best_.narrow = best_.contact == QuadricContact::apart && best_.upper - best_.lower <= relative_width * best_.upper;
    return best_.narrow;
  }

  template <class Number>
  bool improve_lower(const FineDirection& direction) {
    const double lower = gap_along<Number>(a_, b_, direction);
    if (!(lower > best_.lower)) return false;
    best_.lower = lower;
    best_.direction = direction;
    best_.contact = QuadricContact::apart;
    return true;
  }

  template <class Number>
  void improve_upper(const BodyPoint& on_a, const BodyPoint& on_b) {
    const VectorOf<Number> x = point_of<Number>(a_, on_a), y = point_of<Number>(b_, on_b);
    const double upper = distance_at_most(x, y);
    if (!(upper < best_.upper)) return;
    best_.upper = upper;
    best_.on_a = plain_point(x);
    best_.on_b = plain_point(y);
  }

  bool is_meeting_proved() { return is_meeting_proved(search_); }

  /// A common point: the simplex contains the origin, or a point of one body lies within the other.
  bool is_meeting_proved(const QuadricSearch& search) {
    const QuadricSearch::Simplex simplex = search.simplex();
    const BoundedVector of_b = point_of<BoundedNumber>(b_, joined(simplex, false)),
                        of_a = point_of<BoundedNumber>(a_, joined(simplex, true));
    if (is_simplex_around<BoundedDouble>(simplex) || is_simplex_around<BoundedNumber>(simplex)) return met(of_b);
    if (is_surrounded(a_, b_, simplex)) return met(of_b);
    if (is_common(of_a, of_b)) return true;
    for (const double part : {0.125, 0.5, 1.0})
      if (is_common(towards(of_a, a_.middle_point(), part), towards(of_b, b_.middle_point(), part))) return true;
    return false;
  }

  /// Symmetric shapes that overlap leave the origin on a face of every simplex that their symmetry offers; and of slim
  /// ones all simplices are flat.
  bool is_decided_from_elsewhere() {
    for (const Vec3& direction : {Vec3{0.36, 0.48, 0.8}, Vec3{-0.6, 0.7, -0.3}, Vec3{0.5, -0.2, -0.84}}) {
      QuadricSearch other(a_, b_, direction), rounder(a_, b_, direction, a_.roundness());
      if (is_decided_by(other) || is_decided_by(rounder)) return true;
      if (!b_.quadric_kind()) continue;
      QuadricSearch roundest(a_, b_, direction, b_.roundness());
      if (is_decided_by(roundest)) return true;
    }
    return false;
  }

  bool is_decided_by(QuadricSearch& search) {
    search.run(0);
    if (best_.contact != QuadricContact::apart && is_meeting_proved(search)) return true;
    return try_refined(search, search.in_pair(search.nearest())) ||
           try_refined(search, search.in_pair(search.best_direction()));
  }

  /// What bodies have in common, or leave between them, is lost in the rounding of doubles where they are long or slim.
  bool is_meeting_found_finely() {
    const FineEnd end = search_finely(a_, b_, search_.best_direction());
    if (end.around && is_simplex_around<BoundedNumber>(*end.around))
      return met(point_of<BoundedNumber>(b_, joined(*end.around, false)));
    improve_lower<BoundedNumber>(end.direction);
    return false;
  }

  /// A point of A lies within B, which need not be a quadric.
  bool is_point_within_b(const BoundedVector& point) const {
    const QuadricBody alone(point);
    QuadricSearch search(alone, b_, plain(point) - plain(b_.middle_point()));
    search.run(0);
    const QuadricSearch::Simplex simplex = search.simplex();
    if (simplex.size() < 4) return false;
    std::array<BoundedVector, 4> difference_at;
    for (std::size_t i = 0; i < 4; ++i)
      difference_at[i] = point - point_of<BoundedNumber>(b_, body_point(simplex.corner[i].b));
    return is_origin_within(difference_at);
  }

  static BoundedVector towards(const BoundedVector& from, const BoundedVector& to, double part) {
    return from + exactly(part) * (to - from);
  }

  template <class Number>
  [[nodiscard]] bool is_simplex_around(std::span<const QuadricSearch::Corner> corner) const {
    if (corner.size() < 4) return false;
    std::array<VectorOf<Number>, 4> point;
    for (std::size_t i = 0; i < 4; ++i)
      point[i] =
          difference(point_of<Number>(a_, body_point(corner[i].a)), point_of<Number>(b_, body_point(corner[i].b)));
    return is_origin_within(point);
  }

  /// Where the shapes overlap a little, their deepest points lie within each other.
  bool is_shallow_meeting() {
    if (!(refinement_.signed_distance() < 0)) return false;
    const BoundedVector x = point_of<BoundedNumber>(a_, refinement_.on_a()),
                        y = point_of<BoundedNumber>(b_, refinement_.on_b());
    return is_common(x, y);
  }

  /// Points of A and of B; is one of them, or that of B which the other side offers, in both?
  bool is_common(const BoundedVector& of_a, const BoundedVector& of_b) {
    if (is_within(a_, of_b)) return met(of_b);
    if (b_.quadric_kind()) return is_within(b_, of_a) && met(of_a);
    return b_.generator_count() >= 4 && is_point_within_b(of_a) && met(of_a);
  }

  bool met(const BoundedVector& point) {
    best_.contact = QuadricContact::contact;
    best_.lower = best_.upper = 0;
    best_.on_a = best_.on_b = plain(point);
    best_.narrow = true;
    return true;
  }

  const QuadricBody& a_;
  const QuadricBody& b_;
  QuadricSearch search_;
  NewtonRefinement refinement_;
  QuadricNearest best_;
};

}  // namespace

namespace {

/// Where the search leaves open whether they meet, and they are close, `decide(found)` comes before all that takes
/// long; true: that is the answer.
template <class Decide>
QuadricNearest searched(const QuadricBody& a, const QuadricBody& b, QuadricQuestion question,
                        const FastRefinement* guess, const Decide& decide) {
  QuadricNearestSearch search(a, b);
  if (guess != nullptr && search.proves(*guess)) return search.best();
  // From anew, so that both questions are told the same.
  if (question == QuadricQuestion::meeting)
    return search.proves_apart() ? search.best() : searched(a, b, QuadricQuestion::distance, nullptr, decide);
  if (search.is_decided()) return search.best();
  QuadricNearest found = search.best();
  if (found.contact == QuadricContact::undecided && found.upper < close && decide(found)) return found;
  search.decide_at_length();
  return search.best();
}

void take_meeting_at(QuadricNearest& found, const Vec3& point) {
  found.contact = QuadricContact::contact;
  found.lower = found.upper = 0;
  found.on_a = found.on_b = point;
  found.narrow = true;
}

template <class B>
void decide_by_middle(QuadricNearest& found, const PosedQuadric& a, const QuadricBody& body_a, const B& b) {
  if (found.contact == QuadricContact::undecided && is_middle_in(a, b))
    take_meeting_at(found, plain(body_a.middle_point()));
}

template <class B>
void decide_by_common_point(QuadricNearest& found, const PosedQuadric& a, const B& b) {
  if (found.contact != QuadricContact::undecided) return;
  const PairFrame frame = pair_frame(a, b);
  const std::optional<Vec3> point = common_point(a, b, found, frame);
  if (!point) return;
  found.shared = SharedPoint{*point, separating_normal(a, b, *point).value_or(Vec3{})};
  take_meeting_at(found, frame.plainly_placed(*point));
}

/// Each half axis lies along one of the world's.
bool is_along_axes(const PosedQuadric& shape) {
  const Mat3& m = shape.pose().linear;
  for (int i = 0; i < 3; ++i)
    if ((m[i].x != 0) + (m[i].y != 0) + (m[i].z != 0) != 1) return false;
  return true;
}

/// Only that they touch is told before it is known that they do not overlap: along the axes, where it is usual; where
/// shapes are turned, points that are in both as far as doubles tell are mostly in neither.
template <class B>
QuadricNearest searched_with_touching(const PosedQuadric& a, const QuadricBody& body_a, const B& b,
                                      const QuadricBody& body_b, QuadricQuestion question,
                                      const FastRefinement* guess) {
  return searched(body_a, body_b, question, guess, [&](QuadricNearest& found) {
    if (!is_along_axes(a)) return false;
    decide_by_common_point(found, a, b);
    return is_touching(found);
  });
}

}  // namespace

QuadricNearest nearest_of(const QuadricBody& a, const QuadricBody& b, QuadricQuestion question,
                          const FastRefinement* guess) {
  return searched(a, b, question, guess, [](const QuadricNearest&) { return false; });
}

QuadricNearest nearest_of(const PosedQuadric& a, const QuadricBody& body_a, const PosedQuadric& b,
                          const QuadricBody& body_b, QuadricQuestion question, const FastRefinement* guess) {
  QuadricNearest found = searched_with_touching(a, body_a, b, body_b, question, guess);
  decide_by_middle(found, a, body_a, b);
  decide_by_middle(found, b, body_b, a);
  decide_by_common_point(found, a, b);
  return found;
}

QuadricNearest nearest_of(const PosedQuadric& a, const QuadricBody& body_a, const PosedPolytope& b,
                          const QuadricBody& body_b, QuadricQuestion question, const FastRefinement* guess) {
  QuadricNearest found = searched_with_touching(a, body_a, b, body_b, question, guess);
  decide_by_middle(found, a, body_a, b);
  decide_by_common_point(found, a, b);
  return found;
}

}  // namespace toccata
