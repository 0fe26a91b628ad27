#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "arguments.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/core/version.hpp"
#include "toccata/world/world.hpp"

// A World with WorldOptions::space_time beside a plain one: the same bodies, step by step, all pairs compared.
namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;

Vec3 vector_between(Random& random, double low, double high) {
  const double x = random.between(low, high), y = random.between(low, high), z = random.between(low, high);
  return {x, y, z};
}

/// Where a body is, and how it goes on.
struct Course {
  Vec3 at, velocity, axis{0, 0, 1};
  double angle = 0, spin = 0;  ///< degrees, a step
};

/// Bodies that move step by step.
struct Scene {
  std::vector<Body> bodies;
  std::vector<Course> courses;
  std::function<void(Course&, Random&)> go_on;
};

/// Flies on, and is thrown back by the walls of a room.
void fly(Course& course, double room) {
  course.at += course.velocity;
  course.angle += course.spin;
  for (int axis = 0; axis < 3; ++axis)
    if ((course.at[axis] < 0 && course.velocity[axis] < 0) || (course.at[axis] > room && course.velocity[axis] > 0))
      course.velocity[axis] = -course.velocity[axis];
}

Model any_solid(std::size_t number) {
  switch (number % 3) {
    case 0:
      return Sphere(0.5);
    case 1:
      return Box({0.5, 0.3, 0.4});
    default:
      return Capsule({0, 0, -0.5}, {0, 0, 0.5}, 0.25);
  }
}

/// `spacing`: the room has its third power for each body.
Scene flyers(std::size_t count, double spacing, double speed, double spin, Random& random) {
  const double room = spacing * std::cbrt(static_cast<double>(count));
  Scene scene;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 at = vector_between(random, 0, room), velocity = vector_between(random, -speed, speed);
    scene.courses.push_back({at, velocity, vector_between(random, -1, 1), 0, random.between(-spin, spin)});
    scene.bodies.push_back({any_solid(i)});
  }
  scene.go_on = [room](Course& course, Random&) { fly(course, room); };
  return scene;
}

/// Rods as long as the way to their neighbours, whose boxes overlap though they do not meet.
Scene rods(std::size_t count, Random& random) {
  Scene scene = flyers(count, 3, 0.005, 0.1, random);
  for (Body& body : scene.bodies) body.model = Capsule({-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}, 0.05);
  return scene;
}

/// Panels around a planet at the origin that do not turn, each as fast as its orbit demands, which tells its
/// acceleration.
Scene satellites(std::size_t count, Random& random) {
  Scene scene;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 at = random.between(20, 60) * normalized(vector_between(random, -1, 1));
    const double pull = 0.02 / dot(at, at);
    const Vec3 velocity = std::sqrt(pull * length(at)) * normalized(cross(at, vector_between(random, -1, 1)));
    scene.courses.push_back({at, velocity, vector_between(random, -1, 1), random.between(0, 360), 0});
    Body body{Box({2, 0.5, 0.02})};
    body.max_acceleration = 2 * pull;
    scene.bodies.push_back(body);
  }
  scene.go_on = [](Course& course, Random&) {
    const double distance = length(course.at);
    course.velocity -= 0.02 / (distance * distance * distance) * course.at;
    course.at += course.velocity;
    course.angle += course.spin;
  };
  return scene;
}

/// Cars in lanes side by side, slantwise to the axes, so that boxes overlap all the time and cars seldom meet. Each is
/// as fast as it likes, changes that now and then, and promises a speed.
Scene traffic(std::size_t count, Random& random) {
  const auto in_lane = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count) / 4)));
  const Mat3 turn = rotation_about({0, 0, 1}, 40);
  Scene scene;
  for (std::size_t i = 0; i < count; ++i) {
    const double along = 12 * static_cast<double>(i % in_lane), aside = 3.5 * static_cast<double>(i / in_lane);
    const Vec3 way = random.between(0.2, 0.205) * Vec3{1, 0, 0};
    scene.courses.push_back({turn * Vec3{along, aside, 0}, turn * way, {0, 0, 1}, 40, 0});
    Body body{Box({2.2, 0.9, 0.7})};
    body.max_acceleration = 0.005;
    scene.bodies.push_back(body);
  }
  scene.go_on = [turn](Course& course, Random& dice) {
    course.at += course.velocity;
    if (dice.below(100) == 0) course.velocity = turn * (dice.between(0.2, 0.205) * Vec3{1, 0, 0});
  };
  return scene;
}

