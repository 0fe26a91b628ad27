#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "narrow/smooth/depth/growing_surface.hpp"
#include "narrow/smooth/depth/smooth_cap.hpp"

namespace toccata {

/// Searches the direction along which A − B is lowest, all over the sphere: a polytope around the origin grows where it
/// is lowest (G. van den Bergen, "Proximity queries and penetration depth computation on 3D game objects", 2001). Its
/// corners are points of A − B, or *raised* ones beyond its surface, s d for the axis d of a cap of directions with
/// tangent t, where no height is less than L (`SmoothCap`). A direction is then either in such a cap, or it has
/// s d · e < L |e| for all raised corners: where all facets are L high, some point of A − B is L high along it. So
/// round places need no end of corners.
class SmoothExpansion {
 public:
  SmoothExpansion(const SmoothBody& a, const SmoothBody& b) : a_(a), b_(b) {}

  /// Until no facet is lower than the lowest height found by more than this part of it; false when that did not come to
  /// an end. The origin lies within A − B.
  bool run(double part);

  /// The lowest height found, rounded, and its direction; infinite before all.
  [[nodiscard]] double upper() const { return upper_; }
  [[nodiscard]] const Vec3& direction() const { return direction_; }

  /// Certainly no height of A − B is less; 0 where nothing is certain. What is raised may come down to get a proof.
  [[nodiscard]] double proved_depth();

 private:
  struct Corner {
    SmoothSupport a;
    SmoothSupport b;
    Vec3 axis;  ///< of a raised corner
    std::array<AtomPair, 3> atoms{};
    std::size_t atom_count = 0;
    double times = 0;    ///< s
    double tangent = 0;  ///< t; 0 of what is not raised
  };

  bool start();
  bool grow();
  void offer(SmoothCap& cap);
  [[nodiscard]] double target() const;
  [[nodiscard]] bool step(std::size_t facet);
  [[nodiscard]] bool is_promising(const SmoothCap& here, double gain, double missing) const;
  [[nodiscard]] SmoothCap lowest_near(const SmoothCap& from);
  bool raise_edge_or_face(std::size_t facet, const SmoothCap& here, double gain);
  bool raise_around(const Vec3& axis, std::span<const AtomPair> atoms, double gain);
  bool raise(const SmoothCap& cap, double gain);
  void append(const SmoothCap& cap);
  template <class Number>
  [[nodiscard]] VectorOf<Number> exact_corner(std::size_t i) const;
  template <class Number>
  [[nodiscard]] static double proved_height(const std::array<VectorOf<Number>, 3>& corner);
  [[nodiscard]] std::array<std::uint16_t, 3> nearest_first(std::size_t facet) const;
  [[nodiscard]] double proved_lowest(double enough) const;
  bool lower_caps(double least);

  const SmoothBody& a_;
  const SmoothBody& b_;
  GrowingSurface surface_;
  std::array<Corner, GrowingSurface::most_corners> corner_;
  double part_ = 0;
  double highest_target_ = 0;  ///< that corners were raised for
  double upper_ = HUGE_VAL;
  Vec3 direction_;
};

}  // namespace toccata
