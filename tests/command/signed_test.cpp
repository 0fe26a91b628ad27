// `toccata nearest --signed`: on which side of a surface a point is.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/command.hpp"

namespace toccata {
namespace {

using Json = nlohmann::json;
using test::run_command;
using test::TemporaryFolder;

TEST(SignedCommand, TellsTheSideAndWhatToldIt) {
  const TemporaryFolder folder;
  const std::string points = folder.write("points.txt", "3 0 0.5\n0.25 0.1 0\n0.5 0 0\n").string();
  const auto closed = run_command({"nearest", "gen:box", "--points", points, "--signed", "--json"});
  EXPECT_EQ(closed.exit_code, 0) << closed.err;
  const Json report = Json::parse(closed.out)["points"];
  EXPECT_EQ(report[0]["nearest"][0]["side"], "outside");
  EXPECT_EQ(report[1]["nearest"][0]["side"], "inside");
  EXPECT_EQ(report[1]["nearest"][0]["side_by"], "winding number");
  EXPECT_NEAR(report[1]["nearest"][0]["signed_upper"], -0.25, 1e-12);
  EXPECT_EQ(report[2]["nearest"][0]["side"], "boundary");
  const std::string open = folder.write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").string();
  const auto table = run_command({"nearest", open, "--point", "0.1", "0.1", "3", "--signed"});
  EXPECT_NE(table.out.find("outside, by the generalised winding number"), std::string::npos) << table.out;
  const auto csv = run_command({"nearest", open, "--points", points, "--within", "1", "--signed", "--csv"});
  EXPECT_NE(csv.out.find("status,side,side_by,signed_lower,signed_upper,inside_of\n"), std::string::npos) << csv.out;
  EXPECT_NE(csv.out.find("\n0,0,,,,,,,,,,,,,,\n"), std::string::npos) << csv.out;
}

}  // namespace
}  // namespace toccata