/// Side by side in a heap, all of them in contact, and shaken.
Scene pile(std::size_t count, double shake, Random& random) {
  const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(count))));
  Scene scene = flyers(count, 1, 0, 0, random);
  for (std::size_t i = 0; i < count; ++i) {
    const std::array<std::size_t, 3> cell{i % side, i / side % side, i / (side * side)};
    for (int axis = 0; axis < 3; ++axis)
      scene.courses[i].at[axis] = 0.75 * static_cast<double>(cell[static_cast<std::size_t>(axis)]);
  }
  scene.go_on = [shake](Course& course, Random& dice) {
    const Vec3 moved = vector_between(dice, -shake, shake);
    course.at += moved - course.velocity;  // about where it began
    course.velocity = moved;
  };
  return scene;
}

/// Changes its way at every step.
Scene gnats(std::size_t count, Random& random) {
  Scene scene = flyers(count, 3, 0.1, 3, random);
  scene.go_on = [](Course& course, Random& dice) { course.at += vector_between(dice, -0.1, 0.1); };
  return scene;
}

struct NamedMotion {
  const char* name;
  const char* events;  ///< few or many
  std::function<Scene(std::size_t, Random&)> make;
};

std::vector<NamedMotion> motions() {
  return {
      {"flyers", "few", [](std::size_t n, Random& r) { return flyers(n, 5, 0.02, 1, r); }},
      {"rods", "few", rods},
      {"satellites", "few", satellites},
      {"traffic", "few", traffic},
      {"fast-flyers", "some", [](std::size_t n, Random& r) { return flyers(n, 3, 0.5, 10, r); }},
      {"dense-flyers", "many", [](std::size_t n, Random& r) { return flyers(n, 1.2, 0.02, 1, r); }},
      {"pile", "many", [](std::size_t n, Random& r) { return pile(n, 0.01, r); }},
      {"pile-at-rest", "many", [](std::size_t n, Random& r) { return pile(n, 0, r); }},
      {"gnats", "some", gnats},
  };
}

/// One of the two Worlds, and what all its steps took together.
struct Side {
  World world{WorldOptions{}};
  std::vector<BodyId> ids{};
  double seconds = 0, worst = 0;
  std::size_t asked = 0, candidates = 0;
};

struct SpaceTimeRow {
  std::string scene{}, events{};
  std::size_t bodies = 0, begun = 0, ended = 0, pairs = 0, differ = 0;
  Side plain{}, scheduled{};
};

void step(Side& side, std::span<const Pose> poses, Clock clock) {
  const double seconds = seconds_of(
      [&] {
        side.world.move(side.ids, poses);
        side.world.step();
      },
      clock);
  side.seconds += seconds;
  side.worst = std::max(side.worst, seconds);
  side.asked += side.world.last_step().asked;
  side.candidates += side.world.last_step().candidates;
}

bool are_same(std::span<const PairReport> a, std::span<const PairReport> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const PairReport& x, const PairReport& y) {
    return x.a.index == y.a.index && x.b.index == y.b.index && x.in_contact == y.in_contact;
  });
}

SpaceTimeRow measured(const NamedMotion& motion, const WorldArguments& arguments, int threads) {
  Random random(arguments.seed);
  Scene scene = motion.make(arguments.count, random);
  std::vector<Pose> poses(scene.bodies.size());
  const auto pose_all = [&] {
    for (std::size_t i = 0; i < poses.size(); ++i)
      poses[i] = {rotation_about(scene.courses[i].axis, scene.courses[i].angle), scene.courses[i].at};
  };
  pose_all();
  for (std::size_t i = 0; i < poses.size(); ++i) scene.bodies[i].pose = poses[i];
  SpaceTimeRow row{motion.name, motion.events, poses.size()};
  row.plain.world = World({.threads = threads});
  row.scheduled.world = World({.space_time = true, .threads = threads});
  for (Side* side : {&row.plain, &row.scheduled}) {
    side->ids = side->world.add(scene.bodies);
    side->world.step();  // all memory is new the first time
  }
  const Clock clock = threads == 1 ? Clock::thread : Clock::wall;
  for (int frame = 0; frame < arguments.frames; ++frame) {
    for (Course& course : scene.courses) scene.go_on(course, random);
    pose_all();
    // In turn, so that neither always finds the caches warm.
    for (const bool is_first : {true, false})
      step((frame % 2 == 0) == is_first ? row.plain : row.scheduled, poses, clock);
    row.begun += row.plain.world.last_step().begin.size();
    row.ended += row.plain.world.last_step().end.size();
    row.pairs += row.plain.world.pairs().size();
    if (!are_same(row.plain.world.pairs(), row.scheduled.world.pairs())) ++row.differ;
  }
  return row;
}

