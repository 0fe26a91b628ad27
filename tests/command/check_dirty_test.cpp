// Meshes that are not as they should be: what is said of them, --close, and --solid by-winding.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

class CheckDirty : public testing::Test {
 protected:
  void SetUp() override {
    // A box whose lid is its own, a hair above the rest; and without a lid.
    const std::string sides =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
        "f 1 3 4 2\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    folder.write("open.obj", sides);
    folder.write("crack.obj", sides + "v 0 0 1.00001\nv 1 0 1.00001\nv 0 1 1.00001\nv 1 1 1.00001\nf 9 10 12 11\n");
    folder.write("screw.obj",
                 "v 0.4 0.4 0.4\nv 0.6 0.4 0.4\nv 0.4 0.6 0.4\nv 0.4 0.4 0.6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  }

  test::CommandResult run(const Words& words) { return run_command(words, folder.path()); }

  Json report(Words words) {
    words.emplace_back("--json");
    return Json::parse(run(words).out);
  }

  TemporaryFolder folder;
};

TEST_F(CheckDirty, InspectTellsHowFarFromClosedInTheWordsOfTheField) {
  const std::string crack = run({"inspect", "crack.obj"}).out;
  EXPECT_NE(crack.find("8 boundary"), std::string::npos) << crack;
  EXPECT_NE(crack.find("2 holes or rims; gaps of"), std::string::npos) << crack;
  const std::string open = run({"inspect", "open.obj"}).out;
  EXPECT_NE(open.find("1 hole or rim, and none of the gaps"), std::string::npos) << open;
  const Json json = report({"inspect", "crack.obj"})["objects"][0];
  EXPECT_EQ(json["boundaries"], 2);
  EXPECT_EQ(json["self_intersections"], 0);
  EXPECT_GT(json["closing_gap"], 1e-5);
  EXPECT_LT(json["closing_gap"], 2.1e-5);
  EXPECT_TRUE(report({"inspect", "open.obj"})["objects"][0]["closing_gap"].is_null());
}

/// A lid that looks inward leaves no hole.
TEST_F(CheckDirty, OfTrianglesThatAreWoundAgainstEachOtherItIsToldThatNoneIsMissing) {
  folder.write("turned.obj", test::text_of(folder.path() / "open.obj") + "f 5 7 8 6\n");
  const std::string what = "no face is missing, but 4 edges lie between triangles that are wound against each other";
  const std::string inspected = run({"inspect", "turned.obj"}).out;
  EXPECT_NE(inspected.find("open"), std::string::npos);
  EXPECT_NE(inspected.find(what), std::string::npos) << inspected;
  EXPECT_EQ(inspected.find("hole or rim"), std::string::npos) << inspected;
  EXPECT_NE(run({"check", "turned.obj", "screw.obj"}).err.find("turned: " + what), std::string::npos);
  EXPECT_NE(run({"check", "turned.obj", "screw.obj", "--close", "0.01"})
                .err.find("turned is still open after --close, which turns no triangle: " + what),
            std::string::npos);
}

TEST_F(CheckDirty, CheckTellsWhichGapClosesAMesh) {
  const auto result = run({"check", "crack.obj", "screw.obj"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("crack has 8 boundary edges and is closed by --close"), std::string::npos) << result.err;
}

/// The gap that is told, as the option takes it.
std::string told_gap(const std::string& err) {
  const std::string before = " is closed by --close ";
  const std::size_t at = err.find(before);
  return at == std::string::npos ? "" : err.substr(at + before.size(), err.find('\n', at) - at - before.size());
}

TEST_F(CheckDirty, TheGapThatIsToldClosesTheMeshInWhateverUnit) {
  for (const Words& how : std::vector<Words>{{}, {"--unit", "mm"}, {"--unit", "in"}, {"--scale", "700"}}) {
    Words words{"check", "crack.obj", "screw.obj"};
    words.insert(words.end(), how.begin(), how.end());
    const std::string gap = told_gap(run(words).err);
    ASSERT_FALSE(gap.empty());
    words.insert(words.end(), {"--close", gap});
    const std::string err = run(words).err;
    EXPECT_NE(err.find("crack was closed by --close"), std::string::npos) << gap << "\n" << err;
  }
}

TEST_F(CheckDirty, EachOfTheFirstOpenMeshesIsToldWithWhatKeepsItFromBeingClosed) {
  // One side of the tetrahedron twice, and a fin at an edge of it.
  folder.write("fin.obj", test::text_of(folder.path() / "screw.obj") + "v 0.6 0.6 0.6\nf 1 3 2\nf 1 2 5\n");
  // A square of two triangles, one of which looks down.
  folder.write("twisted.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n");
  const Json fin = report({"inspect", "fin.obj"})["objects"][0],
             twisted = report({"inspect", "twisted.obj"})["objects"][0];
  ASSERT_GT(fin["non_manifold_edges"], 1);
  ASSERT_EQ(fin["duplicate_triangles"], 1);
  ASSERT_EQ(twisted["flipped_edges"], 1);
  const auto counted = [](const Json& object, const char* field) { return std::to_string(object[field].get<int>()); };
  const std::string err = run({"check", "open.obj", "fin.obj", "twisted.obj", "screw.obj"}).err;
  EXPECT_NE(err.find("3 of 4 objects are open and taken as surfaces, which contain nothing: open, fin, twisted ("),
            std::string::npos)
      << err;
  for (const std::string& line :
       {std::string("open has 4 boundary edges\n"),
        "fin has " + counted(fin, "boundary_edges") + " boundary edges, " + counted(fin, "non_manifold_edges") +
            " non-manifold edges, 1 duplicate face",
        "twisted has " + counted(twisted, "boundary_edges") + " boundary edges, 1 edge of inconsistent winding"})
    EXPECT_NE(err.find("warning: " + line), std::string::npos) << line << "\n" << err;
  EXPECT_EQ(err.find("screw has"), std::string::npos) << err;
}

TEST_F(CheckDirty, OfManyOpenMeshesTheFirstFewAreTold) {
  const Words words{"check", "open.obj", "open.obj", "open.obj", "open.obj", "open.obj", "open.obj", "open.obj"};
  const std::string err = run(words).err;
  std::size_t told = 0;
  for (std::size_t at = err.find(" boundary edges"); at != std::string::npos; at = err.find(" boundary edges", at + 1))
    ++told;
  EXPECT_EQ(told, 5U) << err;
  EXPECT_NE(err.find(", and 2 more (inspect tells more"), std::string::npos) << err;
}

TEST_F(CheckDirty, CloseMakesASolidAndSaysWhatItDid) {
  const std::string before = test::text_of(folder.path() / "crack.obj");
  const auto result = run({"check", "crack.obj", "screw.obj", "--close", "0.001"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("crack  contains  screw  (both solids)"), std::string::npos) << result.out;
  EXPECT_NE(result.err.find("crack was closed by --close: 4 vertices of its boundary moved, 0 triangles collapsed, 0 "
                            "holes filled by 0 triangles; its file stays as it is"),
            std::string::npos)
      << result.err;
  EXPECT_EQ(test::text_of(folder.path() / "crack.obj"), before);
  const Json json = report({"check", "crack.obj", "screw.obj", "--close", "0.001"});
  EXPECT_EQ(json["asked"]["close"], "0.001");
  EXPECT_EQ(json["objects"][0]["closed"], true);
}

TEST_F(CheckDirty, CloseIsALengthInTheUnitOfTheFiles) {
  EXPECT_EQ(run({"check", "crack.obj", "screw.obj", "--unit", "mm", "--close", "0.001"}).exit_code, 1);
  EXPECT_EQ(run({"check", "crack.obj", "screw.obj", "--unit", "m", "--close", "1mm"}).exit_code, 1);
  EXPECT_EQ(run({"check", "crack.obj", "screw.obj", "--unit", "m", "--close", "0.001mm"}).exit_code, 0);
  EXPECT_EQ(run({"check", "crack.obj", "screw.obj", "--scale", "1000", "--close", "0.001"}).exit_code, 0);
  EXPECT_EQ(run({"check", "crack.obj", "screw.obj", "--close", "0"}).exit_code, 2);
  EXPECT_NE(run({"check", "open.obj", "screw.obj", "--close", "0.001"}).err.find("open is still open after --close"),
            std::string::npos);
}

TEST_F(CheckDirty, HowWideAGapIsClosedIsToldOnceInTheUnitOfTheScene) {
  const auto told = [&](Words words, const std::string& what) {
    words.insert(words.begin(), "check");
    const std::string err = run(words).err;
    EXPECT_NE(err.find("--close: gaps of at most " + what + "\n"), std::string::npos) << what << "\n" << err;
    EXPECT_EQ(err.find("--close: gaps"), err.rfind("--close: gaps")) << err;
  };
  told({"crack.obj", "screw.obj", "--close", "0.001"}, "0.001 are closed, in 1 open mesh");
  told({"crack.obj", "open.obj", "--unit", "mm", "--close", "0.001"}, "0.001 mm are closed, in 2 open meshes");
  told({"crack.obj", "screw.obj", "--unit", "m", "--close", "2in"}, "50.8 mm are closed, in 1 open mesh");
  told({"screw.obj", "screw.obj", "--unit", "cm", "--close", "500"}, "5 m are closed, and no mesh is open");
}

TEST_F(CheckDirty, ATessellationOfFilesWithoutCurvedFacesIsToldToChangeNothing) {
  const std::string err = run({"check", "crack.obj", "screw.obj", "--tessellation", "1mm"}).err;
  EXPECT_NE(err.find("--tessellation 1mm changes nothing: it is about the curved faces of STEP and IFC files"),
            std::string::npos)
      << err;
  EXPECT_EQ(run({"check", "crack.obj", "screw.obj"}).err.find("tessellation"), std::string::npos);
}

TEST_F(CheckDirty, AReportOfClosedMeshesIsAskedAgain) {
  folder.write("report.json", run({"check", "crack.obj", "screw.obj", "--close", "0.001", "--json"}).out);
  EXPECT_EQ(run({"view", "report.json", "-o", "page.html"}).exit_code, 0);
}

TEST_F(CheckDirty, ByWindingWhatIsInsideAnOpenMeshOverlapsItUndecided) {
  EXPECT_EQ(run({"check", "open.obj", "screw.obj"}).exit_code, 0);
  const auto result = run({"check", "open.obj", "screw.obj", "--solid", "by-winding"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(
      result.out.find("open  contains  screw  (the mesh around it is open: by its generalised winding number, 0."),
      std::string::npos)
      << result.out;
  EXPECT_EQ(result.err.find("taken as surface"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("is open and what lies inside is told by the winding number, undecided: open ("),
            std::string::npos)
      << result.err;
  const Json pair = report({"check", "screw.obj", "open.obj", "--solid", "by-winding"})["pairs"][0];
  EXPECT_EQ(pair["relation"], "overlapping");
  EXPECT_EQ(pair["containment"], "a_in_b");
  EXPECT_EQ(pair["status"], "undecided");
  EXPECT_GT(pair["winding"]["lower"], 0.5);
  const Json with_all = report({"check", "screw.obj", "open.obj", "--solid", "by-winding", "--volume", "--tolerance",
                                "1", "--group", "region", "--clearance", "1"});
  EXPECT_EQ(with_all["pairs"][0]["kind"], "contains");
  EXPECT_EQ(with_all["pairs"][0]["tolerance"], "undecided");
  EXPECT_FALSE(with_all["pairs"][0].contains("distance"));
  EXPECT_TRUE(with_all["groups"][0]["lower"][0].is_number());
  EXPECT_EQ(run({"check", "open.obj", "screw.obj", "--solid", "by-winding", "--stream"}).exit_code, 2);
  // Above the missing lid nothing is inside.
  EXPECT_EQ(run({"check", "open.obj", "screw.obj", "--solid", "by-winding", "--pose-b", "0", "0", "1"}).exit_code, 0);
  EXPECT_EQ(report({"check", "open.obj", "screw.obj", "--solid", "by-winding"})["asked"]["query"]["by_winding"], true);
}

}  // namespace
}  // namespace toccata
