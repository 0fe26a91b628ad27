#include "oracle/subdivision.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace toccata::oracle {
namespace {

using Ends = std::pair<Index, Index>;

Ends ends_of(Index a, Index b) { return a < b ? Ends{a, b} : Ends{b, a}; }

Rational fraction(int numerator, int denominator) { return Rational(Integer(numerator), Integer(denominator)); }

Rational later(const Rational& sharpness) {
  if (sharpness >= Rational(10)) return sharpness;
  return sharpness > Rational(1) ? sharpness - Rational(1) : Rational(0);
}

RationalPoint mean(const std::vector<RationalPoint>& points) {
  RationalPoint sum;
  for (const RationalPoint& p : points) sum = sum + p;
  return fraction(1, static_cast<int>(points.size())) * sum;
}

RationalPoint middle_of(const RationalCage& cage, const std::vector<Index>& face) {
  std::vector<RationalPoint> points;
  for (const Index corner : face) points.push_back(cage.points[corner]);
  return mean(points);
}

bool has(const std::vector<Index>& face, Index vertex) {
  return std::find(face.begin(), face.end(), vertex) != face.end();
}

bool has_edge(const std::vector<Index>& face, Index a, Index b) {
  for (std::size_t i = 0; i < face.size(); ++i)
    if (ends_of(face[i], face[(i + 1) % face.size()]) == ends_of(a, b)) return true;
  return false;
}

std::set<Index> neighbours_of(const RationalCage& cage, Index v) {
  std::set<Index> found;
  for (const std::vector<Index>& face : cage.faces)
    for (const Index other : face)
      if (other != v && has_edge(face, v, other)) found.insert(other);
  return found;
}

Rational sharpness_of(const RationalCage& cage, Index a, Index b) {
  const auto found = cage.creases.find(ends_of(a, b));
  return found == cage.creases.end() ? Rational(0) : found->second;
}

RationalPoint edge_point(const RationalCage& cage, Index a, Index b) {
  RationalPoint sharp = mean({cage.points[a], cage.points[b]});
  const Rational sharpness = std::min(sharpness_of(cage, a, b), Rational(1));
  if (sharpness == Rational(1)) return sharp;
  RationalPoint smooth;
  std::vector<RationalPoint> around{cage.points[a], cage.points[b]};
  if (cage.is_loop) smooth = fraction(3, 8) * (cage.points[a] + cage.points[b]);
  for (const std::vector<Index>& face : cage.faces) {
    if (!has_edge(face, a, b)) continue;
    around.push_back(middle_of(cage, face));
    for (const Index c : face)
      if (cage.is_loop && c != a && c != b) smooth = smooth + fraction(1, 8) * cage.points[c];
  }
  if (!cage.is_loop) smooth = mean(around);
  return (Rational(1) - sharpness) * smooth + sharpness * sharp;
}

Rational loop_share(std::size_t valence) {
  const long double turn = std::cos(2 * std::acos(-1.0L) / static_cast<long double>(valence));
  const double high = static_cast<double>(turn);
  Rational cosine = Rational(high) + Rational(static_cast<double>(turn - high));
  if (valence == 3) cosine = fraction(-1, 2);
  if (valence == 4) cosine = Rational(0);
  if (valence == 6) cosine = fraction(1, 2);
  const Rational root = fraction(3, 8) + fraction(1, 4) * cosine;
  return (fraction(5, 8) - root * root) * fraction(1, static_cast<int>(valence));
}

RationalPoint smooth_point(const RationalCage& cage, Index v) {
  const std::set<Index> neighbours = neighbours_of(cage, v);
  const auto n = static_cast<int>(neighbours.size());
  RationalPoint ends;
  for (const Index other : neighbours) ends = ends + cage.points[other];
  if (cage.is_loop) {
    const Rational share = loop_share(neighbours.size());
    return (Rational(1) - Rational(n) * share) * cage.points[v] + share * ends;
  }
  RationalPoint middles;
  for (const std::vector<Index>& face : cage.faces)
    if (has(face, v)) middles = middles + middle_of(cage, face);
  return fraction(n - 2, n) * cage.points[v] + fraction(1, n * n) * (ends + middles);
}

/// As with the sharpnesses that `at` tells; which rule it is: 0 smooth, 2 crease, 3 corner.
template <class SharpnessAt>
std::pair<int, RationalPoint> point_by_sharpness(const RationalCage& cage, Index v, const Rational& corner,
                                                 const SharpnessAt& at) {
  std::vector<Index> sharp;
  for (const Index other : neighbours_of(cage, v))
    if (at(other) > Rational(0)) sharp.push_back(other);
  if (corner > Rational(0) || sharp.size() > 2) return {3, cage.points[v]};
  if (sharp.size() < 2) return {0, smooth_point(cage, v)};
  return {2, fraction(3, 4) * cage.points[v] + fraction(1, 8) * (cage.points[sharp[0]] + cage.points[sharp[1]])};
}

RationalPoint vertex_point(const RationalCage& cage, Index v) {
  const Rational& corner = cage.corners[v];
  const auto now = point_by_sharpness(cage, v, corner, [&](Index other) { return sharpness_of(cage, v, other); });
  const auto then =
      point_by_sharpness(cage, v, later(corner), [&](Index other) { return later(sharpness_of(cage, v, other)); });
  if (now.first == 0 || now.first == then.first) return now.second;
  Rational sum;
  int ending = 0;
  const auto add = [&](const Rational& sharpness) {
    if (sharpness > Rational(0) && later(sharpness) == Rational(0)) {
      sum += sharpness;
      ++ending;
    }
  };
  add(corner);
  for (const Index other : neighbours_of(cage, v)) add(sharpness_of(cage, v, other));
  const Rational share = sum * fraction(1, ending);
  return share * now.second + (Rational(1) - share) * then.second;
}

}  // namespace

RationalCage refined(const RationalCage& cage) {
  RationalCage finer{cage.is_loop, {}, {}, {}, {}};
  for (Index v = 0; v < cage.points.size(); ++v) {
    finer.points.push_back(vertex_point(cage, v));
    finer.corners.push_back(later(cage.corners[v]));
  }
  std::map<Ends, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [found, is_new] = middles.try_emplace(ends_of(a, b), static_cast<Index>(finer.points.size()));
    if (is_new) {
      finer.points.push_back(edge_point(cage, a, b));
      const Rational sharpness = later(sharpness_of(cage, a, b));
      for (const Index end : {a, b})
        if (sharpness > Rational(0)) finer.creases[ends_of(end, found->second)] = sharpness;
    }
    return found->second;
  };
  for (const std::vector<Index>& face : cage.faces) {
    const auto face_middle = static_cast<Index>(finer.points.size());
    if (!cage.is_loop) finer.points.push_back(middle_of(cage, face));
    std::vector<Index> inner;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index after = middle(face[i], face[(i + 1) % face.size()]);
      const Index before = middle(face[(i + face.size() - 1) % face.size()], face[i]);
      finer.faces.push_back({face[i], after, before});
      if (!cage.is_loop) finer.faces.back().insert(finer.faces.back().begin() + 2, face_middle);
      inner.push_back(after);
    }
    if (cage.is_loop) finer.faces.push_back(inner);
  }
  finer.corners.resize(finer.points.size());
  return finer;
}

}  // namespace toccata::oracle
