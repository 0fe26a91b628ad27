#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "arguments.hpp"
#include "random_bodies.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/motion/swept_volume.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::bench {
namespace {

using VolumeJson = nlohmann::ordered_json;

constexpr std::size_t asked_points = 2000, asked_pairs = 200;

/// A body on its way, and points of it in its own frame.
struct VolumeWork {
  std::string set;
  Model body;
  RigidMotion motion;
  std::vector<Vec3> points;
};

RigidMotion turning_by(double turns) { return {Pose{}, {.turns = turns, .translation = {3, 0, 0.5}}}; }

VolumeWork of_box(const char* set, double turns) {
  const Box box({1, 0.3, 0.2});
  VolumeWork work{set, box, turning_by(turns), {}};
  for (int i = 0; i < 8; ++i) work.points.push_back(box.corner(i));
  return work;
}

VolumeWork of_hull(Random& random) {
  const auto hull = std::get<ConvexHull>(random_body("hull", 32, random));
  VolumeWork work{"hull of 32, turning by a quarter", hull, turning_by(0.25), {}};
  for (Index i = 0; i < hull.vertex_count(); ++i) work.points.push_back(hull.vertex(i));
  return work;
}

VolumeWork of_mesh(const std::string& set, const std::shared_ptr<const TriangleMesh>& mesh) {
  const Model model{mesh};
  const Aabb box = model.bounds();
  const double size = length(box.upper - box.lower);
  return {set,
          model,
          {Pose{{}, -0.5 * (box.lower + box.upper)}, {.turns = 0.25, .translation = {size, 0, 0}}},
          {mesh->vertices().begin(), mesh->vertices().end()}};
}

/// Points of the body at random times that the volume does not contain.
std::size_t outside(const VolumeWork& work, const SweptVolume& volume, Random& random) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < asked_points; ++i) {
    const auto number = static_cast<std::size_t>(random.between(0, static_cast<double>(work.points.size())));
    const Vec3 local = work.points[std::min(number, work.points.size() - 1)];
    const Vec3 point = transform(work.motion.at(random.between(0, 1)), local);
    // The pose is rounded, and so is the point.
    count += overlap(Sphere(1e-12 * (1 + length(point)), point), volume.model, {.solid_b = volume.solid}) ? 0 : 1;
  }
  return count;
}

/// Around the points at some times.
Aabb box_of_way(const VolumeWork& work) {
  Aabb box;
  for (int i = 0; i <= 16; ++i)
    for (const Vec3& point : work.points) box = merge(box, transform(work.motion.at(i / 16.0), point));
  return box;
}

/// Balls that stand about the way: how long is it asked of the volume and of the sweep, and what does each say?
VolumeJson asked(const VolumeWork& work, const SweptVolume& volume, Random& random) {
  const Aabb box = box_of_way(work);
  const double size = length(box.upper - box.lower);
  std::vector<Model> balls;
  std::vector<RigidMotion> places;
  std::vector<SweptVolume> standing;
  for (std::size_t i = 0; i < asked_pairs; ++i) {
    balls.emplace_back(Sphere(0.03 * size));
    places.emplace_back(Pose{{}, 0.5 * (box.lower + box.upper) + random.between(0, 0.7) * size * unit_vector(random)});
    standing.push_back(swept_volume(balls.back(), places.back()));
  }
  std::size_t maybe = 0, hits = 0, contradictions = 0;
  std::vector<bool> may(asked_pairs);
  const double of_volume = seconds_of([&] {
    for (std::size_t i = 0; i < asked_pairs; ++i) may[i] = may_meet(volume, standing[i]) != SweptOverlap::never;
  });
  const double of_sweep = seconds_of([&] {
    for (std::size_t i = 0; i < asked_pairs; ++i) {
      const bool hit = sweep(work.body, work.motion, balls[i], places[i]).has_value();
      hits += hit;
      maybe += may[i];
      contradictions += hit && !may[i];
    }
  });
  return {{"asked", asked_pairs},
          {"maybe", maybe},
          {"hits", hits},
          {"contradictions", contradictions},
          {"volume_us", 1e6 * of_volume / asked_pairs},
          {"sweep_us", 1e6 * of_sweep / asked_pairs}};
}

VolumeJson row_of(const VolumeWork& work, int rounds, Random& random) {
  double least = HUGE_VAL;
  SweptVolume volume = swept_volume(work.body, work.motion);
  for (int round = 0; round < rounds; ++round)
    least = std::min(least, seconds_of([&] { volume = swept_volume(work.body, work.motion); }, Clock::thread));
  VolumeJson row = {{"set", work.set},
                    {"make_us", 1e6 * least},
                    {"parts", std::max<std::size_t>(1, volume.model.parts().size())},
                    {"excess", volume.excess},
                    {"outside", outside(work, volume, random)}};
  row.update(asked(work, volume, random));
  return row;
}

void print_row(const VolumeJson& row) {
  fmt::print("{:<36}{:>12.1f}{:>7}{:>10.4f}{:>9}{:>8}{:>8}{:>8}{:>16}{:>12.2f}{:>12.2f}\n",
             row["set"].get<std::string>(), row["make_us"].get<double>(), row["parts"].get<int>(),
             row["excess"].get<double>(), row["outside"].get<int>(), row["asked"].get<int>(), row["maybe"].get<int>(),
             row["hits"].get<int>(), row["contradictions"].get<int>(), row["volume_us"].get<double>(),
             row["sweep_us"].get<double>());
}

}  // namespace

int run_swept_volumes(const MotionArguments& arguments) {
  Random random(arguments.seed);
  std::vector<VolumeWork> all{of_box("box, straight", 0), of_box("box, turning by a quarter", 0.25),
                              of_box("box, turning once", 1), of_hull(random)};
  all.push_back(of_mesh("torus knot, turning by a quarter", single_mesh("gen:torus-knot")));
  if (!arguments.data.empty())
    all.push_back(of_mesh("bunny, turning by a quarter", single_mesh(arguments.data + "/meshes/stanford-bunny.obj")));
  VolumeJson report =
      report_of("motion", {{"task", arguments.task}, {"seed", arguments.seed}, {"rounds", arguments.rounds}});
  std::size_t wrong = 0;
  for (const VolumeWork& work : all) {
    report["results"].push_back(row_of(work, arguments.rounds, random));
    const VolumeJson& row = report["results"].back();
    wrong += row["outside"].get<std::size_t>() + row["contradictions"].get<std::size_t>();
  }
  if (arguments.json) {
    fmt::print("{}\n", report.dump(2));
  } else {
    fmt::print("{:<36}{:>12}{:>7}{:>10}{:>9}{:>8}{:>8}{:>8}{:>16}{:>12}{:>12}\n", "set", "make us", "parts", "excess",
               "outside", "asked", "maybe", "hits", "contradictions", "volume us", "sweep us");
    for (const auto& row : report["results"]) print_row(row);
  }
  return wrong == 0 ? 0 : 1;
}

}  // namespace toccata::bench
