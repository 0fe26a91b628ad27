#include "toccata/shapes/primitives.hpp"

#include "shapes/validation.hpp"

namespace toccata {

Segment::Segment(const Vec3& start, const Vec3& end) : start_(start), end_(end) {
  require_finite(start, "the start of a segment");
  require_finite(end, "the end of a segment");
}

}  // namespace toccata
