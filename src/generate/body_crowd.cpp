#include "generate/random_vector.hpp"
#include "toccata/generate/crowds.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

ConvexHull random_hull(Random& random) {
  std::vector<Vec3> points(20);
  for (Vec3& point : points) {
    point = vector_between(random, -1, 1);
    point = 0.6 / std::sqrt(std::max(0.1, dot(point, point))) * point;
  }
  return ConvexHull(points);
}

/// A few hulls are shared, as they are where bodies are copies of one another.
Shape random_shape(Random& random, const std::vector<ConvexHull>& hulls) {
  switch (random.below(4)) {
    case 0:
      return Sphere(random.between(0.25, 0.6));
    case 1:
      return Box(vector_between(random, 0.25, 0.6));
    case 2: {
      const double half = random.between(0.1, 0.5);
      return Capsule({0, 0, -half}, {0, 0, half}, random.between(0.2, 0.4));
    }
    default:
      return hulls[random.below(hulls.size())];
  }
}

void fly(double& at, double& velocity, double room) {
  at += velocity;
  if ((at < 0 && velocity < 0) || (at > room && velocity > 0)) velocity = -velocity;
  at = std::clamp(at, 0.0, room);
}

}  // namespace

BodyCrowd::BodyCrowd(std::size_t count, double share_in_contact, std::uint64_t seed) {
  if (!(share_in_contact >= 0.001 && share_in_contact <= 1))
    throw Error(fmt::format("a share of {} bodies in contact: it has to lie between 0.001 and 1", share_in_contact));
  Random random(seed);
  std::vector<ConvexHull> hulls;
  while (hulls.size() < 16) hulls.push_back(random_hull(random));
  // How much room two of them leave each other, by experience.
  constexpr double reach = 4.0;
  const double others_near = -std::log1p(-std::min(share_in_contact, 0.99));
  room_ = std::cbrt(static_cast<double>(std::max<std::size_t>(count, 1)) * reach / others_near);
  for (std::size_t i = 0; i < count; ++i) {
    shapes_.push_back(random_shape(random, hulls));
    Flight flight;
    flight.centre = vector_between(random, 0, room_);
    flight.velocity = vector_between(random, -0.02, 0.02);
    flight.axis = vector_between(random, -1, 1) + Vec3{0, 0, 1.5};
    flight.angle = random.between(0, 360);
    flight.spin = random.between(-3, 3);
    flights_.push_back(flight);
  }
  poses_.resize(count);
  for (std::size_t i = 0; i < count; ++i) place(i);
}

void BodyCrowd::place(std::size_t number) {
  const Flight& flight = flights_[number];
  poses_[number] = {rotation_about(flight.axis, flight.angle), flight.centre};
}

void BodyCrowd::step() {
  for (std::size_t i = 0; i < flights_.size(); ++i) {
    Flight& flight = flights_[i];
    fly(flight.centre.x, flight.velocity.x, room_);
    fly(flight.centre.y, flight.velocity.y, room_);
    fly(flight.centre.z, flight.velocity.z, room_);
    flight.angle += flight.spin;
    place(i);
  }
}

}  // namespace toccata
