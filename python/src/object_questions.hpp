#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/query/object_queries.hpp>

#include "calls.hpp"
#include "contact_rows.hpp"
#include "scenes.hpp"
#include "shapes.hpp"

// The questions that SceneIndex and World answer about all their objects (query/object_queries.hpp), bound once for
// both.
namespace toccata::python {

/// How the objects are told in Python. Specialised for SceneObjects and WorldBodies: what chooses
/// some of them, and the lists of them.
template <class Objects>
struct ObjectsTold;

/// "Scene" and "RayHit" as one name.
template <class Answer>
constexpr std::array<char, 32> prefixed(std::string_view prefix) {
  std::array<char, 32> text{};
  std::size_t length = 0;
  for (const char letter : prefix) text[length++] = letter;
  for (const char letter : std::string_view(Described<Answer>::name)) text[length++] = letter;
  return text;
}

template <class Objects, class Bound>
class ObjectQuestions {
 public:
  using Queries = ObjectQueries<Objects>;
  using Told = ObjectsTold<Objects>;
  template <class Answer>
  using Found = typename Queries::template Found<Answer>;

  explicit ObjectQuestions(nb::class_<Bound>& bound) : bound_(bound) {}

  void bind() {
    bind_rays();
    bind_moving();
    bind_lists();
    bind_nearest();
  }

 private:
  static SceneInstance instance(const AnyShape& shape, const PoseLike& pose, Solid solid) {
    return {shape.model, pose_of(pose, "pose"), solid};
  }
  static std::vector<Ray> rays(const ArrayLike& origins, const ArrayLike& motions) {
    const std::vector<Vec3> from = vectors_of(origins, "origins"), ways = vectors_of(motions, "motions");
    if (from.size() != ways.size())
      throw Error(fmt::format("there are {} origins and {} motions; give as many", from.size(), ways.size()));
    std::vector<Ray> rays(from.size());
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i] = {from[i], ways[i]};
    return rays;
  }
  /// `ask(queries, filter, options)`, of many.
  template <class Ask>
  static auto of_many(const Bound& bound, const nb::object& only, int threads, const Ask& ask) {
    const auto filter = Told::filter_of(bound, only);
    const Interruptible call(threads);
    return call.ask([&](const BatchOptions& options) {
      return bound.ask([&](const Queries& queries) { return ask(queries, filter, options); });
    });
  }
  /// `ask(queries, filter)`.
  template <class Ask>
  static auto of_one(const Bound& bound, const nb::object& only, const Ask& ask) {
    const auto filter = Told::filter_of(bound, only);
    return without_lock([&] { return bound.ask([&](const Queries& queries) { return ask(queries, filter); }); });
  }

  void bind_rays() {
    bound_.def(
        "cast_ray",
        [](const Bound& bound, const ArrayLike& origin, const ArrayLike& motion, const nb::object& only) {
          const Ray ray{vector_of(origin, "origin"), vector_of(motion, "motion")};
          return of_one(bound, only,
                        [&](const Queries& queries, const auto& filter) { return queries.cast_ray(ray, filter); });
        },
        nb::arg("origin"), nb::arg("motion"), nb::kw_only(), nb::arg("only") = nb::none(),
        "The first of all that the ray from origin to origin + motion meets, both of the shape (3,) in the world, or "
        "None, "
        "which is proved. As cast_ray of one shape, in the unit of the coordinates. Raises Error like it.");
    bound_.def(
        "cast_ray_through",
        [](const Bound& bound, const ArrayLike& origin, const ArrayLike& motion, const nb::object& only) {
          const Ray ray{vector_of(origin, "origin"), vector_of(motion, "motion")};
          return structured(of_one(bound, only, [&](const Queries& queries, const auto& filter) {
            return queries.cast_ray_through(ray, filter);
          }));
        },
        nb::arg("origin"), nb::arg("motion"), nb::kw_only(), nb::arg("only") = nb::none(),
        "Where the ray from origin to origin + motion, both of the shape (3,) in the world, meets each of them first, "
        "in "
        "order: a structured array with the members of what cast_ray returns, in the unit of the coordinates. Raises "
        "Error like cast_ray.");
    bound_.def(
        "cast_ray_each",
        [](const Bound& bound, const ArrayLike& origins, const ArrayLike& motions, const nb::object& only,
           int threads) {
          const std::vector<Ray> given = rays(origins, motions);
          return structured(of_many(bound, only, threads,
                                    [&](const Queries& queries, const auto& filter, const BatchOptions& options) {
                                      return queries.cast_ray_each(given, filter, options);
                                    }));
        },
        nb::arg("origins"), nb::arg("motions"), nb::kw_only(), nb::arg("only") = nb::none(),
        nb::arg("threads") = all_threads,
        "cast_ray of many rays, shapes (N, 3), on all cores: a structured array with the members of what cast_ray "
        "returns, "
        "and found; in the unit of the coordinates. Raises Error like cast_ray, naming the ray.");
  }

