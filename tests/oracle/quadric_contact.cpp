#include "oracle/quadric_contact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace toccata::oracle {
namespace {

FinePoint plus(const FinePoint& a, const FinePoint& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
FinePoint minus(const FinePoint& a, const FinePoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
FinePoint times(const Fine& s, const FinePoint& a) { return {s * a.x, s * a.y, s * a.z}; }
Fine inner(const FinePoint& a, const FinePoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
FinePoint outer(const FinePoint& a, const FinePoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Fine length_of(const FinePoint& a) { return sqrt(inner(a, a)); }

/// In units of the half axes.
FinePoint local(const FineSet& set, const FinePoint& direction) {
  const auto& [x, y, z] = set.axis;
  const Fine volume = inner(outer(x, y), z);
  return {inner(outer(y, z), direction) / volume, inner(outer(z, x), direction) / volume,
          inner(outer(x, y), direction) / volume};
}

/// A point of the shape in units of its half axes; the same one where that is one.
FinePoint brought_in(FineKind kind, FinePoint p) {
  if (kind == FineKind::ellipsoid) {
    const Fine radius = length_of(p);
    return radius > 1 ? times(1 / radius, p) : p;
  }
  p.z = p.z > 1 ? Fine(1) : p.z < -1 ? Fine(-1) : p.z;
  const Fine most = kind == FineKind::cone ? Fine((1 - p.z) / 2) : Fine(1), radius = sqrt(p.x * p.x + p.y * p.y);
  if (radius <= most) return p;
  return {p.x * (most / radius), p.y * (most / radius), p.z};
}

struct Chord {
  double from;
  double to;
};

std::optional<Chord> cut(const std::optional<Chord>& a, const std::optional<Chord>& b) {
  if (!a || !b || !(std::max(a->from, b->from) <= std::min(a->to, b->to))) return {};
  return Chord{std::max(a->from, b->from), std::min(a->to, b->to)};
}

/// Where a t² + 2 b t + c ≤ 0, for a > 0.
std::optional<Chord> between_roots(double a, double b, double c) {
  const double squared = b * b - a * c;
  if (squared < 0) return {};
  return Chord{(-b - std::sqrt(squared)) / a, (-b + std::sqrt(squared)) / a};
}

/// Where at + rate · t ≥ 0.
std::optional<Chord> not_negative(double at, double rate) {
  if (rate == 0) return at >= 0 ? std::optional(Chord{-1e300, 1e300}) : std::nullopt;
  return rate > 0 ? Chord{-at / rate, 1e300} : Chord{-1e300, -at / rate};
}

Vec3 rounded_to_double(const FinePoint& p) {
  return {p.x.convert_to<double>(), p.y.convert_to<double>(), p.z.convert_to<double>()};
}

/// By its convex sections: the cone one with its tip upwards.
std::optional<Chord> chord_of_unit(FineKind kind, const Vec3& p, const Vec3& d) {
  if (kind == FineKind::ellipsoid) return between_roots(dot(d, d), dot(p, d), dot(p, p) - 1);
  const std::optional<Chord> slab = cut(not_negative(1 - p.z, -d.z), not_negative(1 + p.z, d.z));
  if (!slab) return {};
  // Along the line |(x, y)| − radius is convex: its zeros are found by halving from its least value.
  const auto beyond = [&](double t) {
    const Vec3 q = p + t * d;
    return std::hypot(q.x, q.y) - (kind == FineKind::cone ? (1 - q.z) / 2 : 1);
  };
  double low = std::max(slab->from, -1e6), high = std::min(slab->to, 1e6);
  if (low > high) return {};
  double left = low, right = high;
  for (int i = 0; i < 200; ++i) {
    const double third = (right - left) / 3;
    if (beyond(left + third) < beyond(right - third))
      right -= third;
    else
      left += third;
  }
  if (beyond(left) > 1e-12) return {};
  const auto zero = [&](double inside, double outside) {
    if (beyond(outside) <= 0) return outside;
    for (int i = 0; i < 100; ++i) {
      const double middle = (inside + outside) / 2;
      (beyond(middle) <= 0 ? inside : outside) = middle;
    }
    return inside;
  };
  return Chord{zero(left, low), zero(left, high)};
}

/// The chord of a hull: every triangle of vertices lies in it, and its boundary is made of such.
std::optional<Chord> chord_of_hull(const std::vector<Vec3>& v, const Vec3& p, const Vec3& d) {
  std::optional<Chord> found;
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t j = i + 1; j < v.size(); ++j)
      for (std::size_t k = j + 1; k < v.size(); ++k) {
        const Vec3 e = v[j] - v[i], f = v[k] - v[i], w = p - v[i], normal = cross(e, f);
        const double across = dot(normal, d);
        if (std::fabs(across) < 1e-14) continue;
        const double t = -dot(normal, w) / across;
        const Vec3 q = w + t * d;
        const double s = dot(cross(q, f), normal) / dot(normal, normal),
                     r = dot(cross(e, q), normal) / dot(normal, normal);
        if (s < 0 || r < 0 || s + r > 1) continue;
        found = found ? Chord{std::min(found->from, t), std::max(found->to, t)} : Chord{t, t};
      }
  return found;
}

/// A set around an origin, in doubles.
class Lines {
 public:
  Lines(const FineSet& set, const FinePoint& origin, const FinePoint& along) : set_(set), origin_(origin) {
    along_ = rounded_to_double(along);
    for (const FinePoint& v : set.vertices) vertices_.push_back(rounded_to_double(minus(v, origin)));
    if (set.kind != FineKind::hull) local_along_ = rounded_to_double(local(set, along));
  }

  [[nodiscard]] std::optional<Chord> through(const Vec3& p) const {
    if (set_.kind == FineKind::hull) return chord_of_hull(vertices_, p, along_);
    const FinePoint at{Fine(p.x), Fine(p.y), Fine(p.z)};
    return chord_of_unit(set_.kind, rounded_to_double(local(set_, minus(plus(at, origin_), set_.centre))),
                         local_along_);
  }

 private:
  const FineSet& set_;
  FinePoint origin_;
  Vec3 along_;
  Vec3 local_along_;
  std::vector<Vec3> vertices_;
};

}  // namespace

Fine at_most_from(const FineSet& set, const FinePoint& point, const Fine& enough) {
  FineSet alone, core = set;
  alone.vertices = {point};
  core.radius = 0;
  // As finely as the slack of the radius's surface is looked at.
  const auto searched = [&] {
    const FineNearness near = fine_nearness(alone, core, set.radius > 0 ? 1e-20 : 1e-3, 300);
    return near.meet || near.upper <= set.radius ? Fine(0) : Fine(near.upper - set.radius);
  };
  if (set.kind == FineKind::hull) return searched();
  const FinePoint p = brought_in(set.kind, local(set, minus(point, set.centre)));
  const FinePoint within =
      plus(set.centre, plus(times(p.x, set.axis[0]), plus(times(p.y, set.axis[1]), times(p.z, set.axis[2]))));
  const Fine found = length_of(minus(point, within));
  return found <= enough ? found : std::min(found, searched());
}

Fine depth_along(const FineSet& a, const FineSet& b, const FinePoint& direction) {
  return inner(minus(farthest(a, direction), farthest(b, times(-1, direction))), direction) / length_of(direction);
}

ContactArea contact_area(const FineSet& a, const FineSet& b, const FinePoint& normal, double slack) {
  constexpr int cells = 48;
  const FinePoint aside = abs(normal.x) < Fine(0.6) ? FinePoint{1, 0, 0} : FinePoint{0, 1, 0};
  FinePoint x = outer(normal, aside);
  x = times(1 / length_of(x), x);
  const FinePoint y = outer(normal, x);
  const Lines of_a(a, a.centre, normal), of_b(b, a.centre, normal);
  const double deepest = depth_along(a, b, normal).convert_to<double>();
  const double low_x = inner(minus(farthest(a, times(-1, x)), a.centre), x).convert_to<double>(),
               high_x = inner(minus(farthest(a, x), a.centre), x).convert_to<double>(),
               low_y = inner(minus(farthest(a, times(-1, y)), a.centre), y).convert_to<double>(),
               high_y = inner(minus(farthest(a, y), a.centre), y).convert_to<double>();
  const Vec3 along_x = rounded_to_double(x), along_y = rounded_to_double(y);
  ContactArea result;
  result.cell = (high_x - low_x) / cells * ((high_y - low_y) / cells);
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const Vec3 p = (low_x + (i + 0.5) / cells * (high_x - low_x)) * along_x +
                     (low_y + (j + 0.5) / cells * (high_y - low_y)) * along_y;
      const std::optional<Chord> in_a = of_a.through(p), in_b = of_b.through(p);
      if (in_a && in_b && in_a->to - in_b->from >= deepest - slack) result.area += result.cell;
    }
  return result;
}

}  // namespace toccata::oracle
