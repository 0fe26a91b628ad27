#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/robots.hpp>

#include "arrays.hpp"
#include "calls.hpp"
#include "shapes.hpp"

namespace toccata::python {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Configurations of a robot: one, shape (P,), or many, shape (N, P).
struct GivenConfigurations {
  Doubles numbers;
  bool single = false;

  [[nodiscard]] std::span<const double> all() const {
    std::size_t count = 1;
    for (const std::size_t length : numbers.shape) count *= length;
    return {numbers.data, count};
  }
};

GivenConfigurations configurations_of(const ArrayLike& given, const Robot& robot, std::string_view what) {
  const std::size_t positions = robot.positions().size();
  GivenConfigurations configurations{doubles(given, what)};
  configurations.single = configurations.numbers.has_shape(1, {positions});
  if (!configurations.single && !configurations.numbers.has_shape(2, {positions}))
    throw Error(
        fmt::format("{}: the robot has {} positions, so the shape ({},) or (N, {}) is needed, and what is given "
                    "has the shape {}",
                    what, positions, positions, positions, shape_text(configurations.numbers.shape)));
  return configurations;
}

Floats numbers_told(std::vector<double> numbers) {
  return nb::borrow<Floats>(array_over<double>(std::move(numbers), {}));
}

Booleans booleans_told(std::vector<std::uint8_t> answers) {
  return nb::borrow<Booleans>(array_over<std::uint8_t>(std::move(answers), {}).attr("view")("?"));
}

/// Rows of so many numbers.
Floats rows_told(std::vector<double> numbers, std::initializer_list<std::size_t> of_each) {
  nb::list told;
  told.append(-1);
  for (const std::size_t length : of_each) told.append(length);
  return nb::borrow<Floats>(numbers_told(std::move(numbers)).attr("reshape")(nb::tuple(told)));
}

using NamedPair = std::pair<std::string, std::string>;

NamedPair names_of(const RobotContact& contact, const RobotScene& scene) {
  const auto links = scene.robot().links();
  return {links[contact.link].name,
          contact.with_obstacle ? scene.obstacles()[contact.other].name : links[contact.other].name};
}

std::vector<std::string> link_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const RobotLink& link : robot.links()) names.push_back(link.name);
  return names;
}

std::vector<std::string> position_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const RobotPosition& position : robot.positions()) names.push_back(position.name);
  return names;
}

Floats limits_of(const Robot& robot) {
  std::vector<double> numbers;
  for (const RobotPosition& position : robot.positions()) {
    numbers.push_back(position.limits ? position.limits->lower : -no_limit);
    numbers.push_back(position.limits ? position.limits->upper : no_limit);
  }
  return rows_told(std::move(numbers), {2});
}

/// Matrices (4, 4), one for each link.
Floats link_poses_told(const Robot& robot, const ArrayLike& configurations, int threads) {
  const GivenConfigurations given = configurations_of(configurations, robot, "configurations");
  const std::vector<Pose> poses = without_lock([&, copy = robot] {
    return given.single ? copy.link_poses(given.all()) : copy.link_poses_each(given.all(), threads);
  });
  std::vector<double> numbers;
  numbers.reserve(16 * poses.size());
  for (const Pose& pose : poses) {
    for (int i = 0; i < 3; ++i)
      numbers.insert(numbers.end(), {pose.linear[i].x, pose.linear[i].y, pose.linear[i].z, pose.offset[i]});
    numbers.insert(numbers.end(), {0, 0, 0, 1});
  }
  return given.single ? rows_told(std::move(numbers), {4, 4})
                      : rows_told(std::move(numbers), {robot.links().size(), 4, 4});
}

