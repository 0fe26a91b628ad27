#pragma once

#include <optional>
#include <span>
#include <vector>

#include "query/meshes/posed_mesh.hpp"
#include "query/search_scratch.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata {

// The questions about the surfaces of two posed meshes, whatever they are taken for.

/// Some triangle of `a` meets some triangle of `b`. Stops at the first found.
[[nodiscard]] bool surfaces_meet(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch);

/// Calls `see` with all pairs of triangles that meet, in no particular but always the same order; ends early when it
/// returns false.
void visit_surface_contacts(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch,
                            FunctionRef<bool(const Contact&)> see);

/// All pairs of triangles that meet, ascending; they lie in the scratch. On up to `threads` threads (0: as many as the
/// machine has), which change nothing else.
[[nodiscard]] std::span<const Contact> surface_contacts(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch,
                                                        int threads = own_thread);
[[nodiscard]] std::vector<Contact> surface_contacts(const PosedMesh& a, const PosedMesh& b);

/// The two triangles of one of them: the first that is found, always the same, at the cost of `surfaces_meet`.
[[nodiscard]] std::optional<ItemPair> some_surface_contact(const PosedMesh& a, const PosedMesh& b,
                                                           SearchScratch& scratch);

/// The least of them.
[[nodiscard]] std::optional<Contact> first_surface_contact(const PosedMesh& a, const PosedMesh& b,
                                                           SearchScratch& scratch);

/// Some two triangles of one mesh have more in common than what they share (query/contacts/self_intersection.hpp).
[[nodiscard]] bool intersects_itself(const PosedMesh& mesh, SearchScratch& scratch);

/// All such pairs, the lesser triangle first, ascending; they lie in the scratch.
[[nodiscard]] std::span<const Contact> self_contacts(const PosedMesh& mesh, SearchScratch& scratch);

}  // namespace toccata
