#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "arguments.hpp"
#include "load.hpp"
#include "number_checks.hpp"
#include "option_kinds.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/version.hpp"
#include "toccata/io/query_files.hpp"
#include "toccata/reports/output_file.hpp"
#include "toccata/reports/pages.hpp"
#include "toccata/robots.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

using RobotJson = nlohmann::ordered_json;

struct RobotArguments {
  std::string file;
  std::string srdf;
  std::vector<std::string> packages;
  InputArguments scene;
  std::string cloud;           ///< a file of points; empty: none
  double radius = 0.01;        ///< of a ball around each
  std::string configurations;  ///< a file; empty: where the robot rests
  bool edges = false;
  bool distance = false;
  std::size_t find_allowed = 0;  ///< so many samples
  std::string write_urdf;        ///< a folder
  std::string html;
  Format format = Format::table;
  int threads = 0;
};

constexpr const char* generated_name = "gen:arm";

/// What is asked about.
struct AskedRobot {
  Robot robot;
  std::vector<AllowedPair> allowed;
  LoadedScene loaded{};
  std::vector<std::string> warnings{};
};

/// The folders that the user names, then those of ROS.
std::vector<std::string> package_folders_of(const RobotArguments& arguments) {
  std::vector<std::string> folders = arguments.packages;
  const auto add = [&](const char* variable, const std::string& below) {
    const char* value = std::getenv(variable);
    std::istringstream list(value == nullptr ? "" : value);
    for (std::string folder; std::getline(list, folder, ':');)
      if (!folder.empty()) folders.push_back(folder + below);
  };
  add("ROS_PACKAGE_PATH", "");
  add("AMENT_PREFIX_PATH", "/share");
  return folders;
}

AskedRobot asked_robot(const RobotArguments& arguments) {
  RobotFile file;
  if (arguments.file == generated_name)
    file.description = generated_arm({.subdivisions = 2});
  else
    file = read_urdf(arguments.file, {package_folders_of(arguments)});
  AskedRobot asked{Robot(file.description, arguments.threads), {}, {}, file.warnings};
  if (!arguments.srdf.empty()) asked.allowed = read_srdf(arguments.srdf, asked.robot);
  if (!arguments.scene.files.empty()) asked.loaded = load(arguments.scene);
  asked.warnings.insert(asked.warnings.end(), asked.loaded.warnings.begin(), asked.loaded.warnings.end());
  return asked;
}

/// The pair as people and reports name it.
struct PairNames {
  std::string link, other;
  bool is_obstacle;
};

PairNames names_of(const RobotContact& contact, const RobotScene& scene) {
  const auto links = scene.robot().links();
  return {links[contact.link].name,
          contact.with_obstacle ? scene.obstacles()[contact.other].name : links[contact.other].name,
          contact.with_obstacle};
}

std::string text_of_pair(const RobotContact& contact, const RobotScene& scene) {
  const PairNames names = names_of(contact, scene);
  return fmt::format("{} and {}", printable(names.link), printable(names.other));
}

RobotJson json_of_pair(const RobotContact& contact, const RobotScene& scene) {
  const PairNames names = names_of(contact, scene);
  return {{"link", names.link}, {"other", names.other}, {"obstacle", names.is_obstacle}};
}

/// What was found at the configurations and between them.
struct RobotAnswer {
  std::vector<double> configurations;
  std::vector<std::vector<RobotContact>> contacts;
  std::vector<std::optional<RobotDistance>> distances;  ///< none unless they were asked for
  std::vector<RobotEdge> edges;
};

