#pragma once

#include "query/posed_shape.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

/// The distance of two parts with elements and faces counted from where those of the parts begin.
[[nodiscard]] inline Distance numbered(Distance d, const PosedPart& a, const PosedPart& b) {
  d.element_a += a.first_element;
  d.element_b += b.first_element;
  d.face_a += a.first_face;
  d.face_b += b.first_face;
  return d;
}

}  // namespace toccata
