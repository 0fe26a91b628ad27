#include "query/posed_shape.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "math/constants.hpp"
#include "math/expansion.hpp"
#include "math/world_vertex.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"
#include "query/semantics.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// The least double that is not less than a + b; what overflows ends at the greatest, as all coordinates do.
double clamped_sum_not_less(double a, double b) {
  return std::clamp(sum_not_less(a, b), -greatest_double, greatest_double);
}

/// Makes the posed shape in place; none is copied.
struct PosedShapeMaker {
  PosedShape operator()(const HalfSpace& shape) const {
    return PosedShape(std::in_place_type<PosedHalfSpace>, shape, pose);
  }
  PosedShape operator()(const Compound&) const {
    throw Error(fmt::format("{}: a compound is asked about through its parts", who));
  }
  PosedShape operator()(const HeightField&) const { return triangles(); }
  PosedShape operator()(const std::shared_ptr<const TriangleMesh>&) const { return triangles(); }
  template <PlainShape S>
  PosedShape operator()(const S& shape) const {
    return PosedShape(std::in_place_type<PosedPolytope>, shape, pose);
  }

  template <QuadricShape S>
  PosedShape operator()(const S& shape) const {
    return PosedShape(std::in_place_type<PosedQuadric>, shape, pose);
  }

  PosedShape triangles() const {
    const bool as_solid = taken_as_solid(model, pose, solid, who);
    return PosedShape(std::in_place_type<PosedTriangles>, PosedTriangles{PosedMesh(model, pose, who), as_solid});
  }

  const Model& model;
  const Pose& pose;
  Solid solid;
  std::string_view who;
};

void require_taken(const PosedShape& shape, const Model& model, Solid solid, std::string_view who) {
  if (solid == Solid::all && !is_solid(shape))
    throw Error(
        fmt::format("{}: a {} without an interior is a surface; it cannot be asked about as a solid "
                    "(use solid = auto)",
                    who, name_of(model.shape())));
}

/// What is made; an error that does not begin with the name is given it.
template <class Make>
auto naming(std::string_view who, const Make& make) {
  try {
    return make();
  } catch (const Error& error) {
    const std::string message = error.what();
    if (message.starts_with(who)) throw;
    throw Error(fmt::format("{}: {}", who, message));
  }
}

/// What an error calls a part; written only where there is one.
struct PartName {
  std::string_view who;
  const PartName* whole = nullptr;
  std::size_t part = 0;

  [[nodiscard]] std::string text() const {
    return whole == nullptr ? std::string(who) : fmt::format("{}, part {}", whole->text(), part);
  }
};

PosedShape pose_part(const Model& model, const Pose& pose, Solid solid, const PartName& name) {
  if (name.whole == nullptr) return pose_shape(model, pose, solid, name.who);
  try {
    return pose_shape(model, pose, solid, "a part");
  } catch (const Error&) {
    return pose_shape(model, pose, solid, name.text());
  }
}

void add_parts(const Model& model, const Pose& pose, Solid solid, const PartName& name, PosedModel& posed) {
  const auto* compound = std::get_if<Compound>(&model.shape());
  if (compound == nullptr) {
    PosedPart part{pose_part(model, pose, solid, name), kind_of(model.shape())};
    if (!posed.parts.empty()) {
      const PosedPart& last = posed.parts.back();
      const auto* triangles = std::get_if<PosedTriangles>(&last.shape);
      part.first_element = last.first_element + (triangles ? triangles->mesh.model().element_count() : 1);
      part.first_face = last.first_face + (triangles ? triangles->mesh.model().face_count() : 1);
    }
    posed.parts.push_back(std::move(part));
    return;
  }
  for (std::size_t i = 0; i < model.parts().size(); ++i)
    add_parts(model.parts()[i], pose * compound->parts()[i].pose, solid, {{}, &name, i}, posed);
}

}  // namespace

bool is_solid(const PosedShape& shape) {
  if (const auto* convex = std::get_if<PosedPolytope>(&shape)) return convex->solid();
  if (const auto* triangles = std::get_if<PosedTriangles>(&shape)) return triangles->solid;
  return true;
}

PosedShape pose_shape(const Model& model, const Pose& pose, Solid solid, std::string_view who) {
  if (model.has_mesh()) return std::visit(PosedShapeMaker{model, pose, solid, who}, model.shape());
  return naming(who, [&] {
    PosedShape shape = std::visit(PosedShapeMaker{model, pose, solid, who}, model.shape());
    require_taken(shape, model, solid, who);
    return shape;
  });
}

template <PosedConvexSet S>
S pose_convex(const Model& model, const Pose& pose, std::string_view who) {
  return naming(who, [&] {
    return std::visit(
        [&]<class Shape>(const Shape& shape) -> S {
          if constexpr (std::is_constructible_v<S, const Shape&, const Pose&>)
            return S(shape, pose);
          else
            throw Error("a shape of another kind is posed");
        },
        model.shape());
  });
}
template PosedPolytope pose_convex(const Model&, const Pose&, std::string_view);
template PosedHalfSpace pose_convex(const Model&, const Pose&, std::string_view);
template PosedQuadric pose_convex(const Model&, const Pose&, std::string_view);

PosedModel pose_model(const Model& model, const Pose& pose, Solid solid, std::string_view who,
                      std::vector<PosedPart> memory) {
  memory.clear();
  PosedModel posed{std::move(memory), true};
  add_parts(model, pose, solid, {who}, posed);
  posed.solid =
      std::all_of(posed.parts.begin(), posed.parts.end(), [](const PosedPart& part) { return is_solid(part.shape); });
  return posed;
}

Aabb world_box(const PosedPolytope& shape) {
  const double *x = shape.along(0), *y = shape.along(1), *z = shape.along(2);
  Aabb box;
  for (Index i = 0; i < shape.vertex_count(); ++i) {
    const Vec3 stored{x[i], y[i], z[i]};
    box = merge(box, shape.in_world() ? stored : world_vertex(shape.pose(), stored));
  }
  return widened(box, shape.radius());
}

Aabb world_box(const PosedQuadric& shape) {
  Aabb box;
  const Vec3& half = shape.half();
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3& row = shape.pose().linear[axis];
    const double x = row.x * half.x, y = row.y * half.y, z = row.z * half.z, offset = shape.pose().offset[axis];
    const auto reach = [](double exact) { return exact * (1 + 0x1p-48) + 0x1p-1070; };  // of four roundings
    const QuadricReach reached = with_kind(shape.kind(), [&](auto kind) { return kind.reach(x, y, z); });
    box.lower[axis] = -clamped_sum_not_less(-offset, reach(reached.down));
    box.upper[axis] = clamped_sum_not_less(offset, reach(reached.up));
  }
  return box;
}

Aabb world_box(const PosedModel& model) {
  Aabb box;
  for (const PosedPart& part : model.parts) box = merge(box, world_box(part.shape));
  return box;
}

Aabb widened(Aabb box, double by) {
  if (by == 0 || is_empty(box) || !is_finite(box.lower) || !is_finite(box.upper)) return box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = -clamped_sum_not_less(-box.lower[axis], by);
    box.upper[axis] = clamped_sum_not_less(box.upper[axis], by);
  }
  return box;
}

Aabb world_box(const PosedShape& shape) {
  if (const auto* convex = std::get_if<PosedPolytope>(&shape)) return world_box(*convex);
  if (const auto* triangles = std::get_if<PosedTriangles>(&shape)) return triangles->mesh.box();
  if (const auto* quadric = std::get_if<PosedQuadric>(&shape)) return world_box(*quadric);
  return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
}

}  // namespace toccata
