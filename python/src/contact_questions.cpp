#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/query/contacts.hpp>
#include <toccata/query/manifold.hpp>
#include <toccata/query/self_contacts.hpp>

#include "arrays.hpp"
#include "calls.hpp"
#include "contact_rows.hpp"
#include "manifold_values.hpp"
#include "pair_arguments.hpp"
#include "shapes.hpp"
#include "workspace.hpp"

namespace toccata::python {
namespace {

std::vector<ContactWithPoints> with_points(const std::vector<Contact>& contacts, const Model& a, const Model& b,
                                           const PairQuery& query) {
  std::vector<ContactWithPoints> told;
  told.reserve(contacts.size());
  for (const Contact& contact : contacts) {
    told.push_back({contact, {}});
    if (contact.intersection.kind == IntersectionKind::none) continue;
    const auto points = intersection_points(contact.intersection, world_triangle(a, query.pose_a, contact.element_a),
                                            world_triangle(b, query.pose_b, contact.element_b));
    std::copy_n(points.points.begin(), points.count, told.back().points.begin());
  }
  return told;
}

void bind_contacts(nb::module_& module) {
  const auto bind = [&](const char* name, const char* doc, auto ask) {
    module.def(
        name,
        [ask](const AnyShape& a, const AnyShape& b, const PoseLike& pose_a, const PoseLike& pose_b, Solid solid_a,
              Solid solid_b, int threads) {
          PairQuery query = query_of(pose_a, pose_b, solid_a, solid_b);
          query.threads = threads;
          return structured(
              asked_about(a.model, b.model, [&](const Model& x, const Model& y) { return ask(x, y, query); }));
        },
        nb::arg("a"), nb::arg("b"), nb::arg("pose_a") = nb::none(), nb::arg("pose_b") = nb::none(), nb::kw_only(),
        nb::arg("solid_a") = Solid::automatic, nb::arg("solid_b") = Solid::automatic, nb::arg("threads") = own_thread,
        doc);
  };
  bind("contacts", R"(All pairs of triangles, or of other elements, that have a point in common; exact and in order.

A structured array: element_a, element_b, face_a, face_b, kind (IntersectionKind), coplanar, crossing, point_count. A
shape inside a solid mesh that does not touch its surface has none: ask relation. Two triangles by T. Möller, "A fast
triangle-triangle intersection test", 1997, in exact signs. Shapes are where their poses put them in the world, in any unit.
Raises Error like overlap.)",
       [](const Model& a, const Model& b, const PairQuery& query) { return contacts(a, b, query); });
  bind("contacts_with_points", R"(contacts, with the points in which the triangles meet.

The array has a field more, points of the shape (6, 3): of each row the first point_count points are the corners of what
the triangles have in common, in the world and the unit of the coordinates, every number the nearest double; the others are
0. Where a shape is no mesh there are none: ask manifold. Raises Error like overlap.)",
       [](const Model& a, const Model& b, const PairQuery& query) {
         return with_points(contacts(a, b, query), a, b, query);
       });
}

void bind_contacts_of_many(nb::module_& module) {
  def_pair_questions(
      module, "contacts_each",
      "contacts of many, in shapes and unit as overlap_each takes them, on all cores: one structured array of "
      "all, in order, with the fields of contacts and before them query, which says of which question a "
      "row is. Raises Error like overlap_each.",
      [](const PairsAsked& pairs, int threads) {
        return structured(numbered<OfQuery>(asked_of_pairs(
            pairs, threads,
            [](const Batch<PairQuery>& batch, const BatchOptions& options) { return contacts_each(batch, options); })));
      });
  def_pair_question(module, "contact_regions",
                    R"(The places at which two meshes meet, the deepest first: a structured array.

One region is one connected part that two solids have in common, or one curve or area in which surfaces meet. The fields
are triangle_pairs, face_pairs, lower and upper (the corners of the box around it), point_count, closed, curve_count, area,
normal (from A to B), depth_lower and depth_upper (NaN where one is a surface), deepest (the deepest point); in the world and
the unit of the coordinates. Only the counts, closed and the bounds of the depth are exact. Raises Error like overlap, and for
what is no mesh or height field.)",
                    [](const AnyShape& a, const AnyShape& b, const PoseLike& pose_a, const PoseLike& pose_b,
                       Solid solid_a, Solid solid_b) {
                      const PairQuery query = query_of(pose_a, pose_b, solid_a, solid_b);
                      return structured(flat(asked_about(a.model, b.model, [&](const Model& x, const Model& y) {
                        return contact_regions(x, y, query);
                      })));
                    });
  def_pair_questions(
      module, "contact_regions_each",
      "contact_regions of many, in shapes as overlap_each takes them, on all cores: one structured array of all, in "
      "order, whose field query says of which question a row is; in the unit of the coordinates. Raises Error like "
      "contact_regions, naming the query.",
      [](const PairsAsked& pairs, int threads) {
        const auto found =
            asked_of_pairs(pairs, threads, [](const Batch<PairQuery>& batch, const BatchOptions& options) {
              return contact_regions_each(batch, options);
            });
        std::vector<std::vector<Region>> regions;
        for (const auto& each : found) regions.push_back(flat(each));
        return structured(numbered<OfQuery>(regions));
      });
}

