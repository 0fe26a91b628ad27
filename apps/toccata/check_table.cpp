#include "check_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "table_names.hpp"
#include "toccata/query/pairs.hpp"
#include "toccata/reports/report.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

constexpr std::size_t most_listed = 10;  // per pair of objects; JSON and CSV list all

std::string points_text(const ReportedIntersection& intersection) {
  std::string text;
  for (const Vec3& point : intersection.points) text += (text.empty() ? "" : " ") + point_text(point);
  return text;
}

std::string near_text(const ReportedPair& pair) {
  const bool is_decided = pair.relation.status == Status::exact;
  return distance_text(*pair.distance) + ", " + nearest_text(*pair.distance) +
         (is_decided ? "" : " (undecided: within 10⁻¹² of its clearance)");
}

std::string former_verb(const FormerPair& pair) {
  Relation relation;
  relation.kind = pair.kind;
  relation.containment = pair.containment;
  if (pair.kind != RelationKind::apart) return verb_of(relation);
  return pair.demanded ? "clearance clash" : "is apart from";
}

/// The depth by which a verdict was come to, as far as it is known.
std::string deciding_depth(const ReportedPair& pair) {
  if (pair.local_depth) return local_depth_text(pair);
  if (pair.penetration) return depth_text(pair.penetration->lower, pair.penetration->upper) + ", by what parts them";
  return "no depth is known of them";
}

/// What a tolerance says of the pair.
std::string tolerance_text(const ReportedPair& pair) {
  switch (pair.tolerance) {
    case ToleranceVerdict::within:
      return ", within the tolerance: " + deciding_depth(pair);
    case ToleranceVerdict::beyond:
      return ", beyond the tolerance: " + deciding_depth(pair);
    case ToleranceVerdict::undecided:
      return ", undecided whether within the tolerance: " + deciding_depth(pair);
    case ToleranceVerdict::none:
      break;
  }
  return {};
}

/// How much they have in common, and where.
std::string volume_line(const ReportedPair& pair) {
  if (!pair.volume) return "      no volume is known of what they have in common\n";
  return fmt::format("      volume {}{}\n", volume_text(*pair.volume),
                     pair.common_point ? ", around " + point_text(*pair.common_point) : "");
}

/// What it was in the measure by which it has grown since.
std::string before_growth(const ReportedPair& pair) {
  switch (pair.growth) {
    case ClashGrowth::penetration:
      return depth_text(pair.was->penetration->lower, pair.was->penetration->upper);
    case ClashGrowth::local_depth:
      return depth_text(pair.was->local_depth->lower, pair.was->local_depth->upper) + " in one place";
    case ClashGrowth::volume:
      return "volume " + volume_text(*pair.was->volume);
    case ClashGrowth::none:
      break;
  }
  return {};
}

/// How it stands against the baseline, with the relation of then where that was another, or how large it was.
std::string since_and_before(const ReportedPair& pair, const std::string& verb) {
  const std::string since = since_text(pair);
  if (pair.growth != ClashGrowth::none) return since + " (before: " + before_growth(pair) + ")";
  const std::string before = pair.was ? former_verb(*pair.was) : verb;
  return before == verb ? since : since + " (before: " + before + ")";
}

std::vector<std::string> row_of(const std::vector<std::string>& names, const ReportedPair& pair,
                                const CheckReport& report) {
  const bool is_near = pair.relation.kind == RelationKind::apart && pair.distance;
  const std::string plain = is_near && is_clash(pair) ? "clearance clash" : verb_of(pair.relation);
  const std::string verb = report.has_volume && !is_near ? verb_of(pair) : plain;
  const std::string remark = pair.winding ? winding_text(*pair.winding)
                             : is_near    ? near_text(pair)
                                          : remark_on(pair.relation) + tolerance_text(pair);
  std::vector<std::string> row{names[pair.a], verb, names[pair.b], remark};
  if (report.baseline) row.insert(row.begin(), since_and_before(pair, plain));
  return row;
}

std::string reason_text(GoneReason reason) {
  switch (reason) {
    case GoneReason::apart:
      return "no clash now";
    case GoneReason::touching:
      return "now merely touching, ignored as asked";
    case GoneReason::left_out:
      return "not checked now";
    case GoneReason::no_object:
      return "not in the files now";
  }
  return {};
}

/// Overlaps that have moved, of which the two reports have no measure in common.
bool may_have_grown(const ReportedPair& pair) {
  if (since_baseline(pair) != Since::moved || pair.relation.kind != RelationKind::overlapping) return false;
  return !(pair.penetration && pair.was->penetration) && !(pair.local_depth && pair.was->local_depth) &&
         !(pair.volume && pair.was->volume);
}

