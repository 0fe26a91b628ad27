#include <nanobind/nanobind.h>

#include <fmt/format.h>

#include <toccata/world/character_mover.hpp>

#include "arrays.hpp"
#include "shapes.hpp"
#include "values.hpp"

namespace toccata::python {

void bind_mover_options(nb::module_& module) {
  const MoverOptions usual;
  nb::class_<MoverOptions> bound(module, "MoverOptions",
                                 R"(How a character moves (move_character). Lengths are in the unit of the coordinates.

up: a vector in the world, shape (3,), of any length above 0. skin: how far the shape stays from everything. max_slope_degrees: the
steepest ground that is walked on, from level. step_height: the highest step that is walked up. snap_distance: how far below a walker ground
is looked for. max_slides: how often the way may bend in one step. Options out of range are told by move_character, which
raises Error.)");
  bound
      .def(
          "__init__",
          [](MoverOptions* place, const ArrayLike& up, double skin, double max_slope_degrees, double step_height,
             double snap_distance, int max_slides) {
            new (place)
                MoverOptions{vector_of(up, "up"), skin, max_slope_degrees, step_height, snap_distance, max_slides};
          },
          nb::kw_only(), nb::arg("up") = tuple_of(usual.up), nb::arg("skin") = usual.skin,
          nb::arg("max_slope_degrees") = usual.max_slope_degrees, nb::arg("step_height") = usual.step_height,
          nb::arg("snap_distance") = usual.snap_distance, nb::arg("max_slides") = usual.max_slides)
      .def_prop_ro("up", [](const MoverOptions& options) { return array_of(options.up); })
      .def_ro("skin", &MoverOptions::skin)
      .def_ro("max_slope_degrees", &MoverOptions::max_slope_degrees)
      .def_ro("step_height", &MoverOptions::step_height)
      .def_ro("snap_distance", &MoverOptions::snap_distance)
      .def_ro("max_slides", &MoverOptions::max_slides)
      .def("__repr__", [](const MoverOptions& o) {
        return fmt::format(
            "MoverOptions(up=({}, {}, {}), skin={}, max_slope_degrees={}, step_height={}, snap_distance={}, "
            "max_slides={})",
            o.up.x, o.up.y, o.up.z, o.skin, o.max_slope_degrees, o.step_height, o.snap_distance, o.max_slides);
      });
  bind_value(bound, [](const MoverOptions& options) {
    nb::dict named;
    named["up"] = tuple_of(options.up);
    named["skin"] = options.skin;
    named["max_slope_degrees"] = options.max_slope_degrees;
    named["step_height"] = options.step_height;
    named["snap_distance"] = options.snap_distance;
    named["max_slides"] = options.max_slides;
    return Making(nb::tuple(), named);
  });
  module.def(
      "velocity_along",
      [](const ArrayLike& velocity, const ArrayLike& normals) {
        return array_of(velocity_along(vector_of(velocity, "velocity"), vectors_of(normals, "normals")));
      },
      nb::arg("velocity"), nb::arg("normals"),
      "The vector nearest to `velocity`, shape (3,), in its unit and frame, that goes into none of the planes with "
      "these "
      "normals, shape (N, 3), of length 1: so a velocity loses what goes into the contacts of a step of a character. "
      "Raises Error for a number that is not finite.");
}

}  // namespace toccata::python
