#include "overlap_bodies.hpp"

#include <nanobind/nanobind.h>

#include <utility>
#include <vector>

#include <toccata/query/overlap.hpp>

#include "depths.hpp"
#include "pair_arguments.hpp"
#include "shapes.hpp"

// What two solids have in common, as closed meshes.
namespace toccata::python {

void bind_overlap_bodies(nb::module_& module) {
  module.def(
      "overlap_bodies",
      [](const AnyShape& a, const AnyShape& b, const PoseLike& pose_a, const PoseLike& pose_b, Solid solid_a,
         Solid solid_b) {
        const PairQuery query = query_of(pose_a, pose_b, solid_a, solid_b);
        auto [meshes, volume] = asked_about(a.model, b.model, [&](const Model& x, const Model& y) {
          return std::pair(overlap_bodies(x, y, query), overlap_volume(x, y, query));
        });
        nb::list told;
        for (TriangleMesh& mesh : meshes) told.append(shape_object(Model(std::move(mesh))));
        return nb::make_tuple(told, volume);
      },
      nb::arg("a"), nb::arg("b"), nb::arg("pose_a") = nb::none(), nb::arg("pose_b") = nb::none(), nb::kw_only(),
      nb::arg("solid_a") = Solid::automatic, nb::arg("solid_b") = Solid::automatic,
      nb::sig("def overlap_bodies(a: Shape, b: Shape, pose_a: toccata._typing.PoseLike | None = None, pose_b: "
              "toccata._typing.PoseLike | None = None, *, solid_a: Solid = Solid.automatic, solid_b: Solid = "
              "Solid.automatic) -> tuple[list[Mesh], OverlapVolume]"),
      R"(What two solids have in common, as closed meshes, and how much volume that is, as overlap_volume tells it.

In the world, in the unit of the coordinates: one mesh, of compounds one of each two parts that overlap, none where they are
apart or merely touch. Which parts of each surface lie in the other solid is exact; corners at which surfaces cross are rounded,
and for round shapes stand polyhedra within. Signs that are 0 are decided by H. Edelsbrunner, E. P. Mücke, "Simulation of
simplicity", 1990. Raises Error like overlap_volume, and with the reason where a mesh is not proved to be right but for that
rounding: one of the two passes through itself there, or what they have in common is thinner than coordinates tell.)");
}

}  // namespace toccata::python