RobotAnswer answer_of(const RobotScene& scene, const RobotArguments& arguments) {
  RobotAnswer answer;
  const Robot& robot = scene.robot();
  if (robot.positions().empty()) {
    answer.contacts = {scene.contacts({})};
    if (arguments.distance) answer.distances = {scene.distance({})};
    return answer;
  }
  answer.configurations =
      arguments.configurations.empty() ? robot.rest() : read_configurations(arguments.configurations, robot);
  ProgressBar bar("asking");
  const BatchOptions options{.threads = arguments.threads, .progress = bar.callback()};
  answer.contacts = scene.contacts_each(answer.configurations, ContactsTold::all, options);
  if (arguments.distance)
    answer.distances = scene.distance_each(answer.configurations, std::numeric_limits<double>::infinity(), options);
  if (arguments.edges) {
    const std::span<const double> all(answer.configurations);
    const std::size_t one = robot.positions().size();
    answer.edges = scene.edge_each(all.first(all.size() - one), all.subspan(one),
                                   {.threads = arguments.threads, .progress = bar.callback()});
  }
  return answer;
}

std::string contacts_text(const std::vector<RobotContact>& contacts, const RobotScene& scene) {
  std::string text;
  for (const RobotContact& contact : contacts) text += (text.empty() ? "" : "; ") + text_of_pair(contact, scene);
  return text;
}

std::string distance_text_of(const std::optional<RobotDistance>& distance, const RobotScene& scene) {
  if (!distance) return "nothing to be near to";
  return fmt::format("{:.9g} from {} to {}", distance->distance.upper, printable(names_of(distance->pair, scene).link),
                     printable(names_of(distance->pair, scene).other));
}

std::vector<std::string> row_of_edge(const RobotEdge& edge, std::size_t number, const RobotScene& scene) {
  const std::string name = fmt::format("from {} to {}", number, number + 1);
  if (edge.is_free) return {name, "free", ""};
  return {name, edge.status == Status::exact ? "meets" : "may meet",
          fmt::format("{}, at fraction {:.6f} of the edge", text_of_pair(edge.pair, scene), edge.upper)};
}

std::string text_of_answer(const RobotAnswer& answer, const RobotScene& scene) {
  std::vector<std::vector<std::string>> rows;
  std::size_t meeting = 0;
  for (std::size_t i = 0; i < answer.contacts.size(); ++i) {
    const bool meets = !answer.contacts[i].empty();
    meeting += meets ? 1U : 0U;
    rows.push_back({fmt::format("configuration {}", i), meets ? "meets" : "free",
                    meets                      ? contacts_text(answer.contacts[i], scene)
                    : answer.distances.empty() ? ""
                                               : distance_text_of(answer.distances[i], scene)});
  }
  std::size_t not_free = 0;
  for (std::size_t i = 0; i < answer.edges.size(); ++i) {
    rows.push_back(row_of_edge(answer.edges[i], i, scene));
    not_free += answer.edges[i].is_free ? 0U : 1U;
  }
  std::string text = columns(rows, 2) + fmt::format("{} of {} meet, decided exactly", grouped(meeting),
                                                    counted(answer.contacts.size(), "configuration"));
  if (!answer.edges.empty())
    text += fmt::format("; {} of {} free, proved for every moment", grouped(answer.edges.size() - not_free),
                        counted(answer.edges.size(), "edge"));
  return text + ".\n";
}

std::string text_of_robot(const AskedRobot& asked) {
  const Robot& robot = asked.robot;
  std::size_t triangles = 0;
  for (const Robot::Body& body : robot.bodies())
    if (body.model.has_mesh()) triangles += body.model.mesh().triangle_count();
  return fmt::format("{}: {}, {}, {} that can be chosen, {}\n", printable(robot.name()),
                     counted(robot.links().size(), "link"), counted(robot.joints().size(), "joint"),
                     counted(robot.positions().size(), "position"), counted(triangles, "triangle"));
}

RobotJson json_of_robot(const AskedRobot& asked, const RobotScene& scene, const RobotArguments& arguments) {
  RobotJson json = {{"schema", "toccata/robot/1"},    {"version", version},          {"file", arguments.file},
                    {"robot", asked.robot.name()},    {"links", RobotJson::array()}, {"positions", RobotJson::array()},
                    {"obstacles", RobotJson::array()}};
  for (const RobotLink& link : asked.robot.links()) json["links"].push_back(link.name);
  for (const RobotPosition& position : asked.robot.positions()) {
    RobotJson one = {{"name", position.name}, {"unit", position.turns ? "rad" : "m"}};
    if (position.limits) one["lower"] = position.limits->lower, one["upper"] = position.limits->upper;
    json["positions"].push_back(one);
  }
  for (const SceneInstance& obstacle : scene.obstacles()) json["obstacles"].push_back(obstacle.name);
  return json;
}

