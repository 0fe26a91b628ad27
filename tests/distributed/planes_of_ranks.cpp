// The planes between ranks: bodies that lie on them to the last bit, and planes that go where the bodies go.
#include <cmath>
#include <limits>
#include <vector>

#include "distributed/space_of_ranks.hpp"
#include "distributed/twin_worlds.hpp"
#include "toccata/core/random.hpp"
#include "world/random_bodies.hpp"

namespace toccata::test {
namespace {

/// Divided once, in the first step.
DistributedOptions divided_once() {
  DistributedOptions options;
  options.most_imbalance = 1.9;
  return options;
}

/// As a DistributedWorld divides it in its first step: places of all bodies, whichever rank counts them.
SpaceOfRanks space_of(const World& world) {
  const auto ranks = static_cast<std::size_t>(our_ranks().count());
  if (ranks == 1) return SpaceOfRanks(1);
  std::vector<Vec3> own;
  const std::vector<BodyId> ids = world.bodies();
  for (auto i = static_cast<std::size_t>(our_ranks().rank()); i < ids.size(); i += ranks)
    own.push_back(place_of(world.box(ids[i])));
  const std::vector<std::uint64_t> costs(own.size(), 2);
  return {our_ranks(), own, costs};
}

/// Does the plane divide space here, and is it not another's side?
bool is_divided_at(const SpaceOfRanks& space, const SpaceOfRanks::Plane& plane, Vec3 place) {
  place[plane.axis] = plane.at;
  const int above = space.part_of(place);
  place[plane.axis] = std::nextafter(plane.at, -std::numeric_limits<double>::infinity());
  return space.part_of(place) != above;
}

void expect_to_live_where_they_are(const TwinWorlds& twins, const SpaceOfRanks& space) {
  for (const BodyId id : twins.world.bodies())
    EXPECT_EQ(twins.distributed.lives_here(twins.id_of(id)),
              space.part_of(place_of(twins.world.box(id))) == our_ranks().rank());
}

constexpr double half = 0.25;

/// How many boxes have their middle, their lower and their upper side on a plane, and how many pairs the lower corner
/// of what they have in common.
struct OnPlanes {
  std::size_t middles = 0, lower = 0, upper = 0, corners = 0;
};

OnPlanes count_on_planes(const World& world, const SpaceOfRanks& space) {
  OnPlanes counts;
  for (const SpaceOfRanks::Plane& plane : space.planes()) {
    const auto is_here = [&](const Aabb& box) { return is_divided_at(space, plane, place_of(box)); };
    for (const BodyId id : world.bodies()) {
      const Aabb& box = world.box(id);
      if (!is_here(box)) continue;
      counts.middles += place_of(box)[plane.axis] == plane.at ? 1 : 0;
      counts.lower += box.lower[plane.axis] == plane.at ? 1 : 0;
      counts.upper += box.upper[plane.axis] == plane.at ? 1 : 0;
    }
    for (const PairReport& pair : world.pairs()) {
      const Aabb &a = world.box(pair.a), &b = world.box(pair.b);
      if (is_here(a) && std::max(a.lower[plane.axis], b.lower[plane.axis]) == plane.at) ++counts.corners;
    }
  }
  return counts;
}

TEST(PlanesOfRanks, HaveBodiesOnThem) {
  Random random(11);
  TwinWorlds twins(divided_once());
  std::vector<Body> bodies;
  for (int i = 0; i < 400; ++i) bodies.push_back({Box({half, half, half}), Pose::translation(vector_in(random, 0, 8))});
  twins.add(bodies);
  twins.step();
  const SpaceOfRanks space = space_of(twins.world);
  EXPECT_EQ(space.planes().size() + 1, static_cast<std::size_t>(our_ranks().count()));
  expect_to_live_where_they_are(twins, space);
  // By 0, a half and a whole side from the plane, on both sides of it; five in a row, each two of which touch on the
  // plane or reach over it.
  std::size_t moved = 0;
  for (const SpaceOfRanks::Plane& plane : space.planes()) {
    int turn = 0;
    Pose pose;
    for (const BodyId id : twins.world.bodies()) {
      if (turn == 20 || !is_divided_at(space, plane, place_of(twins.world.box(id)))) continue;
      if (turn % 5 == 0) pose = twins.world.body(id).pose;
      pose.offset[plane.axis] = plane.at + half * (turn % 5 - 2);
      twins.move(id, pose);
      ++turn, ++moved;
    }
  }
  twins.step();
  EXPECT_FALSE(twins.distributed.last_step().costs.was_divided);
  expect_to_live_where_they_are(twins, space);
  const OnPlanes counts = count_on_planes(twins.world, space);
  const std::size_t planes = space.planes().size();
  EXPECT_GE(moved, 10 * planes);
  EXPECT_GE(counts.middles, 2 * planes);
  EXPECT_GE(counts.lower, 2 * planes);
  EXPECT_GE(counts.upper, 2 * planes);
  EXPECT_GE(counts.corners, planes);
  // Onto the doubles beside the planes, where they belong to the other side.
  for (const SpaceOfRanks::Plane& plane : space.planes())
    for (const BodyId id : twins.world.bodies())
      if (Pose pose = twins.world.body(id).pose; pose.offset[plane.axis] == plane.at) {
        pose.offset[plane.axis] = plane.at - 0x1p-45;
        twins.move(id, pose);
      }
  twins.step();
  expect_to_live_where_they_are(twins, space);
}

/// All that stands right of a place goes left, past the others.
TEST(PlanesOfRanks, GoWhereACrowdDrifts) {
  TwinWorlds even, lazy(divided_once());
  std::vector<Body> bodies;
  for (int i = 0; i < 240; ++i) bodies.push_back({Sphere(0.4), Pose::translation(i, 0, 0)});
  even.add(bodies);
  lazy.add(bodies);
  even.step();
  lazy.step();
  const bool is_alone = our_ranks().count() == 1;
  EXPECT_NE(even.distributed.last_step().costs.was_divided, is_alone);
  int divisions = 0;
  double worst = 1;
  for (int frame = 1; frame <= 20; ++frame) {
    for (TwinWorlds* twins : {&even, &lazy}) {
      const std::vector<BodyId> ids = twins->world.bodies();
      for (std::size_t i = 120; i < ids.size(); ++i)
        twins->move(ids[i], Pose::translation(static_cast<double>(i) - 4 * frame, 2, 0));
      twins->step();
    }
    const DistributedCosts& costs = even.distributed.last_step().costs;
    const double left = lazy.distributed.last_step().costs.imbalance;
    EXPECT_LE(costs.imbalance, 1.2) << frame;
    if (costs.was_divided) {
      ++divisions;
      EXPECT_LT(costs.imbalance, left) << frame;
    }
    worst = std::max(worst, left);
  }
  EXPECT_EQ(divisions > 0, !is_alone);
  EXPECT_EQ(worst > 1.4, !is_alone) << worst;
}

}  // namespace
}  // namespace toccata::test
