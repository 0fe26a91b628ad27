#pragma once

#include <optional>
#include <span>
#include <string>

#include "toccata/narrow/minkowski.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// The sum of two convex objects, the first of which is A and the second B: `minkowski`. In the world.
struct MinkowskiQuestion {
  bool difference = false;      ///< A − B instead of A + B
  bool hulls = false;           ///< meshes that are not convex stand for their convex hulls; else they are refused
  std::optional<Vec3> point{};  ///< where it lies is asked too
  friend bool operator==(const MinkowskiQuestion&, const MinkowskiQuestion&) = default;
};

struct MinkowskiReport {
  MinkowskiQuestion question;
  std::string a, b;  ///< names of the objects
  MinkowskiSum sum;
};

/// "A + B" or "A − B".
[[nodiscard]] std::string name_of(const MinkowskiQuestion& question);

/// "inside", "boundary", "outside": of negative, zero and positive.
[[nodiscard]] std::string name_of_side(Sign side);

/// The sum as an object of that name.
[[nodiscard]] SceneObject sum_object(const MinkowskiReport& report);

/// JSON by the schema docs/reference/minkowski-report.md.
[[nodiscard]] std::string minkowski_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                                const MinkowskiReport& report, std::span<const std::string> warnings);

}  // namespace toccata