RobotJson json_of_distance(const RobotDistance& found, const RobotScene& scene) {
  const auto point = [](const Vec3& p) { return RobotJson{p.x, p.y, p.z}; };
  RobotJson json = json_of_pair(found.pair, scene);
  json["lower"] = found.distance.lower;
  json["upper"] = found.distance.upper;
  json["on_link"] = point(found.distance.on_a);
  json["on_other"] = point(found.distance.on_b);
  json["gradient"] = found.gradient;
  return json;
}

void add_answer(const RobotAnswer& answer, const RobotScene& scene, RobotJson& json) {
  const std::size_t one = scene.robot().positions().size();
  json["configurations"] = RobotJson::array();
  for (std::size_t i = 0; i < answer.contacts.size(); ++i) {
    const auto numbers = std::span(answer.configurations).subspan(i * one, one);
    RobotJson entry = {{"positions", std::vector(numbers.begin(), numbers.end())},
                       {"meets", !answer.contacts[i].empty()},
                       {"contacts", RobotJson::array()}};
    for (const RobotContact& contact : answer.contacts[i]) entry["contacts"].push_back(json_of_pair(contact, scene));
    if (!answer.distances.empty() && answer.distances[i])
      entry["distance"] = json_of_distance(*answer.distances[i], scene);
    json["configurations"].push_back(entry);
  }
  if (answer.edges.empty()) return;
  json["edges"] = RobotJson::array();
  for (const RobotEdge& edge : answer.edges) {
    RobotJson entry = {{"free", edge.is_free}};
    if (!edge.is_free) {
      entry["lower"] = edge.lower;
      entry["upper"] = edge.upper;
      entry["status"] = edge.status == Status::exact ? "exact" : "undecided";
      entry["pair"] = json_of_pair(edge.pair, scene);
    }
    json["edges"].push_back(entry);
  }
}

/// The bodies where a configuration puts them, and the pairs that meet, as a page that steps through configurations.
class RobotFilm {
 public:
  explicit RobotFilm(const RobotScene& scene) : scene_(scene), world_({.distance = false, .contacts = true}) {
    const std::vector<SceneInstance> posed = scene.robot().posed(scene.robot().rest());
    for (const SceneInstance& body : posed)
      ids_.push_back(world_.add(Body{.model = body.model, .pose = body.pose, .solid = body.solid, .name = body.name}));
    for (const SceneInstance& obstacle : scene.obstacles())
      obstacles_.push_back(world_.add(Body{.model = obstacle.model,
                                           .pose = obstacle.pose,
                                           .type = BodyType::static_body,
                                           .solid = obstacle.solid,
                                           .name = obstacle.name}));
    leave_out_allowed();
  }

  void add(std::span<const double> configuration, const std::string& label) {
    std::vector<Pose> poses;
    for (const SceneInstance& body : scene_.robot().posed(configuration)) poses.push_back(body.pose);
    world_.move(ids_, poses);
    world_.step();
    recording_.add(world_, label);
  }

  void write(const std::string& path) const {
    write_view_page(world_page(recording_, {.title = scene_.robot().name()}), path);
  }

 private:
  void leave_out_allowed() {
    const auto bodies = scene_.robot().bodies();
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      for (std::size_t j = i + 1; j < ids_.size(); ++j) {
        const auto [a, b] = std::minmax(bodies[i].link, bodies[j].link);
        if (a == b || !scene_.looks_at({a, false, b})) world_.set_rule({.a = ids_[i], .b = ids_[j], .excluded = true});
      }
      for (Index j = 0; j < obstacles_.size(); ++j)
        if (!scene_.looks_at({bodies[i].link, true, j}))
          world_.set_rule({.a = ids_[i], .b = obstacles_[j], .excluded = true});
    }
  }

  const RobotScene& scene_;
  World world_;
  std::vector<BodyId> ids_, obstacles_;
  WorldRecording recording_;
};

