#pragma once

#include "casts.hpp"
#include "judge.hpp"

namespace toccata::bench {

/// How far a peer's shapes may be apart, or have overlapped, at the time that it tells, and how much later it may be by
/// the way; the shapes have a size of about 1.
inline constexpr double cast_tolerance = 1e-4;

/// What a library answered, and how long it took.
struct AnsweredCasts {
  Result result;
  std::vector<CastAnswer> answers;
};

/// Counts disagreements and wrong answers into the results, of which the first is Toccata's. For Toccata's interval the
/// shapes have to be apart at the lower end and before, and to meet at the upper; a peer's shapes must neither be
/// farther apart at its time than the tolerance, nor have overlapped deeper before; one that tells a miss must be right
/// but for as deep an overlap. All by 60 digits.
void judge(const CastWork& work, Judged judged, std::vector<AnsweredCasts>& answered);

}  // namespace toccata::bench
