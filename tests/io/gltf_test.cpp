#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "io/scenes/scene_parts.hpp"
#include "io/text_file.hpp"
#include "support/base64.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/scene_file.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

/// Replaces `from` in `text`, which must be there.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

template <class Value>
std::string bytes_of(std::initializer_list<Value> values) {
  std::string bytes;
  for (const Value value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  return bytes;
}

/// Four points of a square, then two triangles as 16-bit indices, then their strip as bytes.
const std::string square = bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0.1F, 0}) +
                           bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3}) + bytes_of<std::uint8_t>({0, 1, 3, 2});

const std::string file = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
  "nodes": [{"name": "root", "children": [1, 2], "translation": [1, 2, 3], "rotation": [0, 0, 1, 1]},
            {"name": "part", "mesh": 0, "scale": [2, 2, 2]},
            {"name": "part", "mesh": 0, "matrix": [0,1,0,0, -1,0,0,0, 0,0,1,0, 7,8,9,1]}],
  "meshes": [{"name": "square", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
  "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 16}],
  "buffers": [{"byteLength": 64, "uri": "data:application/octet-stream;base64,)" +
                         test::base64(square) + R"("}]})";

Scene parse(const std::string& text) { return io::parse_gltf({text, "a.gltf", "no/such/folder"}); }

void expect_error(const std::string& text, const std::string& part) {
  try {
    (void)parse(text);
    ADD_FAILURE() << "no error: " << part;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    EXPECT_TRUE(std::string(error.what()).starts_with("a.gltf")) << error.what();
  }
}

std::vector<std::array<Index, 3>> triangles_of(const Scene& scene) {
  const auto triangles = scene.objects[0].mesh()->triangles();
  return {triangles.begin(), triangles.end()};
}

TEST(Gltf, NodesPoseSharedMeshes) {
  const Scene scene = parse(file);
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.unit, "m");
  EXPECT_EQ(scene.objects[0].name, "part");
  EXPECT_EQ(scene.objects[1].name, "part #2");
  EXPECT_EQ(scene.objects[0].mesh(), scene.objects[1].mesh());
  const Pose root = pose_of({1, 2, 3}, rotation_of({0, 0, 1, 1}), {1, 1, 1});
  EXPECT_EQ(scene.objects[0].pose, root * scaled(Pose{}, 2));
  EXPECT_EQ(scene.objects[1].pose, root * Pose::from_numbers({0, -1, 0, 1, 0, 0, 0, 0, 1, 7, 8, 9}));
  EXPECT_EQ(scene.nodes[1].parent, 0U);
  EXPECT_EQ(scene.objects[0].mesh()->vertices()[3].y, static_cast<double>(0.1F));
  EXPECT_EQ(triangles_of(scene), (std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Gltf, StripsFansAndNoIndices) {
  const std::string bytes =
      with(with(file, R"("byteOffset": 48, "byteLength": 16)", R"("byteOffset": 60, "byteLength": 4)"),
           R"(5123, "count": 6)", R"(5121, "count": 4)");
  const auto mode = [&](const std::string& text, const std::string& number) {
    return triangles_of(parse(with(text, R"("attributes")", R"("mode": )" + number + R"(, "attributes")")));
  };
  EXPECT_EQ(mode(bytes, "5"), (std::vector<std::array<Index, 3>>{{0, 1, 3}, {1, 2, 3}}));
  EXPECT_EQ(mode(with(file, R"(, "indices": 1)", ""), "6"), (std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mode(with(file, R"(, "indices": 1)", ""), "5"), (std::vector<std::array<Index, 3>>{{0, 1, 2}, {1, 3, 2}}));
  expect_error(with(file, R"("attributes")", R"("mode": 1, "attributes")"), "shows no triangles");
  expect_error(with(file, R"(, "indices": 1)", ""), "4 corners make no whole triangles");
}

TEST(Gltf, SparseAccessorsReplaceElements) {
  const std::string sparse =
      R"("sparse": {"count": 1, "indices": {"bufferView": 1, "byteOffset": 2, "componentType": 5123},
                              "values": {"bufferView": 0, "byteOffset": 24}}, )";
  const Scene scene =
      parse(with(file, R"({"bufferView": 0, "componentType")", "{" + sparse + R"("bufferView": 0, "componentType")"));
  EXPECT_EQ(scene.objects[0].mesh()->vertices()[1], (Vec3{1, 1, 0}));
  const Scene zeros = parse(with(file, R"({"bufferView": 0, "componentType")", "{" + sparse + R"("componentType")"));
  EXPECT_EQ(zeros.objects[0].mesh()->vertices()[1], (Vec3{1, 1, 0}));
  EXPECT_EQ(zeros.objects[0].mesh()->vertices()[2], (Vec3{0, 0, 0}));
  expect_error(with(file, R"({"bufferView": 0, "componentType")",
                    "{" + with(sparse, R"("count": 1)", R"("count": 4)") + R"("componentType")"),
               "its 4 elements need");
}

