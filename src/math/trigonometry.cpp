#include "toccata/math/trigonometry.hpp"

#include <cmath>
#include <utility>

namespace toccata {
namespace {

constexpr double pi = 3.14159265358979323846;

// Taylor's sums up to an eighth of a turn (|x| ≤ π/4): what is left out is below 2⁻⁶⁰ of the result.
double sine_of_small(double x) {
  constexpr double c[] = {-1.0 / 6,        1.0 / 120,         -1.0 / 5040,           1.0 / 362880,
                          -1.0 / 39916800, 1.0 / 6227020800., -1.0 / 1307674368000., 1.0 / 355687428096000.};
  const double y = x * x;
  double sum = 0;
  for (int i = 7; i >= 0; --i) sum = (sum + c[i]) * y;
  return x + x * sum;
}

double cosine_of_small(double x) {
  constexpr double c[] = {1.0 / 24,         -1.0 / 720,          1.0 / 40320,           -1.0 / 3628800,
                          1.0 / 479001600., -1.0 / 87178291200., 1.0 / 20922789888000., -1.0 / 6402373705728000.};
  const double y = x * x;
  double sum = 0;
  for (int i = 7; i >= 0; --i) sum = (sum + c[i]) * y;
  // 1 − y/2 loses the low bits of y/2; they are added back (W. Kahan's compensated difference).
  const double half = 0.5 * y, main = 1 - half;
  return main + (((1 - main) - half) + y * sum);
}

/// The sine and the cosine of the angle `rest`, at most an eighth of a turn, beyond `quarter` quarter turns; a whole
/// turn is `unit`.
SineCosine turned(double rest, double unit, int quarter) {
  const double x = rest * (2 * pi / unit);
  SineCosine result{sine_of_small(x), cosine_of_small(x)};
  // A twelfth of a turn is exact by definition, not by luck of rounding.
  if (std::abs(rest) * 12 == unit) result.sine = std::copysign(0.5, rest);
  for (int i = 0; i < quarter; ++i) result = {result.cosine, 0 - result.sine};
  return result;
}

SineCosine sine_cosine(double angle, double unit) {
  const double within = std::remainder(angle, unit);            // exact, in [−unit/2, unit/2]
  const double quarters = std::nearbyint(4 * (within / unit));  // −2 … 2
  const double rest = within - quarters * (unit / 4);           // exact: both are near each other, or quarters is 0
  // Turning by a quarter maps (s, c) to (c, −s); negative quarters are counted up to the next turn.
  return turned(rest, unit, (static_cast<int>(quarters) + 4) % 4);
}

}  // namespace

SineCosine sine_cosine_of_turns(double turns) { return sine_cosine(turns, 1); }

SineCosine sine_cosine_of_degrees(double degrees) { return sine_cosine(degrees, 360); }

}  // namespace toccata
