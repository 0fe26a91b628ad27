#include <algorithm>
#include <map>
#include <utility>

#include "reports/face_pairs.hpp"
#include "toccata/reports/report.hpp"

// What `check` found, as a value. The demo has no more of the reports than this file and report_words.cpp, so that it
// is built soon.
namespace toccata {
namespace io {
namespace {

ReportedIntersection reported_intersection(const SceneInstance& a, const SceneInstance& b, const Contact& contact) {
  const IntersectionPoints found =
      intersection_points(contact.intersection, world_triangle(a.model, a.pose, contact.element_a),
                          world_triangle(b.model, b.pose, contact.element_b));
  return {contact.intersection.kind, {found.points.begin(), found.points.begin() + found.count}};
}

}  // namespace

std::vector<ReportedFacePair> reported_face_pairs(const SceneInstance& a, const SceneInstance& b,
                                                  const std::vector<Contact>& contacts) {
  std::map<std::pair<Index, Index>, ReportedFacePair> pairs;
  for (const Contact& contact : contacts) {
    ReportedFacePair& pair = pairs[{contact.face_a, contact.face_b}];
    pair.face_a = contact.face_a;
    pair.face_b = contact.face_b;
    pair.crossing = pair.crossing || contact.intersection.crossing;
    if (contact.intersection.kind == IntersectionKind::none) continue;  // one of the two is not made of triangles
    // The triangles that a larger face was cut into often meet the other in the same point or edge.
    ReportedIntersection intersection = reported_intersection(a, b, contact);
    if (std::find(pair.intersections.begin(), pair.intersections.end(), intersection) == pair.intersections.end())
      pair.intersections.push_back(std::move(intersection));
  }
  std::vector<ReportedFacePair> result;
  result.reserve(pairs.size());
  for (auto& [faces, pair] : pairs) result.push_back(std::move(pair));
  return result;
}

}  // namespace io

bool counts_as_contact(const Relation& relation, Touching touching) {
  if (relation.kind == RelationKind::apart) return false;
  return relation.kind != RelationKind::touching || touching == Touching::count || relation.side_unresolved ||
         relation.status != Status::exact;
}

namespace {

/// Where two objects meet or are nearest.
Aabb meeting_place(const PairAnswer& pair) {
  Aabb place;
  for (const ContactRegion& region : pair.regions) place = merge(place, region.box);
  if (pair.manifold)
    for (int i = 0; i < pair.manifold->count; ++i)
      place = merge(place, pair.manifold->points[static_cast<std::size_t>(i)].position);
  for (const ContactManifold& one : pair.manifolds)
    for (int i = 0; i < one.manifold.count; ++i)
      place = merge(place, one.manifold.points[static_cast<std::size_t>(i)].position);
  if (pair.common_point) place = merge(place, *pair.common_point);
  if (is_empty(place)) place = pair.common_box;
  if (pair.relation.kind == RelationKind::apart && pair.distance)
    place = merge(merge(Aabb{}, pair.distance->on_a), pair.distance->on_b);
  return place;
}

}  // namespace

CheckReport make_check_report(std::span<const SceneInstance> models, const CheckAnswer& answer,
                              const ReportOptions& options) {
  const bool asks_clearance =
      options.clearance || !options.pair_clearances.empty() || !options.rules.clearances.empty();
  CheckReport report;
  report.candidate_pairs = answer.candidate_pairs;
  report.has_faces = options.faces;
  report.has_penetration = options.penetration;
  if (asks_clearance) report.clearance = options.clearance.value_or(0);
  report.pair_clearances = options.pair_clearances;
  report.clearance_rules = options.rules.clearances;
  report.has_volume = options.volume;
  if (options.tolerance || !options.rules.tolerances.empty()) report.tolerance = options.tolerance.value_or(0);
  for (const PairAnswer& pair : answer.pairs) {
    const bool is_near = pair.relation.kind == RelationKind::apart && pair.distance;
    if (!is_near && !counts_as_contact(pair.relation, options.touching)) {
      ++report.ignored_touching;
      continue;
    }
    ReportedPair& reported = report.pairs.emplace_back();
    reported.a = pair.a;
    reported.b = pair.b;
    reported.relation = pair.relation;
    if (options.faces) reported.face_pairs = io::reported_face_pairs(models[pair.a], models[pair.b], pair.contacts);
    reported.penetration = pair.penetration;
    reported.depth_end = pair.depth_end;
    reported.manifold = pair.manifold;
    reported.manifolds = pair.manifolds;
    reported.regions = pair.regions;
    reported.distance = pair.distance;
    reported.clearance = pair.clearance;
    reported.kind = pair.kind;
    reported.piercing = pair.piercing;
    reported.tolerance = pair.tolerance;
    reported.local_depth = pair.local_depth;
    reported.volume = pair.volume;
    reported.common_point = pair.common_point;
    reported.place = meeting_place(pair);
  }
  return report;
}

}  // namespace toccata
