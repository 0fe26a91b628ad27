#include "toccata/generate/meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "support/error_message.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata {
namespace {

using test::message_of;

/// FNV-1a over the bits of all coordinates and indices.
std::uint64_t hash_of(const TriangleMesh& mesh) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&](std::uint64_t bits) { hash = (hash ^ bits) * 1099511628211ULL; };
  for (const Vec3& v : mesh.vertices())
    for (int axis = 0; axis < 3; ++axis) {
      const double value = v[axis];
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      add(bits);
    }
  for (const auto& triangle : mesh.triangles())
    for (const Index corner : triangle) add(corner);
  return hash;
}

void expect_sound_solid(const TriangleMesh& mesh) {
  const MeshHealth health = inspect(mesh);
  EXPECT_TRUE(health.closed);
  EXPECT_GT(health.signed_volume, 0);
  EXPECT_EQ(health.non_manifold_edges + health.flipped_edges, 0U);
  EXPECT_EQ(health.degenerate_triangles + health.duplicate_triangles + health.unused_vertices, 0U);
  EXPECT_EQ(health.distinct_vertices, health.vertices);
}

TEST(GeneratedMeshes, AreWhatTheirDescriptionSays) {
  for (const NamedGenerator& generator : mesh_generators()) {
    SCOPED_TRACE(generator.name);
    const TriangleMesh mesh = generate_mesh(generator.name);
    if (generator.closed) {
      expect_sound_solid(mesh);
      EXPECT_EQ(inspect(mesh).components, generator.name == "cavity-box" ? 2U : 1U);
    } else {
      EXPECT_FALSE(is_closed(mesh));
      EXPECT_EQ(inspect(mesh).flipped_edges, 0U);
    }
  }
}

TEST(GeneratedMeshes, AreSoundForOtherParameters) {
  const std::vector<std::string> specifications = {
      "gen:box?half-x=1e-9&half-y=7&half-z=3e8",
      "gen:tetrahedron?half-edge=1e-20",
      "gen:icosphere?subdivisions=0",
      "gen:uv-sphere?around=3&along=2",
      "gen:noise-sphere?roughness=0.9&seed=77&subdivisions=4",
      "gen:prism?sides=3",
      "gen:torus?around=3&sides=3",
      "gen:torus?radius=100&tube-radius=1&around=200",
      "gen:torus-knot?p=3&q=2",
      "gen:torus-knot?p=5&q=7&around=1000&tube-radius=0.03",
      "gen:helix?turns=1&sides=4",
      "gen:helix?sides=24&turns=2&steps-per-turn=100",
      "gen:gear?teeth=3",
      "gen:gear?teeth=120&tip-radius=0.9",
      "gen:cavity-box?margin=1e-6&seed=4",
  };
  for (const std::string& text : specifications) {
    SCOPED_TRACE(text);
    const GeneratorSpecification specification = parse_generator(text);
    expect_sound_solid(generate_mesh(specification.name, specification.parameters));
  }
}

TEST(GeneratedMeshes, HaveTheSizeTheyShould) {
  const MeshHealth box = inspect(box_mesh({1, 2, 3}, {10, 0, 0}));
  EXPECT_EQ(box.triangles, 12U);
  EXPECT_EQ(box.faces, 6U);
  EXPECT_EQ(box.signed_volume, 48);
  EXPECT_EQ(box.lower, (Vec3{9, -2, -3}));
  EXPECT_NEAR(inspect(icosphere_mesh(1, 5)).signed_volume, 4.18879, 0.01);
  EXPECT_NEAR(inspect(uv_sphere_mesh(1, 200, 100)).signed_volume, 4.18879, 0.01);
  EXPECT_NEAR(inspect(torus_mesh({2, 0.5, 200, 100})).signed_volume, 9.8696, 0.02);
  EXPECT_NEAR(inspect(prism_mesh(1, 2, 1000)).signed_volume, 6.28319, 0.001);
  EXPECT_EQ(prism_mesh(1, 2, 7).face_count(), 9U);
}

