#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "io/glb/glb_scene.hpp"
#include "io/view/contact_geometry.hpp"
#include "io/view/drawn_faults.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/report.hpp"

namespace toccata::io {
namespace {

const GlbPaint first_faces{"faces of the first that meet", 0x0072b2};
const GlbPaint second_faces{"faces of the second that meet", 0xd55e00};
const GlbPaint curves{"where they meet", 0x000000};
const GlbPaint faults{"faults of meshes", 0xd55e00};
const GlbPaint lengths{"depths, distances and rays", 0xcc79a7};

/// Points of a finding, in the world, and how they are shown.
struct Shown {
  std::vector<Vec3> points;
  GlbMode mode;
  GlbPaint paint;
};

/// A node for each thing that was found; asked with an answer, it adds those of this answer.
class FindingNodes {
 public:
  explicit FindingNodes(GlbScene& glb) : glb_(glb) {}

  void operator()(const CheckReport& report) {
    for (const ReportedPair& pair : report.pairs) {
      if (pair.relation.kind != RelationKind::apart) add_contacts(pair);
      if (pair.penetration && pair.penetration->upper > 0)
        add_length("depth", {pair.a, pair.b}, pair.penetration->upper,
                   {pair.penetration->on_a, pair.penetration->on_b});
      if (pair.distance) add_distance({pair.a, pair.b}, *pair.distance);
    }
    glb_.add_group("pairs", nodes_);
  }

  void operator()(const DistanceReport& report) {
    for (const ReportedDistance& pair : report.pairs) add_distance({pair.a, pair.b}, pair.distance);
    glb_.add_group("pairs", nodes_);
  }

  void operator()(const SelfReport& report) {
    for (std::size_t i = 0; i < report.objects.size(); ++i) {
      const ReportedSelf& found = report.objects[i];
      if (found.faces.empty()) continue;
      std::vector<Shown> shown = shown_of(contact_geometry(found.faces));
      shown.push_back(
          {corners(static_cast<Index>(i), faces_intersecting(found.faces)), GlbMode::triangles, first_faces});
      add_node("contacts of " + glb_.name_of(i) + " with itself", shown, {{"face_pairs", found.face_pairs}});
    }
    glb_.add_group("self-contacts", nodes_);
  }

  void operator()(const RayReport& report) {
    for (std::size_t i = 0; i < report.rays.size(); ++i) {
      const auto& [query, hit, object] = report.rays[i];
      const Vec3 end = hit.hit ? hit.point : query.origin + query.motion;
      Json extras = Json::object();
      if (hit.hit) extras = {{"meets", glb_.name_of(object)}, {"fraction", hit.upper}};
      add_node(fmt::format("ray {}", i), std::vector<Shown>{{{query.origin, end}, GlbMode::lines, lengths}},
               std::move(extras));
    }
    glb_.add_group("rays", nodes_);
  }

  void operator()(const FacesReport& report) {
    for (const ReportedFaces& found : report.found) {
      const std::vector<Index> faces = distinct_faces(found.found);
      add_node("faces of " + glb_.name_of(found.object),
               std::vector<Shown>{{corners(found.object, faces), GlbMode::triangles, first_faces}},
               {{"faces", faces.size()}});
    }
    glb_.add_group("faces", nodes_);
  }

  void operator()(const NearestReport& report) {
    for (std::size_t i = 0; i < report.points.size(); ++i)
      for (const ReportedSurfacePoint& one : report.points[i].nearest)
        add_node(fmt::format("point {} to {}", i, glb_.name_of(one.object)),
                 std::vector<Shown>{{{report.points[i].point, one.nearest.point}, GlbMode::lines, lengths}},
                 {{"distance", one.nearest.upper}});
    glb_.add_group("points", nodes_);
  }

  void operator()(const InspectReport& report) {
    for (const InspectFinding& finding : inspect_findings(report)) {
      if (!finding.fault) continue;
      const SceneObject& object = report.objects[finding.object].object;
      FaultGeometry found = geometry_of(*finding.fault, *object.mesh(), object.pose);
      add_node(fmt::format("{} of {}", words_of(finding.fault->kind), glb_.name_of(finding.object)),
               std::vector<Shown>{{std::move(found.triangles), GlbMode::triangles, faults},
                                  {std::move(found.segments), GlbMode::lines, faults},
                                  {std::move(found.points), GlbMode::points, faults}},
               {{"count", finding.fault->count()}});
    }
    glb_.add_group("faults", nodes_);
  }

  void operator()(const RebalanceReport&) {}  // its trees are added by themselves
  void operator()(const CostReport&) {}       // it tells of costs alone
  void operator()(const DecomposeReport&) {}  // parts and sums are objects
  void operator()(const MinkowskiReport&) {}
  void operator()(const CrowdReport&) {}  // crowds are recorded (glb_recordings.cpp)
  void operator()(const CrowdWorldReport&) {}

  void operator()(const PosesReport& report) {
    std::vector<std::size_t> at_poses;
    for (std::size_t i = 0; i < std::min(report.face_pairs.size(), report.relations.size()); ++i) {
      if (report.relations[i].kind == RelationKind::apart) continue;
      add_contacts(pair_at(report, i));
      at_poses.push_back(at_pose(i, report.queries.size()));
    }
    glb_.add_group("poses", at_poses);
  }

