#include "robots.hpp"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/robots.hpp>

#include "calls.hpp"
#include "scenes.hpp"
#include "shapes.hpp"
#include "values.hpp"

namespace toccata::python {

std::span<const double> Configurations::numbers() const {
  std::size_t count = 1;
  for (const std::size_t length : given.shape) count *= length;
  return {given.data, count};
}

namespace {

Configurations given_configurations(nb::handle given, const Robot& robot, std::string_view what, bool many) {
  const std::size_t positions = robot.positions().size();
  Configurations configurations{doubles(given, what)};
  if (!configurations.given.has_shape(many ? 2 : 1, {positions}))
    throw Error(
        fmt::format("{}: the robot has {} positions, so the shape {} is needed, and what is given has the shape {}",
                    what, positions, many ? fmt::format("(N, {})", positions) : fmt::format("({},)", positions),
                    shape_text(configurations.given.shape)));
  return configurations;
}

}  // namespace

Configurations configuration_of(nb::handle given, const Robot& robot, std::string_view what) {
  return given_configurations(given, robot, what, false);
}

Configurations configurations_of(nb::handle given, const Robot& robot, std::string_view what) {
  return given_configurations(given, robot, what, true);
}

Floats numbers_told(std::vector<double> numbers, const std::vector<std::size_t>& shape) {
  const nb::capsule owner = capsule_of(std::move(numbers));
  auto* data = static_cast<std::vector<double>*>(owner.data())->data();
  return nb::borrow<Floats>(
      nb::cast(nb::ndarray<nb::numpy, double>(data, shape.size(), shape.data(), owner), nb::rv_policy::reference));
}

std::string text_given(nb::handle given, std::string_view what) {
  std::string text;
  if (!nb::try_cast(given, text))
    throw Error(fmt::format("{}: {} is no text that can be written (UTF-8)", what, nb::repr(given).c_str()));
  return text;
}

std::vector<AllowedPair> allowed_pairs_of(nb::handle given, std::string_view what) {
  if (!nb::hasattr(given, "__iter__") || PyUnicode_Check(given.ptr()))
    throw Error(fmt::format("{}: a list of pairs of names is needed", what));
  std::vector<AllowedPair> pairs;
  for (const nb::handle pair : given) {
    const bool is_list = (PyTuple_Check(pair.ptr()) || PyList_Check(pair.ptr())) && nb::len(pair) >= 2;
    const auto name = [&](std::size_t i) { return nb::object(nb::borrow(pair)[i]); };
    if (!is_list || !PyUnicode_Check(name(0).ptr()) || !PyUnicode_Check(name(1).ptr()))
      throw Error(fmt::format("{}: entry {} is no pair of names", what, pairs.size()));
    pairs.push_back({text_given(name(0), what), text_given(name(1), what)});
  }
  return pairs;
}

namespace {

using Reasoned = std::tuple<std::string, std::string, std::string>;

std::vector<Reasoned> told(const std::vector<AllowedPair>& pairs) {
  std::vector<Reasoned> names;
  for (const AllowedPair& pair : pairs) names.emplace_back(pair.a, pair.b, std::string(name_of(pair.reason)));
  return names;
}

// Joints.

std::optional<std::pair<double, double>> limits_of(const std::optional<JointLimits>& limits) {
  return limits ? std::optional(std::pair(limits->lower, limits->upper)) : std::nullopt;
}

std::optional<std::tuple<std::string, double, double>> mimic_of(const RobotJoint& joint) {
  return joint.mimic ? std::optional(std::tuple(joint.mimic->joint, joint.mimic->multiplier, joint.mimic->offset))
                     : std::nullopt;
}

nb::tuple arguments_of(const RobotJoint& joint) {
  return nb::make_tuple(joint.name, joint.kind, joint.parent, joint.child, joint.origin, tuple_of(joint.axis),
                        limits_of(joint.limits), mimic_of(joint));
}

void bind_joint_kind(nb::module_& module) {
  nb::enum_<RobotJointKind>(module, "RobotJointKind", "How a link moves against the one that it hangs on.")
      .value("fixed", RobotJointKind::fixed, "Not at all; no position.")
      .value("revolute", RobotJointKind::revolute, "Turns about its axis within limits; one position, in radians.")
      .value("continuous", RobotJointKind::continuous, "The same without limits.")
      .value("prismatic", RobotJointKind::prismatic, "Slides along its axis; one position, a length.")
      .value("planar", RobotJointKind::planar, "Slides across its axis and turns about it: x, y and turn.")
      .value("floating", RobotJointKind::floating,
             "Freely: x, y, z, then roll, pitch and yaw about the fixed axes x, y and z.");
}

void bind_joint(nb::module_& module) {
  bind_joint_kind(module);
  nb::class_<RobotJoint> bound(module, "RobotJoint", R"(How one link of a robot hangs on another, as in URDF.

origin: where the child is in the parent's frame at the position 0, a rotation and a translation. axis: shape (3,), in the
child's frame. limits: (lower, upper) of the position, radians or a length in the unit of the coordinates (URDF: metres).
mimic: (joint, multiplier, offset), whose position it follows. Raises Error for what is no pose and no axis; what is wrong
among joints is told by Robot.)");
  bound
      .def(
          "__init__",
          [](RobotJoint* place, const std::string& name, RobotJointKind kind, const std::string& parent,
             const std::string& child, const PoseLike& origin, const ArrayLike& axis,
             const std::optional<std::pair<double, double>>& limits,
             const std::optional<std::tuple<std::string, double, double>>& mimic) {
            RobotJoint joint{name, kind, parent, child, pose_of(origin, "origin"), vector_of(axis, "axis"), {}, {}};
            if (limits) joint.limits = JointLimits{limits->first, limits->second};
            if (mimic) joint.mimic = JointMimic{std::get<0>(*mimic), std::get<1>(*mimic), std::get<2>(*mimic)};
            new (place) RobotJoint(std::move(joint));
          },
          nb::arg("name"), nb::arg("kind"), nb::arg("parent"), nb::arg("child"), nb::arg("origin") = nb::none(),
          nb::arg("axis") = nb::make_tuple(1.0, 0.0, 0.0), nb::arg("limits") = nb::none(),
          nb::arg("mimic") = nb::none())
      .def_ro("name", &RobotJoint::name)
      .def_ro("kind", &RobotJoint::kind)
      .def_ro("parent", &RobotJoint::parent, "A link, by name.")
      .def_ro("child", &RobotJoint::child, "A link, by name.")
      .def_ro("origin", &RobotJoint::origin)
      .def_prop_ro("axis", [](const RobotJoint& joint) { return array_of(joint.axis); })
      .def_prop_ro("limits", [](const RobotJoint& joint) { return limits_of(joint.limits); })
      .def_prop_ro("mimic", &mimic_of)
      .def("__repr__", [](const RobotJoint& joint) {
        return fmt::format("RobotJoint{}", nb::cast<std::string>(nb::repr(arguments_of(joint))));
      });
  bind_value(bound, [](const RobotJoint& joint) { return arguments_of(joint); });
}

RobotPosition position_of_state(const nb::tuple& state) {
  if (state.size() != 4) throw Error("a pickled RobotPosition of another version");
  RobotPosition position{nb::cast<std::string>(state[0]), nb::cast<Index>(state[1]), {}, nb::cast<bool>(state[3])};
  if (const auto limits = nb::cast<std::optional<std::pair<double, double>>>(state[2]))
    position.limits = JointLimits{limits->first, limits->second};
  return position;
}

void bind_position(nb::module_& module) {
  nb::class_<RobotPosition> bound(module, "RobotPosition", "One of the numbers that a configuration is made of.");
  bound.def_ro("name", &RobotPosition::name, "The joint's; of a planar or floating one with \"/x\", \"/y\", …")
      .def_ro("joint", &RobotPosition::joint, "The number of the joint.")
      .def_ro("turns", &RobotPosition::turns, "It is in radians; else a length.")
      .def_prop_ro("limits", [](const RobotPosition& position) { return limits_of(position.limits); })
      .def("__repr__", [](const RobotPosition& position) {
        return fmt::format("<toccata.RobotPosition: {}, {}>", position.name, position.turns ? "radians" : "a length");
      });
  bind_answer_value(
      bound,
      [](const RobotPosition& position) {
        return nb::make_tuple(position.name, position.joint, limits_of(position.limits), position.turns);
      },
      &position_of_state);
}

// Robots.

std::vector<std::string> link_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const RobotLink& link : robot.links()) names.push_back(link.name);
  return names;
}

