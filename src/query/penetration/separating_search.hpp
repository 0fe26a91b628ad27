#pragma once

#include "query/penetration/depth_search.hpp"
#include "query/penetration/separating_cover.hpp"

namespace toccata {

/// A bracket of the penetration depth of two overlapping solids: from below by convex bodies within, from above by a
/// translation after which they are apart (docs/methods/penetration.md). Without the points.
class SeparatingSearch {
 public:
  SeparatingSearch(SolidBody& a, SolidBody& b, const SeparatingQuestions& questions, const DepthLimit& limit);

  /// Begins with what is known: a depth from below, and a way out unless `upper` is infinite.
  [[nodiscard]] Penetration answer(const Penetration& known);

 private:
  [[nodiscard]] bool is_done() const { return limit_.is_narrow(best_) || limit_.is_over(); }
  void try_along(const Vec3& direction, double length);
  void turn();
  std::size_t add_parts(const Vec3& move, std::size_t most);
  void add(const InnerPair& pair);
  void cover();
  bool settle(const TranslationCell& cell);

  SolidBody& a_;
  SolidBody& b_;
  const SeparatingQuestions& questions_;
  const DepthLimit& limit_;
  double extent_;
  TriedWays tried_;
  Penetration& best_ = tried_.best;
  double reach_ = 0;
  SeparatingCover cover_;
  double of_pairs_ = 0;  ///< the greatest depth of a pair of bodies
};

}  // namespace toccata
