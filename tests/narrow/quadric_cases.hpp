#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "oracle/quadrics.hpp"
#include "support/convex_cases.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/narrow/quadrics.hpp"

// Pairs of a quadric and any other, in regimes that are hard in a way of their own.
namespace toccata::test {

using QuadricShape = QuadricShapes::put_into<std::variant>;

/// For each kind: what the oracle calls the set, and the shape that is made of half axes, of which it may have fewer.
template <class S>
struct QuadricTruth;
template <>
struct QuadricTruth<Cylinder> {
  static constexpr oracle::FineKind kind = oracle::FineKind::cylinder;
  static Cylinder made(const Vec3& half) { return {half.x, half.z}; }
};
template <>
struct QuadricTruth<Cone> {
  static constexpr oracle::FineKind kind = oracle::FineKind::cone;
  static Cone made(const Vec3& half) { return {half.x, half.z}; }
};
template <>
struct QuadricTruth<Ellipsoid> {
  static constexpr oracle::FineKind kind = oracle::FineKind::ellipsoid;
  static Ellipsoid made(const Vec3& half) { return Ellipsoid(half); }
};

struct PlacedQuadric {
  QuadricShape shape;
  Pose pose;
};

inline PosedQuadric posed(const PlacedQuadric& placed) {
  return std::visit([&](const auto& shape) { return PosedQuadric(shape, placed.pose); }, placed.shape);
}

inline oracle::FineSet fine_set(const PlacedQuadric& placed) {
  const PosedQuadric seen = posed(placed);
  const oracle::FineKind kind = std::visit([]<class S>(const S&) { return QuadricTruth<S>::kind; }, placed.shape);
  return oracle::quadric_set(kind, seen.half(), placed.pose);
}

inline oracle::FineSet fine_set(const PlacedPolytope& placed) {
  const PosedPolytope seen = posed(placed);
  std::vector<Vec3> vertices;
  for (Index i = 0; i < seen.vertex_count(); ++i) vertices.push_back(seen.vertex(i));
  return oracle::hull_set_of(vertices, seen.radius());
}

/// A quadric and another one, which is a quadric or not.
struct QuadricCase {
  PlacedQuadric a;
  std::variant<PlacedQuadric, PlacedPolytope> b;

  [[nodiscard]] Pose& pose_of_b() {
    return std::visit([](auto& placed) -> Pose& { return placed.pose; }, b);
  }
};

inline const std::vector<std::string>& quadric_kinds() {
  static const auto names = QuadricShapes::of_each([]<class S>(std::type_identity<S>) { return std::string(S::name); });
  static const std::vector<std::string> kinds(names.begin(), names.end());
  return kinds;
}

/// The kinds that the other shape may have.
inline std::vector<std::string> quadric_other_kinds() {
  std::vector<std::string> kinds = quadric_kinds();
  for (const char* kind : {"point", "segment", "triangle", "box", "hull", "sphere", "capsule", "rounded-box"})
    kinds.emplace_back(kind);
  return kinds;
}

/// far; near; close (a gap or an overlap of 1e-6 to 1e-14 of the size); deep; aligned (turned by right angles, on a
/// grid: faces, rims and axes in parallel); affine; needle and flat (half axes that differ by up to 1e6); distant;
/// tiny; huge.
inline const std::vector<std::string>& quadric_regimes() {
  static const std::vector<std::string> regimes{"far",    "near", "close",   "deep", "aligned", "affine",
                                                "needle", "flat", "distant", "tiny", "huge"};
  return regimes;
}

inline Vec3 quadric_half_axes(const std::string& regime, Random& random) {
  const auto length = [&] { return std::pow(10.0, random.between(-1, 0.5)); };
  Vec3 half{length(), length(), length()};
  const double slim = std::pow(10.0, random.between(-6, -2));
  if (regime == "needle") half = {half.x * slim, half.y * slim, half.z};
  if (regime == "flat") half.z *= slim;
  if (regime == "aligned")
    half = {1.0 + double(random.below(3)), 1.0 + double(random.below(3)), 1.0 + double(random.below(3))};
  return half;
}

inline QuadricShape quadric_shape(const std::string& kind, const Vec3& half) {
  const auto all = QuadricShapes::of_each(
      [&half]<class S>(std::type_identity<S>) { return QuadricShape(QuadricTruth<S>::made(half)); });
  const auto is_it = [&kind](const QuadricShape& shape) {
    return kind == std::visit([]<class S>(const S&) { return S::name; }, shape);
  };
  return *std::ranges::find_if(all, is_it);
}

inline Vec3 quadric_direction(Random& random) {
  for (;;) {
    const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    const double squared = x * x + y * y + z * z;
    if (squared > 0.01 && squared < 1) return (1 / std::sqrt(squared)) * Vec3{x, y, z};
  }
}

inline Mat3 quadric_linear(const std::string& regime, Random& random) {
  Mat3 linear = rotation_about(quadric_direction(random), random.between(-180, 180));
  if (regime == "aligned") {
    const int turn = static_cast<int>(random.below(3));
    linear = {};
    for (int i = 0; i < 3; ++i) {
      linear[i] = {0, 0, 0};
      linear[i][(i + turn) % 3] = random.below(2) == 0 ? 1 : -1;
    }
  }
  if (regime == "affine")
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) linear[i][j] += random.between(-0.3, 0.3);
  return linear;
}

