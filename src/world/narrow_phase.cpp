#include "world/narrow_phase.hpp"

#include "query/ask_each.hpp"
#include "query/penetration/solid_penetration.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/query/closer_than.hpp"
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

bool is_defined(ShapeQuestion question, const Body& a, const Body& b) {
  return pair_cell(question, kind_of(a.model.shape()), kind_of(b.model.shape())).state == PairState::defined;
}

bool has_penetration(const Body& a, const Body& b, const Relation& relation) {
  return relation.a_solid && relation.b_solid && is_defined(ShapeQuestion::penetration, a, b) &&
         may_be_parted(pose_model(a.model, a.pose, a.solid, "a"), pose_model(b.model, b.pose, b.solid, "b"));
}

}  // namespace

void NarrowPhase::decide(std::span<const Body> bodies, std::span<const UndecidedPair> undecided,
                         std::span<DecidedPair> pairs) {
  const Chunks rows{undecided.size(), row_length(undecided.size(), options_.threads)};
  parallel_for(rows.size(), options_.threads, [&](std::size_t row) {
    workspaces_.with([&](Workspace& workspace) {
      for (const UndecidedPair& one : rows.of(undecided, row)) {
        DecidedPair& pair = pairs[one.number];
        decide(bodies[pair.pair.first], bodies[pair.pair.second], one.margin, pair, workspace);
      }
    });
  });
}

void NarrowPhase::decide(const Body& a, const Body& b, double margin, DecidedPair& pair, Workspace& workspace) const {
  const PairQuery query = query_of(a, b);
  if (margin > 0 && !closer_than(a.model, b.model, margin, query, cleared(workspace))) {
    pair.nearness = Nearness::apart;
    return;
  }
  const bool in_contact = overlap(a.model, b.model, query, cleared(workspace));
  pair.nearness = in_contact ? Nearness::contact : margin > 0 ? Nearness::near : Nearness::apart;
  const bool is_asked =
      options_.relation || options_.distance || options_.contacts || options_.manifold || options_.penetration;
  if (is_asked && pair.nearness != Nearness::apart)
    pair.details = std::make_shared<const PairDetails>(details_of(a, b, in_contact, cleared(workspace)));
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
  if (options_.manifold && is_defined(ShapeQuestion::manifold, a, b))
    details.manifold = manifold(a.model, b.model, query, workspace);
  if (options_.penetration) {
    const Relation lie = details.relation ? *details.relation : relation(a.model, b.model, query, workspace);
    if (has_penetration(a, b, lie)) details.penetration = penetration(a.model, b.model, query, workspace);
  }
  return details;
}

}  // namespace toccata
