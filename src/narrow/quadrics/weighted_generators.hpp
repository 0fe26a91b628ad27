#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "math/number_vector.hpp"
#include "narrow/quadrics/plain_body.hpp"

namespace toccata {

/// Generators of a body whose weighted mean is a point of it, but for its round part.
template <class Number, std::size_t most>
struct WeightedGenerators {
  std::array<Index, most> generator{};
  std::array<Number, most> weight{};
  std::size_t size = 0;

  void append(Index which, const Number& part) {
    generator[size] = which;
    weight[size] = part;
    ++size;
  }

  [[nodiscard]] bool has(Index which) const {
    for (std::size_t i = 0; i < size; ++i)
      if (generator[i] == which) return true;
    return false;
  }

  /// One of them has a round part.
  [[nodiscard]] bool any_grown(const PlainBody& body) const {
    for (std::size_t i = 0; i < size; ++i)
      if (body.grown(generator[i])) return true;
    return false;
  }

  /// Leaves out the generator of the least weight, where that is less than -slack and not the only one. The other
  /// weights, of which negative ones count as 0, are brought to the sum 1, rounded to doubles.
  bool drop_negative(double slack) {
    std::size_t least = 0;
    for (std::size_t i = 1; i < size; ++i)
      if (plain_weight(i) < plain_weight(least)) least = i;
    if (size < 2 || !(plain_weight(least) < -slack)) return false;
    --size;
    for (std::size_t i = least; i < size; ++i) {
      generator[i] = generator[i + 1];
      weight[i] = weight[i + 1];
    }
    double total = 0;
    for (std::size_t i = 0; i < size; ++i) total += std::fmax(plain_weight(i), 0);
    for (std::size_t i = 0; i < size; ++i)
      weight[i] = Number{total > 0 ? std::fmax(plain_weight(i), 0) / total : 1.0 / static_cast<double>(size)};
    return true;
  }

 private:
  [[nodiscard]] double plain_weight(std::size_t i) const { return number_as<double>(weight[i]); }
};

}  // namespace toccata
