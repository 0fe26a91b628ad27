#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/query/batch.hpp>
#include <toccata/query/overlap.hpp>

#include "arrays.hpp"
#include "calls.hpp"
#include "described.hpp"
#include "pair_arguments.hpp"
#include "shapes.hpp"
#include "workspace.hpp"

namespace toccata::python {
namespace {

/// A question about two shapes: `ask(a, b, query)`.
template <class Ask>
void bind_question(nb::module_& module, const char* name, const char* doc, Ask ask) {
  def_pair_question(module, name, doc,
                    [ask](const AnyShape& a, const AnyShape& b, const PoseLike& pose_a, const PoseLike& pose_b,
                          Solid solid_a, Solid solid_b) {
                      const PairQuery query = query_of(pose_a, pose_b, solid_a, solid_b);
                      return asked_about(a.model, b.model,
                                         [&](const Model& x, const Model& y) { return ask(x, y, query); });
                    });
}

/// The same with a length between the shapes and the poses: `ask(a, b, length, query)`.
template <class Ask>
void bind_question_of_length(nb::module_& module, const char* name, const char* length_name, const char* doc, Ask ask) {
  module.def(
      name,
      [ask](const AnyShape& a, const AnyShape& b, double length, const PoseLike& pose_a, const PoseLike& pose_b,
            Solid solid_a, Solid solid_b) {
        const PairQuery query = query_of(pose_a, pose_b, solid_a, solid_b);
        return asked_about(a.model, b.model, [&](const Model& x, const Model& y) { return ask(x, y, length, query); });
      },
      nb::arg("a"), nb::arg("b"), nb::arg(length_name), nb::arg("pose_a") = nb::none(), nb::arg("pose_b") = nb::none(),
      nb::kw_only(), nb::arg("solid_a") = Solid::automatic, nb::arg("solid_b") = Solid::automatic, doc);
}

template <class Answer>
struct ArrayOf {
  static Answers told(std::vector<Answer> answers) { return structured(std::move(answers)); }
};
template <>
struct ArrayOf<std::uint8_t> {
  static Booleans told(std::vector<std::uint8_t> answers) {
    static_assert(sizeof(bool) == 1);
    return nb::borrow<Booleans>(array_over<std::uint8_t>(std::move(answers), {}).attr("view")("?"));
  }
};

template <class Answer>
auto array_told(std::vector<Answer> answers) {
  return ArrayOf<Answer>::told(std::move(answers));
}

/// The question for many: `ask(batch, options)`.
template <class Ask>
void bind_questions(nb::module_& module, const char* name, const char* doc, Ask ask) {
  def_pair_questions(module, name, doc, [ask](const PairsAsked& pairs, int threads) {
    return array_told(asked_of_pairs(pairs, threads, ask));
  });
}

template <class Ask>
void bind_questions_of_length(nb::module_& module, const char* name, const char* length_name, const char* doc,
                              Ask ask) {
  module.def(
      name,
      [ask](const ShapesLike& a, const ShapesLike& b, double length, const PosesLike& poses_a, const PosesLike& poses_b,
            Solid solid_a, Solid solid_b, int threads) {
        const PairsAsked pairs(a, b, poses_a, poses_b, solid_a, solid_b);
        return array_told(asked_of_pairs(
            pairs, threads,
            [&](const Batch<PairQuery>& batch, const BatchOptions& options) { return ask(batch, length, options); }));
      },
      nb::arg("a"), nb::arg("b"), nb::arg(length_name), nb::arg("poses_a") = nb::none(),
      nb::arg("poses_b") = nb::none(), nb::kw_only(), nb::arg("solid_a") = Solid::automatic,
      nb::arg("solid_b") = Solid::automatic, nb::arg("threads") = all_threads, doc);
}

void bind_casts(nb::module_& module) {
  module.def(
      "cast_shape",
      [](const AnyShape& a, const ArrayLike& motion, const AnyShape& b, const PoseLike& pose_a, const PoseLike& pose_b,
         Solid solid_a, Solid solid_b) {
        const PairQuery query = query_of(pose_a, pose_b, solid_a, solid_b);
        const Vec3 way = vector_of(motion, "motion");
        return asked_about(a.model, b.model, [&](const Model& x, const Model& y) {
          return cast_shape(x, way, y, query, kept_workspace());
        });
      },
      nb::arg("a"), nb::arg("motion"), nb::arg("b"), nb::arg("pose_a") = nb::none(), nb::arg("pose_b") = nb::none(),
      nb::kw_only(), nb::arg("solid_a") = Solid::automatic, nb::arg("solid_b") = Solid::automatic,
      R"(Where A, moved from its pose by motion (shape (3,), in the world) without turning, first meets B, which stands;
None where it does not.

lower and upper are fractions of the way, from 0 to 1. That nothing is met is proved (conservative advancement: B. Mirtich,
"Impulse-based dynamic simulation of rigid body systems", 1996). Lengths are in the unit of the coordinates. Raises Error like
overlap, and where it is not defined, as of two half-spaces.)");
  module.def(
      "cast_shape_each",
      [](const AnyShape& a, const ArrayLike& motions, const AnyShape& b, const PosesLike& poses_a,
         const PosesLike& poses_b, Solid solid_a, Solid solid_b, int threads) {
        const std::vector<Vec3> ways = vectors_of(motions, "motions");
        const Poses of_a = poses_of(poses_a, "poses_a"), of_b = poses_of(poses_b, "poses_b");
        for (const Poses* poses : {&of_a, &of_b})
          if (!poses->is_single() && poses->size() != ways.size())
            throw Error(fmt::format("there are {} motions and {} poses; give as many, or one pose", ways.size(),
                                    poses->size()));
        const auto query = [&](std::size_t i) {
          return CastQuery{ways[i], {.pose_a = of_a[i], .pose_b = of_b[i], .solid_a = solid_a, .solid_b = solid_b}};
        };
        const Batch<CastQuery> batch(a.model, b.model, ways.size(), query);
        const Interruptible call(threads);
        return structured(call.ask([&](const BatchOptions& options) { return cast_shape_each(batch, options); }));
      },
      nb::arg("a"), nb::arg("motions"), nb::arg("b"), nb::arg("poses_a") = nb::none(), nb::arg("poses_b") = nb::none(),
      nb::kw_only(), nb::arg("solid_a") = Solid::automatic, nb::arg("solid_b") = Solid::automatic,
      nb::arg("threads") = all_threads,
      "cast_shape of many motions, shape (N, 3), in the world and the unit of the coordinates, and poses, N or one of "
      "each: a structured array with the members of ShapeHit, and found. Raises Error naming the least query that is "
      "asked "
      "wrongly.");
}

void bind_answers(nb::module_& module) {
  nb::enum_<RelationKind>(module, "RelationKind", nb::is_arithmetic(), "How two shapes lie.")
      .value("apart", RelationKind::apart)
      .value("touching", RelationKind::touching)
      .value("overlapping", RelationKind::overlapping, "Two solids have interior points in common.")
      .value("crossing", RelationKind::crossing, "A surface is involved.");
  nb::enum_<Containment>(module, "Containment", nb::is_arithmetic(), "Which of two shapes contains the other.")
      .value("none", Containment::none)
      .value("a_in_b", Containment::a_in_b)
      .value("b_in_a", Containment::b_in_a)
      .value("equal", Containment::equal);
  bind_answer<Distance>(module);
  bind_answer<Penetration>(module);
  bind_answer<Relation>(module);
  bind_answer<ShapeHit>(module);
}

void bind_single_questions(nb::module_& module) {
  bind_question(
      module, "overlap",
      R"(Have the two posed shapes a point in common? Exact; touching counts, and a shape inside a solid.

Shapes are where their poses put them in the world, in any unit that both have. Of cylinders, cones and ellipsoids a no is
proved, and what is undecided counts as yes. Raises Error when a pose is not finite, or one that its shape may not have, and
when an open mesh is asked about as a solid.)",
      [](const Model& a, const Model& b, const PairQuery& query) { return overlap(a, b, query, kept_workspace()); });
  bind_question(
      module, "relation",
      "How the two posed shapes lie in the world, exactly: apart, touching, overlapping or crossing, and which "
      "contains the other. Raises Error like overlap.",
      [](const Model& a, const Model& b, const PairQuery& query) { return relation(a, b, query, kept_workspace()); });
  bind_question(
      module, "distance",
      R"(How far the two posed shapes are apart, certified: an interval that contains the exact distance, and the nearest points.

0 when they meet, also when one lies within a solid. In the unit of the coordinates; the points are in the world. Convex
shapes by E. G. Gilbert, D. W. Johnson, S. S. Keerthi, "A fast procedure for computing the distance between complex objects
in three-dimensional space", 1988; that the interval holds is proved. Raises Error like overlap.)",
      [](const Model& a, const Model& b, const PairQuery& query) { return distance(a, b, query, kept_workspace()); });
  bind_question_of_length(
      module, "within_distance", "max_distance",
      "Is the exact distance at most the greatest one, in the unit of the coordinates? Decided exactly, and "
      "for less than the distance costs. Raises Error like overlap, and for a negative one.",
      [](const Model& a, const Model& b, double max_distance, const PairQuery& query) {
        return within_distance(a, b, max_distance, query, kept_workspace());
      });
  bind_question_of_length(
      module, "distance_within", "max_distance",
      "What distance answers where it is at most the greatest one, in the unit of the coordinates, else None, which is "
      "found out without it. Raises Error like overlap, and for a negative one.",
      [](const Model& a, const Model& b, double max_distance, const PairQuery& query) {
        return distance_within(a, b, max_distance, query, kept_workspace());
      });
  bind_question(module, "penetration", R"(How deep two solids overlap, as an interval, and a short way to part them.

Of convex shapes narrow; of meshes and compounds the bracket holds as well, and may be wide. In the unit of the
coordinates; direction and points are in the world (G. van den Bergen, "Proximity queries and penetration depth computation
on 3D game objects", 2001). Raises Error like overlap, and where it is not defined: for surfaces, open meshes, two
half-spaces.)",
                [](const Model& a, const Model& b, const PairQuery& query) {
                  return penetration(a, b, query, kept_workspace());
                });
}

void bind_questions_of_many(nb::module_& module) {
  bind_questions(
      module, "overlap_each", R"(overlap for many poses, on all cores: a bool for each.

Poses are N matrices of the shape (N, 4, 4) or (N, 3, 4), N translations (N, 3), N poses of scipy or toccata, or one for
all; a and b are one shape, or a list of N. Poses are in the world, their lengths in any unit that all have. Arrays of
doubles in C order are read as they are, others are converted first. Entry i is what overlap answers for pose i, whatever
the number of threads. Raises Error naming the least query that is asked wrongly.)",
      [](const Batch<PairQuery>& batch, const BatchOptions& options) { return overlap_each(batch, options); });
  bind_questions(
      module, "relation_each",
      "relation for many poses, in shapes and unit as overlap_each takes them, on all cores: a structured array with "
      "the "
      "members of Relation, kind and containment as numbers of their enumerations. Raises Error like overlap_each.",
      [](const Batch<PairQuery>& batch, const BatchOptions& options) { return relation_each(batch, options); });
  bind_questions(
      module, "distance_each",
      "distance for many poses, in shapes as overlap_each takes them, on all cores: a structured array with the "
      "members "
      "of Distance, in the unit of the coordinates. Raises Error like overlap_each.",
      [](const Batch<PairQuery>& batch, const BatchOptions& options) { return distance_each(batch, options); });
  bind_questions_of_length(
      module, "within_distance_each", "max_distance",
      "within_distance for many poses, in shapes as overlap_each takes them, on all cores: a bool for each. "
      "The greatest distance is in the unit of the coordinates. Raises Error like overlap_each, and for "
      "a negative one.",
      [](const Batch<PairQuery>& batch, double max_distance, const BatchOptions& options) {
        return within_distance_each(batch, max_distance, options);
      });
  bind_questions(
      module, "penetration_each",
      "penetration for many poses, in shapes as overlap_each takes them, on all cores: a structured array with the "
      "members of Penetration, in the unit of the coordinates. Raises Error like overlap_each, and where it is not "
      "defined, as penetration.",
      [](const Batch<PairQuery>& batch, const BatchOptions& options) { return penetration_each(batch, options); });
  bind_questions(
      module, "count_contacts_each",
      "How many triangles and faces meet, for many poses, in shapes and unit as overlap_each takes them, on all cores: "
      "a "
      "structured array with triangle_pairs and face_pairs. Raises Error like overlap_each.",
      [](const Batch<PairQuery>& batch, const BatchOptions& options) { return count_contacts_each(batch, options); });
}

}  // namespace

void bind_pair_questions(nb::module_& module) {
  bind_answers(module);
  bind_single_questions(module);
  bind_casts(module);
  bind_questions_of_many(module);
}

}  // namespace toccata::python
