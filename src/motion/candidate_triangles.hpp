#pragma once

#include <cstddef>
#include <span>

#include "toccata/core/function_ref.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/trees/walk.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

/// Called with candidate pairs from several threads at once, each with a number of its own below their count; says
/// whether more is wanted.
using SeeCandidates = FunctionRef<bool(std::size_t thread, std::span<const ItemPair>)>;

/// The number of threads on which the candidates are looked for, and whom to call with how much of the trees has been
/// walked.
struct CandidateWork {
  int threads;
  const Progress& progress;
};

/// Shows every pair (item of a, item of b) of two trees in one frame whose boxes are no farther than `reach` apart
/// along each axis, and perhaps others that are hardly farther: each once, in any order.
void visit_candidates(const WideBvh& a, const WideBvh& b, double reach, const CandidateWork& work, SeeCandidates see);

/// The same of two different items of one tree, the lesser first.
void visit_candidates(const WideBvh& tree, double reach, const CandidateWork& work, SeeCandidates see);

}  // namespace toccata
