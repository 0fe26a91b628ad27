#include "toccata/query/contacts.hpp"

#include <utility>

#include "query/ask.hpp"
#include "query/contacts/part_contacts.hpp"
#include "query/meshes/pair_search.hpp"
#include "query/posed_mesh_pair.hpp"

namespace toccata {

std::vector<Contact> contacts(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  const auto found = contacts(a, b, query, workspace);
  // Those of two meshes are many, and need not be copied.
  if (a.has_mesh() && b.has_mesh()) return std::move(workspace.scratch().contacts);
  return {found.begin(), found.end()};
}

std::span<const Contact> contacts(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  if (a.has_mesh() && b.has_mesh()) {
    const PosedMeshPair pair(a, b, query);
    return surface_contacts(pair.a, pair.b, workspace.scratch(), query.threads);
  }
  const PosedModelPair models(a, b, query, workspace.scratch());
  return contacts_of(models.a, models.b, workspace.scratch(), query.threads);
}

std::optional<Contact> first_contact(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return first_contact(a, b, query, workspace);
}

std::optional<Contact> first_contact(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  if (a.has_mesh() && b.has_mesh()) {
    const PosedMeshPair pair(a, b, query);
    return first_surface_contact(pair.a, pair.b, workspace.scratch());
  }
  const auto all = contacts(a, b, query, workspace);
  if (all.empty()) return std::nullopt;
  return all.front();
}

Triangle world_triangle(const Model& model, const Pose& pose, Index triangle) {
  if (const auto* single = std::get_if<Triangle>(&model.shape()); single != nullptr && triangle == 0)
    return {{transform(pose, (*single)[0]), transform(pose, (*single)[1]), transform(pose, (*single)[2])}};
  Index first = 0;
  for (std::size_t i = 0; i < model.parts().size(); ++i) {
    const Model& part = model.parts()[i];
    const Index count = part.element_count();
    if (triangle - first < count)
      return world_triangle(part, pose * std::get<Compound>(model.shape()).parts()[i].pose, triangle - first);
    first += count;
  }
  const auto vertices = model.mesh().vertices();
  const auto& corner = model.mesh().triangles()[triangle];
  return {{transform(pose, vertices[corner[0]]), transform(pose, vertices[corner[1]]),
           transform(pose, vertices[corner[2]])}};
}

}  // namespace toccata
