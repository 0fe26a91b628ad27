// Trouble: exit code 2, one message on standard error that says where and what to do, nothing on standard output.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;

const char* const good_off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

struct BadFile {
  const char* name;
  std::string text;
  const char* message;  ///< must occur in what is said
};

void PrintTo(const BadFile& file, std::ostream* out) { *out << file.name; }

void expect_trouble(const test::CommandResult& result, const std::string& message) {
  EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("toccata: error: ", 0), 0U) << result.err;
  EXPECT_NE(result.err.find(message), std::string::npos) << "expected '" << message << "' in: " << result.err;
}

class BadFileTest : public testing::TestWithParam<BadFile> {};

TEST_P(BadFileTest, IsTroubleThatNamesTheFile) {
  const TemporaryFolder folder;
  folder.write(GetParam().name, GetParam().text);
  folder.write("good.off", good_off);
  const auto result = run_command({"check", GetParam().name, "good.off"}, folder.path());
  expect_trouble(result, GetParam().message);
  EXPECT_NE(result.err.find(GetParam().name), std::string::npos) << result.err;
  expect_trouble(run_command({"inspect", GetParam().name, "--json"}, folder.path()), GetParam().message);
}

const char* const claiming_ply =
    "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
const char* const scene_of_missing_file =
    R"({"format": "toccata-scene", "version": 1, "objects": [{"name": "a", "file": "gone.obj"}]})";
const char* const scene_of_two_alike =
    R"({"format": "toccata-scene", "version": 1, "objects": [{"name": "twin", "file": "good.off"},
       {"name": "twin", "file": "good.off"}]})";

/// The bytes of values as a little-endian machine holds them, which is what all binary formats here want.
template <class Value>
std::string bytes_of(const std::vector<Value>& values) {
  static_assert(std::endian::native == std::endian::little);
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

const std::vector<float> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::vector<float> corners_with_nan{0, 0, 0, 1, std::numeric_limits<float>::quiet_NaN(), 0, 0, 1, 0};

/// A binary STL file of one facet that says it has `facets`.
std::string binary_stl(std::uint32_t facets, const std::vector<float>& vertices) {
  return std::string(80, ' ') + bytes_of<std::uint32_t>({facets}) + bytes_of<float>({0, 0, 1}) + bytes_of(vertices) +
         std::string(2, '\0');
}

/// A binary PLY file of the triangle 0, 1, `last`.
std::string binary_ply(std::int32_t last, const std::vector<float>& vertices) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
         bytes_of(vertices) + '\3' + bytes_of<std::int32_t>({0, 1, last});
}

/// glTF of one triangle; `buffer` is what holds the 36 bytes of its corners.
std::string gltf(const std::string& buffer, const std::string& accessor = "0") {
  return R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": )" +
         accessor + R"(}}]}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36)" +
         buffer + "}]}";
}

/// The same with the corners in it, as GLB: a header, the JSON and the bytes.
std::string glb(const std::vector<float>& vertices) {
  std::string json = gltf("");
  json.append((4 - json.size() % 4) % 4, ' ');
  const std::string chunks = bytes_of<std::uint32_t>({static_cast<std::uint32_t>(json.size()), 0x4E4F534A}) + json +
                             bytes_of<std::uint32_t>({36, 0x004E4942}) + bytes_of(vertices);
  return "glTF" + bytes_of<std::uint32_t>({2, static_cast<std::uint32_t>(12 + chunks.size())}) + chunks;
}

std::string without_end(const std::string& bytes) { return bytes.substr(0, bytes.size() - 8); }

