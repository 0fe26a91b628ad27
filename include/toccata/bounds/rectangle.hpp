#pragma once

namespace toccata {

/// A closed box of the plane, given by its corner of least coordinates and its size, which is not negative.
struct Rectangle {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// start + length ≥ end, exactly: the sum is rounded, and where that hides the answer its error decides (D. E. Knuth,
/// "The Art of Computer Programming", volume 2, section 4.2.2).
[[nodiscard]] constexpr bool reaches(double start, double length, double end) {
  const double sum = start + length;
  if (sum != end) return sum > end;
  const double length_part = sum - start, start_part = sum - length_part;
  return (start - start_part) + (length - length_part) >= 0;
}

/// The rectangles have a point in common, touching included. Exact, though the far corners need not be doubles.
[[nodiscard]] constexpr bool overlap(const Rectangle& a, const Rectangle& b) {
  return reaches(a.x, a.width, b.x) && reaches(b.x, b.width, a.x) && reaches(a.y, a.height, b.y) &&
         reaches(b.y, b.height, a.y);
}

}  // namespace toccata
