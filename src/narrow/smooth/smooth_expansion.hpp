#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "narrow/smooth/smooth_proof.hpp"

namespace toccata {

/// A polytope of points of A − B around the origin that grows where its surface is nearest (G. van den Bergen,
/// "Proximity queries and penetration depth computation on 3D game objects", 2001).
class SmoothExpansion {
 public:
  struct Corner {
    SmoothSupport a;
    SmoothSupport b;
    Vec3 point;
  };
  struct Facet {
    std::array<std::size_t, 3> corner{};
    Vec3 normal;  ///< outwards, unit
    double height = 0;
  };

  /// The corners have the origin inside.
  SmoothExpansion(const SmoothBody& a, const SmoothBody& b, std::span<const SmoothSearch::Corner> four);

  /// Until the nearest facet is `part` of its height below the surface of A − B, or has so many corners.
  void grow(double part, std::size_t most_corners);

  [[nodiscard]] const Facet& nearest() const;
  [[nodiscard]] const Corner& corner(std::size_t i) const { return corner_[i]; }

  /// No point of the surface of A − B is certainly nearer to the origin; 0 where nothing is certain.
  [[nodiscard]] double proved_depth() const;

 private:
  void add_facet(std::size_t i, std::size_t j, std::size_t k);
  /// False, and nothing is changed, where rounding lets no closed surface come of it.
  bool add_corner(const Corner& corner);

  const SmoothBody& a_;
  const SmoothBody& b_;
  std::vector<Corner> corner_;
  std::vector<Facet> facet_;
};

}  // namespace toccata