void bind_self_contacts(nb::module_& module) {
  module.def(
      "self_contacts",
      [](const AnyShape& mesh, const PoseLike& pose) {
        const Pose placed = pose_of(pose, "pose");
        return structured(asked_about(mesh.model, [&](const Model& model) { return self_contacts(model, placed); }));
      },
      nb::arg("mesh"), nb::arg("pose") = nb::none(),
      "Where a mesh intersects itself: pairs of its triangles that have more in common than the corners they share. A "
      "structured array as of contacts, with element_a the lesser. Exact, in any unit. Raises Error for what is no "
      "mesh, "
      "and for a pose that is not finite.");
  module.def(
      "self_overlap",
      [](const AnyShape& mesh, const PoseLike& pose) {
        const Pose placed = pose_of(pose, "pose");
        return asked_about(mesh.model, [&](const Model& model) { return self_overlap(model, placed); });
      },
      nb::arg("mesh"), nb::arg("pose") = nb::none(),
      "Whether a mesh intersects itself. Exact, in any unit. Raises Error like "
      "self_contacts.");
}

nb::object positions_of(const Manifold& manifold) {
  std::vector<Vec3> positions;
  for (int i = 0; i < manifold.count; ++i) positions.push_back(manifold.points[static_cast<std::size_t>(i)].position);
  return array_over<double>(std::move(positions), {3});
}

nb::object depths_of(const Manifold& manifold) {
  std::vector<double> depths;
  for (int i = 0; i < manifold.count; ++i) depths.push_back(manifold.points[static_cast<std::size_t>(i)].depth);
  return array_over<double>(std::move(depths), {});
}

void bind_manifold(nb::module_& module) {
  nb::class_<Manifold> bound(
      module, "Manifold",
      "Where two convex shapes touch or overlap: up to four points that stand for the region of contact, "
      "rounded. Its length is the number of points, 0 when they are apart.");
  bound.def("__len__", [](const Manifold& m) { return m.count; })
      .def_prop_ro("count", [](const Manifold& m) { return m.count; })
      .def_prop_ro(
          "normal", [](const Manifold& m) { return array_of(m.normal); }, "Unit, from A to B; shape (3,).")
      .def_prop_ro(
          "positions", [](const Manifold& m) { return nb::borrow<Floats>(positions_of(m)); },
          "Half way between the two surfaces, in the world; shape (count, 3).")
      .def_prop_ro(
          "depths", [](const Manifold& m) { return nb::borrow<Floats>(depths_of(m)); },
          "How deep the surfaces overlap there along the normal; negative is a gap. Shape (count,).")
      .def("__repr__", [](const Manifold& m) { return fmt::format("<toccata.Manifold of {} points>", m.count); });
  bind_manifold_values(bound);
  bound.attr("__hash__") = nb::none();  // of ModelManifold too
  def_pair_question(
      module, "manifold",
      R"(Where two convex shapes, or one and a half-space, touch or overlap: up to four points and a normal.

Empty exactly when they are apart. In the world and the unit of the coordinates. Raises Error like overlap, and where it is
not defined, as of meshes: there is one for each contact.)",
      [](const AnyShape& a, const AnyShape& b, const PoseLike& pose_a, const PoseLike& pose_b, Solid solid_a,
         Solid solid_b) {
        const PairQuery query = query_of(pose_a, pose_b, solid_a, solid_b);
        return asked_about(a.model, b.model,
                           [&](const Model& x, const Model& y) { return manifold(x, y, query, kept_workspace()); });
      });
}

}  // namespace

void bind_contact_questions(nb::module_& module) {
  nb::enum_<IntersectionKind>(module, "IntersectionKind", nb::is_arithmetic(), "What two triangles have in common.")
      .value("none", IntersectionKind::none)
      .value("point", IntersectionKind::point)
      .value("segment", IntersectionKind::segment)
      .value("polygon", IntersectionKind::polygon, "They are coplanar and overlap.");
  bind_contacts(module);
  bind_contacts_of_many(module);
  bind_self_contacts(module);
  bind_manifold(module);
}

}  // namespace toccata::python
