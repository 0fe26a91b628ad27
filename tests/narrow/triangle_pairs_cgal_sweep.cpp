#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <optional>

#include "narrow/triangle_pairs.hpp"
#include "support/sweep.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

// Whether and how two triangles meet, compared with CGAL's exact constructions. CGAL takes triangles with area only.
namespace toccata::test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

Kernel::Triangle_3 to_cgal(const Triangle& t) {
  const auto point = [](const Vec3& v) { return Kernel::Point_3(v.x, v.y, v.z); };
  return {point(t[0]), point(t[1]), point(t[2])};
}

struct KindOf {
  using result_type = IntersectionKind;
  IntersectionKind operator()(const Kernel::Point_3& /*unused*/) const { return IntersectionKind::point; }
  IntersectionKind operator()(const Kernel::Segment_3& /*unused*/) const { return IntersectionKind::segment; }
  IntersectionKind operator()(const Kernel::Triangle_3& /*unused*/) const { return IntersectionKind::polygon; }
  IntersectionKind operator()(const std::vector<Kernel::Point_3>& /*unused*/) const {
    return IntersectionKind::polygon;
  }
};

IntersectionKind cgal_kind(const Kernel::Triangle_3& a, const Kernel::Triangle_3& b) {
  const auto common = CGAL::intersection(a, b);
  return common ? boost::apply_visitor(KindOf{}, *common) : IntersectionKind::none;
}

/// Empty, or what is wrong; nothing where CGAL does not take the triangles.
std::optional<std::string> check(const TrianglePair& pair) {
  const Kernel::Triangle_3 a = to_cgal(pair.a), b = to_cgal(pair.b);
  if (a.is_degenerate() || b.is_degenerate()) return std::nullopt;
  const IntersectionKind kind = intersect(pair.a, pair.b).kind;
  const bool meet = CGAL::do_intersect(a, b);
  if (overlap_by_penetration(pair.a, pair.b) != meet) return "penetration";
  if (overlap_by_separating_axes(pair.a, pair.b) != meet) return "separating axes";
  return cgal_kind(a, b) == kind ? "" : "kind";
}

SweepResult run(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random(Random(seed).bits() + 2);
  while (result.cases < cases) {
    const TrianglePair pair = triangle_pair(family, random);
    const std::optional<std::string> wrong = check(pair);
    if (!wrong) continue;
    ++result.cases;
    if (wrong->empty()) continue;
    if (result.wrong++ == 0) result.first_failure = *wrong + ": a" + to_text(pair.a) + ", b" + to_text(pair.b);
  }
  return result;
}

/// All but the family in which a has no area.
std::vector<std::string> families() {
  std::vector<std::string> all = triangle_pair_families();
  std::erase(all, "degenerate");
  return all;
}

const bool known = register_sweep({"triangle-pairs-cgal", families(), 1'000'000, 1000, run});

}  // namespace
}  // namespace toccata::test
