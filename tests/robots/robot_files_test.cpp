#include "toccata/robots/robot_files.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "robots/robot_cases.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

namespace toccata::test {
namespace {

bool tells(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Two links of every kind of shape.
constexpr const char* small_urdf = R"(<?xml version="1.0"?>
<robot name="small">
  <link name="base">
    <collision><origin xyz="0 0 0.5"/><geometry><box size="0.2 0.4 1"/></geometry></collision>
    <collision name="knob"><geometry><sphere radius="0.3"/></geometry></collision>
  </link>
  <link name="arm">
    <collision><geometry><cylinder radius="0.1" length="2"/></geometry></collision>
  </link>
  <link name="hand">
    <collision><geometry><mesh filename="package://parts/hand.off" scale="0.5 0.5 1"/></geometry></collision>
  </link>
  <link name="lamp"><visual><geometry><sphere radius="1"/></geometry></visual></link>
  <joint name="turn" type="revolute">
    <origin xyz="0 0 1" rpy="0 1.5707963267948966 0"/>
    <parent link="base"/><child link="arm"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="2" effort="1" velocity="1"/>
  </joint>
  <joint name="slide" type="prismatic">
    <parent link="arm"/><child link="hand"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="0.5" effort="1" velocity="1"/>
    <mimic joint="turn" multiplier="0.1" offset="0.2"/>
  </joint>
  <joint name="hook" type="fixed"><parent link="arm"/><child link="lamp"/></joint>
</robot>
)";

constexpr const char* hand_mesh = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

class UrdfFile : public ::testing::Test {
 protected:
  UrdfFile() { folder_.write("parts/hand.off", hand_mesh); }
  void SetUp() override {
    if (!reads_urdf()) GTEST_SKIP() << "urdfdom was not there when this was built";
  }

  [[nodiscard]] std::string written(const std::string& text) const {
    return folder_.write("robot.urdf", text).string();
  }
  [[nodiscard]] RobotFile read(const std::string& text) const { return read_urdf(written(text)); }

  /// The message that a change of the text causes, without the folder.
  [[nodiscard]] std::string fault(const std::string& from, const std::string& to) const {
    std::string text = small_urdf;
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    std::string message = message_of([&] { static_cast<void>(read(text)); });
    const std::string folder = folder_.path().string() + "/";
    for (std::size_t at = message.find(folder); at != std::string::npos; at = message.find(folder))
      message.erase(at, folder.size());
    return message;
  }