RobotLink described_link(const std::string& name, nb::handle shapes) {
  RobotLink link{name, {}};
  for (const SceneInstance& shape : instances_of(shapes, fmt::format("link '{}'", name)))
    link.shapes.push_back({shape.model.shape(), shape.pose, shape.solid, shape.name});
  return link;
}

AttachedObject attached_of(nb::handle given, std::size_t number) {
  if (!PyTuple_Check(given.ptr()) || nb::len(given) != 5)
    throw Error(fmt::format("attached: entry {} is no (name, shapes, link, pose, touch_links)", number));
  const auto told = [&](std::size_t i) { return nb::object(nb::borrow(given)[i]); };
  std::vector<std::string> touch_links;
  if (!nb::try_cast(told(4), touch_links))
    throw Error(fmt::format("attached, entry {}: touch_links are a list of names of links", number));
  return {described_link(text_given(told(0), "attached"), told(1)), text_given(told(2), "attached"),
          pose_of(told(3), fmt::format("attached, entry {}", number)), std::move(touch_links)};
}

Robot described(const nb::dict& links, const nb::sequence& joints, const std::string& name, const PoseLike& base,
                const nb::sequence& attached) {
  RobotDescription robot{name, {}, {}, pose_of(base, "base")};
  for (const auto& [link, shapes] : links) {
    if (!PyUnicode_Check(link.ptr())) throw Error("links: names of links are needed as keys");
    robot.links.push_back(described_link(text_given(link, "links"), shapes));
  }
  for (const nb::handle joint : joints) {
    if (!nb::isinstance<RobotJoint>(joint))
      throw Error(fmt::format("joints: entry {} is no RobotJoint", robot.joints.size()));
    robot.joints.push_back(nb::cast<const RobotJoint&>(joint));
  }
  std::vector<AttachedObject> objects;
  for (const nb::handle object : attached) objects.push_back(attached_of(object, objects.size()));
  return without_lock([&] {
    Robot made(std::move(robot));
    for (const AttachedObject& object : objects) made = made.with_attached(object);
    return made;
  });
}

