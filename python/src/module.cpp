#include <nanobind/nanobind.h>

#include <exception>
#include <string_view>

#include <toccata/core/error.hpp>
#include <toccata/core/status.hpp>
#include <toccata/core/version.hpp>

#include "arrays.hpp"
#include "overlap_bodies.hpp"
#include "shapes.hpp"

namespace nb = nanobind;

namespace {

/// The words of an Error. What they quote, as the name of a file, may be no UTF-8.
void tell_error(const std::exception_ptr& thrown, void* type) {
  try {
    std::rethrow_exception(thrown);
  } catch (const toccata::Error& error) {
    const std::string_view words = error.what();
    const auto text =
        nb::steal(PyUnicode_DecodeUTF8(words.data(), static_cast<Py_ssize_t>(words.size()), "backslashreplace"));
    if (text.is_valid()) PyErr_SetObject(static_cast<PyObject*>(type), text.ptr());
  }
}

}  // namespace

NB_MODULE(_core, module) {
  nb::set_leak_warnings(false);  // what a thread still holds when the interpreter ends is no business of the user's
  module.doc() = "The part of toccata that is compiled; what it holds is in toccata.";
  // What is made now belongs to the package, under whose name it is found, pickled and documented.
  const nb::object own_name = module.attr("__name__");
  module.attr("__name__") = "toccata";
  module.attr("__version__") = toccata::version;
  const nb::object error = nb::exception<toccata::Error>(module, "Error", PyExc_ValueError);
  nb::register_exception_translator(tell_error, error.ptr());  // before that of nb::exception
  error.attr("__doc__") =
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
