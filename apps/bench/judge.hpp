#pragma once

#include "measure.hpp"

namespace toccata::bench {

enum class Judged { differing, all };

/// What was asked, for the truth about it.
struct Questions {
  Task task;
  const TriangleMesh& a;
  const TriangleMesh& b;
  const std::vector<PosePair>& poses;
  Judged judged;
};

/// Counts disagreements and wrong answers into the results. The first is Toccata. A wrong answer: the yes or no differs
/// from the truth, or for `contacts` some pair of triangles on which libraries differ is or is not in the list.
void judge(const Questions& questions, std::vector<Answered>& answered);

/// The same of yes-or-no answers about triangles (1: they meet), a list for each result.
void judge(std::span<const TriangleQuestion> questions, const std::vector<std::vector<char>>& answers, Judged judged,
           std::vector<Result>& results);

}  // namespace toccata::bench
