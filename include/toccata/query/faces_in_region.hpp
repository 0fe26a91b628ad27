#pragma once

#include <span>
#include <variant>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/bounds/ball.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// A closed world box, which may be flat, or a closed world ball, of which the radius may be 0.
using Region = std::variant<Aabb, Ball>;

/// Something of a model that has a point in common with a region.
struct FoundElement {
  Index element = 0;  ///< see Model; the triangle of a mesh
  Index face = 0;     ///< the file's own face, counted from 0
  friend constexpr bool operator==(const FoundElement&, const FoundElement&) = default;
};

/// All elements of the posed model that have a point in common with the region, touching included, ascending. Exact, as
/// `overlap` is; nothing is left out. A mesh is asked about by its triangles, whether it is closed or not: a region
/// deep inside of it finds none. Throws Error when the box or ball is empty or not finite, and for poses as `overlap`
/// does.
[[nodiscard]] std::vector<FoundElement> faces_in_region(const Region& region, const Model& model,
                                                        const Pose& pose = {});

/// The same, for a caller who asks often. What is found lies in the workspace until it is used again.
[[nodiscard]] std::span<const FoundElement> faces_in_region(const Region& region, const Model& model, const Pose& pose,
                                                            Workspace& workspace);

/// The faces of what was found, each once and ascending: a face of a file that was cut into triangles is one.
[[nodiscard]] std::vector<Index> distinct_faces(std::span<const FoundElement> found);

/// A question for `faces_in_region`.
struct RegionQuery {
  Region region;
  Pose pose{};
};

/// `faces_in_region` of each, as in batch.hpp.
[[nodiscard]] std::vector<std::vector<FoundElement>> faces_in_region_each(std::span<const RegionQuery> queries,
                                                                          const Model& model,
                                                                          const BatchOptions& options = {});

}  // namespace toccata
