// `toccata nearest`: what it tells of each triangle, the lengths it takes, and what it refuses.
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

Json nearest_of(std::vector<std::string> words) {
  words.insert(words.begin(), "nearest");
  words.push_back("--json");
  const auto result = run_command(words);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return Json::parse(result.out)["points"][0]["nearest"];
}

void expect_refused(const std::vector<std::string>& words, const std::string& message) {
  const auto result = run_command(words);
  EXPECT_EQ(result.exit_code, 2) << result.out;
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
}

TEST(NearestCommand, EveryRankHasItsOwnSignedDistance) {
  const Json inside = nearest_of({"gen:box", "--point", "0.3", "0.1", "0.05", "--k", "12", "--signed"});
  ASSERT_EQ(inside.size(), 12U);
  for (const Json& one : inside) {
    EXPECT_EQ(one["side"], "inside");
    EXPECT_EQ(one["signed_lower"].get<double>(), -one["upper"].get<double>());
    EXPECT_EQ(one["signed_upper"].get<double>(), -one["lower"].get<double>());
  }
  EXPECT_NEAR(inside[0]["signed_upper"], -0.2, 1e-12);
  EXPECT_LT(inside[11]["signed_upper"].get<double>(), -0.79);
  for (const Json& one : nearest_of({"gen:box", "--point", "0.7", "0.1", "0.05", "--k", "12", "--signed"})) {
    EXPECT_EQ(one["side"], "outside");
    EXPECT_EQ(one["signed_lower"], one["lower"]);
    EXPECT_EQ(one["signed_upper"], one["upper"]);
  }
  for (const Json& one : nearest_of({"gen:box", "--point", "0.5", "0", "0", "--k", "12", "--signed"})) {
    EXPECT_EQ(one["side"], "boundary");
    EXPECT_EQ(one["signed_upper"], one["upper"]);
  }
}

TEST(NearestCommand, AnUndecidedSideLeavesBothSignsAtEveryRank) {
  const TemporaryFolder folder;
  // Half of an octahedron: seen from its centre it is exactly half of everything.
  const std::string half = folder
                               .write("half.off",
                                      "OFF\n5 4 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n0 0 1\n"
                                      "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n")
                               .string();
  for (const Json& one : nearest_of({half, "--point", "0", "0", "0", "--k", "4", "--signed"})) {
    EXPECT_EQ(one["side"], "undecided");
    EXPECT_EQ(one["signed_lower"].get<double>(), -one["upper"].get<double>());
    EXPECT_EQ(one["signed_upper"], one["upper"]);
  }
}

TEST(NearestCommand, SidesOfManyPointsAndObjectsDoNotDependOnThreads) {
  const TemporaryFolder folder;
  const std::string points = folder.write("points.txt", "0.1 0.2 0.3\n0.6 0 0\n5 0 0\n0.9 0 0\n").string();
  const std::vector<std::string> words{"nearest", "gen:box", "gen:icosphere", "--points", points,
                                       "--k",     "40",      "--signed",      "--json",   "--threads"};
  auto one = words, many = words;
  one.push_back("1");
  many.push_back("3");
  const auto first = run_command(one);
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.out, run_command(many).out);
  const Json report = Json::parse(first.out)["points"];
  for (const Json& found : report[1]["nearest"])
    EXPECT_EQ(found["side"], found["object"] == "box" ? "outside" : "inside") << found;
}

TEST(NearestCommand, TheColumnsDoNotDependOnWhatIsFound) {
  const auto none = run_command({"nearest", "gen:box", "--point", "9", "9", "9", "--within", "1", "--signed", "--csv"});
  EXPECT_EQ(
      none.out,
      "point,rank,object,face,triangle,lower,upper,x,y,z,status,side,side_by,signed_lower,signed_upper,inside_of\n"
      "0,0,,,,,,,,,,,,,,\n")
      << none.err;
  const auto plain = run_command({"nearest", "gen:box", "--point", "9", "9", "9", "--within", "1", "--csv"});
  EXPECT_EQ(plain.out, "point,rank,object,face,triangle,lower,upper,x,y,z,status\n0,0,,,,,,,,,\n") << plain.err;
}