TEST(Gltf, WhatIsWrongIsSaid) {
  expect_error("{}", "not glTF 2");
  expect_error("{", "not valid JSON");
  expect_error(with(file, R"("2.0")", R"("1.0")"), "not glTF 2");
  expect_error(with(file, R"("nodes": [0])", R"("nodes": [3])"), "there is no node 3");
  expect_error(with(file, R"("children": [1, 2])", R"("children": [1, 0])"), "its own ancestor");
  expect_error(with(file, R"("children": [1, 2])", R"("children": [1, 1])"), "two parents");
  expect_error(with(file, R"("indices": 1)", R"("indices": 2)"), "there is no accessor 2");
  expect_error(with(file, R"("count": 4)", R"("count": 5)"), "its 5 elements need 60 bytes");
  expect_error(with(file, R"("count": 4)", R"("count": 4e9)"), "need 48000000000 bytes");
  expect_error(with(file, R"("count": 4)", R"("count": 1e300)"), "whole number");
  expect_error(with(file, R"("count": 4)", R"("count": 3)"), "index 3 is out of range");
  expect_error(with(file, R"("count": 6)", R"("count": -1)"), "whole number");
  expect_error(with(file, R"("byteLength": 48)", R"("byteLength": 49000)"), "ends at byte 49000");
  expect_error(
      with(file, R"({"bufferView": 0, "componentType")", R"({"byteOffset": 1e15, "bufferView": 0, "componentType")"),
      "elements need");
  expect_error(with(file, R"("buffer": 0)", R"("buffer": 9)"), "there is no buffer 9");
  expect_error(with(file, R"("byteLength": 64)", R"("byteLength": 65536)"), "should have 65536");
  expect_error(with(file, "base64,", "base64,!"), "not base64");
  expect_error(with(file, "data:application/octet-stream;base64,", "data:,"), "not in base64");
  expect_error(with(file, R"("VEC3")", R"("VEC2")"), "must be of type VEC3");
  expect_error(with(file, "5123", "5126"), "indices must be unsigned");
  expect_error(with(file, "7,8,9,1", "7,8,9,2"), "last row");
  expect_error(with(file, "[0, 0, 1, 1]", "[0, 0, 0, 0]"), "quaternion");
  expect_error(with(file, R"({"name": "part", "mesh": 0)", R"({"skin": 0, "name": "part", "mesh": 0)"), "skeleton");
  expect_error(with(file, R"("asset")", R"("extensionsRequired": ["KHR_draco_mesh_compression"], "asset")"),
               "compression off");
  expect_error(
      with(file, R"("bufferView": 0, "componentType": 5126, "count": 4)", R"("componentType": 5126, "count": 4e9)"),
      "far more numbers");
}

TEST(Gltf, BuffersStayInTheFolder) {
  const std::size_t begin = file.find("data:"), end = file.find('"', begin);
  const auto named = [&](const std::string& uri) { return file.substr(0, begin) + uri + file.substr(end); };
  for (const char* uri : {"../secret.bin", "/etc/passwd", "%2e%2e/secret.bin", "a/../../b", "file:///etc/passwd",
                          "http://host/a.bin", "C:\\\\a.bin", ""})
    expect_error(named(uri), "not a file within the folder");
  expect_error(named("missing.bin"), "missing.bin: there is no such file");
}

std::string glb_of(const std::string& text, const std::string& binary) {
  const std::string padded = text + std::string((4 - text.size() % 4) % 4, ' ');
  const auto size = [](const std::string& s) { return static_cast<std::uint32_t>(s.size()); };
  return "glTF" + bytes_of<std::uint32_t>({2, size(padded) + size(binary) + 28, size(padded), 0x4E4F534A}) + padded +
         bytes_of<std::uint32_t>({size(binary), 0x004E4942}) + binary;
}

TEST(Gltf, BinaryFiles) {
  const std::size_t begin = file.find(", \"uri\""), end = file.find("\"}]}", begin);
  const std::string text = file.substr(0, begin) + file.substr(end + 1);
  const std::string glb = glb_of(text, square);
  EXPECT_EQ(triangles_of(parse(glb)), triangles_of(parse(file)));
  for (std::size_t size = 0; size < glb.size(); ++size) EXPECT_THROW((void)parse(glb.substr(0, size)), Error) << size;
  expect_error(text, "the buffer has no data");
}

