#include "narrow/convex/core_separation.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "narrow/convex/expanding_polytope.hpp"

// Let D be the Minkowski difference and h(n) the greatest n · d over it, for a unit vector n. B moved by t n no longer
// overlaps A when t ≥ h(n); the depth is the least of all h(n), the distance from the origin to the boundary of D when
// it lies within.
//
// Every h(n) is an upper bound; that of a rounded n is computed to 2^-48 V (V is the extent of D): the support is
// farthest up to 2^-49 V, and the product off by 2^-50 V. The least distance of a facet of a convex polytope in D that
// has the origin behind all its facets is a lower bound. The search expands the facet with the least lower bound until
// both bounds meet to `relative_width_of_depth`. Where rounding hides whether anything lies beyond a facet, its plane
// is computed exactly; if nothing does, it is a facet of D, and both bounds are its distance.
//
// It ends: every step either makes a facet exact, of which there are finitely many, or adds a point of D that lies
// strictly outside of the polytope, which happens at most once for each pair of vertices.
namespace toccata {
namespace {

/// Roughly, for comparing.
double squared_size(const CoreVertices& core) {
  const Vec3 diagonal = 0x1p-512 * core.greatest() - 0x1p-512 * core.least();
  return dot(diagonal, diagonal);
}

class Search {
 public:
  Search(const PosedPolytope& a, const PosedPolytope& b, double reach)
      : body_(a, b), polytope_(body_), reach_(body_.scaled_length(reach)) {}

  CoreSeparation run();

 private:
  enum class Step { onwards, done, stuck };

  [[nodiscard]] Step step(Index f);
  [[nodiscard]] Step precise_step(Index f);
  [[nodiscard]] Step expand(Index f, const DifferencePoint& p) {
    return polytope_.add(p, f) ? Step::onwards : Step::stuck;
  }
  void offer(Index f, double upper);
  /// While the least lower bound is negative the origin may be outside of D, be the bounds ever so near.
  [[nodiscard]] bool is_narrow(Index f, double upper) const {
    const double lower = polytope_.facet(f).lower;
    return upper <= 0 || (lower >= 0 && upper - lower <= relative_width_of_depth * (upper + reach_));
  }
  [[nodiscard]] CoreSeparation answer(double lower, Status status) const;
  void find_points(CoreSeparation& separation) const;
  [[nodiscard]] Index facet_of_foot() const;

  DifferenceBody body_;
  ExpandingPolytope polytope_;
  double reach_;
  double upper_ = infinity;  ///< the least so far, scaled, and of which facet
  Vec3 direction_{};
  Index facet_ = 0;
};

void Search::offer(Index f, double upper) {
  upper_ = upper;
  direction_ = polytope_.unit_normal(f);
  facet_ = f;
  polytope_.set_upper(upper);
}

Search::Step Search::step(Index f) {
  const Vec3 n = polytope_.unit_normal(f);
  const DifferencePoint farthest = body_.support(n);
  const double upper = dot(n, farthest.value) + 0x1p-48 * body_.extent();
  const bool narrow = is_narrow(f, upper);
  if (narrow || upper < upper_) offer(f, upper);
  if (narrow) return Step::done;
  if (polytope_.height(f, farthest) > polytope_.facet(f).error) return expand(f, farthest);
  if (polytope_.facet(f).precise) return precise_step(f);
  polytope_.make_precise(f);
  return Step::onwards;
}

/// Rounding hides whether anything lies above the facet.
Search::Step Search::precise_step(Index f) {
  if (!polytope_.is_exact(f)) {
    if (polytope_.is_certainly_of_body(f) && is_narrow(f, polytope_.facet(f).upper)) {
      offer(f, polytope_.facet(f).upper);
      return Step::done;
    }
    // It may be farther away than it seemed, and another facet nearer.
    polytope_.make_exact(f);
    return Step::onwards;
  }
  const auto [farthest, height] = polytope_.exact_support(f);
  if (height == Sign::positive) return expand(f, farthest);
  offer(f, polytope_.facet(f).upper);
  return Step::done;
}

CoreSeparation Search::run() {
  if (!polytope_.start()) {
    CoreSeparation flat;
    flat.kind = CoreSeparation::Kind::flat;
    flat.direction = polytope_.flat_direction();
    return flat;
  }
  // Far more than any search takes, and less than a person would call a hang.
  const Index limit = 1000 + 4 * (body_.a().count() + body_.b().count());
  for (Index steps = 0; steps < limit; ++steps) {
    const Index f = polytope_.nearest();
    const Step outcome = step(f);
    if (outcome == Step::done) return answer(polytope_.facet(f).lower, Status::exact);
    if (outcome == Step::stuck) break;
  }
  return answer(polytope_.facet(polytope_.nearest()).lower, Status::not_converged);
}

/// Coplanar triangles of the polytope are one facet of D; the foot of the origin lies in one of them.
Index Search::facet_of_foot() const {
  Index f = facet_;
  for (int hops = 0; hops < 64; ++hops) {
    const auto weights = polytope_.weights_of_foot(f);
    const auto least = static_cast<std::size_t>(std::min_element(weights.begin(), weights.end()) - weights.begin());
    if (weights[least] >= 0) return f;
    const Index next = polytope_.facet(f).neighbour[(least + 1) % 3];
    if (!(dot(polytope_.unit_normal(next), direction_) >= 1 - 0x1p-30)) return f;
    f = next;
  }
  return f;
}

void Search::find_points(CoreSeparation& separation) const {
  const Index f = facet_of_foot();
  std::array<double, 3> weights = polytope_.weights_of_foot(f);
  double sum = 0;
  for (double& weight : weights) sum += weight = std::clamp(weight, 0.0, 1.0);
  separation.on_a = body_.a()[polytope_.corner(f, 0).on_a];
  separation.on_b = body_.b()[polytope_.corner(f, 0).on_b];
  const Vec3 a = separation.on_a, b = separation.on_b;
  for (std::size_t k = 0; k < 3; ++k)
    if (weights[k] > 0) separation.pairs.append(polytope_.corner(f, k).on_a, polytope_.corner(f, k).on_b);
  for (std::size_t k = 1; k < 3; ++k) {
    separation.on_a = separation.on_a + (weights[k] / sum) * (body_.a()[polytope_.corner(f, k).on_a] - a);
    separation.on_b = separation.on_b + (weights[k] / sum) * (body_.b()[polytope_.corner(f, k).on_b] - b);
  }
  // The smaller core's point is off by less, and leads to the other.
  const Vec3 way = body_.unscaled(upper_) * direction_;
  if (squared_size(body_.a()) <= squared_size(body_.b()))
    separation.on_b = separation.on_a - way;
  else
    separation.on_a = separation.on_b + way;
}

CoreSeparation Search::answer(double lower, Status status) const {
  CoreSeparation separation;
  separation.status = status;
  separation.direction = direction_;
  find_points(separation);
  if (upper_ <= 0) return separation;
  separation.kind = CoreSeparation::Kind::deep;
  separation.upper = body_.upper_in_world(upper_);
  separation.lower = lower > 0 ? body_.lower_in_world(lower) : 0.0;
  return separation;
}

}  // namespace

CoreSeparation part_cores_exactly(const PosedPolytope& a, const PosedPolytope& b, double reach) {
  return Search(a, b, reach).run();
}

CoreSeparation part_cores_by_expansion(const PosedPolytope& a, const PosedPolytope& b, double reach, double width) {
  if (const std::optional<CoreSeparation> found = part_cores_fast(a, b, reach, width)) return *found;
  return part_cores_exactly(a, b, reach);
}

}  // namespace toccata