/// Says of how many it cannot be told whether they are graver.
std::string unknown_growth_line(const CheckReport& report) {
  const auto unknown = std::count_if(report.pairs.begin(), report.pairs.end(), may_have_grown);
  if (unknown == 0) return {};
  return fmt::format(
      "Of {} that moved it is not known whether the overlap has grown: ask for --penetration or --volume both times.\n",
      grouped(static_cast<std::size_t>(unknown)));
}

/// What is gone of the baseline, and how many pairs are new, graver, moved and known.
std::string baseline_lines(const CheckReport& report) {
  std::vector<std::vector<std::string>> rows;
  for (const GonePair& pair : report.gone)
    rows.push_back({"gone", printable(pair.was.a), former_verb(pair.was), printable(pair.was.b),
                    "(" + reason_text(pair.reason) + ")"});
  const auto count = [&](Since since) {
    return grouped(
        static_cast<std::size_t>(std::count_if(report.pairs.begin(), report.pairs.end(), [&](const ReportedPair& pair) {
          return since_baseline(pair) == since;
        })));
  };
  return columns(rows, 2) +
         fmt::format("Since {}: {} new, {} graver, {} moved, {} known, {} gone.\n", printable(*report.baseline),
                     count(Since::added), count(Since::graver), count(Since::moved), count(Since::known),
                     grouped(report.gone.size())) +
         unknown_growth_line(report);
}

/// The first few; JSON lists all, in what was asked.
std::string patterns_text(const std::vector<std::string>& patterns) {
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, patterns.size()); ++i)
    text += (i == 0 ? "" : ", ") + printable(patterns[i]);
  return patterns.size() > most ? fmt::format("{} … ({} more)", text, patterns.size() - most) : text;
}

/// As the lengths were understood.
std::string clearance_line(const Scene& scene, const CheckReport& report) {
  const std::vector<std::string> names = table_names(scene.objects);
  std::string text = "Clearance " + length_text(*report.clearance, scene.unit);
  const std::size_t shown = std::min(report.pair_clearances.size(), most_listed);
  for (std::size_t i = 0; i < shown; ++i) {
    const PairClearance& pair = report.pair_clearances[i];
    text += fmt::format("; {} between {} and {}", length_text(pair.clearance, scene.unit),
                        names[std::min(pair.a, pair.b)], names[std::max(pair.a, pair.b)]);
  }
  if (shown < report.pair_clearances.size())
    text += fmt::format("; and of {} their own", counted(report.pair_clearances.size() - shown, "more pair"));
  const std::size_t rules = std::min(report.clearance_rules.size(), most_listed);
  for (std::size_t i = 0; i < rules; ++i) {
    const LengthRule& rule = report.clearance_rules[i];
    text += fmt::format("; {} between {} and {}", length_text(rule.length, scene.unit), patterns_text(rule.pairs.a),
                        patterns_text(rule.pairs.b));
  }
  if (rules < report.clearance_rules.size())
    text += fmt::format("; and by {}", counted(report.clearance_rules.size() - rules, "more rule"));
  return text + ".\n";
}

/// Why a pair has no depth.
std::string depth_refusal(std::span<const TableObject> objects, const ReportedPair& pair) {
  const PairCell cell = pair_cell(ShapeQuestion::penetration, objects[pair.a].kind, objects[pair.b].kind);
  return fmt::format("no depth: {}\n", cell.state == PairState::defined ? pair_cells::surface.text : cell.text);
}

std::string region_line(const ContactRegion& region) {
  const std::string depth = region.depth ? ", " + depth_text(region.depth->lower, region.depth->upper) : "";
  return fmt::format("      region of {} at {}, area {:.6g}{}, normal {}\n",
                     counted(region.face_pairs, "pair of faces", "pairs of faces"), point_text(region.deepest),
                     region.area, depth, point_text(region.normal));
}

/// The deepest few; JSON lists all.
std::string region_lines(const std::vector<ContactRegion>& regions) {
  const std::size_t shown = std::min(regions.size(), most_listed);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) text += region_line(regions[i]);
  if (shown < regions.size())
    text += fmt::format("      … and {}; --json lists all\n", counted(regions.size() - shown, "more region"));
  return text;
}

std::string point_line(const std::string& what, const Manifold& manifold, int i, const char* of_what = "") {
  const ManifoldPoint& point = manifold.points[static_cast<std::size_t>(i)];
  return fmt::format("      {} at {}, depth{} {:.6g}, normal {}\n", what, point_text(point.position), of_what,
                     point.depth, point_text(manifold.normal));
}

