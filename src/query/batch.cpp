#include "toccata/query/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

#include "query/task_reporter.hpp"
#include "query/workspace_pool.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata {
namespace {

/// Lowers `least` to `value` where it is greater.
void lower_to(std::atomic<std::size_t>& least, std::size_t value) {
  std::size_t known = least;
  while (value < known && !least.compare_exchange_weak(known, value)) {
  }
}

/// `ask` for every query. After a failure only earlier queries are still asked, one of which may fail as well: so the
/// error that is told does not depend on timing.
template <class Answer, class Ask>
std::vector<Answer> ask_each(std::span<const PairQuery> queries, const BatchOptions& options, const Ask& ask) {
  std::vector<Answer> answers(queries.size());
  TaskReporter reporter(options.progress, queries.size());
  WorkspacePool workspaces;
  std::atomic<std::size_t> first_failure = std::numeric_limits<std::size_t>::max();
  parallel_for(queries.size(), options.threads, [&](std::size_t i) {
    if (reporter.cancelled() || i > first_failure) return;
    try {
      answers[i] = workspaces.with([&](Workspace& workspace) { return ask(queries[i], workspace); });
    } catch (const Error& error) {
      lower_to(first_failure, i);
      throw Error(fmt::format("query {}: {}", i, error.what()));
    }
    reporter.finished_one();
  });
  return answers;
}

ContactCount count_of(std::span<const Contact> contacts) {
  std::vector<std::pair<Index, Index>> faces;
  for (const Contact& contact : contacts) faces.emplace_back(contact.face_a, contact.face_b);
  const std::size_t triangle_pairs = faces.size();
  std::sort(faces.begin(), faces.end());
  const auto last = std::unique(faces.begin(), faces.end());
  return {triangle_pairs, static_cast<std::size_t>(last - faces.begin())};
}

}  // namespace

std::vector<bool> overlap_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                               const BatchOptions& options) {
  // Bytes, because the threads write neighbours.
  const auto answers = ask_each<char>(queries, options, [&](const PairQuery& query, Workspace& workspace) {
    return overlap(a, b, query, workspace) ? char{1} : char{0};
  });
  return {answers.begin(), answers.end()};
}

std::vector<Relation> relation_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                    const BatchOptions& options) {
  return ask_each<Relation>(queries, options,
                            [&](const PairQuery& query, Workspace&) { return relation(a, b, query); });
}

std::vector<std::vector<Contact>> contacts_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                                const BatchOptions& options) {
  return ask_each<std::vector<Contact>>(queries, options, [&](const PairQuery& query, Workspace& workspace) {
    const auto found = contacts(a, b, query, workspace);
    return std::vector<Contact>(found.begin(), found.end());
  });
}

std::vector<ContactCount> count_contacts_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                              const BatchOptions& options) {
  return ask_each<ContactCount>(queries, options, [&](const PairQuery& query, Workspace& workspace) {
    return count_of(contacts(a, b, query, workspace));
  });
}

}  // namespace toccata