TEST(GeneratedMeshes, NoiseSpheresAreStarShaped) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const TriangleMesh mesh = noise_sphere_mesh({1, 0.9, 3, seed});
    for (const auto& [a, b, c] : mesh.triangles())
      ASSERT_EQ(orient3d(mesh.vertices()[a], mesh.vertices()[b], mesh.vertices()[c], {0, 0, 0}), Sign::negative)
          << seed;
  }
}

TEST(GeneratedMeshes, NegativeImageIsTheBoxWithoutTheMesh) {
  const TriangleMesh knot = generate_mesh("torus-knot");
  const TriangleMesh negative = negative_image(knot, 0.5);
  expect_sound_solid(negative);
  const MeshHealth inner = inspect(knot), outer = inspect(negative);
  const Vec3 size = outer.upper - outer.lower;
  EXPECT_NEAR(outer.signed_volume, size.x * size.y * size.z - inner.signed_volume, 1e-9);
  EXPECT_NEAR(size.x, inner.upper.x - inner.lower.x + 1, 1e-12);
  EXPECT_EQ(outer.faces, inner.faces + 6);
}

TEST(GeneratedMeshes, ErrorsNameWhatIsUnknown) {
  EXPECT_EQ(message_of([] { (void)generate_mesh("torus-not"); }),
            "there is no generator 'torus-not'; did you mean 'torus-knot'?");
  EXPECT_NE(message_of([] { (void)generate_mesh("zzzzzzzzzzzzzz"); }).find("known are box, "), std::string::npos);
  EXPECT_EQ(message_of([] {
              (void)generate_mesh("torus", {{"radiu", 1}});
            }),
            "the generator 'torus' has no parameter 'radiu'; did you mean 'radius'?");
  EXPECT_NE(message_of([] { (void)generate_mesh("torus", {{"around", 2}}); }).find("from 3 to"), std::string::npos);
  EXPECT_NE(message_of([] { (void)generate_mesh("torus", {{"around", 5.5}}); }).find("whole"), std::string::npos);
  EXPECT_NE(message_of([] {
              (void)generate_mesh("box", {{"half-x", std::nan("")}});
            }).find("half-x"),
            std::string::npos);
  EXPECT_NE(message_of([] {
              (void)generate_mesh("torus", {{"tube-radius", 2}});
            }).find("'torus': the radius"),
            std::string::npos);
}

TEST(GeneratorSpecification, IsParsed) {
  const GeneratorSpecification specification = parse_generator("gen:torus-knot?p=3&tube-radius=1.5e-1");
  EXPECT_EQ(specification.name, "torus-knot");
  EXPECT_EQ(specification.parameters, (GeneratorParameters{{"p", 3}, {"tube-radius", 0.15}}));
  EXPECT_EQ(parse_generator("gen:box").name, "box");
  EXPECT_FALSE(is_generator_specification("gene.obj"));
  for (const char* wrong : {"box", "gen:box?half-x", "gen:box?half-x=a", "gen:box?half-x=1&half-x=2", "gen:box?=&"})
    EXPECT_THROW((void)parse_generator(wrong), Error) << wrong;
}

// Golden bits: a platform, compiler or change that makes other meshes shows here.
TEST(GeneratedMeshes, SameBitsEverywhere) {
  std::string hashes;
  for (const NamedGenerator& generator : mesh_generators())
    hashes += generator.name + " " + std::to_string(hash_of(generate_mesh(generator.name))) + "\n";
  EXPECT_EQ(hashes,
            "box 12698064631400954923\n"
            "tetrahedron 4196218586548810489\n"
            "gear 210169126675207855\n"
            "cavity-box 1265022284870546337\n"
            "height-field 11344348564210725059\n"
            "icosphere 5042968231217751757\n"
            "uv-sphere 11203891890445780637\n"
            "noise-sphere 11620045667395909071\n"
            "prism 14849577487075635403\n"
            "torus 8602359352021456576\n"
            "torus-knot 11271160816182758161\n"
            "helix 11464170314212131539\n");
}

}  // namespace
}  // namespace toccata
