#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "math/filter.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {

/// Some faces of a hull, by their place in its list.
struct FaceRange {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// Which faces of a hull cut off something of a region, which those of a larger one are a list for. By exact signs.
class HullSides {
 public:
  explicit HullSides(const ConvexHull& hull);

  [[nodiscard]] FaceRange all() const { return all_; }
  /// Those of the faces that some of the corners are in front of; nothing where all corners are in front of one face,
  /// so that nothing of the hull is among them.
  [[nodiscard]] std::optional<FaceRange> cutting(FaceRange faces, std::span<const Vec3> corners);
  /// Not in front of any.
  [[nodiscard]] bool is_behind(FaceRange faces, const Vec3& point) const;

 private:
  struct Face {
    std::array<Vec3, 3> corners;
    FilteredCross normal;
    [[nodiscard]] bool is_in_front(const Vec3& point) const;
  };

  std::vector<Face> faces_;
  std::vector<Index> lists_;
  FaceRange all_;
};

}  // namespace toccata