/// The points of the first few elements that meet; JSON lists all.
std::string element_lines(const std::vector<ContactManifold>& manifolds) {
  const std::size_t shown = std::min(manifolds.size(), most_listed);
  std::string text;
  for (std::size_t k = 0; k < shown; ++k) {
    const ContactManifold& one = manifolds[k];
    const std::string what = fmt::format("faces {} and {} in contact", one.contact.face_a, one.contact.face_b);
    for (int i = 0; i < one.manifold.count; ++i) text += point_line(what, one.manifold, i, " of these two alone");
  }
  if (shown < manifolds.size())
    text += fmt::format("      … and {} in contact; --json lists all\n",
                        counted(manifolds.size() - shown, "more pair of elements", "more pairs of elements"));
  return text;
}

/// How deep they overlap, and a line for each point and region of contact. `b` is the name of the second.
std::string depth_lines(std::span<const TableObject> objects, const ReportedPair& pair, const std::string& b) {
  if (pair.relation.kind == RelationKind::apart) return {};
  std::string text = "      " + (pair.penetration ? depth_text(*pair.penetration, pair.depth_end, b) + "\n"
                                                  : depth_refusal(objects, pair));
  if (pair.manifold)
    for (int i = 0; i < pair.manifold->count; ++i) text += point_line("contact", *pair.manifold, i);
  return text + element_lines(pair.manifolds) + region_lines(pair.regions);
}

/// A line for the pair, and what is told below it.
std::string pair_text(std::span<const TableObject> objects, const CheckReport& report,
                      const std::vector<std::string>& row, const ReportedPair& pair) {
  const bool is_apart = pair.relation.kind == RelationKind::apart;
  std::string text = columns({row}, 2);
  if (report.has_volume && !is_apart && pair.relation.kind != RelationKind::touching) text += volume_line(pair);
  if (report.has_penetration) text += depth_lines(objects, pair, row[row.size() - 2]);
  if (report.has_faces && !is_apart) text += face_lines(pair.face_pairs);
  return text;
}

std::string group_heading(const std::vector<std::string>& names, const ClashGroup& group) {
  const std::string what =
      group.part ? names[*group.part] : "at " + point_text(0.5 * group.place.lower + 0.5 * group.place.upper);
  return fmt::format("{}: {}\n", what, counted(group.pairs.size(), "pair"));
}

std::string pair_lines(const Scene& scene, std::span<const TableObject> objects, const CheckReport& report) {
  const std::vector<std::string> names = table_names(scene.objects);
  std::vector<std::vector<std::string>> rows;
  for (const ReportedPair& pair : report.pairs) rows.push_back(row_of(names, pair, report));
  const bool is_plain = !report.has_faces && !report.has_penetration && !report.has_volume;
  const auto lines_of = [&](const std::vector<std::size_t>& pairs) {
    std::vector<std::vector<std::string>> listed;
    std::string text;
    for (const std::size_t i : pairs) {
      listed.push_back(rows[i]);
      if (!is_plain) text += pair_text(objects, report, rows[i], report.pairs[i]);
    }
    return is_plain ? columns(listed, 2) : text;
  };
  std::string text;
  for (const ClashGroup& group : report.groups) text += group_heading(names, group) + lines_of(group.pairs);
  if (report.grouping != ClashGrouping::none) return text;
  std::vector<std::size_t> all(rows.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return lines_of(all);
}

/// As the tolerance was understood, and how many are within it.
std::string tolerance_lines(const Scene& scene, const CheckReport& report) {
  const auto count = [&](ToleranceVerdict verdict) {
    return static_cast<std::size_t>(std::count_if(report.pairs.begin(), report.pairs.end(),
                                                  [&](const ReportedPair& pair) { return pair.tolerance == verdict; }));
  };
  const std::size_t within = count(ToleranceVerdict::within);
  const auto by_place =
      static_cast<std::size_t>(std::count_if(report.pairs.begin(), report.pairs.end(), [](const ReportedPair& pair) {
        return pair.tolerance == ToleranceVerdict::within && pair.local_depth;
      }));
  std::string text =
      fmt::format("{} within {}", within == 0 ? "No pair is" : counted(within, "pair"),
                  *report.tolerance > 0 ? "the tolerance of " + length_text(*report.tolerance, scene.unit)
                                        : std::string("a tolerance"));
  if (within == 0) text += ", by its deepest place or by what parts the two";
  if (within > 0)
    text += fmt::format(": {} by the deepest place, {} by what parts the two: no clash", by_place, within - by_place);
  if (const std::size_t undecided = count(ToleranceVerdict::undecided); undecided > 0)
    text += fmt::format("; of {} that could not be decided", counted(undecided, "pair"));
  return text + ".\n";
}

bool tells_lengths(const CheckReport& report) {
  return report.has_penetration || report.has_volume || report.tolerance || report.clearance;
}

}  // namespace

