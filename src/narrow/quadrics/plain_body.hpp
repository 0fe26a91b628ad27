#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "narrow/convex/gjk.hpp"
#include "narrow/quadrics/pair_frame.hpp"

namespace toccata {

/// A point of a body that is the farthest along a direction, but for rounding.
struct QuadricSupport {
  Index generator = 0;
  Vec3 round;  ///< in units of the columns; within the ball of radius 1 but for rounding
  Vec3 point;  ///< in the pair's frame, rounded
};

/// The search of a hull's vertices with the kernels that it refers to.
struct HullSearch {
  explicit HullSearch(const PosedPolytope& shape) : kernels(support_kernels()), search(shape, kernels) {}
  HullSearch(const HullSearch& other) : HullSearch(other.search.shape()) {}
  HullSearch& operator=(const HullSearch&) = delete;
  ~HullSearch() = default;

  SupportKernels kernels;
  SupportSearch search;
};

/// One shape of a pair, whichever it is, as the convex hull of generators, in doubles: what searches look at. All
/// generators are copies of one ball of up to three dimensions under a linear map, placed at a centre each, or the bare
/// centre: of an ellipsoid one generator, of a cylinder two discs, of a cone a disc and a point, of a polytope its
/// vertices, of a rounded shape balls. So Σ λ_i centre_i + (Σ λ_i grown_i) · Σ_j u_j column_j is a point of the body,
/// for weights λ that are not negative and have the sum 1, and |u| ≤ 1; and every point of it is that.
class PlainBody {
 public:
  PlainBody(const PosedQuadric& shape, const PairFrame& frame);
  PlainBody(const PosedPolytope& shape, const PairFrame& frame);

  [[nodiscard]] Index generator_count() const { return count_; }
  [[nodiscard]] std::size_t column_count() const { return columns_; }
  [[nodiscard]] bool grown(Index generator) const { return columns_ > 0 && !(has_tip_ && generator == 1); }
  /// The last generator of a quadric is a point.
  [[nodiscard]] bool has_tip() const { return has_tip_; }
  /// The kind of a quadric; none for a polytope.
  [[nodiscard]] const std::optional<PosedQuadric::Kind>& quadric_kind() const { return kind_; }

  // In the pair's frame.
  [[nodiscard]] Vec3 plain_centre(Index generator) const {
    return search_ ? frame_.plainly_placed(search_->search.vertex(generator)) : plain_centre_[generator];
  }
  /// Some inner point, for a first direction.
  [[nodiscard]] Vec3 middle() const { return 0.5 * (plain_centre(0) + plain_centre(count_ - 1)); }
  [[nodiscard]] const Vec3& plain_column(std::size_t j) const { return plain_column_[j]; }
  [[nodiscard]] QuadricSupport support(const Vec3& direction) const;
  /// Σ_j u_j column_j.
  [[nodiscard]] Vec3 map(const Vec3& round) const {
    return (round.x * plain_column_[0] + round.y * plain_column_[1]) + round.z * plain_column_[2];
  }
  /// The products of the direction with the columns; 0 beyond them.
  [[nodiscard]] Vec3 along_columns(const Vec3& direction) const {
    return {dot(direction, plain_column_[0]), dot(direction, plain_column_[1]), dot(direction, plain_column_[2])};
  }

  /// No point of the body is higher along the direction, which is no longer than 1: certain, where the frame's factor,
  /// half axes and radii are from 2⁻³⁰⁰ to 2³⁰⁰.
  [[nodiscard]] double height_at_most(const Vec3& direction) const;

  /// The body of a quadric at another place.
  [[nodiscard]] PlainBody moved(const Vec3& by) const;

  /// Writes all generators of which rounding does not exclude that they are the farthest along the direction, if they
  /// fit, and returns how many there are.
  [[nodiscard]] Index highest_generators(const Vec3& direction, std::span<Index> found) const;

 protected:
  explicit PlainBody(const Vec3& point) : count_(1) { plain_centre_[0] = point; }

  const PosedPolytope* hull_ = nullptr;
  std::optional<HullSearch> search_;
  PairFrame frame_;
  Index count_ = 0;
  std::size_t columns_ = 0;
  bool has_tip_ = false;
  std::optional<PosedQuadric::Kind> kind_;
  std::array<Vec3, 8> plain_centre_{};
  std::array<Vec3, 3> plain_column_{};
};

}  // namespace toccata
