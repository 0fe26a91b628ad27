#include "toccata/query/contacts.hpp"

#include <utility>

#include "query/pair_search.hpp"
#include "query/posed_pair.hpp"

namespace toccata {

std::vector<Contact> contacts(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  static_cast<void>(contacts(a, b, query, workspace));
  return std::move(workspace.scratch().contacts);
}

std::span<const Contact> contacts(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  const PosedPair pair(a, b, query);
  return surface_contacts(pair.a, pair.b, workspace.scratch(), query.threads);
}

std::optional<Contact> first_contact(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return first_contact(a, b, query, workspace);
}

std::optional<Contact> first_contact(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  const PosedPair pair(a, b, query);
  return first_surface_contact(pair.a, pair.b, workspace.scratch());
}

Triangle world_triangle(const Model& model, const Pose& pose, Index triangle) {
  const auto vertices = model.mesh().vertices();
  const auto& corner = model.mesh().triangles()[triangle];
  return {{transform(pose, vertices[corner[0]]), transform(pose, vertices[corner[1]]),
           transform(pose, vertices[corner[2]])}};
}

}  // namespace toccata
