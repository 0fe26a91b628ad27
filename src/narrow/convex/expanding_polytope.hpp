#pragma once

#include <array>
#include <cmath>
#include <memory_resource>
#include <vector>

#include "math/constants.hpp"
#include "narrow/convex/difference_body.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {

/// n / |n|, each component off by at most 2^-50; n is not 0.
[[nodiscard]] Vec3 unit_vector(const IntegerVector& n);

/// A triangle of a convex polytope within D, scaled. It turns counter-clockwise seen from outside.
struct PolytopeFacet {
  std::array<Index, 3> corner{};
  std::array<Index, 3> neighbour{};  ///< across the edge from corner[k] to corner[(k + 1) % 3]
  Vec3 normal{};                     ///< outwards; unit when the facet is precise
  double offset = 0;                 ///< normal · corner
  double error = 0;                  ///< of the offset, and of the heights of points, along that normal
  double lower = 0;                  ///< the exact distance of its plane from the origin is no less,
  double upper = 0;                  ///< and no more: of precise facets only
  Index exact = none;                ///< its exact plane, once it was needed
  bool precise = false;              ///< computed to about twice the digits of a double, or exactly
  bool alive = true;
  static constexpr Index none = ~Index{0};
};

/// A convex polytope of points of D that grows by its farthest points. Which facets a new point sees is decided by
/// exact signs, so it is convex at every moment. While all facets have the origin behind them, the ball around the
/// origin that reaches the nearest plane lies within it, and so within D.
class ExpandingPolytope {
 public:
  explicit ExpandingPolytope(const DifferenceBody& body);

  /// Begins with a tetrahedron of D; false when D is flat: a polygon, a segment or a point.
  [[nodiscard]] bool start();
  /// Across a flat D, unit.
  [[nodiscard]] const Vec3& flat_direction() const { return flat_direction_; }

  /// Facets that are farther away than this need not be looked at. It may only fall, and never below the least distance
  /// of D's boundary.
  void set_upper(double upper) { upper_ = upper; }
  /// The living facet whose `lower` is the least; of equals, the oldest.
  [[nodiscard]] Index nearest();
  /// Outwards, of length 1 up to 2^-51.
  [[nodiscard]] Vec3 unit_normal(Index f) const {
    const Vec3& n = facets_[f].normal;
    return facets_[f].precise ? n : (1 / std::sqrt(dot(n, n))) * n;
  }
  [[nodiscard]] const PolytopeFacet& facet(Index f) const { return facets_[f]; }
  [[nodiscard]] const DifferencePoint& corner(Index f, std::size_t k) const { return points_[facets_[f].corner[k]]; }
  [[nodiscard]] Index point_count() const { return static_cast<Index>(points_.size()); }

  /// Along the facet's normal, off by its `error`.
  [[nodiscard]] double height(Index f, const DifferencePoint& p) const {
    return dot(facets_[f].normal, p.value - corner(f, 0).value);
  }

  /// Computes the facet's plane with more digits; to the end where these are too few to make it precise.
  void make_precise(Index f);
  /// No point of D lies above the precise facet, as far as rounded heights and the facet's own corners can tell.
  [[nodiscard]] bool is_certainly_of_body(Index f) const;
  /// Computes the facet's plane exactly: its distance is then known to 2^-51 of itself.
  void make_exact(Index f);
  [[nodiscard]] bool is_exact(Index f) const { return facets_[f].exact != PolytopeFacet::none; }
  /// The point of D that is farthest above an exact facet, exactly; and whether it is above it at all.
  struct ExactSupport {
    DifferencePoint point;
    Sign height = Sign::zero;
  };
  [[nodiscard]] ExactSupport exact_support(Index f) const;

  /// Where the foot of the origin lies in the facet's plane: its weights, which add up to 1, each off by 2^-53 of
  /// itself. In doubles those of a needle would be rough.
  [[nodiscard]] std::array<double, 3> weights_of_foot(Index f) const;

  /// The hull with a point that lies above the facet. False when the facets it sees are not a disc, which exact signs
  /// exclude.
  [[nodiscard]] bool add(const DifferencePoint& point, Index above);

 private:
  struct ExactPlane {
    IntegerVector normal;
    WideInteger offset;
  };
  struct HorizonEdge {
    Index from;
    Index to;
    Index hidden;  ///< the facet on the far side, which the point does not see
  };
  struct Walk {
    Index facet;
    std::size_t edge;
    int left;
  };
  struct QueueEntry {
    double lower = 0;
    Index facet = 0;
  };

  [[nodiscard]] bool start_roughly();
  [[nodiscard]] bool start_exactly();
  void make_tetrahedron(const std::array<DifferencePoint, 4>& points);
  [[nodiscard]] Sign orientation(const std::array<DifferencePoint, 4>& points) const;
  Index add_facet(Index p, Index q, Index r);
  void measure(PolytopeFacet& facet) const;
  void settle(Index f, const Vec3& unit_normal, double distance, double lower, double upper);
  void enqueue(Index f);
  [[nodiscard]] bool completes_parallelogram(Index f, const DifferencePoint& p) const;
  [[nodiscard]] Sign height_sign(Index f, const DifferencePoint& p);
  [[nodiscard]] bool sees(const DifferencePoint& p, Index f);
  void find_horizon(const DifferencePoint& point, Index above);
  [[nodiscard]] std::size_t edge_towards(Index f, Index neighbour) const;
  [[nodiscard]] bool horizon_is_a_loop() const;

  const DifferenceBody& body_;
  double upper_ = infinity;
  alignas(64) std::array<std::byte, 48 * 1024> buffer_;
  std::pmr::monotonic_buffer_resource memory_;
  std::pmr::vector<DifferencePoint> points_;
  std::pmr::vector<PolytopeFacet> facets_;
  std::pmr::vector<QueueEntry> queue_;
  std::pmr::vector<HorizonEdge> horizon_;
  std::pmr::vector<Walk> walk_;
  std::vector<ExactPlane> planes_;
  Vec3 flat_direction_{};
};

}  // namespace toccata