void bind_robot(nb::module_& module) {
  nb::class_<Robot>(module, "Robot",
                    "A tree of links and joints. Configurations are arrays of a number for each of its positions: "
                    "radians and the unit of the lengths (URDF: metres).")
      .def_static(
          "from_urdf",
          [](const std::string& path, const std::vector<std::string>& packages) {
            RobotFile file = without_lock([&] { return read_urdf(path, {packages}); });
            nb::module_ warnings = nb::module_::import_("warnings");
            for (const std::string& warning : file.warnings) warnings.attr("warn")(warning);
            return without_lock([&] { return Robot(std::move(file.description)); });
          },
          nb::arg("path"), nb::arg("packages") = std::vector<std::string>{},
          "Of a URDF file, with its meshes. `packages` are folders in which package://name/path is looked for, before "
          "the "
          "folders that the file lies in. Raises Error naming the file, line and element; warns of sizes that look "
          "like "
          "another unit.")
      .def_static(
          "generated", [] { return Robot(generated_arm()); },
          "An arm of seven joints with meshes, made from numbers: to try things with.")
      .def_prop_ro(
          "name", [](const Robot& robot) { return robot.name(); }, "As its file has it.")
      .def_prop_ro("links", &link_names, "Their names.")
      .def_prop_ro("positions", &position_names, "What a configuration is made of: joints by name, in this order.")
      .def_prop_ro("limits", &limits_of, "The least and the greatest of each position, shape (P, 2); infinite: none.")
      .def(
          "rest", [](const Robot& robot) { return numbers_told(robot.rest()); },
          "All positions 0, or the middle of limits that exclude 0; shape (P,).")
      .def(
          "sampled",
          [](const Robot& robot, std::size_t count, std::uint64_t seed) {
            return rows_told(sampled_configurations(robot, count, seed), {robot.positions().size()});
          },
          nb::arg("count"), nb::arg("seed") = 1, "Random configurations within the limits, shape (count, P).")
      .def("link_poses", &link_poses_told, nb::arg("configurations"), nb::kw_only(), nb::arg("threads") = all_threads,
           "Where the links are: matrices, shape (L, 4, 4) of one configuration, (N, L, 4, 4) of many.")
      .def(
          "with_attached",
          [](const Robot& robot, const std::string& name, const AnyShape& shape, const std::string& link,
             const PoseLike& pose, const std::vector<std::string>& touch_links) {
            return robot.with_attached({{name, {{shape.model.shape()}}}, link, pose_of(pose, "pose"), touch_links});
          },
          nb::arg("name"), nb::arg("shape"), nb::arg("link"), nb::arg("pose") = nb::none(),
          nb::arg("touch_links") = std::vector<std::string>{},
          "A robot that holds a shape too, fixed to a link at a pose in its frame; it may touch the links that are "
          "named.")
      .def(
          "srdf_pairs",
          [](const Robot& robot, const std::string& path) {
            std::vector<NamedPair> pairs;
            for (const AllowedPair& pair : read_srdf(path, robot)) pairs.emplace_back(pair.a, pair.b);
            return pairs;
          },
          nb::arg("path"), "The pairs of links that an SRDF file disables, for RobotScene(allowed=…).")
      .def(
          "allowed_pairs",
          [](const Robot& robot, std::size_t samples, std::uint64_t seed, int threads) {
            const auto found = without_lock([&, copy = robot] {
              return allowed_pairs_by_samples(copy, {.samples = samples, .seed = seed, .threads = threads});
            });
            std::vector<std::tuple<std::string, std::string, std::string>> pairs;
            for (const AllowedPair& pair : found) pairs.emplace_back(pair.a, pair.b, std::string(name_of(pair.reason)));
            return pairs;
          },
          nb::arg("samples") = 10'000, nb::arg("seed") = 1, nb::kw_only(), nb::arg("threads") = all_threads,
          "Pairs of links that need not be looked at, by samples, each with its reason: adjacent, always, at rest, "
          "never. "
          "`never` is no proof.");
}

/// Distances at configurations, as arrays.
struct RobotDistances {
  Floats lower, upper, on_link, on_other, gradient;
  std::vector<std::optional<NamedPair>> pairs;
};

RobotDistances distances_told(const RobotScene& scene, const std::vector<std::optional<RobotDistance>>& found) {
  const std::size_t positions = scene.robot().positions().size();
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> lower, upper, on_link, on_other, gradient;
  RobotDistances told;
  for (const std::optional<RobotDistance>& one : found) {
    const Vec3 nowhere{none, none, none};
    const Vec3 a = one ? one->distance.on_a : nowhere, b = one ? one->distance.on_b : nowhere;
    lower.push_back(one ? one->distance.lower : no_limit);
    upper.push_back(one ? one->distance.upper : no_limit);
    on_link.insert(on_link.end(), {a.x, a.y, a.z});
    on_other.insert(on_other.end(), {b.x, b.y, b.z});
    for (std::size_t i = 0; i < positions; ++i) gradient.push_back(one ? one->gradient[i] : none);
    told.pairs.push_back(one ? std::optional(names_of(one->pair, scene)) : std::nullopt);
  }
  told.lower = numbers_told(std::move(lower));
  told.upper = numbers_told(std::move(upper));
  told.on_link = rows_told(std::move(on_link), {3});
  told.on_other = rows_told(std::move(on_other), {3});
  told.gradient = rows_told(std::move(gradient), {positions});
  return told;
}

