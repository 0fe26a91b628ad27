#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/no_index.hpp"
#include "io/formats/utf8.hpp"
#include "reports/questions/asked_of.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "reports/report_parts.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

/// What is asked for where the question does not say it, as shares of the diagonal of the cage's box.
constexpr double mesh_share = 1e-3;
constexpr double gap_share = 1e-6;

/// A comparison of faces takes about as long as it takes to make so many triangles.
constexpr std::size_t triangles_of_a_comparison = 8;

constexpr std::array<const char*, 2> scheme_words{"loop", "catmull-clark"};

const char* word_of(SubdivisionScheme scheme) { return scheme_words[static_cast<std::size_t>(scheme)]; }

SubdivisionScheme scheme_of(const io::JsonValue& value) {
  const std::string word = value.text();
  if (word != scheme_words[0] && word != scheme_words[1])
    value.fail("there is no scheme " + word, "write loop or catmull-clark");
  return word == scheme_words[0] ? SubdivisionScheme::loop : SubdivisionScheme::catmull_clark;
}

/// Sharp for ever is the number from which on it is so.
double finite_sharpness(double sharpness) { return std::min(sharpness, sharp_for_ever); }

io::Json json_of_creases(const CageFeatures& features) {
  io::Json list = io::Json::array();
  for (const CageCrease& crease : features.creases)
    list.push_back({crease.first, crease.second, finite_sharpness(crease.sharpness)});
  return list;
}

io::Json json_of_corners(const CageFeatures& features) {
  io::Json list = io::Json::array();
  for (const CageCorner& corner : features.corners) list.push_back({corner.vertex, finite_sharpness(corner.sharpness)});
  return list;
}

Index vertex_number(const io::JsonValue& value, double number) {
  if (!(number >= 0 && number < no_index && std::floor(number) == number))
    value.fail(fmt::format("{:g} is no number of a vertex", number), "count vertices from 0");
  return static_cast<Index>(number);
}

CageFeatures features_of(const io::JsonValue& value) {
  CageFeatures features;
  for (const io::JsonValue& crease : value.elements("creases")) {
    const std::vector<double> n = crease.numbers(3);
    features.creases.push_back({vertex_number(crease, n[0]), vertex_number(crease, n[1]), n[2]});
  }
  for (const io::JsonValue& corner : value.elements("corners")) {
    const std::vector<double> n = corner.numbers(2);
    features.corners.push_back({vertex_number(corner, n[0]), n[1]});
  }
  features.border = value.flag_or("sharp_corners", false) ? CageBorder::sharp_corner : CageBorder::smooth;
  return features;
}

/// The cage as it is in the world, so that lengths are those of the question.
SubdivisionCage cage_of(const SceneInstance& posed, const SubdivideQuestion& question, CageFeatures features) {
  if (!posed.model.has_mesh())
    throw Error(
        fmt::format("a {} is no cage: give a mesh, whose faces are those of the cage", name_of(posed.model.shape())));
  features.border = question.features.border;
  const auto cage = SubdivisionCage::of_mesh(posed.model.mesh(), question.scheme, std::move(features));
  if (!question.crease_angle) return cage.posed(posed.pose);
  CageFeatures with_angles = cage.features();
  for (const CageCrease& crease : creases_by_angle(cage.polygons(), *question.crease_angle))
    with_angles.creases.push_back(crease);
  return SubdivisionCage(cage.polygons(), question.scheme, std::move(with_angles)).posed(posed.pose);
}

double diagonal_of(const SubdivisionCage& cage) {
  const Aabb box = fit_aabb(cage.polygons().vertices);
  return length(box.upper - box.lower);
}

LimitDistance gap_of(const SubdivisionCage& cage, const SubdivideQuestion& question, double within,
                     const io::Asking& asking) {
  const std::span<const SceneInstance> models = asking.models;
  LimitQuery query{.tolerance = within, .max_faces = question.max_triangles};
  query.max_comparisons = question.max_triangles / triangles_of_a_comparison;
  query.progress = asking.options.progress;
  query.pair.solid_a = models[0].solid;
  query.pair.solid_b = models[1].solid;
  if (question.both)
    return distance(cage, io::asked_of(models[1].name, [&] { return cage_of(models[1], question, {}); }), query);
  query.pair.pose_b = models[1].pose;
  return distance(cage, models[1].model, query);
}

