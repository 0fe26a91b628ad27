#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/io/scene_file.hpp>
#include <toccata/query/check_all.hpp>
#include <toccata/shapes/close_mesh.hpp>
#include <toccata/shapes/convex_hull.hpp>
#include <toccata/shapes/mesh_health.hpp>

#include "answers.hpp"
#include "calls.hpp"
#include "shapes.hpp"
#include "values.hpp"

// Files of many objects, what is wrong with a mesh and how it is closed, and hulls of other things than points.
namespace toccata::python {

template <>
struct Described<MeshRepair> {
  static constexpr const char* name = "MeshRepair";
  static constexpr const char* doc = "What close_mesh has done, counted.";
  static constexpr std::tuple fields{
      field<MeshRepair, &MeshRepair::moved_vertices>("moved_vertices", "Of the boundary, onto another one."),
      field<MeshRepair, &MeshRepair::collapsed_triangles>("collapsed_triangles", "They are gone."),
      field<MeshRepair, &MeshRepair::filled_holes>("filled_holes", ""),
      field<MeshRepair, &MeshRepair::added_triangles>("added_triangles",
                                                      "Each is a face of its own, after the others."),
      field<MeshRepair, &MeshRepair::open_holes>("open_holes", "That are wider, or no simple loop.")};
};

namespace {

const TriangleMesh& mesh_asked(const AnyShape& mesh) {
  if (!mesh.model.has_mesh() || !mesh.model.parts().empty()) throw Error("mesh: a Mesh is needed");
  return mesh.model.mesh();
}

nb::tuple state_of_fault(const MeshFault& fault) {
  return nb::make_tuple(static_cast<int>(fault.kind), array_over<Index>(std::vector(fault.edges), {2}),
                        array_over<Index>(std::vector(fault.triangles), {}),
                        array_over<Index>(std::vector(fault.vertices), {}));
}

MeshFault fault_of_state(const nb::tuple& state) {
  constexpr const char* what = "a pickled MeshFault";
  if (state.size() != 4) throw Error("a pickled MeshFault of another version");
  MeshFault fault{static_cast<MeshFaultKind>(nb::cast<int>(state[0])),
                  {},
                  indices_of(nb::object(state[2]), 1, what),
                  indices_of(nb::object(state[3]), 1, what)};
  const std::vector<Index> ends = indices_of(nb::object(state[1]), 2, what);
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) fault.edges.push_back({ends[i], ends[i + 1]});
  return fault;
}

void bind_faults(nb::module_& module) {
  nb::enum_<MeshFaultKind>(module, "MeshFaultKind", nb::is_arithmetic(),
                           "What is out of order at a place of a mesh: what MeshHealth counts under the same name.")
      .value("boundary_edges", MeshFaultKind::boundary_edges)
      .value("non_manifold_edges", MeshFaultKind::non_manifold_edges)
      .value("flipped_edges", MeshFaultKind::flipped_edges)
      .value("degenerate_triangles", MeshFaultKind::degenerate_triangles)
      .value("duplicate_triangles", MeshFaultKind::duplicate_triangles)
      .value("unused_vertices", MeshFaultKind::unused_vertices);
  nb::class_<MeshFault> bound(
      module, "MeshFault",
      "Faults of one kind that hang together through vertices: the edges around one hole, say. Its "
      "length is how many there are.");
  bound.def_ro("kind", &MeshFault::kind)
      .def_prop_ro(
          "edges",
          [](const MeshFault& fault) { return nb::borrow<Indices>(array_over<Index>(std::vector(fault.edges), {2})); },
          "By their vertices, shape (N, 2).")
      .def_prop_ro("triangles",
                   [](const MeshFault& fault) {
                     return nb::borrow<Indices>(array_over<Index>(std::vector(fault.triangles), {}));
                   })
      .def_prop_ro("vertices",
                   [](const MeshFault& fault) {
                     return nb::borrow<Indices>(array_over<Index>(std::vector(fault.vertices), {}));
                   })
      .def("__len__", &MeshFault::count)
      .def("__repr__", [](const MeshFault& fault) { return fmt::format("<toccata.MeshFault of {}>", fault.count()); });
  bind_answer_value(bound, &state_of_fault, &fault_of_state);
  module.def(
      "mesh_faults",
      [](const AnyShape& mesh) {
        const TriangleMesh& triangles = mesh_asked(mesh);
        return without_lock([&, kept = mesh.model] { return mesh_faults(triangles); });
      },
      nb::arg("mesh"),
      "Where the faults are that Mesh.health counts: by kind, then the larger first. Their counts add up to what it "
      "says. Raises Error for what is no Mesh.");
}

void bind_closing(nb::module_& module) {
  bind_answer<MeshRepair>(module);
  module.def(
      "close_mesh",
      [](const AnyShape& mesh, double gap) {
        const TriangleMesh& triangles = mesh_asked(mesh);
        MeshRepair done;
        Model closed = without_lock([&, kept = mesh.model] {
          RepairedMesh repaired = close_mesh(triangles, gap);
          done = repaired.repair;
          return Model(std::move(repaired.mesh));
        });
        return nb::make_tuple(shape_object(closed), done);
      },
      nb::arg("mesh"), nb::arg("gap"), nb::sig("def close_mesh(mesh: Mesh, gap: float) -> tuple[Mesh, MeshRepair]"),
      "Another mesh with the gaps closed that are no wider than `gap`, in the unit of the coordinates, and what was "
      "done: "
      "vertices of the boundary within it of each other become one, and holes are filled that are somewhere no wider. "
      "What "
      "is no boundary stays as it is. Raises Error for what is no Mesh, and when the gap is not positive and finite.");
  module.def(
      "closing_gap",
      [](const AnyShape& mesh) {
        const TriangleMesh& triangles = mesh_asked(mesh);
        return without_lock([&, kept = mesh.model] { return closing_gap(triangles); });
      },
      nb::arg("mesh"),
      "A gap by which close_mesh closes the mesh, in the unit of the coordinates, at most twice the least of some that "
      "are "
      "tried; 0 of a closed one, None where none does. Raises Error for what is no Mesh.");
  module.def(
      "mesh_parts",
      [](const AnyShape& mesh) {
        const TriangleMesh& triangles = mesh_asked(mesh);
        return nb::borrow<Indices>(array_over<Index>(
            without_lock([&, kept = mesh.model] { return mesh_parts(triangles).part_of_triangle; }), {}));
      },
      nb::arg("mesh"),
      "To which part of the mesh each triangle belongs, shape (M,): triangles are of one where they are connected "
      "through "
      "vertices, of equal coordinates taken as one. Raises Error for what is no Mesh.");
}

void bind_hulls(nb::module_& module) {
  module.def(
      "hull_of_half_spaces",
      [](const nb::sequence& half_spaces) {
        std::vector<HalfSpace> planes;
        for (const nb::handle each : half_spaces) {
          if (!nb::isinstance<AnyShape>(each) ||
              !std::holds_alternative<HalfSpace>(nb::cast<const AnyShape&>(each).model.shape()))
            throw Error(fmt::format("half_spaces: entry {} is no HalfSpace", planes.size()));
          planes.push_back(std::get<HalfSpace>(nb::cast<const AnyShape&>(each).model.shape()));
        }
        return shape_object(Model(without_lock([&] { return hull_of_half_spaces(planes); })));
      },
      nb::arg("half_spaces"),
      nb::sig("def hull_of_half_spaces(half_spaces: collections.abc.Sequence[HalfSpace]) -> ConvexHull"),
      "The solid that half-spaces have in common: its vertices are found exactly, and rounded to the nearest doubles, "
      "in "
      "the unit of the coordinates. "
      "It is found in one go: Ctrl-C is taken when it is. Raises Error when they have no point in common, naming at "
      "most four that have none, and when it is flat or has "
      "no "
      "end.");
  module.def(
      "view_frustum",
      [](const ArrayLike& eye, const ArrayLike& direction, const ArrayLike& up, double field_of_view, double aspect,
         double nearest, double farthest) {
        return shape_object(Model(view_frustum({vector_of(eye, "eye"), vector_of(direction, "direction"),
                                                vector_of(up, "up"), field_of_view, aspect, nearest, farthest})));
      },
      nb::arg("eye"), nb::arg("direction"), nb::arg("up") = nb::make_tuple(0.0, 1.0, 0.0), nb::kw_only(),
      nb::arg("field_of_view") = View{}.field_of_view, nb::arg("aspect") = View{}.aspect,
      nb::arg("nearest") = View{}.nearest, nb::arg("farthest") = View{}.farthest,
      nb::sig("def view_frustum(eye: numpy.typing.ArrayLike, direction: numpy.typing.ArrayLike, up: "
              "numpy.typing.ArrayLike = (0.0, 1.0, 0.0), *, field_of_view: float = 60.0, aspect: float = 1.0, nearest: "
              "float = 0.1, farthest: float = 1000.0) -> ConvexHull"),
      "The solid that a camera sees in perspective: field_of_view from the bottom of the picture to its top, in "
      "degrees; "
      "aspect, its width over its height; nearest and farthest, in the unit of the coordinates. eye, direction and up "
      "have the shape (3,), in the world. "
      "What it overlaps is in view. Raises Error that names a number out of range.");
}

void bind_scene_files(nb::module_& module) {
  module.def(
      "load_scene",
      [](const std::filesystem::path& path, const std::optional<std::string>& unit, double scale, bool split) {
        ReadOptions options{.scale = scale, .split = split};
        if (unit) options.metres_per_unit = metres_per_unit(*unit);
        return without_lock([&] { return scene_models(read_scene(path.string(), options)); });
      },
      nb::arg("path"), nb::arg("unit") = nb::none(), nb::kw_only(), nb::arg("scale") = 1.0, nb::arg("split") = false,
      "The objects of any file that is read, at their places: a mesh file as one, glTF and GLB as the meshes of their "
      "node "
      "tree, 3MF, and scene files (.json). unit: what a length of 1 in the file is, \"mm\", \"in\", or metres, as "
      "\"0.001\"; "
      "lengths are metres then. split: the objects of an OBJ file and the solids of a text STL file are each one. "
      "Raises "
      "Error naming the file and the line.");
}

}  // namespace

void bind_meshes(nb::module_& module) {
  bind_faults(module);
  bind_closing(module);
  bind_hulls(module);
  bind_scene_files(module);
}

}  // namespace toccata::python
