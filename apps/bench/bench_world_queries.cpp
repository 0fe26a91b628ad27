#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "arguments.hpp"
#include "float_mesh.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/overlap.hpp"
#include "world_queries.hpp"

namespace toccata::bench {
namespace {

constexpr std::size_t query_block = 1000;

/// Bodies of about size 1, one in every eight units of volume.
class Places {
 public:
  Places(std::size_t bodies, std::uint64_t seed) : random_(seed), side_(2 * std::cbrt(static_cast<double>(bodies))) {}

  Vec3 place() {
    const double x = random_.between(0, side_), y = random_.between(0, side_), z = random_.between(0, side_);
    return {x, y, z};
  }
  Pose pose() {
    const Vec3 axis{random_.between(-1, 1), random_.between(-1, 1), 1};
    return {rotation_about(axis, random_.between(0, 360)), place()};
  }
  Model model() {
    const std::uint64_t kind = random_.below(3);
    if (kind == 0) return Sphere(random_.between(0.3, 0.5));
    if (kind == 1) return Capsule({0, 0, -0.3}, {0, 0, 0.3}, random_.between(0.2, 0.3));
    return Box({random_.between(0.2, 0.5), random_.between(0.2, 0.5), random_.between(0.2, 0.5)});
  }

 private:
  Random random_;
  double side_;
};

WorldTask world_task_of(const std::string& name) {
  if (name == "cast") return WorldTask::cast;
  return name == "ray" ? WorldTask::ray : name == "nearest" ? WorldTask::nearest : WorldTask::overlap;
}

/// The hull of 200 points of an ellipsoid.
Model hull_model(double size) {
  Random random(1);
  std::vector<Vec3> points;
  for (int i = 0; i < 200; ++i) {
    const Vec3 d = random_direction(random);
    points.push_back(size * Vec3{d.x, 0.75 * d.y, 0.5 * d.z});
  }
  return Model(ConvexHull(points));
}

/// A ball and a box in turn, or what is asked for.
Model moving_model(const std::string& shape, std::size_t i, double size) {
  if (shape == "hull") return hull_model(size);
  if (shape == "cylinder") return Cylinder(0.75 * size, size);
  if (shape == "cone") return Cone(0.75 * size, size);
  if (shape == "ellipsoid") return Ellipsoid({size, 0.75 * size, 0.5 * size});
  return i % 2 == 0 ? Model(Sphere(size)) : Model(Box({size, 0.75 * size, 0.5 * size}));
}

/// The mesh around the origin and a hundred long: Bullet's tolerances are lengths.
Model hundred_long(const TriangleMesh& mesh) {
  const Aabb box = fit_aabb(mesh.vertices());
  const Vec3 centre = 0.5 * (box.lower + box.upper), size = box.upper - box.lower;
  std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Vec3& v : vertices) v = (100 / std::sqrt(dot(size, size))) * (v - centre);
  return Model(TriangleMesh(std::move(vertices), {mesh.triangles().begin(), mesh.triangles().end()}));
}

/// From a sphere of twice the size of the mesh's box, through a point of the box and beyond: shapes of a fiftieth of
/// its size.
WorldWork work_at_mesh(const WorldQueriesArguments& arguments) {
  if (arguments.task != "cast")
    throw Error("--mesh: shapes are cast at one mesh (--task cast), and nothing else is asked");
  WorldWork work;
  work.task = WorldTask::cast;
  const Model mesh = hundred_long(*single_mesh(arguments.mesh));
  const Aabb box = mesh.bounds();
  const double reach = 100;
  work.bodies.push_back({mesh, {}, Solid::none, ""});
  Random random(arguments.seed);
  for (std::size_t i = 0; i < arguments.count; ++i) {
    const Vec3 from = reach * random_direction(random);
    Vec3 through;
    for (int axis = 0; axis < 3; ++axis) through[axis] = random.between(box.lower[axis], box.upper[axis]);
    const Pose pose{rotation_about(random_direction(random), random.between(0, 360)), from};
    work.moving.push_back({{moving_model(arguments.shape, i, reach / 50), pose}, 3.0 * (through - from)});
  }
  return work;
}

/// Rays and moving shapes begin outside of all bodies, as Bullet meets no body from within.
WorldWork work_of(const WorldQueriesArguments& arguments) {
  if (!arguments.mesh.empty()) return work_at_mesh(arguments);
  Places places(arguments.bodies, arguments.seed);
  WorldWork work;
  work.task = world_task_of(arguments.task);
  for (std::size_t i = 0; i < arguments.bodies; ++i) work.bodies.push_back({places.model(), places.pose()});
  const SceneIndex index(work.bodies);
  while (work.size() < arguments.count) {
    if (work.task == WorldTask::nearest) work.shapes.push_back({Model(Sphere(0.1)), places.pose()});
    if (work.task == WorldTask::overlap) work.shapes.push_back({Model(Box({1, 1, 1})), places.pose()});
    if (work.task == WorldTask::cast) {
      const SceneInstance shape{moving_model(arguments.shape, work.size(), 0.2), places.pose()};
      const Vec3 motion = places.place() - shape.pose.offset;
      if (index.overlapping(shape).empty()) work.moving.push_back({shape, motion});
    }
    if (work.task != WorldTask::ray) continue;
    const Vec3 from = places.place();
    if (index.overlapping({Model(Point(from)), {}}).empty()) work.rays.push_back({from, places.place() - from});
  }
  return work;
}

struct MeasuredQueries {
  Result result;
  std::vector<double> answers;
};

MeasuredQueries measured(WorldQueryLibrary& library, const WorldWork& work, int rounds) {
  MeasuredQueries one;
  one.result.build_ms = 1e3 * seconds_of([&] { library.build(work); }, Clock::thread);
  library.prepare(work);
  one.answers.resize(work.size());
  const auto ask = [&](std::size_t first, auto answers) { library.answer(first, answers); };
  summarise(fastest_of_blocks(std::span(one.answers), query_block, rounds, Clock::thread, ask), one.result);
  one.result.who = library.description();
  one.result.queries = work.size();
  return one;
}

/// Peers tell times and distances to about so much.
bool agree(double a, double b) { return std::fabs(a - b) <= 1e-4 * (1 + std::fabs(b)); }

/// Every body is within a unit of the origin of its frame.
bool is_beside(const Ray& ray, const SceneInstance& body) {
  const Vec3 to_body = body.pose.offset - ray.origin;
  const double time = std::clamp(dot(to_body, ray.motion) / dot(ray.motion, ray.motion), 0.0, 1.0);
  const Vec3 apart = to_body - time * ray.motion;
  return dot(apart, apart) > 4;
}

double time_of(const WorldWork& work, const Ray& ray) {
  double first = 1;
  for (const SceneInstance& body : work.bodies) {
    if (is_beside(ray, body)) continue;
    const std::optional<RayHit> hit = cast_ray(ray.origin, ray.motion, body.model, body.pose);
    if (hit) first = std::min(first, hit->upper);
  }
  return first;
}

double time_of(const WorldWork& work, const MovingShape& moving) {
  double first = 1;
  for (const SceneInstance& body : work.bodies) {
    if (!body.model.has_mesh() && is_beside({moving.shape.pose.offset, moving.motion}, body)) continue;
    const PairQuery query{moving.shape.pose, body.pose, Solid::automatic, body.solid};
    const std::optional<ShapeHit> hit = cast_shape(moving.shape.model, moving.motion, body.model, query);
    if (hit) first = std::min(first, hit->upper);
  }
  return first;
}

/// Every body by itself.
double truth(const WorldWork& work, std::size_t i) {
  if (work.task == WorldTask::ray) return time_of(work, work.rays[i]);
  if (work.task == WorldTask::cast) return time_of(work, work.moving[i]);
  const SceneInstance& shape = work.shapes[i];
  double nearest = std::numeric_limits<double>::infinity(), count = 0;
  for (const SceneInstance& body : work.bodies) {
    const PairQuery query{shape.pose, body.pose};
    if (work.task == WorldTask::overlap)
      count += overlap(shape.model, body.model, query) ? 1 : 0;
    else
      nearest = std::min(nearest, distance(shape.model, body.model, query).upper);
  }
  return work.task == WorldTask::overlap ? count : nearest;
}

void judge(const WorldWork& work, bool all, std::vector<MeasuredQueries>& measured) {
  for (std::size_t i = 0; i < work.size(); ++i) {
    bool differ = false;
    for (MeasuredQueries& one : measured)
      if (!agree(one.answers[i], measured.front().answers[i])) {
        differ = true;
        ++one.result.disagreements;
      }
    if (differ) ++measured.front().result.disagreements;
    if (!differ && !all) continue;
    const double right = truth(work, i);
    for (MeasuredQueries& one : measured)
      if (!agree(one.answers[i], right)) ++one.result.wrong;
  }
}

WorldQueryLibraries libraries_asked(const WorldQueriesArguments& arguments, WorldTask task) {
  if (arguments.shape != "ball-box" && task != WorldTask::cast)
    throw Error("--shape: shapes move with --task cast alone; add it, or leave --shape out");
  WorldQueryLibraries libraries = toccata_world_query_libraries();
  for (const std::string& peer : arguments.peers) {
    if (peer == "bullet" && arguments.shape == "ellipsoid")
      throw Error("--peer bullet: it has no ellipsoids; leave --peer out, or move another --shape");
    for (auto& library : peer == "bullet" ? bullet_world_query_libraries(task) : fcl_world_query_libraries(task))
      libraries.push_back(std::move(library));
  }
  return libraries;
}

}  // namespace

int run_world_queries(const WorldQueriesArguments& arguments) {
  const WorldWork work = work_of(arguments);
  WorldQueryLibraries libraries = libraries_asked(arguments, work.task);
  std::vector<MeasuredQueries> all;
  for (auto& library : libraries) {
    all.push_back(measured(*library, work, arguments.rounds));
    all.back().result.task = arguments.task;
    library.reset();
  }
  judge(work, arguments.verify, all);
  Measurements measurements;
  for (const MeasuredQueries& one : all) measurements.results.push_back(one.result);
  auto report = report_of("world-queries", {{"task", arguments.task},
                                            {"shape", arguments.shape},
                                            {"bodies", work.bodies.size()},
                                            {"mesh", arguments.mesh},
                                            {"seed", arguments.seed},
                                            {"block", query_block},
                                            {"rounds", arguments.rounds}});
  return print_results(std::move(report), measurements, arguments.json);
}

}  // namespace toccata::bench