io::Json json_of(const LimitDistance& gap) {
  return {{"lower", gap.lower},
          {"upper", gap.upper},
          {"on_mesh", io::json_of(gap.on_mesh)},
          {"on_other", io::json_of(gap.on_model)},
          {"distance_to_limit", gap.distance_to_limit},
          {"cage_face", gap.cage_face},
          {"element", gap.element},
          {"level", gap.level},
          {"status", name_of(gap.status)}};
}

std::string triangle_line(const SubdividedMesh& mesh, Index triangle) {
  return io::line_of({{"vertices", mesh.mesh.triangles()[triangle]},
                      {"cage_face", mesh.mesh.face_of(triangle)},
                      {"distance_to_limit", mesh.triangle_distances[triangle]}});
}

struct SubdivideKind {
  using Question = SubdivideQuestion;
  using Report = SubdivideReport;
  static constexpr const char* name = "subdivide";

  static io::Json write(const SubdivideQuestion& q) {
    io::Json json = {{"scheme", word_of(q.scheme)},
                     {"within", q.within},
                     {"levels", q.levels},
                     {"max_triangles", q.max_triangles},
                     {"both", q.both},
                     {"sharp_corners", q.features.border == CageBorder::sharp_corner}};
    if (!q.features.creases.empty()) json["creases"] = json_of_creases(q.features);
    if (!q.features.corners.empty()) json["corners"] = json_of_corners(q.features);
    if (q.crease_angle) json["crease_angle"] = *q.crease_angle;
    return json;
  }

  static SubdivideQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "scheme", "within", "levels", "max_triangles", "both", "sharp_corners", "creases",
                       "corners", "crease_angle"});
    SubdivideQuestion q;
    if (value.has("scheme")) q.scheme = scheme_of(value.at("scheme"));
    if (value.has("within")) q.within = value.at("within").number();
    q.levels = static_cast<int>(value.whole_or("levels", 30, 0));
    q.max_triangles = value.whole_or("max_triangles", std::size_t{1} << 40, q.max_triangles);
    q.both = value.flag_or("both", false);
    q.features = features_of(value);
    if (value.has("crease_angle")) q.crease_angle = value.at("crease_angle").number();
    return q;
  }

  static SubdivideReport ask(const SubdivideQuestion& question, const io::Asking& asking) {
    if (asking.models.empty() || asking.models.size() > 2)
      throw Error(
          fmt::format("a cage is subdivided, or asked about together with one other object; here are {} objects",
                      asking.models.size()));
    const std::string& name = asking.models[0].name;
    const bool is_alone = asking.models.size() == 1;
    const SubdivisionCage cage =
        io::asked_of(name, [&] { return cage_of(asking.models[0], question, question.features); });
    SubdivideReport report{.question = question, .cage = name};
    report.faces = cage.polygons().first.size() - 1;
    report.closed = cage.closed();
    report.within = question.within != 0 ? question.within : (is_alone ? mesh_share : gap_share) * diagonal_of(cage);
    if (is_alone)
      report.mesh = io::asked_of(name, [&] {
        return refine(cage, {report.within, question.levels, question.max_triangles, asking.options.progress});
      });
    else
      report.gap = gap_of(cage, question, report.within, asking);
    return report;
  }

  static std::string json(const SubdivideReport& report, const io::Reporting& reporting) {
    io::Json json = reporting.head("toccata/subdivide/1");
    json["cage"] = {{"name", io::as_utf8(report.cage)}, {"faces", report.faces}, {"closed", report.closed}};
    json["within"] = report.within;
    if (report.gap) json["gap"] = json_of(*report.gap);
    if (!report.mesh) return io::document(json);
    const SubdividedMesh& mesh = *report.mesh;
    json["distance_to_limit"] = mesh.distance_to_limit;
    json["deepest_level"] = mesh.deepest_level;
    json["status"] = name_of(mesh.status);
    const std::string with_vertices =
        io::with_list(io::document(json), "vertices", mesh.mesh.vertices().size(),
                      [&](std::size_t i) { return io::line_of(io::json_of(mesh.mesh.vertices()[i])); });
    return io::with_list(with_vertices, "triangles", mesh.mesh.triangle_count(),
                         [&](std::size_t i) { return triangle_line(mesh, static_cast<Index>(i)); });
  }
};

}  // namespace

SceneObject limit_object(const SubdivideReport& report) {
  SceneObject object;
  object.name = report.cage + "-limit";
  object.shape = std::make_shared<const TriangleMesh>(report.mesh.value().mesh);
  object.source = "subdivision";
  return object;
}

constinit const io::QuestionKind SubdivideQuestion::kind = io::question_kind<SubdivideKind>();

}  // namespace toccata
