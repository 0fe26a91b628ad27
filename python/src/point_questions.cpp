#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>

#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/query/batch.hpp>
#include <toccata/query/signed_distance.hpp>

#include "arrays.hpp"
#include "calls.hpp"
#include "described.hpp"
#include "shapes.hpp"
#include "workspace.hpp"

namespace toccata::python {
namespace {

NearestQuery nearest_query(const PoseLike& pose, double max_distance) { return {pose_of(pose, "pose"), max_distance}; }

/// `ask(points, model, options)` as a structured array.
template <class Ask>
Answers asked_of_points(const ArrayLike& points, const AnyShape& shape, int threads, const Ask& ask) {
  const std::vector<Vec3> given = vectors_of(points, "points");
  const Interruptible call(threads);
  return structured(call.ask([&, model = shape.model](const BatchOptions& options) {
    return ask(std::span<const Vec3>(given), model, options);
  }));
}

void bind_nearest(nb::module_& module) {
  module.def(
      "nearest_point",
      [](const ArrayLike& point, const AnyShape& surface, const PoseLike& pose, double max_distance) {
        const Vec3 at = vector_of(point, "point");
        const NearestQuery query = nearest_query(pose, max_distance);
        return asked_about(surface.model,
                           [&](const Model& model) { return nearest_point(at, model, query, kept_workspace()); });
      },
      nb::arg("point"), nb::arg("surface"), nb::arg("pose") = nb::none(), nb::arg("max_distance") = unlimited,
      R"(The nearest point of the surface of a posed shape, also from within; None where all of it is farther than max_distance.

The point has the shape (3,), in the world. Nothing farther than max_distance is found, but for 1e-12 of it. In the unit of
the coordinates. By the tree of a mesh, the nearest boxes first (N. Roussopoulos, S. Kelley, F. Vincent, "Nearest neighbor
queries", 1995). Raises Error when a number is not finite, the greatest distance is negative, and for poses as overlap does.)");
  module.def(
      "nearest_points",
      [](const ArrayLike& point, std::size_t k, const AnyShape& surface, const PoseLike& pose, double max_distance) {
        const Vec3 at = vector_of(point, "point");
        const NearestQuery query = nearest_query(pose, max_distance);
        return structured(
            asked_about(surface.model, [&](const Model& model) { return nearest_points(at, k, model, query); }));
      },
      nb::arg("point"), nb::arg("k"), nb::arg("surface"), nb::arg("pose") = nb::none(),
      nb::arg("max_distance") = unlimited,
      "The points that are nearest to one of the shape (3,) in the world, of the k nearest elements, the nearest "
      "first: a "
      "structured array with the members of SurfacePoint, in the unit of the coordinates. Raises Error like "
      "nearest_point.");
  module.def(
      "nearest_point_each",
      [](const ArrayLike& points, const AnyShape& surface, const PoseLike& pose, double max_distance, int threads) {
        const NearestQuery query = nearest_query(pose, max_distance);
        return asked_of_points(points, surface, threads,
                               [&](std::span<const Vec3> given, const Model& model, const BatchOptions& options) {
                                 return nearest_point_each(given, model, query, options);
                               });
      },
      nb::arg("points"), nb::arg("surface"), nb::arg("pose") = nb::none(), nb::arg("max_distance") = unlimited,
      nb::kw_only(), nb::arg("threads") = all_threads,
      "nearest_point of many points, shape (N, 3), on all cores: a structured array with the members of SurfacePoint, "
      "and found, in "
      "the unit of the coordinates. Raises Error like nearest_point, naming the point.");
}

void bind_sides(nb::module_& module) {
  nb::enum_<Side>(module, "Side", nb::is_arithmetic(), "Where a point is.")
      .value("outside", Side::outside)
      .value("boundary", Side::boundary)
      .value("inside", Side::inside);
  nb::enum_<SignBy>(module, "SignBy", nb::is_arithmetic(), "What tells inside from outside.")
      .value("automatic", SignBy::automatic, "Of a closed mesh the winding number, of an open one the generalised.")
      .value("winding_number", SignBy::winding_number, "Exact. Not of open meshes.")
      .value("generalized_winding_number", SignBy::generalized_winding_number, "A guess where holes are.");
}

void bind_signed_distances(nb::module_& module) {
  bind_answer<SignedDistance>(module);
  module.def(
      "signed_distance",
      [](const ArrayLike& point, const AnyShape& shape, const PoseLike& pose, SignBy sign_by) {
        const Vec3 at = vector_of(point, "point");
        const Pose placed = pose_of(pose, "pose");
        return asked_about(shape.model, [&](const Model& model) {
          return signed_distance(at, model, placed, sign_by, kept_workspace());
        });
      },
      nb::arg("point"), nb::arg("shape"), nb::arg("pose") = nb::none(), nb::arg("sign_by") = SignBy::automatic,
      R"(How far a point, shape (3,) in the world, is from the surface of a posed shape, negative inside.

The side is exact of closed meshes and of shapes that are none; of an open mesh it is that of the generalised winding
number (A. Jacobson and others, 2013). In the unit of the coordinates. Raises Error when a number is not finite, or an open
mesh is asked by SignBy.winding_number.)");
  module.def(
      "signed_distance_each",
      [](const ArrayLike& points, const AnyShape& shape, const PoseLike& pose, SignBy sign_by, int threads) {
        const Pose placed = pose_of(pose, "pose");
        return asked_of_points(points, shape, threads,
                               [&](std::span<const Vec3> given, const Model& model, const BatchOptions& options) {
                                 return signed_distance_each(given, model, placed, sign_by, options);
                               });
      },
      nb::arg("points"), nb::arg("shape"), nb::arg("pose") = nb::none(), nb::arg("sign_by") = SignBy::automatic,
      nb::kw_only(), nb::arg("threads") = all_threads,
      "signed_distance of many points, shape (N, 3), on all cores: a structured array with the members of "
      "SignedDistance, in the unit of the coordinates. Raises Error like signed_distance, naming the point.");
}

void bind_winding(nb::module_& module) {
  bind_answer<WindingNumber>(module);
  module.def(
      "locate",
      [](const ArrayLike& point, const AnyShape& solid, const PoseLike& pose) {
        const Vec3 at = vector_of(point, "point");
        const Pose placed = pose_of(pose, "pose");
        const PointLocation found =
            asked_about(solid.model, [&](const Model& model) { return locate(at, model, placed); });
        return std::pair(found.side, found.winding_number);
      },
      nb::arg("point"), nb::arg("solid"), nb::arg("pose") = nb::none(),
      "Where a point, shape (3,) in the world, lies relative to a closed mesh, exactly, and how often the surface "
      "winds "
      "around it. Raises Error for an open mesh, and when a number is not finite.");
  module.def(
      "generalized_winding_number",
      [](const ArrayLike& point, const AnyShape& mesh, const PoseLike& pose, double tolerance) {
        const Vec3 at = vector_of(point, "point");
        const Pose placed = pose_of(pose, "pose");
        return asked_about(mesh.model, [&](const Model& model) {
          return generalized_winding_number(at, model, placed, {.tolerance = tolerance});
        });
      },
      nb::arg("point"), nb::arg("mesh"), nb::arg("pose") = nb::none(),
      nb::arg("tolerance") = WindingOptions{}.tolerance,
      "How much of the sphere of directions around a point, shape (3,) in the world, a mesh covers: about 1 inside, 0 "
      "outside, and between where holes are. Off by at most the tolerance, a number without unit, as an interval "
      "(A. Jacobson, L. Kavan, O. Sorkine-Hornung, \"Robust inside-outside segmentation using generalized winding "
      "numbers\", 2013). Raises Error for what is no mesh, and when a number is not finite.");
  module.def(
      "generalized_winding_number_each",
      [](const ArrayLike& points, const AnyShape& mesh, const PoseLike& pose, double tolerance, int threads) {
        const Pose placed = pose_of(pose, "pose");
        return asked_of_points(
            points, mesh, threads, [&](std::span<const Vec3> given, const Model& model, const BatchOptions& options) {
              return generalized_winding_number_each(given, model, placed, {.tolerance = tolerance}, options);
            });
      },
      nb::arg("points"), nb::arg("mesh"), nb::arg("pose") = nb::none(),
      nb::arg("tolerance") = WindingOptions{}.tolerance, nb::kw_only(), nb::arg("threads") = all_threads,
      "generalized_winding_number of many points, shape (N, 3), on all cores: a structured array with the members of "
      "WindingNumber. Raises Error like it, naming the point.");
}

void bind_rays(nb::module_& module) {
  module.def(
      "cast_ray",
      [](const ArrayLike& origin, const ArrayLike& motion, const AnyShape& target, const PoseLike& pose, Solid solid) {
        const Vec3 from = vector_of(origin, "origin"), way = vector_of(motion, "motion");
        const Pose placed = pose_of(pose, "pose");
        return asked_about(target.model, [&](const Model& model) { return cast_ray(from, way, model, placed, solid); });
      },
      nb::arg("origin"), nb::arg("motion"), nb::arg("target"), nb::arg("pose") = nb::none(), nb::kw_only(),
      nb::arg("solid") = Solid::automatic,
      R"(Where the ray from origin to origin + motion first meets the posed shape, None where it meets nothing, which is proved;
both of the shape (3,), in the world.

lower and upper are fractions of the way, from 0 to 1: a ray ends at origin + motion. No ray passes between two triangles
that share an edge. A solid is met at once from within; Solid.none asks its surface. Lengths are in the unit of the
coordinates. Raises Error when a number is not finite or the motion is zero.)");
  module.def(
      "cast_ray_each",
      [](const ArrayLike& origins, const ArrayLike& motions, const AnyShape& target, const PoseLike& pose, Solid solid,
         int threads) {
        const std::vector<Vec3> from = vectors_of(origins, "origins"), ways = vectors_of(motions, "motions");
        if (from.size() != ways.size())
          throw Error(fmt::format("there are {} origins and {} motions; give as many", from.size(), ways.size()));
        const Pose placed = pose_of(pose, "pose");
        std::vector<RayQuery> queries(from.size());
        for (std::size_t i = 0; i < queries.size(); ++i) queries[i] = {from[i], ways[i], placed, solid};
        const Interruptible call(threads);
        return structured(call.ask(
            [&, model = target.model](const BatchOptions& options) { return cast_ray_each(queries, model, options); }));
      },
      nb::arg("origins"), nb::arg("motions"), nb::arg("target"), nb::arg("pose") = nb::none(), nb::kw_only(),
      nb::arg("solid") = Solid::automatic, nb::arg("threads") = all_threads,
      "cast_ray of many rays, origins and motions of the shape (N, 3) in the world and the unit of the coordinates, on "
      "all cores: a structured array with the members of RayHit, and found. Raises Error like cast_ray, naming the "
      "ray.");
}

}  // namespace

void bind_point_questions(nb::module_& module) {
  bind_answer<RayHit>(module);
  bind_answer<SurfacePoint>(module);
  bind_nearest(module);
  bind_sides(module);
  bind_signed_distances(module);
  bind_winding(module);
  bind_rays(module);
}

}  // namespace toccata::python
