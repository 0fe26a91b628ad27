#include "toccata/io/report.hpp"

#include <vector>

#include "io/formats/utf8.hpp"
#include "io/reports/report_parts.hpp"

namespace toccata {

using io::Json;

namespace {

const char* name_of_kind(SumFaceKind kind) {
  constexpr const char* names[] = {"of a", "of b", "of both", "of edges"};
  return names[static_cast<std::size_t>(kind)];
}

std::string vertex_line(const MinkowskiSum& sum, Index i) {
  return io::line_of(
      {{"on_a", sum.pair(i).on_a}, {"on_b", sum.pair(i).on_b}, {"position", io::json_of(sum.vertex(i))}});
}

std::string face_line(const MinkowskiSum& sum, const HullTopology& topology, Index f) {
  const std::vector<Index> vertices(topology.origin.begin() + topology.face_start[f],
                                    topology.origin.begin() + topology.face_start[f + 1]);
  return io::line_of({{"kind", name_of_kind(sum.face_kind(f))}, {"vertices", vertices}});
}

}  // namespace

std::string name_of(const MinkowskiQuestion& question) { return question.difference ? "A − B" : "A + B"; }

std::string name_of_side(Sign side) {
  return side == Sign::negative ? "inside" : side == Sign::zero ? "boundary" : "outside";
}

SceneObject sum_object(const MinkowskiReport& report) {
  SceneObject object;
  object.name = name_of(report.question);
  object.shape = report.sum.as_shape();
  object.source = "computed";
  return object;
}

std::string minkowski_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                  const MinkowskiReport& report, std::span<const std::string> warnings) {
  const MinkowskiSum& sum = report.sum;
  io::Json json = io::report_head("toccata/minkowski/1", scene, models, warnings);
  json["operation"] = report.question.difference ? "difference" : "sum";
  json["a"] = io::as_utf8(report.a);
  json["b"] = io::as_utf8(report.b);
  json["dimension"] = sum.dimension();
  json["radius"] = sum.radius();
  if (const auto& point = report.question.point)
    json["point"] = {{"position", io::json_of(*point)}, {"side", name_of_side(sum.side_of(*point))}};
  const HullTopology topology = sum.topology();
  const std::size_t faces = sum.dimension() > 1 ? topology.face_count() : 0;
  const std::string with_vertices =
      io::with_list(io::document(json), "vertices", sum.vertex_count(),
                    [&](std::size_t i) { return vertex_line(sum, static_cast<Index>(i)); });
  return io::with_list(with_vertices, "faces", faces,
                       [&](std::size_t f) { return face_line(sum, topology, static_cast<Index>(f)); });
}

}  // namespace toccata