/// Moves B until the gap is about this, or the overlap where it is negative.
inline void leave_quadric_gap(QuadricCase& pair, double gap) {
  const auto measured = [&pair] {
    return std::visit([&](const auto& other) { return distance(posed(pair.a), posed(other)); }, pair.b);
  };
  for (int i = 0; i < 3; ++i) {
    const Distance now = measured();
    if (!(now.upper > 0)) return;
    const Vec3 way = now.on_b - now.on_a;
    const double length = std::sqrt(dot(way, way));
    if (!(length > 0)) return;
    pair.pose_of_b().offset = pair.pose_of_b().offset - ((length - gap) / length) * way;
    if (gap <= 0) return;
  }
}

inline bool is_plain_kind(const std::string& kind) { return std::ranges::count(quadric_kinds(), kind) > 0; }

inline void resize(QuadricCase& pair, double factor) {
  const auto scale = [factor](Pose& pose) { pose = {scaled(pose, factor).linear, factor * pose.offset}; };
  scale(pair.a.pose);
  if (auto* quadric = std::get_if<PlacedQuadric>(&pair.b)) scale(quadric->pose);
}

inline QuadricCase quadric_case(const std::string& kind_a, const std::string& kind_b, const std::string& regime,
                                Random& random) {
  QuadricCase pair{{quadric_shape(kind_a, quadric_half_axes(regime, random)), {quadric_linear(regime, random), {}}},
                   PlacedPolytope{Point({0, 0, 0}), {}}};
  const std::string plain = regime == "affine" ? "far" : regime;
  if (is_plain_kind(kind_b))
    pair.b =
        PlacedQuadric{quadric_shape(kind_b, quadric_half_axes(regime, random)), {quadric_linear(regime, random), {}}};
  else if (regime == "aligned" && kind_b == "box")
    pair.b = PlacedPolytope{Box({1.0 + double(random.below(3)), 1, 2}), {}};
  else
    pair.b = PlacedPolytope{random_convex(kind_b, random), {quadric_linear(plain, random), {}}};
  if (regime == "deep") {
    pair.pose_of_b().offset = random.between(0, 0.5) * quadric_direction(random);
    return pair;
  }
  if (regime == "aligned") {
    for (int i = 0; i < 3; ++i) pair.pose_of_b().offset[i] = double(random.below(9)) - 4;
    return pair;
  }
  pair.pose_of_b().offset = random.between(8, 12) * quadric_direction(random);
  const double sign = random.below(2) == 0 ? -1 : 1;
  if (regime == "near" || regime == "affine") leave_quadric_gap(pair, sign * random.between(0.001, 0.05));
  if (regime == "close" || regime == "needle" || regime == "flat")
    leave_quadric_gap(pair, sign * std::pow(10.0, random.between(-14, regime == "close" ? -6 : -1)));
  if (regime == "distant") {
    leave_quadric_gap(pair, sign * random.between(0.001, 0.05));
    const Vec3 place = std::pow(10.0, random.between(3, 8)) * quadric_direction(random);
    pair.a.pose.offset = pair.a.pose.offset + place;
    pair.pose_of_b().offset = pair.pose_of_b().offset + place;
  }
  if (regime == "tiny" || regime == "huge") {
    leave_quadric_gap(pair, sign * random.between(0.001, 0.05));
    if (is_plain_kind(kind_b))
      resize(pair, std::pow(10.0, regime == "tiny" ? -random.between(5, 250) : random.between(5, 250)));
  }
  return pair;
}

}  // namespace toccata::test