RobotScene scene_of(const Robot& robot, const nb::sequence& obstacles, const std::vector<NamedPair>& allowed,
                    bool allow_adjacent) {
  std::vector<SceneInstance> instances;
  for (const nb::handle given : obstacles) {
    const auto parts = nb::cast<nb::sequence>(given);
    const std::size_t count = nb::len(parts);
    const AnyShape* shape = nullptr;
    if (count < 1 || count > 3 || !nb::try_cast(parts[0], shape, false) || shape == nullptr)
      throw Error(fmt::format("obstacles: the {}-th is no shape, pose and name", instances.size()));
    instances.push_back({shape->model, count > 1 ? pose_of(parts[1], "the pose of an obstacle") : Pose{},
                         Solid::automatic,
                         count > 2 ? nb::cast<std::string>(parts[2]) : fmt::format("obstacle {}", instances.size())});
  }
  RobotSceneOptions options{{}, allow_adjacent};
  for (const NamedPair& pair : allowed) options.allowed.push_back({pair.first, pair.second});
  return without_lock([&] { return RobotScene(robot, instances, options); });
}

struct EdgesTold {
  Booleans free;
  Floats lower, upper;
  std::vector<std::optional<NamedPair>> pairs;
};

GivenConfigurations edge_ends(const ArrayLike& given, const Robot& robot, std::string_view what) {
  GivenConfigurations ends = configurations_of(given, robot, what);
  if (ends.single) throw Error(fmt::format("{}: configurations of the shape (N, P) are needed", what));
  return ends;
}

EdgesTold edges_told(const RobotScene& scene, const ArrayLike& from, const ArrayLike& to, double precision,
                     int threads) {
  const GivenConfigurations begins = edge_ends(from, scene.robot(), "from_"), ends = edge_ends(to, scene.robot(), "to");
  const std::vector<RobotEdge> edges = Interruptible(threads, false).ask([&](const BatchOptions& options) {
    return scene.edge_each(begins.all(), ends.all(),
                           {.precision = precision, .threads = options.threads, .progress = options.progress});
  });
  EdgesTold told;
  std::vector<std::uint8_t> free;
  std::vector<double> lower, upper;
  for (const RobotEdge& edge : edges) {
    free.push_back(edge.is_free ? 1 : 0);
    lower.push_back(edge.lower);
    upper.push_back(edge.upper);
    told.pairs.push_back(edge.is_free ? std::nullopt : std::optional(names_of(edge.pair, scene)));
  }
  told.free = booleans_told(std::move(free));
  told.lower = numbers_told(std::move(lower));
  told.upper = numbers_told(std::move(upper));
  return told;
}

void bind_robot_answers(nb::module_& module) {
  nb::class_<RobotDistances>(module, "RobotDistances", "The least distance at each of many configurations.")
      .def_ro("lower", &RobotDistances::lower, "The exact one is at least this; shape (N,).")
      .def_ro("upper", &RobotDistances::upper, "And at most this: 0 where they meet, infinite where there is none.")
      .def_ro("on_link", &RobotDistances::on_link, "The nearest point of the link; shape (N, 3).")
      .def_ro("on_other", &RobotDistances::on_other, "The nearest point of what it is near to; shape (N, 3).")
      .def_ro("gradient", &RobotDistances::gradient,
              "How it changes with each position, by the witness points; shape (N, P), 0 where they meet.")
      .def_ro("pairs", &RobotDistances::pairs, "Which link and which other, by name.");
  nb::class_<EdgesTold>(module, "RobotEdges", "What happens on the straight ways between configurations.")
      .def_ro("free", &EdgesTold::free, "Proved for every moment; shape (N,).")
      .def_ro("lower", &EdgesTold::lower, "Nothing is met before this part of the way.")
      .def_ro("upper", &EdgesTold::upper, "The first contact is here at the latest; 1 where it is free.")
      .def_ro("pairs", &EdgesTold::pairs, "What meets first, by name; None where it is free.");
}

