#include "narrow/smooth/casts/smooth_ray.hpp"

namespace toccata {
namespace {

/// Part of a line, with the normals where it begins in coordinates in which the shape is round.
struct Stretch {
  BoundedNumber enters = exactly(-HUGE_VAL);
  BoundedNumber leaves = exactly(HUGE_VAL);
  enum class End { none, cap_below, cap_above, round } first = End::none;
  bool empty = false;
  bool certain = true;
};

bool is_unbounded(const BoundedNumber& a) { return std::isinf(a.value.high); }

/// The part of both; in doubt where the order of two ends is.
void cut_front(Stretch& stretch, const BoundedNumber& enters, Stretch::End end) {
  if (is_unbounded(stretch.enters) || (enters - stretch.enters).is_positive()) {
    stretch.enters = enters;
    stretch.first = end;
  } else if (!(enters - stretch.enters).is_negative()) {
    stretch.certain = false;
  }
}

void cut_back(Stretch& stretch, const BoundedNumber& leaves) {
  if (is_unbounded(stretch.leaves) || (leaves - stretch.leaves).is_negative())
    stretch.leaves = leaves;
  else if (!(leaves - stretch.leaves).is_positive())
    stretch.certain = false;
}

/// Where −1 ≤ z + t w ≤ 1.
void cut_by_caps(Stretch& stretch, const BoundedNumber& z, const BoundedNumber& w) {
  const BoundedNumber one = exactly(1.0);
  if (w.is_positive() || w.is_negative()) {
    const BoundedNumber below = (-one - z) / w, above = (one - z) / w;
    const bool up = w.is_positive();
    cut_front(stretch, up ? below : above, up ? Stretch::End::cap_below : Stretch::End::cap_above);
    cut_back(stretch, up ? above : below);
    return;
  }
  // In parallel, or nearly so: then it is not certain where they are passed.
  stretch.certain = false;
}

/// Where a t² + 2 b t + c ≤ 0, for a > 0.
void cut_by_roots(Stretch& stretch, const BoundedNumber& a, const BoundedNumber& b, const BoundedNumber& c) {
  const BoundedNumber discriminant = b * b - a * c;
  if (!a.is_positive() || !(discriminant.is_positive() || discriminant.is_negative())) {
    stretch.certain = false;
    return;
  }
  if (discriminant.is_negative()) {
    stretch.empty = true;
    return;
  }
  const BoundedNumber root = square_root(discriminant);
  // The sum of two of the same sign keeps its digits.
  const bool falling = b.value.high < 0;
  const BoundedNumber sum = falling ? root - b : -(root + b);
  cut_front(stretch, falling ? c / sum : sum / a, Stretch::End::round);
  cut_back(stretch, falling ? sum / a : c / sum);
}

BoundedVector round_normal(PosedSmooth::Kind kind, const BoundedVector& at, Stretch::End end) {
  const BoundedNumber none = exactly(0.0);
  if (end == Stretch::End::cap_below || end == Stretch::End::cap_above)
    return {none, none, exactly(end == Stretch::End::cap_above ? 1.0 : -1.0)};
  if (kind == PosedSmooth::Kind::ellipsoid) return at;
  // Of x² + y² = ((1 − z) / 2)² the gradient.
  return {at[0], at[1], kind == PosedSmooth::Kind::cone ? exactly(0.25) * (exactly(1.0) - at[2]) : none};
}

}  // namespace

std::optional<LineWithin> line_within(const SmoothBody& smooth, const BoundedVector& from, const BoundedVector& along) {
  const std::array<BoundedVector, 3>& axis = smooth.axes();
  const BoundedVector normal[3] = {cross(axis[1], axis[2]), cross(axis[2], axis[0]), cross(axis[0], axis[1])};
  const BoundedNumber volume = dot(normal[0], axis[0]);
  const BoundedVector from_middle = from - smooth.middle_point();
  BoundedVector p, v;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = dot(normal[i], from_middle) / volume;
    v[i] = dot(normal[i], along) / volume;
  }
  const PosedSmooth::Kind kind = *smooth.smooth_kind();
  BoundedNumber a = v[0] * v[0] + v[1] * v[1], b = p[0] * v[0] + p[1] * v[1], c = p[0] * p[0] + p[1] * p[1];
  Stretch stretch;
  if (kind == PosedSmooth::Kind::ellipsoid) {
    a = a + v[2] * v[2], b = b + p[2] * v[2], c = (c + p[2] * p[2]) - exactly(1.0);
    cut_by_roots(stretch, a, b, c);
  } else if (kind == PosedSmooth::Kind::cylinder) {
    cut_by_caps(stretch, p[2], v[2]);
    if (is_exactly_zero(a)) {
      const BoundedNumber beyond = c - exactly(1.0);
      stretch.empty = stretch.empty || beyond.is_positive();
      stretch.certain = stretch.certain && (beyond.is_positive() || beyond.is_negative());
    } else {
      cut_by_roots(stretch, a, b, c - exactly(1.0));
    }
  } else {
    return {};
  }
  if (!stretch.certain && !stretch.empty) return {};
  LineWithin found;
  found.enters = stretch.enters;
  found.leaves = stretch.leaves;
  const BoundedNumber length = stretch.leaves - stretch.enters;
  if (!stretch.empty && !length.is_positive() && !length.is_negative()) return {};
  found.empty = stretch.empty || length.is_negative();
  if (found.empty) return found;
  const BoundedVector at = p + stretch.enters * v, out = round_normal(kind, at, stretch.first);
  // A normal is mapped by the inverse of the transpose.
  BoundedVector in_pair{exactly(0.0), exactly(0.0), exactly(0.0)};
  for (std::size_t i = 0; i < 3; ++i) in_pair = in_pair + (out[i] / volume) * normal[i];
  found.normal = plain(in_pair);
  return found;
}

}  // namespace toccata
