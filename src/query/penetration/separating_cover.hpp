#pragma once

#include <cstddef>
#include <vector>

#include "query/penetration/solid_body.hpp"

namespace toccata {

/// A convex body within A and one within B: while they overlap, A and B do.
struct InnerPair {
  const InnerPart* a;
  const InnerPart* b;
};

/// A cube of translations of B.
struct TranslationCell {
  Vec3 centre;
  double half;

  /// From no translation to the nearest and the farthest of the cell, rounded.
  [[nodiscard]] double nearest() const;
  [[nodiscard]] double farthest() const;
};

/// The translations of B after which A and B are known to overlap still: for every pair a convex set, the Minkowski
/// difference of its bodies. Several of them cover what none does, as the walls of a hole hold a peg together.
class SeparatingCover {
 public:
  /// `extent`: the greatest coordinates of both and of the translations, added up.
  explicit SeparatingCover(double extent) : margin_(0x1p-40 * extent) {}

  void add(const InnerPair& pair) { pairs_.push_back(pair); }

  /// Proved of all translations of the cell: after none of them do the interiors part. The cell lies within the set of
  /// a single pair when its corners do.
  [[nodiscard]] bool covers(const TranslationCell& cell) const;

 private:
  [[nodiscard]] bool covers(const InnerPair& pair, const TranslationCell& cell) const;

  std::vector<InnerPair> pairs_;
  double margin_;  ///< more than rounding moves a vertex by
};

}  // namespace toccata
