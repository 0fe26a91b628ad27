#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/text_file.hpp"
#include "support/command.hpp"
#include "toccata/io/query_files.hpp"

namespace toccata {
namespace {

using test::message_of;

std::string error_of_pose(const std::string& text) {
  return message_of([&] { (void)pose_from_text(text); });
}

Pose turned(const Vec3& axis, double degrees) { return {rotation_about(axis, degrees), {}}; }

TEST(PoseText, TwelveNumbersAreAPoseAndThreeATranslation) {
  EXPECT_EQ(pose_from_text("1 2 3, 4 5 6, 7 8 9, 10 11 12"),
            Pose::from_numbers({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(pose_from_text(" 1,-2,3e1 "), Pose::translation(1, -2, 30));
}

TEST(PoseText, SixteenNumbersAreAMatrixAndSevenATranslationWithAQuaternion) {
  EXPECT_EQ(pose_from_text("1 2 3 10 4 5 6 11 7 8 9 12 0 0 0 1"),
            Pose::from_numbers({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(pose_from_text("1 2 3 0 0 3 3"), (Pose{rotation_of({.z = 3, .w = 3}), {1, 2, 3}}));
}

TEST(PoseText, WordsTurnFirstAndThenTranslate) {
  EXPECT_EQ(pose_from_text("translation=1,2,3 axis=0,0,2 degrees=90"),
            (Pose{rotation_about({0, 0, 1}, 90), {1, 2, 3}}));
  EXPECT_EQ(pose_from_text("degrees 90 axis 0 0 2"), turned({0, 0, 1}, 90));
  EXPECT_EQ(pose_from_text("quaternion=0,0,3,3").linear, rotation_of({.z = 3, .w = 3}));
  EXPECT_EQ(pose_from_text("translation=4,5,6"), Pose::translation(4, 5, 6));
}

TEST(PoseText, SmallLettersTurnAboutFixedAxesAndCapitalsAboutTurnedOnes) {
  const Mat3 x = rotation_about({1, 0, 0}, 90), y = rotation_about({0, 1, 0}, 90), z = rotation_about({0, 0, 1}, 90);
  EXPECT_EQ(pose_from_text("euler=xyz:90,90,90").linear, z * (y * x));
  EXPECT_EQ(pose_from_text("euler=XYZ:90,90,90").linear, x * y * z);
  EXPECT_EQ(pose_from_text("euler=zxz:90,90,0").linear, x * z);
  // A point on x goes to y about z, and from there to z about x.
  EXPECT_EQ((pose_from_text("euler=zxz:90,90,0") * Vec3{1, 0, 0}), (Vec3{0, 0, 1}));
}

TEST(PoseText, ErrorsTellTheTextAndWhatToWrite) {
  EXPECT_EQ(
      error_of_pose("1 2"),
      "the pose \"1 2\": a pose of 2 numbers; write 12 numbers, R row by row and then t; 16, a 4 × 4 matrix row by "
      "row; 7, a translation and a quaternion x y z w; 3, a translation; or words such as translation=1,0,0 "
      "axis=0,0,1 degrees=90");
  EXPECT_NE(error_of_pose("1 0 0 0 0 1 0 0 0 0 1 0 5 0 0 1").find("column by column"), std::string::npos);
  EXPECT_NE(error_of_pose("1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 2").find("not 0 0 0 1; write"), std::string::npos);
  EXPECT_NE(error_of_pose("1 2 3 0 0 0 0").find("the quaternion is zero"), std::string::npos);
  EXPECT_NE(error_of_pose("").find("there is no pose"), std::string::npos);
  EXPECT_NE(error_of_pose("1 2 three").find("\"three\" is no number"), std::string::npos);
  EXPECT_NE(error_of_pose("turn=1").find("\"turn\" is not known"), std::string::npos);
  EXPECT_NE(error_of_pose("axis=0,0,1").find("the axis has no degrees"), std::string::npos);
  EXPECT_NE(error_of_pose("degrees=1").find("the degrees have no axis"), std::string::npos);
  EXPECT_NE(error_of_pose("axis=0,0,0 degrees=1").find("no direction"), std::string::npos);
  EXPECT_NE(error_of_pose("translation=1,2").find("write 3"), std::string::npos);
  EXPECT_NE(error_of_pose("axis=z degrees=90").find("\"z\" after \"axis\" is no number; write 3"), std::string::npos);
  EXPECT_NE(error_of_pose("translation=1,2,3 translation=1,2,3").find("there are two"), std::string::npos);
  EXPECT_NE(error_of_pose("quaternion=0,0,0,0").find("zero"), std::string::npos);
  EXPECT_NE(error_of_pose("quaternion=0,0,0,1 euler=xyz:1,2,3").find("two rotations"), std::string::npos);
  EXPECT_NE(error_of_pose("euler=xxz:1,2,3").find("no order"), std::string::npos);
  EXPECT_NE(error_of_pose("euler=xyZ:1,2,3").find("no order"), std::string::npos);
  EXPECT_NE(error_of_pose("euler").find("no order"), std::string::npos);
  EXPECT_NE(error_of_pose("nan 0 0").find("\"nan\" is not known"), std::string::npos);
  EXPECT_NE(error_of_pose("1 0 1e999").find("\"1e999\" is no number"), std::string::npos);
}

class MotionFile : public testing::Test {
 protected:
  std::vector<MotionKey> keys(const std::string& text) {
    return read_motion(folder.write("m.txt", text).string()).keys;
  }
  std::string error_of_motion(const std::string& text) {
    return message_of([&] { (void)keys(text); });
  }
  test::TemporaryFolder folder;
};

TEST_F(MotionFile, HasAKeyALineAndTimesFromZeroToOne) {
  const auto read = keys("# a motion\n2  0 0 0\n\n3  translation=1,0,0  # there\n6 axis=0,0,1 degrees=90\n");
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read[0].time, 0);
  EXPECT_EQ(read[1].time, 0.25);
  EXPECT_EQ(read[2].time, 1);
  EXPECT_EQ(read[1].pose, Pose::translation(1, 0, 0));
  EXPECT_EQ(read[2].pose, turned({0, 0, 1}, 90));
}

// From one key to the next the shorter way is taken, which is not what such a turn says.
TEST_F(MotionFile, ATurnOfMoreThanHalfACircleBetweenTwoKeysIsRefused) {
  for (const char* text :
       {"0 0 0 0\n1 axis=0,0,1 degrees=270\n", "0 axis=0,0,1 degrees=-100\n1 axis=0,0,1 degrees=100\n",
        "0 axis=0,0,1 degrees=100\n1 axis=0,0,-2 degrees=100\n", "0 axis=0,0,1 degrees=360\n1 translation=1,2,3\n",
        "0 axis=1,0,0 degrees=0\n1 axis=0,0,1 degrees=270\n",
        "0 axis=0.1,0.2,0.3 degrees=10\n1 axis=1,2,3 degrees=270\n"})
    EXPECT_NE(error_of_motion(text).find("m.txt:2: from the key before it turns by"), std::string::npos) << text;
  EXPECT_NE(error_of_motion("0 0 0 0\n1 axis=0,0,1 degrees=270\n").find("by 270 degrees"), std::string::npos);
  for (const char* text : {"0 axis=0,0,1 degrees=230.92\n1 axis=0,0,1 degrees=410.92\n",
                           "0 0 0 0\n1 axis=0,0,1 degrees=180\n2 axis=0,0,1 degrees=360\n",
                           "0 axis=0,0,1 degrees=700\n1 axis=0,0,2 degrees=800\n",
                           "0 axis=0,0,1 degrees=300\n1 axis=0,1,0 degrees=10\n", "0 0 0 0\n1 euler=xyz:0,0,270\n"})
    EXPECT_EQ(error_of_motion(text), "") << text;
}

TEST_F(MotionFile, ErrorsNameTheFileAndTheLine) {
  EXPECT_NE(error_of_motion("0 0 0 0\n").find("m.txt: a motion has at least two keys"), std::string::npos);
  EXPECT_NE(error_of_motion("0 0 0 0\n0 1 0 0\n").find("m.txt:2: the time is not later"), std::string::npos);
  EXPECT_NE(error_of_motion("0 0 0 0\n1 1 0\n").find("m.txt:2: a pose of 2 numbers"), std::string::npos);
  EXPECT_NE(error_of_motion("0 0 0 0\n1\n").find("m.txt:2: there is no pose"), std::string::npos);
  EXPECT_NE(error_of_motion("x 0 0 0\n").find("m.txt:1: "), std::string::npos);
  EXPECT_NE(error_of_motion("-1e308 0 0 0\n1e308 0 0 0\n").find("farther apart"), std::string::npos);
}

}  // namespace
}  // namespace toccata
