#include "toccata/world/character_mover.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "query/scenes/object_search.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/trigonometry.hpp"
#include "toccata/query/scene_index.hpp"
#include "toccata/world/world_queries.hpp"
#include "world/character_mover/moved_objects.hpp"
#include "world/character_mover/mover_walk.hpp"

namespace toccata {
namespace {

/// Ground just as steep as the greatest slope is walked on, however its normal is rounded.
constexpr double slope_tolerance = 0x1p-40;

void require_option(bool is_fine, const char* name, double value, const char* range) {
  if (!is_fine) throw Error(fmt::format("a character: its {} is {}; it has to be {}", name, value, range));
}

MoverSetting checked_setting(const MoverOptions& options) {
  const Vec3 up = normalized(options.up);
  if (up == Vec3{}) throw Error("a character: its `up` has no direction; give one of a length above 0");
  const auto is_length = [](double value) { return value >= 0 && std::isfinite(value); };
  require_option(options.skin > 0 && std::isfinite(options.skin), "skin", options.skin, "a length above 0");
  require_option(options.max_slope_degrees >= 0 && options.max_slope_degrees < 90, "greatest slope",
                 options.max_slope_degrees, "from 0 to less than 90 degrees");
  require_option(is_length(options.step_height), "step height", options.step_height, "a length of 0 or more");
  require_option(is_length(options.snap_distance), "snap distance", options.snap_distance, "a length of 0 or more");
  require_option(options.max_slides >= 1, "number of slides", options.max_slides, "1 or more");
  return {up,
          options.skin,
          sine_cosine_of_degrees(options.max_slope_degrees).cosine - slope_tolerance,
          options.step_height,
          options.snap_distance,
          options.max_slides};
}

void require_way(const Vec3& motion, const Pose& from) {
  if (!is_finite(motion)) throw Error("a character: its motion has a coordinate that is not finite");
  if (!is_finite(from)) throw Error("a character: its pose has a number that is not finite");
  if (!is_finite(from.offset + 2 * motion) || !std::isfinite(length(motion) * length(motion)))
    throw Error("a character: its motion is so long that where it leads is no double");
}

MoverContact<Index> told_contact(const WalkContact& contact) {
  return {contact.object, contact.element, contact.point, contact.normal};
}

/// One step, of which all is known.
class OneStep {
 public:
  OneStep(const SearchedObjects& objects, const Model& shape, const MoverState<Index>& from,
          const MoverSetting& setting)
      : objects_(objects),
        from_(from),
        setting_(setting),
        body_(shape, from.pose),
        around_(objects, body_, setting.skin, setting.least_gap()),
        walk_(around_, setting) {}

  [[nodiscard]] MoverStep<Index> taken(const Vec3& motion, std::span<const MovedIndex> moved) {
    const double rise = dot(motion, setting_.up);
    const bool walks = from_.ground && rise <= 0x1p-40 * length(motion);
    look_ahead(motion, walks);
    MoverStep<Index> step;
    const Vec3 begin = brought_out(step, moved);
    const Vec3 wanted = walks ? motion - rise * setting_.up : motion;
    SlideEnd end = walk_.slide(begin, wanted, walks ? Footing::walking : Footing::free);
    if (walks) step_up_where_blocked(begin, wanted, end, step);
    settle(end, walks, rise, wanted, step);
    step.cut_short = step.cut_short || end.cut_short;
    step.state.pose = body_.pose_at(end.position);
    step.moved = end.position - from_.pose.offset;
    tell(end, step);
    return step;
  }

 private:
  /// Where a step of a usual length can lead is looked up once.
  void look_ahead(const Vec3& motion, bool walks) {
    const double reach = length(motion);
    if (!(reach < 4 * body_.size())) return;
    const Vec3 rise = (walks ? setting_.step_height : 0) * setting_.up;
    const Vec3 drop = (walks ? std::max(setting_.snap_distance, setting_.skin) : 0) * setting_.up;
    const Vec3& at = from_.pose.offset;
    const Aabb way = merge(merge(body_.box_at(at), body_.box_at(at + rise)), body_.box_at(at - drop));
    around_.look_around(widened(way, reach + 2 * setting_.skin));
  }

  /// Brings it along with what has moved, and out of what it is in.
  Vec3 brought_out(MoverStep<Index>& step, std::span<const MovedIndex> moved) {
    const Vec3& from = from_.pose.offset;
    std::optional<MoverStand> stand;
    if (from_.ground) stand = MoverStand{from_.ground->object, from_.ground->point};
    const CarriedPlace carried = carried_along(from, stand, moved, objects_, walk_, body_, setting_.least_gap());
    step.carried = carried.position - from;
    step.crushed = carried.crushed;
    step.cut_short = carried.cut_short;
    const RecoveredPlace out = walk_.recovered(carried.position, objects_);
    step.pushed_out = out.position - carried.position;
    step.tight = out.tight;
    step.stuck = out.stuck;
    return out.position;
  }

  void step_up_where_blocked(const Vec3& begin, const Vec3& wanted, SlideEnd& end, MoverStep<Index>& step) {
    const auto blocks = [this](const WalkContact& contact) { return !walk_.is_walkable(contact.normal); };
    if (setting_.step_height == 0 || std::none_of(end.contacts.begin(), end.contacts.end(), blocks)) return;
    auto higher = walk_.step_up(begin, wanted, end);
    if (!higher) return;
    end = std::move(*higher);
    step.stepped = true;
  }

