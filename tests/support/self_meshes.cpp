#include "support/self_meshes.hpp"

#include <cmath>

#include "support/mesh_soups.hpp"

namespace toccata::test {
namespace {

using Corners = std::vector<std::array<Index, 3>>;

Index below(Random& random, std::size_t bound) { return static_cast<Index>(random.below(bound)); }

/// Any three of a few points with small whole coordinates, some of which coincide.
TriangleMesh grid_mesh(Random& random) {
  const std::uint64_t side = 2 + random.below(3);
  const bool flat = random.below(4) == 0;
  std::vector<Vec3> points(4 + random.below(5));
  for (Vec3& p : points)
    p = {static_cast<double>(random.below(side)), static_cast<double>(random.below(side)),
         flat ? 0.0 : static_cast<double>(random.below(side))};
  Corners corners(3 + random.below(8));
  for (auto& triangle : corners)
    for (Index& corner : triangle) corner = below(random, points.size());
  return {std::move(points), std::move(corners)};
}

/// A sheet of 3 × 2 cells, folded at a line, with heights that are whole, noisy or zero.
TriangleMesh sheet_mesh(Random& random) {
  constexpr Index columns = 4, rows = 3;
  const double fold = 0.5 * static_cast<double>(random.below(7)), noise = random.below(2) == 0 ? 0 : 0.5;
  const double whole = random.below(2) == 0 ? 0 : 1;
  std::vector<Vec3> points;
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const double step = whole * static_cast<double>(random.below(2));
      points.push_back({std::abs(i - fold), static_cast<double>(j), step + noise * random.between(-1, 1)});
    }
  Corners corners;
  for (Index j = 0; j + 1 < rows; ++j)
    for (Index i = 0; i + 1 < columns; ++i) {
      const Index corner = j * columns + i;
      corners.push_back({corner, corner + 1, corner + columns + 1});
      corners.push_back({corner, corner + columns + 1, corner + columns});
    }
  return {std::move(points), std::move(corners)};
}

/// A strip in a plane that turns back now and then.
TriangleMesh strip_mesh(Random& random) {
  std::vector<Vec3> points;
  double x = 0, step = 1;
  for (Index i = 0; i < 10; ++i) {
    points.push_back({x, static_cast<double>(i % 2), 0});
    if (random.below(3) == 0) step = -step;
    x += 0.5 * step * static_cast<double>(1 + random.below(2));
  }
  Corners corners;
  for (Index i = 0; i + 2 < points.size(); ++i) corners.push_back({i, i + 1, i + 2});
  return {std::move(points), std::move(corners)};
}

/// Long thin triangles around a hub, with a few more between their ends.
TriangleMesh needle_mesh(Random& random) {
  const auto small = [&] {
    const int exponent = -static_cast<int>(random.below(52));
    return std::ldexp(random.between(-1, 1), exponent);
  };
  std::vector<Vec3> points{{small(), small(), small()}};
  for (Index i = 0; i < 8; ++i) points.push_back({random.below(3) == 0 ? -100.0 : 100.0, small(), small()});
  Corners corners;
  for (Index i = 1; i + 1 < points.size(); ++i) corners.push_back({0, i, i + 1});
  for (Index i = 0; i < 3; ++i) corners.push_back({1 + below(random, 8), 1 + below(random, 8), 1 + below(random, 8)});
  return {std::move(points), std::move(corners)};
}

TriangleMesh with_duplicates(const TriangleMesh& mesh, Random& random) {
  Corners corners(mesh.triangles().begin(), mesh.triangles().end());
  for (std::uint64_t i = 1 + random.below(3); i > 0; --i) {
    std::array<Index, 3> again = corners[random.below(corners.size())];
    std::swap(again[0], again[random.below(3)]);
    corners.insert(corners.begin() + static_cast<std::ptrdiff_t>(random.below(corners.size())), again);
  }
  return {std::vector<Vec3>(mesh.vertices().begin(), mesh.vertices().end()), std::move(corners)};
}

TriangleMesh any_mesh(Random& random) {
  switch (random.below(4)) {
    case 0:
      return grid_mesh(random);
    case 1:
      return sheet_mesh(random);
    case 2:
      return strip_mesh(random);
    default:
      return needle_mesh(random);
  }
}

Pose any_pose(Random& random) {
  const auto& families = pose_families();
  return random_poses(families[random.below(families.size())], random).pose_a;
}

SelfMesh mesh_of(const std::string& family, Random& random) {
  if (family == "grid") return {grid_mesh(random), {}};
  if (family == "sheets") return {sheet_mesh(random), any_pose(random)};
  if (family == "strips") return {strip_mesh(random), random.below(2) == 0 ? Pose{} : any_pose(random)};
  if (family == "needles") return {needle_mesh(random), {}};
  if (family == "duplicates") return {with_duplicates(any_mesh(random), random), {}};
  if (family == "soups") return {random_soup(random, 12, 0.4, random.below(2) == 0 ? 0 : 4), any_pose(random)};
  if (family == "tiny") return {any_mesh(random), scaled(Pose{}, 1e-300)};
  if (family == "huge") return {any_mesh(random), scaled(Pose{}, 1e305)};
  Pose far = any_pose(random);
  far.offset = {1e15, -1e15, 3e14};
  return {any_mesh(random), far};
}

}  // namespace

const std::vector<std::string>& self_mesh_families() {
  static const std::vector<std::string> families{"grid",  "sheets", "strips", "needles", "duplicates",
                                                 "soups", "tiny",   "huge",   "far"};
  return families;
}

SelfMesh random_self_mesh(const std::string& family, Random& random) {
  SelfMesh made = mesh_of(family, random);
  if (random.below(2) == 0) made.mesh = unwelded(made.mesh);
  return made;
}

TriangleMesh unwelded(const TriangleMesh& mesh) {
  std::vector<Vec3> vertices;
  Corners corners;
  for (const auto& triangle : mesh.triangles()) {
    const auto first = static_cast<Index>(vertices.size());
    for (const Index corner : triangle) vertices.push_back(mesh.vertices()[corner]);
    corners.push_back({first, first + 1, first + 2});
  }
  return {std::move(vertices), std::move(corners)};
}

}  // namespace toccata::test