/// Where the root link is at every configuration.
Pose base_of(const Robot& robot) { return robot.link_poses(robot.rest())[robot.root()]; }

nb::object name_of_link(const Robot& robot, Index link) {
  return nb::cast(robot.links()[link].name);  // there may be a NUL in it
}

/// Of each link, its shapes as they were given.
std::vector<nb::list> shapes_of_links(const Robot& robot) {
  std::vector<nb::list> shapes(robot.links().size());
  for (const Robot::Body& body : robot.bodies())
    shapes[body.link].append(nb::cast(SceneInstance{body.model, body.pose, body.solid, body.name}));
  return shapes;
}

/// Links that were attached are the last ones, each with the last joints: of the first is told which they may touch,
/// that first on which they hang.
std::size_t count_attached(const Robot& robot) {
  std::size_t count = 0;
  std::optional<Index> last;
  for (const IndexPair& pair : robot.touching_attachments())
    if (std::exchange(last, pair.second) != pair.second) ++count;
  return count;
}

nb::list attached_told(const Robot& robot, const std::vector<nb::list>& shapes) {
  nb::list told;
  const std::size_t count = count_attached(robot), first = robot.links().size() - count;
  for (std::size_t link = first; link < robot.links().size(); ++link) {
    const RobotJoint& joint = robot.joints()[robot.joints().size() - robot.links().size() + link];
    nb::list touched;
    for (const IndexPair& pair : robot.touching_attachments())
      if (pair.second == link) touched.append(name_of_link(robot, pair.first));
    touched.attr("pop")(0);  // that on which it hangs
    told.append(nb::make_tuple(name_of_link(robot, static_cast<Index>(link)), shapes[link], nb::cast(joint.parent),
                               joint.origin, touched));
  }
  return told;
}