/// In a scene of all kinds of shapes: whose surface is nearest, and inside of which object the point is.
TEST(NearestCommand, OfASceneOfShapesItTellsTheNearestSurfaceAndWhatHoldsThePoint) {
  const TemporaryFolder folder;
  const std::string scene = folder
                                .write("scene.json",
                                       R"({"format": "toccata-scene", "version": 1, "objects": [
      {"name": "hall", "shape": {"type": "sphere", "radius": 50}},
      {"name": "chest", "shape": {"type": "box", "half_extents": [1, 1, 1]}},
      {"name": "pair", "shape": {"type": "compound", "parts": [
         {"shape": {"type": "sphere", "radius": 1}},
         {"shape": {"type": "box", "half_extents": [1, 1, 1]}, "pose": [1,0,0, 0,1,0, 0,0,1, 9,0,0]}]},
       "pose": [1,0,0, 0,1,0, 0,0,1, 0,9,0]},
      {"name": "ground", "shape": {"type": "half-space", "normal": [0, 0, 1], "point": [0, 0, -20]}}]})")
                                .string();
  const std::string points = folder.write("points.txt", "3 0 0\n0.5 0 0\n9 9.5 0.1\n0 0 -60\n0 0 99\n").string();
  const auto result = run_command({"nearest", scene, "--points", points, "--signed", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json report = Json::parse(result.out)["points"];
  const std::vector<std::string> nearest{"chest", "chest", "pair", "hall", "hall"};
  for (std::size_t i = 0; i < nearest.size(); ++i) EXPECT_EQ(report[i]["nearest"][0]["object"], nearest[i]) << i;
  EXPECT_EQ(report[0]["side"], "inside");
  EXPECT_EQ(report[0]["inside_of"], "hall");
  EXPECT_EQ(report[0]["nearest"][0]["side"], "outside");
  EXPECT_NEAR(report[0]["signed_upper"], -2, 1e-11);
  EXPECT_EQ(report[1]["nearest"][0]["side"], "inside");
  EXPECT_EQ(report[2]["nearest"][0]["triangle"], 1);
  EXPECT_NEAR(report[2]["nearest"][0]["signed_upper"], -0.5, 1e-12);
  EXPECT_EQ(report[3]["inside_of"], "ground");
  EXPECT_EQ(report[4]["side"], "outside");
  EXPECT_TRUE(report[4]["inside_of"].is_null());
  const auto table = run_command({"nearest", scene, "--points", points, "--signed"});
  EXPECT_NE(table.out.find("point 0  is inside hall\n"), std::string::npos) << table.out;
  const auto csv = run_command({"nearest", scene, "--points", points, "--signed", "--within", "1", "--csv"});
  EXPECT_NE(csv.out.find("\n0,0,,,,,,,,,,,,,,hall\n"), std::string::npos) << csv.out;
  EXPECT_NE(csv.out.find("\n4,0,,,,,,,,,,,,,,\n"), std::string::npos) << csv.out;
}

TEST(NearestCommand, TrianglesAreToldByTheirNumbers) {
  const TemporaryFolder folder;
  const std::string quad = folder.write("quad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n").string();
  const Json found = nearest_of({quad, "--point", "0.9", "0.2", "1", "--k", "2"});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0]["face"], 0);
  EXPECT_EQ(found[1]["face"], 0);
  EXPECT_NE(found[0]["triangle"], found[1]["triangle"]);
  const auto csv = run_command({"nearest", quad, "--point", "0.9", "0.2", "1", "--k", "2", "--csv"});
  EXPECT_NE(csv.out.find("\n0,1,quad,0," + found[0]["triangle"].dump() + ","), std::string::npos) << csv.out;
  EXPECT_NE(csv.out.find("\n0,2,quad,0," + found[1]["triangle"].dump() + ","), std::string::npos) << csv.out;
  const auto help = run_command({"nearest", "--help"});
  EXPECT_NE(help.out.find("so many nearest triangles"), std::string::npos) << help.out;
}

TEST(NearestCommand, TheGreatestDistanceIsALength) {
  const TemporaryFolder folder;
  const std::string file = folder.write("flat.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").string();
  const std::vector<std::string> point{file, "--unit", "m", "--point", "0.1", "0.1", "0.003", "--within"};
  const auto within = [&](const std::string& length) {
    auto words = point;
    words.push_back(length);
    return nearest_of(words).size();
  };
  EXPECT_EQ(within("4mm"), 1U);
  EXPECT_EQ(within("2mm"), 0U);
  EXPECT_EQ(within("0.004"), 1U);
  const auto refused = [&](const std::string& length, const std::string& message) {
    expect_refused({"nearest", file, "--point", "0", "0", "1", "--within", length}, message);
  };
  refused("", "a length must be given");
  refused("near", "a length is 0 or more, in units of the scene (0.5) or with its own (2mm, 0.1in)");
  refused("nan", "a length is 0 or more");
  refused("2mm", "add --unit");
}

TEST(NearestCommand, WithoutAFileItSaysWhatItTakes) {
  expect_refused({"nearest", "--point", "0", "0", "1"}, "no file was named: name mesh files (");
  expect_refused({"inspect", "--hierarchy"}, "no file was named: name mesh or scene files");
  expect_refused({"cost"}, "no file was named: name two files of one mesh each");
}

TEST(NearestCommand, ADistanceBeyondTheDoublesIsRefused) {
  expect_refused({"nearest", "gen:box", "--point", "1.7e308", "1.7e308", "1.7e308", "--json"},
                 "'box': point 0: it is farther away than a double can tell");
  EXPECT_EQ(nearest_of({"gen:box", "--point", "1e308", "0", "0"}).size(), 1U);
}

}  // namespace
}  // namespace toccata
