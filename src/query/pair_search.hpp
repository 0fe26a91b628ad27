#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "query/posed_mesh.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata {

// The questions about the surfaces of two posed meshes, whatever they are taken for.

/// Some triangle of `a` meets some triangle of `b`. Stops at the first found.
[[nodiscard]] bool surfaces_meet(const PosedMesh& a, const PosedMesh& b);

/// Calls `see` with all pairs of triangles that meet, in no particular but always the same order; ends early when it
/// returns false.
void visit_surface_contacts(const PosedMesh& a, const PosedMesh& b, const std::function<bool(const Contact&)>& see);

/// All pairs of triangles that meet, ascending.
[[nodiscard]] std::vector<Contact> surface_contacts(const PosedMesh& a, const PosedMesh& b);

/// The least of them.
[[nodiscard]] std::optional<Contact> first_surface_contact(const PosedMesh& a, const PosedMesh& b);

}  // namespace toccata
