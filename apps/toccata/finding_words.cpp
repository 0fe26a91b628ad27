#include "finding_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "words.hpp"

namespace toccata::command {
namespace {

bool is_near(const ReportedPair& pair) { return pair.relation.kind == RelationKind::apart; }

std::vector<Vec3> points_of(const ReportedPair& pair) {
  std::vector<Vec3> points;
  for (const ReportedFacePair& faces : pair.face_pairs)
    for (const ReportedIntersection& intersection : faces.intersections)
      points.insert(points.end(), intersection.points.begin(), intersection.points.end());
  if (!points.empty()) return points;
  for (const ContactRegion& region : pair.regions) points.push_back(region.deepest);
  if (pair.manifold)
    for (int i = 0; i < pair.manifold->count; ++i)
      points.push_back(pair.manifold->points[static_cast<std::size_t>(i)].position);
  for (const ContactManifold& one : pair.manifolds)
    for (int i = 0; i < one.manifold.count; ++i)
      points.push_back(one.manifold.points[static_cast<std::size_t>(i)].position);
  if (points.empty() && pair.penetration && pair.penetration->upper > 0)
    points = {pair.penetration->on_a, pair.penetration->on_b};
  if (points.empty() && is_near(pair) && pair.distance) points = {pair.distance->on_a, pair.distance->on_b};
  return points;
}

/// FNV-1a.
std::uint64_t hash_of(std::string_view text, std::uint64_t hash) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

}  // namespace

std::string kind_of_finding(const ReportedPair& pair) {
  if (pair.relation.status != Status::exact || pair.relation.side_unresolved) return "undecided";
  return is_near(pair) ? "clearance" : name_of(pair.relation.kind);
}

std::string sentence_of(const Scene& scene, const ReportedPair& pair) {
  const std::string a = printable(scene.objects[pair.a].name), b = printable(scene.objects[pair.b].name);
  if (is_near(pair) && pair.distance)
    return fmt::format("{} and {} are nearer than their clearance: {}", a, b, distance_text(*pair.distance));
  const bool is_deep = pair.penetration && pair.penetration->upper > 0;
  return fmt::format("{} {} {}{} {}", a, verb_of(pair.relation), b,
                     is_deep ? ", " + depth_text(*pair.penetration, pair.depth_end) : "", remark_on(pair.relation));
}

std::vector<std::string> details_of(const Scene& scene, const ReportedPair& pair, bool has_baseline) {
  std::vector<std::string> details;
  if (is_near(pair) && pair.distance) details.push_back("from " + nearest_text(*pair.distance));
  if (const std::optional<Aabb> place = place_of(scene, pair))
    details.push_back(fmt::format("within the box from {} to {}", point_text(place->lower), point_text(place->upper)));
  if (!pair.regions.empty()) details.push_back(counted(pair.regions.size(), "region of contact", "regions of contact"));
  if (has_baseline) details.push_back("since the baseline: " + name_of(since_baseline(pair)));
  return details;
}

std::optional<Aabb> place_of(const Scene& scene, const ReportedPair& pair) {
  const std::vector<Vec3> points = points_of(pair);
  if (!points.empty()) {
    Aabb box{points[0], points[0]};
    for (const Vec3& point : points)
      for (int axis = 0; axis < 3; ++axis) {
        box.lower[axis] = std::min(box.lower[axis], point[axis]);
        box.upper[axis] = std::max(box.upper[axis], point[axis]);
      }
    return box;
  }
  const bool is_b_inside = pair.relation.containment == Containment::b_in_a;
  if (pair.relation.containment == Containment::none) return std::nullopt;
  return inspect(scene.objects[is_b_inside ? pair.b : pair.a]).world_box;
}

std::string digits_of(const std::string& words) {
  constexpr std::uint64_t start = 0xcbf29ce484222325U;
  const std::uint64_t first = hash_of(words, start), second = hash_of(words, hash_of("second", first));
  return fmt::format("{:016x}{:016x}", first, second);
}

std::string in_address(const std::string& path) {
  std::string address;
  for (const char c : path) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          std::string_view("/-_.~").find(c) != std::string_view::npos;
    address += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return address;
}

}  // namespace toccata::command