std::string scaling_line(const LoadedScene& loaded) {
  if (loaded.scaled_by.empty()) return {};
  return fmt::format(
      "Coordinates were multiplied by {} and rounded: slanted faces that touch in the files may be apart or overlap by "
      "a last digit.\n",
      loaded.scaled_by);
}

std::vector<TableObject> table_objects(const Scene& scene) {
  std::vector<TableObject> objects;
  for (const SceneObject& object : scene.objects) {
    const auto mesh = object.mesh();
    objects.push_back({kind_of(object.shape), mesh ? mesh->triangle_count() : 0});
  }
  return objects;
}

std::size_t triangle_count(std::span<const TableObject> objects) {
  std::size_t count = 0;
  for (const TableObject& object : objects) count += object.triangles;
  return count;
}

std::string face_lines(const std::vector<ReportedFacePair>& pairs) {
  if (pairs.empty()) return "      no faces meet\n";
  std::vector<std::vector<std::string>> rows;
  const std::size_t shown = std::min(pairs.size(), most_listed);
  for (std::size_t i = 0; i < shown; ++i) {
    const ReportedFacePair& faces = pairs[i];
    if (faces.intersections.empty())  // with a shape that is no mesh
      rows.push_back({fmt::format("face {}", faces.face_a), fmt::format("face {}", faces.face_b), "meet", ""});
    for (const ReportedIntersection& intersection : faces.intersections)
      rows.push_back({fmt::format("face {}", faces.face_a), fmt::format("face {}", faces.face_b),
                      (faces.crossing ? "cross in a " : "touch in a ") + name_of(intersection.kind),
                      points_text(intersection)});
  }
  std::string text = columns(rows, 6);
  if (shown < pairs.size())
    text +=
        fmt::format("      … and {} of faces; --json and --csv list all\n", counted(pairs.size() - shown, "more pair"));
  return text;
}

std::string check_table(const Scene& scene, const CheckReport& report) {
  return check_table(scene, table_objects(scene), report);
}

std::string check_table(const Scene& scene, std::span<const TableObject> objects, const CheckReport& report) {
  const auto near =
      static_cast<std::size_t>(std::count_if(report.pairs.begin(), report.pairs.end(), [](const ReportedPair& pair) {
        return pair.relation.kind == RelationKind::apart;
      }));
  const auto undecided =
      static_cast<std::size_t>(std::count_if(report.pairs.begin(), report.pairs.end(), [](const ReportedPair& pair) {
        const bool may_be_neither =
            pair.relation.kind == RelationKind::touching || pair.relation.kind == RelationKind::apart;
        return (may_be_neither || pair.winding) && pair.relation.status != Status::exact;
      }));
  std::string text = fmt::format("{} with {}; the bounding boxes of {} overlap{}.\n",
                                 counted(scene.objects.size(), "object"), counted(triangle_count(objects), "triangle"),
                                 counted(report.candidate_pairs, "pair"), report.clearance ? " or are as near" : "");
  if (report.clearance) text += clearance_line(scene, report);
  if (report.pairs.empty())
    text += std::string(report.unfinished > 0 ? "Nothing of what was looked at collides" : "Nothing collides") +
            (report.clearance ? " or is nearer than its clearance" : "") +
            (report.ignored_touching > 0 ? " beyond touching.\n" : ".\n");
  else
    text += pair_lines(scene, objects, report) +
            fmt::format("{} in contact{}, {}.\n", counted(report.pairs.size() - near, "pair"),
                        report.clearance ? fmt::format(" and {} not farther apart than asked", near) : "",
                        decided_text(undecided));
  if (report.ignored_touching > 0)
    text += fmt::format("{} merely touching, ignored as asked.\n", counted(report.ignored_touching, "pair"));
  if (report.unfinished > 0)
    text += fmt::format("Stopped: {} not looked at; what is told is right, and not all.\n",
                        counted(report.unfinished, "pair"));
  if (report.tolerance) text += tolerance_lines(scene, report);
  if (report.left_out.value_or(0) > 0)
    text += fmt::format("{} left out by rules, not looked at.\n", counted(*report.left_out, "pair"));
  if (report.baseline) text += baseline_lines(report);
  if (!report.pairs.empty() && tells_lengths(report) && scene.unit != "unit")
    text += fmt::format("Lengths and places are in {}.\n", scene.unit);
  return text;
}

}  // namespace toccata::command