std::string name_of(const testing::TestParamInfo<BadFile>& file) {
  std::string name = file.param.name;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

// What is broken below is broken in one place only.
TEST(GoodBinaryFiles, AreRead) {
  const TemporaryFolder folder;
  folder.write("good.off", good_off);
  folder.write("good.stl", binary_stl(1, corners));
  folder.write("good.ply", binary_ply(2, corners));
  folder.write("good.glb", glb(corners));
  folder.write("outside.gltf", gltf(R"(, "uri": "corners.bin")"));
  folder.write("corners.bin", bytes_of(corners));
  for (const char* const name : {"good.stl", "good.ply", "good.glb", "outside.gltf"})
    EXPECT_EQ(run_command({"check", name, "good.off"}, folder.path()).exit_code, 1) << name;
}

INSTANTIATE_TEST_SUITE_P(BinaryFiles, BadFileTest,
                         testing::Values(BadFile{"cut.stl", without_end(binary_stl(1, corners)), "cut.stl"},
                                         BadFile{"claims.stl", binary_stl(4'000'000'000U, corners), "claims.stl"},
                                         BadFile{"nan.stl", binary_stl(1, corners_with_nan), "nan.stl"},
                                         BadFile{"cut.ply", without_end(binary_ply(2, corners)), "cut.ply"},
                                         BadFile{"nan.ply", binary_ply(2, corners_with_nan), "nan.ply"},
                                         BadFile{"index.ply", binary_ply(3, corners), "index.ply"},
                                         BadFile{"negative.ply", binary_ply(-1, corners), "negative.ply"},
                                         BadFile{"cut.glb", without_end(glb(corners)), "cut.glb"},
                                         BadFile{"nan.glb", glb(corners_with_nan), "nan.glb"}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(
    GltfFiles, BadFileTest,
    testing::Values(BadFile{"broken.gltf", without_end(gltf("")), "broken.gltf"},
                    BadFile{"nothing.gltf", "{}", "glTF 2"},
                    BadFile{"accessor.gltf", gltf(R"(, "uri": "good.off")", "7"), "accessor 7"},
                    BadFile{"gone.gltf", gltf(R"(, "uri": "gone.bin")"), "gone.bin"},
                    BadFile{"short.gltf", gltf(R"(, "uri": "data:application/octet-stream;base64,AAAA")"), "3 bytes"},
                    BadFile{"letters.gltf", gltf(R"(, "uri": "data:application/octet-stream;base64,A*AA")"), "base64"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(Files, BadFileTest,
                         testing::Values(BadFile{"empty.obj", "", "empty.obj"},
                                         BadFile{"truncated.off", "OFF\n3 1 0\n0 0 0\n1 0", "truncated.off"},
                                         BadFile{"liar.stl", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "liar.stl"},
                                         BadFile{"unknown.xyz", "1 2 3\n", "unknown.xyz"},
                                         BadFile{"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "index.obj:4"},
                                         BadFile{"nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", "nan.obj:2"},
                                         BadFile{"huge.obj", "v 0 0 0\nv 1 1e999 0\nv 0 1 0\nf 1 2 3\n", "huge.obj:2"},
                                         BadFile{"claims.ply", claiming_ply, "claims.ply"},
                                         BadFile{"missing-part.json", scene_of_missing_file, "gone.obj"},
                                         BadFile{"alike.json", scene_of_two_alike, "twin"}),
                         name_of);

class BadQuestion : public testing::Test {
 protected:
  TemporaryFolder folder;
  void SetUp() override { folder.write("good.off", good_off); }

  test::CommandResult check_posed(std::vector<std::string> pose, const std::string& file = "good.off") {
    pose.insert(pose.begin(), {"check", "good.off", file, "--pose-b"});
    return run_command(pose, folder.path());
  }
};

TEST_F(BadQuestion, MissingFile) {
  expect_trouble(run_command({"check", "good.off", "gone.stl"}, folder.path()), "gone.stl");
}

TEST_F(BadQuestion, FolderInsteadOfFile) {
  std::filesystem::create_directory(folder.path() / "empty");
  expect_trouble(run_command({"check", "good.off", "empty"}, folder.path()), "no mesh file is in this folder");
}

TEST_F(BadQuestion, PoseThatIsNotFinite) {
  for (const char* const number : {"inf", "1e999", "nan", "0x1p0", ""})
    expect_trouble(check_posed({"1", "0", "0", "0", "1", "0", "0", "0", "1", "0", number, "0"}), "--pose-b");
}

TEST_F(BadQuestion, PoseOfElevenNumbers) {
  expect_trouble(check_posed({"1", "0", "0", "0", "1", "0", "0", "0", "1", "0", "0"}), "pose-b");
}

TEST_F(BadQuestion, PosedVertexThatOverflows) {
  folder.write("large.off", "OFF\n3 1 0\n0 0 0\n1e308 0 0\n0 1 0\n3 0 1 2\n");
  expect_trouble(check_posed({"1e10", "0", "0", "0", "1", "0", "0", "0", "1", "0", "0", "0"}, "large.off"), "large");
}

TEST_F(BadQuestion, SingularPoseOfASolid) {
  folder.write("solid.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  const std::vector<std::string> flat{"1", "0", "0", "0", "1", "0", "0", "0", "0", "0", "0", "0"};
  expect_trouble(check_posed(flat, "solid.off"), "singular");
  // A surface may be flattened.
  EXPECT_EQ(check_posed(flat).exit_code, 1);
}

TEST_F(BadQuestion, OpenMeshAsSolid) {
  expect_trouble(run_command({"check", "good.off", "good.off", "--solid=all"}, folder.path()), "open");
}

TEST_F(BadQuestion, OneObjectIsNoPair) {
  expect_trouble(run_command({"check", "good.off"}, folder.path()), "needs two");
}

TEST_F(BadQuestion, PosesForThreeFiles) {
  expect_trouble(run_command({"check", "good.off", "good.off", "good.off", "--pose-a", "1", "0", "0", "0", "1", "0",
                              "0", "0", "1", "0", "0", "0"},
                             folder.path()),
                 "two files");
}

TEST_F(BadQuestion, MistypedSubcommandIsToldTheRightOne) {
  expect_trouble(run_command({"chekc", "good.off"}), "did you mean 'check'");
}

TEST_F(BadQuestion, UnknownOption) { expect_trouble(run_command({"check", "a.obj", "b.obj", "--fast"}), "--fast"); }

TEST_F(BadQuestion, NumbersThatAnOptionDoesNotTakeAreToldWithWhatItTakes) {
  struct Wrong {
    std::vector<std::string> words;
    const char* told;
  };
  for (const auto& [words, told] : std::vector<Wrong>{
           {{"check", "a.obj", "b.obj", "--threads", "5000"},
            "--threads: give a whole number from 0 to 1024, not '5000'"},
           {{"check", "a.obj", "b.obj", "--threads", "two"},
            "--threads: give a whole number from 0 to 1024, not 'two'"},
           {{"check", "a.obj", "b.obj", "--threads", "-1"}, "--threads: give a whole number from 0 to 1024, not '-1'"},
           {{"check", "a.obj", "b.obj", "--threads", "010"},
            "--threads: give a whole number from 0 to 1024, not '010'"},
           {{"check", "a.obj", "b.obj", "--scale", "abc"}, "--scale: give a finite number above 0, not 'abc'"},
           {{"check", "a.obj", "b.obj", "--scale", "0"}, "--scale: give a finite number above 0, not '0'"},
           {{"check", "a.obj", "b.obj", "--stop-after", "nan"},
            "--stop-after: give a finite number above 0, not 'nan'"},
           {{"check", "a.obj", "b.obj", "--stop-after", "inf"},
            "--stop-after: give a finite number above 0, not 'inf'"},
           {{"check", "a.obj", "b.obj", "--stop-after", "1e999"}, "--stop-after: give a finite number above 0"},
           {{"nearest", "a.obj", "--k", "0"}, "--k: give a whole number from 1 to 1000000, not '0'"},
           {{"decompose", "a.obj", "--parts", "x"}, "--parts: give a whole number from 1 to 4096, not 'x'"},
           {{"demo", "mould", "--factor", "nan"}, "--factor: give a number from 0.001 to 1000, not 'nan'"},
           {{"sweep", "a.obj", "--stop-before", "-1"}, "--stop-before: give a finite number of 0 or more, not '-1'"},
           {{"subdivide", "a.obj", "--crease-angle", "200"}, "--crease-angle: give a number from 0 to 180, not '200'"},
           {{"walk", "a.obj", "--max-slope", "steep"}, "--max-slope: give a number from 0 to 90, not 'steep'"},
           {{"robot", "gen:arm", "--find-allowed", "0"}, "--find-allowed: give a whole number from 1 to"},
           {{"crowd", "--count", "0"}, "--count: give a whole number from 1 to 100000000, not '0'"},
           {{"cost", "a.obj", "b.obj", "--leaf-size", "65"},
            "--leaf-size: give a whole number from 1 to 64, not '65'"}})
    expect_trouble(run_command(words), told);
}

TEST_F(BadQuestion, UnitsThatAreNoneAreRefused) {
  for (const std::string unit : {"parsec", "0", "-1", "nan", "mm2", "MM", "1 m"}) {
    const auto result = run_command({"check", "good.off", "good.off", "--unit", unit}, folder.path());
    expect_trouble(result, "'" + unit + "' is not a unit; write mm, cm, m, km, in, ft, or a positive number of metres");
  }
}

TEST_F(BadQuestion, FileNamesCannotSmuggleControlCharacters) {
  const auto result = run_command({"check", "evil\x1b[31m.obj", "good.off"}, folder.path());
  expect_trouble(result, "evil");
  EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace toccata
