#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/robots.hpp>

#include "calls.hpp"
#include "contact_rows.hpp"
#include "object_questions.hpp"
#include "robots.hpp"
#include "scenes.hpp"
#include "shapes.hpp"
#include "values.hpp"

namespace toccata::python {
namespace {

/// A RobotDistance without what has another length for each robot.
struct RobotNearest {
  RobotContact pair;
  Distance distance;
  Index body = 0;
  Index other_body = 0;
};

/// And with it.
struct RobotDistanceTold {
  RobotNearest nearest;
  std::vector<double> gradient;
};

}  // namespace

template <>
struct Described<RobotContact> {
  static constexpr const char* name = "RobotContact";
  static constexpr const char* doc =
      "A link and what it meets: another link, or an obstacle. RobotScene.names tells them.";
  static constexpr std::tuple fields{
      field<RobotContact, &RobotContact::link>("link", "The number of the link."),
      field<RobotContact, &RobotContact::with_obstacle>("with_obstacle", "The other is an obstacle, and else a link."),
      field<RobotContact, &RobotContact::other>("other", "The number of the other, as a link the greater.")};
};

template <>
struct Described<RobotNearest> {
  static constexpr const char* name = "RobotDistance";
  static constexpr const char* doc = "The least distance of a robot at a configuration; A is the link.";
  static constexpr auto fields =
      std::tuple_cat(fields_within<RobotNearest, &RobotNearest::pair>(Described<RobotContact>::fields),
                     fields_within<RobotNearest, &RobotNearest::distance>(Described<Distance>::fields),
                     std::tuple{field<RobotNearest, &RobotNearest::body>("body", "Which shape of the robot, of all."),
                                field<RobotNearest, &RobotNearest::other_body>(
                                    "other_body", "Which the other is, of a link; of an obstacle 0.")});
};

template <>
struct Described<RobotDistanceTold> {
  using Told = RobotDistanceTold;
  static constexpr const char* name = "RobotDistance";
  static constexpr const char* doc =
      "The least of the distances of all pairs that are looked at: the exact one lies in [lower, upper], in the unit "
      "of "
      "the coordinates, both 0 where they meet. A is the link.";
  static constexpr auto fields = std::tuple_cat(
      fields_within<Told, &Told::nearest>(Described<RobotNearest>::fields),
      std::tuple{field<Told, &Told::gradient>(
          "gradient",
          "How it changes with each position, per radian or per length, by the nearest points; shape (P,), all 0 where "
          "they meet. Where several pairs of points are nearest it is that of this pair.")});
};

template <>
struct Described<RobotEdge> {
  static constexpr const char* name = "RobotEdge";
  static constexpr const char* doc =
      "What happens on the straight way from one configuration to another, in the time from 0 to 1. Where it is not "
      "free, RobotScene.names tells which two meet first.";
  static constexpr auto fields = std::tuple_cat(
      std::tuple{field<RobotEdge, &RobotEdge::is_free>("is_free", "Proved for every moment."),
                 field<RobotEdge, &RobotEdge::lower>("lower", "Nothing is met before, which is proved."),
                 field<RobotEdge, &RobotEdge::upper>("upper", "The first contact is here at the latest; 1 if free."),
                 field<RobotEdge, &RobotEdge::status>(
                     "status", "exact: at `upper` they meet; undecided: they come nearer than can be told.")},
      fields_within<RobotEdge, &RobotEdge::pair>(Described<RobotContact>::fields));
};

namespace {

using NamedPair = std::pair<std::string, std::string>;

/// What an answer or a row of an array has under this name.
template <class Value>
Value member_of(nb::handle answer, const char* name) {
  return nb::cast<Value>(nb::hasattr(answer, name) ? nb::object(answer.attr(name))
                                                   : nb::object(answer[name].attr("item")()));
}

/// A RobotScene as Python holds it: with the options that made it, which its copies share.
struct HeldRobotScene : RobotScene {
  HeldRobotScene(const Robot& robot, std::span<const SceneInstance> obstacles, RobotSceneOptions given)
      : RobotScene(robot, obstacles, given), options(std::make_shared<const RobotSceneOptions>(std::move(given))) {}

