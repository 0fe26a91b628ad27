#include "reports/view/finding_layers.hpp"

#include "reports/questions/question_kinds.hpp"
#include "reports/view/contact_geometry.hpp"

namespace toccata::io {

void add_contacts(LayerWriter& layers, const std::vector<ReportedFacePair>& pairs) {
  const ContactGeometry found = contact_geometry(pairs);
  layers.add_triangles("contact", found.triangles);
  layers.add_segments("contact", found.segments);
  layers.add_points("contact", found.points);
}

void add_intersecting_faces(LayerWriter& layers, Index a, Index b, const std::vector<ReportedFacePair>& pairs) {
  layers.add_faces("contact", a, intersecting_faces(pairs, &ReportedFacePair::face_a));
  layers.add_faces("contact", b, intersecting_faces(pairs, &ReportedFacePair::face_b));
  add_contacts(layers, pairs);
}

void add_depth(LayerWriter& layers, const std::optional<Penetration>& depth) {
  if (depth && depth->upper > 0) layers.add_length("depth", depth->on_a, depth->on_b, depth->upper, depth->lower);
}

void add_distance(LayerWriter& layers, const Distance& distance) {
  if (distance.upper > 0) layers.add_length("distance", distance.on_a, distance.on_b, distance.upper);
}

void add_arrow(std::vector<Arrow>& arrows, const Vec3& point, const Vec3& normal) {
  if (!(normal == Vec3{})) arrows.push_back({point, normal});
}

void add_normals(LayerWriter& layers, const std::vector<ContactRegion>& regions,
                 const std::optional<Manifold>& manifold) {
  std::vector<Arrow> arrows;
  for (const ContactRegion& region : regions) add_arrow(arrows, region.deepest, region.normal);
  for (int i = 0; manifold && i < manifold->count; ++i)
    add_arrow(arrows, manifold->points[static_cast<std::size_t>(i)].position, manifold->normal);
  layers.add_arrows("normal", arrows);
}

Json finding_layers(const SceneAnswer& answer, const ViewMeshes& meshes, ViewData& data) {
  LayerWriter layers(meshes, data);
  if (const QuestionKind& kind = question_kind_of(answer); kind.mark != nullptr) kind.mark(answer, layers);
  return layers.take();
}

}  // namespace toccata::io
