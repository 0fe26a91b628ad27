#include "world/narrow_phase.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <hwy/cache_control.h>

#include "query/ask.hpp"
#include "query/ask_each.hpp"
#include "query/manifolds/model_manifolds.hpp"
#include "query/penetration/solid_penetration.hpp"
#include "query/scenes/task_reporter.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/motion/rigid_motion.hpp"
#include "toccata/narrow/box_box.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/pairs.hpp"

namespace toccata {
namespace {

PairQuery query_of(const Body& a, const Body& b) { return {a.pose, b.pose, a.solid, b.solid}; }

/// The workspace begins anew: what it knew is of another pair.
Workspace& cleared(Workspace& workspace) {
  workspace.scratch().convex = {};
  return workspace;
}

/// How many pairs before its turn a body is fetched: those of greater index lie anywhere.
constexpr std::size_t ahead = 3;

void fetch(const Body& body) {
  constexpr std::size_t line = 64;
  const auto* const bytes = reinterpret_cast<const char*>(&body);
  for (std::size_t at = 0; at < sizeof(Body); at += line) hwy::Prefetch(bytes + at);
}

/// A convex body at its place, made where it lies; none where it is something else.
struct PlaceConvex {
  template <PlainShape S>
  void operator()(const S& shape) const {
    placed.emplace(shape, pose);
  }
  template <QuadricShape S>
  void operator()(const S&) const {}
  void operator()(const HalfSpace&) const {}
  void operator()(const HeightField&) const {}
  void operator()(const std::shared_ptr<const TriangleMesh>&) const {}
  void operator()(const Compound&) const {}

  const Pose& pose;
  std::optional<PosedPolytope>& placed;
};

/// What is left of a length beyond the margin, rounded down.
double beyond_margin(double length, double margin) {
  return std::min(std::max(0.0, (length - margin) * (1 - 0x1p-52)), greatest_double);
}

/// Before they could have moved against each other by this, two that are near stay so and do not touch.
double near_until(const Distance& apart, double margin) {
  return std::min(apart.lower, beyond_margin(margin, apart.upper));
}

AnswerLasts while_near(double way) { return {.radius = way}; }

/// How long two that meet do so. The difference A − B holds a ball around c, and the origin. If it holds q = −λ c too,
/// as it does if A meets B moved by q, it holds the ball around the origin whose radius is the share s = λ / (1 + λ) of
/// the first: and as A and B move, that of the ball around s c + (1 − s) q as they have gone, of which the share s goes
/// with the centres of the bodies, whatever they turn. Roundings are covered by the position errors of flights.
AnswerLasts while_held(const PosedPolytope& a, const Body& b, const WantedLasting& wanted, SimplexCache& workspace) {
  const auto& [centre, radius] = wanted.inner;
  const double left = radius - length(centre);
  if (!(radius > 0) || left >= std::min(0.5 * wanted.enough, 0.3 * radius))
    return {.offset = centre, .radius = radius, .turning = 0};
  for (const double share : {0.5, 0.15}) {
    const double held = std::min(share, wanted.enough / radius);
    std::optional<PosedPolytope> moved;
    const Pose pose{b.pose.linear, b.pose.offset - held / (1 - held) * centre};
    std::visit(PlaceConvex{pose, moved}, b.model.shape());
    if (overlap(a, *moved, &workspace)) return {.radius = held * radius, .turning = 1 - held};
  }
  return left > 0 ? AnswerLasts{.offset = centre, .radius = radius, .turning = 0} : AnswerLasts{};
}

/// Whether two are in contact, and their manifolds where these are wanted, which tell it too.
struct Touch {
  bool wants_manifolds = false;
  std::vector<ModelManifold> manifolds{};

  bool found(const PosedPolytope& a, const PosedPolytope& b, SimplexCache& workspace) {
    if (!wants_manifolds) return overlap(a, b, &workspace);
    const Manifold manifold = toccata::manifold(a, b, &workspace);
    if (manifold.count == 0) return false;
    manifolds = {{manifold}};
    return true;
  }

