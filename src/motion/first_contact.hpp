#pragma once

#include <optional>

#include "motion/point_bounds.hpp"
#include "toccata/core/status.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// Two convex sets that move, as the search for their first contact sees them.
class MovingPair {
 public:
  /// A direction of length 1, from the first to the second: along it they seem to be farthest apart at the time. Zero
  /// where they seem to meet. A guess.
  [[nodiscard]] virtual Vec3 direction(double time) = 0;

  /// So far they are certainly apart along the direction then; negative where they are not, and NaN where nothing is
  /// certain. For a half-space its normal is the direction, whatever is given.
  [[nodiscard]] virtual double separation(double time, const Vec3& direction) = 0;

  /// A separation along a direction that is shorter than 1 tells of no more than one along a direction of length 1.
  [[nodiscard]] virtual bool may_turn() const = 0;

  /// Whether they certainly have a point in common then. False says nothing.
  [[nodiscard]] virtual bool surely_meet(double time) = 0;

 protected:
  ~MovingPair() = default;
};

/// They do not meet before `lower`. Exact: they have met by `upper`; undecided: at `lower`, which `upper` is then, they
/// are nearer than rounding tells.
struct FirstContact {
  double lower = 0;
  double upper = 0;
  Vec3 normal{};  ///< from the second to the first
  Status status = Status::exact;
};

/// Nothing where they are proved not to meet in the stretch.
///
/// Advances from separation to separation: a direction that parts the two at one time parts them up to another when
/// what it leaves between them at both is more than the points' bending can take away in between (least_between), and
/// so does one that turns from the best of the one time to the best of the other. The gap that is left may so be
/// crossed in steps that go with its root, and not with itself as in conservative advancement (B. V. Mirtich,
/// "Impulse-based dynamic simulation of rigid body systems", 1996); and towards a contact the gap that a step leaves
/// goes with the square of the gap before it.
[[nodiscard]] std::optional<FirstContact> first_contact(MovingPair& pair, const TimeStretch& stretch,
                                                        const GapBounds& bounds);

}  // namespace toccata
