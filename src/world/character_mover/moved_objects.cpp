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
  PushingObject(const MovedIndex& moved, const InstanceView& at, const MoverBody& body, double gap)
      : moved_(moved), at_(at), body_(body), gap_(gap), begin_(moved.before) {}

  /// The way that it pushes the body next, if it meets it.
  [[nodiscard]] std::optional<Vec3> next_push(const Vec3& position) {
    const RigidMotion motion = RigidMotion::between(begin_, at_.pose);
    const SweepQuery query{Solid::automatic, at_.solid, gap_};
    const ShapeHit met = sweep(body_.model(), RigidMotion(body_.pose_at(position)), at_.model, motion, query);
    if (!met.hit) return {};
    begin_ = met.lower > 0 ? motion.at(met.lower) : begin_;
    const double way = dot(displacement_of(met.point, begin_, at_.pose), met.normal);
    if (!(way > 0)) return {};
    return way * met.normal;
  }

  [[nodiscard]] Index object() const { return moved_.object; }

 private:
  const MovedIndex& moved_;
  InstanceView at_;
  const MoverBody& body_;
  double gap_;
  Pose begin_;
};

}  // namespace

CarriedPlace carried_along(const Vec3& position, const std::optional<MoverStand>& stand,
                           std::span<const MovedIndex> moved, const SearchedObjects& objects, MoverWalk& walk,
                           const MoverBody& body, double gap) {
  CarriedPlace place{position};
  for (const MovedIndex& one : moved)
    if (stand && stand->object == one.object && objects.accepts(one.object)) {
      const Vec3 by = displacement_of(stand->point, one.before, objects.at(one.object).pose);
      place.position = walk.slide(place.position, by, Footing::free, one.object).position;
    }
  for (const MovedIndex& one : moved) {
    if (!objects.accepts(one.object) || (stand && stand->object == one.object)) continue;
    PushingObject pushing(one, objects.at(one.object), body, gap);
    for (int i = 0; i < most_pushes; ++i) {
      const std::optional<Vec3> push = pushing.next_push(place.position);
      if (!push) break;
      const Vec3 from = place.position;
      place.position = walk.slide(from, *push, Footing::free, one.object).position;
      const double done = dot(place.position - from, *push) / dot(*push, *push);
      if (done < 0.5) place.crushed = true;
      if (done < 0.5) break;
    }
  }
  return place;
}

}  // namespace toccata
