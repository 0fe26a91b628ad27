#include "finding_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "words.hpp"

namespace toccata::command {
namespace {

bool is_near(const ReportedPair& pair) { return pair.relation.kind == RelationKind::apart; }

/// A box, and the words of what is in it.
struct Place {
  Aabb box;
  std::string words;
};

/// "at (0, 0, 1)"; or between which corners, by how many directions the box has an extent in that shows in their
/// digits.
std::string where_text(const Aabb& box) {
  const std::string lower = point_text(box.lower), upper = point_text(box.upper);
  const std::array<Vec3, 3> sides{{{box.upper.x, box.lower.y, box.lower.z},
                                   {box.lower.x, box.upper.y, box.lower.z},
                                   {box.lower.x, box.lower.y, box.upper.z}}};
  const auto extents = std::ranges::count_if(sides, [&](const Vec3& end) { return point_text(end) != lower; });
  if (extents == 0) return "at " + lower;
  constexpr std::array<const char*, 3> forms{"on the segment", "within the rectangle", "within the box"};
  return fmt::format("{} from {} to {}", forms[static_cast<std::size_t>(extents - 1)], lower, upper);
}

Place place_named(const char* what, const Aabb& box) { return {box, fmt::format("{} {}", what, where_text(box))}; }

Place place_between(const char* what, const Vec3& on_a, const Vec3& on_b) {
  return {fit_aabb(std::array{on_a, on_b}), fmt::format("{} {} and {}", what, point_text(on_a), point_text(on_b))};
}

/// What the faces have in common.
Aabb box_of_intersections(const ReportedPair& pair) {
  Aabb box;
  for (const ReportedFacePair& faces : pair.face_pairs)
    for (const ReportedIntersection& intersection : faces.intersections)
      box = merge(box, fit_aabb(intersection.points));
  return box;
}

Aabb box_of_contact_points(const ReportedPair& pair) {
  Aabb box;
  const auto add = [&](const Manifold& manifold) {
    for (int i = 0; i < manifold.count; ++i) box = merge(box, manifold.points[static_cast<std::size_t>(i)].position);
  };
  if (pair.manifold) add(*pair.manifold);
  for (const ContactManifold& one : pair.manifolds) add(one.manifold);
  return box;
}

/// A point of both.
std::optional<Place> common_place(const ReportedPair& pair) {
  if (!pair.common_point) return std::nullopt;
  return place_named("both hold a point", merge(Aabb{}, *pair.common_point));
}

/// As far as the answer tells it, the most telling first.
std::optional<Place> told_place(const Scene& scene, const ReportedPair& pair) {
  if (is_near(pair)) {
    if (!pair.distance) return std::nullopt;
    return place_between("the nearest points are", pair.distance->on_a, pair.distance->on_b);
  }
  if (const Aabb box = box_of_intersections(pair); !is_empty(box)) return place_named("the surfaces meet", box);
  Aabb regions;
  for (const ContactRegion& region : pair.regions) regions = merge(regions, region.box);
  if (!is_empty(regions)) return place_named("they meet", regions);
  if (const Aabb box = box_of_contact_points(pair); !is_empty(box)) return place_named("they are in contact", box);
  if (pair.penetration && pair.penetration->upper > 0)
    return place_between("the deepest points are", pair.penetration->on_a, pair.penetration->on_b);
  if (pair.relation.containment == Containment::none) return common_place(pair);
  const bool is_b_inside = pair.relation.containment == Containment::b_in_a;
  const std::optional<Aabb> box = inspect(scene.objects[is_b_inside ? pair.b : pair.a]).world_box;
  return box ? std::optional(place_named("the one inside lies", *box)) : std::nullopt;
}

/// What a tolerance makes of the pair, and by which depth; empty where there is none.
std::string verdict_text(const ReportedPair& pair) {
  const std::string depth = pair.local_depth ? ", " + local_depth_text(pair) : "";
  switch (pair.tolerance) {
    case ToleranceVerdict::within:
      return depth + ", within the tolerance: no clash";
    case ToleranceVerdict::beyond:
      return depth + ", beyond the tolerance";
    case ToleranceVerdict::undecided:
      return ", undecided whether within the tolerance";
    case ToleranceVerdict::none:
      break;
  }
  return {};
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

std::vector<std::string> labels_of(const ReportedPair& pair, bool has_volume) {
  std::vector<std::string> labels{kind_of_finding(pair)};
  const std::string kind = name_of(pair.kind);
  if (has_volume && pair.kind != ClashKind::overlap && kind != labels[0]) labels.push_back(kind);
  return labels;
}

std::string sentence_of(const Scene& scene, const ReportedPair& pair) {
  const std::string a = printable(scene.objects[pair.a].name), b = printable(scene.objects[pair.b].name);
  if (is_near(pair) && pair.distance && !is_clash(pair))
    return fmt::format("{} and {} are {}", a, b, distance_text(*pair.distance));
  if (is_near(pair) && pair.distance)
    return fmt::format("{} and {} are nearer than their clearance: {}", a, b, distance_text(*pair.distance));
  const bool is_deep = pair.penetration && pair.penetration->upper > 0;
  return fmt::format("{} {} {}{}{} {}", a, verb_of(pair), b,
                     is_deep ? ", " + depth_text(*pair.penetration, pair.depth_end, b) : "", verdict_text(pair),
                     pair.winding ? winding_text(*pair.winding) : remark_on(pair.relation));
}

std::vector<std::string> details_of(const Scene& scene, const ReportedPair& pair, bool has_baseline) {
  std::vector<std::string> details;
  const std::optional<Place> place = told_place(scene, pair), common = common_place(pair);
  if (place) details.push_back(place->words);
  if (pair.volume && pair.volume->upper > 0)
    details.push_back(fmt::format("the volume that they have in common is {}", volume_text(*pair.volume)));
  if (common && !(place && place->words == common->words)) details.push_back(common->words);
  if (!pair.regions.empty()) details.push_back(counted(pair.regions.size(), "region of contact", "regions of contact"));
  if (has_baseline) details.push_back("since the baseline: " + since_text(pair));
  return details;
}

Aabb place_of(const Scene& scene, const ReportedPair& pair) {
  const auto has_end = [](const Aabb& box) { return !is_empty(box) && is_finite(box.lower) && is_finite(box.upper); };
  if (const std::optional<Place> place = told_place(scene, pair); place && has_end(place->box)) return place->box;
  return has_end(pair.place) ? pair.place : Aabb{{-1, -1, -1}, {1, 1, 1}};
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