void bind_robot_scene(nb::module_& module) {
  nb::class_<RobotScene>(module, "RobotScene", "A robot among obstacles. Answers are exact, on meshes too.")
      .def(
          "__init__",
          [](RobotScene* place, const Robot& robot, const nb::sequence& obstacles,
             const std::vector<NamedPair>& allowed,
             bool allow_adjacent) { new (place) RobotScene(scene_of(robot, obstacles, allowed, allow_adjacent)); },
          nb::arg("robot"), nb::arg("obstacles") = nb::tuple(), nb::kw_only(),
          nb::arg("allowed") = std::vector<NamedPair>{}, nb::arg("allow_adjacent") = true,
          "Obstacles are (shape,), (shape, pose) or (shape, pose, name). Pairs of names that are allowed are not "
          "looked "
          "at, nor, with allow_adjacent, links that a joint joins.")
      .def(
          "meets",
          [](const RobotScene& scene, const ArrayLike& configurations, int threads) {
            const GivenConfigurations given = configurations_of(configurations, scene.robot(), "configurations");
            if (given.single) return nb::object(nb::bool_(without_lock([&] { return scene.meets(given.all()); })));
            return nb::object(booleans_told(Interruptible(threads, false).ask([&](const BatchOptions& options) {
              return scene.meets_each(given.all(), options);
            })));
          },
          nb::arg("configurations"), nb::kw_only(), nb::arg("threads") = all_threads,
          nb::sig("def meets(self, configurations: numpy.typing.ArrayLike, *, threads: int = 0) -> "
                  "bool | toccata._typing.Booleans"),
          "Does any pair that is looked at have a point in common? A bool of one configuration, shape (P,), an array "
          "(N,) of many, shape (N, P).")
      .def(
          "contacts",
          [](const RobotScene& scene, const ArrayLike& configuration) {
            const GivenConfigurations given = configurations_of(configuration, scene.robot(), "configuration");
            if (!given.single) throw Error("configuration: one of the shape (P,) is needed");
            std::vector<NamedPair> pairs;
            for (const RobotContact& contact : without_lock([&] { return scene.contacts(given.all()); }))
              pairs.push_back(names_of(contact, scene));
            return pairs;
          },
          nb::arg("configuration"), "Which links meet which others, by name.")
      .def(
          "distances",
          [](const RobotScene& scene, const ArrayLike& configurations, double max_distance, int threads) {
            const GivenConfigurations given = edge_ends(configurations, scene.robot(), "configurations");
            return distances_told(scene, Interruptible(threads, false).ask([&](const BatchOptions& options) {
              return scene.distance_each(given.all(), max_distance, options);
            }));
          },
          nb::arg("configurations"), nb::arg("max_distance") = no_limit, nb::kw_only(),
          nb::arg("threads") = all_threads, "The least distance at each of many configurations, shape (N, P).")
      .def("edges", &edges_told, nb::arg("from_"), nb::arg("to"), nb::arg("precision") = 0x1p-20, nb::kw_only(),
           nb::arg("threads") = all_threads,
           "The straight ways from configurations, shape (N, P), to as many others: free at every moment, or when they "
           "first meet what.")
      .def(
          "free",
          [](const RobotScene& scene, const ArrayLike& from, const ArrayLike& to, double precision, int threads) {
            const GivenConfigurations begins = edge_ends(from, scene.robot(), "from_"),
                                      ends = edge_ends(to, scene.robot(), "to");
            return booleans_told(Interruptible(threads, false).ask([&](const BatchOptions& options) {
              return scene.free_each(
                  begins.all(), ends.all(),
                  {.precision = precision, .threads = options.threads, .progress = options.progress});
            }));
          },
          nb::arg("from_"), nb::arg("to"), nb::arg("precision") = 0x1p-20, nb::kw_only(),
          nb::arg("threads") = all_threads, "Only whether each is free; quicker. An array (N,).");
}

}  // namespace

void bind_robots(nb::module_& module) {
  bind_robot(module);
  bind_robot_answers(module);
  bind_robot_scene(module);
}

}  // namespace toccata::python