  void bind_moving() {
    bound_.def(
        "cast_shape",
        [](const Bound& bound, const AnyShape& shape, const ArrayLike& motion, const PoseLike& pose, Solid solid,
           const nb::object& only) {
          const MovingShape moving{instance(shape, pose, solid), vector_of(motion, "motion")};
          return of_one(bound, only,
                        [&](const Queries& queries, const auto& filter) { return queries.cast_shape(moving, filter); });
        },
        nb::arg("shape"), nb::arg("motion"), nb::arg("pose") = nb::none(), nb::kw_only(),
        nb::arg("solid") = Solid::automatic, nb::arg("only") = nb::none(),
        "The first of all that the shape, which is A, meets on its way from its pose by motion, shape (3,) in the "
        "world, or "
        "None, which is proved. As cast_shape of two, in the unit of the coordinates. Raises Error like it.");
    bound_.def(
        "cast_shape_each",
        [](const Bound& bound, const ShapesLike& shapes, const ArrayLike& motions, const PosesLike& poses, Solid solid,
           const nb::object& only, int threads) {
          const std::vector<Vec3> ways = vectors_of(motions, "motions");
          std::vector<SceneInstance> instances = instances_of(shapes, poses, solid);
          if (instances.size() == 1) instances.resize(ways.size(), instances.front());
          if (instances.size() != ways.size())
            throw Error(fmt::format("there are {} motions and {} shapes at their poses; give as many, or one shape",
                                    ways.size(), instances.size()));
          std::vector<MovingShape> moving;
          for (std::size_t i = 0; i < ways.size(); ++i) moving.push_back({std::move(instances[i]), ways[i]});
          return structured(of_many(bound, only, threads,
                                    [&](const Queries& queries, const auto& filter, const BatchOptions& options) {
                                      return queries.cast_shape_each(moving, filter, options);
                                    }));
        },
        nb::arg("shapes"), nb::arg("motions"), nb::arg("poses") = nb::none(), nb::kw_only(),
        nb::arg("solid") = Solid::automatic, nb::arg("only") = nb::none(), nb::arg("threads") = all_threads,
        "cast_shape of many motions, shape (N, 3), of one shape or N, at one pose or N, on all cores: a structured "
        "array "
        "with the members of what cast_shape returns, and found; in the unit of the coordinates. Raises Error like "
        "cast_shape, naming the query.");
  }

