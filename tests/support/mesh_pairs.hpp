#pragma once

#include <string>
#include <vector>

#include "toccata/query/contacts.hpp"

namespace toccata::test {

/// The contacts by testing every pair of world triangles whose boxes overlap. No tree, no culling.
std::vector<Contact> contacts_by_brute_force(const Model& a, const Model& b, const PairQuery& query);

PairQuery exchanged(const PairQuery& query);

/// The same triangles, faces and meetings, in the same order.
bool same(const std::vector<Contact>& x, const std::vector<Contact>& y);

/// What is wrong with overlap, first_contact and contacts of two surfaces, both ways round, compared with brute force;
/// empty when nothing is.
std::string fault_of_surface_queries(const Model& a, const Model& b, const PairQuery& query);

}  // namespace toccata::test
