#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/formats/parse.hpp"
#include "io/text_file.hpp"

namespace toccata::io {
namespace {

using test::bytes_of;
using test::message_of;
using ::testing::Test;

PolygonMesh obj(const std::string& text) { return parse_obj(bytes_of(text), "a.obj"); }
std::string error_of_obj(const std::string& text) {
  return message_of([&] { obj(text); });
}

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(Obj, PartsAreWhatStandsUnderTheSameNamesWithTheVerticesThatTheyUse) {
  const std::string text = triangle + "f 3 2 1\no car\nv 5 5 5\nf 1 2 4\ng left  door\nf 2 4 3\nv 7 7 7\n" +
                           "o car\nf 4 3 5\no house\ng house\nf 1 2 3\ng\n";
  const std::vector<NamedPolygons> parts = parse_obj_parts(bytes_of(text), "a.obj");
  ASSERT_EQ(parts.size(), 4U);
  EXPECT_EQ(parts[0].name, "");
  EXPECT_EQ(parts[0].mesh.corners, (std::vector<Index>{2, 1, 0}));
  EXPECT_EQ(parts[1].name, "car");
  EXPECT_EQ(parts[1].mesh.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {7, 7, 7}}));
  EXPECT_EQ(parts[1].mesh.corners, (std::vector<Index>{0, 1, 3, 3, 2, 4}));
  EXPECT_EQ(parts[1].mesh.first, (std::vector<Index>{0, 3, 6}));
  EXPECT_EQ(parts[2].name, "car/left door");
  EXPECT_EQ(parts[2].mesh.vertices, (std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}, {5, 5, 5}}));
  EXPECT_EQ(parts[3].name, "house");
}

TEST(Obj, VerticesAndFacesAreKeptInTheirOrder) {
  const PolygonMesh mesh = obj(triangle + "v 1 1 0.1\nf 1 2 3\nf 2 4 3 1\n");
  EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.1}}));
  EXPECT_EQ(mesh.corners, (std::vector<Index>{0, 1, 2, 1, 3, 2, 0}));
  EXPECT_EQ(mesh.first, (std::vector<Index>{0, 3, 7}));
}

TEST(Obj, CornersMayNameTextureAndNormal) {
  for (const char* face :
       {"f 1/1 2/2 3/3", "f 1//1 2//2 3//3", "f 1/7/9 2/-1/8 3/1/-2", "f 1/ 2// 3/4/", "f -3 -2 -1", "f\t1  2\t 3 \t",
        "f 1 2 3 # a comment", "f 1 2 \\\n 3", "f 1 2\\\r\n 3", "fo 1 2 3", "f +1 2 3"})
    EXPECT_EQ(obj(triangle + face).corners, (std::vector<Index>{0, 1, 2})) << face;
}

TEST(Obj, NegativeIndicesCountBackFromTheFace) {
  const PolygonMesh mesh = obj(triangle + "f -3 -2 -1\nv 5 5 5\nf -1 -2 -3\n");
  EXPECT_EQ(mesh.corners, (std::vector<Index>{0, 1, 2, 3, 2, 1}));
}

TEST(Obj, FacesMayNameLaterVertices) { EXPECT_EQ(obj("f 1 2 3\n" + triangle).corners.size(), 3u); }

TEST(Obj, LinesEndInEveryWayAndBlankOnesAreSkipped) {
  for (const char* text : {"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3",
                           "\xEF\xBB\xBFv 0 0 0\n\n  \nv 1 0 0\n\tv 0 1 0\n\n#\nf 1 2 3"}) {
    EXPECT_EQ(obj(text).vertices.size(), 3u) << text;
    EXPECT_EQ(obj(text).corners.size(), 3u) << text;
  }
}

