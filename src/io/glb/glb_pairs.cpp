#include <fmt/format.h>

#include <utility>

#include "io/glb/glb_scene.hpp"
#include "io/view/contact_geometry.hpp"
#include "toccata/io/relation_words.hpp"

namespace toccata::io {
namespace {

using Json = GlbWriter::Json;

const GlbPaint first_faces{"faces of the first that meet", 0x0072b2};
const GlbPaint second_faces{"faces of the second that meet", 0xd55e00};
const GlbPaint curves{"where they meet", 0x000000};
const GlbPaint lengths{"depth and distance", 0xcc79a7};

/// Points of a pair, in the world, and how they are shown.
struct Shown {
  std::vector<Vec3> points;
  GlbMode mode;
  GlbPaint paint;
};

class PairNodes {
 public:
  explicit PairNodes(GlbScene& glb) : glb_(glb) {}

  void add(const ReportedPair& pair) {
    if (pair.relation.kind != RelationKind::apart) add_contacts(pair);
    if (pair.penetration && pair.penetration->upper > 0)
      add_length("depth", pair, pair.penetration->upper, {pair.penetration->on_a, pair.penetration->on_b});
    if (pair.distance && pair.distance->upper > 0)
      add_length("distance", pair, pair.distance->upper, {pair.distance->on_a, pair.distance->on_b});
  }

  [[nodiscard]] const std::vector<std::size_t>& nodes() const { return nodes_; }

 private:
  [[nodiscard]] std::string title(const char* what, const ReportedPair& pair) const {
    return fmt::format("{} of {} and {}", what, glb_.name_of(pair.a), glb_.name_of(pair.b));
  }

  void add_contacts(const ReportedPair& pair) {
    ContactGeometry found = contact_geometry(pair.face_pairs);
    for (int i = 0; pair.manifold && i < pair.manifold->count; ++i)
      found.points.push_back(pair.manifold->points[static_cast<std::size_t>(i)].position);
    std::vector<Shown> shown{
        {corners(pair.a, meeting_faces(pair.face_pairs, &ReportedFacePair::face_a)), GlbMode::triangles, first_faces},
        {corners(pair.b, meeting_faces(pair.face_pairs, &ReportedFacePair::face_b)), GlbMode::triangles, second_faces},
        {std::move(found.triangles), GlbMode::triangles, curves},
        {std::move(found.segments), GlbMode::lines, curves},
        {std::move(found.points), GlbMode::points, curves}};
    const std::string remark = remark_on(pair.relation);
    add_node(title("contacts", pair), shown,
             {{"found", fmt::format("{} {} {}{}{}", glb_.name_of(pair.a), verb_of(pair.relation), glb_.name_of(pair.b),
                                    remark.empty() ? "" : " ", remark)}});
  }

  void add_length(const char* what, const ReportedPair& pair, double length, const std::array<Vec3, 2>& ends) {
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

void add_pairs(GlbScene& glb, const CheckReport& report) {
  PairNodes pairs(glb);
  for (const ReportedPair& pair : report.pairs) pairs.add(pair);
  glb.add_group("pairs", pairs.nodes());
}

}  // namespace toccata::io
