#pragma once

#include <vector>

#include "toccata/narrow/flipped.hpp"
#include "toccata/query/contacts.hpp"

// Contacts of (A, B) as those of (B, A).
namespace toccata {

[[nodiscard]] inline Contact flipped(const Contact& c) {
  return {c.triangle_b, c.triangle_a, c.face_b, c.face_a, flipped(c.intersection)};
}

/// In their order; sort them anew.
[[nodiscard]] inline std::vector<Contact> flipped(std::vector<Contact> contacts) {
  for (Contact& contact : contacts) contact = flipped(contact);
  return contacts;
}

}  // namespace toccata