  TemporaryFolder folder_;
};

TEST_F(UrdfFile, HasTheShapesAndJointsThatItTells) {
  const RobotFile file = read(small_urdf);
  const Robot robot(file.description);
  EXPECT_EQ(robot.name(), "small");
  ASSERT_EQ(robot.bodies().size(), 4U);
  EXPECT_EQ(robot.bodies()[0].pose, Pose::translation(0, 0, 0.5));
  EXPECT_EQ(std::get<Box>(robot.bodies()[0].model.shape()).half_extents(), (Vec3{0.1, 0.2, 0.5}));
  EXPECT_EQ(robot.bodies()[1].name, "base, knob");
  EXPECT_EQ(std::get<Cylinder>(robot.bodies()[2].model.shape()).half_height(), 1);
  EXPECT_EQ(robot.bodies()[3].pose.linear[0], (Vec3{0.5, 0, 0}));
  ASSERT_EQ(robot.positions().size(), 1U);
  EXPECT_EQ(robot.positions()[0].limits, (JointLimits{-1, 2}));
  // At 0 the arm's axis lies along x, and the hand slides along it by 0.2.
  const std::vector<Pose> poses = robot.link_poses(std::vector<double>{0});
  EXPECT_LT(length(poses[robot.link_of("hand")] * Vec3() - (Vec3{0.2, 0, 1})), 1e-15);
  ASSERT_EQ(file.warnings.size(), 1U);
  EXPECT_TRUE(tells(file.warnings[0], "link 'lamp' has a picture and no collision shape"));
}

TEST_F(UrdfFile, WhatIsBrokenIsNamedWithItsLine) {
  EXPECT_EQ(fault("type=\"revolute\"", "type=\"revolut\""),
            "robot.urdf:14: joint 'turn' is of the type 'revolut', which there is not; did you mean 'revolute'?");
  EXPECT_EQ(fault("<child link=\"hand\"/>", "<child link=\"hnd\"/>"),
            "robot.urdf:19: joint 'slide': its child is link 'hnd', which there is not; did you mean 'hand'?");
  EXPECT_TRUE(tells(fault("<parent link=\"base\"/>", "<parent link=\"hand\"/>"), "hangs on itself"));
  EXPECT_TRUE(tells(fault("<child link=\"lamp\"/>", "<child link=\"arm\"/>"), "link 'arm' has two parents"));
  EXPECT_TRUE(tells(fault("<limit lower=\"-1\" upper=\"2\" effort=\"1\" velocity=\"1\"/>", ""), "robot.urdf:14: "));
  EXPECT_TRUE(
      tells(fault("lower=\"-1\" upper=\"2\"", "lower=\"3\" upper=\"2\""), "robot.urdf:14: joint 'turn': its limits"));
  // urdfdom tells what is wrong before it tells of which joint.
  for (const char* limits : {"lower=\"nan\" upper=\"2\"", "lower=\"-inf\" upper=\"inf\""}) {
    const std::string told = fault("lower=\"-1\" upper=\"2\"", limits);
    EXPECT_TRUE(tells(told, "robot.urdf:14: ") && tells(told, "not a valid float")) << told;
  }
  EXPECT_TRUE(tells(fault("<mimic joint=\"turn\"", "<mimic joint=\"trn\""), "joint 'slide': it mimics joint 'trn'"));
  EXPECT_TRUE(tells(fault("radius=\"0.3\"", "radius=\"-0.3\""), "robot.urdf:3: link 'base'"));
  EXPECT_TRUE(tells(fault("hand.off", "hnd.off"), "robot.urdf:10: link 'hand': package://parts/hnd.off is in none of"));
  EXPECT_TRUE(tells(fault("package://parts/hand.off", "hand.stl"), "there is no file"));
  EXPECT_TRUE(tells(fault("package://parts/hand.off", "http://there/hand.stl"), "meshes are read from disk alone"));
  EXPECT_TRUE(tells(fault("scale=\"0.5 0.5 1\"", "scale=\"0.5 0 1\""), "no number of it may be 0"));
  folder_.write("parts/hand.dae", "<COLLADA/>");
  EXPECT_TRUE(tells(fault("hand.off", "hand.dae"), "is COLLADA, which is not read; convert it to STL, OBJ or glTF"));
  folder_.write("parts/broken.off", "OFF\n1 1 0\n0 0 0\n3 0 1 2\n");
  EXPECT_TRUE(tells(fault("hand.off", "broken.off"), "broken.off"));
}

TEST_F(UrdfFile, WhatIsNoRobotIsRefused) {
  EXPECT_TRUE(tells(message_of([&] { static_cast<void>(read("<robot name=\"x\"><link")); }), "this is no XML"));
  EXPECT_TRUE(tells(message_of([&] { static_cast<void>(read("<scene/>")); }), "its root element is <scene>"));
  EXPECT_TRUE(tells(message_of([&] { static_cast<void>(read("<robot name=\"x\"/>")); }), "has no link"));
  EXPECT_TRUE(tells(message_of([&] { static_cast<void>(read("<robot name=\"x\"><link/></robot>")); }),
                    "robot.urdf:1: <link> has no attribute name"));
  EXPECT_NE(message_of([&] { static_cast<void>(read_urdf((folder_ / "none.urdf").string())); }), "");
  EXPECT_NE(message_of([&] { static_cast<void>(read("")); }), "");
}

TEST_F(UrdfFile, OddSizesAreWarnedOf) {
  std::string text = small_urdf;
  text.replace(text.find("0.5 0.5 1\""), 10, "500 500 9\"");
  EXPECT_TRUE(tells(read(text).warnings.at(0), "write scale=\"0.001 0.001 0.001\""));
  text.replace(text.find("500 500 9\""), 10, "1e-5 1e-5 1e-5\"");
  EXPECT_TRUE(tells(read(text).warnings.at(0), "is only"));
  text = small_urdf;
  text.replace(text.find("xyz=\"0 0 1\""), 11, "xyz=\"0 0 1e3\"");
  EXPECT_TRUE(tells(read(text).warnings.back(), "URDF is in metres"));
}

TEST_F(UrdfFile, ANumberThatIsNoneIsToldWithItsJointAndLine) {
  const std::string mimic = "multiplier=\"0.1\" offset=\"0.2\"";
  EXPECT_EQ(fault(mimic, "multiplier=\"fast\""),
            "robot.urdf:22: joint 'slide': <mimic>: multiplier value (fast) is not a valid float");
  EXPECT_EQ(fault(mimic, "offset=\"near\""),
            "robot.urdf:22: joint 'slide': <mimic>: offset value (near) is not a valid float");
  for (const char* number : {"nan", "1e999", "", "1 2"}) {
    const std::string told = fault(mimic, fmt::format("multiplier=\"{}\"", number));
    EXPECT_TRUE(told.starts_with("robot.urdf:22: joint 'slide'")) << told;
  }
}

TEST_F(UrdfFile, DegreesAreWarnedOf) {
  const auto warnings_with = [&](const std::string& angles) {
    std::string text = small_urdf;
    const std::string radians = "0 1.5707963267948966 0";
    return read(text.replace(text.find(radians), radians.size(), angles)).warnings;
  };
  for (const char* angles : {"0 6.2831854 0", "-6.2831853071795862 0 3"}) EXPECT_EQ(warnings_with(angles).size(), 1U);
  for (const char* angles : {"0 90 45", "0 -90 0", "-360 0 0"}) {
    const auto warnings = warnings_with(angles);
    ASSERT_EQ(warnings.size(), 2U) << angles;
    EXPECT_TRUE(tells(warnings[1], fmt::format("line 15: joint 'turn': rpy=\"{}\"", angles))) << warnings[1];
  }
  EXPECT_TRUE(tells(warnings_with("0 90 45")[1], "if these are degrees, write 1.5708 for 90"));
}

TEST_F(UrdfFile, AttributesThatAreNotReadAreWarnedOf) {
  std::string text = small_urdf;
  text.replace(text.find("rpy=\"0 1.5"), 3, "rpi");
  const std::string mimicking = "<mimic joint=\"turn\" multiplier";
  text.replace(text.find(mimicking), mimicking.size(), "<mimic joint=\"turn\" multipler");
  const RobotFile file = read(text);
  ASSERT_EQ(file.warnings.size(), 3U);
  EXPECT_EQ(file.warnings[1], "line 15: joint 'turn': the attribute rpi of <origin> is not read; did you mean 'rpy'?");
  EXPECT_EQ(file.warnings[2],
            "line 22: joint 'slide': the attribute multipler of <mimic> is not read; did you mean 'multiplier'?");
  // Where urdfdom does not read it, it is told; where it does, the joint turns.
  text = small_urdf;
  const std::string radians = "rpy=\"0 1.5707963267948966 0\"";
  text.replace(text.find(radians), radians.size(), "quat_xyzw=\"0 1 0 0\"");
  const RobotFile by_quaternion = read(text);
  const bool is_read = by_quaternion.description.joints[0].origin.linear[0].x == -1;
  ASSERT_EQ(by_quaternion.warnings.size(), is_read ? 1U : 2U);
  EXPECT_TRUE(is_read ||
              tells(by_quaternion.warnings.back(), "the attribute quat_xyzw of <origin> is not read; write"));
}

TEST_F(UrdfFile, ACollisionThatIsNotUnderstoodIsAnErrorAndNotLeftOut) {
  const std::string link =
      "<link name=\"a\"><collision><origin xyz=\"{}\"/><geometry><box size=\"1 1 1\"/></geometry></collision></link>\n";
  const auto robot = [&](const std::string& place) {
    std::string text = link;
    return "<robot name=\"r\">\n" + text.replace(text.find("{}"), 2, place) + "</robot>\n";
  };
  EXPECT_EQ(read(robot("0 0 0")).description.links[0].shapes.size(), 1U);
  for (const char* place : {"0 0 O", "0 0", "0,0,0", "0 nan 0"})
    EXPECT_TRUE(tells(message_of([&] { static_cast<void>(read(robot(place))); }),
                      "robot.urdf:2: not each <collision> of link 'a' is understood"))
        << place;
}

TEST_F(UrdfFile, PackagesAreLookedForInTheirOrder) {
  folder_.write("elsewhere/parts/hand.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const std::string path = written(small_urdf);
  const auto triangles = [&](const std::vector<std::string>& folders) {
    const RobotFile file = read_urdf(path, {folders});
    return mesh_of(file.description.links[2].shapes[0].shape)->triangle_count();
  };
  EXPECT_EQ(triangles({}), 4U);
  EXPECT_EQ(triangles({(folder_ / "elsewhere").string()}), 1U);
  EXPECT_EQ(triangles({(folder_ / "elsewhere/parts").string()}), 1U);
  EXPECT_EQ(triangles({(folder_ / "nowhere").string(), (folder_ / "parts/").string()}), 4U);
}

TEST_F(UrdfFile, AWrittenRobotIsReadAgain) {
  const RobotDescription arm = generated_arm({.subdivisions = 1});
  write_urdf(arm, (folder_ / "arm").string());
  const Robot before(arm), after(read_urdf((folder_ / "arm/robot.urdf").string()).description);
  const std::vector<double> configuration{0.1, -0.2, 0.3, 0.4, -0.5, 0.6, 0.7};
  EXPECT_EQ(before.link_poses(configuration), after.link_poses(configuration));
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(before.positions()[i].limits, after.positions()[i].limits);
  for (std::size_t i = 0; i < before.bodies().size(); ++i)
    EXPECT_TRUE(
        std::ranges::equal(before.bodies()[i].model.mesh().vertices(), after.bodies()[i].model.mesh().vertices()));
  write_urdf(arm, (folder_ / "arm").string());  // what is there already is the same
  EXPECT_TRUE(tells(message_of([&] { write_urdf(generated_arm({.subdivisions = 0}), (folder_ / "arm").string()); }),
                    "there is another file already"));
  RobotDescription cone = planar_robot();
  cone.links[1].shapes = {{Cone(1, 1)}};
  EXPECT_TRUE(tells(message_of([&] { write_urdf(cone, (folder_ / "cone").string()); }), "URDF has no cone"));
  RobotDescription named = generated_arm({.subdivisions = 0});
  named.links[0].name = named.joints[0].parent = std::string("ba\0se", 5);
  EXPECT_TRUE(tells(message_of([&] { write_urdf(named, (folder_ / "named").string()); }), "XML cannot hold"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "named/robot.urdf"));
}

TEST_F(UrdfFile, SrdfTellsWhichPairsAreDisabled) {
  const Robot robot(read(small_urdf).description);
  const auto pairs_of = [&](const std::string& inside) {
    return read_srdf(folder_.write("robot.srdf", "<robot name=\"small\">\n" + inside + "\n</robot>\n").string(), robot);
  };
  EXPECT_EQ(
      pairs_of("<disable_collisions link1=\"arm\" link2=\"base\" reason=\"Adjacent\"/>\n"
               "<disable_collisions link1=\"base\" link2=\"hand\" reason=\"Never\"/>"),
      (std::vector<AllowedPair>{{"base", "arm", AllowedReason::adjacent}, {"base", "hand", AllowedReason::never}}));
  EXPECT_EQ(pairs_of("<disable_default_collisions link=\"hand\"/><enable_collisions link1=\"lamp\" link2=\"hand\"/>"),
            (std::vector<AllowedPair>{{"base", "hand", AllowedReason::given}, {"arm", "hand", AllowedReason::given}}));
  EXPECT_TRUE(
      tells(message_of([&] { static_cast<void>(pairs_of("<disable_collisions link1=\"arm\" link2=\"bas\"/>")); }),
            "robot.srdf:2: the robot has no link 'bas'; did you mean 'base'?"));
  EXPECT_TRUE(tells(message_of([&] { static_cast<void>(pairs_of("<disable_collisions link1=\"arm\"/>")); }),
                    "robot.srdf:2: <disable_collisions> has no attribute link2"));
}

TEST_F(UrdfFile, OneOfTheOtherKindIsToldByItsElements) {
  const Robot robot(read(small_urdf).description);
  const std::string urdf = written(small_urdf);
  EXPECT_TRUE(tells(message_of([&] { static_cast<void>(read_srdf(urdf, robot)); }),
                    "<link> is of a URDF file, a robot; pairs of links that are not looked at are in an SRDF file"));
  const std::string srdf = "<robot name=\"small\">\n\n<disable_collisions link1=\"arm\" link2=\"base\"/></robot>\n";
  EXPECT_TRUE(tells(message_of([&] { static_cast<void>(read(srdf)); }),
                    "robot.urdf:3: <disable_collisions> is of an SRDF file"));
}

TEST_F(UrdfFile, FaultsOfTheXmlAreToldByTheirLine) {
  const auto fault = [&](const std::string& text) { return message_of([&] { static_cast<void>(read(text)); }); };
  EXPECT_TRUE(tells(fault("hello\n"), "robot.urdf: this is no XML: no element is in it"));
  EXPECT_TRUE(tells(fault("<robot name=\"a\">\n<link name=\"b\"/>\n</robot"),
                    "robot.urdf:3: the XML ends here, and an element is still open"));
  EXPECT_TRUE(tells(fault("<robot name=\"a\">\n<link name=\"b\"><!-- c --><!--\n</link></robot>\n"),
                    "robot.urdf:2: the comment that begins here is not closed by -->"));
  EXPECT_TRUE(tells(fault("<!-- a -->\n<!-- b\n<robot name=\"a\"/>\n"),
                    "robot.urdf:2: the comment that begins here is not closed by -->"));
  EXPECT_TRUE(tells(fault("<robot name=\"a\">\n<link name=\"b\"/>\n</link>\n"), "robot.urdf:3: this is no XML"));
}

TEST_F(UrdfFile, MacrosAreToBeExpandedFirst) {
  const std::string text =
      "<robot name=\"a\" xmlns:xacro=\"http://ros.org/wiki/xacro\">\n<link "
      "name=\"b\">\n<xacro:shape/></link></robot>\n";
  const std::string fault = message_of([&] { static_cast<void>(read(text)); });
  EXPECT_TRUE(
      tells(fault, "robot.urdf:3: <xacro:shape>: xacro macros are not expanded here; expand them first (`xacro "));
  const std::string named = folder_.write("arm.urdf.xacro", small_urdf).string();
  EXPECT_EQ(message_of([&] { static_cast<void>(read_urdf(named)); }),
            named + ": xacro macros are not expanded here; expand them first (`xacro " + named + " > " +
                (folder_ / "arm.urdf").string() + "`) and give that file");
  // Those that were expanded keep the name space.
  std::string expanded = small_urdf;
  expanded.replace(expanded.find("<robot"), 6, "<robot xmlns:xacro=\"http://ros.org/wiki/xacro\"");
  EXPECT_EQ(read(expanded).description.links.size(), 4U);
}

TEST_F(UrdfFile, NumbersOfGltfAreWarnedOf) {
  folder_.write("parts/hand.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "buffers": [{"byteLength": 36, "uri":
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}]})");
  std::string text = small_urdf;
  text.replace(text.find("hand.off"), 8, "hand.gltf");
  const RobotFile file = read(text);
  EXPECT_TRUE(tells(file.warnings.at(0),
                    "hand.gltf' is glTF, whose y axis points up by its standard: its numbers are "
                    "taken as they are"));
  EXPECT_EQ(mesh_of(file.description.links[2].shapes[0].shape)->vertices()[2], (Vec3{0, 1, 0}));
}

