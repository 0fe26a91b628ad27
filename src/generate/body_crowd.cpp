#include "generate/random_vector.hpp"
#include "toccata/generate/crowds.hpp"

#include <algorithm>
#include <cmath>
#include <string>

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

/// How far two bodies that lie on each other overlap.
constexpr double resting_depth = 0x1p-9;

/// A frame and frame.
constexpr double gravity = 0x1p-9;

/// Hills of some ten units, without functions that differ from one platform to another.
double height_of_hills(double x, double y) {
  const auto wave = [](double t) {
    const double phase = t - std::floor(t), fall = phase * (1 - phase);
    return 16 * fall * fall - 0.5;
  };
  return wave(x / 12) + wave(y / 14 + 0.25);
}

/// How far below its own origin a shape reaches under a rotation.
struct ReachDown {
  double operator()(const Sphere& sphere) const { return sphere.radius(); }
  double operator()(const Capsule& capsule) const { return std::fabs(down.z * capsule.end().z) + capsule.radius(); }
  double operator()(const Box& box) const {
    const Vec3& half = box.half_extents();
    return (std::fabs(down.x * half.x) + std::fabs(down.y * half.y)) + std::fabs(down.z * half.z);
  }
  double operator()(const ConvexHull& hull) const {
    double reach = 0;
    for (Index i = 0; i < hull.vertex_count(); ++i) reach = std::max(reach, -dot(down, hull.vertex(i)));
    return reach;
  }
  template <class Other>
  double operator()(const Other&) const {
    return 0;
  }
  Vec3 down;  ///< the rotation's last row
};

std::vector<ConvexHull> random_hulls(Random& random) {
  std::vector<ConvexHull> hulls;
  while (hulls.size() < 16) hulls.push_back(random_hull(random));
  return hulls;
}

}  // namespace

std::span<const NamedScene> body_crowd_scenes() {
  static const std::vector<NamedScene> scenes{
      {"fly", "they fly and turn in a room, one in twenty in contact"},
      {"stacks", "boxes stand in stacks of eight and tremble, and others roll over the floor between them"},
      {"pile", "they lie on and beside each other, and each trembles in its place"},
      {"floor", "they fall on a large box, and roll on"},
      {"terrain", "they fall on hills of triangles, and roll on"},
  };
  return scenes;
}

BodyCrowd::BodyCrowd(std::size_t count, double share_in_contact, std::uint64_t seed) {
  if (!(share_in_contact >= 0.001 && share_in_contact <= 1))
    throw Error(fmt::format("a share of {} bodies in contact: it has to lie between 0.001 and 1", share_in_contact));
  Random random(seed);
  hulls_ = random_hulls(random);
  // How much room two of them leave each other, by experience.
  constexpr double reach = 4.0;
  const double others_near = -std::log1p(-std::min(share_in_contact, 0.99));
  room_ = std::cbrt(static_cast<double>(std::max<std::size_t>(count, 1)) * reach / others_near);
  fill(count, random);
}

BodyCrowd::BodyCrowd(std::string_view scene, std::size_t count, std::uint64_t seed) {
  const std::span<const NamedScene> known = body_crowd_scenes();
  if (std::none_of(known.begin(), known.end(), [&](const NamedScene& one) { return one.name == scene; })) {
    std::vector<std::string> names;
    for (const NamedScene& one : known) names.push_back(one.name);
    throw Error(fmt::format("there is no crowd of bodies '{}'{}", scene, suggestion(scene, names)));
  }
  if (scene == "fly") {
    *this = BodyCrowd(count, 0.05, seed);
    return;
  }
  Random random(seed);
  hulls_ = random_hulls(random);
  has_hills_ = scene == "terrain";
  room_ = 1.75 * std::ceil(std::sqrt(static_cast<double>(std::max<std::size_t>(count, 1))));
  add_ground(scene);
  if (scene == "stacks")
    add_stacks(count, random);
  else if (scene == "pile")
    add_pile(count, random);
  else
    add_falling(count, random);
}

void BodyCrowd::add(const Shape& shape, const Flight& flight) {
  shapes_.push_back(shape);
  flights_.push_back(flight);
  poses_.push_back({});
  place(shapes_.size() - 1);
}

void BodyCrowd::fill(std::size_t count, Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    const Shape shape = random_shape(random, hulls_);
    Flight flight;
    flight.centre = vector_between(random, 0, room_);
    flight.velocity = vector_between(random, -0.02, 0.02);
    flight.axis = vector_between(random, -1, 1) + Vec3{0, 0, 1.5};
    flight.angle = random.between(0, 360);
    flight.spin = random.between(-3, 3);
    add(shape, flight);
  }
}

void BodyCrowd::add_ground(std::string_view scene) {
  Flight flight;
  flight.axis = {0, 0, 1};
  flight.motion = Motion::stay;
  ground_count_ = 1;
  constexpr double border = 4;
  if (scene != "terrain") {
    flight.centre = {0.5 * room_, 0.5 * room_, -1};
    add(Box({0.5 * room_ + border, 0.5 * room_ + border, 1}), flight);
    return;
  }
  flight.centre = {-border, -border, 0};
  const auto side = static_cast<Index>(room_ + 2 * border) + 2;
  std::vector<double> heights;
  for (Index j = 0; j < side; ++j)
    for (Index i = 0; i < side; ++i) heights.push_back(height_of_hills(i - border, j - border));
  add(HeightField(side, side, 1, 1, heights), flight);
}

