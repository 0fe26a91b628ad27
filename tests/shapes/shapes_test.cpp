#include "toccata/shapes/shape.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "toccata/core/error.hpp"

namespace toccata {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// The message of the Error that `make` throws; empty when it throws none.
std::string refusal_of(const std::function<void()>& make) {
  try {
    make();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void expect_refused(const std::string& words, const std::function<void()>& make) {
  const std::string message = refusal_of(make);
  EXPECT_NE(message.find(words), std::string::npos) << "\"" << message << "\" does not say \"" << words << "\"";
}

TEST(Shapes, NumbersThatAreNotFiniteAreRefused) {
  for (const double bad : {HUGE_VAL, -HUGE_VAL, not_a_number}) {
    expect_refused("position of a point", [&] { static_cast<void>(Point({bad, 0, 0})); });
    expect_refused("start of a segment", [&] { static_cast<void>(Segment({0, bad, 0}, {})); });
    expect_refused("end of a segment", [&] { static_cast<void>(Segment({}, {0, bad, 0})); });
    expect_refused("centre of a sphere", [&] { static_cast<void>(Sphere(1, {0, 0, bad})); });
    expect_refused("start of a capsule", [&] { static_cast<void>(Capsule({bad, 0, 0}, {}, 1)); });
    expect_refused("end of a capsule", [&] { static_cast<void>(Capsule({}, {bad, 0, 0}, 1)); });
    expect_refused("point of a half-space", [&] { static_cast<void>(HalfSpace({bad, 0, 0}, {1, 0, 0})); });
    expect_refused("normal of a half-space", [&] { static_cast<void>(HalfSpace({}, {1, bad, 0})); });
    expect_refused("centre of a box", [&] { static_cast<void>(Box({1, 1, 1}, {0, bad, 0})); });
    expect_refused("vertex of a rounded triangle", [&] {
      static_cast<void>(Rounded(Triangle{{Vec3{}, {bad, 0, 0}, {}}}, 1));
    });
  }
}

TEST(Shapes, SizesMustBePositiveAndFinite) {
  for (const double bad : {0.0, -0.0, -1.0, HUGE_VAL, not_a_number}) {
    expect_refused("radius of a sphere is", [&] { static_cast<void>(Sphere(bad)); });
    expect_refused("radius of a capsule is", [&] { static_cast<void>(Capsule({}, {1, 0, 0}, bad)); });
    expect_refused("radius of a rounded shape is", [&] { static_cast<void>(Rounded(Point{}, bad)); });
    expect_refused("along x is", [&] { static_cast<void>(Box({bad, 1, 1})); });
    expect_refused("along y is", [&] { static_cast<void>(Box({1, bad, 1})); });
    expect_refused("along z is", [&] { static_cast<void>(Box({1, 1, bad})); });
  }
  EXPECT_EQ(Sphere(std::numeric_limits<double>::denorm_min()).radius(), std::numeric_limits<double>::denorm_min());
}

TEST(Shapes, ANormalOfAHalfSpaceMustNotBeZero) {
  expect_refused("normal of a half-space is zero", [] { static_cast<void>(HalfSpace({}, {0, -0.0, 0})); });
}

TEST(Shapes, CornersOfABoxMustBeFiniteAndDiffer) {
  const double most = std::numeric_limits<double>::max();
  expect_refused("along y are", [&] { static_cast<void>(Box({1, 1, 1}, {0, 1e17, 0})); });
  expect_refused("along x are", [&] { static_cast<void>(Box({most, 1, 1}, {most, 0, 0})); });
  EXPECT_EQ(refusal_of([&] { static_cast<void>(Box({most, most, most})); }), "");
  EXPECT_EQ(refusal_of([&] { static_cast<void>(Box({1, 1, 1}, {0x1p53, 0, 0})); }), "");
}

TEST(Shapes, CornersOfABoxAreNumberedByTheirBits) {
  const Box box({1, 2, 3}, {10, 20, 30});
  EXPECT_EQ(box.corner(0), (Vec3{9, 18, 27}));
  EXPECT_EQ(box.corner(1), (Vec3{11, 18, 27}));
  EXPECT_EQ(box.corner(2), (Vec3{9, 22, 27}));
  EXPECT_EQ(box.corner(4), (Vec3{9, 18, 33}));
  EXPECT_EQ(box.corner(7), (Vec3{11, 22, 33}));
}

TEST(HeightField, RefusesWhatIsNoGrid) {
  const std::vector<double> heights(6, 1.0);
  expect_refused("at least two of both", [&] { static_cast<void>(HeightField(1, 6, 1, 1, heights)); });
  expect_refused("at least two of both", [&] { static_cast<void>(HeightField(6, 0, 1, 1, heights)); });
  expect_refused("needs 9 heights", [&] { static_cast<void>(HeightField(3, 3, 1, 1, heights)); });
  expect_refused("cut it up", [&] { static_cast<void>(HeightField(1U << 31U, 2, 1, 1, heights)); });
  expect_refused("along x is 0", [&] { static_cast<void>(HeightField(3, 2, 0, 1, heights)); });
  expect_refused("along y is -1", [&] { static_cast<void>(HeightField(3, 2, 1, -1, heights)); });
  expect_refused("not finite", [&] { static_cast<void>(HeightField(3, 2, 1e308, 1, heights)); });
  std::vector<double> with_bad = heights;
  with_bad[4] = not_a_number;
  expect_refused("column 1, row 1", [&] { static_cast<void>(HeightField(3, 2, 1, 1, with_bad)); });
}

TEST(HeightField, IsTheTrianglesThatItsHeaderSays) {
  const std::vector<double> heights = {0, 1, 2, 3, 4, 5};
  const HeightField field(3, 2, 0.5, 2, heights);
  EXPECT_EQ(field.columns(), 3U);
  EXPECT_EQ(field.rows(), 2U);
  EXPECT_EQ(field.vertex(2, 1), (Vec3{1, 2, 5}));
  const TriangleMesh& mesh = *field.mesh();
  ASSERT_EQ(mesh.triangle_count(), 4U);
  EXPECT_EQ(mesh.triangles()[0], (std::array<Index, 3>{0, 1, 4}));
  EXPECT_EQ(mesh.triangles()[1], (std::array<Index, 3>{0, 4, 3}));
  EXPECT_EQ(mesh.triangles()[2], (std::array<Index, 3>{1, 2, 5}));
  EXPECT_EQ(mesh.face_of(3), 1U);
}

struct DrawnVertex {
  float colour = 0, x = 0, y = 0, z = 0;
};

TEST(TriangleMesh, IsCopiedFromBuffers) {
  const std::vector<DrawnVertex> drawn = {{9, 0, 0, 0}, {9, 1, 0, 0}, {9, 0, 2, 0}, {9, 0, 0, 0.1F}};
  const std::array<std::uint16_t, 6> narrow = {0, 1, 2, 0, 1, 3};
  const TriangleMesh mesh = TriangleMesh::from_buffers({&drawn[0].x, 4, sizeof(DrawnVertex)}, {narrow}, 0.5);
  ASSERT_EQ(mesh.vertices().size(), 4U);
  EXPECT_EQ(mesh.vertices()[2], (Vec3{0, 1, 0}));
  EXPECT_EQ(mesh.vertices()[3].z, 0.5 * static_cast<double>(0.1F));
  EXPECT_EQ(mesh.triangles()[1], (std::array<Index, 3>{0, 1, 3}));
  const std::vector<double> numbers = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<std::uint32_t> wide = {2, 1, 0};
  EXPECT_EQ(TriangleMesh::from_buffers({numbers.data(), 3}, {wide}).triangles()[0], (std::array<Index, 3>{2, 1, 0}));
  EXPECT_EQ(TriangleMesh::from_buffers({numbers.data(), 3}, {wide.data(), 3}).vertices()[1], (Vec3{1, 0, 0}));
}

TEST(TriangleMesh, RefusesBuffersThatAreNoMesh) {
  const std::vector<float> numbers = {0, 0, 0, 1, 0, 0, 0, NAN, 0};
  const std::vector<std::uint32_t> wide = {0, 1, 1, 0, 7, 1, 1};
  const auto made = [&](std::size_t vertices, std::size_t indices, std::size_t stride = 12, double scale = 1) {
    return [&numbers, &wide, vertices, indices, stride, scale] {
      static_cast<void>(TriangleMesh::from_buffers({numbers.data(), vertices, stride}, {wide.data(), indices}, scale));
    };
  };
  expect_refused("vertex 2 ", made(3, 3));
  expect_refused("triangle 1 names vertex 7", made(2, 6));
  expect_refused("triangle 2 has 1 corners", made(2, 7));
  expect_refused("stride of 8 bytes", made(2, 3, 8));
  expect_refused("at least one triangle", made(2, 0));
  expect_refused("scale", made(2, 3, 12, 0));
  const float* none = nullptr;
  expect_refused("2 positions is null", [&] { static_cast<void>(TriangleMesh::from_buffers({none, 2}, {wide})); });
}

TEST(Compound, RefusesNoPartsAndBadPoses) {
  expect_refused("at least one part", [] { static_cast<void>(Compound({})); });
  const std::vector<CompoundPart> moved_away = {{Sphere{1}}, {Sphere{1}, Pose::translation(0, HUGE_VAL, 0)}};
  expect_refused("of part 1", [&] { static_cast<void>(Compound(moved_away)); });
  const std::vector<CompoundPart> null = {{std::shared_ptr<const TriangleMesh>()}};
  expect_refused("null", [&] { static_cast<void>(Compound(null)); });
}

TEST(Compound, KeepsItsPartsInOrder) {
  const std::vector<CompoundPart> inner = {{Box{{1, 2, 3}}}};
  const std::vector<CompoundPart> parts = {{Sphere{1}, Pose::translation(1, 2, 3)}, {Compound(inner)}};
  const Compound compound(parts);
  ASSERT_EQ(compound.parts().size(), 2U);
  EXPECT_EQ(name_of(compound.parts()[0].shape), "sphere");
  EXPECT_EQ(compound.parts()[0].pose, Pose::translation(1, 2, 3));
  EXPECT_EQ(name_of(compound.parts()[1].shape), "compound");
}

TEST(Compound, IsRefusedBeyondAThousandLevels) {
  Shape nested = Sphere(1);
  for (int level = 0; level < most_compound_levels; ++level) nested = Compound({{nested}});
  expect_refused("nested more than 1000 deep", [&] { static_cast<void>(Compound({{Box({1, 1, 1})}, {nested}})); });
  int levels = 0;
  EXPECT_THROW(for (Shape s = Sphere(1); levels < 12000; ++levels) s = Compound({{s}}), Error);
  EXPECT_EQ(levels, most_compound_levels);
}

TEST(Shape, HasAName) {
  EXPECT_EQ(name_of(Point{}), "point");
  EXPECT_EQ(name_of(Segment{{}, {}}), "segment");
  EXPECT_EQ(name_of(Triangle{}), "triangle");
  EXPECT_EQ(name_of(HalfSpace{{}, {1, 0, 0}}), "half-space");
  EXPECT_EQ(name_of(Capsule{{}, {}, 1}), "capsule");
  EXPECT_EQ(name_of(Rounded{Box{{1, 1, 1}}, 1}), "rounded shape");
  EXPECT_EQ(name_of(Cylinder(1, 1)), "cylinder");
  EXPECT_EQ(name_of(Cone(1, 1)), "cone");
  EXPECT_EQ(name_of(Ellipsoid({1, 1, 1})), "ellipsoid");
  EXPECT_EQ(name_of(HeightField{2, 2, 1, 1, std::array<double, 4>{}}), "height field");
  EXPECT_EQ(name_of(std::shared_ptr<const TriangleMesh>()), "mesh");
}

}  // namespace
}  // namespace toccata
