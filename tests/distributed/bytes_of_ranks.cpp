// What ranks send each other of a body: every bit of it comes back, in few bytes.
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "distributed/body_bytes.hpp"
#include "distributed/pose_bytes.hpp"
#include "distributed/twin_worlds.hpp"
#include "toccata/core/random.hpp"
#include "world/random_bodies.hpp"

namespace toccata::test {
namespace {

/// The bytes that it takes.
std::size_t expect_pose_back(const Pose& pose) {
  MessageWriter writer;
  put_pose(writer, pose);
  const Bytes bytes = writer.take();
  MessageReader reader(bytes);
  const Pose back = get_pose(reader);
  EXPECT_TRUE(reader.is_at_end());
  EXPECT_EQ(std::memcmp(&back, &pose, sizeof(Pose)), 0);
  return bytes.size();
}

TEST(BytesOfRanks, BringNumbersBack) {
  std::vector<std::uint64_t> numbers{0, 1, 127, 128, std::numeric_limits<std::uint64_t>::max()};
  for (int bit = 0; bit < 64; ++bit) numbers.push_back((std::uint64_t{1} << bit) - 1);
  MessageWriter writer;
  for (const std::uint64_t number : numbers) writer.put_number(number);
  const Bytes bytes = writer.take();
  MessageReader reader(bytes);
  for (const std::uint64_t number : numbers) EXPECT_EQ(reader.get_number(), number);
  EXPECT_TRUE(reader.is_at_end());
  const std::vector<std::byte> endless(11, std::byte{0xff});
  MessageReader wrong(endless);
  EXPECT_THROW(static_cast<void>(wrong.get_number()), Error);
}

TEST(BytesOfRanks, BringPosesBackBitForBit) {
  Random random(1);
  EXPECT_EQ(expect_pose_back(Pose::translation(1, 2, 3)), 25U);
  std::size_t most = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 axis = vector_in(random, -1, 1);
    Pose pose = Pose::rotation(axis, random.between(-180, 180));
    pose.offset = vector_in(random, -1e6, 1e6);
    most = std::max(most, expect_pose_back(pose));
  }
  EXPECT_LE(most, 90U);
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, -1}})
    for (int degrees = -360; degrees <= 360; degrees += 15) expect_pose_back(Pose::rotation(axis, degrees));
}

/// Any twelve numbers may be a pose: also those with two zeros, denormal ones, and mirrored rotations.
TEST(BytesOfRanks, BringAnyTwelveNumbersBack) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    Pose pose;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        pose.linear[row][column] = i % 2 == 0 ? std::bit_cast<double>(random.bits()) : random.between(-1, 1);
    EXPECT_LE(expect_pose_back(pose), 97U);
  }
  Pose pose;
  pose.linear[1][2] = -0.0;
  EXPECT_GT(expect_pose_back(pose), 25U);
  pose.linear[2] = {0, -0.0, -1};
  expect_pose_back(pose);
  pose.linear[2][0] = std::numeric_limits<double>::denorm_min();
  expect_pose_back(pose);
}

std::vector<std::size_t> sizes_of_bodies(const std::vector<Body>& bodies) {
  ModelStore from(0), to(1);
  std::vector<std::size_t> sizes;
  for (const Body& body : bodies) {
    MessageWriter writer;
    put_body(writer, body, from, 1, ModelGoes::once);
    const Bytes bytes = writer.take();
    MessageReader reader(bytes);
    const Body back = get_body(reader, to);
    EXPECT_TRUE(reader.is_at_end());
    EXPECT_EQ(back.pose, body.pose);
    EXPECT_EQ(std::tie(back.type, back.solid, back.category, back.mask, back.margin, back.max_acceleration,
                       back.max_speed, back.user_data, back.name),
              std::tie(body.type, body.solid, body.category, body.mask, body.margin, body.max_acceleration,
                       body.max_speed, body.user_data, body.name));
    EXPECT_EQ(back.model.shape().index(), body.model.shape().index());
    sizes.push_back(bytes.size());
  }
  return sizes;
}

TEST(BytesOfRanks, BringBodiesBack) {
  Body other{Box({1, 2, 3}), Pose::rotation({1, 2, 3}, 40)};
  other.type = BodyType::kinematic_body;
  other.solid = Solid::none;
  other.category = 6;
  other.mask = 5;
  other.margin = 0.5;
  other.max_acceleration = 3;
  other.max_speed = 9;
  other.user_data = 77;
  other.name = "gear";
  const std::vector<std::size_t> sizes = sizes_of_bodies({Body{Box({1, 2, 3})}, other});
  EXPECT_EQ(sizes[0], 77U);
  EXPECT_GT(sizes[1], 130U);
  Random random(3);
  std::vector<Body> bodies;
  for (int i = 0; i < 200; ++i) bodies.push_back(random_body("any", random));
  static_cast<void>(sizes_of_bodies(bodies));
}

/// Every box of a row moves, and turns on where that is said; which ranks have which stays as it is.
void expect_few_bytes(bool turns, std::size_t most) {
  TwinWorlds twins;
  Random random(4);
  std::vector<Body> bodies;
  for (int i = 0; i < 200; ++i) {
    Body box{Box({0.6, 0.6, 0.6}), Pose::rotation(vector_in(random, -1, 1), 1)};
    box.pose.offset.x = i;
    box.margin = 1;
    bodies.push_back(box);
  }
  twins.add(bodies);
  twins.step();
  twins.step();
  const std::vector<BodyId> ids = twins.world.bodies();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    Pose pose = turns ? Pose::rotation(vector_in(random, -1, 1), 1) : bodies[i].pose;
    pose.offset = bodies[i].pose.offset + Vec3{0, 0.001, 0.002};
    twins.move(ids[i], pose);
  }
  twins.step();
  const DistributedCosts& costs = twins.distributed.last_step().costs;
  EXPECT_EQ(costs.came, 0U);
  EXPECT_EQ(costs.ghosts_elsewhere > 0, our_ranks().count() > 1);
  EXPECT_LE(costs.bytes_sent, most * costs.ghosts_elsewhere);
  EXPECT_EQ(costs.neighbours > 0, our_ranks().count() > 1);
}

TEST(BytesOfRanks, AreAHundredOfAGhostThatMovesAtMost) {
  expect_few_bytes(false, 35);
  expect_few_bytes(true, 100);
}

TEST(BytesOfRanks, AreNoneOfAGhostThatRests) {
  TwinWorlds twins;
  twins.add(row_of_spheres(60));
  twins.step();
  for (const BodyId id : twins.world.bodies()) twins.move(id, twins.world.body(id).pose);
  twins.step();
  // What is moved to where it is tells its offset: that it is the same is not looked for.
  EXPECT_LE(twins.distributed.last_step().costs.bytes_sent, 35 * twins.distributed.last_step().costs.ghosts_elsewhere);
  twins.step();
  EXPECT_EQ(twins.distributed.last_step().costs.bytes_sent, 0U);
}

}  // namespace
}  // namespace toccata::test
