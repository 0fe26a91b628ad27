#include "support/mover_levels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/data.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/io/model_file.hpp"

namespace toccata::test {
namespace {

SceneInstance placed(Model model, const Pose& pose = {}) { return {std::move(model), pose}; }

Vec3 level_direction(Random& random) {
  const double angle = random.between(-std::numbers::pi, std::numbers::pi);
  return {std::cos(angle), std::sin(angle), 0};
}

void add_floor(std::vector<SceneInstance>& models, double half, Random& random) {
  models.push_back(placed(Model(seamed_rectangle({-half, -half, 0}, {2 * half, 0, 0}, {0, 2 * half, 0}, random))));
}

void add_room(std::vector<SceneInstance>& models, double half, double height, Random& random) {
  const Vec3 x{2 * half, 0, 0}, y{0, 2 * half, 0}, z{0, 0, height}, low{-half, -half, 0}, high{half, half, height};
  add_floor(models, half, random);
  models.push_back(placed(Model(seamed_rectangle(low + z, x, y, random))));
  models.push_back(placed(Model(seamed_rectangle(low, x, z, random))));
  models.push_back(placed(Model(seamed_rectangle(low, y, z, random))));
  models.push_back(placed(Model(seamed_rectangle(high, -x, -z, random))));
  models.push_back(placed(Model(seamed_rectangle(high, -y, -z, random))));
}

Model plain_shape(Random& random, double size) {
  switch (random.below(6)) {
    case 0:
      return Sphere(size);
    case 1:
      return Cylinder(size, size);
    case 2:
      return Cone(size, 2 * size);
    case 3:
      return Ellipsoid({size, 2 * size, size / 2});
    case 4:
      return Capsule({}, {size, size, size}, size / 2);
    default:
      return Box({size, size / 2, size});
  }
}

void add_stairs(std::vector<SceneInstance>& models, Random& random) {
  const double height = random.between(0.05, 0.29), depth = random.between(0.25, 0.6);
  const bool is_one_mesh = random.below(2) == 0;
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto first = static_cast<Index>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c, d});
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
  };
  for (int i = 0; i < 12; ++i) {
    const double front = i * depth, back = i == 11 ? front + 8 : front + depth, top = (i + 1) * height;
    if (is_one_mesh) {
      quad({front, -2, top - height}, {front, 2, top - height}, {front, 2, top}, {front, -2, top});
      quad({front, -2, top}, {front, 2, top}, {back, 2, top}, {back, -2, top});
    } else {
      models.push_back(
          placed(Box({(back - front) / 2, 2, top / 2}), Pose::translation((front + back) / 2, 0, top / 2)));
    }
  }
  if (is_one_mesh) models.push_back(placed(Model(TriangleMesh(vertices, triangles))));
}

HeightField random_terrain(Random& random) {
  constexpr Index count = 33;
  std::vector<double> heights;
  const double roughness = random.between(0, 0.6);
  for (Index j = 0; j < count; ++j)
    for (Index i = 0; i < count; ++i)
      heights.push_back(2 * std::sin(0.3 * i) * std::cos(0.2 * j) + roughness * random.unit());
  return {count, count, 0.8, 0.8, heights};
}

void add_wedges(std::vector<SceneInstance>& models, Random& random) {
  for (int i = 0; i < 6; ++i) {
    const Vec3 tip = random_vector(random, 3) + Vec3{0, 0, 2};
    const Vec3 a = level_direction(random);
    const double angle = random.between(0.05, 1);
    const Vec3 b = std::cos(angle) * a + std::sin(angle) * Vec3{-a.y, a.x, 0};
    const Vec3 lean = random_vector(random, 1) + Vec3{0, 0, 3};
    models.push_back(placed(Model(seamed_rectangle(tip - lean, 5.0 * a, 2.0 * lean, random))));
    models.push_back(placed(Model(seamed_rectangle(tip - lean, 5.0 * b, 2.0 * lean, random))));
  }
}

void add_shapes(std::vector<SceneInstance>& models, Random& random) {
  models.push_back(placed(HalfSpace({}, {0, 0, 1})));
  for (int i = 0; i < 20; ++i) {
    const Vec3 at = random_vector(random, 6);
    models.push_back(placed(plain_shape(random, random.between(0.1, 0.8)),
                            Pose{random_rotation(random), {at.x, at.y, std::abs(at.z) / 6}}));
  }
  const Compound gate({{Box({0.1, 0.1, 1}), Pose::translation(0, 1, 1)},
                       {Box({0.1, 0.1, 1}), Pose::translation(0, -1, 1)},
                       {Box({0.1, 1.2, 0.1}), Pose::translation(0, 0, 2.2)}});
  models.push_back(placed(Model(gate)));
}

