#include "shape_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <variant>
#include <vector>

#include "words.hpp"

namespace toccata::command {
namespace {

constexpr Index most_vertices = 8;  // JSON lists all

std::string vertices_text(const ConvexHull& hull) {
  std::string text;
  for (Index i = 0; i < std::min(hull.vertex_count(), most_vertices); ++i)
    text += (i == 0 ? "" : ", ") + point_text(hull.vertex(i));
  return text + (hull.vertex_count() > most_vertices ? ", …" : "");
}

std::string text_of(const ConvexHull& hull) {
  const std::size_t edges = hull.topology().origin.size() / 2;
  const std::string size =
      hull.dimension() == 3
          ? fmt::format("with {}, {} and {}", counted(hull.vertex_count(), "vertex", "vertices"),
                        counted(edges, "edge"), counted(hull.topology().face_count(), "face"))
          : fmt::format("without an interior, of {}", counted(hull.vertex_count(), "vertex", "vertices"));
  return fmt::format("convex hull {}: {}", size, vertices_text(hull));
}

std::string text_of(double number) { return fmt::format("{:.6g}", number); }
std::string text_of(const Vec3& point) { return point_text(point); }

struct Text {
  template <DescribedShape S>
  std::string operator()(const S& shape) const {
    return std::apply(
        [&shape](const auto&... parameters) { return fmt::format(S::words, text_of((shape.*parameters.value)())...); },
        S::parameters);
  }
  std::string operator()(const Triangle& t) const {
    return fmt::format("triangle {}, {}, {}", point_text(t[0]), point_text(t[1]), point_text(t[2]));
  }
  std::string operator()(const ConvexHull& hull) const { return text_of(hull); }
  std::string operator()(const Rounded& s) const {
    return fmt::format("rounded by {:.6g}: {}", s.radius(), std::visit(*this, s.core()));
  }
  std::string operator()(const HeightField& s) const {
    return fmt::format("height field of {} × {} heights, spacing {:.6g} × {:.6g}", s.columns(), s.rows(), s.spacing_x(),
                       s.spacing_y());
  }
  std::string operator()(const std::shared_ptr<const TriangleMesh>& mesh) const {
    return "mesh of " + counted(mesh->triangle_count(), "triangle");
  }
  std::string operator()(const Compound& compound) const {
    std::vector<std::string> parts;
    for (const CompoundPart& part : compound.parts()) parts.push_back(std::visit(*this, part.shape));
    return fmt::format("compound of {}: {}", counted(parts.size(), "part"), fmt::join(parts, "; "));
  }
};

}  // namespace

std::string shape_text(const Shape& shape) { return std::visit(Text{}, shape); }

}  // namespace toccata::command
