#pragma once

#include <span>
#include <vector>

#include "toccata/math/pose.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata {

// Where a mesh intersects itself: two of its world triangles that have more in common than the hull of the world
// vertices that they share, or that have the same vertices (docs/truth.md). Sharing is decided by coordinates: numbers
// of vertices do not matter, so a soup of triangles is answered like a welded mesh. Exact. The mesh may be open or
// closed, a solid or not. Throws Error when the pose or a world vertex is not finite, and for a model that is no mesh.

/// All pairs of triangles in which the posed model intersects itself, ascending by (element_a, element_b); element_a
/// is the lesser. The intersection is all that the two have in common, also what they share.
[[nodiscard]] std::vector<Contact> self_contacts(const Model& model, const Pose& pose = {});

/// The same, for a caller who asks often. The contacts lie in the workspace until it is used again.
[[nodiscard]] std::span<const Contact> self_contacts(const Model& model, const Pose& pose, Workspace& workspace);

/// Whether there is any.
[[nodiscard]] bool self_overlap(const Model& model, const Pose& pose = {});
[[nodiscard]] bool self_overlap(const Model& model, const Pose& pose, Workspace& workspace);

/// `self_contacts` of each of the posed models; none for convex shapes and half-spaces, which do not meet themselves.
/// An Error names the model; a compound is one: ask its parts.
[[nodiscard]] std::vector<std::vector<Contact>> self_contacts_each(std::span<const SceneInstance> models,
                                                                   const BatchOptions& options = {});

}  // namespace toccata
