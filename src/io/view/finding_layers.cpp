#include "io/view/finding_layers.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "io/view/contact_geometry.hpp"
#include "io/view/drawn_faults.hpp"
#include "io/view/layer_writer.hpp"

namespace toccata::io {
namespace {

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
  if (depth && depth->upper > 0) layers.add_length("depth", depth->on_a, depth->on_b, depth->upper);
}

void add_distance(LayerWriter& layers, const Distance& distance) {
  if (distance.upper > 0) layers.add_length("distance", distance.on_a, distance.on_b, distance.upper);
}

/// Of no length where there is none.
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

/// The equators of a ball, seen along each axis.
std::vector<Vec3> circles_of(const Ball& ball) {
  constexpr int parts = 64;
  std::vector<Vec3> ends;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = [&](int i) {
      const double angle = 2 * std::numbers::pi * i / parts;
      Vec3 place = ball.centre;
      place[(axis + 1) % 3] += ball.radius * std::cos(angle);
      place[(axis + 2) % 3] += ball.radius * std::sin(angle);
      return place;
    };
    for (int i = 0; i < parts; ++i) {
      ends.push_back(at(i));
      ends.push_back(at(i + 1));
    }
  }
  return ends;
}

/// Draws one answer after the other.
struct FindingMarks {
  LayerWriter& layers;

  void operator()(const CheckReport& report) const {
    for (std::size_t i = 0; i < report.pairs.size(); ++i) {
      const ReportedPair& pair = report.pairs[i];
      layers.begin(i);
      add_intersecting_faces(layers, pair.a, pair.b, pair.face_pairs);
      add_depth(layers, pair.penetration);
      if (pair.distance) add_distance(layers, *pair.distance);
      add_normals(layers, pair.regions, pair.manifold);
      for (const ContactManifold& one : pair.manifolds) add_normals(layers, {}, one.manifold);
    }
  }

  void operator()(const PosesReport& report) const {
    for (std::size_t i = 0; i < report.queries.size(); ++i) {
      layers.begin(i);
      if (i < report.face_pairs.size()) add_intersecting_faces(layers, 0, 1, report.face_pairs[i]);
      if (!report.penetrations.empty()) add_depth(layers, report.penetrations[i]);
      if (!report.regions.empty()) add_normals(layers, report.regions[i], std::nullopt);
    }
  }

  void operator()(const SelfReport& report) const {
    for (std::size_t i = 0; i < report.objects.size(); ++i) {
      layers.begin(i);
      layers.add_faces("contact", static_cast<Index>(i), faces_intersecting(report.objects[i].faces));
      add_contacts(layers, report.objects[i].faces);
    }
  }

  void operator()(const DistanceReport& report) const {
    for (std::size_t i = 0; i < report.pairs.size(); ++i) {
      layers.begin(i);
      add_distance(layers, report.pairs[i].distance);
    }
  }

  void operator()(const DistancePosesReport& report) const {
    for (std::size_t i = 0; i < report.queries.size(); ++i) {
      layers.begin(i);
      add_distance(layers, report.distances[i]);
    }
  }

  void operator()(const RayReport& report) const {
    for (std::size_t i = 0; i < report.rays.size(); ++i) {
      const auto& [query, hit, object] = report.rays[i];
      layers.begin(i);
      const Vec3 end = query.origin + query.motion;
      layers.add_segments("ray", std::array{query.origin, hit.hit ? hit.point : end});
      layers.add_points("start", std::array{query.origin});
      if (!hit.hit) continue;
      layers.add_points("hit", std::array{hit.point});
      std::vector<Arrow> normal;
      add_arrow(normal, hit.point, hit.normal);
      layers.add_arrows("normal", normal);
    }
  }

  void operator()(const FacesReport& report) const {
    if (const auto* ball = std::get_if<Ball>(&report.region))
      layers.add_segments("region", circles_of(*ball));
    else
      layers.add_box("region", std::get<Aabb>(report.region).lower, std::get<Aabb>(report.region).upper);
    for (std::size_t i = 0; i < report.found.size(); ++i) {
      layers.begin(i);
      layers.add_faces("within", report.found[i].object, distinct_faces(report.found[i].found));
    }
  }

  void operator()(const NearestReport& report) const {
    for (std::size_t i = 0; i < report.points.size(); ++i) {
      layers.begin(i);
      layers.add_points("asked", std::array{report.points[i].point});
      for (const ReportedSurfacePoint& one : report.points[i].nearest)
        layers.add_length("distance", report.points[i].point, one.nearest.point, one.nearest.upper);
    }
  }

  // These have no marks of their own: trees, hierarchies and moving boxes are layers by themselves, convex
  // parts and sums are objects.
  void operator()(const RebalanceReport&) const {}
  void operator()(const CostReport&) const {}
  void operator()(const CrowdReport&) const {}
  void operator()(const CrowdWorldReport&) const {}
  void operator()(const DecomposeReport&) const {}
  void operator()(const MinkowskiReport&) const {}

  void operator()(const InspectReport& report) const {
    const std::vector<InspectFinding> findings = inspect_findings(report);
    for (std::size_t i = 0; i < findings.size(); ++i) {
      if (!findings[i].fault) continue;
      layers.begin(i);
      const SceneObject& object = report.objects[findings[i].object].object;
      const FaultGeometry shown = geometry_of(*findings[i].fault, *object.mesh(), object.pose);
      const std::string role = name_of(findings[i].fault->kind);
      layers.add_triangles(role.c_str(), shown.triangles);
      layers.add_segments(role.c_str(), shown.segments);
      layers.add_points(role.c_str(), shown.points);
    }
  }
};

}  // namespace

Json finding_layers(const SceneAnswer& answer, const ViewMeshes& meshes, ViewData& data) {
  LayerWriter layers(meshes, data);
  std::visit(FindingMarks{layers}, answer);
  return layers.take();
}

}  // namespace toccata::io