  std::shared_ptr<const RobotSceneOptions> options;
};

Making making_of_scene(const HeldRobotScene& scene) {
  nb::list allowed;
  for (const AllowedPair& pair : scene.options->allowed) allowed.append(nb::make_tuple(pair.a, pair.b));
  nb::dict named;
  named["allowed"] = allowed;
  named["allow_adjacent"] = scene.options->allow_adjacent;
  const std::vector<SceneInstance> obstacles(scene.obstacles().begin(), scene.obstacles().end());
  return {nb::make_tuple(scene.robot(), obstacles), named};
}

NamedPair names_of(const HeldRobotScene& scene, nb::handle answer) {
  const auto links = scene.robot().links();
  const auto obstacles = scene.obstacles();
  const Index link = member_of<Index>(answer, "link"), other = member_of<Index>(answer, "other");
  const bool with_obstacle = member_of<bool>(answer, "with_obstacle");
  if (link >= links.size() || other >= (with_obstacle ? obstacles.size() : links.size()))
    throw Error("answer: it tells a link or an obstacle that this scene has not");
  const std::string& name = with_obstacle ? obstacles[other].name : links[other].name;
  return {links[link].name, name.empty() ? fmt::format("obstacle {}", other) : name};
}

RobotDistanceTold told(const RobotDistance& found) {
  return {{found.pair, found.distance, found.body, found.other_body}, found.gradient};
}

/// The members of RobotDistance and `found`: rows of numpy, since the gradient is as long as the robot has positions.
Answers distances_told(const std::vector<std::optional<RobotDistance>>& answers, std::size_t positions) {
  std::vector<std::optional<RobotNearest>> nearest(answers.size());
  std::vector<double> gradients(answers.size() * positions);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (!answers[i]) continue;
    nearest[i] = told(*answers[i]).nearest;
    std::ranges::copy(answers[i]->gradient, gradients.begin() + static_cast<std::ptrdiff_t>(i * positions));
  }
  const Answers rows = structured(nearest);
  nb::list members;
  for (const nb::handle name : rows.attr("dtype").attr("names"))
    members.append(nb::make_tuple(name, rows.attr("dtype").attr("fields")[name][0]));
  members.append(nb::make_tuple("gradient", "f8", nb::make_tuple(positions)));
  nb::object whole = nb::module_::import_("numpy").attr("zeros")(answers.size(), members);
  for (const nb::handle name : rows.attr("dtype").attr("names")) whole[name] = rows[name];
  whole["gradient"] = numbers_told(std::move(gradients), {answers.size(), positions});
  return nb::borrow<Answers>(whole);
}

HeldRobotScene scene_of(const Robot& robot, const ObjectsLike& obstacles, const nb::object& allowed,
                        bool allow_adjacent) {
  const std::vector<SceneInstance> instances = instances_of(obstacles, "obstacles");
  RobotSceneOptions options{{}, allow_adjacent};
  if (!allowed.is_none()) options.allowed = allowed_pairs_of(allowed, "allowed");
  return without_lock([&, copy = robot] { return HeldRobotScene(copy, instances, options); });
}

/// `ask(numbers, options)` of many configurations.
template <class Ask>
auto of_many(const HeldRobotScene& scene, const ArrayLike& configurations, int threads, const Ask& ask) {
  const Configurations given = configurations_of(configurations, scene.robot(), "configurations");
  return Interruptible(threads).ask(
      [&, copy = scene](const BatchOptions& options) { return ask(copy, given.numbers(), options); });
}

/// `ask(from, to, options)` of many ways.
template <class Ask>
auto of_many_ways(const HeldRobotScene& scene, const ArrayLike& from, const ArrayLike& to, double precision,
                  int threads, const Ask& ask) {
  const Configurations begins = configurations_of(from, scene.robot(), "begins"),
                       ends = configurations_of(to, scene.robot(), "ends");
  if (begins.given.rows() != ends.given.rows())
    throw Error(fmt::format("there are {} begins and {} ends; give as many", begins.given.rows(), ends.given.rows()));
  return Interruptible(threads).ask([&, copy = scene](const BatchOptions& options) {
    return ask(copy, begins.numbers(), ends.numbers(),
               EdgeOptions{.precision = precision, .threads = options.threads, .progress = options.progress});
  });
}

Booleans booleans_told(std::vector<std::uint8_t> answers) {
  return nb::borrow<Booleans>(array_over<std::uint8_t>(std::move(answers), {}).attr("view")("?"));
}

void bind_scene(nb::class_<HeldRobotScene>& bound) {
  bound
      .def(
          "__init__",
          [](HeldRobotScene* place, const Robot& robot, const ObjectsLike& obstacles, const nb::object& allowed,
             bool allow_adjacent) { new (place) HeldRobotScene(scene_of(robot, obstacles, allowed, allow_adjacent)); },
          nb::arg("robot"), nb::arg("obstacles") = nb::tuple(), nb::kw_only(), nb::arg("allowed") = nb::none(),
          nb::arg("allow_adjacent") = true,
          nb::sig("def __init__(self, robot: Robot, obstacles: toccata._typing.ObjectsLike = (), *, allowed: "
                  "toccata._typing.AllowedPairs | None = None, allow_adjacent: bool = True) -> None"))
      .def_prop_ro("robot", [](const HeldRobotScene& scene) { return scene.robot(); })
      .def_prop_ro(
          "obstacles",
          [](const HeldRobotScene& scene) { return std::vector(scene.obstacles().begin(), scene.obstacles().end()); },
          "In their order: their numbers are their places here.")
      .def("names", &names_of, nb::arg("answer"),
           nb::sig("def names(self, answer: RobotContact | RobotDistance | RobotEdge | numpy.void) -> tuple[str, str]"),
           "What the two of an answer, or of a row of an array of answers, are called: a link, and a link or an "
           "obstacle. "
           "Raises Error for an answer of another scene.")
      .def(
          "looks_at",
          [](const HeldRobotScene& scene, Index link, Index other, bool with_obstacle) {
            if (link >= scene.robot().links().size() ||
                other >= (with_obstacle ? scene.obstacles().size() : scene.robot().links().size()))
              throw Error("link, other: there is no link or obstacle of this number");
            const bool is_exchanged = !with_obstacle && other < link;
            return is_exchanged ? scene.looks_at({other, false, link}) : scene.looks_at({link, with_obstacle, other});
          },
          nb::arg("link"), nb::arg("other"), nb::arg("with_obstacle") = false,
          "Whether these two, told by their numbers, are looked at: two links in either order, or a link and an "
          "obstacle. "
          "Raises Error for a number that there is not.")
      .def("__repr__", [](const HeldRobotScene& scene) {
        return fmt::format("<toccata.RobotScene: {} among {} obstacles>", scene.robot().name(),
                           scene.obstacles().size());
      });
  bind_copying(bound);
  bind_pickling(bound, &making_of_scene);
}

void bind_contacts(nb::class_<HeldRobotScene>& bound) {
  bound
      .def(
          "meets",
          [](const HeldRobotScene& scene, const ArrayLike& configuration) {
            const Configurations given = configuration_of(configuration, scene.robot(), "configuration");
            return without_lock([&, copy = scene] { return copy.meets(given.numbers()); });
          },
          nb::arg("configuration"),
          "Does any pair that is looked at have a point in common, at a configuration, shape (P,)? Exact. Raises Error "
          "for "
          "another shape, and when a number is not finite.")
      .def(
          "meets_each",
          [](const HeldRobotScene& scene, const ArrayLike& configurations, int threads) {
            return booleans_told(of_many(scene, configurations, threads,
                                         [](const RobotScene& asked, auto numbers, const BatchOptions& options) {
                                           return asked.meets_each(numbers, options);
                                         }));
          },
          nb::arg("configurations"), nb::kw_only(), nb::arg("threads") = all_threads,
          "meets of many, shape (N, P), on all cores: an array of bools, shape (N,). Raises Error naming the "
          "configuration.")
      .def(
          "contacts",
          [](const HeldRobotScene& scene, const ArrayLike& configuration) {
            const Configurations given = configuration_of(configuration, scene.robot(), "configuration");
            return without_lock([&, copy = scene] { return copy.contacts(given.numbers()); });
          },
          nb::arg("configuration"),
          "Which links meet which others at a configuration, shape (P,); ascending. Exact. Raises "
          "Error like meets.")
      .def(
          "contacts_each",
          [](const HeldRobotScene& scene, const ArrayLike& configurations, int threads) {
            return structured(numbered<OfQuery>(of_many(
                scene, configurations, threads, [](const RobotScene& asked, auto numbers, const BatchOptions& options) {
                  return asked.contacts_each(numbers, ContactsTold::all, options);
                })));
          },
          nb::arg("configurations"), nb::kw_only(), nb::arg("threads") = all_threads,
          "contacts of many, shape (N, P), on all cores: one structured array of all, in order, with the members of "
          "RobotContact and query, which says of which configuration a row is. Raises Error naming the configuration.");
}

void bind_distances(nb::class_<HeldRobotScene>& bound) {
  bound
      .def(
          "distance",
          [](const HeldRobotScene& scene, const ArrayLike& configuration,
             double max_distance) -> std::optional<RobotDistanceTold> {
            const Configurations given = configuration_of(configuration, scene.robot(), "configuration");
            const auto found = without_lock([&, copy = scene] { return copy.distance(given.numbers(), max_distance); });
            return found ? std::optional(told(*found)) : std::nullopt;
          },
          nb::arg("configuration"), nb::arg("max_distance") = unlimited,
          "The least distance of all pairs that are looked at, at a configuration, shape (P,), with its gradient, in "
          "the unit "
          "of the coordinates; None where there is none within the greatest distance. Raises Error like meets, and for "
          "a "
          "greatest distance that is negative.")
      .def(
          "distance_each",
          [](const HeldRobotScene& scene, const ArrayLike& configurations, double max_distance, int threads) {
            return distances_told(of_many(scene, configurations, threads,
                                          [&](const RobotScene& asked, auto numbers, const BatchOptions& options) {
                                            return asked.distance_each(numbers, max_distance, options);
                                          }),
                                  scene.robot().positions().size());
          },
          nb::arg("configurations"), nb::arg("max_distance") = unlimited, nb::kw_only(),
          nb::arg("threads") = all_threads,
          "distance of many, shape (N, P), on all cores: a structured array with the members of RobotDistance, the "
          "gradient of the shape (P,), and found; in the unit of the coordinates. Raises Error naming the "
          "configuration.");
}

void bind_edges(nb::class_<HeldRobotScene>& bound) {
  const double usual = EdgeOptions{}.precision;
  bound
      .def(
          "edge",
          [](const HeldRobotScene& scene, const ArrayLike& begin, const ArrayLike& end, double precision) {
            const Configurations from = configuration_of(begin, scene.robot(), "begin"),
                                 to = configuration_of(end, scene.robot(), "end");
            return without_lock(
                [&, copy = scene] { return copy.edge(from.numbers(), to.numbers(), {.precision = precision}); });
          },
          nb::arg("begin"), nb::arg("end"), nb::arg("precision") = usual,
          "The straight way from one configuration to another, shapes (P,): free at every moment, or when which two "
          "first meet, as a part of the way, told within the precision, a part too (conservative advancement: B. "
          "Mirtich, "
          "\"Impulse-based dynamic simulation of rigid body systems\", 1996). Raises Error like meets, and for a "
          "precision "
          "below 2**-40 or above 1.")
      .def(
          "edge_each",
          [](const HeldRobotScene& scene, const ArrayLike& begins, const ArrayLike& ends, double precision,
             int threads) {
            return structured(of_many_ways(scene, begins, ends, precision, threads,
                                           [](const RobotScene& asked, auto from, auto to, const EdgeOptions& options) {
                                             return asked.edge_each(from, to, options);
                                           }));
          },
          nb::arg("begins"), nb::arg("ends"), nb::arg("precision") = usual, nb::kw_only(),
          nb::arg("threads") = all_threads,
          "edge of many, shapes (N, P), on all cores: a structured array with the members of RobotEdge. Raises Error "
          "naming "
          "the configuration.")
      .def(
          "free_each",
          [](const HeldRobotScene& scene, const ArrayLike& begins, const ArrayLike& ends, double precision,
             int threads) {
            return booleans_told(
                of_many_ways(scene, begins, ends, precision, threads,
                             [](const RobotScene& asked, auto from, auto to, const EdgeOptions& options) {
                               return asked.free_each(from, to, options);
                             }));
          },
          nb::arg("begins"), nb::arg("ends"), nb::arg("precision") = usual, nb::kw_only(),
          nb::arg("threads") = all_threads,
          "Only whether each edge, by its ends of the shapes (N, P), is free, which is quicker, on all cores: an array "
          "of "
          "bools, shape (N,). Raises Error like edge_each.");
}

void bind_obstacles(nb::module_& module) {
  module.def(
      "point_cloud",
      [](const ArrayLike& points, double radius, const std::string& name) {
        return point_cloud(vectors_of(points, "points"), radius, name);
      },
      nb::arg("points"), nb::arg("radius"), nb::arg("name") = "cloud",
      "A point cloud as an obstacle: a ball of this radius around each point, shape (N, 3), in the world and the unit "
      "of "
      "the coordinates. Raises Error without a point, and for a radius that is not positive.");
  module.def(
      "voxel_map",
      [](const ArrayLike& middles, double edge, const std::string& name) {
        return voxel_map(vectors_of(middles, "middles"), edge, name);
      },
      nb::arg("middles"), nb::arg("edge"), nb::arg("name") = "voxels",
      "The occupied cells of a voxel map or an octree, all of one size, as an obstacle: a cube of this edge around "
      "each middle, "
      "shape (N, 3), in the world and the unit of the coordinates. Raises Error like point_cloud.");
  module.def(
      "generated_room",
      [](std::size_t boxes, bool meshes, std::uint64_t seed) {
        if (boxes > 1'000'000) throw Error("boxes: at most 1,000,000");
        return generated_room({boxes, meshes, seed});
      },
      nb::arg("boxes") = 100, nb::arg("meshes") = true, nb::arg("seed") = 1,
      "What stands around Robot.generated(), in its unit: boxes that are turned any way, and three meshes. Raises "
      "Error "
      "for more than a million boxes.");
}

}  // namespace

void bind_robot_scenes(nb::module_& module) {
  bind_answer<RobotContact>(module);
  bind_answer<RobotDistanceTold>(module);
  bind_answer<RobotEdge>(module);
  nb::class_<HeldRobotScene> bound(module, "RobotScene",
                                   R"(A robot among obstacles, made ready for questions. Immutable.

What is said of a configuration is what overlap and distance say of the shapes at the places of Robot.posed, pair by pair:
exactly, on meshes too. Obstacles are SceneInstances, shapes, or pairs (shape, pose). Pairs of names in `allowed` are not
looked at, nor, with allow_adjacent, links that a joint joins, nor what an attached object may touch. Answers do not depend
on threads. Lengths are in the unit of the coordinates (URDF: metres). Raises Error for names that there are not, and naming
the obstacle that cannot be posed so.)");
  bind_scene(bound);
  bind_contacts(bound);
  bind_distances(bound);
  bind_edges(bound);
  bind_obstacles(module);
}

}  // namespace toccata::python
