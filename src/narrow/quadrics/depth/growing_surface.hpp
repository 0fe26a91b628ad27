#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "math/number_vector.hpp"
#include "narrow/convex/facet_slots.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// A closed surface of triangles around the origin that grows by points beyond its facets. Each point replaces a disc
/// of facets by a fan, so that the surface stays a sphere whatever rounding does; it need not be convex. Planes are
/// found in doubles or, where doubles see slim facets as flat, from corners of 106 bits.
class GrowingSurface {
 public:
  static constexpr std::size_t most_corners = 128;

  using FinePoint = FineVector;
  struct Corner {
    Vec3 point;
    FinePoint fine;  ///< of a fine surface
  };

  enum class Precision : std::uint8_t { plain, fine };

  /// Begins with a tetrahedron; false when it is flat.
  bool start(Precision precision, const std::array<Corner, 4>& corners);

  [[nodiscard]] bool is_fine() const { return precision_ == Precision::fine; }
  [[nodiscard]] std::size_t corner_count() const { return corners_; }
  [[nodiscard]] bool full() const { return corners_ == most_corners; }
  [[nodiscard]] Vec3 corner(std::size_t i) const { return {x_[i], y_[i], z_[i]}; }

  /// With vacant ones.
  [[nodiscard]] std::size_t facet_count() const { return slots_.count(); }
  [[nodiscard]] bool is_vacant(std::size_t f) const { return slots_.is_vacant(f); }
  /// Outwards, unit but for rounding.
  [[nodiscard]] Vec3 normal(std::size_t f) const { return {normal_x_[f], normal_y_[f], normal_z_[f]}; }
  /// The height of its plane along the normal; infinite for a vacant slot.
  [[nodiscard]] double height(std::size_t f) const { return height_[f]; }
  [[nodiscard]] FacetSlots::Corners corners_of(std::size_t f) const { return slots_.corners(f); }
  /// That of the facet's corners which is nearest to the origin is the first of them.
  [[nodiscard]] FacetSlots::Corners nearest_first(std::size_t f) const;

  /// The lowest facet that is not settled; of equals, that of the least number. Nothing where all are settled.
  [[nodiscard]] std::optional<std::size_t> lowest() const;
  /// The facet that the point is farthest beyond.
  [[nodiscard]] std::size_t most_before(const Vec3& point) const;
  void settle(std::size_t f) { pending_[f] = HUGE_VAL; }

  /// The surface with a point that lies beyond the facet. False, and nothing is changed, when a facet would have no
  /// area.
  bool add(const Corner& corner, std::size_t beyond);

  /// The facet's plane is certainly higher than that where each of its corners is off by no more than `error`, which is
  /// at least 2⁻⁵⁰ of what the corners' coordinates and these' parts are. It is decided in doubles alone.
  [[nodiscard]] bool is_surely_above(std::size_t f, double height, double error) const;

 private:
  void set(std::size_t i, const Corner& corner);
  /// A vector across the plane of three corners, of any length.
  [[nodiscard]] Vec3 across(std::size_t i, std::size_t j, std::size_t k) const;
  void measure(std::size_t f, const Vec3& product);
  void vacate(std::size_t f);
  [[nodiscard]] bool find_fan(std::size_t beyond, double margin);

  Precision precision_ = Precision::plain;
  std::size_t corners_ = 0;
  double extent_ = 0;
  std::array<double, most_corners> x_, y_, z_;
  std::array<double, most_corners> squared_;  ///< distances from the origin
  std::vector<FinePoint> fine_;               ///< of a fine surface
  FacetSlots slots_;
  std::array<double, FacetSlots::most_facets> normal_x_, normal_y_, normal_z_, height_;
  std::array<double, FacetSlots::most_facets> pending_;  ///< the heights of facets that are not settled, else infinite
  std::array<double, most_corners> fan_x_, fan_y_, fan_z_;  ///< across the facets that are to come
};

}  // namespace toccata
