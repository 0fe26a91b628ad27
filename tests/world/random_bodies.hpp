#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <variant>
#include <vector>

#include "support/convex_cases.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/world/body.hpp"

namespace toccata::test {

/// convex: of all kinds, about as large as they are apart; whole: boxes and spheres of small whole numbers, which often
/// touch exactly; ratio: sizes from 1e-9 to 10; far: a billion units from the origin; any: also cylinders,
/// cones, ellipsoids, meshes open and closed, height fields, half-spaces and compounds.
inline constexpr std::array<std::string_view, 5> body_families{"convex", "whole", "ratio", "far", "any"};

inline Vec3 vector_in(Random& random, double low, double high) {
  const double x = random.between(low, high), y = random.between(low, high), z = random.between(low, high);
  return {x, y, z};
}

inline Pose random_place(std::string_view family, Random& random) {
  if (family == "whole") {
    const Vec3 at = vector_in(random, 0, 6);
    return Pose::translation(std::floor(at.x), std::floor(at.y), std::floor(at.z));
  }
  Pose pose{random_rotation(random), vector_in(random, 0, family == "ratio" ? 3 : 6)};
  if (family == "far") pose.offset = pose.offset + Vec3{1e9, -1e9, 1e9};
  return pose;
}

inline Model random_convex_model(Random& random) {
  const std::vector<std::string>& kinds = convex_kinds();
  return std::visit([](const auto& shape) { return Model(shape); },
                    random_convex(kinds[random.below(kinds.size())], random));
}

inline Model random_solid(double size, Random& random) {
  switch (random.below(3)) {
    case 0:
      return Sphere(size);
    case 1:
      return Box({size, size, 0.5 * size});
    default:
      return Capsule({0, 0, -size}, {0, 0, size}, 0.5 * size);
  }
}

inline Model random_whole(Random& random) {
  if (random.below(3) == 0) return Sphere(0.5 + 0.5 * static_cast<double>(random.below(2)));
  const auto half = [&] { return 0.5 + 0.5 * static_cast<double>(random.below(2)); };
  const double x = half(), y = half(), z = half();
  return Box({x, y, z});
}

inline Model random_quadric(Random& random) {
  const auto length = [&] { return random.between(0.1, 0.75); };
  const double x = length(), y = length(), z = length();
  switch (random.below(3)) {
    case 0:
      return Cylinder(x, z);
    case 1:
      return Cone(x, z);
    default:
      return Ellipsoid({x, y, z});
  }
}

/// A mesh, height field, half-space, compound, smooth or other convex shape.
inline Model random_any(Random& random) {
  switch (random.below(12)) {
    case 0:
      return Model(box_between({-0.5, -0.5, -0.5}, {0.5, 0.25, 0.5}));
    case 1:
      return Model(random_soup(random, 6, 0.7, 8));
    case 2:
      return Model(HeightField(3, 2, 0.5, 0.5, std::array{0.0, 0.5, 0.0, 0.25, 0.0, 0.5}));
    case 3:
      if (random.below(4) == 0) return HalfSpace({0, 0, -3}, {0, 0, 1});
      [[fallthrough]];
    case 4:
      return Model(Compound(
          std::array{CompoundPart{Sphere(0.5)}, CompoundPart{Box({0.25, 0.25, 0.25}), Pose::translation(1, 0, 0)}}));
    case 5:
    case 6:
      return random_quadric(random);
    default:
      return random_convex_model(random);
  }
}

inline Model random_model(std::string_view family, Random& random) {
  if (family == "whole") return random_whole(random);
  if (family == "ratio") return random_solid(std::pow(10, random.between(-9, 1)), random);
  return family == "any" ? random_any(random) : random_convex_model(random);
}

inline double random_margin(Random& random) {
  if (random.below(2) == 0) return 0;
  return random.below(20) == 0 ? std::numeric_limits<double>::infinity() : 0.25 * static_cast<double>(random.below(4));
}

/// With margins, categories and motions of all sorts.
inline Body random_body(std::string_view family, Random& random) {
  Body body{random_model(family, random), random_place(family, random)};
  const std::uint64_t motion = random.below(6);
  body.type = motion == 0 ? BodyType::static_body : motion == 1 ? BodyType::kinematic_body : BodyType::dynamic_body;
  body.category = std::uint64_t{1} << random.below(3);
  if (random.below(4) == 0) body.mask = random.below(8);
  body.margin = random_margin(random);
  body.user_data = random.bits();
  return body;
}

}  // namespace toccata::test