/// Frames between configurations where edges were asked about.
constexpr int frames_of_edge = 8;

void write_film(const RobotAnswer& answer, const RobotScene& scene, const RobotArguments& arguments) {
  RobotFilm film(scene);
  const std::size_t one = scene.robot().positions().size();
  const std::span<const double> all(answer.configurations);
  for (std::size_t i = 0; i < answer.contacts.size(); ++i) {
    const auto here = all.subspan(i * one, one);
    film.add(here, fmt::format("configuration {}", i));
    if (!arguments.edges || i + 1 == answer.contacts.size()) continue;
    const auto next = all.subspan((i + 1) * one, one);
    for (int k = 1; k < frames_of_edge; ++k) {
      const double time = static_cast<double>(k) / frames_of_edge;
      std::vector<double> between(one);
      for (std::size_t j = 0; j < one; ++j) between[j] = here[j] + time * (next[j] - here[j]);
      film.add(between, fmt::format("from {} to {}, at {}", i, i + 1, time));
    }
  }
  const UninterruptedWriting writing;
  film.write(arguments.html);
}

/// As an SRDF file has them.
std::string srdf_of(const Robot& robot, const std::vector<AllowedPair>& pairs) {
  const auto word = [](AllowedReason reason) {
    switch (reason) {
      case AllowedReason::adjacent:
        return "Adjacent";
      case AllowedReason::always:
        return "Always";
      case AllowedReason::at_rest:
        return "Default";
      case AllowedReason::never:
        return "Never";
      default:
        return "User";
    }
  };
  std::string text = fmt::format("<robot name=\"{}\">\n", robot.name());
  for (const AllowedPair& pair : pairs)
    text += fmt::format("  <disable_collisions link1=\"{}\" link2=\"{}\" reason=\"{}\"/>\n", pair.a, pair.b,
                        word(pair.reason));
  return text + "</robot>\n";
}

int find_allowed(const AskedRobot& asked, const RobotArguments& arguments) {
  ProgressBar bar("sampling");
  const std::vector<AllowedPair> pairs = allowed_pairs_by_samples(
      asked.robot, {.samples = arguments.find_allowed, .threads = arguments.threads, .progress = bar.callback()});
  if (arguments.format != Format::json) {
    print_answer(srdf_of(asked.robot, pairs));
    return 0;
  }
  RobotJson json = json_of_robot(asked, RobotScene(asked.robot), arguments);
  json["allowed"] = RobotJson::array();
  for (const AllowedPair& pair : pairs)
    json["allowed"].push_back({{"a", pair.a}, {"b", pair.b}, {"reason", name_of(pair.reason)}});
  print_answer(json.dump(1, ' ', false, RobotJson::error_handler_t::replace) + "\n");
  return 0;
}

