#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "toccata/query/check_all.hpp"
#include "toccata/query/nearest.hpp"
#include "toccata/query/scene_nearest.hpp"
#include "toccata/query/signed_distance.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// A point of the surface of a scene's object, which is told by its place in the scene.
struct ReportedSurfacePoint {
  SurfacePoint nearest;
  Index object = 0;
  /// When asked for: the side is that of the point, of the whole object; the distance is that of `nearest`, negative
  /// inside.
  std::optional<SignedDistance> signed_distance{};
};

/// A point that was asked about, and what is nearest to it, nearest first; none where nothing is within the greatest
/// distance.
struct ReportedPoint {
  Vec3 point;
  std::vector<ReportedSurfacePoint> nearest;
  std::optional<SceneSignedDistance> in_scene{};  ///< of all objects together, when asked for
};

/// JSON by the schema toccata/nearest/1 of docs/reference/nearest-report.md. Doubles round-trip.
[[nodiscard]] std::string nearest_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                              std::span<const ReportedPoint> points,
                                              std::span<const std::string> warnings);

/// Comma-separated values with a header line: a line per point of a surface. `sides`: with the columns of the signed
/// distances, empty where there is none.
[[nodiscard]] std::string nearest_report_csv(const Scene& scene, std::span<const ReportedPoint> points, bool sides);

}  // namespace toccata
