#include "toccata/io/report.hpp"

#include <fmt/format.h>

#include "io/formats/utf8.hpp"
#include "io/reports/report_parts.hpp"

namespace toccata {

using io::Json;

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

}  // namespace

std::string faces_report_json(const Scene& scene, std::span<const SceneInstance> models, const Region& region,
                              std::span<const ReportedFaces> found, std::span<const std::string> warnings) {
  io::Json head = io::report_head("toccata/faces/1", scene, models, warnings);
  head["region"] = json_of(region);
  const std::vector<FoundFace> faces = by_face(found);
  return io::with_list(io::document(head), "faces", faces.size(),
                       [&](std::size_t i) { return line_of(scene, faces[i]); });
}

std::string faces_report_csv(const Scene& scene, std::span<const ReportedFaces> found) {
  std::string csv = "object,face,triangles\n";
  for (const FoundFace& face : by_face(found))
    csv += fmt::format("{},{},{}\n", io::csv_field(io::as_utf8(scene.objects[face.object].name)), face.face,
                       face.elements.size());
  return csv;
}

}  // namespace toccata
