#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "io/formats/utf8.hpp"
#include "reports/glb/glb_findings.hpp"
#include "reports/questions/asked_of.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "reports/view/finding_layers.hpp"
#include "reports/view/pair_methods.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

io::Json json_of(const Region& region) {
  if (const auto* ball = std::get_if<Ball>(&region))
    return {{"centre", io::json_of(ball->centre)}, {"radius", ball->radius}};
  const Aabb& box = std::get<Aabb>(region);
  return {{"lower", io::json_of(box.lower)}, {"upper", io::json_of(box.upper)}};
}

/// A face of the file, and which of its triangles were found.
struct FoundFace {
  Index object = 0;
  Index face = 0;
  std::span<const FoundElement> elements;
};

std::vector<FoundFace> by_face(std::span<const ReportedFaces> reported) {
  std::vector<FoundFace> faces;
  for (const ReportedFaces& of_object : reported) {
    const std::span<const FoundElement> found = of_object.found;
    for (std::size_t begin = 0, end = 0; begin < found.size(); begin = end) {
      while (end < found.size() && found[end].face == found[begin].face) ++end;
      faces.push_back({of_object.object, found[begin].face, found.subspan(begin, end - begin)});
    }
  }
  return faces;
}

std::string line_of(const Scene& scene, const FoundFace& face) {
  io::Json triangles = io::Json::array();
  for (const FoundElement& one : face.elements) triangles.push_back(one.element);
  return io::line_of({{"object", io::as_utf8(scene.objects[face.object].name)},
                      {"object_index", face.object},
                      {"face", face.face},
                      {"triangles", triangles}});
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

struct FacesKind {
  using Question = FacesQuestion;
  using Report = FacesReport;
  static constexpr const char* name = "faces";

  static io::Json write(const FacesQuestion& q) {
    std::vector<double> numbers;
    if (const auto* ball = std::get_if<Ball>(&q.region)) {
      io::append(numbers, ball->centre);
      numbers.push_back(ball->radius);
      return {{"ball", numbers}};
    }
    io::append(numbers, std::get<Aabb>(q.region).lower);
    io::append(numbers, std::get<Aabb>(q.region).upper);
    return {{"box", numbers}};
  }

  static FacesQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "box", "ball"});
    if (value.has("box") == value.has("ball")) value.fail("a region is a box or a ball", "write one of the two");
    if (value.has("ball")) {
      const std::vector<double> n = value.at("ball").numbers(4);
      return FacesQuestion{Ball{io::vector_at(n, 0), n[3]}};
    }
    const std::vector<double> n = value.at("box").numbers(6);
    return FacesQuestion{Aabb{io::vector_at(n, 0), io::vector_at(n, 3)}};
  }

  static FacesReport ask(const FacesQuestion& question, const io::Asking& asking) {
    FacesReport report{question.region, {}};
    Workspace workspace;
    for (std::size_t i = 0; i < asking.models.size(); ++i) {
      const SceneInstance& posed = asking.models[i];
      const auto here = io::asked_of(
          posed.name, [&] { return faces_in_region(question.region, posed.model, posed.pose, workspace); });
      if (!here.empty()) report.found.push_back({static_cast<Index>(i), {here.begin(), here.end()}});
    }
    return report;
  }

  static std::string json(const FacesReport& report, const io::Reporting& reporting) {
    io::Json head = reporting.head("toccata/faces/1");
    head["region"] = json_of(report.region);
    const std::vector<FoundFace> faces = by_face(report.found);
    return io::with_list(io::document(head), "faces", faces.size(),
                         [&](std::size_t i) { return line_of(reporting.scene, faces[i]); });
  }

  static std::string csv(const FacesReport& report, const Scene& scene) {
    std::string csv = "object,face,triangles\n";
    for (const FoundFace& face : by_face(report.found))
      csv += fmt::format("{},{},{}\n", io::csv_field(io::as_utf8(scene.objects[face.object].name)), face.face,
                         face.elements.size());
    return csv;
  }

  static void mark(const FacesReport& report, io::LayerWriter& layers) {
    if (const auto* ball = std::get_if<Ball>(&report.region))
      layers.add_segments("region", circles_of(*ball));
    else
      layers.add_box("region", std::get<Aabb>(report.region).lower, std::get<Aabb>(report.region).upper);
    for (std::size_t i = 0; i < report.found.size(); ++i) {
      layers.begin(i);
      layers.add_faces("within", report.found[i].object, distinct_faces(report.found[i].found));
    }
  }

  static io::Json words(const FacesReport& report, io::PairMethods&) {
    io::Json words = io::Json::array();
    for (const ReportedFaces& found : report.found)
      words.push_back(
          {{"object", found.object}, {"faces", distinct_faces(found.found).size()}, {"triangles", found.found.size()}});
    return words;
  }

  static void show(const FacesReport& report, io::GlbFindings& nodes) {
    for (const ReportedFaces& found : report.found) {
      const std::vector<Index> faces = distinct_faces(found.found);
      nodes.add_node(
          "faces of " + nodes.glb().name_of(found.object),
          std::vector<io::Shown>{{nodes.corners(found.object, faces), io::GlbMode::triangles, io::first_faces}},
          {{"faces", faces.size()}});
    }
    nodes.glb().add_group("faces", nodes.nodes());
  }

  static std::vector<io::NamedObjects> named(const FacesReport& report) {
    std::vector<io::NamedObjects> named;
    for (const ReportedFaces& found : report.found) named.push_back({found.object, found.object});
    return named;
  }

  static void leave_out_drawn(FacesReport& report) { report.found.clear(); }
};

}  // namespace

constinit const io::QuestionKind FacesQuestion::kind = io::question_kind<FacesKind>();

}  // namespace toccata