TEST(Obj, WeightsAndColoursOfVerticesAreLeftOut) {
  const PolygonMesh mesh = obj("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 1 0 0 1\nf 1 2 3\n");
  EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(Obj, OtherStatementsAreSkippedAndFacesNumberedOverTheWholeFile) {
  const PolygonMesh mesh = obj("mtllib C:\\models\\\no first\n" + triangle +
                               "vt 0 0\nvn 0 0 1\ng one two\nusemtl red\ns off\nl 1 2\np 1\nf 1 2 3\no second\n" +
                               triangle + "f 4 5 6\n# C:\\\nf 6 5 4\nparm u 0 1\n");
  EXPECT_EQ(mesh.first, (std::vector<Index>{0, 3, 6, 9}));
  EXPECT_EQ(mesh.corners, (std::vector<Index>{0, 1, 2, 3, 4, 5, 5, 4, 3}));
}

TEST(Obj, DegenerateFacesAreKept) { EXPECT_EQ(obj(triangle + "f 1 1 1\nf 1 2 2 3\n").corners.size(), 7u); }

TEST(Obj, EveryErrorNamesFileAndLine) {
  const struct {
    std::string text, message;
  } cases[] = {
      {triangle + "f 1 2 4\n", "a.obj:4: a face names vertex 4, but there are only 3; "},
      {triangle + "\nf 1 2 3\nf 1 2 9\nf 1 2 12\n", "a.obj:6: a face names vertex 9, but there are only 3; "},
      {triangle + "f 1 2 -4\n", "a.obj:4: a face names vertex -4, but there are only 3 before it; "},
      {triangle + "f 0 1 2\n", "a.obj:4: a face names vertex 0; count vertices from 1"},
      {triangle + "f 1 2 99999999999\n", "a.obj:4: a face names vertex 99999999999, but there are only "},
      {triangle + "f 1 2 99999999999999999999\n",
       "a.obj:4: the face corner \"99999999999999999999\" is not an index; "},
      {triangle + "f 1 2 3.0\n", "a.obj:4: the face corner \"3.0\" is not an index; "},
      {triangle + "f 1/1/1/1 2 3\n", "a.obj:4: the face corner \"1/1/1/1\" is not an index; "},
      {triangle + "f 1/x 2 3\n", "a.obj:4: the face corner \"1/x\" is not an index; "},
      {triangle + "f /1 2 3\n", "a.obj:4: the face corner \"/1\" is not an index; "},
      {triangle + "f 1 2\n", "a.obj:4: a face has 2 corners; give it three or more"},
      {triangle + "f\n", "a.obj:4: a face has 0 corners; "},
      {"v 1 2\n", "a.obj:1: the z coordinate is missing; "},
      {"v 0 0 0\r\nv nan 0 0\n", "a.obj:2: the x coordinate \"nan\" is not a finite decimal number; "},
      {"v 0 -inf 0\n", "a.obj:1: the y coordinate \"-inf\" is not a finite decimal number; "},
      {"v 0 0 1e400\n", "a.obj:1: the z coordinate \"1e400\" is larger than any double; "},
      {"v 0 0 0x1p3\n", "a.obj:1: the z coordinate \"0x1p3\" is not a finite decimal number; "},
      {"v 0,5 0 0\n", "a.obj:1: the x coordinate \"0,5\" is not a finite decimal number; "},
      {"v 3.1+e2 0 0\n", "a.obj:1: the x coordinate \"3.1+e2\" is not a finite decimal number; "},
      {"v 0 0 0 red\n", "a.obj:1: the weight or colour \"red\" is not a finite decimal number; "},
      {"v 0 0 0 1 2 3 4 5\n", "a.obj:1: \"5\" does not belong after a vertex; "},
      {triangle, "a.obj: there is no face in it (3 vertices); "},
      {"hello\nworld\n", "a.obj: there is neither a vertex nor a face in it; check that it is an OBJ file"},
      {std::string("v 0 0 0\0\n", 9), "a.obj: this is binary data where text was expected; "},
      {"\xFF\xFEv", "a.obj: this is UTF-16 text; save it as UTF-8 or ASCII"},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(error_of_obj(text).substr(0, message.size()), message) << text;
}

TEST(Obj, EveryTruncationIsReadOrRefusedButNothingElse) {
  const std::string whole = triangle + "v 1 1 1 0.5 0.5 0.5\nf 1/1/1 2//2 -1\\\n 3\nf 1 2 3 # end\n";
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    const std::string message = error_of_obj(whole.substr(0, size));
    EXPECT_TRUE(message.empty() || message.starts_with("a.obj:")) << size << message;
  }
}

}  // namespace
}  // namespace toccata::io
