#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "toccata/core/index.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// A closed surface of triangles around the origin that grows by points beyond its facets, in doubles. Each point
/// replaces a disc of facets by a fan, so that the surface stays a sphere whatever rounding does; it need not be
/// convex.
class GrowingSurface {
 public:
  static constexpr std::size_t most_corners = 128;
  static constexpr std::size_t most_facets = 2 * most_corners;  // of a sphere, less than twice as many as corners

  struct Facet {
    std::array<std::uint16_t, 3> corner{};
    Vec3 normal;        ///< outwards, unit but for rounding
    double height = 0;  ///< of its plane along the normal
    bool settled = false;
  };

  /// Begins with a tetrahedron; false when it is flat.
  bool start(const std::array<Vec3, 4>& corners);

  [[nodiscard]] std::size_t corner_count() const { return corners_; }
  [[nodiscard]] std::size_t facet_count() const { return facets_; }
  [[nodiscard]] bool full() const { return corners_ == most_corners; }
  [[nodiscard]] const Vec3& corner(std::size_t i) const { return point_[i]; }
  [[nodiscard]] const Facet& facet(std::size_t f) const { return facet_[f]; }

  /// The lowest facet that is not settled; of equals, that of the least number. Nothing where all are settled.
  [[nodiscard]] std::optional<std::size_t> lowest() const;
  /// The facet that the point is farthest beyond.
  [[nodiscard]] std::size_t most_before(const Vec3& point) const;
  void settle(std::size_t f) { facet_[f].settled = true; }

  /// The surface with a point that lies beyond the facet. False, and nothing is changed, when a facet would have no
  /// area.
  bool add(const Vec3& point, std::size_t beyond);

 private:
  struct Edge {
    std::uint16_t twin;  ///< of the facet that stays
    std::uint16_t to;
  };

  bool place(std::size_t f, std::size_t i, std::size_t j, std::size_t k);
  [[nodiscard]] bool has_area(std::size_t i, std::size_t j, const Vec3& apex) const;
  void join(std::size_t edge, std::size_t other);
  /// The facets that are seen by more than `margin`, as far as they hang together with the first; and the way around
  /// them.
  void find_disc(const Vec3& point, std::size_t first, double margin);
  [[nodiscard]] bool is_disc() const;
  void make_fan(const Vec3& point);
  /// The last facet takes its slot.
  void remove(std::size_t f);

  std::array<Vec3, most_corners> point_;
  std::array<Facet, most_facets> facet_;
  std::array<std::uint16_t, 4 * most_facets> twin_;  ///< of the edge from corner k of facet f to the next, at 4f + k
  std::size_t corners_ = 0;
  std::size_t facets_ = 0;
  double extent_ = 0;

  std::array<std::uint16_t, most_facets> gone_;
  std::array<bool, most_facets> is_gone_{};
  std::size_t gone_count_ = 0;
  std::array<Edge, most_corners> leaving_;  ///< of the way around, by where the edge begins
  std::size_t around_ = 0;                  ///< edges
  std::uint16_t around_start_ = 0;
};

}  // namespace toccata
