#include "world/character_mover/mover_surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "query/casts/swept_view.hpp"
#include "query/meshes/world_search.hpp"
#include "query/relation/relation_locality.hpp"
#include "world/character_mover/level_parts.hpp"

namespace toccata {
namespace {

/// Witness points are off by no more than this times the greatest coordinate (convex_convex.hpp).
constexpr double witness_error = 1e-12;

/// A motion within this of parallel to a plane does not go into it, as long as it is by less than this of the skin.
constexpr double parallel_slope = 0x1p-36, parallel_share = 0x1p-9;

/// How much of the skin the planes that tell a distance may be wrong by at most.
constexpr double witness_share = 0x1p-8;

/// What is farther than that beyond where it counts is left out unseen: more than a time and a distance may be off by.
constexpr double share_of_spare = 0x1p-26;

/// So many things are looked at without asking first which of them is met at the latest.
constexpr std::size_t few_enough = 3;

/// Room is made at once for so many triangles around a body.
constexpr std::size_t usual_number = 256;

Aabb box_of_way(const Aabb& box, const Vec3& motion) {
  return merge(box, Aabb{box.lower + motion, box.upper + motion});
}

}  // namespace

void MoverSurroundings::look_around(const Aabb& box) {
  if (!is_empty(region_) && contains(region_, box)) return;
  const Aabb both = is_empty(region_) ? box : merge(region_, box);
  region_ = is_long(both.upper - both.lower) ? box : both;
  gather();
}

void MoverSurroundings::gather() {
  candidates_.clear();
  faces_.clear();
  elements_.clear();
  solids_.clear();
  std::vector<Index> near;
  objects_.tree.visit_overlapping(region_, [&](Index object) {
    if (objects_.accepts(object)) near.push_back(object);
    return true;
  });
  std::sort(near.begin(), near.end());
  for (const Index object : near) gather_object(object);
}

void MoverSurroundings::gather_triangles(const PosedMesh& mesh, Index object, Index first_element) {
  std::vector<MeshTriangle> near;
  std::vector<std::pair<Index, std::size_t>> order;
  near.reserve(usual_number);
  order.reserve(usual_number);
  const RoundedBox reached = body_.reached_in(region_);
  visit_world_triangles(mesh, region_, [&](const MeshTriangle& triangle) {
    if (reached.misses(triangle.box)) return;
    order.emplace_back(triangle.number, near.size());
    near.push_back(triangle);
  });
  std::sort(order.begin(), order.end());
  candidates_.reserve(candidates_.size() + near.size());
  for (const auto& [number, place] : order)
    candidates_.push_back({near[place].box, near[place].corners, object, first_element + number});
}

void MoverSurroundings::gather_object(Index object) {
  for (const PosedPart& part : level_parts(objects_, object)) {
    if (const auto* mesh = std::get_if<PosedTriangles>(&part.shape)) {
      gather_triangles(mesh->mesh, object, part.first_element);
      if (mesh->solid) solids_.push_back({object, mesh->mesh});
    } else if (overlap(world_box(part.shape), region_)) {
      const LevelElement& element = elements_.emplace_back(element_of(part, object));
      candidates_.push_back({element.box, {}, object, element.element, &element});
    }
  }
}

const LevelElement& MoverSurroundings::made(Candidate& candidate) {
  if (const TriangleFace* face = face_alone(candidate); face != nullptr)
    candidate.made = &elements_.emplace_back(
        element_of(candidate.triangle, *face, candidate.object, candidate.element, candidate.box));
  return *candidate.made;
}

const TriangleFace* MoverSurroundings::face_alone(Candidate& candidate) {
  if (candidate.made != nullptr) return nullptr;
  if (candidate.face == no_face) {
    candidate.face = faces_.size();
    faces_.push_back(face_of(candidate.triangle));
  }
  return &faces_[candidate.face];
}

std::vector<NearThing> MoverSurroundings::things_within(const Vec3& position, double distance) {
  look_around(widened(body_.box_at(position), distance));
  const MoverBody::Placed placed = body_.placed_at(position);
  const double spared = distance + share_of_spare * skin_;
  const RoundedBox reach = body_.reach_of(placed, {}, spared);
  const PlaneCast kept(placed.corners, {}, {body_.radius() + spared, 0, 0});
  const bool has_planes = placed.corners.count > 0;
  std::vector<NearThing> near;
  for (Candidate& candidate : candidates_) {
    if (reach.misses(candidate.box)) continue;
    if (has_planes && is_kept_off(candidate, kept)) continue;
    const LevelElement& element = made(candidate);
    if (has_planes && kept.times_of(element.planes).earliest > 1) continue;
    const MoverGap gap = body_.gap_of(placed, element);
    if (gap.distance <= distance) near.push_back({gap, &element});
  }
  return near;
}

std::optional<MoverSurroundings::Holder> MoverSurroundings::holder_of(const Vec3& position) {
  look_around(body_.box_at(position));
  const Vec3 point = body_.point_at(position);
  for (const Holder& solid : solids_)
    if (overlap(solid.mesh.box(), Aabb{point, point}) && is_interior(point, solid.mesh)) return solid;
  return {};
}

double MoverSurroundings::same_time(const Vec3& motion) const { return 0x1p-16 * skin_ / length(motion); }

/// A way so long that it is better to go along it than to look up all around it.
bool MoverSurroundings::is_long(const Vec3& motion) const {
  return largest_magnitude(motion) > 8 * std::max(body_.size(), 8 * skin_);
}

std::optional<MoverMeeting> MoverSurroundings::first_meeting(const Vec3& position, const Vec3& motion,
                                                             std::optional<Index> without) {
  if (motion == Vec3{}) return {};
  return is_long(motion) ? first_far_on(position, motion, without) : first_around(position, motion, without);
}

/// When the body comes as near as it may, by conservative advancement (B. V. Mirtich, "Impulse-based dynamic simulation
/// of rigid body systems", 1996): the plane across the shortest way between two convex things bounds how soon they can
/// be nearer. Along a straight way the distance is a convex function of time, so these are the steps of Newton's method
/// from the left, which never pass the first root.
std::optional<MoverSurroundings::Met> MoverSurroundings::meeting_with(const LevelElement& thing,
                                                                      const MoverBody::Placed& start,
                                                                      const Vec3& motion, double limit) const {
  const Vec3& position = start.position;
  const double speed = length(motion);
  const double tolerance = 0x1p-28 * skin_;
  MoverGap gap = body_.gap_of(start, thing);
  const double wanted = std::min(least_gap_, gap.distance);
  double time = 0;
  for (int round = 0; round < 100; ++round) {
    const double approach = -dot(gap.normal, motion);
    const bool is_leaving = approach <= std::min(parallel_slope * speed, parallel_share * skin_);
    const double excess = gap.distance - wanted;
    if (gap.normal == Vec3{}) return Met{time, &thing, false};
    if (!is_leaving && excess <= tolerance) return Met{time, &thing};
    if (is_leaving && gap.distance <= 0) return {};
    // So far the plane is known.
    const Vec3 at = position + time * motion;
    const double extent = std::max(largest_magnitude(at), largest_magnitude(gap.point)) + body_.size();
    const double known = (witness_share * skin_ / witness_error) * (gap.witness / (extent * speed));
    time += is_leaving ? known : std::min(known, excess / approach);
    if (!(time <= limit)) return {};
    gap = body_.gap_at(position + time * motion, thing);
  }
  return Met{time, &thing, false};
}

/// The nearest, at a time, of what is met then: among several elements that lie in one plane, that over which the body
/// is. So an edge between two of them is no obstacle.
std::optional<MoverMeeting> MoverSurroundings::nearest_of(std::span<const Met> met, double time, const Vec3& position,
                                                          const Vec3& motion) const {
  std::optional<MoverMeeting> nearest;
  for (const Met& one : met) {
    if (one.time > time + same_time(motion)) continue;
    const MoverGap gap = body_.gap_at(position + time * motion, *one.thing);
    const auto rank = [](const MoverGap& g, const LevelElement& e) {
      return std::tuple(g.distance, e.object, e.element);
    };
    if (!nearest || rank(gap, *one.thing) < rank(nearest->gap, nearest->thing))
      nearest = MoverMeeting{time, gap, *one.thing, one.is_proved};
  }
  return nearest;
}

/// So long that where it leads, and how far into a plane, is rounded by more than a 16th of the skin.
bool MoverSurroundings::is_too_long_for_planes(const Vec3& motion) const {
  return !(0x1p-50 * largest_magnitude(motion) <= 0x1p-4 * skin_);
}

std::optional<PlaneCast> MoverSurroundings::plane_cast(const MoverBody::Placed& start, const Vec3& motion) const {
  if (start.corners.count == 0 || is_too_long_for_planes(motion)) return {};
  const double parallel_speed = std::min(parallel_slope * length(motion), parallel_share * skin_);
  return PlaneCast(start.corners, motion, {body_.radius() + least_gap_, share_of_spare * skin_, parallel_speed});
}

RoundedBox MoverSurroundings::reach_of_way(const MoverBody::Placed& start, const Vec3& motion) const {
  return body_.reach_of(start, motion, least_gap_ + share_of_spare * skin_);
}

/// By the face of a triangle of which no more is known yet.
bool MoverSurroundings::is_kept_off(Candidate& candidate, const PlaneCast& planes) {
  const TriangleFace* face = face_alone(candidate);
  return face != nullptr && planes.is_kept_off(*face);
}

/// What boxes and the faces of triangles leave.
std::vector<MoverSurroundings::Candidate*> MoverSurroundings::on_the_way(const MoverBody::Placed& start,
                                                                         const Vec3& motion,
                                                                         std::optional<Index> without) {
  const std::optional<PlaneCast> planes = plane_cast(start, motion);
  const RoundedBox reach = reach_of_way(start, motion);
  std::vector<Candidate*> near;
  for (Candidate& candidate : candidates_) {
    if (candidate.object == without || reach.misses(candidate.box)) continue;
    if (!planes || !is_kept_off(candidate, *planes)) near.push_back(&candidate);
  }
  return near;
}

/// When the thing is met that is nearest at the start, and a little later; 1 where it is not.
double MoverSurroundings::latest_time(std::span<Candidate* const> near, const MoverBody::Placed& start,
                                      const Vec3& motion) {
  const RoundedBox at_start = reach_of_way(start, {});
  Candidate* nearest = nullptr;
  double least = infinity;
  for (Candidate* candidate : near) {
    const double square = at_start.square_of_distance(candidate->box);
    if (!(square < least)) continue;
    least = square;
    nearest = candidate;
  }
  if (nearest == nullptr) return 1;
  const auto meeting = meeting_with(made(*nearest), start, motion, 1);
  return meeting ? std::min(1.0, meeting->time + 2 * same_time(motion)) : 1;
}

/// What boxes and planes leave until a time, in the order of the times that these tell.
std::vector<MoverSurroundings::Waiting> MoverSurroundings::waiting_of(std::span<Candidate* const> near,
                                                                      const MoverBody::Placed& start,
                                                                      const Vec3& motion, double latest) {
  const std::optional<PlaneCast> planes = plane_cast(start, motion);
  const RoundedBox reach = reach_of_way(start, latest * motion);
  std::vector<Waiting> waiting;
  for (Candidate* candidate : near) {
    if (reach.misses(candidate->box)) continue;
    const LevelElement& element = made(*candidate);
    const PlaneCast::Times times = planes ? planes->times_of(element.planes) : PlaneCast::Times{};
    if (times.free <= 1 && times.earliest <= latest) waiting.push_back({times, &element});
  }
  std::stable_sort(waiting.begin(), waiting.end(), [](const Waiting& a, const Waiting& b) {
    return std::tie(a.times.earliest, a.times.free) < std::tie(b.times.earliest, b.times.free);
  });
  return waiting;
}

/// What has a vertex of the body over a face when its planes leave it is looked at first: its distance is told by the
/// face, and what lies in the same plane comes no sooner.
MoverSurroundings::AllMet MoverSurroundings::met_of(std::span<const Waiting> waiting, const MoverBody::Placed& start,
                                                    const Vec3& motion) const {
  const double same = same_time(motion);
  AllMet all;
  const auto look_at = [&](const LevelElement& thing) {
    const auto meeting = meeting_with(thing, start, motion, std::min(1.0, all.first + same));
    if (!meeting) return;
    all.met.push_back(*meeting);
    all.first = std::min(all.first, meeting->time);
  };
  std::vector<Waiting> slow;
  for (const Waiting& next : waiting) {
    if (next.times.earliest > all.first + same) break;
    const MoverBody::Placed then = body_.placed_at(start.position + next.times.free * motion);
    if (body_.bound_of(then, *next.thing).planes.is_exact)
      look_at(*next.thing);
    else
      slow.push_back(next);
  }
  std::sort(slow.begin(), slow.end(), [](const Waiting& a, const Waiting& b) {
    return std::tie(a.times.free, a.thing->object, a.thing->element) <
           std::tie(b.times.free, b.thing->object, b.thing->element);
  });
  for (const Waiting& next : slow) {
    if (!all.met.empty() && next.times.free >= all.first - same) break;
    if (next.times.earliest <= all.first + same) look_at(*next.thing);
  }
  return all;
}

/// What is met later than the nearest thing need not be looked at, as long as something is found by then.
std::optional<MoverMeeting> MoverSurroundings::first_around(const Vec3& position, const Vec3& motion,
                                                            std::optional<Index> without) {
  look_around(widened(box_of_way(body_.box_at(position), motion), skin_));
  const MoverBody::Placed start = body_.placed_at(position);
  const std::vector<Candidate*> near = on_the_way(start, motion, without);
  const double latest = near.size() > few_enough ? latest_time(near, start, motion) : 1;
  AllMet all = met_of(waiting_of(near, start, motion, latest), start, motion);
  const bool is_late = all.met.empty() || all.first > latest;
  if (latest < 1 && is_late) all = met_of(waiting_of(near, start, motion, 1), start, motion);
  return nearest_of(all.met, all.first, position, motion);
}

std::optional<MoverMeeting> MoverSurroundings::first_far_on(const Vec3& position, const Vec3& motion,
                                                            std::optional<Index> without) const {
  const Aabb box = widened(body_.box_at(position), skin_);
  const Vec3 half = 0.5 * (box.upper - box.lower);
  const PosedPolytope moving(Box(half + 0x1p-20 * half, 0.5 * (box.lower + box.upper)));
  const MoverBody::Placed start = body_.placed_at(position);
  const std::optional<PlaneCast> planes = plane_cast(start, motion);
  std::deque<LevelElement> seen;  // what is in it stays where it is
  std::vector<Met> met;
  double first = 1;
  const auto limit = [&] { return std::min(1.0, first + same_time(motion)); };
  const auto look_at = [&](LevelElement element) {
    if (planes && !(planes->times_of(element.planes).free <= limit())) return limit();
    const auto meeting = meeting_with(element, start, motion, limit());
    if (!meeting) return limit();
    seen.push_back(std::move(element));
    met.push_back({meeting->time, &seen.back(), meeting->is_proved});
    first = std::min(first, meeting->time);
    return limit();
  };
  SweptFrontier frontier;
  objects_.tree.visit_along(box, motion, 1, [&](Index object) {
    if (object == without || !objects_.accepts(object)) return limit();
    for (const PosedPart& part : level_parts(objects_, object)) {
      const auto* triangles = std::get_if<PosedTriangles>(&part.shape);
      if (triangles == nullptr) {
        look_at(element_of(part, object));
        continue;
      }
      const PosedMesh& mesh = triangles->mesh;
      if (mesh.model().mesh().triangle_count() == 0) continue;
      const SweptView view(moving, motion, mesh);
      const SweptWalk walk({nullptr, &mesh.model().wide_bvh()}, view.directions());
      walk.run(frontier, limit(),
               [&](ItemPair items) { return look_at(element_of(mesh, items.second, part.first_element, object)); });
    }
    return limit();
  });
  return nearest_of(met, first, position, motion);
}

}  // namespace toccata
