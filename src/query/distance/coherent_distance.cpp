#include "query/distance/coherent_distance.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include "math/constants.hpp"
#include "narrow/quadrics/distance/quadric_coherent.hpp"
#include "query/distance/relative_motion.hpp"
#include "query/nearest/nearest_triangles.hpp"

namespace toccata {
namespace {

constexpr std::size_t short_life = 6;
constexpr std::size_t longest_rest = 64;

double diagonal(const Aabb& box) {
  const Vec3 size = box.upper - box.lower;
  return std::sqrt(dot(size, size));
}

/// Measured: after a step of half the distance most of the front that is near is opened again or parted anew, which
/// costs what a search does; however near they are, a step of 0.1 % of the size leaves most of it.
bool is_little(double motion, double distance, const PosedMesh& a, const PosedMesh& b) {
  return motion < std::max(distance / 4, std::min(diagonal(a.box()), diagonal(b.box())) / 500);
}

/// Takes note of where the two are now.
void follow(const PosedTriangles& a, const PosedTriangles& b, CoherentState& state) {
  const Pose &pose_a = a.mesh.pose(), &pose_b = b.mesh.pose();
  const double motion = state.counts.questions == 0 ? infinity
                                                    : relative_motion(a.mesh.model(), b.mesh.model(), state.pose_a,
                                                                      state.pose_b, pose_a, pose_b);
  state.moved_little = state.counts.questions == 0 || is_little(motion, state.clearance, a.mesh, b.mesh);
  if (!state.moved_little) state.front.clear();
  const bool same_kinds = state.solid_a == a.solid && state.solid_b == b.solid;
  // Surfaces that come no nearer than so cannot have passed through each other.
  const double left = (state.clearance - motion) * (1 - 0x1p-50);
  state.clearance = same_kinds && left > 0 ? left : 0;
  state.pose_a = pose_a;
  state.pose_b = pose_b;
  state.solid_a = a.solid;
  state.solid_b = b.solid;
  ++state.counts.questions;
}

void make_front(const PosedMesh& a, const PosedMesh& b, double upper, CoherentState& state) {
  const NearWalk walk = near_walk(a, b);
  if (!NearFront::serves(walk)) return;
  NearestTriangles question(a, b, state.workspace.scratch(), {.limit = upper});
  state.front.make(walk, question);
  state.counts.last.volume_tests += state.front.counts().volume_tests;
  state.counts.last.items += state.front.counts().items;
}

Distance searched(const PosedMesh& a, const PosedMesh& b, CoherentState& state) {
  SearchScratch& scratch = state.workspace.scratch();
  const Distance found = surfaces_nearby(a, b, {}, scratch)->distance;
  ++state.counts.searches;
  state.counts.last = scratch.counts;
  if (state.rest > 0) {
    --state.rest;
  } else if (found.upper > 0 && state.moved_little) {
    make_front(a, b, found.upper, state);
    state.age = 0;
  }
  return found;
}

/// Gives up a front that has grown too large; how long it lasted tells whether others are worth making.
void drop_front(CoherentState& state) {
  state.front.clear();
  state.next_rest = state.age < short_life ? std::min(2 * state.next_rest + 1, longest_rest) : 0;
  state.rest = state.next_rest;
}

/// Nothing where the front does not tell.
std::optional<Distance> kept_distance(const PosedMesh& a, const PosedMesh& b, CoherentState& state) {
  if (state.front.is_empty()) return {};
  const NearWalk walk = near_walk(a, b);
  if (!NearFront::serves(walk)) {
    state.front.clear();
    return {};
  }
  NearestTriangles question(a, b, state.workspace.scratch());
  const bool whole = state.front.move(walk, question);
  state.counts.last = state.front.counts();
  if (question.found_meeting()) {
    state.front.clear();
    return at_contact(a, b, state.workspace.scratch());
  }
  if (!whole) {
    drop_front(state);
    return {};
  }
  ++state.age;
  const Distance found = question.nearest(&state.nearest_pair);
  if (state.front.has_grown()) make_front(a, b, found.upper, state);
  return found;
}

/// From B to A, as the direction is; the other way round it is that of the exchanged pair.
template <class A, class B>
std::optional<Distance> quadric_distance([[maybe_unused]] const A& a, [[maybe_unused]] const B& b,
                                         [[maybe_unused]] Vec3& direction) {
  if constexpr (std::is_same_v<A, PosedQuadric> &&
                (std::is_same_v<B, PosedQuadric> || std::is_same_v<B, PosedPolytope>)) {
    return coherent_distance(a, b, direction);
  } else if constexpr (std::is_same_v<A, PosedPolytope> && std::is_same_v<B, PosedQuadric>) {
    direction = -direction;
    const Distance found = flipped(coherent_distance(b, a, direction));
    direction = -direction;
    return found;
  } else {
    return {};
  }
}

}  // namespace

std::optional<Distance> coherent_quadric_distance(const PosedShape& a, const PosedShape& b, Vec3& direction) {
  return std::visit([&](const auto& x, const auto& y) { return quadric_distance(x, y, direction); }, a, b);
}

Distance coherent_distance(const PosedTriangles& a, const PosedTriangles& b, CoherentState& state) {
  follow(a, b, state);
  const bool inside_is_known = state.clearance > 0;
  if (!inside_is_known) state.inner.reset();
  if (state.inner) {
    state.counts.last = {};
    return with_faces(at_inner_part(*state.inner, a.mesh, b.mesh), a.mesh, b.mesh);
  }
  Distance found{};
  if (const auto kept = kept_distance(a.mesh, b.mesh, state))
    found = *kept;
  else
    found = searched(a.mesh, b.mesh, state);
  state.clearance = found.lower;
  if (found.upper > 0 && !inside_is_known) state.inner = inner_part(a, b);
  if (state.inner) found = at_inner_part(*state.inner, a.mesh, b.mesh);
  return with_faces(found, a.mesh, b.mesh);
}

}  // namespace toccata
