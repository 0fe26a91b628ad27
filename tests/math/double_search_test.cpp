#include "math/double_search.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace toccata {
namespace {

/// The number itself is a double; its half sums are told by long doubles.
double found(double number, double guess) {
  return nearest_double_by(
      [number](double x, double y) {
        const long double less = static_cast<long double>(number) - (static_cast<long double>(x) + y) / 2;
        return less < 0 ? Sign::negative : less > 0 ? Sign::positive : Sign::zero;
      },
      guess);
}

TEST(DoubleSearch, FindsNumbersHoweverFarTheGuessIs) {
  constexpr double greatest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double number : {0.0, 1.0, -1.0, 1e-300, -1e-300, least, -least, greatest, -greatest})
    for (const double guess : {0.0, 1.0, -1.0, least, -least, greatest, -greatest, infinity, -infinity,
                               std::numeric_limits<double>::quiet_NaN()})
      EXPECT_EQ(found(number, guess), number) << "from " << guess;
}

}  // namespace
}  // namespace toccata
