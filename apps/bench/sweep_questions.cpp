#include "sweep_questions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "random_bodies.hpp"
#include "single_mesh.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/distance.hpp"

namespace toccata::bench {
namespace {

/// What one set is drawn from: a pair, and how it moves.
struct DrawnSweep {
  SweepPair pair;
  SweepQuestion question;
};

Pose turned_about_offset(const Pose& start, const Vec3& axis, double degrees, const Vec3& translation) {
  if (degrees == 0) return {start.linear, start.offset + translation};  // to the bit, so that it is straight
  return {rotation_about(axis, degrees) * start.linear, start.offset + translation};
}

SweepBody hull_or_box(Random& random) {
  if (random.between(0, 1) < 0.5) return Box(std::get<Box>(random_body("box", 0, random)));
  return ConvexHull(std::get<ConvexHull>(random_body("hull", 16, random)));
}

Pose posed_at(const Vec3& offset, Random& random) { return {random_rotation(random), offset}; }

/// A comes from 3 to 5 away and goes past the middle of B, which is at the origin, by up to `aside`.
SweepWay way_past(double aside, double degrees, Random& random) {
  const Vec3 towards = unit_vector(random), across = cross(towards, unit_vector(random));
  const double before = random.between(3, 5), beside = random.between(0, aside);
  const Pose start = posed_at(-before * towards + beside * across, random);
  const Vec3 axis = unit_vector(random);
  const double turned = random.between(-degrees, degrees);
  return {start, turned_about_offset(start, axis, turned, 8 * towards)};
}

SweepWay turning_at(const Vec3& offset, double degrees, Random& random) {
  const Pose start = posed_at(offset, random);
  const Vec3 axis = unit_vector(random);
  return {start, turned_about_offset(start, axis, random.between(-degrees, degrees), {})};
}

DrawnSweep translation(Random& random) {
  SweepBody a = hull_or_box(random);
  SweepBody b = hull_or_box(random);
  SweepWay way_a = way_past(0.55, 0, random);
  return {{std::move(a), std::move(b)}, {0, std::move(way_a), turning_at({}, 0, random)}};
}

DrawnSweep rotation(Random& random) {
  SweepBody a = hull_or_box(random);
  SweepBody b = hull_or_box(random);
  SweepWay way_a = way_past(0.6, 45, random);
  return {{std::move(a), std::move(b)}, {0, std::move(way_a), turning_at({}, 45, random)}};
}

Box thin_box(Random& random) {
  const double x = random.between(0.5, 1);
  const double y = random.between(0.5, 1);
  return Box({x, y, std::pow(10, random.between(-4, -1.5))});
}

DrawnSweep thin_boxes(Random& random) {
  const Box a = thin_box(random), b = thin_box(random);
  SweepWay way_a = way_past(0.6, 90, random);
  return {{a, b}, {0, std::move(way_a), turning_at({}, 90, random)}};
}

/// A small body passes a wall in about a thousandth of its way, and beside the wall in a third of the cases.
DrawnSweep thin_wall(Random& random) {
  const double size = random.between(0.01, 0.05);
  const Box a({size, size, size}), wall({1, 1, std::pow(10, random.between(-5, -2))});
  const double x = random.between(-1.2, 1.2);
  const double y = random.between(-1.2, 1.2);
  const Vec3 through{x, y, 0};
  const Vec3 aslant = unit_vector(random);
  const Vec3 way = Vec3{0, 0, 20} + 2 * aslant;
  const Pose start = posed_at(through - random.between(0.2, 0.8) * way, random);
  const Vec3 axis = unit_vector(random);
  return {{a, wall}, {0, {start, turned_about_offset(start, axis, random.between(-45, 45), way)}, {}}};
}

/// A rod turns about its middle, beside a peg that it reaches in a part of its turn.
DrawnSweep rod(Random& random) {
  const double thickness = random.between(0.005, 0.03);
  const Box turning({1, thickness, thickness}), peg({0.03, 0.03, 0.5});
  const Pose start{rotation_about({0, 0, 1}, random.between(0, 360)), {}};
  const double degrees = random.between(-170, 170);
  const double angle = random.between(0, 2 * 3.14159265358979);
  const double away = random.between(0.3, 1.1);
  Pose standing = Pose::translation(away * std::cos(angle), away * std::sin(angle), random.between(-0.6, 0.6));
  return {{turning, peg}, {0, {start, turned_about_offset(start, {0, 0, 1}, degrees, {})}, {standing, standing}}};
}

/// Flies over a box along x and spins about y, which for the capsule is its own axis: above it by 1e-9 to 0.03, or in
/// a third of the cases too low by as much, so that it meets an edge.
DrawnSweep spinning(Random& random) {
  const double radius = random.between(0.05, 0.5);
  const double gap = std::pow(10, random.between(-9, -1.5)) * (random.between(0, 1) < 1.0 / 3 ? -1 : 1);
  const Box box({0.5, 0.5, 0.25});
  SweepBody round = Sphere(radius);
  if (random.between(0, 1) < 0.5) round = Capsule({0, 0, -0.2}, {0, 0, 0.2}, radius);
  const Pose start{rotation_about({1, 0, 0}, 90), {-1.5, random.between(-0.2, 0.2), 0.25 + radius + gap}};
  const double degrees = random.between(-170, 170);
  return {{std::move(round), box}, {0, {start, turned_about_offset(start, {0, 1, 0}, degrees, {3, 0, 0})}, {}}};
}

Model model_of(const SweepBody& body) {
  return std::visit([](const auto& shape) { return Model(shape); }, body);
}

double distance_at_start(const DrawnSweep& drawn) {
  return distance(model_of(drawn.pair.a), model_of(drawn.pair.b), {drawn.question.a.start, drawn.question.b.start})
      .upper;
}

SweepWork drawn_set(const std::string& set, std::size_t count, Random& random, DrawnSweep (*draw)(Random&)) {
  SweepWork work{set};
  work.block = std::min<std::size_t>(20, count);
  while (work.questions.size() < count) {
    DrawnSweep drawn = draw(random);
    if (distance_at_start(drawn) < 0.01) continue;
    drawn.question.pair = work.pairs.size();
    work.pairs.push_back(std::move(drawn.pair));
    work.questions.push_back(drawn.question);
  }
  return work;
}

using SharedTriangles = std::shared_ptr<const TriangleMesh>;

/// How far along x the second has to stand so that the first, which turns, comes as near as `gap` to it.
double place_beside(const SharedTriangles& mesh, const SweepWay& turning, double gap) {
  const Model model{mesh};
  const Vec3 size = model.bounds().upper - model.bounds().lower;
  double meets = 0, free = 4 * length(size);
  const SweepQuery query{.stop_before = gap};
  while (free - meets > 1e-4 * length(size)) {
    const double middle = 0.5 * (meets + free);
    const RigidMotion standing(Pose::translation(middle, 0, 0));
    (sweep(model, turning.motion(), model, standing, query) ? meets : free) = middle;
  }
  return free;
}

/// The mesh turns by a quarter about its middle, with one that stands beside it: free at a gap of 1 % of its diagonal,
/// or moved into its way by 3 % of that.
SweepWork beside_each_other(const std::string& set, const SharedTriangles& mesh, double nearer) {
  const Aabb box = Model{mesh}.bounds();
  const double diagonal = length(box.upper - box.lower);
  const Vec3 middle = 0.5 * (box.lower + box.upper);
  const Pose start = Pose{{}, -middle};
  // About the origin of the mesh's own frame, as all motions here.
  const SweepWay turning{start, turned_about_offset(start, {0, 1, 0}, 90, {})};
  const double beside = place_beside(mesh, turning, 0.01 * diagonal) - nearer * diagonal;
  const Pose standing{{}, Vec3{beside, 0, 0}};
  return {set, {{mesh, mesh}}, {{0, turning, {standing, standing}}}};
}

}  // namespace

std::vector<SweepWork> sweeps_of_bodies(const MotionArguments& arguments) {
  Random random(arguments.seed);
  const std::size_t count = arguments.count;
  std::vector<SweepWork> sets;
  sets.push_back(drawn_set("translations", count, random, translation));
  sets.push_back(drawn_set("rotations", count, random, rotation));
  sets.push_back(drawn_set("thin boxes", count, random, thin_boxes));
  sets.push_back(drawn_set("thin walls", count, random, thin_wall));
  sets.push_back(drawn_set("rods", count, random, rod));
  sets.push_back(drawn_set("spinning round", count, random, spinning));
  return sets;
}

std::vector<SweepWork> sweeps_of_meshes(const MotionArguments& arguments) {
  std::vector<SweepWork> sets;
  if (!arguments.data.empty()) {
    const SharedTriangles bunny = single_mesh(arguments.data + "/meshes/stanford-bunny.obj");
    sets.push_back(beside_each_other("bunnies, free", bunny, 0));
    sets.push_back(beside_each_other("bunnies, meeting", bunny, 0.04));
  }
  for (const int subdivisions : {3, 4, 5, 6}) {
    const SharedTriangles mesh = single_mesh(fmt::format("gen:noise-sphere?subdivisions={}", subdivisions));
    if (mesh->triangle_count() > arguments.most) continue;
    sets.push_back(beside_each_other(fmt::format("rough spheres, {} triangles", mesh->triangle_count()), mesh, 0.04));
  }
  return sets;
}

}  // namespace toccata::bench
