#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "query/scenes/task_reporter.hpp"
#include "query/search_scratch.hpp"
#include "query/workspace_pool.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/query/batch.hpp"
#include "trees/chunks.hpp"

namespace toccata {

/// Lowers `least` to `value` where it is greater.
inline void lower_to(std::atomic<std::size_t>& least, std::size_t value) {
  std::size_t known = least;
  while (value < known && !least.compare_exchange_weak(known, value)) {
  }
}

/// How many questions in a row one thread takes: few enough that all threads stay busy, and enough that a question of a
/// hundred nanoseconds is not outweighed by the taking.
inline std::size_t row_length(std::size_t count, int threads) {
  constexpr std::size_t rows_per_thread = 32, longest = 256;
  return std::clamp<std::size_t>(count / (rows_per_thread * static_cast<std::size_t>(thread_count(threads))), 1,
                                 longest);
}

/// Throws Error when something is kept, and not for each question.
inline void require_one_each(std::span<const SimplexCache> kept, std::size_t count, std::string_view noun) {
  if (!kept.empty() && kept.size() != count)
    throw Error(fmt::format("{} SimplexCaches are kept for {} {}; give one for each, or none", kept.size(), count,
                            noun == "query" ? "queries" : fmt::format("{}s", noun)));
}

/// `ask(i, workspace)` for every question i of so many. After a failure only earlier questions are still asked, one of
/// which may fail as well: so the error that is told, as "<noun> i: …", does not depend on timing.
template <class Ask>
auto ask_each(std::size_t count, std::string_view noun, const BatchOptions& options, const Ask& ask) {
  using Answer = std::invoke_result_t<const Ask&, std::size_t, Workspace&>;
  static_assert(!std::is_same_v<Answer, bool>, "the threads write neighbours: bytes, and no bits");
  require_one_each(options.warm_start, count, noun);
  std::vector<Answer> answers(count);
  TaskReporter reporter(options.progress, count);
  WorkspacePool workspaces;
  std::atomic<std::size_t> first_failure = std::numeric_limits<std::size_t>::max();
  const auto answer = [&](std::size_t i, Workspace& workspace) {
    if (reporter.cancelled() || i > first_failure) return;
    try {
      if (!options.warm_start.empty()) workspace.scratch().convex = options.warm_start[i];
      answers[i] = ask(i, workspace);
      if (!options.warm_start.empty()) options.warm_start[i] = workspace.scratch().convex;
    } catch (const Error& error) {
      lower_to(first_failure, i);
      throw Error(fmt::format("{} {}: {}", noun, i, error.what()));
    }
    reporter.finished_one();
  };
  const std::size_t length = row_length(count, options.threads);
  parallel_for((count + length - 1) / length, options.threads, [&](std::size_t row) {
    workspaces.with([&](Workspace& workspace) {
      const std::size_t end = std::min(count, (row + 1) * length);
      for (std::size_t i = row * length; i < end; ++i) answer(i, workspace);
    });
  });
  return answers;
}

/// `ask(question, workspace)` for every question.
template <class Question, class Ask>
auto ask_each(std::span<const Question> questions, std::string_view noun, const BatchOptions& options, const Ask& ask) {
  return ask_each(questions.size(), noun, options,
                  [&](std::size_t i, Workspace& workspace) { return ask(questions[i], workspace); });
}

/// `ask(points, answers, workspace)` for rows of points, each on one thread, for questions that are faster when some
/// are asked together and that only points which are not finite can fail.
template <class Answer, class Ask>
std::vector<Answer> ask_in_rows(std::span<const Vec3> points, const BatchOptions& options, const Ask& ask) {
  require_one_each(options.warm_start, points.size(), "point");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i])) throw Error(fmt::format("point {}: the point is not finite", i));
  constexpr std::size_t enough_together = 64;
  const auto threads = static_cast<std::size_t>(thread_count(options.threads));
  const std::size_t share = std::min(enough_together, (points.size() + threads - 1) / threads);
  const Chunks rows{points.size(), std::max(row_length(points.size(), options.threads), share)};
  std::vector<Answer> answers(points.size());
  TaskReporter reporter(options.progress, points.size());
  WorkspacePool workspaces;
  parallel_for(rows.size(), options.threads, [&](std::size_t row) {
    if (reporter.cancelled()) return;
    const auto of_row = rows.of(std::span(answers), row);
    workspaces.with([&](Workspace& workspace) { ask(rows.of(points, row), of_row, workspace); });
    for (std::size_t i = 0; i < of_row.size(); ++i) reporter.finished_one();
  });
  return answers;
}

}  // namespace toccata
