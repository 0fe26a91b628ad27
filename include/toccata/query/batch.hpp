#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "toccata/core/progress.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {

// The questions about two models, asked for many poses. Entry i of an answer is what the question of the same name
// answers for queries[i]; it depends neither on the other queries nor on the number of threads. Throws Error as that
// question does, the message beginning with "query i: ", of the least such i.

struct BatchOptions {
  int threads = 0;  ///< 0: as many as the machine has; the answer does not depend on it
  Progress progress{};
};

/// How many triangles, and how many faces of the files, meet. A face that was cut into triangles meets a face once,
/// however many of these do.
struct ContactCount {
  std::size_t triangle_pairs = 0;
  std::size_t face_pairs = 0;
  friend constexpr bool operator==(const ContactCount&, const ContactCount&) = default;
};

[[nodiscard]] std::vector<bool> overlap_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                             const BatchOptions& options = {});

[[nodiscard]] std::vector<Relation> relation_each(const Model& a, const Model& b, std::span<const PairQuery> queries,
                                                  const BatchOptions& options = {});

[[nodiscard]] std::vector<std::vector<Contact>> contacts_each(const Model& a, const Model& b,
                                                              std::span<const PairQuery> queries,
                                                              const BatchOptions& options = {});

/// The contacts counted and not kept.
[[nodiscard]] std::vector<ContactCount> count_contacts_each(const Model& a, const Model& b,
                                                            std::span<const PairQuery> queries,
                                                            const BatchOptions& options = {});

}  // namespace toccata
