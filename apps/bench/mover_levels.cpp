#include <algorithm>
#include <array>
#include <cmath>

#include "movers.hpp"
#include "single_mesh.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"

namespace toccata::bench {
namespace {

constexpr double length_of_wish = 0.08;

/// A mesh of rectangles that are cut into many triangles.
class CutSurface {
 public:
  CutSurface(double cell, std::uint64_t seed) : cell_(cell), random_(seed) {}

  /// Strips along `side`, whose cuts are at random and do not meet those of the next: T-junctions and slivers.
  void add(const Vec3& corner, const Vec3& side, const Vec3& other) {
    const std::size_t strips = cells_of(other), cells = cells_of(side);
    for (std::size_t strip = 0; strip < strips; ++strip) {
      const auto part = [&](std::size_t i) { return static_cast<double>(i) / static_cast<double>(strips); };
      add_strip(corner + part(strip) * other, corner + part(strip + 1) * other, side, cells);
    }
  }

  /// The sides and the top of a box that stands on z = `low`.
  void add_block(const Vec3& low, const Vec3& high) {
    const Vec3 size = high - low, x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
    add(low, x, z);
    add(low, z, y);
    add(low + y, z, x);
    add(low + x, y, z);
    add(low + z, x, y);
  }

  [[nodiscard]] Model model() && { return Model(TriangleMesh(std::move(vertices_), std::move(triangles_))); }

 private:
  [[nodiscard]] std::size_t cells_of(const Vec3& side) const {
    return static_cast<std::size_t>(std::max(1.0, std::round(length(side) / cell_)));
  }

  std::vector<double> cuts(std::size_t cells) {
    std::vector<double> all{0, 1};
    while (all.size() < cells + 1) all.push_back(random_.unit());
    std::sort(all.begin(), all.end());
    return all;
  }

  void add_strip(const Vec3& low, const Vec3& high, const Vec3& side, std::size_t cells) {
    const std::vector<double> below = cuts(cells), above = cuts(cells);
    const auto first = static_cast<Index>(vertices_.size()), upper = first + static_cast<Index>(below.size());
    for (const double cut : below) vertices_.push_back(low + cut * side);
    for (const double cut : above) vertices_.push_back(high + cut * side);
    Index i = 0, j = 0;
    while (i + 1 < below.size() || j + 1 < above.size()) {
      const bool is_low = j + 1 == above.size() || (i + 1 < below.size() && below[i + 1] < above[j + 1]);
      triangles_.push_back({first + i, is_low ? first + i + 1 : upper + j + 1, upper + j});
      (is_low ? i : j) += 1;
    }
  }