int run_robot(const RobotArguments& arguments) {
  if (!arguments.html.empty()) require_output(arguments.html, OutputKind::page);
  const AskedRobot asked = asked_robot(arguments);
  print_warnings(asked.warnings);
  if (!arguments.write_urdf.empty()) {
    RobotDescription description{asked.robot.name(), {}, {}, {}};
    description.links.assign(asked.robot.links().begin(), asked.robot.links().end());
    description.joints.assign(asked.robot.joints().begin(), asked.robot.joints().end());
    const UninterruptedWriting writing;
    write_urdf(description, arguments.write_urdf);
    print_answer(fmt::format("written: {}/robot.urdf and its meshes\n", arguments.write_urdf));
    return 0;
  }
  if (arguments.find_allowed > 0) return find_allowed(asked, arguments);
  std::vector<SceneInstance> obstacles = scene_models(asked.loaded.scene, arguments.threads);
  if (!arguments.cloud.empty()) obstacles.push_back(point_cloud(read_points(arguments.cloud), arguments.radius));
  const RobotScene scene(asked.robot, obstacles, {.allowed = asked.allowed, .allow_adjacent = arguments.srdf.empty()});
  const RobotAnswer answer = answer_of(scene, arguments);
  if (!arguments.html.empty()) write_film(answer, scene, arguments);
  if (arguments.format == Format::json) {
    RobotJson json = json_of_robot(asked, scene, arguments);
    add_answer(answer, scene, json);
    print_answer(json.dump(1, ' ', false, RobotJson::error_handler_t::replace) + "\n");
  } else {
    print_answer(text_of_robot(asked) + text_of_answer(answer, scene));
  }
  const bool meets = std::ranges::any_of(answer.contacts, [](const auto& contacts) { return !contacts.empty(); }) ||
                     std::ranges::any_of(answer.edges, [](const RobotEdge& edge) { return !edge.is_free; });
  return meets ? 1 : 0;
}

}  // namespace

Subcommand add_robot(CLI::App& app) {
  const auto arguments = std::make_shared<RobotArguments>();
  CLI::App* robot = app.add_subcommand("robot", "what a robot's links meet at configurations, and between them");
  robot->add_option("file", arguments->file, "a URDF file; gen:arm is an arm that is generated")->required();
  add_file(*robot, "--srdf", arguments->srdf,
           "pairs of links that are not looked at, in place of those that a joint joins");
  robot->add_option("--package", arguments->packages, "folders in which package://… is looked for, before those of ROS")
      ->type_name("FOLDER");
  robot->add_option("--scene", arguments->scene.files, fmt::format("what stands around it: {}", any_files))
      ->type_name("FILE");
  add_text(*robot, "--unit", arguments->scene.unit, "of plain mesh files of the scene: mm, cm, m, in, ft",
           "a unit must be given");
  CLI::Option* cloud = add_file(*robot, "--cloud", arguments->cloud, "a point cloud around it: three numbers a line");
  robot->add_option("--radius", arguments->radius, "of the ball that each of its points stands for")
      ->check(number_above_0())
      ->capture_default_str()
      ->needs(cloud);
  CLI::Option* configurations =
      add_file(*robot, "--configurations", arguments->configurations,
               "a line of numbers for each, in radians and metres (default: where all positions are 0)");
  robot->add_flag("--edges", arguments->edges, "also the ways from each configuration to the next, at every moment")
      ->needs(configurations);
  robot->add_flag("--distance", arguments->distance, "also the least distance at each configuration");
  robot
      ->add_option("--find-allowed", arguments->find_allowed,
                   "instead: pairs that need not be looked at, by so many samples, as SRDF")
      ->type_name("NUMBER")
      ->check(whole_number(1, 100'000'000));
  add_text(*robot, "--write-urdf", arguments->write_urdf, "instead: write the robot and its meshes into this folder",
           "a folder must be named")
      ->type_name("FOLDER");
  add_file(*robot, "--html", arguments->html, "write a page that shows the robot at the configurations");
  add_json(*robot, arguments->format, "write JSON (docs/reference/robot-report.md)");
  add_threads(*robot, arguments->threads, "answer");
  robot->footer(
      with_name("Answers are exact, on meshes too; that an edge is free is proved for every moment.\n\n"
                "Exit code: 0 nothing meets, 1 something does, 2 trouble.\n\nExample:\n"
                "  {0} robot gen:arm --write-urdf arm\n"
                "  {0} robot arm/robot.urdf --scene table.obj --configurations q.csv --edges\n"
                "  {0} robot arm/robot.urdf --find-allowed 10000 > arm.srdf\n"
                "  {0} robot arm/robot.urdf --srdf arm.srdf --configurations q.csv --distance --json"));
  return {robot, [arguments] {
            arguments->scene.threads = arguments->threads;
            return run_robot(*arguments);
          }};
}

}  // namespace toccata::command
