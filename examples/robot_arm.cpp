// A robot arm of three links beside a table: which joint angles are free, and with how much clearance?
#include <toccata/toccata.hpp>

#include <array>
#include <cstdio>

using namespace toccata;

namespace {

constexpr double link_length = 1;

/// Where the links are for joint angles in degrees, about the y axis.
std::array<Pose, 3> forward_kinematics(const std::array<double, 3>& degrees) {
  std::array<Pose, 3> poses;
  Pose joint = Pose::translation(0, 0, 1);
  double angle = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    angle += degrees[i];
    joint = {rotation_about({0, 1, 0}, angle), joint.offset};
    poses[i] = joint;
    joint.offset = transform(joint, {0, 0, link_length});
  }
  return poses;
}

}  // namespace

int main() {
  World world({.distance = true});  // the distance of every pair that is told
  std::array<BodyId, 3> links;
  const std::array<const char*, 3> names = {"upper arm", "forearm", "hand"};
  for (std::size_t i = 0; i < 3; ++i) {
    Body link{Capsule({0, 0, 0}, {0, 0, link_length}, 0.1)};
    link.name = names[i];
    link.margin = 0.25;  // pairs are told that are as near as this or nearer
    links[i] = world.add(link);
  }
  Body table{Box({1, 1, 0.05}), Pose::translation(1.5, 0, 0.75)};
  table.name = "table";
  table.type = BodyType::static_body;
  world.add(table);

  // Neighbours share a joint, so they always touch: they are no pair.
  world.set_rule({.a = links[0], .b = links[1], .excluded = true});
  world.set_rule({.a = links[1], .b = links[2], .excluded = true});

  int free = 0, near = 0, colliding = 0;
  for (double shoulder = 0; shoulder <= 120; shoulder += 10)
    for (double elbow = -120; elbow <= 120; elbow += 10)
      for (double wrist = -90; wrist <= 90; wrist += 30) {
        world.move(links, forward_kinematics({shoulder, elbow, wrist}));
        world.step();
        bool touches = false;
        for (const PairReport& pair : world.pairs()) touches = touches || pair.in_contact;
        ++(touches ? colliding : world.pairs().empty() ? free : near);
      }
  std::printf("%d configurations collide, %d come nearer than the margin, %d are free\n", colliding, near, free);

  world.move(links, forward_kinematics({50, 60, 0}));
  world.step();
  for (const PairReport& pair : world.pairs())
    std::printf("%s and %s: %s, %.3f apart\n", world.body(pair.a).name.c_str(), world.body(pair.b).name.c_str(),
                pair.in_contact ? "contact" : "near", pair.details->distance->upper);
}
