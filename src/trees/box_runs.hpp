#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/trees/wide_bvh.hpp"
#include "trees/chunks.hpp"

namespace toccata {

/// Around a triangle of a mesh, exact.
[[nodiscard]] inline Aabb triangle_box(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles()[triangle];
  const Vec3* vertices = mesh.vertices().data();
  return merge(merge({vertices[a], vertices[a]}, vertices[b]), vertices[c]);
}

/// The boxes of items, told a run at a time whenever they are needed: those of a large mesh would together take more
/// memory than the mesh.
class BoxRuns {
 public:
  /// Fills in the boxes of the items from `first` on. May be called from several threads at once.
  using Tell = FunctionRef<void(std::size_t first, std::span<Aabb> boxes)>;

  /// Refers to `tell`.
  BoxRuns(std::size_t count, Tell tell) : count_(count), tell_(tell) {}

  [[nodiscard]] std::size_t size() const { return count_; }

  /// Calls `see(item, box)` for the items of a chunk of all.
  template <class See>
  void each(const Chunks& chunks, std::size_t chunk, const See& see) const {
    each(chunks.first(chunk), std::min(chunks.first(chunk) + chunks.piece, chunks.count), see);
  }

  /// The same for the items of [first, end).
  template <class See>
  void each(std::size_t first, std::size_t end, const See& see) const {
    std::array<Aabb, 128> run;
    for (; first < end; first += run.size()) {
      const auto boxes = std::span(run).first(std::min(run.size(), end - first));
      tell_(first, boxes);
      for (std::size_t i = 0; i < boxes.size(); ++i) see(first + i, boxes[i]);
    }
  }

 private:
  std::size_t count_;
  Tell tell_;
};

/// Builds a tree as the function over boxes does (trees/wide_bvh.hpp).
[[nodiscard]] WideBvh build_wide_bvh(const BoxRuns& boxes, const WideBuildOptions& options = {});

/// Over the boxes of the mesh's triangles.
[[nodiscard]] WideBvh build_wide_bvh(const TriangleMesh& mesh, const WideBuildOptions& options = {});

}  // namespace toccata
