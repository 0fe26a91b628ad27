#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "query/decomposition/solid_frame.hpp"
#include "query/decomposition/solid_piece.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// An edge at which the solid is not convex, and the planes that would cut there.
struct ReflexEdge {
  std::array<Vec3, 2> ends;  ///< local
  double weight = 0;
  std::array<Index, 2> planes{};  ///< of both faces

  [[nodiscard]] Vec3 middle() const { return 0.5 * (ends[0] + ends[1]); }
};

struct WeightedPlane {
  PlaneChoice choice;
  RoundedPlane plane;
};

/// The planes through the edges of a mesh at which its solid is not convex: those of most weight.
struct ReflexPlanes {
  std::vector<ReflexEdge> edges;
  std::vector<WeightedPlane> planes;
};

/// `outward` is −1 for a mesh that is inside out, else 1.
[[nodiscard]] ReflexPlanes reflex_planes(const TriangleMesh& mesh, const SolidFrame& frame, double outward);

/// Half of space that a piece lies in.
struct CellSide {
  Index plane = 0;
  int sign = 1;
};

/// Where to cut a piece best, by the volume that the hulls of both sides exceed them by, and by the edges at which the
/// solid is no longer concave after the cut.
class CutSearch {
 public:
  CutSearch(const SolidFrame& frame, const ReflexPlanes& reflex, int threads)
      : frame_(frame), reflex_(reflex), threads_(threads) {}

  /// None where no plane has something of the piece on both sides.
  [[nodiscard]] std::optional<PlaneChoice> best_cut(const SolidPiece& piece, std::span<const RoundedPlane> planes,
                                                    std::span<const CellSide> cell, double excess) const;

 private:
  [[nodiscard]] std::vector<PlaneChoice> candidates(const SolidPiece& piece,
                                                    std::span<const ReflexEdge* const> edges) const;
  [[nodiscard]] std::vector<const ReflexEdge*> edges_in(std::span<const RoundedPlane> planes,
                                                        std::span<const CellSide> cell) const;
  void add_reflex(std::vector<PlaneChoice>& choices, std::span<const ReflexEdge* const> edges) const;

  const SolidFrame& frame_;
  const ReflexPlanes& reflex_;
  int threads_;
};

}  // namespace toccata