/// What `described` makes it of.
Making making_of_robot(const Robot& robot) {
  const std::vector<nb::list> shapes = shapes_of_links(robot);
  const std::size_t attached = count_attached(robot);
  nb::dict links, named;
  for (Index link = 0; link < robot.links().size() - attached; ++link) links[name_of_link(robot, link)] = shapes[link];
  nb::list joints;
  for (const RobotJoint& joint : robot.joints().first(robot.joints().size() - attached)) joints.append(nb::cast(joint));
  if (attached > 0) named["attached"] = attached_told(robot, shapes);
  return {nb::make_tuple(links, joints, robot.name(), base_of(robot)), named};
}

Floats limits_told(const Robot& robot) {
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> numbers;
  for (const RobotPosition& position : robot.positions()) {
    numbers.push_back(position.limits ? position.limits->lower : -none);
    numbers.push_back(position.limits ? position.limits->upper : none);
  }
  return numbers_told(std::move(numbers), {robot.positions().size(), 2});
}

/// Matrices (4, 4), in an array of this shape.
Floats matrices_told(const std::vector<Pose>& poses, const std::vector<std::size_t>& shape) {
  std::vector<double> numbers;
  numbers.reserve(16 * poses.size());
  for (const Pose& pose : poses) {
    for (int i = 0; i < 3; ++i)
      numbers.insert(numbers.end(), {pose.linear[i].x, pose.linear[i].y, pose.linear[i].z, pose.offset[i]});
    numbers.insert(numbers.end(), {0, 0, 0, 1});
  }
  return numbers_told(std::move(numbers), shape);
}

Robot read_robot(const std::filesystem::path& path, const std::vector<std::filesystem::path>& packages) {
  std::vector<std::string> folders;
  for (const std::filesystem::path& package : packages) folders.push_back(package.string());
  RobotFile file = without_lock([&] { return read_urdf(path.string(), {std::move(folders)}); });
  nb::module_ warnings = nb::module_::import_("warnings");
  for (const std::string& warning : file.warnings) warnings.attr("warn")(warning);
  return without_lock([&] { return Robot(std::move(file.description)); });
}

void write_robot(const Robot& robot, const std::filesystem::path& folder) {
  RobotDescription description{robot.name(), {}, {}, base_of(robot)};
  description.links.assign(robot.links().begin(), robot.links().end());
  description.joints.assign(robot.joints().begin(), robot.joints().end());
  without_lock([&] { write_urdf(description, folder.string()); });
}

void bind_making(nb::class_<Robot>& bound) {
  bound
      .def(
          "__init__",
          [](Robot* place, const nb::dict& links, const nb::sequence& joints, const std::string& name,
             const PoseLike& base,
             const nb::sequence& attached) { new (place) Robot(described(links, joints, name, base, attached)); },
          nb::arg("links"), nb::arg("joints") = nb::tuple(), nb::arg("name") = "", nb::arg("base") = nb::none(),
          nb::arg("attached") = nb::tuple(),
          nb::sig("def __init__(self, links: dict[str, toccata._typing.ObjectsLike], joints: "
                  "collections.abc.Sequence[RobotJoint] = (), name: str = '', base: toccata._typing.PoseLike | None = "
                  "None, attached: collections.abc.Sequence[tuple[str, toccata._typing.ObjectsLike, str, "
                  "toccata._typing.PoseLike | None, collections.abc.Sequence[str]]] = ()) -> None"))
      .def_static(
          "from_urdf", &read_robot, nb::arg("path"), nb::arg("packages") = nb::tuple(),
          nb::sig(
              "def from_urdf(path: str | os.PathLike, packages: collections.abc.Sequence[str | os.PathLike] = ()) -> "
              "Robot"),
          "Of a URDF file, with its meshes. package://name/path is looked for in `packages`, which are folders, "
          "before the folders that the file lies in. Lengths are metres. Raises Error naming the file, line and "
          "element, "
          "and for xacro, which is to be expanded first; warns of sizes that look like another unit, of glTF, whose y "
          "axis "
          "points up, and of links that have a picture alone.")
      .def_static(
          "generated",
          [](int subdivisions, std::uint64_t seed) {
            return Robot(generated_arm({subdivisions, seed}));
          },
          nb::arg("subdivisions") = 3, nb::arg("seed") = 1,
          "An arm of seven joints with a mesh of 20 · 4^subdivisions triangles for each link, 1.3 long: to try things "
          "with.")
      .def("write_urdf", &write_robot, nb::arg("folder"),
           "Writes folder/robot.urdf, and every mesh beside it as an OBJ file. Raises Error naming the file that holds "
           "something else already, and the link whose shape URDF has not.")
      .def(
          "with_attached",
          [](const Robot& robot, const std::string& name, const AnyShape& shape, const std::string& link,
             const PoseLike& pose, const std::vector<std::string>& touch_links) {
            return robot.with_attached({{name, {{shape.model.shape()}}}, link, pose_of(pose, "pose"), touch_links});
          },
          nb::arg("name"), nb::arg("shape"), nb::arg("link"), nb::arg("pose") = nb::none(),
          nb::arg("touch_links") = std::vector<std::string>{},
          nb::sig("def with_attached(self, name: str, shape: Shape, link: str, pose: toccata._typing.PoseLike | None = "
                  "None, touch_links: collections.abc.Sequence[str] = ()) -> Robot"),
          "A robot that holds a shape too: a link more, fixed to `link` at a pose in its frame, in the unit of the "
          "robot. It "
          "may touch that link "
          "and those that are named. Positions stay as they are. Raises Error for links that there are not.");
}

