#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#include <cmath>
#include <optional>

#include "nearest.hpp"

namespace toccata::bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using CgalTriangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, CgalTriangles::const_iterator>;
using CgalTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 converted(const Vec3& v) { return {v.x, v.y, v.z}; }

/// With the points that it keeps to begin its searches with.
class CgalNearest : public NearestLibrary {
 public:
  Description description() const override {
    return {"cgal", "AABB_tree, closest_point", CGAL_VERSION_STR, "Simple_cartesian<double>, -O3 -DNDEBUG"};
  }

  void prepare(const TriangleMesh& mesh) override {
    for (const auto& corner : mesh.triangles())
      triangles_.emplace_back(converted(mesh.vertices()[corner[0]]), converted(mesh.vertices()[corner[1]]),
                              converted(mesh.vertices()[corner[2]]));
    tree_.emplace(triangles_.cbegin(), triangles_.cend());
    tree_->build();
    tree_->accelerate_distance_queries();
  }

  void answer(std::span<const Vec3> points, std::span<double> distances) override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Kernel::Point_3 p = converted(points[i]);
      distances[i] = std::sqrt(CGAL::squared_distance(p, tree_->closest_point(p)));
    }
  }

 private:
  CgalTriangles triangles_;
  std::optional<CgalTree> tree_;
};

}  // namespace

NearestLibraries cgal_nearest_libraries() {
  NearestLibraries libraries;
  libraries.push_back(std::make_unique<CgalNearest>());
  return libraries;
}

}  // namespace toccata::bench
