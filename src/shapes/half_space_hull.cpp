#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <span>
#include <vector>

#include "core/no_index.hpp"
#include "math/exact.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/shapes/convex_hull.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {
namespace {

/// A half-space n · p ≤ d is stored as (n, −d); a point p, or a direction, as (w p, w) with w > 0, or w = 0. A point is
/// in the half-space when their product is not positive.
using WholeVector4 = std::array<Integer, 4>;

Integer whole_product(const WholeVector4& a, const WholeVector4& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// The same direction in doubles, of which the greatest is 1 or -1: each is off by 2^-54 at most.
using Direction4 = std::array<double, 4>;

Direction4 rounded_direction(const WholeVector4& v) {
  Integer greatest = 0;
  for (const Integer& number : v) greatest = std::max(greatest, Integer(abs(number)));
  Direction4 rounded{};
  if (greatest == 0) return rounded;
  for (std::size_t i = 0; i < 4; ++i) rounded[i] = nearest_double(v[i], greatest, 0);
  return rounded;
}

/// The product of two such directions is off by less: eight factors by 2^-54 each, and by the roundings of four
/// products and three sums, none greater than 4, which are 16 · 2^-53 at most.
constexpr double sign_error_of_height = 0x1p-48;

/// The sign of the product where it is certain, else zero.
Sign certain_height_sign(const Direction4& a, const Direction4& b) {
  const double height = (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
  return height > sign_error_of_height ? Sign::positive : height < -sign_error_of_height ? Sign::negative : Sign::zero;
}

/// The same direction in the least whole numbers.
WholeVector4 in_lowest_terms(WholeVector4 v) {
  Integer common = 0;
  for (const Integer& number : v) common = gcd(common, number);
  if (common > 1)
    for (Integer& number : v) number /= common;
  return v;
}

WholeVector4 homogeneous_plane(const HalfSpace& half_space) {
  const RationalPoint normal = to_rational(half_space.normal());
  const std::array<Rational, 4> numbers{normal.x, normal.y, normal.z, -dot(normal, to_rational(half_space.point()))};
  Integer unit = 1;  // all denominators are powers of two
  for (const Rational& number : numbers) unit = std::max(unit, denominator(number));
  WholeVector4 plane;
  for (std::size_t i = 0; i < 4; ++i) plane[i] = numerator(numbers[i]) * (unit / denominator(numbers[i]));
  return in_lowest_terms(plane);
}

/// What has a product of 0 with all three, in either direction; 0 when they depend on each other.
WholeVector4 across_three(const WholeVector4& a, const WholeVector4& b, const WholeVector4& c) {
  const auto minor = [&](std::size_t i, std::size_t j, std::size_t k) -> Integer {
    return a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) + a[k] * (b[i] * c[j] - b[j] * c[i]);
  };
  return {minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
}

const WholeVector4 behind_infinity{0, 0, 0, -1};

bool is_null_vector(const WholeVector4& v) {
  return std::all_of(v.begin(), v.end(), [](const Integer& number) { return number == 0; });
}

/// Comparisons of rays with planes and with each other: how many a question may take in all, and how far it is.
struct Comparisons {
  std::uint64_t most;
  std::size_t given;  ///< half-spaces, those that are equal counted once
  std::uint64_t taken = 0;
  std::size_t cut = 0;  ///< so many of them, since the last beginning
};

struct TooManyComparisons : Error {
  using Error::Error;
};

/// What half-spaces have in common, as the extreme rays of a cone in four dimensions: the double description method (T.
/// S. Motzkin, H. Raiffa, G. L. Thompson, R. M. Thrall, 1953; K. Fukuda, A. Prodon, "Double description method
/// revisited", 1996). Every vertex is a ray with w > 0; one with w = 0 is a direction without end.
class HalfSpaceCone {
 public:
  struct Ray {
    WholeVector4 at;
    Direction4 rounded{};
    std::vector<Index> planes;  ///< those it lies in, in their order
  };

  /// The cone of three half-spaces with independent normals.
  HalfSpaceCone(const std::array<WholeVector4, 3>& first, Comparisons& comparisons) : comparisons_(comparisons) {
    const std::array<WholeVector4, 4> planes{behind_infinity, first[0], first[1], first[2]};
    for (std::size_t i = 0; i < 4; ++i) {
      Ray ray{in_lowest_terms(across_three(planes[(i + 1) % 4], planes[(i + 2) % 4], planes[(i + 3) % 4])), {}, {}};
      if (whole_product(planes[i], ray.at) > 0)
        for (Integer& number : ray.at) number = -number;
      for (Index j = 0; j < 4; ++j)
        if (j != i) ray.planes.push_back(j);
      ray.rounded = rounded_direction(ray.at);
      rays_.push_back(std::move(ray));
    }
  }

  [[nodiscard]] const std::vector<Ray>& rays() const { return rays_; }
  [[nodiscard]] bool has_a_point() const {
    return std::any_of(rays_.begin(), rays_.end(), [](const Ray& ray) { return ray.at[3] > 0; });
  }
  /// Whether all of it lies in the plane of the half-space that was given as the i-th, from 0.
  [[nodiscard]] bool lies_in_plane(std::size_t i) const {
    const auto is_in = [&](const Ray& ray) {
      return std::binary_search(ray.planes.begin(), ray.planes.end(), static_cast<Index>(i + 1));
    };
    return std::all_of(rays_.begin(), rays_.end(), is_in);
  }

  /// Throws TooManyComparisons.
  void cut(const WholeVector4& plane) {
    const Index number = plane_count_++;
    const Direction4 rounded = rounded_direction(plane);
    std::vector<Sign> sides;
    std::vector<std::size_t> inside;
    for (Ray& ray : rays_) {
      Sign side = certain_height_sign(rounded, ray.rounded);
      if (side == Sign::zero) side = sign_of(whole_product(plane, ray.at));
      if (side == Sign::negative) inside.push_back(sides.size());
      if (side == Sign::zero) ray.planes.push_back(number);
      sides.push_back(side);
    }
    count_comparisons(rays_.size());
    std::vector<Ray> edges;
    for (std::size_t i = 0; i < rays_.size(); ++i)
      if (sides[i] == Sign::positive) append_edges_through({plane, number}, i, inside, edges);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < rays_.size(); ++i)
      if (sides[i] != Sign::positive && kept++ != i) rays_[kept - 1] = std::move(rays_[i]);
    rays_.resize(kept);
    std::move(edges.begin(), edges.end(), std::back_inserter(rays_));
  }

 private:
  struct NumberedPlane {
    const WholeVector4& plane;
    Index number = 0;
  };

  void append_edges_through(const NumberedPlane& cut, std::size_t outside, std::span<const std::size_t> inside,
                            std::vector<Ray>& edges) {
    count_comparisons(inside.size());
    for (const std::size_t j : inside) {
      take_shared_planes(rays_[outside], rays_[j]);
      if (shared_.size() < 2 || !are_neighbours(outside, j)) continue;
      edges.push_back(between(rays_[outside], rays_[j], cut.plane));
      edges.back().planes = shared_;
      edges.back().planes.push_back(cut.number);
    }
  }

  void take_shared_planes(const Ray& a, const Ray& b) {
    shared_.clear();
    std::set_intersection(a.planes.begin(), a.planes.end(), b.planes.begin(), b.planes.end(),
                          std::back_inserter(shared_));
  }

  /// Two are when no third ray lies in all planes that both lie in.
  [[nodiscard]] bool are_neighbours(std::size_t a, std::size_t b) {
    count_comparisons(rays_.size());
    for (std::size_t third = 0; third < rays_.size(); ++third) {
      const std::vector<Index>& planes = rays_[third].planes;
      if (third != a && third != b && std::includes(planes.begin(), planes.end(), shared_.begin(), shared_.end()))
        return false;
    }
    return true;
  }

  /// Where the edge between a ray outside and one inside goes through the plane that is cut along.
  [[nodiscard]] static Ray between(const Ray& outside, const Ray& inside, const WholeVector4& plane) {
    const Integer above = whole_product(plane, outside.at), below = whole_product(plane, inside.at);
    Ray ray;
    for (std::size_t i = 0; i < 4; ++i) ray.at[i] = above * inside.at[i] - below * outside.at[i];
    ray.at = in_lowest_terms(ray.at);
    ray.rounded = rounded_direction(ray.at);
    return ray;
  }

  void count_comparisons(std::size_t more) {
    comparisons_.taken += more;
    if (comparisons_.taken <= comparisons_.most) return;
    const auto vertices = std::count_if(rays_.begin(), rays_.end(), [](const Ray& ray) { return ray.at[3] > 0; });
    throw TooManyComparisons(fmt::format(
        "{} of the {} half-spaces, taken in a mixed order, have {} vertices in common, and it would take more than {} "
        "comparisons to find those of all; leave out some that cut little off, or allow more",
        comparisons_.cut, comparisons_.given, vertices, comparisons_.most));
  }

  Index plane_count_ = 4;
  std::vector<Ray> rays_;
  std::vector<Index> shared_;  ///< planes of the two rays that are compared
  Comparisons& comparisons_;
};

/// Three half-spaces with independent normals. Where the given ones have none, all that they hold in common goes on
/// without end in the directions that are `free`; half-spaces across these take the places.
struct FirstThree {
  std::array<WholeVector4, 3> planes;
  std::vector<Index> numbers;  ///< of those that are given
  std::vector<WholeVector4> free{};
};

FirstThree first_three(std::span<const WholeVector4> planes, std::span<const Index> order) {
  FirstThree first;
  first.planes[0] = planes[order[0]];
  first.numbers = {order[0]};
  const auto next = [&](std::size_t place, const auto& is_new, const WholeVector4& otherwise) {
    const auto found = std::find_if(order.begin(), order.end(), [&](Index i) { return is_new(planes[i]); });
    first.planes[place] = found == order.end() ? otherwise : planes[*found];
    if (found == order.end())
      first.free.push_back(otherwise);
    else
      first.numbers.push_back(*found);
  };
  const WholeVector4& p = first.planes[0];
  const auto across_both = [&](const WholeVector4& q) { return across_three(p, q, behind_infinity); };
  const WholeVector4 along_x = across_both({1, 0, 0, 0});
  next(
      1, [&](const WholeVector4& q) { return !is_null_vector(across_both(q)); },
      is_null_vector(along_x) ? across_both({0, 1, 0, 0}) : along_x);
  const WholeVector4 last = across_both(first.planes[1]);
  next(
      2, [&](const WholeVector4& r) { return whole_product(last, r) != 0; }, last);
  return first;
}

/// Half-spaces cut with each other in an order, until nothing is left or all were.
struct CommonSet {
  HalfSpaceCone cone;
  std::vector<Index> numbers;  ///< of the cone's half-spaces; `no_index` for those across a free direction
  std::vector<WholeVector4> free;
};

/// Throws TooManyComparisons.
CommonSet common_set(std::span<const WholeVector4> planes, std::span<const Index> order, Comparisons& comparisons) {
  FirstThree first = first_three(planes, order);
  comparisons.cut = first.numbers.size();
  CommonSet common{HalfSpaceCone(first.planes, comparisons), first.numbers, first.free};
  common.numbers.resize(3, no_index);
  for (WholeVector4 opposite : first.free) {
    for (Integer& number : opposite) number = -number;
    common.cone.cut(opposite);
    common.numbers.push_back(no_index);
  }
  for (const Index i : order) {
    if (!common.cone.has_a_point()) break;
    if (std::find(first.numbers.begin(), first.numbers.end(), i) != first.numbers.end()) continue;
    common.cone.cut(planes[i]);
    common.numbers.push_back(i);
    ++comparisons.cut;
  }
  std::erase(common.numbers, no_index);
  return common;
}

/// Chooses, among half-spaces without a common point, at most four that have none, of which none can be left out (E.
/// Helly, 1923). They are given as they were cut until nothing was left. The last that is cut belongs to every such
/// choice among those before it. It goes first in the next round, whose last is another, until those in front are all
/// that there are.
std::vector<Index> least_without_point(std::span<const WholeVector4> planes, std::vector<Index> among,
                                       Comparisons& comparisons) {
  for (int round = 0; round < 6; ++round) {
    if (round > 0) among = common_set(planes, among, comparisons).numbers;
    std::rotate(among.begin(), among.end() - 1, among.end());
  }
  for (std::size_t i = 0; i < among.size() && among.size() > 1;) {
    std::vector<Index> fewer = among;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (common_set(planes, fewer, comparisons).cone.has_a_point())
      ++i;
    else
      among = std::move(fewer);
  }
  std::sort(among.begin(), among.end());
  return among;
}

[[noreturn]] void refuse_empty(std::span<const WholeVector4> planes, const std::vector<Index>& among,
                               Comparisons& comparisons) {
  std::vector<Index> least;
  try {
    least = least_without_point(planes, among, comparisons);
  } catch (const TooManyComparisons&) {
    throw Error(
        fmt::format("the half-spaces have no point in common, and it would take more than {} comparisons to tell a few "
                    "of them that have none; move or turn one of them, or allow more",
                    comparisons.most));
  }
  throw Error(fmt::format("half-spaces {} have no point in common; move or turn one of them", fmt::join(least, ", ")));
}

Vec3 direction_in_doubles(const WholeVector4& direction) {
  const Integer greatest =
      std::max({Integer(abs(direction[0])), Integer(abs(direction[1])), Integer(abs(direction[2]))});
  const auto number = [&](std::size_t i) { return nearest_double(direction[i], greatest, 0); };
  return {number(0), number(1), number(2)};
}

[[noreturn]] void refuse_unbounded(const WholeVector4& direction) {
  const Vec3 d = direction_in_doubles(direction);
  throw Error(
      fmt::format("what the half-spaces have in common goes on without end in the direction ({}, {}, {}); add one "
                  "whose normal points there",
                  d.x, d.y, d.z));
}

void refuse_flat(const CommonSet& common) {
  std::vector<Index> flat;
  for (std::size_t i = 0; i < common.numbers.size(); ++i)
    if (common.cone.lies_in_plane(i)) flat.push_back(common.numbers[i]);
  if (flat.empty()) return;
  std::sort(flat.begin(), flat.end());
  throw Error(
      fmt::format("all that the half-spaces have in common lies in the planes of half-spaces {}: it is flat, and "
                  "no solid; move one of them",
                  fmt::join(flat, ", ")));
}

/// In an order that depends on nothing but them.
std::vector<Vec3> vertices_of_cone(const HalfSpaceCone& cone) {
  std::vector<Vec3> vertices;
  for (const HalfSpaceCone::Ray& ray : cone.rays()) {
    const auto number = [&](std::size_t i) { return nearest_double(ray.at[i], ray.at[3], 0); };
    const Vec3 vertex{number(0), number(1), number(2)};
    if (!is_finite(vertex))
      throw Error("a vertex of the half-spaces lies farther away than any double; choose a larger unit of length");
    vertices.push_back(vertex);
  }
  std::sort(vertices.begin(), vertices.end(), [](const Vec3& a, const Vec3& b) {
    return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
  });
  return vertices;
}

/// The numbers of the planes, of equal ones the first alone, in a mixed order: one after the other along a shape, as
/// they are often given, each would cut away much of what those before it made.
std::vector<Index> mixed_order(std::span<const WholeVector4> planes) {
  std::vector<Index> order(planes.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return planes[a] < planes[b]; });
  const auto is_equal = [&](Index a, Index b) { return planes[a] == planes[b]; };
  order.erase(std::unique(order.begin(), order.end(), is_equal), order.end());
  std::sort(order.begin(), order.end());
  Random random(1);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

}  // namespace

ConvexHull hull_of_half_spaces(std::span<const HalfSpace> half_spaces, std::uint64_t most_comparisons) {
  if (half_spaces.size() < 4)
    throw Error(fmt::format("{} half-spaces enclose nothing; give at least four", half_spaces.size()));
  std::vector<WholeVector4> planes;
  for (const HalfSpace& half_space : half_spaces) planes.push_back(homogeneous_plane(half_space));
  const std::vector<Index> order = mixed_order(planes);
  Comparisons comparisons{most_comparisons, order.size()};
  const CommonSet common = common_set(planes, order, comparisons);
  if (!common.cone.has_a_point()) refuse_empty(planes, common.numbers, comparisons);
  if (!common.free.empty()) refuse_unbounded(common.free.front());
  for (const HalfSpaceCone::Ray& ray : common.cone.rays())
    if (ray.at[3] == 0) refuse_unbounded(ray.at);
  refuse_flat(common);
  ConvexHull hull(vertices_of_cone(common.cone));
  if (hull.dimension() < 3)
    throw Error(
        "what the half-spaces have in common is thinner than doubles tell apart there; choose an origin nearby");
  return hull;
}

}  // namespace toccata