void bind_manners_of_robots(nb::class_<Robot>& bound) {
  bind_copying(bound);
  bind_pickling(bound, &making_of_robot);
  bind_equality(bound, [](const Robot& robot) {
    const Making making = making_of_robot(robot);  // links by their names, which tell not in what order they are
    return Making(nb::make_tuple(link_names(robot), making.arguments), making.named);
  });
  bound.def("__hash__", [](const Robot& robot) {
    return nb::hash(nb::make_tuple(robot.name(), nb::tuple(nb::cast(link_names(robot)))));
  });
}

void bind_parts_of_robot(nb::class_<Robot>& bound) {
  bound
      .def_prop_ro(
          "name", [](const Robot& robot) { return robot.name(); }, "As its file has it.")
      .def_prop_ro("links", &link_names, "Their names; a link's number is its place here.")
      .def_prop_ro(
          "joints", [](const Robot& robot) { return std::vector(robot.joints().begin(), robot.joints().end()); },
          "In order.")
      .def_prop_ro(
          "positions",
          [](const Robot& robot) { return std::vector(robot.positions().begin(), robot.positions().end()); },
          "What a configuration is made of, in the order of the joints; those that mimic have none.")
      .def_prop_ro("limits", &limits_told, "The least and the greatest of each position, shape (P, 2); infinite: none.")
      .def(
          "link_of", [](const Robot& robot, const std::string& name) { return robot.link_of(name); }, nb::arg("name"),
          "The number of a link. Raises Error with what may have been meant.")
      .def("__repr__", [](const Robot& robot) {
        return fmt::format("<toccata.Robot {}: {} links, {} positions>", robot.name(), robot.links().size(),
                           robot.positions().size());
      });
}

