#include "toccata/query/contacts.hpp"

#include "query/pair_search.hpp"
#include "query/posed_pair.hpp"

namespace toccata {

std::vector<Contact> contacts(const Model& a, const Model& b, const PairQuery& query) {
  const PosedPair pair(a, b, query);
  return surface_contacts(pair.a, pair.b);
}

std::optional<Contact> first_contact(const Model& a, const Model& b, const PairQuery& query) {
  const PosedPair pair(a, b, query);
  SearchScratch scratch;
  return first_surface_contact(pair.a, pair.b, scratch);
}

Triangle world_triangle(const Model& model, const Pose& pose, Index triangle) {
  const auto vertices = model.mesh().vertices();
  const auto& corner = model.mesh().triangles()[triangle];
  return {{transform(pose, vertices[corner[0]]), transform(pose, vertices[corner[1]]),
           transform(pose, vertices[corner[2]])}};
}

}  // namespace toccata
