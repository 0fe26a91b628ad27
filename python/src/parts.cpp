#include <nanobind/nanobind.h>

#include <vector>

#include <fmt/format.h>

#include <toccata/query/convex_parts.hpp>

#include "arrays.hpp"
#include "calls.hpp"
#include "shapes.hpp"

namespace toccata::python {
namespace {

void bind_part(nb::module_& module) {
  nb::class_<ConvexPart>(module, "ConvexPart", "A convex part of a mesh.")
      .def_prop_ro(
          "hull", [](const ConvexPart& part) { return shape_object(Model(part.hull)); },
          nb::sig("def hull(self) -> ConvexHull"))
      .def_ro("volume", &ConvexPart::volume, "Of the hull, rounded.")
      .def_ro("concavity", &ConvexPart::concavity, "No point of the hull is farther than this from the solid; proved.")
      .def_ro("concavity_found", &ConvexPart::concavity_found, "Some point of the hull is as far as this, at least.")
      .def_prop_ro(
          "faces",
          [](const ConvexPart& part) {
            return nb::borrow<Indices>(array_over<Index>(std::vector<Index>(part.faces), {}));
          },
          "Of the mesh, ascending: those that the part has more than the border of.");
}

}  // namespace

void bind_parts(nb::module_& module) {
  bind_part(module);
  nb::class_<ConvexParts>(module, "ConvexParts", "Convex parts whose union contains a solid.")
      .def("__len__", [](const ConvexParts& parts) { return parts.parts.size(); })
      .def_prop_ro(
          "parts",
          [](const ConvexParts& parts) {
            nb::list list;
            for (const ConvexPart& part : parts.parts) list.append(nb::cast(part));
            return list;
          },
          "By falling volume.", nb::sig("def parts(self) -> list[ConvexPart]"))
      .def_ro("mesh_volume", &ConvexParts::mesh_volume, "Of the solid, rounded.")
      .def_ro("hull_volume", &ConvexParts::hull_volume, "Of all hulls.")
      .def_ro("excess", &ConvexParts::excess, "hull_volume - mesh_volume.")
      .def_ro("concavity", &ConvexParts::concavity, "The greatest of all parts.")
      .def(
          "compound", [](const ConvexParts& parts) { return shape_object(Model(parts.compound())); },
          "The parts as one shape, for questions that are to be about them and not about the mesh.",
          nb::sig("def compound(self) -> Compound"))
      .def("__repr__",
           [](const ConvexParts& parts) { return fmt::format("<toccata.ConvexParts: {}>", parts.parts.size()); });
  module.def(
      "decompose",
      [](const AnyShape& mesh, std::size_t max_parts, double concavity, int threads) {
        DecompositionOptions options{max_parts, concavity, threads};
        const Interruptible call(threads);
        options.progress = call.options().progress;
        return call.ask([&, model = mesh.model](const BatchOptions&) { return decompose(model, options); });
      },
      nb::arg("mesh"), nb::kw_only(), nb::arg("max_parts") = DecompositionOptions{}.max_parts,
      nb::arg("concavity") = 0.0, nb::arg("threads") = own_thread,
      R"(Convex parts whose union contains the solid that a closed mesh encloses; that is proved.

It stops cutting at max_parts, or where no part is farther than the concavity (in the unit of the mesh) from the solid
(J.-M. Lien, N. M. Amato, "Approximate convex decomposition of polyhedra", 2007). The same on any number of threads. Ctrl-C
ends it. Raises Error for what is no closed mesh, and for a limit out of range.)");
}

}  // namespace toccata::python