  /// Onto the ground, if it stands on some or walked and some is near below.
  void settle(SlideEnd& end, bool walks, double rise, const Vec3& wanted, MoverStep<Index>& step) {
    if (rise > 0 && !walks) return;
    std::optional<WalkContact> ground = end.ground ? end.ground : walk_.ground_at(end.position);
    if (!ground && walks && setting_.snap_distance > 0) {
      const auto below = walk_.put_down(end.position, wanted);
      if (below) {
        end.position = below->position;
        end.cut_short = end.cut_short || below->cut_short;
        ground = below->ground;
        end.contacts.insert(end.contacts.end(), below->contacts.begin(), below->contacts.end() - 1);
      }
    }
    if (ground) step.state.ground = told_contact(*ground);
  }

  void tell(const SlideEnd& end, MoverStep<Index>& step) const {
    for (const WalkContact& contact : end.contacts) {
      const double level = dot(contact.normal, setting_.up);
      if (level <= -setting_.level_cosine)
        step.met_ceiling = true;
      else if (!walk_.is_walkable(contact.normal))
        step.met_wall = true;
      step.contacts.push_back(told_contact(contact));
    }
  }

  const SearchedObjects& objects_;
  const MoverState<Index>& from_;
  const MoverSetting& setting_;
  MoverBody body_;
  MoverSurroundings around_;
  MoverWalk walk_;
};

// What an object is called by its number, and the other way round; none where it is no more.

std::optional<Index> index_in_level(const SceneObjects& objects, Index id) {
  return id < objects.models.size() ? std::optional(id) : std::nullopt;
}
std::optional<Index> index_in_level(const WorldBodies& bodies, BodyId id) {
  return bodies.world->contains(id) ? std::optional(id.index) : std::nullopt;
}

template <class Objects>
std::vector<MovedIndex> moved_indices(const Objects& objects,
                                      std::span<const MovedObject<typename Objects::Id>> moved) {
  std::vector<MovedIndex> indices;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const std::optional<Index> object = index_in_level(objects, moved[i].object);
    if (!object) throw Error(fmt::format("a character: object {} of those that moved is not in the level", i));
    if (!is_finite(moved[i].before))
      throw Error(fmt::format("a character: where object {} of those that moved was is not finite", i));
    indices.push_back({*object, moved[i].before});
  }
  return indices;
}

template <class Objects>
MoverState<Index> by_index(const Objects& objects, const MoverState<typename Objects::Id>& state) {
  MoverState<Index> own{state.pose, {}};
  if (!state.ground) return own;
  // Ground that is no more carries nobody.
  const Index object = index_in_level(objects, state.ground->object).value_or(static_cast<Index>(-1));
  own.ground = {object, state.ground->element, state.ground->point, state.ground->normal};
  return own;
}

template <class Objects>
MoverStep<typename Objects::Id> by_id(const Objects& objects, const MoverStep<Index>& step) {
  MoverStep<typename Objects::Id> own;
  own.state.pose = step.state.pose;
  if (const auto& ground = step.state.ground)
    own.state.ground = MoverContact<typename Objects::Id>{objects.id_of(ground->object), ground->element, ground->point,
                                                          ground->normal};
  own.moved = step.moved;
  own.carried = step.carried;
  for (const MoverContact<Index>& contact : step.contacts)
    own.contacts.push_back({objects.id_of(contact.object), contact.element, contact.point, contact.normal});
  own.met_wall = step.met_wall;
  own.met_ceiling = step.met_ceiling;
  own.stepped = step.stepped;
  own.pushed_out = step.pushed_out;
  own.tight = step.tight;
  own.stuck = step.stuck;
  own.crushed = step.crushed;
  own.cut_short = step.cut_short;
  return own;
}

}  // namespace

template <class Objects>
MoverStep<typename Objects::Id> move_character(const ObjectQueries<Objects>& level, const Model& shape,
                                               const MoverState<typename Objects::Id>& from, const Vec3& motion,
                                               const MoverOptions& options, const typename Objects::Filter& filter,
                                               std::span<const MovedObject<typename Objects::Id>> moved) {
  const Objects& objects = level.objects();
  objects.require_unchanged();
  const MoverSetting setting = checked_setting(options);
  require_way(motion, from.pose);
  const auto at = [&](Index object) { return objects.at(object); };
  const auto name_of = [&](Index object) { return objects.name_of(object); };
  const auto accepts = [&](Index object) { return objects.accepts(filter, object); };
  const SearchedObjects searched{level.boxes(), at, name_of, accepts};
  const std::vector<MovedIndex> indices = moved_indices(objects, moved);
  const MoverState<Index> state = by_index(objects, from);
  return by_id(objects, OneStep(searched, shape, state, setting).taken(motion, indices));
}

template MoverStep<Index> move_character(const ObjectQueries<SceneObjects>&, const Model&, const MoverState<Index>&,
                                         const Vec3&, const MoverOptions&, const ObjectFilter&,
                                         std::span<const MovedObject<Index>>);
template MoverStep<BodyId> move_character(const ObjectQueries<WorldBodies>&, const Model&, const MoverState<BodyId>&,
                                          const Vec3&, const MoverOptions&, const BodyFilter&,
                                          std::span<const MovedObject<BodyId>>);

Vec3 velocity_along(const Vec3& velocity, std::span<const Vec3> normals) {
  if (!is_finite(velocity)) throw Error("the velocity is not finite");
  std::vector<MotionPlane> planes;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (!is_finite(normals[i])) throw Error(fmt::format("normal {} is not finite", i));
    planes.push_back({normals[i], 0});
  }
  return nearest_motion(velocity, planes).value_or(Vec3{});
}

}  // namespace toccata
