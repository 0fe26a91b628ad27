#pragma once

#include <optional>

#include "toccata/query/casts.hpp"

namespace toccata {

/// What `cast_shape` tells of a hit; nothing where there is none, and perhaps nothing of one that is later than `limit`
/// of the way (0 to 1).
[[nodiscard]] std::optional<ShapeHit> cast_until(const Model& a, const Vec3& motion, const Model& b,
                                                 const PairQuery& query, double limit, Workspace& workspace);

}  // namespace toccata
