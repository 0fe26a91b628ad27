#include <fmt/format.h>

#include <algorithm>

#include "io/formats/utf8.hpp"
#include "reports/glb/glb_findings.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "reports/view/finding_layers.hpp"
#include "reports/view/pair_methods.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

std::string line_of(const ReportedDistance& pair, const Scene& scene) {
  io::Json line = {{"a", io::as_utf8(scene.objects[pair.a].name)},
                   {"b", io::as_utf8(scene.objects[pair.b].name)},
                   {"a_index", pair.a},
                   {"b_index", pair.b}};
  io::add(line, pair.distance);
  return io::line_of(line);
}

std::string line_of(const DistancePosesReport& report, std::size_t i) {
  io::Json line = {{"query", i}};
  io::add(line, report.distances[i]);
  line["pose_a"] = report.queries[i].pose_a.numbers();
  line["pose_b"] = report.queries[i].pose_b.numbers();
  return io::line_of(line);
}

Distance distance_between(const SceneInstance& a, const SceneInstance& b, Workspace& workspace) {
  try {
    return distance(a.model, b.model, {a.pose, b.pose, a.solid, b.solid}, workspace);
  } catch (const Error& error) {
    throw Error(fmt::format("'{}' (a) and '{}' (b): {}", a.name, b.name, error.what()));
  }
}

struct DistanceKind {
  using Question = DistanceQuestion;
  using Report = DistanceReport;
  static constexpr const char* name = "distance";

  static io::Json write(const DistanceQuestion& q) { return {{"first_objects", q.first_objects}}; }

  static DistanceQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "first_objects"});
    return DistanceQuestion{value.whole_or("first_objects", std::numeric_limits<Index>::max(), 0)};
  }

  static DistanceReport ask(const DistanceQuestion& question, const io::Asking& asking) {
    const bool two_sides = question.first_objects > 0;
    const std::size_t first_end =
        two_sides ? std::min(question.first_objects, asking.models.size()) : asking.models.size();
    std::vector<std::vector<ReportedDistance>> of_first(first_end);
    parallel_for(first_end, asking.options.threads, [&](std::size_t i) {
      Workspace workspace;
      for (std::size_t j = two_sides ? first_end : i + 1; j < asking.models.size(); ++j)
        if (!io::in_one_group(asking.models[i], asking.models[j]))
          of_first[i].push_back({static_cast<Index>(i), static_cast<Index>(j),
                                 distance_between(asking.models[i], asking.models[j], workspace)});
    });
    DistanceReport report;
    for (const auto& some : of_first) report.pairs.insert(report.pairs.end(), some.begin(), some.end());
    return report;
  }

  static std::string json(const DistanceReport& report, const io::Reporting& reporting) {
    return io::with_list(io::document(reporting.head("toccata/distance/1")), "pairs", report.pairs.size(),
                         [&](std::size_t i) { return line_of(report.pairs[i], reporting.scene); });
  }

  static std::string csv(const DistanceReport& report, const Scene& scene) {
    std::string csv = std::string("a,b") + io::csv_distance_names + "\n";
    for (const ReportedDistance& pair : report.pairs)
      csv += io::csv_field(io::as_utf8(scene.objects[pair.a].name)) + "," +
             io::csv_field(io::as_utf8(scene.objects[pair.b].name)) + io::csv_of(pair.distance) + "\n";
    return csv;
  }

  static void mark(const DistanceReport& report, io::LayerWriter& layers) {
    for (std::size_t i = 0; i < report.pairs.size(); ++i) {
      layers.begin(i);
      io::add_distance(layers, report.pairs[i].distance);
    }
  }

  static io::Json words(const DistanceReport& report, io::PairMethods& methods) {
    io::Json words = io::Json::array();
    for (const ReportedDistance& pair : report.pairs)
      words.push_back({{"methods", {{"distance", methods.number_of(ShapeQuestion::distance, pair.a, pair.b)}}}});
    return words;
  }

  static void show(const DistanceReport& report, io::GlbFindings& nodes) {
    for (const ReportedDistance& pair : report.pairs) nodes.add_distance({pair.a, pair.b}, pair.distance);
    nodes.glb().add_group("pairs", nodes.nodes());
  }

  static std::vector<io::NamedObjects> named(const DistanceReport& report) {
    std::vector<io::NamedObjects> named;
    for (const ReportedDistance& pair : report.pairs) named.push_back({pair.a, pair.b});
    return named;
  }
};

struct DistancePosesKind {
  using Question = DistancePosesQuestion;
  using Report = DistancePosesReport;
  static constexpr const char* name = "distance-poses";

  static io::Json write(const DistancePosesQuestion& q) {
    io::Json json = io::Json::object();
    io::add_queries(json, q.queries);
    return json;
  }

  static DistancePosesQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "poses", "solid"});
    return DistancePosesQuestion{io::queries_read_from(value)};
  }

  static DistancePosesReport ask(const DistancePosesQuestion& question, const io::Asking& asking) {
    asking.require_two();
    return DistancePosesReport{
        question.queries,
        distance_each({asking.models[0].model, asking.models[1].model, question.queries}, asking.batch())};
  }

  static std::string json(const DistancePosesReport& report, const io::Reporting& reporting) {
    io::Json head = reporting.head("toccata/distance-poses/2");
    head["intersecting"] = intersecting_count(report);
    return io::with_list(io::document(head), "queries", report.queries.size(),
                         [&](std::size_t i) { return line_of(report, i); });
  }

  static std::string csv(const DistancePosesReport& report, const Scene&) {
    std::string csv = std::string("query") + io::csv_distance_names + "\n";
    for (std::size_t i = 0; i < report.distances.size(); ++i)
      csv += fmt::format("{}", i) + io::csv_of(report.distances[i]) + "\n";
    return csv;
  }

  static void mark(const DistancePosesReport& report, io::LayerWriter& layers) {
    for (std::size_t i = 0; i < report.queries.size(); ++i) {
      layers.begin(i);
      io::add_distance(layers, report.distances[i]);
    }
  }

  static io::Json words(const DistancePosesReport& report, io::PairMethods& methods) {
    const io::Json entry = {{"methods", {{"distance", methods.number_of(ShapeQuestion::distance, 0, 1)}}}};
    return io::Json(report.distances.size(), entry);
  }

  static void show(const DistancePosesReport& report, io::GlbFindings& nodes) {
    std::vector<std::size_t> at_poses;
    for (std::size_t i = 0; i < report.distances.size(); ++i) {
      if (report.distances[i].upper == 0) continue;
      nodes.add_distance({0, 1}, report.distances[i]);
      at_poses.push_back(nodes.at_pose(i, report.queries.size()));
    }
    nodes.glb().add_group("poses", at_poses);
  }
};

}  // namespace

std::size_t intersecting_count(const DistancePosesReport& report) {
  return static_cast<std::size_t>(
      std::count_if(report.distances.begin(), report.distances.end(), [](const Distance& d) { return d.upper == 0; }));
}

constinit const io::QuestionKind DistanceQuestion::kind = io::question_kind<DistanceKind>();
constinit const io::QuestionKind DistancePosesQuestion::kind = io::question_kind<DistancePosesKind>();

}  // namespace toccata
