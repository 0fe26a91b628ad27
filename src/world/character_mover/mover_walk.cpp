#include "world/character_mover/mover_walk.hpp"

#include <algorithm>
#include <cmath>

#include "world/character_mover/face_normals.hpp"

namespace toccata {
namespace {

/// The part of a vector that is not along `up`.
Vec3 horizontal_part(const Vec3& v, const Vec3& up) { return v - dot(v, up) * up; }

/// To a walker a change of height costs a millionth of one of place, so that slopes and steps neither slow nor turn it.
constexpr double walking_height = 0x1p-10;

}  // namespace

/// The motion that is nearest to the wanted one and goes into no plane. A slope too steep to be walked on is a wall to
/// what would climb it.
Vec3 MoverWalk::allowed(const Vec3& wanted, std::span<const Plane> planes, Footing footing) const {
  std::vector<MotionPlane> kept;
  for (const Plane& plane : planes) {
    if (plane.gap.distance > 2 * setting_.skin) continue;
    const Vec3& normal = plane.gap.normal;
    kept.push_back({normal, 0});
    const double height = dot(normal, setting_.up);
    if (height > 0x1p-30 && height < setting_.level_cosine)
      kept.push_back({normalized(horizontal_part(normal, setting_.up)), 0});
  }
  const MotionCost cost{setting_.up, footing == Footing::walking ? walking_height : 1};
  return nearest_motion(wanted, kept, cost).value_or(Vec3{});
}

/// When the thing that is met is as far as the skin: the distance is a convex function of time, so it is not less
/// before than its slope tells. 0 where that is no more than a hair from the start.
double MoverWalk::time_at_skin(const MoverMeeting& met, const Vec3& motion) const {
  const double approach = -dot(met.gap.normal, motion);
  const double missing = setting_.skin - met.gap.distance;
  const double time = missing > 0 ? (approach > 0 ? met.time - missing / approach : 0) : met.time;
  return time * length(motion) > 0x1p-8 * setting_.skin ? time : 0;
}

/// As far as to what is met next; no if nothing is, or no motion is left.
bool MoverWalk::goes_on(Sliding& way, std::optional<Index> without) {
  SlideEnd& end = way.end;
  const Vec3 motion = allowed(way.rest, way.planes, way.footing);
  if (!(length(motion) > way.least)) return false;
  const std::optional<MoverMeeting> met = around_.first_meeting(end.position, motion, without);
  if (!met) {
    end.position += motion;
    return false;
  }
  const double time = time_at_skin(*met, motion);
  end.position += time * motion;
  way.rest = (1 - time) * way.rest;
  for (Plane& plane : way.planes) plane.gap = around_.body().gap_at(end.position, plane.thing);
  way.planes.push_back({met->thing, met->gap});
  end.contacts.push_back({met->thing.object, met->thing.element, met->gap.point, met->gap.normal});
  end.cut_short = end.cut_short || !met->is_proved;
  return true;
}

SlideEnd MoverWalk::slide(const Vec3& position, const Vec3& wanted, Footing footing, std::optional<Index> without) {
  Sliding way{{position, {}}, wanted, footing, 0x1p-40 * length(wanted)};
  for (int bend = 0; bend <= setting_.max_slides; ++bend)
    if (!goes_on(way, without)) return way.end;
  way.end.cut_short = way.end.cut_short || length(allowed(way.rest, way.planes, footing)) > way.least;
  return way.end;
}

std::optional<SlideEnd> MoverWalk::put_down(const Vec3& position, const Vec3& motion) {
  const double longest = length(motion), drop = setting_.snap_distance;
  Sliding way{{position, {}}, -drop * setting_.up, Footing::free, 0x1p-40 * drop};
  for (int bend = 0; bend <= setting_.max_slides && goes_on(way); ++bend) {
    const Vec3 aside = horizontal_part(way.end.position - position, setting_.up);
    const double off = length(aside);
    const bool is_seen = off > 0x1p-8 * setting_.skin;  // less is rounding, where `up` is no axis
    if (is_seen && (off > longest || dot(aside, motion) > 0x1p-6 * off * longest)) return {};
    way.end.ground = ground_at(way.end.position);
    if (way.end.ground) return way.end;
  }
  return {};
}

std::optional<MoverWalk::Stop> MoverWalk::stopped(const Vec3& position, const Vec3& motion) {
  const std::optional<MoverMeeting> met = around_.first_meeting(position, motion);
  if (!met) return {};
  return Stop{position + time_at_skin(*met, motion) * motion, met->is_proved};
}

/// On the edge of something that could be walked on, no higher above the lowest point than a step: so stairs are ground
/// to a round foot.
bool MoverWalk::stands_on_edge(const NearThing& near, const Vec3& position) const {
  const Vec3& up = setting_.up;
  if (!(dot(near.gap.normal, up) > 0x1p-6)) return false;
  const double lowest = dot(position, up) - depth_below_;
  if (!(dot(near.gap.point, up) - lowest <= setting_.step_height)) return false;
  const std::vector<Vec3> normals =
      face_normals_at(near.thing->set.posed(), near.gap.point, near.gap.normal, setting_.skin);
  return std::any_of(normals.begin(), normals.end(), [&](const Vec3& normal) { return is_walkable(normal); });
}

std::optional<WalkContact> MoverWalk::ground_at(const Vec3& position) {
  std::optional<WalkContact> ground;
  double steepness = 0;
  for (const NearThing& near : around_.things_within(position, 1.125 * setting_.skin)) {
    const double level = dot(near.gap.normal, setting_.up);
    if (ground && level <= steepness) continue;
    if (!is_walkable(near.gap.normal) && !stands_on_edge(near, position)) continue;
    ground = WalkContact{near.thing->object, near.thing->element, near.gap.point, near.gap.normal};
    steepness = level;
  }
  return ground;
}

MoverWalk::TriedStep MoverWalk::tried_step(const Vec3& position, const Vec3& motion, const SlideEnd& flat) {
  const Vec3& up = setting_.up;
  const double skin = setting_.skin;
  const Vec3 rise = setting_.step_height * up;
  const Stop top = stopped(position, rise).value_or(Stop{position + rise});
  const double risen = dot(top.position - position, up);
  if (!(risen > skin)) return {.is_step = false, .end = {.position = position, .cut_short = !top.is_proved}};
  TriedStep tried{.is_step = false, .end = slide(top.position, motion, Footing::walking)};
  SlideEnd& end = tried.end;
  end.cut_short = end.cut_short || !top.is_proved;
  const double ahead = dot(end.position - flat.position, motion);
  if (!(ahead > 0x1p-8 * skin * length(motion))) return tried;
  const auto landing = stopped(end.position, -(dot(end.position - position, up) + skin) * up);
  if (!landing) return tried;
  end.position = landing->position;
  end.cut_short = end.cut_short || !landing->is_proved;
  end.ground = ground_at(end.position);
  // What it stands on is the skin below it; a step may be as high as that is exact.
  const double floor = dot(position, up) - depth_below_ - skin;
  tried.is_step = end.ground && dot(end.ground->point, up) - floor <= setting_.step_height + 0.25 * skin;
  return tried;
}

std::optional<SlideEnd> MoverWalk::step_up(const Vec3& position, const Vec3& motion, SlideEnd& flat) {
  TriedStep tried = tried_step(position, motion, flat);
  if (tried.is_step) return std::move(tried.end);
  flat.cut_short = flat.cut_short || tried.end.cut_short;
  return {};
}

}  // namespace toccata
