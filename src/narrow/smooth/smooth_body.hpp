#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "narrow/convex/gjk.hpp"
#include "narrow/smooth/number_vector.hpp"
#include "toccata/narrow/posed_convex.hpp"
#include "toccata/narrow/posed_smooth.hpp"

namespace toccata {

/// Where the searches and proofs for a pair happen: the world moved by −origin and multiplied by a power of two, so
/// that neither a place far from the origin nor tiny or huge lengths cost digits.
struct PairFrame {
  Vec3 origin;
  double factor = 1;

  [[nodiscard]] BoundedVector place(const Vec3& world) const;
  [[nodiscard]] BoundedVector scaled(const Vec3& world) const;
  [[nodiscard]] Vec3 back(const Vec3& placed) const;
};

[[nodiscard]] PairFrame pair_frame(const PosedSmooth& a, const PosedSmooth& b);
[[nodiscard]] PairFrame pair_frame(const PosedSmooth& a, const PosedConvex& b);

/// A point of a body that is the farthest along a direction, but for rounding.
struct SmoothSupport {
  Index atom = 0;
  Vec3 round;  ///< in units of the columns; within the ball of radius 1 but for rounding
  Vec3 point;  ///< in the pair's frame, rounded
};

/// One shape of a pair, whichever it is, as the convex hull of atoms. All atoms are copies of one ball of up to three
/// dimensions under a linear map, placed at a centre each, or the bare centre: of an ellipsoid one atom, of a cylinder
/// two discs, of a cone a disc and a point, of a polytope its vertices, of a rounded shape balls. So
/// Σ λ_i centre_i + (Σ λ_i grown_i) · Σ_j u_j column_j is a point of the body, for weights λ that are not negative and
/// have the sum 1, and |u| ≤ 1; and every point of it is that.
class SmoothBody {
 public:
  SmoothBody(const PosedSmooth& shape, const PairFrame& frame);
  SmoothBody(const PosedConvex& shape, const PairFrame& frame, const SupportKernels& kernels);
  explicit SmoothBody(const BoundedVector& point);

  [[nodiscard]] Index atom_count() const { return count_; }
  [[nodiscard]] std::size_t column_count() const { return columns_; }
  [[nodiscard]] bool grown(Index atom) const { return columns_ > 0 && !(is_cone_ && atom == 1); }

  [[nodiscard]] BoundedVector centre(Index atom) const;
  [[nodiscard]] const BoundedVector& column(std::size_t j) const { return column_[j]; }
  /// Of a smooth shape: the images of its half axes, of the radius twice and the half height.
  [[nodiscard]] const std::array<BoundedVector, 3>& axes() const { return axes_; }
  [[nodiscard]] const std::optional<PosedSmooth::Kind>& smooth_kind() const { return kind_; }
  /// The body of a smooth shape, moved.
  [[nodiscard]] SmoothBody moved(const BoundedVector& by) const;
  /// Of a smooth shape: the map that makes it as long as it is wide, rounded.
  [[nodiscard]] Mat3 roundness() const;
  [[nodiscard]] const BoundedVector& middle_point() const { return middle_; }

  // In doubles, in the pair's frame.
  [[nodiscard]] Vec3 plain_centre(Index atom) const;
  [[nodiscard]] const Vec3& plain_column(std::size_t j) const { return plain_column_[j]; }
  [[nodiscard]] SmoothSupport support(const Vec3& direction) const;
  /// Σ_j u_j column_j.
  [[nodiscard]] Vec3 map(const Vec3& round) const;
  /// The products of the direction with the columns; 0 beyond them.
  [[nodiscard]] Vec3 along_columns(const Vec3& direction) const;

  /// Writes all atoms of which rounding does not exclude that they are the farthest along the direction, if they fit,
  /// and returns how many there are.
  [[nodiscard]] Index highest_atoms(const Vec3& direction, std::span<Index> found) const;

 private:
  const PosedConvex* hull_ = nullptr;
  std::optional<SupportSearch> search_;
  PairFrame frame_;
  Index count_ = 0;
  std::size_t columns_ = 0;
  bool is_cone_ = false;
  std::optional<PosedSmooth::Kind> kind_;
  std::array<BoundedVector, 2> centre_{};
  std::array<BoundedVector, 3> column_{};
  std::array<BoundedVector, 3> axes_{};
  BoundedVector middle_{};
  std::array<Vec3, 8> plain_centre_{};
  std::array<Vec3, 3> plain_column_{};
};

}  // namespace toccata
