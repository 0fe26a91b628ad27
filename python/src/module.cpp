#include <nanobind/nanobind.h>

#include <toccata/core/error.hpp>
#include <toccata/core/status.hpp>
#include <toccata/core/version.hpp>

#include "arrays.hpp"
#include "overlap_bodies.hpp"
#include "shapes.hpp"

namespace nb = nanobind;

NB_MODULE(_core, module) {
  nb::set_leak_warnings(false);  // what a thread still holds when the interpreter ends is no business of the user's
  module.doc() = "The part of toccata that is compiled; what it holds is in toccata.";
  // What is made now belongs to the package, under whose name it is found, pickled and documented.
  const nb::object own_name = module.attr("__name__");
  module.attr("__name__") = "toccata";
  module.attr("__version__") = toccata::version;
  nb::exception<toccata::Error>(module, "Error", PyExc_ValueError).attr("__doc__") =
      "What was asked wrongly, and what to do: the message of the C++ library, which names the argument, file or "
      "element.";
  nb::enum_<toccata::Status>(module, "Status", nb::is_arithmetic(), "How far an answer can be trusted.")
      .value("exact", toccata::Status::exact, "It is the truth for the given numbers.")
      .value("undecided", toccata::Status::undecided,
             "Within the stated bound of the boundary; the safe answer is given.")
      .value("not_converged", toccata::Status::not_converged, "The interval is wider than promised, and still holds.");
  using namespace toccata::python;
  know_arrays();
  bind_poses(module);
  bind_shapes(module);
  bind_pair_questions(module);
  bind_point_questions(module);
  bind_contact_questions(module);
  bind_mover_options(module);
  bind_scenes(module);
  bind_depths(module);
  bind_overlap_bodies(module);
  bind_regions(module);
  bind_meshes(module);
  bind_motions(module);
  bind_deforming(module);
  bind_worlds(module);
  bind_boxes(module);
  bind_parts(module);
  bind_robots(module);
  bind_caches(module);
  bind_pages(module);
  module.attr("__name__") = own_name;
}
