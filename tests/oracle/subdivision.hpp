#pragma once

#include <map>
#include <utility>
#include <vector>

#include "oracle/rational.hpp"
#include "toccata/core/index.hpp"

namespace toccata::oracle {

/// A cage in exact numbers, and how it is refined by the rules of the papers, point by point, without any tables of
/// neighbours. Sharpness of 10 or more lasts.
struct RationalCage {
  bool is_loop = false;
  std::vector<RationalPoint> points;
  std::vector<std::vector<Index>> faces;
  std::map<std::pair<Index, Index>, Rational> creases;  ///< by the ends, the lesser first; borders are told here too
  std::vector<Rational> corners;                        ///< of each vertex
};

/// A face with the corners c_i becomes, in order, the faces (c_i, middle of c_i and c_i+1, middle of the face, middle
/// of c_i−1 and c_i), with Loop without the middle of the face, and then the one of three middles. With Loop the
/// cosines are off by 10⁻¹⁸.
[[nodiscard]] RationalCage refined(const RationalCage& cage);

}  // namespace toccata::oracle
