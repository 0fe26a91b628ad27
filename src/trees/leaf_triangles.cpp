#include "trees/leaf_triangles.hpp"

namespace toccata {
namespace {

/// Doubles round by 2⁻⁵² of what is at most 2.
constexpr float of_floats_to_1 = 0x1.00001p-25F, of_floats_to_2 = 0x1.00001p-24F;

/// How a mesh's vertices come into a tree's units. Scaled first: a difference may be too large for doubles.
class IntoUnits {
 public:
  explicit IntoUnits(const WideBvh& tree) : scale_(1 / tree.unit), origin_(scale_ * tree.origin) {}
  [[nodiscard]] Vec3 operator()(const Vec3& vertex) const { return scale_ * vertex - origin_; }

 private:
  double scale_;
  Vec3 origin_;
};

void set_lane(TriangleLanes& lanes, std::size_t lane, const std::array<Vec3, 3>& triangle, Index number) {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    lanes.corner[corner][0][lane] = static_cast<float>(triangle[corner].x);
    lanes.corner[corner][1][lane] = static_cast<float>(triangle[corner].y);
    lanes.corner[corner][2][lane] = static_cast<float>(triangle[corner].z);
  }
  lanes.number[lane] = number;
}

}  // namespace

LeafTriangles leaf_triangles(const WideBvh& tree, const TriangleMesh& mesh) {
  LeafTriangles all;
  all.off = tree.unit < 0x1p1023 ? of_floats_to_1 : of_floats_to_2;
  all.of_block.resize(tree.blocks.size());
  const IntoUnits in_units(tree);
  for (std::size_t number = 0; number < tree.blocks.size(); ++number) {
    const WideBlock& block = tree.blocks[number];
    for (std::size_t lane = 0; lane < block.count; ++lane) {
      if (!block.is_item(lane)) continue;
      const Index triangle = tree.items[block.item_place(lane)];
      const auto& corner = mesh.triangles()[triangle];
      const auto vertices = mesh.vertices();
      set_lane(all.of_block[number], lane,
               {in_units(vertices[corner[0]]), in_units(vertices[corner[1]]), in_units(vertices[corner[2]])}, triangle);
    }
  }
  return all;
}

}  // namespace toccata
