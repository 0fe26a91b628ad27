#include "query/manifolds/contact_element.hpp"

#include "query/contacts/part_contacts.hpp"

namespace toccata {

ContactElement::ContactElement(const PosedModel& model, Index element)
    : number_(element), part_(posed_element(model, element)) {
  for (auto part = model.parts.rbegin(); part != model.parts.rend(); ++part) {
    if (part->first_element > element) continue;
    if (const auto* triangles = std::get_if<PosedTriangles>(&part->shape))
      around_.emplace(*triangles, element - part->first_element);
    return;
  }
}

}  // namespace toccata
