#include "narrow/triangles/triangle_pair_block.hpp"

#include <utility>

#include "narrow/triangles/triangle_features.hpp"

namespace toccata {
namespace {

Triangle triangle_in(const TrianglePairBlock::Corners& corners, std::size_t lane) {
  const auto corner = [&](std::size_t i) -> Vec3 {
    return {corners[i][0][lane], corners[i][1][lane], corners[i][2][lane]};
  };
  return {{corner(0), corner(1), corner(2)}};
}

void put(TrianglePairBlock::Corners& corners, std::size_t lane, const Triangle& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i][0][lane] = t.vertex[i].x;
    corners[i][1][lane] = t.vertex[i].y;
    corners[i][2][lane] = t.vertex[i].z;
  }
}

constexpr bool is_above(unsigned sides, int corner) { return ((sides >> corner) & 1U) != 0; }

/// The edge along which the boundary goes from below to above the other plane: there the triangle's interval starts
/// (`plane_interval`). `sides` has bit i set when corner i is above, and is neither 0 nor 7.
constexpr Feature rising_edge(unsigned sides) {
  for (int i = 0; i < 3; ++i)
    if (!is_above(sides, i) && is_above(sides, (i + 1) % 3)) return edge_feature(i);
  return face_feature();
}

constexpr Feature falling_edge(unsigned sides) { return rising_edge(~sides & 7U); }

/// The meeting of two triangles that cross and have no corner in the other's plane, by a lane's bits of `signs`.
constexpr Intersection crossing_intersection(unsigned code) {
  const unsigned sides_a = code & 7U, sides_b = (code >> 3U) & 7U;
  // Along L the interval of b comes end first (`intersection_of_intervals`).
  IntersectionPoint first = (code & 64U) != 0 ? IntersectionPoint{face_feature(), falling_edge(sides_b)}
                                              : IntersectionPoint{rising_edge(sides_a), face_feature()};
  IntersectionPoint last = (code & 128U) != 0 ? IntersectionPoint{face_feature(), rising_edge(sides_b)}
                                              : IntersectionPoint{falling_edge(sides_a), face_feature()};
  if (last < first) std::swap(first, last);
  Intersection m;
  m.kind = IntersectionKind::segment;
  m.crossing = true;
  m.on_a = m.on_b = face_feature();
  m.count = 2;
  m.points[0] = first;
  m.points[1] = last;
  return m;
}

constexpr std::array<Intersection, 256> all_crossing_intersections() {
  std::array<Intersection, 256> intersections{};
  for (unsigned code = 0; code < intersections.size(); ++code) intersections[code] = crossing_intersection(code);
  return intersections;
}

constexpr std::array<Intersection, 256> crossing_intersections = all_crossing_intersections();

/// Bit i is bit `lane` of byte i.
constexpr unsigned column(std::uint64_t bytes, std::size_t lane) {
  // The product moves bit 8i to 56 + i, and nothing else there: no two of its terms meet in one bit.
  return static_cast<unsigned>((((bytes >> lane) & 0x0101010101010101U) * 0x0102040810204080U) >> 56U);
}

}  // namespace

Triangle triangle_a(const TrianglePairBlock& block, std::size_t lane) { return triangle_in(block.a, lane); }
Triangle triangle_b(const TrianglePairBlock& block, std::size_t lane) { return triangle_in(block.b, lane); }

void set_pair(TrianglePairBlock& block, std::size_t lane, const Triangle& a, const Triangle& b) {
  put(block.a, lane, a);
  put(block.b, lane, b);
}

const Intersection& intersection_in(const TrianglePairBlock& block, std::size_t lane) {
  return crossing_intersections[column(block.signs, lane)];
}

}  // namespace toccata
