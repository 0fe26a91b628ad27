#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/convex.hpp"
#include "query/relation/hull_mesh.hpp"
#include "support/convex_cases.hpp"
#include "support/mesh_pairs.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/relation.hpp"

// What the answers about two models have to be, of which one is a mesh, a height field or a compound.
namespace toccata::test {

inline Model model_of(const ConvexShape& shape) {
  return std::visit([](const auto& given) { return Model(given); }, shape);
}

inline RelationKind kind_of(oracle::RelationKind kind) { return static_cast<RelationKind>(kind); }
inline Containment containment_of(oracle::Containment c) { return static_cast<Containment>(c); }

/// What is wrong with the answers about the models, compared with the oracle's relation; empty when nothing is.
inline std::string fault_of(const Model& a, const Model& b, const PairQuery& query, const oracle::Relation& truth) {
  const Relation found = relation(a, b, query);
  if (found.kind != kind_of(truth.kind)) return "relation";
  if (found.containment != containment_of(truth.containment)) return "containment";
  if (found.side_unresolved != truth.side_unresolved) return "side_unresolved";
  if (found.status != Status::exact) return "status";
  if (!(relation(b, a, exchanged(query)) == flipped(found))) return "relation, exchanged";
  const bool meets = truth.kind != oracle::RelationKind::apart;
  if (overlap(a, b, query) != meets || overlap(b, a, exchanged(query)) != meets) return "overlap";
  const std::vector<Contact> list = contacts(a, b, query);
  if (!list.empty() && !meets) return "contacts";
  if (meets && list.empty() && truth.containment == oracle::Containment::none) return "no contacts";
  return "";
}

/// The shape as the mesh of its hull, in the world; nothing where that is not the same set or not taken the same way.
inline std::optional<Model> as_mesh(const PlacedPolytope& placed) {
  const PosedPolytope shape = posed(placed);
  if (shape.radius() > 0) return std::nullopt;
  const HullMesh hull = hull_mesh(shape);
  const bool one_face = hull.mesh->triangle_count() == 1;
  if (shape.solid() ? hull.dimension != 3 : !one_face) return std::nullopt;
  return Model(hull.mesh);
}

}  // namespace toccata::test
