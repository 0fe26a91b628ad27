// `toccata faces`: which faces lie in a box or a ball.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/command.hpp"

namespace toccata {
namespace {

using Json = nlohmann::json;
using test::run_command;
using test::TemporaryFolder;

TEST(FacesCommand, TellsTheFacesOfTheFileOnce) {
  const TemporaryFolder folder;
  const std::string file = folder
                               .write("quads.off",
                                      "OFF\n6 2 0\n0 0 0\n2 0 0\n2 2 1\n0 2 1\n0 4 0\n2 4 0\n"
                                      "4 0 1 2 3\n4 3 2 5 4\n")
                               .string();
  const auto one = run_command({"faces", file, "--ball", "1", "1", "1.5", "1", "--csv"});
  EXPECT_EQ(one.exit_code, 1) << one.err;
  EXPECT_EQ(one.out, "object,face,triangles\nquads,0,2\n");
  const auto all = run_command({"faces", file, "--box", "-9,-9,-9,9,9,9", "--json"});
  EXPECT_EQ(all.exit_code, 1) << all.err;
  const Json faces = Json::parse(all.out)["faces"];
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_EQ(faces[1]["face"], 1);
  EXPECT_EQ(faces[1]["triangles"], (std::vector<int>{2, 3}));
  EXPECT_EQ(run_command({"faces", file, "--ball", "50", "50", "50", "1"}).exit_code, 0);
}

TEST(FacesCommand, DoesNotCallQuadricShapesExact) {
  const TemporaryFolder folder;
  const std::string can =
      folder
          .write("can.json", R"({"format": "toccata-scene", "version": 1, "objects": [{"name": "can", "shape":
            {"type": "compound", "parts": [{"shape": {"type": "cylinder", "radius": 1, "half_height": 1}}]}}]})")
          .string();
  const auto touching = run_command({"faces", can, "--ball", "2", "0", "0", "1"});
  EXPECT_EQ(touching.exit_code, 1) << touching.err;
  EXPECT_NE(touching.out.find("exactly but of cylinders"), std::string::npos) << touching.out;
  const auto box = run_command({"faces", "gen:box", "--ball", "1", "0", "0", "1"});
  EXPECT_NE(box.out.find("decided exactly.\n"), std::string::npos) << box.out;
}

TEST(FacesCommand, WrongRegionsAreTroubleThatSaysWhatToDo) {
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& message) {
    const auto result = run_command(arguments);
    EXPECT_EQ(result.exit_code, 2) << result.out;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  };
  refused({"faces", "gen:box"}, "no region is given");
  refused({"faces", "gen:box", "--box", "1", "0", "0", "0", "1", "1"},
          "--box: the box is empty, its x goes from 1 to 0");
  refused({"faces", "gen:box", "--ball", "0", "0", "0", "-1"},
          "error: --ball: the radius is -1; give a radius of 0 or more");
  refused({"faces", "gen:box", "--ball", "0", "0", "0", "x"}, "--ball: 'x' is not a finite number");
  refused({"faces", "gen:box", "--ball", "0", "0", "0"}, "--ball");
  refused({"faces", "--ball", "0", "0", "0", "1"}, "no file was named: name mesh files (");
}

}  // namespace
}  // namespace toccata