  bool found(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
    if (!wants_manifolds) return overlap(a, b, query, workspace);
    MetManifolds met = manifolds_where_met(a, b, query, workspace);
    manifolds = std::move(met.manifolds);
    return met.in_contact;
  }
};

/// What `within_distance` and `overlap` answer, of two convex ones.
BodyNearness nearness_of(const PosedPolytope& a, const PosedPolytope& b, const Body& body_b, double margin,
                         WantedLasting& wanted, Touch& touch, SimplexCache& workspace) {
  if (wanted.enough > 0) {
    const DirectedGap gap = certain_gap(a, b, margin + wanted.enough, &workspace);
    if (gap.length > margin) {
      wanted.lasts.gap = {beyond_margin(gap.length, margin), gap.direction};
      return BodyNearness::apart;
    }
  }
  if (margin > 0 && !std::isinf(margin) && !nearby(a, b, WantedDistance::within(margin), &workspace))
    return BodyNearness::apart;
  const bool in_contact = touch.found(a, b, workspace);
  if (!in_contact && margin == 0) return BodyNearness::apart;
  if (wanted.of_told)
    wanted.lasts = in_contact ? while_held(a, body_b, wanted, workspace)
                              : while_near(near_until(distance(a, b, &workspace), margin));
  return in_contact ? BodyNearness::contact : BodyNearness::near;
}

/// Two boxes, whose corners are not made where only a yes or no is wanted; null for other shapes.
std::optional<bool> boxes_overlap(const Body& a, const Body& b) {
  const auto *box_a = std::get_if<Box>(&a.model.shape()), *box_b = std::get_if<Box>(&b.model.shape());
  if (box_a == nullptr || box_b == nullptr) return std::nullopt;
  return overlap(*box_a, a.pose, *box_b, b.pose);
}

/// What `within_distance` and `overlap` answer.
BodyNearness nearness_of(const Body& a, const Body& b, double margin, WantedLasting& wanted, Touch& touch,
                         Workspace& workspace) {
  if (margin == 0 && wanted.enough == 0 && !touch.wants_manifolds)
    if (const std::optional<bool> meet = boxes_overlap(a, b))
      return *meet ? BodyNearness::contact : BodyNearness::apart;
  std::optional<PosedPolytope> placed_a, placed_b;
  std::visit(PlaceConvex{a.pose, placed_a}, a.model.shape());
  if (placed_a) std::visit(PlaceConvex{b.pose, placed_b}, b.model.shape());
  if (placed_b) return nearness_of(*placed_a, *placed_b, b, margin, wanted, touch, cleared(workspace).scratch().convex);
  const PairQuery query = query_of(a, b);
  std::optional<Distance> known;
  if (wanted.enough > 0) {
    known = distance_within(a.model, b.model, (margin + wanted.enough) * (1 + 0x1p-50), query, cleared(workspace));
    if (!known) {
      wanted.lasts = while_near(wanted.enough);
      return BodyNearness::apart;
    }
  }
  const bool is_far = margin > 0 && !within_distance(a.model, b.model, margin, query, cleared(workspace));
  if (!is_far && touch.found(a.model, b.model, query, cleared(workspace))) return BodyNearness::contact;
  const bool is_near = !is_far && margin > 0;
  if (known && (!is_near || wanted.of_told))
    wanted.lasts = while_near(is_near ? near_until(*known, margin) : beyond_margin(known->lower, margin));
  return is_near ? BodyNearness::near : BodyNearness::apart;
}

/// Where it stands, or how it goes.
RigidMotion motion_of(Index index, std::span<const Body> bodies, const BodiesOnTheWay& on_the_way) {
  const auto found = on_the_way.find(index);
  return found == on_the_way.end() ? RigidMotion(bodies[index].pose) : found->second.motion;
}

/// Two half-spaces, which meet wherever they are or never, are not asked about.
bool has_first_contact(const Body& a, const Body& b) {
  return pair_cell(ShapeQuestion::cast_shape, kind_of(a.model.shape()), kind_of(b.model.shape())).state ==
         PairState::defined;
}

/// The only manifold of two shapes, which have at most one.
Manifold plain(std::span<const ModelManifold> manifolds) {
  return manifolds.empty() ? Manifold{} : static_cast<const Manifold&>(manifolds[0]);
}

}  // namespace

void NarrowPhase::decide(std::span<const Body> bodies, const BodiesOnTheWay& on_the_way, UndecidedPairs& undecided,
                         std::span<DecidedPair> pairs, const Progress& progress) {
  const std::span<const UndecidedPair> all = undecided.pairs;
  const Chunks rows{all.size(), row_length(all.size(), options_.threads)};
  TaskReporter reporter(progress, all.size());
  parallel_for(rows.size(), options_.threads, [&](std::size_t row) {
    if (reporter.cancelled()) return;
    workspaces_.with([&](Workspace& workspace) {
      const std::span<const UndecidedPair> some = rows.of(all, row);
      WantedLasting none;
      for (std::size_t i = 0; i < some.size(); ++i) {
        if (i + ahead < some.size()) fetch(bodies[pairs[some[i + ahead].number].pair.second]);
        DecidedPair& pair = pairs[some[i].number];
        WantedLasting& lasting = undecided.lasting.empty() ? none : rows.of(std::span(undecided.lasting), row)[i];
        decide(bodies[pair.pair.first], bodies[pair.pair.second], some[i].margin, lasting, pair, workspace);
        if (!on_the_way.empty()) add_first_contact(bodies, on_the_way, pair, workspace);
        reporter.finished_one();
        if (reporter.cancelled()) return;
      }
    });
  });
}

void NarrowPhase::decide(const Body& a, const Body& b, double margin, WantedLasting& wanted, DecidedPair& pair,
                         Workspace& workspace) const {
  Touch touch{options_.manifold};
  pair.nearness = nearness_of(a, b, margin, wanted, touch, workspace);
  if (!tells_details(options_) || !is_told(pair.nearness)) return;
  PairDetails details = details_of(a, b, pair.nearness == BodyNearness::contact, cleared(workspace));
  details.manifolds = std::move(touch.manifolds);
  if (options_.manifold && pair.nearness == BodyNearness::contact &&
      is_defined(ShapeQuestion::manifold, a.model, b.model))
    details.manifold = plain(details.manifolds);
  pair.details = std::make_shared<const PairDetails>(std::move(details));
}

void NarrowPhase::add_first_contact(std::span<const Body> bodies, const BodiesOnTheWay& on_the_way, DecidedPair& pair,
                                    Workspace& workspace) const {
  const auto [first, second] = pair.pair;
  const Body &a = bodies[first], &b = bodies[second];
  if ((!on_the_way.contains(first) && !on_the_way.contains(second)) || !has_first_contact(a, b)) return;
  const std::optional<ShapeHit> hit =
      sweep(a.model, motion_of(first, bodies, on_the_way), b.model, motion_of(second, bodies, on_the_way),
            {.solid_a = a.solid, .solid_b = b.solid}, cleared(workspace));
  if (!hit) return;
  PairDetails details = pair.details ? *pair.details : details_of(a, b, false, cleared(workspace));
  details.first_contact = hit;
  pair.details = std::make_shared<const PairDetails>(std::move(details));
  if (pair.nearness == BodyNearness::apart) pair.nearness = BodyNearness::passed;
}

PairDetails NarrowPhase::details_of(const Body& a, const Body& b, bool in_contact, Workspace& workspace) const {
  const PairQuery query = query_of(a, b);
  PairDetails details;
  if (options_.relation) details.relation = relation(a.model, b.model, query, workspace);
  if (options_.distance) details.distance = distance(a.model, b.model, query, workspace);
  if (!in_contact) return details;
  if (options_.contacts) {
    const auto found = contacts(a.model, b.model, query, workspace);
    details.contacts.assign(found.begin(), found.end());
  }
  if (options_.penetration) {
    const Relation lie = details.relation ? *details.relation : relation(a.model, b.model, query, workspace);
    if (const auto depth = depth_where_defined(a.model, b.model, query, lie, {}, workspace))
      details.penetration = depth->penetration;
  }
  return details;
}

}  // namespace toccata
