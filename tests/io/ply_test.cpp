#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "io/formats/parse.hpp"
#include "io/text_file.hpp"

namespace toccata::io {
namespace {

using test::bytes_of;
using test::message_of;

PolygonMesh ply(const std::string& text) { return parse_ply(bytes_of(text), "a.ply"); }
std::string error_of_ply(const std::string& text) {
  return message_of([&] { ply(text); });
}

const std::string head = "ply\nformat ascii 1.0\ncomment by hand\nobj_info none\n";
const std::string four_vertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0.1\n";
const std::string faces = "property list uchar int vertex_indices\nend_header\n";
const std::vector<Vec3> expected_points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.1}};

std::string with_one_face(const std::string& face) {
  return head + four_vertices + "element face 1\n" + faces + points + face;
}

/// Values appended in the byte order of a file.
class Binary {
 public:
  explicit Binary(bool big_endian) : big_endian_(big_endian) {}

  template <typename T>
  Binary& add(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (big_endian_) std::reverse(raw, raw + sizeof(T));
    bytes_.append(raw, sizeof(T));
    return *this;
  }

  [[nodiscard]] std::string file(const std::string& header) const {
    const std::string order = big_endian_ ? "binary_big_endian" : "binary_little_endian";
    return "ply\nformat " + order + " 1.0\n" + header + "end_header\n" + bytes_;
  }

 private:
  bool big_endian_;
  std::string bytes_;
};

TEST(Ply, TextIsReadInItsOrderWithTheNearestDoubles) {
  const PolygonMesh mesh = ply(head + four_vertices + "element face 2\n" + faces + points + "3 0 1 2\n4 0 1 2 3\n");
  EXPECT_EQ(mesh.vertices, expected_points);
  EXPECT_EQ(mesh.corners, (std::vector<Index>{0, 1, 2, 0, 1, 2, 3}));
  EXPECT_EQ(mesh.first, (std::vector<Index>{0, 3, 7}));
}

TEST(Ply, PropertiesMayComeInAnyOrderAndUnknownOnesAreSkipped) {
  const PolygonMesh mesh =
      ply("ply\r\nformat ascii 1.0\r\nelement camera 1\r\nproperty list int float m\r\nproperty uchar q\r\nelement "
          "nothing 4000000000\r\n"
          "element face 1\r\nproperty uchar red\r\nproperty list uint8 uint32 vertex_index\r\nproperty list uchar "
          "float texcoord\r\n"
          "element vertex 3\r\nproperty float z\r\nproperty list char short w\r\nproperty float64 x\r\nproperty uchar "
          "alpha\r\nproperty double y\r\n"
          "element edge 1\r\nproperty int a\r\nend_header\r\n"
          "2 nan 7 9\r\n\r\n255 3 2 1 0 6 0 0 1 0 0 1\r\n0.1 0 1 7 2\r\n0 2 5 6 3 7 4\r\n0 0 5 7\r\n6\r\n77\r\n");
  EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{1, 2, 0.1}, {3, 4, 0}, {5, 6, 0}}));
  EXPECT_EQ(mesh.corners, (std::vector<Index>{2, 1, 0}));
}

TEST(Ply, BinaryOfBothEndsAndAllTypes) {
  for (const bool big_endian : {false, true}) {
    Binary body(big_endian);
    body.add(1.5f).add(std::int8_t{-2}).add(std::numeric_limits<float>::quiet_NaN()).add(0.1);
    body.add(2.5f).add(std::int8_t{-3}).add(0.0f).add(0.2);
    body.add(3.5f).add(std::int8_t{4}).add(0.0f).add(-0.3);
    body.add(std::uint16_t{3})
        .add(std::int16_t{2})
        .add(std::int16_t{1})
        .add(std::int16_t{0})
        .add(std::int32_t{1})
        .add(9.0);
    const PolygonMesh mesh =
        ply(body.file("element vertex 3\nproperty float y\nproperty char x\nproperty float nx\nproperty double z\n"
                      "element face 1\nproperty list ushort short vertex_index\nproperty list int double other\n"));
    EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{-2, 1.5, 0.1}, {-3, 2.5, 0.2}, {4, 3.5, -0.3}})) << big_endian;
    EXPECT_EQ(mesh.corners, (std::vector<Index>{2, 1, 0})) << big_endian;
  }
}

