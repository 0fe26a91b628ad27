#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/version.h>

#include <optional>

#include "sums.hpp"

namespace toccata::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

std::vector<Point> points_of(const ConvexHull& hull) {
  std::vector<Point> points;
  for (Index v = 0; v < hull.vertex_count(); ++v)
    points.emplace_back(hull.vertex(v).x, hull.vertex(v).y, hull.vertex(v).z);
  return points;
}

/// The hull of all sums of two vertices; its own minkowski_sum_3 is of Nef polyhedra and takes seconds.
class CgalSums final : public SumLibrary {
 public:
  [[nodiscard]] Description description() const override {
    return {"cgal", "convex_hull_3 of all sums, Side_of_triangle_mesh", CGAL_VERSION_STR, "-O3 -DNDEBUG"};
  }
  void prepare(std::span<const SumPair> pairs) override {
    for (const SumPair& pair : pairs) pairs_.push_back({points_of(pair.a), points_of(pair.b)});
  }
  Index make(std::size_t i) override { return static_cast<Index>(hull_of(i).number_of_vertices()); }
  void make_ready() override {
    ready_ = hull_of(0);
    inside_.emplace(ready_);
    static_cast<void>((*inside_)(Point(0, 0, 0)));  // builds its tree
  }
  [[nodiscard]] bool contains(const Vec3& p) override {
    return (*inside_)(Point(p.x, p.y, p.z)) != CGAL::ON_UNBOUNDED_SIDE;
  }

 private:
  [[nodiscard]] Mesh hull_of(std::size_t i) const {
    std::vector<Point> sums;
    for (const Point& p : pairs_[i].first)
      for (const Point& q : pairs_[i].second) sums.push_back(p + (q - CGAL::ORIGIN));
    Mesh mesh;
    CGAL::convex_hull_3(sums.begin(), sums.end(), mesh);
    return mesh;
  }

  std::vector<std::pair<std::vector<Point>, std::vector<Point>>> pairs_;
  Mesh ready_;
  std::optional<CGAL::Side_of_triangle_mesh<Mesh, Kernel>> inside_;
};

}  // namespace

SumLibraries cgal_sum_libraries() {
  SumLibraries libraries;
  libraries.push_back(std::make_unique<CgalSums>());
  return libraries;
}

}  // namespace toccata::bench
