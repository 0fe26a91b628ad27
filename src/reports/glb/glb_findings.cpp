#include "reports/glb/glb_findings.hpp"

#include <fmt/format.h>

#include <utility>

#include "reports/questions/question_kinds.hpp"
#include "reports/view/contact_geometry.hpp"

namespace toccata::io {
namespace {

const GlbPaint second_faces{"faces of the second that meet", 0xd55e00};
const GlbPaint curves{"where they meet", 0x000000};

}  // namespace

std::size_t GlbFindings::at_pose(std::size_t pose, std::size_t poses) {
  const std::vector<std::size_t> nodes = std::exchange(nodes_, {});
  return glb_.add_at_pose(fmt::format("at pose {}", pose), nodes, pose, poses, {{"extras", {{"pose", pose}}}});
}

std::string GlbFindings::title(const char* what, const std::array<Index, 2>& pair) const {
  return fmt::format("{} of {} and {}", what, glb_.name_of(pair[0]), glb_.name_of(pair[1]));
}

std::vector<Shown> GlbFindings::shown_of(ContactGeometry found) {
  return {{std::move(found.triangles), GlbMode::triangles, curves},
          {std::move(found.segments), GlbMode::lines, curves},
          {std::move(found.points), GlbMode::points, curves}};
}

void GlbFindings::add_contacts(const ReportedPair& pair) {
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

void GlbFindings::add_distance(const std::array<Index, 2>& pair, const Distance& distance) {
  if (distance.upper > 0) add_length("distance", pair, {distance.on_a, distance.on_b}, {{"distance", distance.upper}});
}

void GlbFindings::add_depth(const std::array<Index, 2>& pair, const Penetration& depth) {
  add_length("depth", pair, {depth.on_a, depth.on_b},
             {{"found", bracket_text(depth.lower, depth.upper) + " deep"},
              {"depth", {{"lower", depth.lower}, {"upper", depth.upper}}}});
}

void GlbFindings::add_length(const char* what, const std::array<Index, 2>& pair, const std::array<Vec3, 2>& ends,
                             Json extras) {
  const std::vector<Shown> shown{{{ends.begin(), ends.end()}, GlbMode::lines, lengths}};
  add_node(title(what, pair), shown, std::move(extras));
}

std::vector<Vec3> GlbFindings::corners(Index object, std::span<const Index> faces) const {
  const DisplayMesh& drawn = glb_.meshes().meshes()[glb_.meshes().drawn()[object].mesh];
  const Pose pose = glb_.pose_of(object);
  std::vector<Vec3> found;
  for (const Index triangle : glb_.meshes().triangles_of(object, faces))
    for (const Index corner : drawn.triangles[triangle]) found.push_back(transform(pose, drawn.vertices[corner]));
  return found;
}

void GlbFindings::add_node(const std::string& name, std::span<const Shown> shown, Json extras) {
  std::vector<Vec3> all;
  for (const Shown& part : shown) all.insert(all.end(), part.points.begin(), part.points.end());
  const GlbFrame frame = GlbFrame::around(all);
  Json parts = Json::array();
  for (const Shown& part : shown)
    if (!part.points.empty()) parts.push_back(glb_.part(joined_part(part.points, frame), part.mode, part.paint));
  Json more = {{"extras", std::move(extras)}};
  if (!parts.empty()) more["mesh"] = glb_.add_mesh(name, std::move(parts));
  nodes_.push_back(glb_.add_node(name, {}, frame, more));
}

void add_findings(GlbScene& glb, const SceneAnswer& answer) {
  GlbFindings nodes(glb);
  if (const QuestionKind& kind = question_kind_of(answer); kind.show != nullptr) kind.show(answer, nodes);
}

}  // namespace toccata::io
