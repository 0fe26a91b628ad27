#pragma once

#include <optional>
#include <variant>

#include "oracle/quadrics.hpp"
#include "toccata/motion/rigid_motion.hpp"

// Bodies that move and turn, slowly: 60 digits, and nothing of the library but the plain structs that hold its input.
// No tree, and no bound but how fast points are and how their ways bend.
namespace toccata::oracle {

struct FineHalfSpace {
  FinePoint point;
  FinePoint normal;
};

/// A convex set where it is at the start, and how it moves from there.
struct FineBody {
  std::variant<FineSet, FineHalfSpace> set;
  RigidMove move;
};

/// The set at the part `time` of its move.
FineBody moved(const FineBody& body, const Fine& time);

/// How near the two are at a time; of a half-space the height over it, which `lower` and `upper` both are. Not for two
/// half-spaces.
FineNearness nearness_at(const FineBody& a, const FineBody& b, const Fine& time);

/// Whether they have a point in common then.
bool meet_at(const FineBody& a, const FineBody& b, double time);

/// The first contact. Free: they are apart at all times. Hit: apart before `lower`, and they meet by `upper`.
/// Undecided: apart before `lower`; later they come so near that the subdivision ends.
struct FineContact {
  enum class Kind { free, hit, undecided } kind = Kind::free;
  Fine lower = 0;
  Fine upper = 1;
};

/// Halves [0, 1]: in an interval they are apart when at its middle they are farther apart than points can travel in
/// half of it, or so far along a direction that turns that they stay apart along it. That is looked at in `long
/// double`, and believed where more than its rounding is left (quick_motion.hpp). Ends where intervals are narrower
/// than `narrowest`, at least 2⁻⁴⁰; contact is looked for at their middles and ends.
FineContact first_contact(const FineBody& a, const FineBody& b, double narrowest);

}  // namespace toccata::oracle
