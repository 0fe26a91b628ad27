#include <fmt/format.h>

#include <optional>
#include <type_traits>
#include <vector>

#include "io/formats/utf8.hpp"
#include "reports/questions/asked_of.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
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

/// The hull that a mesh stands for.
ConvexHull hull_of(const TriangleMesh& mesh, bool of_any) {
  if (of_any) return ConvexHull(mesh.vertices());
  try {
    return hull_of_convex_mesh(mesh);
  } catch (const Error& error) {
    throw Error(fmt::format("{}; --hull takes its convex hull (MinkowskiQuestion::hulls)", error.what()));
  }
}

/// Keeps the hull that a posed shape refers to.
class Operand {
 public:
  Operand(const SceneInstance& posed, bool hull_of_any)
      : posed_(io::asked_of(posed.name, [&] { return convex_of(posed, hull_of_any); })) {}
  Operand(const Operand&) = delete;
  Operand& operator=(const Operand&) = delete;
  [[nodiscard]] const PosedPolytope& convex() const { return posed_; }

 private:
  [[nodiscard]] PosedPolytope convex_of(const SceneInstance& posed, bool hull_of_any) {
    if (const auto mesh = mesh_of(posed.model.shape())) {
      hull_ = hull_of(*mesh, hull_of_any);
      return PosedPolytope(*hull_, posed.pose);
    }
    return std::visit(
        [&](const auto& shape) -> PosedPolytope {
          if constexpr (std::is_constructible_v<PosedPolytope, decltype(shape), const Pose&>)
            return PosedPolytope(shape, posed.pose);
          else
            throw Error(fmt::format("a {} has no sum here; give bounded convex shapes, or a mesh",
                                    name_of(posed.model.shape())));
        },
        posed.model.shape());
  }

  std::optional<ConvexHull> hull_;
  PosedPolytope posed_;
};

struct MinkowskiKind {
  using Question = MinkowskiQuestion;
  using Report = MinkowskiReport;
  static constexpr const char* name = "minkowski";

  static io::Json write(const MinkowskiQuestion& q) {
    io::Json json = {{"difference", q.difference}, {"hulls", q.hulls}};
    if (q.point) json["point"] = {q.point->x, q.point->y, q.point->z};
    return json;
  }

  static MinkowskiQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "difference", "hulls", "point"});
    MinkowskiQuestion q{value.flag_or("difference", false), value.flag_or("hulls", false)};
    if (value.has("point")) q.point = io::vector_at(value.at("point").numbers(3), 0);
    return q;
  }

  static MinkowskiReport ask(const MinkowskiQuestion& question, const io::Asking& asking) {
    if (asking.models.size() != 2)
      throw Error(fmt::format("a sum is of two objects, A and B; here {} {}", asking.models.size() == 1 ? "is" : "are",
                              asking.models.size()));
    const Operand a(asking.models[0], question.hulls), b(asking.models[1], question.hulls);
    return {question, asking.models[0].name, asking.models[1].name,
            question.difference ? minkowski_difference(a.convex(), b.convex()) : minkowski_sum(a.convex(), b.convex())};
  }

  static std::string json(const MinkowskiReport& report, const io::Reporting& reporting) {
    const MinkowskiSum& sum = report.sum;
    io::Json json = reporting.head("toccata/minkowski/1");
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
};

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

constinit const io::QuestionKind MinkowskiQuestion::kind = io::question_kind<MinkowskiKind>();

}  // namespace toccata
