#include "narrow/smooth/contact/smooth_parting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "math/vec3_measures.hpp"
#include "toccata/math/trigonometry.hpp"

namespace toccata {
namespace {

/// How far apart the bodies are brought in turn, so that they have nearest points; the pair is of size 1. From farther
/// out a step turns the normal more, from nearer the points are told more finely.
constexpr std::array<double, 4> gaps_between{0x1p-2, 0x1p-6, 0x1p-12, 0x1p-20};

/// The nearest points lie across from each other, but for this.
constexpr double rounding_across = 0x1p-44;

/// A direction that is no worse, but for this, is another one.
constexpr double rounding_along = 0x1p-46;

/// From one gap.
constexpr int most_steps = 12;

/// As far as it is told along a direction that is a double's.
double depth_along(const SmoothBody& a, const SmoothBody& b, const Vec3& normal) {
  return -gap_along<BoundedNumber>(a, b, fine(-normal));
}

/// The bodies moved apart along the normal, and no farther than by the gap.
SmoothNearest nearest_when_parted(const SmoothBody& a, const SmoothBody& b, const Vec3& way) {
  return nearest_of(a.moved(exactly(-way)), b, SmoothQuestion::distance);
}

/// Of bodies that hardly meet, the direction along which they overlap the least, or nearly so: A − B has a surface at
/// the origin, and no inside from which to look for it.
class TouchingPair {
 public:
  TouchingPair(const SmoothBody& a, const SmoothBody& b) : a_(a), b_(b), polish_(a, b) {}

  /// The cheap guesses come first: where one shows that they no more than touch, none is better.
  SmoothParting least() {
    along_axes([&](const Vec3& d) { take(d); });
    if (is_touching()) return best_;
    SmoothSearch search(a_, b_, plain(a_.middle_point()) - plain(b_.middle_point()));
    search.run(0);
    polish(-search.best_direction());
    if (is_touching()) return best_;
    along_axes([&](const Vec3& d) { polish(d); });
    polish_best_of_spiral();
    return best_;
  }

 private:
  [[nodiscard]] bool is_touching() const { return best_.depth <= rounding_along; }

  /// Those of the smooth shapes, and against them.
  template <class Visit>
  void along_axes(const Visit& visit) const {
    for (const SmoothBody* body : {&a_, &b_})
      if (body->smooth_kind())
        for (const BoundedVector& axis : body->axes())
          for (const double sign : {1.0, -1.0}) visit(unit_or_zero(sign * plain(axis)));
  }

  /// From a direction and from where Newton's method leads from there.
  void polish(const Vec3& direction) {
    const Vec3 d = unit_or_zero(direction);
    if (d == Vec3{}) return;
    take(d);
    const std::array<SmoothSearch::Corner, 1> corner{SmoothSearch::Corner{a_.support(d), b_.support(-d), 1}};
    polish_.begin(corner, -d, SmoothPolish::Attempt::first);
    if (!polish_.settle()) return;
    const FineDirection& found = polish_.direction();
    take(-unit_or_zero({found[0].high, found[1].high, found[2].high}));
  }

  void take(const Vec3& d) {
    if (d == Vec3{}) return;
    const double depth = depth_along(a_, b_, d);
    if (depth < best_.depth) best_ = {d, depth, a_.support(d).point, b_.support(-d).point};
  }

  /// From the best of directions all over the sphere, on a spiral of the golden angle.
  void polish_best_of_spiral() {
    constexpr int count = 128;
    std::array<std::pair<double, Vec3>, count> found;
    for (int i = 0; i < count; ++i) {
      const double z = 1 - (2 * i + 1.0) / count, across = std::sqrt(1 - z * z);
      const SineCosine turn = sine_cosine_of_turns(0.3819660112501051 * i);
      const Vec3 d{across * turn.cosine, across * turn.sine, z};
      found[static_cast<std::size_t>(i)] = {dot(d, a_.support(d).point - b_.support(-d).point), d};
    }
    constexpr std::size_t tried = 6;
    std::partial_sort(found.begin(), found.begin() + tried, found.end(),
                      [](const auto& f, const auto& g) { return f.first < g.first; });
    for (std::size_t i = 0; i < tried; ++i) polish(found[i].second);
  }

  const SmoothBody& a_;
  const SmoothBody& b_;
  SmoothPolish polish_;
  SmoothParting best_{{}, HUGE_VAL, {}, {}};
};

SmoothParting first_parting(const SmoothBody& a, const SmoothBody& b, const SmoothNearest& met) {
  if (met.contact != SmoothContact::contact) return TouchingPair(a, b).least();
  const Penetration least = least_depth(a, b);
  return {least.direction, least.upper, least.on_a, least.on_b};
}

enum class Step : std::uint8_t { none, another, last };

Step take_step(SmoothParting& parting, const SmoothBody& a, const SmoothBody& b, double gap) {
  const Vec3 way = (parting.depth + gap) * parting.normal;
  const SmoothNearest near = nearest_when_parted(a, b, way);
  if (near.contact != SmoothContact::apart) return Step::none;
  parting.on_a = near.on_a + way;
  parting.on_b = near.on_b;
  const Vec3 between = near.on_b - near.on_a;
  if (plain_length(between - dot(between, parting.normal) * parting.normal) <= rounding_across) return Step::last;
  const Vec3 normal = -unit_or_zero({near.direction[0].high, near.direction[1].high, near.direction[2].high});
  const double depth = depth_along(a, b, normal);
  if (!(depth < parting.depth + rounding_along)) return Step::none;
  parting.normal = normal;
  parting.depth = depth;
  return Step::another;
}

}  // namespace

// All of A − B, moved so that it lies a gap before the origin, is no nearer to it than its nearest point w: along the
// direction of w they are parted no later. So each step shortens the way, until w lies along the normal.
SmoothParting parting_of(const SmoothBody& a, const SmoothBody& b, const SmoothNearest& met) {
  SmoothParting parting = first_parting(a, b, met);
  for (const double gap : gaps_between)
    for (int step = 0; step < most_steps; ++step)
      if (const Step taken = take_step(parting, a, b, gap); taken == Step::none)
        break;
      else if (taken == Step::last)
        return parting;
  return parting;
}

}  // namespace toccata