  double cell_;
  Random random_;
  std::vector<Vec3> vertices_;
  std::vector<std::array<Index, 3>> triangles_;
};

SceneInstance as_surface(Model model, const Pose& pose = {}) { return {std::move(model), pose, Solid::none, ""}; }

/// Hills with gentle and steep sides, and small bumps; cells of a quarter.
constexpr double terrain_cell = 0.25;

SceneInstance terrain(std::size_t triangles, std::uint64_t seed) {
  const auto cells = static_cast<Index>(std::round(std::sqrt(static_cast<double>(triangles) / 2)));
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> faces;
  Random random(seed);
  for (Index j = 0; j <= cells; ++j)
    for (Index i = 0; i <= cells; ++i) {
      const double x = terrain_cell * i, y = terrain_cell * j;
      const double hills = 1.5 * std::sin(0.4 * x) * std::cos(0.3 * y);
      vertices.push_back({x, y, hills + 0.15 * random.unit()});
    }
  for (Index j = 0; j < cells; ++j)
    for (Index i = 0; i < cells; ++i) {
      const Index at = j * (cells + 1) + i, above = at + cells + 1;
      faces.push_back({at, at + 1, above + 1});
      faces.push_back({at, above + 1, above});
    }
  return as_surface(Model(TriangleMesh(std::move(vertices), std::move(faces))));
}

double side_of(std::size_t triangles) {
  return terrain_cell * std::round(std::sqrt(static_cast<double>(triangles) / 2));
}

/// Upright boxes, turned at random, about one in four fifths of a unit of area: where people walk in a quarter of the
/// terrain.
void add_crowd(std::vector<SceneInstance>& models, std::size_t triangles, std::uint64_t seed) {
  Random random(seed + 1);
  const double half_side = side_of(triangles) / 2;
  for (std::size_t i = 0; i < triangles / 100; ++i) {
    const Vec3 half{random.between(0.05, 0.3), random.between(0.05, 0.3), random.between(0.3, 3)};
    const double x = random.between(0, half_side), y = random.between(0, half_side);
    models.push_back({Box(half), Pose{rotation_about({0, 0, 1}, random.between(0, 360)), {x, y, 0}}, Solid::automatic,
                      ""});
  }
}

/// Rooms in a square, six by six units each, with doors, and in each a podium of five steps.
constexpr double room_side = 6, wall_height = 3, step_rise = 0.2, step_tread = 0.35;
constexpr int rooms_along = 6;

void add_walls_of_room(CutSurface& surface, const Vec3& corner) {
  constexpr double thickness = 0.2, door = 1.6, wing = (room_side - door) / 2;
  for (const double begin : {0.0, wing + door}) {
    surface.add_block(corner + Vec3{begin, 0, 0}, corner + Vec3{begin + wing, thickness, wall_height});
    surface.add_block(corner + Vec3{0, begin + thickness, 0}, corner + Vec3{thickness, begin + wing, wall_height});
  }
}

void add_podium(CutSurface& surface, const Vec3& corner) {
  for (int i = 0; i < 5; ++i) {
    const double in = 0.9 + i * step_tread, out = room_side - 0.9 - i * step_tread;
    surface.add_block(corner + Vec3{in, in, i * step_rise}, corner + Vec3{out, out, (i + 1) * step_rise});
  }
}

SceneInstance rooms(std::size_t triangles, std::uint64_t seed) {
  // A room has about 190 units of area; a cell of two triangles.
  const double area = 190.0 * rooms_along * rooms_along;
  CutSurface surface(std::sqrt(2 * area / static_cast<double>(triangles)), seed);
  const double side = room_side * rooms_along;
  surface.add({0, 0, 0}, {side, 0, 0}, {0, side, 0});
  for (int i = 0; i < rooms_along; ++i)
    for (int j = 0; j < rooms_along; ++j) {
      const Vec3 corner{room_side * i, room_side * j, 0};
      add_walls_of_room(surface, corner);
      add_podium(surface, corner);
    }
  return as_surface(std::move(surface).model());
}

/// A corridor along x with a plane floor and two plane walls, cut anyhow.
constexpr double corridor_length = 400, corridor_width = 2.4;

SceneInstance corridor(std::size_t triangles, std::uint64_t seed) {
  const double area = corridor_length * (corridor_width + 2 * wall_height);
  CutSurface surface(std::sqrt(2 * area / static_cast<double>(triangles)), seed);
  const Vec3 x{corridor_length, 0, 0}, y{0, corridor_width, 0}, z{0, 0, wall_height};
  surface.add({}, x, y);
  surface.add({}, x, z);
  surface.add(y, x, z);
  return as_surface(std::move(surface).model());
}

/// Where walkers begin.
struct StartArea {
  Vec3 low, high;
};

StartArea start_area(const WalkWork& work, std::size_t triangles) {
  if (work.level == "crowd") return {{1, 1, 20}, {side_of(triangles) / 2 - 1, side_of(triangles) / 2 - 1, 20}};
  const Aabb& box = work.models.front().model.bounds();
  const double share = work.surface == TrueSurface::straight_corridor ? 0.4 : 0.1;
  const Vec3 size = box.upper - box.lower, at = work.models.front().pose.offset;
  StartArea area{at + box.lower, at + box.upper};
  for (const int axis : {0, 1}) {
    const double in = axis == 0 ? share : 0.2;
    area.low[axis] += in * size[axis];
    area.high[axis] -= in * size[axis];
  }
  area.low.z = area.high.z = at.z + box.upper.z + 1;
  return area;
}

/// Just above what is first met from above, where there is room.
Vec3 free_start(const SceneIndex& level, const StartArea& area, Random& random) {
  for (int attempt = 0; attempt < 10000; ++attempt) {
    Vec3 foot{random.between(area.low.x, area.high.x), random.between(area.low.y, area.high.y), area.low.z};
    const auto floor = level.cast_ray({foot, {0, 0, -1000}});
    if (!floor) continue;
    foot.z += -1000 * floor->upper + 0.3;
    if (level.overlapping({walker_model(), Pose::translation(foot)}).empty()) return foot;
  }
  throw Error("mover: nobody finds room to stand in the level; take another --mesh or --scale");
}

/// It turns now and then. In a corridor it keeps to one direction along it, and goes at the walls as often as not.
std::vector<Vec3> wishes_of(TrueSurface surface, std::size_t steps, Random& random) {
  const double ahead = random.below(2) == 0 ? 0 : 180;
  const auto heading = [&] {
    const double degrees =
        surface == TrueSurface::straight_corridor ? ahead + random.between(-60, 60) : random.between(0, 360);
    return rotation_about({0, 0, 1}, degrees) * Vec3{length_of_wish, 0, 0};
  };
  std::vector<Vec3> wishes{heading()};
  while (wishes.size() < steps) wishes.push_back(random.below(30) == 0 ? heading() : wishes.back());
  return wishes;
}

void add_walks(WalkWork& work, const StartArea& area, std::size_t walks, std::size_t steps, std::uint64_t seed) {
  const SceneIndex level(work.models);
  Random random(seed + 2);
  for (std::size_t i = 0; i < walks; ++i) {
    const Vec3 start = free_start(level, area, random);
    work.walks.push_back({start, wishes_of(work.surface, steps, random)});
  }
}

}  // namespace

std::vector<std::string> walk_levels() { return {"terrain", "crowd", "rooms", "seams"}; }

WalkWork walk_work(const std::string& level, std::size_t triangles, std::size_t walks, std::size_t steps,
                   std::uint64_t seed) {
  WalkWork work;
  work.level = level;
  if (level == "rooms") work.models.push_back(rooms(triangles, seed));
  if (level == "seams") {
    work.models.push_back(corridor(triangles, seed));
    work.surface = TrueSurface::straight_corridor;
  }
  if (level == "terrain" || level == "crowd") work.models.push_back(terrain(triangles, seed));
  if (level == "crowd") add_crowd(work.models, triangles, seed);
  add_walks(work, start_area(work, triangles), walks, steps, seed);
  return work;
}

WalkWork walk_work_at(const std::string& file, double scale, std::size_t walks, std::size_t steps, std::uint64_t seed) {
  const auto mesh = single_mesh(file);
  std::vector<Vec3> vertices(mesh->vertices().begin(), mesh->vertices().end());
  for (Vec3& v : vertices) v = scale * v;
  WalkWork work;
  work.level = "mesh";
  work.models.push_back(
      as_surface(Model(TriangleMesh(std::move(vertices), {mesh->triangles().begin(), mesh->triangles().end()}))));
  add_walks(work, start_area(work, 0), walks, steps, seed);
  return work;
}

}  // namespace toccata::bench
