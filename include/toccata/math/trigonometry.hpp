#pragma once

namespace toccata {

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

// Sine and cosine with the same bits on every platform, which the C library's do not have. The argument is in units in
// which a whole turn is a whole number, so its reduction is exact: multiples of a quarter turn give exactly 0, 1 and
// −1, and of a twelfth exactly ±1/2. The error is below 2 units in the last place (tests/math/trigonometry_test.cpp
// measures it). Arguments must be finite.

/// 1 is a whole turn.
[[nodiscard]] SineCosine sine_cosine_of_turns(double turns);

/// 360 is a whole turn.
[[nodiscard]] SineCosine sine_cosine_of_degrees(double degrees);

}  // namespace toccata
