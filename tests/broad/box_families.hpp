#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/random.hpp"

namespace toccata::test {

/// Kinds of boxes that broad phases get wrong, or find hard.
inline constexpr std::array box_families{
    std::string_view("uniform"), std::string_view("sizes"),    std::string_view("equal"),
    std::string_view("nested"),  std::string_view("plane"),    std::string_view("line"),
    std::string_view("giant"),   std::string_view("lattice"),  std::string_view("touching"),
    std::string_view("points"),  std::string_view("denormal"), std::string_view("far"),
    std::string_view("huge"),    std::string_view("clusters"), std::string_view("infinite"),
    std::string_view("decades"), std::string_view("columns"),  std::string_view("last-place")};

inline Aabb box_around_point(const Vec3& centre, const Vec3& half) { return {centre - half, centre + half}; }

inline Vec3 vector_between(Random& random, double low, double high) {
  const double x = random.between(low, high), y = random.between(low, high), z = random.between(low, high);
  return {x, y, z};
}

/// Box `i` of a family; with the same i, boxes of different seeds have little to do with each other.
inline Aabb random_box(std::string_view family, std::size_t i, Random& random) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto step = [&](std::uint64_t count) { return static_cast<double>(random.below(count)); };
  if (family == "uniform") return box_around_point(vector_between(random, 0, 6), vector_between(random, 0.2, 0.6));
  if (family == "sizes")
    return box_around_point(vector_between(random, 0, 6),
                            std::pow(10, random.between(-3, 0)) * vector_between(random, 0.5, 1));
  if (family == "equal") return {{1, 2, 3}, {4, 5, 6}};
  if (family == "nested") {
    const double half = 1 + step(50);
    return {{-half, -half, -half}, {half, half, half}};
  }
  if (family == "plane") {
    const Vec3 centre = vector_between(random, 0, 8), half = vector_between(random, 0.1, 0.5);
    return {{centre.x - half.x, centre.y - half.y, 7}, {centre.x + half.x, centre.y + half.y, 7}};
  }
  if (family == "line") {
    const double at = random.between(0, 50);
    return {{at, -1, -1}, {at + random.between(0, 1), -1, -1}};
  }
  if (family == "giant" && i % 97 == 3) return {{-100, -100, -100}, {100, 100, 100}};
  if (family == "giant") return box_around_point(vector_between(random, -90, 90), {0.5, 0.5, 0.5});
  if (family == "lattice") {
    const Vec3 lower{step(5), step(5), step(5)};
    return {lower, lower + Vec3{step(3), step(3), step(3)}};
  }
  if (family == "touching") {
    const Vec3 lower{step(9), step(9), step(9)};
    return {lower, lower + Vec3{1, 1, 1}};
  }
  if (family == "points") {
    const Vec3 at{step(4), step(4), step(4)};
    return {at, at};
  }
  if (family == "denormal") {
    constexpr double least = std::numeric_limits<double>::denorm_min();
    const Vec3 lower{least * step(20), least * step(20), least * step(20)};
    return {lower, lower + Vec3{least * step(6), least * step(6), least * step(6)}};
  }
  if (family == "far") {
    const Vec3 lower{1e15 + step(12), -1e15 + step(12), 1e15 + step(12)};
    return {lower, lower + Vec3{step(4), step(4), step(4)}};
  }
  if (family == "huge") {
    const double side = random.between(-1, 1) * 1.7e308, other = random.between(-1, 1) * 1.7e308;
    const double x = step(3), y = step(3);
    return {{std::min(side, other), x, -1e308 * y}, {std::max(side, other), x + 1, 1e308 * y}};
  }
  if (family == "clusters") {
    const double cluster = 1000 * step(4);
    return box_around_point(Vec3{cluster, -cluster, 0} + vector_between(random, 0, 3), {0.3, 0.3, 0.3});
  }
  if (family == "infinite" && i % 11 == 2) return {{-infinity, -infinity, -infinity}, {infinity, infinity, step(6)}};
  if (family == "infinite" && i % 11 == 5) return {{step(6), step(6), -infinity}, {infinity, infinity, infinity}};
  if (family == "infinite") return box_around_point(vector_between(random, 0, 6), vector_between(random, 0.2, 0.6));
  if (family == "decades") {
    const double size = std::pow(10, random.between(-12, 12));
    return box_around_point(random.between(0, 10) * size * vector_between(random, -1, 1), {size, size, size});
  }
  if (family == "columns") return box_around_point({step(6), step(6), random.between(0, 9)}, {0.1, 0.1, 3});
  // Corners that differ by a last place of doubles, where floats see no difference.
  const auto nearly = [&](double value) { return value * (1 + step(3) * 0x1p-52); };
  const double x = 1 + step(4), y = 1 + step(4), z = 1 + step(4);
  return {{nearly(x), nearly(y), nearly(z)}, {nearly(x + 1), nearly(y + 1), nearly(z + 1)}};
}

inline std::vector<Aabb> random_boxes(std::string_view family, std::size_t count, Random& random) {
  std::vector<Aabb> boxes;
  boxes.reserve(count);
  while (boxes.size() < count) boxes.push_back(random_box(family, boxes.size(), random));
  return boxes;
}

}  // namespace toccata::test
