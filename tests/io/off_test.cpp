#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/formats/parse.hpp"
#include "io/text_file.hpp"

namespace toccata::io {
namespace {

using test::bytes_of;
using test::message_of;

PolygonMesh off(const std::string& text) { return parse_off(bytes_of(text), "a.off"); }
std::string error_of_off(const std::string& text) {
  return message_of([&] { off(text); });
}

const std::string square_points = "0 0 0\n1 0 0\n1 1 0\n0 1 0.1\n";

TEST(Off, VerticesAndFacesAreKeptInTheirOrder) {
  const PolygonMesh mesh = off("OFF\n4 2 5\n" + square_points + "3 0 1 2\n4 0 1 2 3\n");
  EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.1}}));
  EXPECT_EQ(mesh.corners, (std::vector<Index>{0, 1, 2, 0, 1, 2, 3}));
  EXPECT_EQ(mesh.first, (std::vector<Index>{0, 3, 7}));
}

TEST(Off, TheCountsStandOnTheFirstLineOrTheNext) {
  const std::string body = square_points + "3 0 1 2\n";
  for (const char* head :
       {"OFF\n4 1 0\n", "OFF 4 1 0\n", "OFF4 1 0\n", "OFF\n4 1\n",
        "# made by hand\n\nOFF # yes\n\n# counts\n4 1 0 # three\n", "OFF\r\n4 1 0\r\n", "\xEF\xBB\xBFOFF\n4 1 0\n"})
    EXPECT_EQ(off(head + body).corners, (std::vector<Index>{0, 1, 2})) << head;
}

TEST(Off, ColoursNormalsAndTextureAreSkipped) {
  EXPECT_EQ(off("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 1 0 1 1 1 1\n3 0 1 2 0.5 0.5 0.5\n").vertices[1],
            (Vec3{1, 0, 0}));
  EXPECT_EQ(off("NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2 255 0 0 # red\n").corners.size(), 3u);
  EXPECT_EQ(off("STCNOFF\n3 1 0\n0 0 0 9 9 9 9 9 9 9 9 9\n1 0 0\n0 1 0\n3 0 1 2\n").corners.size(), 3u);
  EXPECT_EQ(off("STOFF\n3 1 0\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n").corners.size(), 3u);
}

TEST(Off, EveryErrorNamesFileAndLine) {
  const std::string head = "OFF\n4 1 0\n";
  const struct {
    std::string text, message;
  } cases[] = {
      {"OOF\n1 1 1\n", "a.off:1: an OFF file begins with OFF; "},
      {"# nothing\n", "a.off:2: the file holds only comments; "},
      {"OFF", "a.off:1: the file ends before the counts; "},
      {"OFF BINARY\n", "a.off:1: binary OFF files are not read; export the mesh as text"},
      {std::string("OFF BINARY\n\0\0\0\4", 15), "a.off:1: binary OFF files are not read; "},
      {"4OFF\n1 1 1\n", "a.off:1: vertices of four or more dimensions are not read; "},
      {"nOFF\n5\n1 1 1\n", "a.off:1: vertices of four or more dimensions are not read; "},
      {"OFF\n4294967296 1 0\n", "a.off:2: the number of vertices is 4294967296; "},
      {"OFF\n4000000000 4000000000 0\n" + square_points,
       "a.off:2: the file is too short for 4000000000 vertices and 4000000000 faces; "},
      {"OFF\n353535235358 6 0\n", "a.off:2: the number of vertices is 353535235358; "},
      {"OFF\n-1 1 0\n", "a.off:2: the number of vertices is -1; "},
      {"OFF\n4 1.5 0\n", "a.off:2: the number of faces \"1.5\" is not an integer; "},
      {"OFF\n4\n", "a.off:2: the number of faces is missing; "},
      {"OFF\n4 1 0 7\n", "a.off:2: \"7\" does not belong after the counts; "},
      {"OFF\n4 0 0\n" + square_points, "a.off:2: there is no face in it; "},
      {head + square_points + "3 0 1 4\n", "a.off:7: face 0 names vertex 4, but there are 4; count vertices from 0"},
      {head + square_points + "3 0 1 -1\n", "a.off:7: face 0 names vertex -1, but there are 4; "},
      {head + square_points + "3 0 1 \n", "a.off:7: a corner is missing; "},
      {head + square_points + "2 0 1 2 3\n", "a.off:7: face 0 has 2 corners; "},
      {head + square_points + "4000000000 0 1 2\n", "a.off:7: a corner is missing; "},
      {head + square_points + "3 0 1 2\n3 0 1 2\n",
       "a.off:8: there is more in the file than the 4 vertices and 1 faces that were announced; "},
      {head + "0 0 0\n1 0 inf\n1 1 0\n0 1 0\n3 0 1 2\n",
       "a.off:4: the z coordinate \"inf\" is not a finite decimal number; "},
      {head + "0 0 0\n1 0 # short\n1 1 0\n0 1 0\n3 0 1 2\n", "a.off:4: the z coordinate is missing; "},
      {head + square_points + "#########\n", "a.off:8: the file ends before face 0; "},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(error_of_off(text).substr(0, message.size()), message) << text;
}

TEST(Off, EveryTruncationIsAnError) {
  const std::string whole = "OFF\n4 2 0\n" + square_points + "3 0 1 2\n4 0 1 2 3";
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_TRUE(error_of_off(whole.substr(0, size)).starts_with("a.off:")) << size;
}

}  // namespace
}  // namespace toccata::io