TEST(Gltf, ManyNodesOfOneNameAreQuick) {
  std::string nodes = R"("nodes": [)", roots;
  for (int i = 0; i < 20000; ++i) {
    nodes += R"({"name": "n", "mesh": 0},)";
    roots += (i == 0 ? "" : ",") + std::to_string(i);
  }
  const std::size_t begin = file.find(R"("nodes": [{"name")"), end = file.find(R"("meshes")");
  const std::string many = file.substr(0, begin) + nodes.substr(0, nodes.size() - 1) + "], " + file.substr(end);
  EXPECT_EQ(parse(with(many, R"("nodes": [0])", R"("nodes": [)" + roots + "]")).objects.back().name, "n #20000");
}

/// A file whose mesh is that many primitives of one accessor.
std::string repeating(const std::string& primitive, int times, std::size_t positions) {
  std::string list = primitive;
  for (int i = 1; i < times; ++i) list += "," + primitive;
  return R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": [)" + list +
         R"(]}], "accessors": [{"componentType": 5126, "type": "VEC3", "count": )" + std::to_string(positions) +
         R"(}, {"componentType": 5121, "type": "SCALAR", "count": )" + std::to_string(positions) + "}]}";
}

TEST(Gltf, ASmallFileCannotFillTheMemory) {
  for (const char* mode : {R"(, "mode": 4)", R"(, "mode": 5)", R"(, "indices": 1)"}) {
    const std::string primitive = R"({"attributes": {"POSITION": 0})" + std::string(mode) + "}";
    EXPECT_EQ(parse(repeating(primitive, 3, 99999)).objects.size(), 1U);
    expect_error(repeating(primitive, 40, 99999), "asks for far more numbers than it has");
    expect_error(repeating(primitive, 1, 999999), "asks for far more numbers than it has");
  }
}

TEST(Gltf, BuffersOfOneFileLoadItOnce) {
  const test::TemporaryFolder folder;
  folder.write("square.bin", square + std::string(1 << 20, '\0'));
  const std::size_t begin = file.find("data:"), end = file.find('"', begin);
  const std::string named = file.substr(0, begin) + "square.bin" + file.substr(end);
  std::string buffers = R"({"byteLength": 64, "uri": "square.bin"})", views, accessors, primitives;
  for (int i = 1; i <= 12; ++i) {
    const std::string number = std::to_string(i);
    buffers += R"(, {"byteLength": 64, "uri": "./square%2ebin"})";
    views += R"(, {"buffer": )" + number + R"(, "byteLength": 48})";
    accessors +=
        R"(, {"bufferView": )" + std::to_string(i + 1) + R"(, "componentType": 5126, "count": 4, "type": "VEC3"})";
    primitives += R"(, {"attributes": {"POSITION": )" + std::to_string(i + 1) + R"(}, "indices": 1})";
  }
  // Each file that is loaded allows for more; loaded once, it does not allow for this many elements of zero.
  std::string text = with(named, R"("indices": 1})", R"("indices": 1})" + primitives);
  text = with(text, R"("type": "SCALAR"})", R"("type": "SCALAR"})" + accessors);
  text = with(text, R"("byteLength": 16})", R"("byteLength": 16})" + views);
  const std::size_t list = text.find(R"("buffers": [)");
  text = text.substr(0, list) + R"("buffers": [)" + buffers + "]}";
  folder.write("a.gltf", text);
  EXPECT_EQ(read_scene(folder / "a.gltf").objects[0].mesh()->triangles().size(), 26U);
  const std::string greedy = R"(, {"componentType": 5126, "count": 20000000, "type": "VEC3"}])";
  const std::size_t after = text.find("],", text.find(R"("accessors")"));
  text = text.substr(0, after) + greedy + text.substr(after + 1);
  text = with(text, R"({"attributes": {"POSITION": 13}, "indices": 1})",
              R"({"attributes": {"POSITION": 13}, "indices": 1}, {"attributes": {"POSITION": 14}, "indices": 1})");
  folder.write("b.gltf", text);
  EXPECT_NE(test::message_of([&] { (void)read_scene(folder / "b.gltf"); }).find("far more numbers"), std::string::npos);
}

TEST(Gltf, EveryFileOfACorpusLoadsOrGivesAnError) {
  const std::filesystem::path corpus = "/usr/share/assimp/models";
  if (!std::filesystem::exists(corpus)) GTEST_SKIP() << "install assimp-testmodels";
  int loaded = 0, refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus)) {
    if (!entry.is_regular_file() || !io::is_gltf(entry.path())) continue;
    try {
      EXPECT_FALSE(read_scene(entry.path()).objects.empty());
      ++loaded;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(entry.path().string()), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(loaded, 20);
  EXPECT_GT(refused, 10);
}

}  // namespace
}  // namespace toccata
