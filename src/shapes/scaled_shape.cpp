#include "toccata/shapes/shape.hpp"

#include <algorithm>
#include <type_traits>
#include <vector>

namespace toccata {
namespace {

Point scaled(const Point& p, double f) { return Point(f * p.position()); }
Segment scaled(const Segment& s, double f) { return {f * s.start(), f * s.end()}; }
Triangle scaled(const Triangle& t, double f) { return {{f * t[0], f * t[1], f * t[2]}}; }
Box scaled(const Box& b, double f) { return Box(f * b.half_extents(), f * b.centre()); }

ConvexHull scaled(const ConvexHull& hull, double f) {
  std::vector<Vec3> vertices;
  for (Index i = 0; i < hull.vertex_count(); ++i) vertices.push_back(f * hull.vertex(i));
  return ConvexHull(vertices);
}

Rounded scaled(const Rounded& r, double f) {
  return {std::visit([f](const auto& core) -> Rounded::Core { return scaled(core, f); }, r.core()), f * r.radius()};
}

Compound scaled(const Compound& compound, double f) {
  std::vector<CompoundPart> parts;
  for (const CompoundPart& part : compound.parts()) {
    const Pose pose = keeps_its_form(part.shape) ? part.pose : toccata::scaled(part.pose, f);
    parts.push_back({scaled_in_itself(part.shape, f), {pose.linear, f * part.pose.offset}});
  }
  return Compound(parts);
}

}  // namespace

bool keeps_its_form(const Shape& shape) {
  if (const auto* compound = std::get_if<Compound>(&shape))
    return std::ranges::any_of(compound->parts(), [](const CompoundPart& part) { return keeps_its_form(part.shape); });
  return std::holds_alternative<HalfSpace>(shape) || std::holds_alternative<Sphere>(shape) ||
         std::holds_alternative<Capsule>(shape) || std::holds_alternative<Rounded>(shape);
}

Shape scaled_in_itself(const Shape& shape, double factor) {
  if (!keeps_its_form(shape)) return shape;
  if (const auto* space = std::get_if<HalfSpace>(&shape)) return HalfSpace(factor * space->point(), space->normal());
  if (const auto* ball = std::get_if<Sphere>(&shape)) return Sphere(factor * ball->radius(), factor * ball->centre());
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    return Capsule(factor * capsule->start(), factor * capsule->end(), factor * capsule->radius());
  if (const auto* rounded = std::get_if<Rounded>(&shape)) return scaled(*rounded, factor);
  return scaled(std::get<Compound>(shape), factor);
}

std::shared_ptr<const TriangleMesh> mesh_of(const Shape& shape) {
  if (const auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&shape)) return *mesh;
  if (const auto* field = std::get_if<HeightField>(&shape)) return field->mesh();
  return nullptr;
}

}  // namespace toccata