void BodyCrowd::add_stacks(std::size_t count, Random& random) {
  constexpr std::size_t high = 8;
  // Eight of every ten bodies are a stack, beside a lane in which the others roll.
  const std::size_t stacks = count / 10;
  const auto per_row = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(stacks + 1))));
  for (std::size_t stack = 0; stack < stacks; ++stack) {
    const std::size_t row = stack / per_row;
    const Vec3 foot{3.5 * static_cast<double>(stack % per_row), 3.5 * static_cast<double>(row), 0};
    double top = 0;
    for (std::size_t i = 0; i < high; ++i) {
      const Vec3 half = vector_between(random, 0.3, 0.6);
      Flight flight;
      flight.centre = foot + Vec3{random.between(-0.1, 0.1), random.between(-0.1, 0.1), top + half.z - resting_depth};
      flight.velocity = {random.between(-0x1p-10, 0x1p-10), random.between(-0x1p-10, 0x1p-10), 0};
      flight.axis = {0, 0, 1};
      flight.angle = random.between(0, 360);
      flight.spin = random.between(-0.05, 0.05);
      flight.motion = Motion::tremble;
      top = flight.centre.z + half.z;
      add(Box(half), flight);
    }
  }
  const double side = 3.5 * static_cast<double>(per_row);
  while (shapes_.size() < count + ground_count_) {
    Flight flight;
    const double lane = 3.5 * static_cast<double>(random.below(per_row)) + 1.75;
    flight.centre = {random.between(0, side), lane + random.between(-0.2, 0.2), 0};
    flight.velocity = {random.between(-0.02, 0.02), 0, 0};
    flight.axis = vector_between(random, -1, 1) + Vec3{0, 0, 1.5};
    flight.spin = random.between(-3, 3);
    flight.motion = Motion::roll;
    add(random_shape(random, hulls_), flight);
    lay_down(shapes_.size() - 1, 0);
  }
}

void BodyCrowd::lay_down(std::size_t number, double above) {
  flights_[number].centre.z = resting_height(number) + above;
  place(number);
}

void BodyCrowd::add_pile(std::size_t count, Random& random) {
  constexpr double apart = 0.875;
  const auto per_side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(count))));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t x = i % per_side, y = i / per_side % per_side, z = i / per_side / per_side;
    Flight flight;
    flight.centre = apart * Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z) + 0.5};
    flight.velocity = vector_between(random, -0x1p-10, 0x1p-10);
    flight.axis = vector_between(random, -1, 1) + Vec3{0, 0, 1.5};
    flight.angle = random.between(0, 360);
    flight.spin = random.between(-0.05, 0.05);
    flight.motion = Motion::tremble;
    add(random_shape(random, hulls_), flight);
  }
}

void BodyCrowd::add_falling(std::size_t count, Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    Flight flight;
    flight.centre = {random.between(0, room_), random.between(0, room_), 0};
    flight.velocity = {random.between(-0.02, 0.02), random.between(-0.02, 0.02), 0};
    flight.axis = vector_between(random, -1, 1) + Vec3{0, 0, 1.5};
    flight.angle = random.between(0, 360);
    flight.spin = random.between(-3, 3);
    flight.motion = Motion::fall;
    add(random_shape(random, hulls_), flight);
    // A third lies already.
    lay_down(shapes_.size() - 1, i % 3 == 0 ? 0 : random.between(0, 4));
  }
}

double BodyCrowd::resting_height(std::size_t number) const {
  const Flight& flight = flights_[number];
  const double ground = has_hills_ ? height_of_hills(flight.centre.x, flight.centre.y) : 0;
  const Mat3 turned = rotation_about(flight.axis, flight.angle);
  return ground + std::visit(ReachDown{turned[2]}, shapes_[number]) - resting_depth;
}

void BodyCrowd::place(std::size_t number) {
  const Flight& flight = flights_[number];
  poses_[number] = {rotation_about(flight.axis, flight.angle), flight.centre};
}

void BodyCrowd::go_on(std::size_t number) {
  Flight& flight = flights_[number];
  const double there_and_back = frame_ % 2 == 0 ? 1 : -1;
  switch (flight.motion) {
    case Motion::fly:
      fly(flight.centre.x, flight.velocity.x, room_);
      fly(flight.centre.y, flight.velocity.y, room_);
      fly(flight.centre.z, flight.velocity.z, room_);
      flight.angle += flight.spin;
      return;
    case Motion::tremble:
      flight.centre = flight.centre + there_and_back * flight.velocity;
      flight.angle += there_and_back * flight.spin;
      return;
    case Motion::roll:
    case Motion::fall:
      fly(flight.centre.x, flight.velocity.x, room_);
      fly(flight.centre.y, flight.velocity.y, room_);
      flight.angle += flight.spin;
      flight.velocity.z -= gravity;
      flight.centre.z = std::max(flight.centre.z + flight.velocity.z, resting_height(number));
      if (flight.motion == Motion::roll || flight.centre.z <= resting_height(number)) flight.velocity.z = 0;
      return;
    case Motion::stay:
      return;
  }
}

void BodyCrowd::step() {
  for (std::size_t i = 0; i < flights_.size(); ++i) {
    go_on(i);
    place(i);
  }
  ++frame_;
}

}  // namespace toccata
