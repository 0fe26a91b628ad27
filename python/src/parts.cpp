#include <nanobind/nanobind.h>

#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/query/convex_parts.hpp>

#include "arrays.hpp"
#include "calls.hpp"
#include "shapes.hpp"
#include "values.hpp"

namespace toccata::python {
namespace {

constexpr std::size_t members_of_parts = 5;

nb::tuple state_of_part(const ConvexPart& part) {
  return nb::make_tuple(shape_object(Model(part.hull)), part.volume, part.concavity, part.concavity_found,
                        array_over<Index>(std::vector<Index>(part.faces), {}));
}

ConvexPart part_of_state(const nb::tuple& state) {
  if (state.size() != members_of_parts) throw Error("a pickled ConvexPart of another version");
  const Model hull = nb::cast<const AnyShape&>(state[0]).model;
  if (!std::holds_alternative<ConvexHull>(hull.shape())) throw Error("a pickled ConvexPart: its hull is none");
  return {std::get<ConvexHull>(hull.shape()), nb::cast<double>(state[1]), nb::cast<double>(state[2]),
          nb::cast<double>(state[3]), indices_of(nb::object(state[4]), 1, "a pickled ConvexPart")};
}

nb::list list_of_parts(const ConvexParts& parts) {
  nb::list list;
  for (const ConvexPart& part : parts.parts) list.append(nb::cast(part));
  return list;
}

nb::tuple state_of_parts(const ConvexParts& parts) {
  return nb::make_tuple(list_of_parts(parts), parts.mesh_volume, parts.hull_volume, parts.excess, parts.concavity);
}

ConvexParts parts_of_state(const nb::tuple& state) {
  if (state.size() != members_of_parts) throw Error("a pickled ConvexParts of another version");
  ConvexParts parts{{},
                    nb::cast<double>(state[1]),
                    nb::cast<double>(state[2]),
                    nb::cast<double>(state[3]),
                    nb::cast<double>(state[4])};
  for (const nb::handle part : nb::cast<nb::list>(state[0])) parts.parts.push_back(nb::cast<const ConvexPart&>(part));
  return parts;
}

void bind_part(nb::module_& module) {
  nb::class_<ConvexPart> bound(module, "ConvexPart", "A convex part of a mesh.");
  bound
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
          "Of the mesh, ascending: those that the part has more than the border of.")
      .def("__repr__", [](const ConvexPart& part) {
        return fmt::format("<toccata.ConvexPart of {} vertices, of volume {}>", part.hull.vertex_count(), part.volume);
      });
  bind_answer_value(
      bound, [](const ConvexPart& part) { return state_of_part(part); }, &part_of_state);
}

}  // namespace

void bind_parts(nb::module_& module) {
  bind_part(module);
  nb::class_<ConvexParts> bound(module, "ConvexParts", "Convex parts whose union contains a solid.");
  bound.def("__len__", [](const ConvexParts& parts) { return parts.parts.size(); })
      .def_prop_ro("parts", &list_of_parts, "By falling volume.", nb::sig("def parts(self) -> list[ConvexPart]"))
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
  bind_answer_value(
      bound, [](const ConvexParts& parts) { return state_of_parts(parts); }, &parts_of_state);
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
