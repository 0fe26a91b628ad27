// Two thousand bodies fall onto the ground and onto each other. The library finds the contacts; the physics here is the
// simplest that there is: each contact moves the two apart.
#include <toccata/methods.hpp>
#include <toccata/toccata.hpp>

#include <algorithm>
#include <cstdio>
#include <vector>

using namespace toccata;

namespace {

constexpr std::size_t count = 2000;
constexpr double step_seconds = 1.0 / 60;

struct Flight {
  BodyId id;
  Vec3 position, velocity;
};

/// Bodies in a loose pile, balls and cubes in turn.
std::vector<Flight> add_bodies(World& world) {
  Random random(1);
  std::vector<Flight> flights(count);
  for (std::size_t i = 0; i < count; ++i) {
    flights[i].position = {random.between(-10, 10), random.between(-10, 10), random.between(1, 12)};
    Body body{i % 2 == 0 ? Model(Sphere(0.25)) : Model(Box({0.25, 0.25, 0.25}))};
    body.pose.offset = flights[i].position;
    body.user_data = i;  // from a body of a report back to our own data
    flights[i].id = world.add(body);
  }
  return flights;
}

/// Moves one of the two bodies of a contact out of it, and takes the speed into it away. The normal points out of the
/// other one.
void resolve(Flight& flight, const Vec3& normal, double depth) {
  flight.position = flight.position + depth * normal;
  const double into = std::min(0.0, dot(flight.velocity, normal));
  flight.velocity = flight.velocity - into * normal;
}

}  // namespace

int main() {
  World world({.manifold = true});  // contact points and a normal of each pair
  std::vector<Flight> flights = add_bodies(world);
  Body ground{HalfSpace({0, 0, 0}, {0, 0, 1})};
  ground.type = BodyType::static_body;
  const BodyId floor = world.add(ground);

  std::size_t begun = 0;
  for (int frame = 0; frame < 120; ++frame) {
    for (Flight& flight : flights) {
      flight.velocity.z -= 9.81 * step_seconds;
      flight.position = flight.position + step_seconds * flight.velocity;
      world.move(flight.id, {Mat3{}, flight.position});
    }
    begun += world.step().begin.size();
    for (const PairReport& pair : world.pairs()) {
      const Manifold& contact = *pair.details->manifold;  // every pair here is of convex shapes or the half-space
      // The normal of a manifold points from a to b.
      const double share = pair.b == floor ? 1 : 0.5, depth = share * std::max(0.0, contact.points[0].depth);
      resolve(flights[world.body(pair.a).user_data], -contact.normal, depth);
      if (pair.b != floor) resolve(flights[world.body(pair.b).user_data], contact.normal, depth);
    }
    if (frame % 30 == 29) {
      double height = 0;
      for (const Flight& flight : flights) height += flight.position.z / count;
      std::printf("after %.1f s: mean height %.1f\n", (frame + 1) * step_seconds, height);
    }
  }
  std::printf("about %zu pairs have begun, and %zu are in contact at the end\n", begun / 100 * 100,
              world.pairs().size() / 100 * 100);
}
