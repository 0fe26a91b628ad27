#pragma once

#include <functional>
#include <vector>

#include "query/penetration/separating_cover.hpp"
#include "query/penetration/separating_seeds.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

/// A way that is made longer to part two solids grows by at least that, however small they are.
inline constexpr double least_step = 0x1p-1020;

/// What is asked of two solids whose convex bodies are searched.
struct SeparatingQuestions {
  /// A lower bound of the distance of A from B, moved; 0 when they meet.
  std::function<double(const Vec3& move)> distance;
  /// Some of the points at which their surfaces meet.
  std::function<std::vector<SurfaceIntersection>(const Vec3& move)> intersections;
};

/// A bracket of the penetration depth of two overlapping solids: from below by convex bodies within, from above by a
/// translation after which they are apart (docs/methods/penetration.md). Without the points.
class SeparatingSearch {
 public:
  SeparatingSearch(SolidBody& a, SolidBody& b, SeparatingQuestions questions);

  [[nodiscard]] Penetration answer();

 private:
  using Seeds = std::vector<SeparatingSeed>;

  [[nodiscard]] double slack(double length) const { return 0x1p-48 * (extent_ + length); }
  [[nodiscard]] bool parted(const Vec3& move) const;
  [[nodiscard]] bool good_enough() const;
  bool try_translation(const Vec3& direction, double length);
  void try_along(const Vec3& direction, double length);
  void shorten(int steps);
  void turn();
  std::size_t add_parts(const Vec3& move, std::size_t most);
  void add(const InnerPair& pair);
  void cover();
  bool settle(const TranslationCell& cell);

  SolidBody& a_;
  SolidBody& b_;
  SeparatingQuestions questions_;
  double extent_;
  double reach_ = 0;
  SeparatingCover cover_;
  double of_pairs_ = 0;  ///< the greatest depth of a pair of bodies
  Penetration best_{};
};

}  // namespace toccata
