#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "io/formats/parse.hpp"
#include "io/text_file.hpp"
#include "toccata/core/random.hpp"

namespace toccata::io {
namespace {

using test::bytes_of;
using test::message_of;

TriangleMesh stl(const std::string& text) { return parse_stl(bytes_of(text), "a.stl"); }
std::string error_of_stl(const std::string& text) {
  return message_of([&] { static_cast<void>(stl(text)); });
}

const std::string facet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0.1\n endloop\nendfacet\n";

template <typename T>
void append(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string binary(const std::vector<Vec3>& vertices, const std::string& header = "made by a test") {
  std::string bytes = header;
  bytes.resize(80, '\0');
  append(bytes, static_cast<std::uint32_t>(vertices.size() / 3));
  for (std::size_t facet_start = 0; facet_start < vertices.size(); facet_start += 3) {
    for (int i = 0; i < 3; ++i) append(bytes, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(vertices[facet_start + corner][axis]));
    append(bytes, std::uint16_t{0x8123});
  }
  return bytes;
}

const std::vector<Vec3> two_facets = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}, {0, 0, 0}, {0, 1, 0.1}, {1, 0, 0}};

TEST(Stl, SolidsOfATextAreParts) {
  const std::string text =
      "solid left  wheel\n" + facet + "endsolid\nsolid\nendsolid\nSOLID right\n" + facet + facet + "endsolid right\n";
  const std::vector<NamedMesh> solids = parse_stl_solids(bytes_of(text), "a.stl");
  ASSERT_EQ(solids.size(), 2U);
  EXPECT_EQ(solids[0].name, "left wheel");
  EXPECT_EQ(solids[0].mesh.triangle_count(), 1U);
  EXPECT_EQ(solids[1].name, "right");
  EXPECT_EQ(solids[1].mesh.triangle_count(), 2U);
  EXPECT_EQ(solids[1].mesh.vertices().size(), 3U);
  EXPECT_EQ(stl(text).triangle_count(), 3U);
  EXPECT_EQ(parse_stl_solids(bytes_of(binary(two_facets)), "a.stl").size(), 1U);
}

TEST(Stl, CornersOfTheSameCoordinatesAreOneVertex) {
  const std::string other =
      "facet normal 0 0 1\nouter loop\nvertex 2 0 0\nvertex 0 1 0.1\nvertex 1 0 0\nendloop\nendfacet\n";
  const TriangleMesh mesh = stl("solid part 1\n" + facet + facet + other + "endsolid part 1\n");
  ASSERT_EQ(mesh.triangle_count(), 3u);
  ASSERT_EQ(mesh.vertices().size(), 4u);
  EXPECT_EQ(mesh.vertices()[2], (Vec3{0, 1, 0.1}));
  EXPECT_EQ(mesh.vertices()[3], (Vec3{2, 0, 0}));
  EXPECT_EQ(mesh.triangles()[1], (std::array<Index, 3>{0, 1, 2}));
  EXPECT_EQ(mesh.triangles()[2], (std::array<Index, 3>{3, 2, 1}));
  EXPECT_EQ(mesh.face_of(2), 2u);
}

/// −0 and 0 are equal, but not the same double, and both are kept.
TEST(Stl, VerticesKeepTheirSigns) {
  const TriangleMesh mesh = stl(binary({{0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {0, 1, 0}, {1, 0, 0}}));
  ASSERT_EQ(mesh.vertices().size(), 4u);
  EXPECT_FALSE(std::signbit(mesh.vertices()[0].x));
  EXPECT_TRUE(std::signbit(mesh.vertices()[3].x));
  EXPECT_EQ(mesh.triangles()[1], (std::array<Index, 3>{3, 2, 1}));
}

/// Every corner is where the file has it, in a mesh so large that the table of vertices grows, of which some come
/// again.
TEST(Stl, ManyVerticesAreFoundAgain) {
  Random random(7);
  std::vector<Vec3> corners;
  for (int i = 0; i < 30000; ++i) {
    const auto place = [&] { return static_cast<double>(static_cast<float>(std::floor(random.between(0, 25)) * 0.1)); };
    corners.push_back({place(), place(), place()});
  }
  const TriangleMesh mesh = stl(binary(corners));
  std::set<std::array<double, 3>> distinct;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3& vertex = mesh.vertices()[mesh.triangles()[i / 3][i % 3]];
    ASSERT_EQ(vertex, corners[i]) << i;
    distinct.insert({vertex.x, vertex.y, vertex.z});
  }
  EXPECT_EQ(mesh.vertices().size(), distinct.size());
  EXPECT_GT(distinct.size(), 10000u);
}

TEST(Stl, SeveralSolidsAreOneMesh) {
  EXPECT_EQ(
      stl("solid\n" + facet + "endsolid\nsolid empty\nendsolid\nsolid b\n" + facet + "endsolid b").triangle_count(),
      2u);
}

TEST(Stl, WordsMayBeInCapitalsAndNormalsMayBeAnything) {
  EXPECT_EQ(
      stl("  SOLID x\r\nFACET NORMAL nan nan -nan\r\nOUTER LOOP\r\nVERTEX 0 0 0\r\nVertex 1 0 0\r\nVERTEX 0 1 0\r\n"
          "ENDLOOP\r\nENDFACET\r\nENDSOLID\r\n")
          .triangle_count(),
      1u);
  EXPECT_EQ(stl("solid x\nfacet outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid")
                .triangle_count(),
            1u);
}

TEST(Stl, BinaryFloatsAreWidenedExactly) {
  const TriangleMesh mesh = stl(binary(two_facets));
  ASSERT_EQ(mesh.triangle_count(), 2u);
  EXPECT_EQ(mesh.vertices()[2].z, static_cast<double>(0.1f));
  EXPECT_EQ(mesh.triangles()[1], (std::array<Index, 3>{0, 2, 1}));
}

TEST(Stl, BinaryMayBeginWithSolid) {
  EXPECT_EQ(stl(binary(two_facets, "solid facet normal")).triangle_count(), 2u);
  const std::string all_text(80, ' ');
  EXPECT_EQ(stl(binary(two_facets, "solid exported by a text loving program" + all_text.substr(39))).triangle_count(),
            2u);
}

TEST(Stl, ALittlePaddingMayFollowABinary) {
  EXPECT_EQ(stl(binary(two_facets) + "\n").triangle_count(), 2u);
  EXPECT_EQ(stl(binary(two_facets) + std::string(49, '\0')).triangle_count(), 2u);
}

TEST(Stl, EveryErrorNamesThePlace) {
  const std::string start = "solid x\nfacet normal 0 0 1\nouter loop\n";
  const struct {
    std::string text, message;
  } cases[] = {
      {start + "vertex 0 0\nvertex 1 0 0\n", "a.stl:4: the z coordinate is missing; "},
      {start + "vertex 0 0 nan\n", "a.stl:4: the z coordinate \"nan\" is not a finite decimal number; "},
      {start + "vertex 0 0 1e999\n", "a.stl:4: the z coordinate \"1e999\" is larger than any double; "},
      {start + "vertex 0 0 0 1\n", "a.stl:4: \"vertex\" was expected, not \"1\"; "},
      {start + "vertex 0 0 0\nvertex 1 0 0\nendloop\n", "a.stl:6: \"vertex\" was expected, not \"endloop\"; "},
      {start + "vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n",
       "a.stl:7: a facet has more than three vertices; "},
      {"solid x\n" + facet, "a.stl:9: the file ends inside a solid; "},
      {"solid x\n" + facet.substr(0, 40), "a.stl:4: the x coordinate is missing; "},
      {"solid x\n" + facet + "endsolid\nwhat\n", "a.stl:10: \"solid\" was expected, not \"what\"; "},
      {"solid x\nendsolid x\n", "a.stl: there is no facet in it; "},
      {"something else", "a.stl: this is no STL file: "},
      {std::string(84, '\0'), "a.stl: there is no facet in it; "},
      {binary(two_facets).substr(0, 150),
       "a.stl: at byte 80: a binary STL file with 2 facets is announced, but the file has room for 1; "},
      {binary(two_facets) + std::string(50, '\0'),
       "a.stl: at byte 80: a binary STL file with 2 facets is announced, but the file has room for 3; "},
      {binary({{0, 0, 0}, {1, 0, std::numeric_limits<double>::infinity()}, {0, 1, 0}}),
       "a.stl: at byte 108: vertex 1 of facet 0 is not finite; "},
      {std::string(80, 'x') + "\xFF\xFF\xFF\xFF" + std::string(900, 'x'),
       "a.stl: at byte 80: a binary STL file with 4294967295 facets is announced, "},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(error_of_stl(text).substr(0, message.size()), message) << text;
}

TEST(Stl, EveryTruncationIsAnError) {
  for (const std::string& whole : {"solid x\n" + facet + "endsolid", binary(two_facets)})
    for (std::size_t size = 0; size < whole.size(); ++size)
      EXPECT_TRUE(error_of_stl(whole.substr(0, size)).starts_with("a.stl:")) << size;
}

}  // namespace
}  // namespace toccata::io
