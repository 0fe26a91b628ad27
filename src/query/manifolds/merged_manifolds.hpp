#pragma once

#include <vector>

#include "toccata/query/manifolds.hpp"

namespace toccata {

/// Manifolds of elements, of which those with one normal become one: up to four of their points stand for all.
class MergedManifolds {
 public:
  void add(const Manifold& manifold, Index element_a, Index element_b);

  [[nodiscard]] bool is_empty() const { return groups_.empty(); }

  /// In the order in which their first elements were added.
  [[nodiscard]] std::vector<ModelManifold> merged() const;

 private:
  struct Point {
    ManifoldPoint point;
    Index element_a;
    Index element_b;
  };
  struct Group {
    Vec3 normal;
    std::vector<Point> points;
    std::size_t manifolds = 0;
  };

  [[nodiscard]] static ModelManifold told(const Group& group);
  [[nodiscard]] static std::vector<Point> few_of(const Group& group);

  std::vector<Group> groups_;
};

}  // namespace toccata
