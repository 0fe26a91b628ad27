#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/query/batch.hpp>
#include <toccata/query/manifolds.hpp>
#include <toccata/query/overlap.hpp>
#include <toccata/query/penetration.hpp>

#include "contact_rows.hpp"
#include "depths.hpp"
#include "manifold_values.hpp"
#include "object_questions.hpp"
#include "pair_arguments.hpp"
#include "workspace.hpp"

// How deep, how much of it, and at which points two shapes overlap.
namespace toccata::python {

namespace {

void bind_brackets(nb::module_& module) {
  bind_answer<DepthBracket>(module);
  module.def(
      "depth_bracket",
      [](const AnyShape& a, const AnyShape& b, const PoseLike& pose_a, const PoseLike& pose_b, double precision,
         double time_limit, Solid solid_a, Solid solid_b) {
        const PairQuery query = query_of(pose_a, pose_b, solid_a, solid_b);
        const DepthOptions depth{precision, time_limit};
        return asked_about(a.model, b.model,
                           [&](const Model& x, const Model& y) { return depth_bracket(x, y, query, depth); });
      },
      nb::arg("a"), nb::arg("b"), nb::arg("pose_a") = nb::none(), nb::arg("pose_b") = nb::none(), nb::kw_only(),
      nb::arg("precision") = DepthOptions{}.precision, nb::arg("time_limit") = unlimited,
      nb::arg("solid_a") = Solid::automatic, nb::arg("solid_b") = Solid::automatic,
      R"(penetration, as narrow as asked: upper <= (1 + precision) * lower, or the bracket tells why not.

In the unit of the coordinates; direction and points are in the world. time_limit: seconds, after which nothing new is begun;
the answer depends on the machine then, as nothing else does. Raises Error like penetration, and for a precision or a limit
that is not above 0.)");
  module.def(
      "depth_bracket_each",
      [](const ShapesLike& a, const ShapesLike& b, const PosesLike& poses_a, const PosesLike& poses_b, double precision,
         double time_limit, Solid solid_a, Solid solid_b, int threads) {
        const PairsAsked pairs(a, b, poses_a, poses_b, solid_a, solid_b);
        const DepthOptions depth{precision, time_limit};
        return structured(
            asked_of_pairs(pairs, threads, [&](const Batch<PairQuery>& batch, const BatchOptions& options) {
              return depth_bracket_each(batch, depth, options);
            }));
      },
      nb::arg("a"), nb::arg("b"), nb::arg("poses_a") = nb::none(), nb::arg("poses_b") = nb::none(), nb::kw_only(),
      nb::arg("precision") = DepthOptions{}.precision, nb::arg("time_limit") = unlimited,
      nb::arg("solid_a") = Solid::automatic, nb::arg("solid_b") = Solid::automatic, nb::arg("threads") = all_threads,
      "depth_bracket of many, in shapes as overlap_each takes them, on all cores: a structured array with the members "
      "of "
      "DepthBracket, in the unit of the coordinates. The time limit is that of each. Raises Error like depth_bracket, "
      "naming the query.");
}

void bind_volume(nb::module_& module) {
  bind_answer<OverlapVolume>(module);
  def_pair_question(module, "overlap_volume",
                    R"(How much volume two solids have in common, as a bracket that holds the exact number.

In the third power of the unit of the coordinates. Of closed meshes, boxes and hulls it is as narrow as rounding; of what is
round some thousandths wide. Signs that are 0 are decided by H. Edelsbrunner, E. P. Mücke, "Simulation of simplicity", 1990.
Raises Error like overlap, and where one is a surface, and for two half-spaces.)",
                    [](const AnyShape& a, const AnyShape& b, const PoseLike& pose_a, const PoseLike& pose_b,
                       Solid solid_a, Solid solid_b) {
                      const PairQuery query = query_of(pose_a, pose_b, solid_a, solid_b);
                      return asked_about(a.model, b.model,
                                         [&](const Model& x, const Model& y) { return overlap_volume(x, y, query); });
                    });
}

/// What the manifolds hold, one after the other.
nb::tuple rows_told(const std::vector<Manifold>& manifolds) {
  std::vector<std::int32_t> counts;
  std::vector<Vec3> normals;
  std::vector<std::array<Vec3, 4>> positions;
  std::vector<std::array<double, 4>> depths;
  for (const Manifold& manifold : manifolds) {
    counts.push_back(manifold.count);
    normals.push_back(manifold.normal);
    positions.emplace_back();
    depths.emplace_back();
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
      positions.back()[i] = manifold.points[i].position;
      depths.back()[i] = manifold.points[i].depth;
    }
  }
  return nb::make_tuple(array_over<std::int32_t>(std::move(counts), {}), array_over<double>(std::move(normals), {3}),
                        array_over<double>(std::move(positions), {4, 3}), array_over<double>(std::move(depths), {4}));
}

nb::object elements_told(const std::array<Index, 4>& elements, int count) {
  return array_over<Index>(std::vector<Index>(elements.begin(), elements.begin() + count), {});
}

