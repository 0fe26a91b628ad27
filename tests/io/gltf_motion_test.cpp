#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <string>

#include "io/text_file.hpp"
#include "support/base64.hpp"
#include "toccata/io/query_files.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

using test::message_of;

class GltfMotion : public testing::Test {
 protected:
  /// The place of an accessor of these floats.
  int floats(const std::string& type, std::initializer_list<float> values) {
    const std::size_t components = type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4;
    std::string bytes;
    for (const float value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    views += (views.empty() ? "" : ",") + std::string("{\"buffer\": 0, \"byteOffset\": ") +
             std::to_string(data.size()) + ", \"byteLength\": " + std::to_string(bytes.size()) + "}";
    accessors += (accessors.empty() ? "" : ",") + std::string("{\"bufferView\": ") + std::to_string(count) +
                 R"(, "componentType": 5126, "count": )" + std::to_string(values.size() / components) +
                 R"(, "type": ")" + type + "\"}";
    data += bytes;
    return count++;
  }

  /// Has an animation's channel move a node.
  void move(int node, const std::string& path, int times, int values, const std::string& way = "LINEAR") {
    const std::string comma = samplers.empty() ? "" : ",";
    channels += comma + R"({"sampler": )" + std::to_string(moved) + R"(, "target": {"node": )" + std::to_string(node) +
                R"(, "path": ")" + path + "\"}}";
    samplers += comma + R"({"input": )" + std::to_string(times) + R"(, "output": )" + std::to_string(values) +
                R"(, "interpolation": ")" + way + "\"}";
    ++moved;
  }

  FileMotion read(const std::string& node = "") {
    const std::string text = R"({"asset": {"version": "2.0"}, "nodes": [)" + nodes +
                             R"(], "animations": [{"channels": [)" + channels + R"(], "samplers": [)" + samplers +
                             R"(]}], "accessors": [)" + accessors + R"(], "bufferViews": [)" + views +
                             R"(], "buffers": [{"byteLength": )" + std::to_string(data.size()) +
                             R"(, "uri": "data:application/octet-stream;base64,)" + test::base64(data) + "\"}]}";
    return read_motion(folder.write("a.gltf", text).string(), node);
  }

  std::string error(const std::string& node = "") {
    return message_of([&] { (void)read(node); });
  }

  /// A base that turns what is on it by a quarter about z and doubles it, with an arm.
  std::string nodes = R"({"name": "base", "children": [1], "rotation": [0, 0, 1, 1], "scale": [2, 2, 2],
                         "translation": [10, 0, 0]},
                        {"name": "arm", "translation": [1, 0, 0]}, {"name": "lamp"})";
  std::string data, views, accessors, channels, samplers;
  int count = 0, moved = 0;
  test::TemporaryFolder folder;
};

const float half = std::sqrt(0.5F);

/// Where the arm of the file is in the world at a time: what is at `local` in its frame.
Vec3 of_arm(const FileMotion& motion, double time, const Vec3& local) {
  const Pose base = pose_of({10, 0, 0}, rotation_about({0, 0, 1}, 90), {2, 2, 2});
  const RigidMotion through = RigidMotion::through(motion.keys, motion.centre);
  return through.at(time) * (base * (Pose::translation(1, 0, 0) * local));
}

TEST_F(GltfMotion, TurnsAboutTheNodesOriginAndGoesStraightOnInItsParentsFrame) {
  const int times = floats("SCALAR", {1, 2, 5});
  move(1, "translation", times, floats("VEC3", {1, 0, 0, 1, 3, 0, 1, 3, 4}));
  move(1, "rotation", times, floats("VEC4", {0, 0, 0, 1, 0, 0, half, half, 0, 0, half, half}));
  const FileMotion motion = read();
  EXPECT_TRUE(motion.is_in_metres);
  ASSERT_EQ(motion.keys.size(), 3U);
  EXPECT_EQ(motion.keys[1].time, 0.25);
  const Pose base = pose_of({10, 0, 0}, rotation_about({0, 0, 1}, 90), {2, 2, 2});
  for (const double part : {0.0, 0.5, 1.0}) {
    const Pose arm{rotation_about({0, 0, 1}, 90 * part), {1, 3 * part, 0}};
    EXPECT_LT(length(of_arm(motion, 0.25 * part, {1, 2, 3}) - base * (arm * Vec3{1, 2, 3})), 1e-5) << part;
  }
  EXPECT_LT(length(of_arm(motion, 1, {1, 2, 3}) - base * (Vec3{1, 3, 4} + Vec3{-2, 1, 3})), 1e-5);
}

