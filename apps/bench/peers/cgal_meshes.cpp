#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/internal/AABB_traversal_traits_with_transformation.h>
#include <CGAL/version.h>

#include <iterator>
#include <optional>

#include "library.hpp"

namespace toccata::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalTriangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, CgalTriangles::const_iterator>;
using Traits = CGAL::AABB_traits<Kernel, Primitive>;
using CgalTree = CGAL::AABB_tree<Traits>;
using Transformation = CGAL::Aff_transformation_3<Kernel>;

Kernel::Point_3 converted(const Vec3& v) { return {v.x, v.y, v.z}; }

/// The triangles, and the tree over them, which points at them.
struct CgalMesh {
  explicit CgalMesh(const TriangleMesh& mesh) {
    const auto vertices = mesh.vertices();
    triangles.reserve(mesh.triangle_count());
    for (const auto& corner : mesh.triangles())
      triangles.emplace_back(converted(vertices[corner[0]]), converted(vertices[corner[1]]),
                             converted(vertices[corner[2]]));
    tree.insert(triangles.cbegin(), triangles.cend());
    tree.build();
  }
  std::size_t bytes() const {
    return (triangles.size() - 1) * sizeof(CGAL::AABB_node<Traits>) + triangles.size() * sizeof(Primitive);
  }

  CgalTriangles triangles;
  CgalTree tree;
};

Transformation transformation_of(const Pose& pose) {
  const Mat3& m = pose.linear;
  return {m[0].x, m[0].y,        m[0].z, pose.offset.x, m[1].x, m[1].y,
          m[1].z, pose.offset.y, m[2].x, m[2].y,        m[2].z, pose.offset.z};
}

/// As CGAL::Rigid_triangle_mesh_collision_detection does it, which wants a manifold mesh; most real files are not. With
/// a left where it is, which is faster than to pose both.
bool trees_meet(const CgalTree& a, const CgalTree& b, const Transformation& b_in_a) {
  using One = CGAL::Do_intersect_traversal_traits_with_transformation<Traits, Kernel, CGAL::Tag_true>;
  using Two = CGAL::Do_intersect_traversal_traits_for_two_trees<Traits, Kernel, CGAL::Tag_true>;
  const CGAL::Interval_nt_advanced::Protector rounding_upwards;
  Two traversal(b.traits(), b_in_a, One(a.traits()));
  b.traversal(a, traversal);
  return traversal.is_intersection_found();
}

/// Every triangle of b, in a's frame, asked of a's tree.
TrianglePairs pairs_of(const CgalMesh& a, const CgalMesh& b, const Transformation& b_in_a) {
  TrianglePairs pairs;
  std::vector<CgalTree::Primitive_id> met;
  for (std::size_t j = 0; j < b.triangles.size(); ++j) {
    met.clear();
    a.tree.all_intersected_primitives(b.triangles[j].transform(b_in_a), std::back_inserter(met));
    for (const auto& i : met) pairs.emplace_back(static_cast<Index>(i - a.triangles.cbegin()), static_cast<Index>(j));
  }
  return pairs;
}

class CgalMeshes : public MeshLibrary {
 public:
  Description description() const override {
    return {"cgal", "AABB_tree, EPICK", CGAL_VERSION_STR, TOCCATA_BENCH_COMPILER ", -O3 -DNDEBUG -frounding-math"};
  }

  void build(const TriangleMesh& a, const TriangleMesh& b) override {
    a_.emplace(a);
    b_.emplace(b);
  }

  std::size_t bytes() const override { return a_->bytes() + b_->bytes(); }

  std::string obstacle(Task task, int) const override {
    return task == Task::distance ? "AABB_tree tells no distance of two meshes" : "";
  }

  Answer answer(Task task, const PosePair& poses) const override {
    const Transformation b_in_a = transformation_of(poses.a).inverse() * transformation_of(poses.b);
    if (task == Task::overlap) return {trees_meet(a_->tree, b_->tree, b_in_a), {}};
    Answer answer{false, pairs_of(*a_, *b_, b_in_a)};
    answer.overlap = !answer.pairs.empty();
    return answer;
  }

 private:
  std::optional<CgalMesh> a_;
  std::optional<CgalMesh> b_;
};

}  // namespace

MeshLibraries cgal_mesh_libraries() {
  MeshLibraries libraries;
  libraries.push_back(std::make_unique<CgalMeshes>());
  return libraries;
}

}  // namespace toccata::bench