TEST(Ply, IntegerCoordinatesAreExact) {
  for (const bool big_endian : {false, true}) {
    Binary body(big_endian);
    for (int vertex = 0; vertex < 3; ++vertex)
      body.add(std::uint32_t{4000000001}).add(std::int32_t{-2000000001}).add(std::uint16_t{65535});
    body.add(std::uint8_t{3}).add(std::uint32_t{0}).add(std::uint32_t{1}).add(std::uint32_t{2});
    EXPECT_EQ(ply(body.file("element vertex 3\nproperty uint x\nproperty int y\nproperty ushort z\n"
                            "element face 1\nproperty list uchar uint vertex_indices\n"))
                  .vertices[2],
              (Vec3{4000000001, -2000000001, 65535}));
  }
}

TEST(Ply, AHeaderOfCarriageReturnsMayPrecedeALineFeedByte) {
  std::string bytes =
      "ply\rformat binary_little_endian 1.0\relement face 1\rproperty list uchar uchar vertex_indices\r"
      "element vertex 11\rproperty char x\rproperty char y\rproperty char z\rend_header\r\n";
  for (int i = 0; i < 10; ++i) bytes += static_cast<char>(i);  // a face of ten corners: its count is a line feed
  EXPECT_EQ(ply(bytes + std::string(33, '\1')).corners.size(), 10u);
}

TEST(Ply, StripsAlternateAndBeginAnewAtMinusOne) {
  const std::string text = head + "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n" +
                           "element tristrips 2\nproperty list int int vertex_indices\nend_header\n" +
                           "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";
  const PolygonMesh mesh = ply(text + "11 0 1 2 3 4 -1 5 4 -1 3 2\n4 3 2 2 1\n");
  EXPECT_EQ(mesh.corners, (std::vector<Index>{0, 1, 2, 2, 1, 3, 2, 3, 4, 3, 2, 2, 2, 2, 1}));
  EXPECT_EQ(mesh.first, (std::vector<Index>{0, 3, 6, 9, 12, 15}));
  EXPECT_TRUE(error_of_ply(text + "3 0 1 -2\n0\n").starts_with("a.ply:18: face 0 names vertex -2, but there are 6; "));
}

