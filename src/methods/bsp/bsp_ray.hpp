#pragma once

#include <vector>

#include "methods/bsp/bsp_parts.hpp"
#include "toccata/core/function_ref.hpp"

namespace toccata {

/// Walks through the cells along a segment in their order. Where it passes a plane is known to within an interval, and
/// both sides have all of the segment that may be there: so nothing is missed, and who asks decides triangles exactly.
class BspRayWalk {
 public:
  /// From `origin` to `origin + motion`, each coordinate of which may be off by 2^-53 of the motion's.
  BspRayWalk(const BspTree::Parts& parts, const Vec3& origin, const Vec3& motion)
      : parts_(parts), origin_(origin), motion_(motion) {}

  /// Is told each triangle that may be met, some several times, and answers from which time on none is of interest.
  using Meet = FunctionRef<double(Index)>;
  void run(Meet meet);

 private:
  /// A cell and which part of the ray may be in it, as fractions of the part within the box of the mesh.
  struct Stretch {
    BspChild at = 0;
    double from = 0;
    double to = 1;
  };
  /// Of the heights above a node's plane: where they begin, how they go on, and what they are off by.
  struct Heights {
    double start = 0;
    double rise = 0;
    double error = 0;
    [[nodiscard]] bool certainly_above(const Stretch& s) const {
      return start + s.from * rise > error && start + s.to * rise > error;
    }
    [[nodiscard]] bool certainly_below(const Stretch& s) const {
      return start + s.from * rise < -error && start + s.to * rise < -error;
    }
  };

  [[nodiscard]] bool enter_box();
  [[nodiscard]] Heights heights(const FloatBspPlane& plane) const;
  void pass(Stretch stretch, Meet meet);
  void push_both_sides(const Stretch& stretch, const BspNode& node, const Heights& heights);
  [[nodiscard]] bool is_too_late(const Stretch& stretch) const;

  const BspTree::Parts& parts_;
  Vec3 origin_;
  Vec3 motion_;
  double latest_ = 1;  ///< of the times of interest
  double enters_ = 0;  ///< the times between which the ray may be within the box
  double leaves_ = 1;
  Vec3 start_;      ///< in the unit of FloatBspPlane, where it enters
  Vec3 way_;        ///< from there to where it leaves
  double off_ = 0;  ///< what any coordinate of either is off by at most
  std::vector<Stretch> waiting_;
};

}  // namespace toccata
