#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <vector>

#include "narrow/convex_cells.hpp"
#include "toccata/methods/minkowski.hpp"

// Sums and differences of polytopes, compared with CGAL's hull of all sums of two vertices in exact numbers: volume,
// support, and on which side points lie.
namespace toccata::test {
namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactMesh = CGAL::Surface_mesh<Exact::Point_3>;

Exact::Vector_3 exact_vector(const Vec3& v) { return {v.x, v.y, v.z}; }
Exact::Point_3 exact_point(const Vec3& v) { return {v.x, v.y, v.z}; }

std::vector<Exact::Point_3> all_sums(const PosedPolytope& a, const PosedPolytope& b, bool negated) {
  std::vector<Exact::Point_3> sums;
  for (Index i = 0; i < a.vertex_count(); ++i)
    for (Index j = 0; j < b.vertex_count(); ++j)
      sums.push_back(exact_point(a.vertex(i)) + exact_vector(negated ? -b.vertex(j) : b.vertex(j)));
  return sums;
}

Exact::FT six_volumes_of(const Exact::Point_3& p, const Exact::Point_3& q, const Exact::Point_3& r) {
  return CGAL::determinant(p - CGAL::ORIGIN, q - CGAL::ORIGIN, r - CGAL::ORIGIN);
}

/// The hull of all sums, and where a point lies beside it.
class CgalSum {
 public:
  explicit CgalSum(const std::vector<Exact::Point_3>& sums) {
    CGAL::convex_hull_3(sums.begin(), sums.end(), mesh_);
    for (const auto face : mesh_.faces()) {
      const auto h = mesh_.halfedge(face);
      faces_.push_back(
          {mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)), mesh_.point(mesh_.target(mesh_.next(h)))});
    }
  }

  /// Something flat is one polygon, or the triangles of one.
  [[nodiscard]] bool is_solid() const {
    if (faces_.empty()) return false;
    const auto& [p, q, r] = faces_[0];
    return std::ranges::any_of(mesh_.vertices(), [&, &p = p, &q = q, &r = r](const auto vertex) {
      return CGAL::orientation(p, q, r, mesh_.point(vertex)) != CGAL::ZERO;
    });
  }

  [[nodiscard]] Exact::FT volume() const {
    Exact::FT sum = 0;
    for (const auto& [p, q, r] : faces_) sum += six_volumes_of(p, q, r);
    return sum;
  }

  [[nodiscard]] Exact::FT support(const Exact::Vector_3& direction) const {
    Exact::FT most = 0;
    bool is_first = true;
    for (const auto vertex : mesh_.vertices()) {
      const Exact::FT height = (mesh_.point(vertex) - CGAL::ORIGIN) * direction;
      if (is_first || height > most) most = height;
      is_first = false;
    }
    return most;
  }

  [[nodiscard]] Sign side_of(const Exact::Point_3& point) const {
    Sign side = Sign::negative;
    for (const auto& [p, q, r] : faces_) {
      const CGAL::Orientation before = CGAL::orientation(p, q, r, point);
      if (before == CGAL::POSITIVE) return Sign::positive;
      if (before == CGAL::ZERO) side = Sign::zero;
    }
    return side;
  }

 private:
  ExactMesh mesh_;
  std::vector<std::array<Exact::Point_3, 3>> faces_;
};

/// The same of the sum's own exact vertices and faces.
class OwnSum {
 public:
  OwnSum(const MinkowskiSum& sum, const PosedPolytope& a, const PosedPolytope& b, bool negated) : sum_(sum) {
    for (Index i = 0; i < sum.vertex_count(); ++i) {
      const SumVertex pair = sum.pair(i);
      const Vec3 on_b = b.vertex(pair.on_b);
      vertices_.push_back(exact_point(a.vertex(pair.on_a)) + exact_vector(negated ? -on_b : on_b));
    }
  }

  [[nodiscard]] Exact::FT volume() const {
    const HullTopology t = sum_.topology();
    Exact::FT total = 0;
    for (Index f = 0; f < t.face_count(); ++f)
      for (Index h = t.face_start[f] + 1; h + 1 < t.face_start[f + 1]; ++h)
        total += six_volumes_of(at(t.origin[t.face_start[f]]), at(t.origin[h]), at(t.origin[h + 1]));
    return total;
  }

  [[nodiscard]] Exact::FT support(const Exact::Vector_3& direction) const {
    Exact::FT most = (at(0) - CGAL::ORIGIN) * direction;
    for (const Exact::Point_3& p : vertices_) most = std::max<Exact::FT>(most, (p - CGAL::ORIGIN) * direction);
    return most;
  }

 private:
  [[nodiscard]] const Exact::Point_3& at(Index i) const { return vertices_[i]; }

  const MinkowskiSum& sum_;
  std::vector<Exact::Point_3> vertices_;
};

/// Vertices as rounded, what is between them, and what is a last place off.
std::vector<Vec3> points_near(const MinkowskiSum& sum, Random& random) {
  std::vector<Vec3> points{{0, 0, 0}};
  const auto vertex = [&] { return sum.vertex(static_cast<Index>(random.below(sum.vertex_count()))); };
  for (int i = 0; i < 2; ++i) {
    const Vec3 p = vertex(), q = vertex(), r = vertex();
    points.insert(points.end(),
                  {p, 0.5 * (p + q), 0.25 * ((p + q) + (q + r)), p + random.between(-0.1, 1.1) * (q - p)});
    Vec3 moved = 0.5 * (q + r);
    moved.y = std::nextafter(moved.y, i == 0 ? HUGE_VAL : -HUGE_VAL);
    points.push_back(moved);
  }
  return points;
}

std::string fault_of_sum(const PosedPolytope& a, const PosedPolytope& b, bool negated, Random& random) {
  const MinkowskiSum sum = negated ? minkowski_difference(a, b) : minkowski_sum(a, b);
  const CgalSum theirs(all_sums(a, b, negated));
  const OwnSum ours(sum, a, b, negated);
  if (theirs.is_solid() != (sum.dimension() == 3)) return "the dimension";
  for (int i = 0; i < 4; ++i) {
    const Exact::Vector_3 direction(random.between(-1, 1), random.between(-1, 1), i == 0 ? 0 : random.between(-1, 1));
    if (ours.support(direction) != theirs.support(direction)) return "the support";
  }
  if (!theirs.is_solid()) return "";
  if (ours.volume() != theirs.volume()) return "the volume";
  const SumLocator locator(sum);
  for (const Vec3& p : points_near(sum, random)) {
    const Sign side = theirs.side_of(exact_point(p));
    if (sum.side_of(p) != side) return "the side of a point";
    if (locator.side_of(p) != side) return "the side of a point, by the locator";
  }
  return "";
}

std::string check_with_cgal(const ConvexCase& pair, Random& random) {
  const PosedPolytope a = posed(pair.a), b = posed(pair.b);
  const std::string wrong = fault_of_sum(a, b, false, random);
  return wrong.empty() ? fault_of_sum(a, b, true, random) : "of the difference: " + wrong;
}

SweepResult run_with_cgal(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  return run_cell(cell, seed, cases, check_with_cgal);
}

const bool cgal_sums_known = register_sweep({"minkowski-sums-cgal",
                                             {"segment/hull", "triangle/triangle", "triangle/box", "box/box",
                                              "box/hull", "hull/hull", "hull/flat-hull", "hull/needle-hull"},
                                             10'000,
                                             cell_round,
                                             run_with_cgal,
                                             cell_shard,
                                             cell_round});

}  // namespace
}  // namespace toccata::test
