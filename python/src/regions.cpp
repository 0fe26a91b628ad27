#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>

#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/query/faces_in_region.hpp>
#include <toccata/query/scene_index.hpp>

#include "calls.hpp"
#include "contact_rows.hpp"
#include "scenes.hpp"
#include "shapes.hpp"

// Faces within boxes and balls, and points asked about among many shapes.
namespace toccata::python {

template <>
struct Described<FoundElement> {
  static constexpr const char* name = "FoundElement";
  static constexpr const char* doc = "Something of a shape that has a point in common with a region.";
  static constexpr std::tuple fields{
      field<FoundElement, &FoundElement::element>("element", "The element, of a mesh the triangle."),
      field<FoundElement, &FoundElement::face>("face", "The face, as its file counts them from 0.")};
};

template <>
struct Described<ScenePoint> {
  static constexpr const char* name = "ScenePoint";
  static constexpr const char* doc = "A point of the surface of one of many.";
  static constexpr auto fields =
      std::tuple_cat(std::tuple{field<ScenePoint, &ScenePoint::object>("object", "Of which of the objects.")},
                     fields_within<ScenePoint, &ScenePoint::nearest>(Described<SurfacePoint>::fields));
};

namespace {

/// Without what is no number.
struct SignedRow {
  SignedDistance distance{};
  Index object = 0;
  bool inside = false;
  Index inside_of = 0;
};

}  // namespace

template <>
struct Described<SignedRow> {
  static constexpr const char* name = "SceneSignedDistance";
  static constexpr const char* doc = "";
  static constexpr auto fields =
      std::tuple_cat(std::tuple{field<SignedRow, &SignedRow::object>("object", "")},
                     fields_within<SignedRow, &SignedRow::distance>(Described<SignedDistance>::fields),
                     std::tuple{field<SignedRow, &SignedRow::inside>("inside", ""),
                                field<SignedRow, &SignedRow::inside_of>("inside_of", "")});
};

namespace {

/// A box (2, 3), its corners, or a ball (centre, radius).
std::vector<RegionQuery> regions_of(const nb::object& boxes, const nb::object& centres, const nb::object& radii,
                                    const Pose& pose) {
  std::vector<RegionQuery> queries;
  if (!boxes.is_none() && (!centres.is_none() || !radii.is_none())) throw Error("regions: boxes or balls, not both");
  if (!boxes.is_none()) {
    for (const Aabb& box : boxes_of(boxes, "boxes")) queries.push_back({box, pose});
    return queries;
  }
  const std::vector<Vec3> at = vectors_of(centres, "centres");
  const std::vector<double> radius = numbers_for(radii, at.size(), "radii");
  for (std::size_t i = 0; i < at.size(); ++i) queries.push_back({Ball{at[i], radius[i]}, pose});
  return queries;
}

void bind_faces(nb::module_& module) {
  module.def(
      "faces_in_box",
      [](const AnyShape& shape, const ArrayLike& lower, const ArrayLike& upper, const PoseLike& pose) {
        const Aabb box{vector_of(lower, "lower"), vector_of(upper, "upper")};
        const Pose placed = pose_of(pose, "pose");
        return structured(
            asked_about(shape.model, [&](const Model& model) { return faces_in_region(box, model, placed); }));
      },
      nb::arg("shape"), nb::arg("lower"), nb::arg("upper"), nb::arg("pose") = nb::none(),
      R"(What of a posed shape has a point in common with a closed box of the world, by its least and its greatest corner.

Corners of the shape (3,), in the unit of the coordinates. A structured array: element and face, ascending. Exact, touching
included; of a mesh its triangles are asked about, so a box deep inside finds none. Raises Error when the box is empty or not finite, and for poses as overlap does.)");
  module.def(
      "faces_in_ball",
      [](const AnyShape& shape, const ArrayLike& centre, double radius, const PoseLike& pose) {
        const Ball ball{vector_of(centre, "centre"), radius};
        const Pose placed = pose_of(pose, "pose");
        return structured(
            asked_about(shape.model, [&](const Model& model) { return faces_in_region(ball, model, placed); }));
      },
      nb::arg("shape"), nb::arg("centre"), nb::arg("radius"), nb::arg("pose") = nb::none(),
      "faces_in_box of a closed ball of the world, its centre of the shape (3,), whose radius may be 0, in the unit of "
      "the "
      "coordinates. Raises Error when the radius is negative or a number is not finite, and for poses as overlap "
      "does.");
  module.def(
      "faces_in_region_each",
      [](const AnyShape& shape, const nb::object& boxes, const nb::object& centres, const nb::object& radii,
         const PoseLike& pose, int threads) {
        const std::vector<RegionQuery> queries = regions_of(boxes, centres, radii, pose_of(pose, "pose"));
        return structured(
            numbered<OfQuery>(Interruptible(threads).ask([&, model = shape.model](const BatchOptions& options) {
              return faces_in_region_each(queries, model, options);
            })));
      },
      nb::arg("shape"), nb::kw_only(), nb::arg("boxes") = nb::none(), nb::arg("centres") = nb::none(),
      nb::arg("radii") = nb::none(), nb::arg("pose") = nb::none(), nb::arg("threads") = all_threads,
      nb::sig("def faces_in_region_each(shape: Shape, *, boxes: numpy.typing.ArrayLike | None = None, centres: "
              "numpy.typing.ArrayLike | None = None, radii: numpy.typing.ArrayLike | None = None, pose: "
              "toccata._typing.PoseLike | None = None, threads: int = 0) -> toccata._typing.Answers"),
      "faces_in_box of many boxes, shape (N, 2, 3), or faces_in_ball of many balls, centres (N, 3) and one radius or "
      "N, in the world and the unit of the coordinates, on all cores: one structured array of all, in order, whose "
      "field query says of which region a row is. Raises Error like these, naming the region, and for boxes and balls "
      "at once.");
}

void bind_points(nb::module_& module) {
  module.def(
      "nearest_points_each",
      [](const ArrayLike& points, std::size_t k, const ObjectsLike& objects, double max_distance, int threads) {
        const std::vector<Vec3> given = vectors_of(points, "points");
        const std::vector<SceneInstance> instances = instances_of(objects, "objects");
        return structured(numbered<OfQuery>(Interruptible(threads).ask([&](const BatchOptions& options) {
          return nearest_points_each(given, k, instances, max_distance, options);
        })));
      },
      nb::arg("points"), nb::arg("k"), nb::arg("objects"), nb::arg("max_distance") = unlimited, nb::kw_only(),
      nb::arg("threads") = all_threads,
      "Of many points, shape (N, 3), the k nearest elements of all objects together, on all cores: one structured "
      "array, "
      "the nearest first of each, with query, object and the members of SurfacePoint; in the world and the unit of the "
      "coordinates. Raises Error naming the point.");
  module.def(
      "scene_signed_distance_each",
      [](const ArrayLike& points, const ObjectsLike& objects, SignBy sign_by, int threads) {
        const std::vector<Vec3> given = vectors_of(points, "points");
        const std::vector<SceneInstance> instances = instances_of(objects, "objects");
        const auto found = Interruptible(threads).ask(
            [&](const BatchOptions& options) { return signed_distance_each(given, instances, sign_by, options); });
        std::vector<SignedRow> rows;
        for (const SceneSignedDistance& one : found)
          rows.push_back({one.distance, one.object, one.inside_of.has_value(), one.inside_of.value_or(0)});
        return structured(std::move(rows));
      },
      nb::arg("points"), nb::arg("objects"), nb::arg("sign_by") = SignBy::automatic, nb::kw_only(),
      nb::arg("threads") = all_threads,
      "How far many points, shape (N, 3), are from the nearest surface of all objects, negative inside one of them: a "
      "structured array with object, whose surface it is, the members of SignedDistance, inside, and inside_of, the "
      "first "
      "object that the point is inside of; in the world and the unit of the coordinates. Raises Error like "
      "signed_distance, naming the point.");
}

}  // namespace

void bind_regions(nb::module_& module) {
  bind_faces(module);
  bind_points(module);
}

}  // namespace toccata::python
