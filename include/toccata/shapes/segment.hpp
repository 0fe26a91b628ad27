#pragma once

#include "toccata/math/vec3.hpp"

namespace toccata {

/// The segment between two points of the shape's own frame, which may be equal. A surface: it has no interior.
class Segment {
 public:
  /// Throws Error when an end is not finite.
  Segment(const Vec3& start, const Vec3& end);

  [[nodiscard]] const Vec3& start() const { return start_; }
  [[nodiscard]] const Vec3& end() const { return end_; }

 private:
  Vec3 start_;
  Vec3 end_;
};

}  // namespace toccata