void fill(std::string_view family, std::vector<SceneInstance>& models, MoverLevelCase& made, Random& random) {
  if (family == "flat" || family == "wedge") add_floor(models, 10, random);
  if (family == "wedge") add_wedges(models, random);
  if (family == "shapes") add_shapes(models, random);
  if (family == "soup") models.push_back(placed(Model(random_soup(random, 300, 0.2, 0)), toccata::scaled(Pose{}, 8)));
  if (family == "terrain") models.push_back(placed(Model(random_terrain(random)), Pose::translation(-12, -12, 0)));
  if (family == "stairs") {
    add_floor(models, 10, random);
    add_stairs(models, random);
  }
  if (family != "room") return;
  add_room(models, 6, 4, random);
  made.lower = {-6, -6, 0};
  made.upper = {6, 6, 4};
  for (int i = 0; i < 12; ++i) {
    const Vec3 at = random_vector(random, 5);
    const Vec3 half{random.between(0.1, 1), random.between(0.1, 1), random.between(0.02, 0.6)};
    const Pose pose{rotation_about({random.between(-0.4, 0.4), random.between(-0.4, 0.4), 1}, random.between(0, 360)),
                    {at.x, at.y, 0}};
    if (random.below(2) == 0)
      models.push_back(placed(Model(box_mesh(half)), pose));
    else
      models.push_back(placed(Box(half), pose));
  }
}

}  // namespace

TriangleMesh seamed_rectangle(const Vec3& corner, const Vec3& side, const Vec3& other, Random& random) {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  const int strips = static_cast<int>(2 + random.below(8));
  for (int strip = 0; strip < strips; ++strip) {
    const Vec3 low = corner + (static_cast<double>(strip) / strips) * other;
    const Vec3 high = corner + (static_cast<double>(strip + 1) / strips) * other;
    // Cuts of both sides of the strip, ascending; now and then two that are nearly one.
    std::array<std::vector<double>, 2> cuts;
    for (auto& of_side : cuts) {
      of_side = {0, 1};
      for (std::uint64_t i = 0; i < 1 + random.below(6); ++i) of_side.push_back(random.unit());
      of_side.push_back(std::min(1.0, of_side.back() + 1e-7));
      std::sort(of_side.begin(), of_side.end());
    }
    const auto first = static_cast<Index>(vertices.size());
    const auto upper = static_cast<Index>(first + cuts[0].size());
    for (const double cut : cuts[0]) vertices.push_back(low + cut * side);
    for (const double cut : cuts[1]) vertices.push_back(high + cut * side);
    Index i = 0, j = 0;
    while (i + 1 < cuts[0].size() || j + 1 < cuts[1].size()) {
      const bool along_low = j + 1 == cuts[1].size() || (i + 1 < cuts[0].size() && random.below(2) == 0);
      triangles.push_back({first + i, along_low ? first + i + 1 : upper + j + 1, upper + j});
      (along_low ? i : j) += 1;
    }
  }
  return {vertices, triangles};
}

MoverLevelCase random_level(std::string_view family, Random& random) {
  MoverLevelCase made;
  std::vector<SceneInstance> models;
  if (family == "env") {
    const auto data = data_folder();
    if (data) models.push_back(placed(load_model((*data / "meshes/env.obj").string()), toccata::scaled(Pose{}, 0.02)));
  } else {
    fill(family, models, made, random);
  }
  made.level = SceneIndex(models);
  Vec3 low{-5, -5, 0.05}, high{5, 5, 2};
  if (family == "soup") low = {-1, -1, -1}, high = {9, 9, 9};
  if (family == "env" && !models.empty()) {
    const Aabb& box = models[0].model.bounds();
    low = 0.02 * box.lower;
    high = 0.02 * box.upper;
  }
  for (int i = 0; i < 8; ++i)
    made.starts.push_back(
        {random.between(low.x, high.x), random.between(low.y, high.y), random.between(low.z, high.z)});
  return made;
}

Model random_character(Random& random) {
  const double radius = random.between(0.1, 0.5), height = random.between(0, 1.2);
  switch (random.below(7)) {
    case 0:
      return Sphere(radius, {0, 0, radius});
    case 1:
      return Box({radius, radius, height / 2 + 0.1}, {0, 0, height / 2 + 0.1});
    case 2:
      return Rounded(Box({radius, radius, height / 2 + 0.1}, {0, 0, height / 2 + 0.2}), 0.1);
    case 3:
      return ConvexHull({{0, 0, 0}, {radius, 0, 0.4}, {-radius, radius, 0.5}, {0, -radius, 0.3}, {0, 0, 1.2}});
    default:
      return Capsule({0, 0, radius}, {0, 0, radius + height}, radius);
  }
}

}  // namespace toccata::test