void bind_manifolds(nb::module_& module) {
  nb::class_<ModelManifold, Manifold> bound(module, "ModelManifold",
                                            "A Manifold, and the two elements at which each of its points lies.");
  bound
      .def_prop_ro(
          "elements_a",
          [](const ModelManifold& m) { return nb::borrow<Indices>(elements_told(m.elements_a, m.count)); },
          "Of A, of a mesh triangles; shape (count,).")
      .def_prop_ro(
          "elements_b",
          [](const ModelManifold& m) { return nb::borrow<Indices>(elements_told(m.elements_b, m.count)); }, "Of B.")
      .def("__repr__",
           [](const ModelManifold& m) { return fmt::format("<toccata.ModelManifold of {} points>", m.count); });
  bind_manifold_values(bound);
  def_pair_question(
      module, "manifolds",
      R"(Where any two shapes touch or overlap: of meshes and compounds one manifold for each normal of their contacts.

What slides over a surface does not catch on its inner edges: normals are of the Voronoi regions of the mesh (M. Lin,
J. Canny, "A fast algorithm for incremental distance calculation", 1991). In the world and the unit of the coordinates. Empty
exactly when they are apart, but for two half-spaces and for what lies wholly within where no penetration is defined. Raises
Error like overlap.)",
      [](const AnyShape& a, const AnyShape& b, const PoseLike& pose_a, const PoseLike& pose_b, Solid solid_a,
         Solid solid_b) {
        const PairQuery query = query_of(pose_a, pose_b, solid_a, solid_b);
        return asked_about(a.model, b.model, [&](const Model& x, const Model& y) { return manifolds(x, y, query); });
      });
  module.def(
      "manifold_each",
      [](const ShapesLike& a, const ShapesLike& b, const PosesLike& poses_a, const PosesLike& poses_b, int threads) {
        const PairsAsked pairs(a, b, poses_a, poses_b, Solid::automatic, Solid::automatic);
        return rows_told(asked_of_pairs(pairs, threads, [](const Batch<PairQuery>& batch, const BatchOptions& options) {
          return manifold_each(batch, options);
        }));
      },
      nb::arg("a"), nb::arg("b"), nb::arg("poses_a") = nb::none(), nb::arg("poses_b") = nb::none(), nb::kw_only(),
      nb::arg("threads") = all_threads,
      nb::sig(
          "def manifold_each(a: toccata._typing.ShapesLike, b: toccata._typing.ShapesLike, poses_a: "
          "toccata._typing.PosesLike | None = None, poses_b: toccata._typing.PosesLike | None = None, *, threads: int "
          "= 0) -> tuple[numpy.typing.NDArray[numpy.int32], toccata._typing.Floats, toccata._typing.Floats, "
          "toccata._typing.Floats]"),
      "manifold of many, in shapes as overlap_each takes them, on all cores: counts (N,), normals (N, 3), positions "
      "(N, 4, 3) and depths (N, 4), of which the first `count` of each are points and the others 0; in the unit of the "
      "coordinates. Raises Error like manifold, naming the query.");
}

void bind_first_contact(nb::module_& module) {
  def_pair_question(
      module, "first_contact",
      "The least of contacts, without the others; None where there is none. In any unit. Raises Error like overlap.",
      [](const AnyShape& a, const AnyShape& b, const PoseLike& pose_a, const PoseLike& pose_b, Solid solid_a,
         Solid solid_b) {
        const PairQuery query = query_of(pose_a, pose_b, solid_a, solid_b);
        return asked_about(a.model, b.model,
                           [&](const Model& x, const Model& y) { return first_contact(x, y, query); });
      });
}

void bind_distances_within(nb::module_& module) {
  module.def(
      "distance_within_each",
      [](const ShapesLike& a, const ShapesLike& b, double max_distance, const PosesLike& poses_a,
         const PosesLike& poses_b, Solid solid_a, Solid solid_b, int threads) {
        const PairsAsked pairs(a, b, poses_a, poses_b, solid_a, solid_b);
        return structured(
            asked_of_pairs(pairs, threads, [&](const Batch<PairQuery>& batch, const BatchOptions& options) {
              return distance_within_each(batch, max_distance, options);
            }));
      },
      nb::arg("a"), nb::arg("b"), nb::arg("max_distance"), nb::arg("poses_a") = nb::none(),
      nb::arg("poses_b") = nb::none(), nb::kw_only(), nb::arg("solid_a") = Solid::automatic,
      nb::arg("solid_b") = Solid::automatic, nb::arg("threads") = all_threads,
      "distance_within of many, in shapes as overlap_each takes them, on all cores: a structured array with the "
      "members "
      "of Distance, and found; in the unit of the coordinates. Raises Error like distance_within, naming the query.");
}

}  // namespace

void bind_depths(nb::module_& module) {
  bind_answer<Contact>(module);
  bind_brackets(module);
  bind_volume(module);
  bind_manifolds(module);
  bind_first_contact(module);
  bind_distances_within(module);
}

}  // namespace toccata::python