TEST(Ply, EveryErrorNamesThePlace) {
  const std::string vertices_only = head + four_vertices;
  const struct {
    std::string text, message;
  } cases[] = {
      {"plx\n", "a.ply:1: a PLY file begins with a line that says ply; "},
      {"ply", "a.ply:1: a PLY file begins with a line that says ply; "},
      {"ply\nformat ascii 1.0\n", "a.ply: the line end_header is missing; "},
      {"ply\nelement vertex 0\nend_header\n", "a.ply:4: the header has no format line; "},
      {"ply\nformat utf8 1.0\nend_header\n", "a.ply:2: the format \"utf8\" is not known; "},
      {"ply\nformat ascii 2.0\nend_header\n", "a.ply:2: version \"2.0\" of PLY is not known; "},
      {head + "elephant 1\nend_header\n", "a.ply:5: \"elephant\" is no word of a PLY header; "},
      {head + "property int x\nend_header\n", "a.ply:5: a property stands before the first element; "},
      {vertices_only + "property quad w\nend_header\n", "a.ply:9: the type \"quad\" is not known; "},
      {vertices_only + "property list float int w\nend_header\n", "a.ply:9: a list is counted by floats; "},
      {head + "element vertex -1\nend_header\n", "a.ply:5: the number of \"vertex\" is -1; "},
      {head + "element vertex 4294967296\nend_header\n", "a.ply:5: the number of \"vertex\" is 4294967296; "},
      {head + "element face 1\n" + faces + "3 0 0 0", "a.ply: there must be exactly one element called vertex; "},
      {head + "element vertex 1\nproperty int x\nproperty int y\nend_header\n0 0\n",
       "a.ply:5: vertices must have each of the properties x, y and z once; "},
      {vertices_only + "end_header\n" + points, "a.ply: there is no face in it (4 vertices); "},
      {vertices_only + "element face 1\nproperty list uchar int loop\nend_header\n" + points + "3 0 1 2\n",
       "a.ply:9: \"face\" must have one list called vertex_indices; "},
      {vertices_only + "element face 1\nproperty list uchar float vertex_indices\nend_header\n" + points + "3 0 1 2\n",
       "a.ply:9: the corners of faces are floats; "},
      {head + "element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n" + points,
       "a.ply:5: the file is too short for 4000000000 elements \"vertex\"; "},
      {vertices_only + "element face 4000000000\n" + faces + points,
       "a.ply:9: the file is too short for 4000000000 elements \"face\"; "},
      {with_one_face("3 0 1 4\n"), "a.ply:16: face 0 names vertex 4, but there are 4; count vertices from 0"},
      {with_one_face("3 0 1 -1\n"), "a.ply:16: face 0 names vertex -1, but there are 4; "},
      {with_one_face("2 0 1\n"), "a.ply:16: face 0 has 2 corners; "},
      {with_one_face("3 0 1 2 3\n"), "a.ply:16: \"3\" does not belong after the last value of an element; "},
      {with_one_face("3 0 1 x\n"), "a.ply:16: a corner \"x\" is not an integer; "},
      {with_one_face("-3 0 1 2\n"), "a.ply:16: a list has the length -3; "},
      {with_one_face("4000000000 0 1 2\n"), "a.ply:16: the file is too short for a list of 4000000000 values; "},
      {with_one_face("3 0 1 2\n3 0 1 2\n"), "a.ply:17: there is more in the file than its header announces; "},
      {with_one_face("3 0\n"), "a.ply:16: the file is too short for a list of 3 values; "},
      {head + four_vertices + "element face 1\n" + faces + "0 0 nan\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n",
       "a.ply:12: the z coordinate \"nan\" is not a finite decimal number; "},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(error_of_ply(text).substr(0, message.size()), message) << text;
}

TEST(Ply, BinaryErrorsNameTheByte) {
  const std::string header =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\n";
  Binary body(true);
  for (int i = 0; i < 9; ++i) body.add(i == 4 ? std::numeric_limits<float>::infinity() : 1.0f);
  body.add(std::uint8_t{3}).add(0).add(1).add(2);
  const std::string start = std::to_string(Binary(true).file(header).size() + 16);
  EXPECT_EQ(error_of_ply(body.file(header)),
            "a.ply: at byte " + start + ": the y coordinate is not finite; export the mesh again");

  Binary good(false);
  for (int i = 0; i < 9; ++i) good.add(1.0f);
  const std::string corners_at = std::to_string(Binary(false).file(header).size() + 37);
  EXPECT_TRUE(error_of_ply(Binary(good).add(std::uint8_t{3}).add(0).add(1).add(3).file(header))
                  .find("face 0 names vertex 3, but there are 3; ") != std::string::npos);
  EXPECT_EQ(error_of_ply(Binary(good).add(std::uint8_t{255}).add(0).add(1).add(2).file(header)),
            "a.ply: at byte " + corners_at + ": the file is too short for a list of 255 values; export the mesh again");
  EXPECT_TRUE(error_of_ply(Binary(good).add(std::uint8_t{3}).add(0).add(1).add(2).add(7).file(header))
                  .find("there is more in the file than its header announces; ") != std::string::npos);
  EXPECT_EQ(error_of_ply(Binary(good).add(std::uint8_t{3}).add(0).add(1).add(2).add('\n').file(header)), "");
}

TEST(Ply, EveryTruncationIsAnError) {
  Binary body(false);
  for (int i = 0; i < 9; ++i) body.add(1.0f);
  body.add(std::uint8_t{3}).add(0).add(1).add(2);
  for (const std::string& whole :
       {with_one_face("4 0 1 2 3"), body.file("element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                                              "element face 1\nproperty list uchar int vertex_indices\n")})
    for (std::size_t size = 0; size < whole.size(); ++size)
      EXPECT_TRUE(error_of_ply(whole.substr(0, size)).starts_with("a.ply:")) << size;
}

}  // namespace
}  // namespace toccata::io