  void operator()(const DistancePosesReport& report) {
    std::vector<std::size_t> at_poses;
    for (std::size_t i = 0; i < report.distances.size(); ++i) {
      if (report.distances[i].upper == 0) continue;
      add_distance({0, 1}, report.distances[i]);
      at_poses.push_back(at_pose(i, report.queries.size()));
    }
    glb_.add_group("poses", at_poses);
  }

 private:
  /// "boundary edges".
  static std::string words_of(MeshFaultKind kind) {
    std::string words = toccata::name_of(kind);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
  }

  /// What was found at a pose, as that of a pair.
  static ReportedPair pair_at(const PosesReport& report, std::size_t i) {
    ReportedPair pair;
    pair.a = 0;
    pair.b = 1;
    pair.relation = report.relations[i];
    pair.face_pairs = report.face_pairs[i];
    return pair;
  }

  /// Puts the nodes that were added under one that shows them at this pose.
  std::size_t at_pose(std::size_t pose, std::size_t poses) {
    const std::vector<std::size_t> nodes = std::exchange(nodes_, {});
    return glb_.add_at_pose(fmt::format("at pose {}", pose), nodes, pose, poses, {{"extras", {{"pose", pose}}}});
  }

  [[nodiscard]] std::string title(const char* what, const std::array<Index, 2>& pair) const {
    return fmt::format("{} of {} and {}", what, glb_.name_of(pair[0]), glb_.name_of(pair[1]));
  }

  /// What faces have in common.
  static std::vector<Shown> shown_of(ContactGeometry found) {
    return {{std::move(found.triangles), GlbMode::triangles, curves},
            {std::move(found.segments), GlbMode::lines, curves},
            {std::move(found.points), GlbMode::points, curves}};
  }

  void add_contacts(const ReportedPair& pair) {
    ContactGeometry found = contact_geometry(pair.face_pairs);
    for (int i = 0; pair.manifold && i < pair.manifold->count; ++i)
      found.points.push_back(pair.manifold->points[static_cast<std::size_t>(i)].position);
    for (const ContactManifold& one : pair.manifolds)
      for (int i = 0; i < one.manifold.count; ++i)
        found.points.push_back(one.manifold.points[static_cast<std::size_t>(i)].position);
    std::vector<Shown> shown{{corners(pair.a, intersecting_faces(pair.face_pairs, &ReportedFacePair::face_a)),
                              GlbMode::triangles, first_faces},
                             {corners(pair.b, intersecting_faces(pair.face_pairs, &ReportedFacePair::face_b)),
                              GlbMode::triangles, second_faces}};
    for (Shown& part : shown_of(std::move(found))) shown.push_back(std::move(part));
    const std::string remark = remark_on(pair.relation);
    add_node(title("contacts", {pair.a, pair.b}), shown,
             {{"found", fmt::format("{} {} {}{}{}", glb_.name_of(pair.a), verb_of(pair.relation), glb_.name_of(pair.b),
                                    remark.empty() ? "" : " ", remark)}});
  }

  void add_distance(const std::array<Index, 2>& pair, const Distance& distance) {
    if (distance.upper > 0) add_length("distance", pair, distance.upper, {distance.on_a, distance.on_b});
  }

  void add_length(const char* what, const std::array<Index, 2>& pair, double length, const std::array<Vec3, 2>& ends) {
    const std::vector<Shown> shown{{{ends.begin(), ends.end()}, GlbMode::lines, lengths}};
    add_node(title(what, pair), shown, {{what, length}});
  }

  /// Of the triangles that are drawn for these faces.
  [[nodiscard]] std::vector<Vec3> corners(Index object, std::span<const Index> faces) const {
    const DisplayMesh& drawn = glb_.meshes().meshes()[glb_.meshes().drawn()[object].mesh];
    const Pose pose = glb_.pose_of(object);
    std::vector<Vec3> found;
    for (const Index triangle : glb_.meshes().triangles_of(object, faces))
      for (const Index corner : drawn.triangles[triangle]) found.push_back(transform(pose, drawn.vertices[corner]));
    return found;
  }

  void add_node(const std::string& name, std::span<const Shown> shown, Json extras) {
    std::vector<Vec3> all;
    for (const Shown& part : shown) all.insert(all.end(), part.points.begin(), part.points.end());
    const GlbFrame frame = GlbFrame::around(all);
    Json parts = Json::array();
    for (const Shown& part : shown)
      if (!part.points.empty()) parts.push_back(glb_.part(joined_part(part.points, frame), part.mode, part.paint));
    Json more = {{"extras", std::move(extras)}};
    if (!parts.empty()) more["mesh"] = glb_.add_mesh(name, std::move(parts));
    nodes_.push_back(glb_.add_node(name, {}, frame, std::move(more)));
  }

  GlbScene& glb_;
  std::vector<std::size_t> nodes_;
};

}  // namespace

void add_findings(GlbScene& glb, const SceneAnswer& answer) {
  FindingNodes nodes(glb);
  std::visit([&](const auto& report) { nodes(report); }, answer);
}

}  // namespace toccata::io
