#include "support/deforming_cases.hpp"

#include <cmath>
#include <stdexcept>

#include "support/mesh_soups.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata::test {
namespace {

using TriangleCorners = std::vector<std::array<Index, 3>>;

std::vector<Vec3> copied_vertices(std::span<const Vec3> vertices) { return {vertices.begin(), vertices.end()}; }

template <class Change>
DeformingCase changed_case(const DeformingCase& made, Change change) {
  std::vector<Vec3> start = copied_vertices(made.mesh.vertices()), end = made.end;
  for (Vec3& v : start) v = change(v);
  for (Vec3& v : end) v = change(v);
  return {made.mesh.with_vertices(std::move(start)), std::move(end)};
}

Vec3 whole_position(Random& random, int size) {
  const auto draw = [&] { return static_cast<double>(random.below(2 * static_cast<std::uint64_t>(size) + 1)) - size; };
  const double x = draw(), y = draw();
  return {x, y, draw()};
}

DeformingCase moving_soup(Random& random) {
  TriangleMesh mesh = random_soup(random, 4, 0.8, random.below(2) == 0 ? 0 : 8);
  std::vector<Vec3> end = copied_vertices(mesh.vertices());
  const double size = random.below(2) == 0 ? 0.2 : 1;
  for (Vec3& v : end) v += random_vector(random, size);
  return {std::move(mesh), std::move(end)};
}

DeformingCase moving_grid(Random& random) {
  const auto vertex_count = static_cast<Index>(5 + random.below(5));
  std::vector<Vec3> start, end;
  for (Index i = 0; i < vertex_count; ++i) {
    start.push_back(whole_position(random, 2));
    end.push_back(random.below(3) == 0 ? start.back() : whole_position(random, 2));
  }
  const auto any = [&] { return static_cast<Index>(random.below(vertex_count)); };
  TriangleCorners triangles;
  for (int i = 0; i < 4; ++i) {
    const Index a = any(), b = any();
    triangles.push_back({a, b, any()});
  }
  return {{std::move(start), std::move(triangles)}, std::move(end)};
}

DeformingCase moving_in_plane(Random& random) {
  return changed_case(moving_grid(random), [](const Vec3& v) { return Vec3{v.x, v.y, v.x + 2 * v.y}; });
}

/// The half with x > 1/2 goes over to the other side and down onto or through it; a little noise, or none.
DeformingCase folding_sheet(Random& random) {
  const double noise = random.below(2) == 0 ? 0 : 0.02;
  TriangleMesh flat = square_sheet_mesh(2);
  std::vector<Vec3> start = copied_vertices(flat.vertices()), end;
  const double height = random.below(2) == 0 ? 0.5 : 0.25, depth = random.below(3) == 0 ? 0 : -0.25;
  for (Vec3& v : start) {
    const bool is_over = v.x > 0.5;
    end.push_back(is_over ? Vec3{1 - v.x, v.y, depth} + random_vector(random, noise) : v);
    if (is_over) v = {1 - v.x, v.y, height * v.x};
    v += random_vector(random, noise);
  }
  return {flat.with_vertices(std::move(start)), std::move(end)};
}

/// The first corner of one triangle meets the other's face, its edge or a corner: all are whole numbers.
DeformingCase planted_corner(Random& random) {
  const int size = 1 << (1 + random.below(16));
  const Vec3 a = whole_position(random, size), u = 4 * whole_position(random, size),
             v = 4 * whole_position(random, size);
  const double i = static_cast<double>(random.below(5)),
               j = static_cast<double>(random.below(5 - static_cast<std::uint64_t>(i)));
  const Vec3 met = a + (i / 4) * u + (j / 4) * v;
  std::vector<Vec3> start{
      whole_position(random, size), whole_position(random, size), whole_position(random, size), a, a + u, a + v};
  std::vector<Vec3> end = start;
  const double times = std::array<double, 3>{1, 2, 4}[random.below(3)];
  end[0] = start[0] + times * (met - start[0]);
  for (const std::size_t k : {1U, 2U}) end[k] = whole_position(random, size);
  return {{std::move(start), {{0, 1, 2}, {3, 4, 5}, {4, 3, 1}}}, std::move(end)};
}

DeformingCase corner_beside(Random& random) {
  DeformingCase made = planted_corner(random);
  Vec3& moved = made.end[random.below(made.end.size())];
  double& coordinate = moved[static_cast<int>(random.below(3))];
  coordinate = std::nextafter(coordinate, random.below(2) == 0 ? HUGE_VAL : -HUGE_VAL);
  return made;
}

DeformingCase any_deforming_case(Random& random) {
  constexpr std::array kinds{moving_soup, moving_grid, moving_in_plane, folding_sheet, planted_corner};
  return kinds[random.below(kinds.size())](random);
}

DeformingCase resting_case(Random& random) {
  DeformingCase made = any_deforming_case(random);
  made.end = copied_vertices(made.mesh.vertices());
  return made;
}

DeformingCase scaled_soup(Random& random, int exponent) {
  return changed_case(moving_soup(random), [&](const Vec3& v) { return std::ldexp(1.0, exponent) * v; });
}

DeformingCase far_case(Random& random) {
  const Vec3 there = 1e12 * whole_position(random, 1);
  return changed_case(any_deforming_case(random), [&](const Vec3& v) { return v + there; });
}

struct DeformingFamily {
  std::string name;
  DeformingCase (*draw)(Random&);
};

const std::vector<DeformingFamily>& deforming_draws() {
  static const std::vector<DeformingFamily> all{{"soup", moving_soup},
                                                {"grid", moving_grid},
                                                {"plane", moving_in_plane},
                                                {"fold", folding_sheet},
                                                {"planted", planted_corner},
                                                {"beside-planted", corner_beside},
                                                {"rest", resting_case},
                                                {"tiny", [](Random& random) { return scaled_soup(random, -1000); }},
                                                {"huge", [](Random& random) { return scaled_soup(random, 1000); }},
                                                {"far", far_case}};
  return all;
}

}  // namespace

const std::vector<std::string>& deforming_families() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const DeformingFamily& family : deforming_draws()) list.push_back(family.name);
    return list;
  }();
  return names;
}

DeformingCase random_deforming_case(const std::string& family, Random& random) {
  for (const DeformingFamily& known : deforming_draws())
    if (known.name == family) return known.draw(random);
  throw std::invalid_argument("there is no family of deforming meshes '" + family + "'");
}

TriangleMesh square_sheet_mesh(int cells) {
  const TriangleMesh sheet = height_field_mesh({.cells_x = cells, .cells_y = cells, .cell = 1.0 / cells, .height = 0});
  std::vector<Vec3> vertices = copied_vertices(sheet.vertices());
  for (Vec3& v : vertices) v += Vec3{0.5, 0.5, 0};
  return sheet.with_vertices(std::move(vertices));
}

}  // namespace toccata::test
