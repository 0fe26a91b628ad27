#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <optional>
#include <span>
#include <vector>

#include "narrow/quadrics/depth/growing_surface.hpp"
#include "narrow/quadrics/depth/quadric_cap.hpp"

namespace toccata {

/// The tangent, no less, of the cap of directions that a raised corner stands for, s times the axis, where only heights
/// below L matter. The axis' length, 1 but for 3 roundings, and those here, 4, take a fifth of the 32.
[[nodiscard]] inline double tangent_of_raised(double times, double least) {
  const double ratio = times / least * (1 + 0x1p-48);
  return std::sqrt(std::fmax(ratio * ratio - 1, 0));
}

/// Searches the direction along which A − B is lowest, all over the sphere: a polytope around the origin grows where it
/// is lowest (G. van den Bergen, "Proximity queries and penetration depth computation on 3D game objects", 2001). Its
/// corners are points of A − B, or *raised* ones beyond its surface, s d for the axis d of a cap of directions with
/// tangent t, where no height is less than L (`QuadricCap`). A direction is then either in such a cap, or it has
/// s d · e < L |e| for all raised corners: where all facets are L high, some point of A − B is L high along it. So
/// round places need no end of corners.
class QuadricExpansion {
 public:
  using Precision = GrowingSurface::Precision;

  QuadricExpansion(const QuadricBody& a, const QuadricBody& b);

  /// Until no facet is lower than the lowest height found by more than this part of it; false when that did not come to
  /// an end, or a height is not positive: then the origin does not lie within A − B, or hardly.
  bool run(double part, Precision precision);

  /// The lowest height found, rounded, and its direction; infinite before all.
  [[nodiscard]] double upper() const { return upper_; }
  [[nodiscard]] const Vec3& direction() const { return direction_; }

  /// Certainly no height of A − B is less; 0 where nothing is certain. What is raised may come down to get a proof.
  [[nodiscard]] double proved_depth();

 private:
  struct Corner {
    QuadricSupport a;
    QuadricSupport b;
    Vec3 axis;  ///< of a raised corner
    std::array<GeneratorPair, 3> generators{};
    std::size_t generator_count = 0;
    double times = 0;    ///< s; 0 of what was never raised
    double tangent = 0;  ///< t; 0 of what is not raised

    explicit Corner(const HighestPoint& highest) : a(highest.on_a), b(highest.on_b) {}
    Corner(const QuadricCap& cap, double s, double t);
  };

  bool start();
  bool grow();
  double offer(const HighestPoint& highest);
  void offer(double height, const Vec3& axis);
  [[nodiscard]] double target() const;
  [[nodiscard]] bool step(std::size_t facet);
  [[nodiscard]] bool is_promising(const HighestPoint& here, double gain, double missing) const;
  [[nodiscard]] std::optional<QuadricCap> lowest_near(const HighestPoint& from);
  [[nodiscard]] bool is_raised(const Vec3& axis) const;
  bool raise_edge_or_face(std::size_t facet, const HighestPoint& here, double gain);
  [[nodiscard]] bool is_between(const Vec3& axis, std::span<const Vec3> points) const;
  bool raise_around(const Vec3& axis, std::span<const GeneratorPair> generators, double gain);
  bool raise(const QuadricCap& cap, double gain);
  bool add(const Corner& corner, const Vec3& point, std::size_t facet);
  template <class Number>
  [[nodiscard]] VectorOf<Number> exact_corner(const Corner& corner) const;
  template <class Number>
  [[nodiscard]] static double proved_height(const std::array<VectorOf<Number>, 3>& corner);
  [[nodiscard]] GrowingSurface::Corner placed(const Corner& corner, const Vec3& point) const;
  [[nodiscard]] double corner_error() const;
  [[nodiscard]] bool has_come_down(std::size_t facet) const;
  template <class Number>
  [[nodiscard]] double proved_height(std::size_t facet) const;
  [[nodiscard]] double proved_lowest(double enough) const;
  bool lower_caps(double least);

  const QuadricBody& a_;
  const QuadricBody& b_;
  Precision precision_ = Precision::plain;
  GrowingSurface surface_;
  bool has_surface_ = false;
  alignas(64) std::array<std::byte, sizeof(Corner) * GrowingSurface::most_corners + 64> buffer_;
  std::pmr::monotonic_buffer_resource memory_;
  std::pmr::vector<Corner> corner_;
  double part_ = 0;
  double highest_target_ = 0;  ///< that corners were raised for
  double upper_ = HUGE_VAL;
  Vec3 direction_;
};

}  // namespace toccata