TEST_F(GltfMotion, RestsBeforeAndAfterAChannelsKeys) {
  move(1, "translation", floats("SCALAR", {0, 4}), floats("VEC3", {1, 0, 0, 1, 0, 4}));
  move(1, "rotation", floats("SCALAR", {1, 2}), floats("VEC4", {0, 0, 0, 1, 0, 0, half, half}));
  const FileMotion motion = read();
  ASSERT_EQ(motion.keys.size(), 4U);
  EXPECT_EQ(motion.keys[1].time, 0.25);
  EXPECT_EQ(motion.keys[2].time, 0.5);
  const Pose base = pose_of({10, 0, 0}, rotation_about({0, 0, 1}, 90), {2, 2, 2});
  EXPECT_LT(length(of_arm(motion, 0.125, {1, 0, 0}) - base * Vec3{2, 0, 0.5}), 1e-6);
  EXPECT_LT(length(of_arm(motion, 1, {1, 0, 0}) - base * Vec3{1, 1, 4}), 1e-6);
}

TEST_F(GltfMotion, IsThatOfTheNodeWhoseNameIsGiven) {
  const int times = floats("SCALAR", {0, 1});
  move(1, "translation", times, floats("VEC3", {1, 0, 0, 2, 0, 0}));
  move(2, "translation", times, floats("VEC3", {0, 0, 0, 0, 0, 7}));
  EXPECT_EQ(read("lamp").keys[1].pose, Pose::translation(0, 0, 7));
  EXPECT_NE(error().find("2 nodes move; name one of 'arm', 'lamp'"), std::string::npos) << error();
  EXPECT_NE(error("base").find("no node 'base' moves; name one of"), std::string::npos);
}

TEST_F(GltfMotion, WhatIsNoRigidMotionIsRefused) {
  EXPECT_NE(error().find("no animation"), std::string::npos) << error();
  const int times = floats("SCALAR", {0, 1}), places = floats("VEC3", {1, 0, 0, 2, 0, 0});
  move(1, "translation", times, places, "STEP");
  EXPECT_NE(error().find("joined by STEP, and only LINEAR"), std::string::npos) << error();
  channels = samplers = "";
  moved = 0;
  move(1, "scale", times, places);
  EXPECT_NE(error().find("its scale changes"), std::string::npos) << error();
  channels = samplers = "";
  moved = 0;
  move(1, "translation", times, places);
  move(1, "translation", times, places);
  EXPECT_NE(error().find("the translation is animated twice"), std::string::npos) << error();
  channels = samplers = "";
  moved = 0;
  move(1, "translation", times, places);
  move(0, "translation", times, places);
  EXPECT_NE(error("arm").find("'arm' moves, and so does 'base' above it"), std::string::npos) << error("arm");
}

TEST_F(GltfMotion, BrokenKeysAreToldByTheirPlace) {
  const auto error_of = [&](const std::string& path, int times, int values) {
    channels = samplers = "";
    moved = 0;
    move(1, path, times, values);
    return error();
  };
  const int places = floats("VEC3", {1, 0, 0, 2, 0, 0}), times = floats("SCALAR", {0, 1});
  EXPECT_NE(error_of("translation", floats("SCALAR", {0, 1, 2}), places).find("3 times for 2 values"),
            std::string::npos);
  EXPECT_NE(error_of("translation", floats("SCALAR", {1, 1}), places).find("/animations/0/samplers/0/input: the time"),
            std::string::npos);
  EXPECT_NE(error_of("translation", floats("SCALAR", {0, std::numeric_limits<float>::infinity()}), places)
                .find("key 1 is not finite"),
            std::string::npos);
  EXPECT_NE(error_of("rotation", times, floats("VEC4", {0, 0, 0, 1, 0, 0, 0, 0})).find("key 1: "), std::string::npos);
  EXPECT_NE(error_of("rotation", times, places).find("must be of type VEC4"), std::string::npos);
  EXPECT_NE(error_of("translation", 99, places).find("there is no accessor 99"), std::string::npos);
  EXPECT_NE(error_of("translation", floats("SCALAR", {1}), floats("VEC3", {1, 2, 3})).find("a single moment"),
            std::string::npos);
}

TEST_F(GltfMotion, WhatIsOfAnotherTypeIsNotTakenForLeftOut) {
  channels = R"({"sampler": 0, "target": 5})";
  samplers = R"({"input": 0, "output": 0})";
  EXPECT_NE(error().find("a.gltf: at /animations/0/channels/0/target: this is not an object"), std::string::npos)
      << error();
  channels = "5";
  EXPECT_NE(error().find("a.gltf: at /animations/0/channels/0: this is not an object"), std::string::npos) << error();
}

TEST_F(GltfMotion, NodesThatAreTheirOwnAncestorsAreRefused) {
  nodes = R"({"name": "one", "children": [1]}, {"name": "other", "children": [0]})";
  move(0, "translation", floats("SCALAR", {0, 1}), floats("VEC3", {1, 0, 0, 2, 0, 0}));
  EXPECT_NE(error().find("its own ancestor"), std::string::npos) << error();
}

TEST(MotionFileOfText, HasNoNodes) {
  test::TemporaryFolder folder;
  const std::string path = folder.write("m.txt", "0 0 0 0\n1 1 0 0\n").string();
  EXPECT_NE(message_of([&] { (void)read_motion(path, "arm"); }).find("only a glTF or GLB file has nodes"),
            std::string::npos);
}

}  // namespace
}  // namespace toccata
