#include "world/character_mover/moved_objects.hpp"

#include <algorithm>

#include "toccata/motion/rigid_motion.hpp"

namespace toccata {
namespace {

/// How many times one object may push in a step: once for each side that it shows as it turns.
constexpr int most_pushes = 8;

/// How a point of an object moves as the object goes from one pose to another.
Vec3 displacement_of(const Vec3& point, const Pose& before, const Pose& after) {
  return after * (inverse(before) * point) - point;
}

/// An object that comes the character's way, in the level.
class PushingObject {
 public:
  /// It begins where it is told to.
  PushingObject(const MovedIndex& from, const SearchedObjects& objects, const MoverBody& body, double gap)
      : objects_(objects), object_(from.object), body_(body), gap_(gap), begin_(from.before) {}

  /// The way that it pushes the body next, if it meets it. What slips along the body, or leaves it, and is no farther
  /// than the gap, may meet it later on its way: so it is asked for what comes nearer.
  [[nodiscard]] std::optional<Vec3> next_push(const Vec3& position) {
    return ask_about(object_, objects_, [&](const InstanceView& at) { return next_push_of(at, position); });
  }

 private:
  std::optional<Vec3> next_push_of(const InstanceView& at, const Vec3& position) {
    for (const double gap : {gap_, 0.25 * gap_, 0.0}) {
      const RigidMotion motion = RigidMotion::between(begin_, at.pose);
      const SweepQuery query{Solid::automatic, at.solid, gap};
      const std::optional<ShapeHit> met =
          sweep(body_.model(), RigidMotion(body_.pose_at(position)), at.model, motion, query);
      if (!met) return {};
      const Pose there = met->lower > 0 ? motion.at(met->lower) : begin_;
      const double way = dot(displacement_of(met->point, there, at.pose), met->normal);
      if (!(way > 0)) continue;
      begin_ = there;
      return way * met->normal;
    }
    return {};
  }

  const SearchedObjects& objects_;
  Index object_;
  const MoverBody& body_;
  double gap_;
  Pose begin_;
};

/// How a character is carried and pushed, one object after the other.
class Carrying {
 public:
  Carrying(const Vec3& position, const SearchedObjects& objects, MoverWalk& walk, const MoverBody& body, double gap)
      : objects_(objects), walk_(walk), body_(body), gap_(gap), place_{position} {}

  /// Where something keeps the character from going along, its carrier has gone on under it, and may meet it.
  void carry(const Vec3& stand, const MovedIndex& carrier) {
    const Pose& now = objects_.at(carrier.object).pose;
    const Vec3 by = displacement_of(stand, carrier.before, now);
    const Vec3 wanted = place_.position + by;
    go(by, carrier.object);
    const Vec3 missing = wanted - place_.position;
    if (!(missing == Vec3{})) push_from({carrier.object, {now.linear, now.offset - missing}});
  }

  void push_from(const MovedIndex& begin) {
    PushingObject pushing(begin, objects_, body_, gap_);
    for (int i = 0; i < most_pushes; ++i) {
      const std::optional<Vec3> push = pushing.next_push(place_.position);
      if (!push) return;
      const Vec3 from = place_.position;
      go(*push, begin.object);
      const double done = dot(place_.position - from, *push) / dot(*push, *push);
      if (done < 0.5) {
        place_.crushed = true;
        return;
      }
    }
    if (pushing.next_push(place_.position)) place_.crushed = true;
  }

  [[nodiscard]] const CarriedPlace& place() const { return place_; }

 private:
  void go(const Vec3& by, Index pushing) {
    const SlideEnd end = walk_.slide(place_.position, by, Footing::free, pushing);
    place_.position = end.position;
    place_.cut_short = place_.cut_short || end.cut_short;
  }

  const SearchedObjects& objects_;
  MoverWalk& walk_;
  const MoverBody& body_;
  double gap_;
  CarriedPlace place_;
};

}  // namespace

CarriedPlace carried_along(const Vec3& position, const std::optional<MoverStand>& stand,
                           std::span<const MovedIndex> moved, const SearchedObjects& objects, MoverWalk& walk,
                           const MoverBody& body, double gap) {
  Carrying carrying(position, objects, walk, body, gap);
  const auto carries = [&](const MovedIndex& one) { return stand && stand->object == one.object; };
  for (const MovedIndex& one : moved)
    if (carries(one) && objects.accepts(one.object)) carrying.carry(stand->point, one);
  for (const MovedIndex& one : moved)
    if (!carries(one) && objects.accepts(one.object)) carrying.push_from(one);
  return carrying.place();
}

}  // namespace toccata
