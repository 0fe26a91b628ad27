#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "arguments.hpp"
#include "float_mesh.hpp"
#include "oracle/rays.hpp"
#include "rays.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/error.hpp"

namespace toccata::bench {
namespace {

constexpr std::size_t ray_block = 1000;

/// What rays are sent through.
struct RayAim {
  explicit RayAim(const TriangleMesh& mesh) : box(fit_aabb(mesh.vertices())) {
    if (!(reach() > 0) || !std::isfinite(reach()))
      throw Error(
          "--mesh: rays are sent through the box of the mesh, and its diagonal is 0 or overflows; name another");
  }
  [[nodiscard]] Vec3 centre() const { return 0.5 * (box.lower + box.upper); }
  [[nodiscard]] double reach() const {
    const Vec3 size = box.upper - box.lower;
    return std::sqrt(dot(size, size));
  }
  Aabb box;
};

RayQuestion ray_through(const Vec3& origin, const Vec3& through) {
  return {as_floats(origin), as_floats(3.0 * (through - as_floats(origin)))};
}

/// From a sphere of twice the size of the mesh's box, through a point of the box and beyond.
std::vector<RayQuestion> rays_at(const RayAim& aim, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<RayQuestion> rays;
  while (rays.size() < count) {
    const Vec3 origin = aim.centre() + aim.reach() * random_direction(random);
    Vec3 through;
    for (int axis = 0; axis < 3; ++axis) through[axis] = random.between(aim.box.lower[axis], aim.box.upper[axis]);
    rays.push_back(ray_through(origin, through));
  }
  return rays;
}

/// From a point at twice the distance, through a grid across the middle of the box, row by row; about as many.
std::vector<RayQuestion> rays_of_camera(const RayAim& aim, std::size_t count) {
  const auto side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
  const Vec3 eye = aim.centre() + aim.reach() * Vec3{2, 0.3, 0.2}, size = aim.box.upper - aim.box.lower;
  std::vector<RayQuestion> rays;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double y = (column + 0.5) / side - 0.5, z = (row + 0.5) / side - 0.5;
      rays.push_back(ray_through(eye, aim.centre() + Vec3{0, y * size.y, z * size.z}));
    }
  return rays;
}

struct MeasuredRays {
  Result result;
  std::vector<RayAnswer> answers;
};

MeasuredRays measured(RayLibrary& library, const TriangleMesh& mesh, const std::vector<RayQuestion>& rays, int rounds) {
  MeasuredRays one;
  one.result.build_ms = 1e3 * seconds_of([&] { library.prepare(mesh, rays); });
  one.answers.resize(rays.size());
  const auto ask = [&](std::size_t first, auto answers) { library.answer(first, answers); };
  summarise(fastest_of_blocks(std::span(one.answers), ray_block, rounds, Clock::wall, ask), one.result);
  one.result.who = library.description();
  one.result.task = "rays";
  one.result.queries = rays.size();
  return one;
}

/// A millionth of the way, and what floats tell of it.
bool agree(const RayAnswer& a, const RayAnswer& b) {
  return a.hit == b.hit && (!a.hit || std::fabs(a.time - b.time) <= 2e-6);
}

/// Every triangle in rationals.
RayAnswer truth(const TriangleMesh& mesh, const RayQuestion& ray) {
  std::optional<oracle::Rational> first;
  for (const auto& corner : mesh.triangles()) {
    oracle::RationalTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i) triangle.vertex[i] = oracle::exact(mesh.vertices()[corner[i]]);
    const auto time = oracle::time_of_hit(oracle::exact(ray.origin), oracle::exact(ray.motion), triangle);
    if (time && (!first || *time < *first)) first = time;
  }
  return {first.has_value(), first ? static_cast<double>(*first) : 0};
}

void judge(const TriangleMesh& mesh, const std::vector<RayQuestion>& rays, bool all,
           std::vector<MeasuredRays>& measured) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    bool differ = false;
    for (MeasuredRays& one : measured)
      if (!agree(one.answers[i], measured.front().answers[i])) {
        differ = true;
        ++one.result.disagreements;
      }
    if (differ) ++measured.front().result.disagreements;
    if (!differ && !all) continue;
    const RayAnswer right = truth(mesh, rays[i]);
    for (MeasuredRays& one : measured)
      if (!agree(one.answers[i], right)) ++one.result.wrong;
  }
}

}  // namespace

int run_rays(const RaysArguments& arguments) {
  RayLibraries libraries = toccata_ray_libraries();
  for (const std::string& peer : arguments.peers)
    for (auto& library : peer == "embree" ? embree_ray_libraries() : RayLibraries{})
      libraries.push_back(std::move(library));
  const TriangleMesh mesh = of_floats(*single_mesh(arguments.mesh));
  const RayAim aim(mesh);
  const std::vector<RayQuestion> rays =
      arguments.camera ? rays_of_camera(aim, arguments.count) : rays_at(aim, arguments.count, arguments.seed);
  std::vector<MeasuredRays> all;
  for (auto& library : libraries) {
    all.push_back(measured(*library, mesh, rays, arguments.rounds));
    library.reset();
  }
  judge(mesh, rays, arguments.verify, all);
  Measurements measurements;
  for (const MeasuredRays& one : all) measurements.results.push_back(one.result);
  const auto hits = std::ranges::count(all.front().answers, true, &RayAnswer::hit);
  auto report = report_of("rays", {{"mesh", arguments.mesh},
                                   {"triangles", mesh.triangle_count()},
                                   {"seed", arguments.seed},
                                   {"camera", arguments.camera},
                                   {"block", ray_block},
                                   {"rounds", arguments.rounds},
                                   {"hits", hits}});
  return print_results(std::move(report), measurements, arguments.json);
}

}  // namespace toccata::bench
