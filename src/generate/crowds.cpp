#include "toccata/generate/crowds.hpp"
#include "generate/random_vector.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

Vec3 times(const Vec3& a, const Vec3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// About normally distributed, of deviation 1: the sum of twelve uniform numbers, which is the same on every platform.
double bell(Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum;
}

/// About 10^-x, for x up to 3: straight between eighths, so that it is the same on every platform.
double decades_down(double x) {
  constexpr double eighth = 0.7498942093324559;  // 10^(-1/8)
  double power = 1, rest = 8 * x;
  while (rest > 0) {
    power *= 1 - std::min(rest, 1.0) * (1 - eighth);
    rest -= 1;
  }
  return power;
}

double ground_at(double x, double y) {
  // Hills of about 100 units, without functions that differ from one platform to another.
  const auto wave = [](double t) {
    const double phase = t - std::floor(t);
    return 16 * phase * (1 - phase) - 2;
  };
  return 6 * wave(x / 97) + 5 * wave(y / 113 + 0.3 * wave(x / 211));
}

double reflected(double& velocity, double value, double least, double most) {
  if (value < least && velocity < 0) velocity = -velocity;
  if (value > most && velocity > 0) velocity = -velocity;
  return std::clamp(value, least, most);
}

}  // namespace

std::span<const NamedScene> crowd_scenes() {
  static const std::vector<NamedScene> scenes{
      {"uniform", "boxes of similar sizes fill a room and move by a hundredth of their size a frame"},
      {"clustered", "the same in heaps of 2000, far apart"},
      {"sizes", "sizes over three decades"},
      {"static", "as uniform, but only one in twenty moves"},
      {"terrain", "a crowd that walks on hills"},
      {"fast", "as uniform, but each moves by its size a frame"},
      {"bounce", "as uniform, but they fall, bounce off the floor and rise again"},
      {"pile", "boxes of one size lie on and beside each other, and each trembles in its place"},
  };
  return scenes;
}

Crowd::Crowd(std::string_view scene, std::size_t count, std::uint64_t seed) {
  const std::span<const NamedScene> known = crowd_scenes();
  if (std::none_of(known.begin(), known.end(), [&](const NamedScene& one) { return one.name == scene; })) {
    std::vector<std::string> names;
    for (const NamedScene& one : known) names.push_back(one.name);
    throw Error(fmt::format("there is no crowd '{}'{}", scene, suggestion(scene, names)));
  }
  Random random(seed);
  const bool clustered = scene == "clustered", sizes = scene == "sizes";
  on_ground_ = scene == "terrain";
  const double boxes_per_volume = sizes ? 37.7 : clustered ? 0.00075 : 0.75;
  const auto all = static_cast<double>(std::max<std::size_t>(count, 1));
  const double side = on_ground_ ? std::sqrt(all / 1.5) : std::cbrt(all / boxes_per_volume);
  const Vec3 room{side, side, on_ground_ ? 0 : side};
  gravity_ = scene == "bounce" ? 0.001 : 0;
  const auto per_side = static_cast<Index>(std::ceil(std::cbrt(all)));
  std::vector<Vec3> heaps(std::max<std::size_t>(1, count / 2000));
  for (Vec3& heap : heaps) heap = vector_between(random, 0.05 * side, 0.95 * side);
  const double speed = scene == "fast" ? 1 : 0.01;
  bodies_.reserve(count);
  for (Index number = 0; number < count; ++number) {
    Body body;
    body.centre = times(vector_between(random, 0, 1), room);
    body.most = room;
    if (clustered) {
      const Vec3 by{bell(random), bell(random), bell(random)};
      body.centre = heaps[number % heaps.size()] + 4.0 * by;
    }
    body.half = sizes ? decades_down(random.between(0, 3)) * vector_between(random, 0.4, 0.6)
                      : vector_between(random, 0.25, 0.75);
    body.velocity = speed * times(body.half, vector_between(random, -2, 2));
    if (on_ground_) body.half.z = 0.75 + 0.5 * body.half.z;
    if (gravity_ > 0) {  // on its way up or down from a height between its own and the room's
      const double rise = random.unit() * (side - body.centre.z);
      body.velocity.z = (number % 2 == 0 ? 1 : -1) * std::sqrt(2 * gravity_ * rise);
    }
    if (scene == "pile") put_into_pile(body, number, per_side);
    bodies_.push_back(body);
    if (scene != "static" || random.below(20) == 0) moving_.push_back(number);
  }
  boxes_.resize(count);
  for (Index number = 0; number < count; ++number) place(number);
}

/// In layers of one height, so that of each layer all ends lie within the way that a box trembles.
void Crowd::put_into_pile(Body& body, Index number, Index per_side) {
  const Index row = number / per_side, layer = row / per_side;
  const Vec3 place{static_cast<double>(number % per_side), static_cast<double>(row % per_side),
                   static_cast<double>(layer)};
  const Vec3 reach{0.02, 0.02, 0.02}, size_before = body.half;
  body.half = {0.5, 0.5, 0.5};
  body.least = place - reach;
  body.most = place + reach;
  // Sizes and velocities of the other scenes are random enough for where and how it begins.
  body.centre = body.least + times(2 * reach, 2 * (size_before - Vec3{0.25, 0.25, 0.25}));
  body.velocity = 0.25 * body.velocity;
}

void Crowd::place(Index number) {
  Body& body = bodies_[number];
  if (on_ground_) body.centre.z = ground_at(body.centre.x, body.centre.y) + body.half.z;
  boxes_[number] = {body.centre - body.half, body.centre + body.half};
}

std::span<const Index> Crowd::step() {
  for (const Index number : moving_) {
    Body& body = bodies_[number];
    body.velocity.z -= gravity_;
    const Vec3 to = body.centre + body.velocity;
    body.centre = {reflected(body.velocity.x, to.x, body.least.x, body.most.x),
                   reflected(body.velocity.y, to.y, body.least.y, body.most.y),
                   reflected(body.velocity.z, to.z, body.least.z, body.most.z)};
    place(number);
  }
  return moving_;
}

}  // namespace toccata