void bind_configurations(nb::class_<Robot>& bound) {
  bound
      .def(
          "rest", [](const Robot& robot) { return numbers_told(robot.rest(), {robot.positions().size()}); },
          "All positions 0, or the middle of limits that exclude 0; shape (P,).")
      .def(
          "sampled",
          [](const Robot& robot, std::size_t count, std::uint64_t seed) {
            return numbers_told(sampled_configurations(robot, count, seed), {count, robot.positions().size()});
          },
          nb::arg("count"), nb::arg("seed") = 1,
          "Random configurations within the limits, shape (count, P), in radians and the unit of the lengths; the same "
          "for "
          "the same seed.")
      .def(
          "read_configurations",
          [](const Robot& robot, const std::filesystem::path& path) {
            std::vector<double> numbers = read_configurations(path.string(), robot);
            const std::size_t positions = robot.positions().size(),
                              count = numbers.size() / std::max<std::size_t>(positions, 1);
            return numbers_told(std::move(numbers), {count, positions});
          },
          nb::arg("path"),
          "Of a file with a line of numbers for each, by commas or blanks, and names before them or the order of the "
          "positions: shape (N, P). Raises Error naming the file and the line.")
      .def(
          "beyond_limits",
          [](const Robot& robot, const ArrayLike& configuration) {
            return robot.beyond_limits(configuration_of(configuration, robot, "configuration").numbers());
          },
          nb::arg("configuration"),
          "The first position of a configuration, shape (P,), that is beyond its limits, or None. Other questions do "
          "not "
          "look at limits. Raises Error for another shape, and when a number is not finite.")
      .def(
          "link_poses",
          [](const Robot& robot, const ArrayLike& configuration) {
            const Configurations given = configuration_of(configuration, robot, "configuration");
            return matrices_told(robot.link_poses(given.numbers()), {robot.links().size(), 4, 4});
          },
          nb::arg("configuration"),
          "Where the links are in the world at a configuration, shape (P,): matrices, shape (L, 4, 4). Raises Error "
          "for "
          "another shape, and when a number is not finite.")
      .def(
          "link_poses_each",
          [](const Robot& robot, const ArrayLike& configurations, int threads) {
            const Configurations given = configurations_of(configurations, robot, "configurations");
            const auto poses = Interruptible(threads).ask([&, copy = robot](const BatchOptions& options) {
              return copy.link_poses_each(given.numbers(), options.threads, options.progress);
            });
            return matrices_told(poses, {given.given.rows(), robot.links().size(), 4, 4});
          },
          nb::arg("configurations"), nb::kw_only(), nb::arg("threads") = all_threads,
          "link_poses of many, shape (N, P), on all cores: matrices in the world, shape (N, L, 4, 4). Raises Error "
          "naming the "
          "configuration.")
      .def(
          "posed",
          [](const Robot& robot, const ArrayLike& configuration) {
            return robot.posed(configuration_of(configuration, robot, "configuration").numbers());
          },
          nb::arg("configuration"),
          "The shapes of the links where a configuration, shape (P,), puts them in the world, with names: for show, "
          "check_all "
          "and SceneIndex. Raises Error like link_poses.");
}

void bind_allowed(nb::class_<Robot>& bound) {
  bound
      .def(
          "srdf_pairs",
          [](const Robot& robot, const std::filesystem::path& path) { return told(read_srdf(path.string(), robot)); },
          nb::arg("path"),
          "The pairs of links that an SRDF file disables, for RobotScene(allowed=…): (a, b, \"given\"). Raises Error "
          "naming the file and the line.")
      .def(
          "adjacent_pairs", [](const Robot& robot) { return told(adjacent_pairs(robot)); },
          "Links with shapes that are joined by a joint, or by joints and links without shapes.")
      .def(
          "allowed_pairs",
          [](const Robot& robot, std::size_t samples, std::uint64_t seed, int threads) {
            return told(Interruptible(threads).ask([&, copy = robot](const BatchOptions& options) {
              return allowed_pairs_by_samples(
                  copy, {.samples = samples, .seed = seed, .threads = options.threads, .progress = options.progress});
            }));
          },
          nb::arg("samples") = 10'000, nb::arg("seed") = 1, nb::kw_only(), nb::arg("threads") = all_threads,
          "Pairs of links that need not be looked at, by samples, for RobotScene(allowed=…): (a, b, reason), where the "
          "reason is adjacent, always, at rest, or never, which is no proof.");
}

void bind_robot(nb::module_& module) {
  nb::class_<Robot> bound(module, "Robot", R"(A tree of links and joints. Immutable.

Robot(links, joints): links are names with the shapes of each, as SceneInstance takes them, in the link's frame; base is
where the root link is in the world. attached: what it holds, (name, shapes, link, pose, touch_links) of each, as with_attached
takes them. Configurations are arrays of a number for each of `positions`, in radians where it
turns and in the unit of the lengths where it slides (URDF: metres). Raises Error naming the link or joint: no tree, two of
one name, an axis or a number that is not finite, limits the wrong way round.)");
  bind_making(bound);
  bind_manners_of_robots(bound);
  bind_parts_of_robot(bound);
  bind_configurations(bound);
  bind_allowed(bound);
}

}  // namespace

void bind_robots(nb::module_& module) {
  bind_joint(module);
  bind_position(module);
  bind_robot(module);
  bind_robot_scenes(module);
}

}  // namespace toccata::python