/// The same several times: of the times the least count, as other programs run.
SpaceTimeRow best_of_rounds(const NamedMotion& motion, const WorldArguments& arguments, int threads) {
  SpaceTimeRow best = measured(motion, arguments, threads);
  for (int round = 1; round < arguments.rounds; ++round) {
    const SpaceTimeRow again = measured(motion, arguments, threads);
    best.differ += again.differ;
    const auto keep_least = [](Side& least, const Side& other) {
      least.seconds = std::min(least.seconds, other.seconds);
      least.worst = std::min(least.worst, other.worst);
    };
    keep_least(best.plain, again.plain);
    keep_least(best.scheduled, again.scheduled);
  }
  return best;
}

/// How many times fewer pairs are asked about.
double fewer(const SpaceTimeRow& row) {
  return static_cast<double>(row.plain.asked) / static_cast<double>(std::max<std::size_t>(row.scheduled.asked, 1));
}

/// How many times fewer pairs would be asked about if each were only where something begins or ends, as if it were
/// known when: no bound in space and time can reach more.
double fewer_at_best(const SpaceTimeRow& row) {
  return static_cast<double>(row.plain.asked) / static_cast<double>(std::max<std::size_t>(row.begun + row.ended, 1));
}

/// The same, if the pairs that are told had to be asked about at every step, as where details are told of them.
double fewer_with_told(const SpaceTimeRow& row) {
  return static_cast<double>(row.plain.asked) /
         static_cast<double>(std::max<std::size_t>(std::min(row.pairs + row.ended, row.plain.asked), 1));
}

Json json_of(const SpaceTimeRow& row, int threads, int frames) {
  const auto side = [&](const Side& one) {
    return Json{{"milliseconds", 1e3 * one.seconds / frames},
                {"worst_milliseconds", 1e3 * one.worst},
                {"candidates", one.candidates},
                {"asked", one.asked}};
  };
  return {{"scene", row.scene},
          {"events", row.events},
          {"bodies", row.bodies},
          {"threads", threads},
          {"begun", row.begun},
          {"pairs", row.pairs},
          {"plain", side(row.plain)},
          {"space_time", side(row.scheduled)},
          {"times_fewer_asked", fewer(row)},
          {"times_fewer_at_best", fewer_at_best(row)},
          {"times_fewer_with_told", fewer_with_told(row)},
          {"time_ratio", row.scheduled.seconds / row.plain.seconds},
          {"steps_that_differ", row.differ}};
}

void print_row(const SpaceTimeRow& row, int threads, int frames) {
  const double steps = frames;
  fmt::print(
      "{:<14}{:>8}{:>8}{:>10.1f}{:>10.1f}{:>12.1f}{:>12.1f}{:>9.1f}{:>9.1f}{:>9.1f}{:>10.3f}{:>12.3f}{:>8.2f}{:>8}\n",
      row.scene, threads, row.bodies, static_cast<double>(row.begun) / steps, static_cast<double>(row.pairs) / steps,
      static_cast<double>(row.plain.asked) / steps, static_cast<double>(row.scheduled.asked) / steps, fewer(row),
      fewer_at_best(row), fewer_with_told(row), 1e3 * row.plain.seconds / steps, 1e3 * row.scheduled.seconds / steps,
      row.scheduled.seconds / row.plain.seconds, row.differ);
}

}  // namespace

int run_space_time(const WorldArguments& arguments) {
  Json report =
      report_of("space-time", {{"count", arguments.count}, {"frames", arguments.frames}, {"seed", arguments.seed}});
  report["results"] = Json::array();
  if (!arguments.json)
    fmt::print("{:<14}{:>8}{:>8}{:>10}{:>10}{:>12}{:>12}{:>9}{:>9}{:>9}{:>10}{:>12}{:>8}{:>8}\n", "a step", "threads",
               "bodies", "begin", "pairs", "asked", "space-time", "fewer", "at best", "w. told", "ms", "space-time",
               "ratio", "differ");
  const std::vector<NamedMotion> all = motions();
  if (!arguments.scene.empty() &&
      std::none_of(all.begin(), all.end(), [&](const NamedMotion& one) { return arguments.scene == one.name; }))
    throw Error(fmt::format("there is no scene \"{}\": without --scene all are measured, and named", arguments.scene));
  bool all_same = true;
  for (const int threads : arguments.threads)
    for (const NamedMotion& motion : all) {
      if (!arguments.scene.empty() && arguments.scene != motion.name) continue;
      const SpaceTimeRow row = best_of_rounds(motion, arguments, threads);
      report["results"].push_back(json_of(row, threads, arguments.frames));
      if (!arguments.json) print_row(row, threads, arguments.frames);
      all_same = all_same && row.differ == 0;
    }
  if (arguments.json) fmt::print("{}\n", report.dump(2));
  return all_same ? 0 : 1;
}

}  // namespace toccata::bench