  void bind_lists() {
    bound_.def(
        "overlapping",
        [](const Bound& bound, const AnyShape& shape, const PoseLike& pose, Solid solid, const nb::object& only) {
          const SceneInstance asked = instance(shape, pose, solid);
          return Told::ids(of_one(bound, only, [&](const Queries& queries, const auto& filter) {
            return queries.overlapping(asked, filter);
          }));
        },
        nb::arg("shape"), nb::arg("pose") = nb::none(), nb::kw_only(), nb::arg("solid") = Solid::automatic,
        nb::arg("only") = nb::none(),
        "Which of them have a point in common with the shape at its pose in the world, ascending. Exact, in "
        "any unit. Raises Error like overlap.");
    bound_.def(
        "relations",
        [](const Bound& bound, const AnyShape& shape, const PoseLike& pose, Solid solid, const nb::object& only) {
          const SceneInstance asked = instance(shape, pose, solid);
          return structured(of_one(bound, only, [&](const Queries& queries, const auto& filter) {
            return queries.relations(asked, filter);
          }));
        },
        nb::arg("shape"), nb::arg("pose") = nb::none(), nb::kw_only(), nb::arg("solid") = Solid::automatic,
        nb::arg("only") = nb::none(),
        "overlapping, and how: the shape is A. A structured array with the members of Relation and which it is, in any "
        "unit. Raises Error like overlap.");
    bound_.def(
        "within",
        [](const Bound& bound, const AnyShape& shape, double max_distance, const PoseLike& pose, Solid solid,
           const nb::object& only) {
          const SceneInstance asked = instance(shape, pose, solid);
          return Told::ids(of_one(bound, only, [&](const Queries& queries, const auto& filter) {
            return queries.within(asked, max_distance, filter);
          }));
        },
        nb::arg("shape"), nb::arg("max_distance"), nb::arg("pose") = nb::none(), nb::kw_only(),
        nb::arg("solid") = Solid::automatic, nb::arg("only") = nb::none(),
        "Which of them are at most so far from the shape at its pose, in the unit of the coordinates, ascending. "
        "Decided "
        "exactly. Raises Error like within_distance.");
    bound_.def(
        "overlapping_each",
        [](const Bound& bound, const ShapesLike& shapes, const PosesLike& poses, Solid solid, const nb::object& only,
           int threads) {
          const std::vector<SceneInstance> asked = instances_of(shapes, poses, solid);
          return Told::rows(of_many(bound, only, threads,
                                    [&](const Queries& queries, const auto& filter, const BatchOptions& options) {
                                      return queries.overlapping_each(asked, filter, options);
                                    }));
        },
        nb::arg("shapes"), nb::arg("poses") = nb::none(), nb::kw_only(), nb::arg("solid") = Solid::automatic,
        nb::arg("only") = nb::none(), nb::arg("threads") = all_threads,
        "overlapping of one shape or N, at one pose or N, on all cores: one structured array of all that was found, in "
        "order, whose field query says of which question a row is. In any unit. Raises Error like overlap, naming the "
        "query.");
    bound_.def(
        "within_each",
        [](const Bound& bound, const ShapesLike& shapes, double max_distance, const PosesLike& poses, Solid solid,
           const nb::object& only, int threads) {
          const std::vector<SceneInstance> asked = instances_of(shapes, poses, solid);
          return Told::rows(of_many(bound, only, threads,
                                    [&](const Queries& queries, const auto& filter, const BatchOptions& options) {
                                      return queries.within_each(asked, max_distance, filter, options);
                                    }));
        },
        nb::arg("shapes"), nb::arg("max_distance"), nb::arg("poses") = nb::none(), nb::kw_only(),
        nb::arg("solid") = Solid::automatic, nb::arg("only") = nb::none(), nb::arg("threads") = all_threads,
        "within of one shape or N, at one pose or N, on all cores, in the unit of the coordinates: a structured array "
        "as "
        "that of overlapping_each. Raises Error like within_distance, naming the query.");
  }

  void bind_nearest() {
    bound_.def(
        "nearest",
        [](const Bound& bound, const AnyShape& shape, const PoseLike& pose, double max_distance, Solid solid,
           const nb::object& only) {
          const SceneInstance asked = instance(shape, pose, solid);
          return of_one(bound, only, [&](const Queries& queries, const auto& filter) {
            return queries.nearest(asked, max_distance, filter);
          });
        },
        nb::arg("shape"), nb::arg("pose") = nb::none(), nb::arg("max_distance") = unlimited, nb::kw_only(),
        nb::arg("solid") = Solid::automatic, nb::arg("only") = nb::none(),
        "The nearest of all to the shape, which is A, as distance tells it of two, in the unit of the coordinates; "
        "None "
        "where none is within the greatest distance, which is decided exactly. Raises Error like distance, and for a "
        "greatest distance that is negative.");
    bound_.def(
        "nearest_each",
        [](const Bound& bound, const ShapesLike& shapes, const PosesLike& poses, double max_distance, Solid solid,
           const nb::object& only, int threads) {
          const std::vector<SceneInstance> asked = instances_of(shapes, poses, solid);
          return structured(of_many(bound, only, threads,
                                    [&](const Queries& queries, const auto& filter, const BatchOptions& options) {
                                      return queries.nearest_each(asked, max_distance, filter, options);
                                    }));
        },
        nb::arg("shapes"), nb::arg("poses") = nb::none(), nb::arg("max_distance") = unlimited, nb::kw_only(),
        nb::arg("solid") = Solid::automatic, nb::arg("only") = nb::none(), nb::arg("threads") = all_threads,
        "nearest of one shape or N, at one pose or N, on all cores: a structured array with the members of what "
        "nearest "
        "returns, and found; in the unit of the coordinates. Raises Error like nearest, naming the query.");
  }

  nb::class_<Bound>& bound_;
};

/// The classes of single answers about one of the objects.
template <class Objects>
void bind_object_answers(nb::module_& module) {
  using Queries = ObjectQueries<Objects>;
  bind_answer<typename Queries::template Found<RayHit>>(module);
  bind_answer<typename Queries::template Found<ShapeHit>>(module);
  bind_answer<typename Queries::template Found<Distance>>(module);
}

}  // namespace toccata::python
