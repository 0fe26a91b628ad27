#include "toccata/query/distance.hpp"

#include <cmath>

#include <fmt/format.h>

#include "narrow/exact/within.hpp"
#include "narrow/quadrics/distance/quadric_within.hpp"
#include "query/ask.hpp"
#include "query/distance/least_distance.hpp"
#include "query/distance/mesh_distance.hpp"
#include "query/nearest/nearest_triangles.hpp"
#include "query/search_scratch.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

struct AskWithin {
  static constexpr ShapeQuestion question = ShapeQuestion::distance;

  bool operator()(const PosedPolytope& a, const PosedPolytope& b) const {
    return is_within(a, b, tolerance, &scratch.convex);
  }
  bool operator()(const PosedPolytope& a, const PosedHalfSpace& b) const {
    return is_within(distance(a, b), a, b, tolerance);
  }
  bool operator()(const PosedHalfSpace& a, const PosedHalfSpace& b) const {
    return is_within(distance(a, b), a, b, tolerance);
  }
  /// What the interval leaves open counts as closer.
  template <PosedConvexSet Other>
  bool operator()(const PosedQuadric& a, const Other& b) const {
    return is_within(a, b, tolerance);
  }
  template <class Other>
  bool operator()(const PosedTriangles& a, const Other& b) const {
    return is_within(a, b, tolerance, scratch);
  }

  double tolerance;
  SearchScratch& scratch;
};

struct AskNearby {
  static constexpr ShapeQuestion question = ShapeQuestion::distance;
  using Answer = std::optional<Nearby>;

  Answer operator()(const PosedPolytope& a, const PosedPolytope& b) const {
    return judged(distance(a, b, &scratch.convex), a, b);
  }
  Answer operator()(const PosedPolytope& a, const PosedHalfSpace& b) const { return judged(distance(a, b), a, b); }
  Answer operator()(const PosedHalfSpace& a, const PosedHalfSpace& b) const { return judged(distance(a, b), a, b); }
  template <PosedConvexSet Other>
  Answer operator()(const PosedQuadric& a, const Other& b) const {
    if (!is_within(a, b, limit_from(cutoff))) return {};
    const Distance found = distance(a, b);
    return Nearby{found, found.upper <= cutoff || is_within(a, b, cutoff)};
  }
  template <class Other>
  Answer operator()(const PosedTriangles& a, const Other& b) const {
    return nearby(a, b, cutoff, scratch);
  }

  template <class A, class B>
  Answer judged(const Distance& found, const A& a, const B& b) const {
    if (found.lower > limit_from(cutoff)) return {};
    return Nearby{found, is_within(found, a, b, cutoff)};
  }

  double cutoff;
  SearchScratch& scratch;
};

/// −0 is 0.
double checked(double tolerance, const char* name) {
  if (!(tolerance >= 0)) throw Error(fmt::format("{} is {}; it has to be a length of 0 or more", name, tolerance));
  return tolerance + 0.0;
}

}  // namespace

bool within_distance(const Model& a, const Model& b, double tolerance, const PairQuery& query) {
  Workspace workspace;
  return within_distance(a, b, tolerance, query, workspace);
}

bool within_distance(const Model& a, const Model& b, double tolerance, const PairQuery& query, Workspace& workspace) {
  const AskWithin question{checked(tolerance, "tolerance"), workspace.scratch()};
  workspace.scratch().counts = {};
  const PosedModelPair models(a, b, query, workspace.scratch());
  bool found = false;
  models.visit_near(tolerance, [&](const PosedPart& part_a, const PosedPart& part_b) {
    require_answered(ShapeQuestion::distance, part_a.kind, part_b.kind);
    found = std::isinf(tolerance) || ask(question, part_a, part_b);
    return found ? -1.0 : tolerance;
  });
  return found;
}

std::optional<Distance> distance_within(const Model& a, const Model& b, double limit, const PairQuery& query) {
  Workspace workspace;
  return distance_within(a, b, limit, query, workspace);
}

std::optional<Distance> distance_within(const Model& a, const Model& b, double limit, const PairQuery& query,
                                        Workspace& workspace) {
  const AskNearby question{checked(limit, "limit"), workspace.scratch()};
  workspace.scratch().counts = {};
  const PosedModelPair models(a, b, query, workspace.scratch());
  LeastDistance least(workspace.scratch());
  bool within = false;
  models.visit_near(limit_from(limit), [&](const PosedPart& part_a, const PosedPart& part_b) {
    if (least.is_farther(part_a, part_b)) return least.limit(limit_from(limit));
    if (const std::optional<Nearby> found = ask(question, part_a, part_b)) {
      within = within || found->is_within;
      least.keep(found->distance, part_a, part_b);
    }
    return least.limit(limit_from(limit));
  });
  return within ? least.found() : std::nullopt;
}

}  // namespace toccata