TEST_F(UrdfFile, OneOfWiderCharactersIsToldAsSuch) {
  std::string wide, wider;
  for (const char c : std::string("<robot name=\"a\"/>")) {
    wide += {c, '\0'};
    wider += {c, '\0', '\0', '\0'};
  }
  const std::string zero(1, '\0');
  const std::vector<std::pair<std::string, std::string>> texts{{wide, "UTF-16LE"},
                                                               {zero + wide, "UTF-16BE"},
                                                               {"\xff\xfe" + wide, "UTF-16"},
                                                               {"\xfe\xff" + zero + wide, "UTF-16"},
                                                               {wider, "UTF-32LE"},
                                                               {"\xff\xfe" + zero + zero + wider, "UTF-32"}};
  for (const auto& one : texts)
    EXPECT_TRUE(tells(
        message_of([&] { static_cast<void>(read(one.first)); }),
        fmt::format("robot.urdf: it is written in {0}, and UTF-8 is read; convert it (iconv -f {0} ", one.second)));
}

TEST(ConfigurationsFile, IsNumbersInTheOrderThatItNames) {
  const TemporaryFolder folder;
  const Robot robot(planar_robot());
  const auto read = [&](const std::string& text) {
    return read_configurations(folder.write("q.csv", text).string(), robot);
  };
  EXPECT_EQ(read("0.5, 1, 0.25\n# nothing\n\n-7 -2 1 # the last\n"), (std::vector<double>{0.5, 1, 0.25, -7, -2, 1}));
  EXPECT_EQ(read("slide,shoulder,elbow\r\n0.25,0.5,1\r\n"), (std::vector<double>{0.5, 1, 0.25}));
  const auto fault = [&](const std::string& text) {
    const std::string message = message_of([&] { static_cast<void>(read(text)); });
    return message.substr(std::min(message.find("q.csv"), message.size()));
  };
  EXPECT_EQ(fault("0,0,0\n1,2\n"), "q.csv:2: a line of 3 numbers has 2; give one for each position of the robot");
  EXPECT_TRUE(tells(fault("0,,0,0\n"), "q.csv:1: a line of 3 numbers has 4"));
  EXPECT_TRUE(tells(fault("0,,0\n"), "q.csv:1: \"\" is no number"));
  EXPECT_EQ(read("\xEF\xBB\xBF"
                 "0.5,1,0.25\n"),
            (std::vector<double>{0.5, 1, 0.25}));
  EXPECT_TRUE(tells(fault("0,0,0\n0,nan,0\n"), "q.csv:2: \"nan\" is no number"));
  EXPECT_TRUE(tells(fault("0,0,0\n0,1e999,0\n"), "q.csv:2: \"1e999\" is no number"));
  EXPECT_TRUE(tells(fault("0,3.5,0\n"), "q.csv:1: the position of 'elbow' is 3.5, beyond its limits -3 to 3"));
  EXPECT_TRUE(
      tells(fault("shoulder,elbw,slide\n"), "q.csv:1: the robot has no position \"elbw\"; did you mean 'elbow'?"));
  EXPECT_TRUE(tells(fault("shoulder,elbow,elbow\n"), "is named twice"));
  EXPECT_TRUE(tells(fault("shoulder,elbow\n"), "the position 'slide' is not named"));
  EXPECT_TRUE(tells(fault("# nothing\n"), "the file holds no configuration"));
}

}  // namespace
}  // namespace toccata::test
