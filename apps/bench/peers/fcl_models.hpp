#pragma once

#include <fcl/geometry/bvh/BVH_model.h>

#include <memory>
#include <vector>

#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::bench {

template <class Volume>
std::unique_ptr<fcl::BVHModel<Volume>> fcl_model_of(const TriangleMesh& mesh) {
  std::vector<fcl::Vector3d> vertices;
  std::vector<fcl::Triangle> triangles;
  for (const Vec3& v : mesh.vertices()) vertices.emplace_back(v.x, v.y, v.z);
  for (const auto& corner : mesh.triangles()) triangles.emplace_back(corner[0], corner[1], corner[2]);
  auto model = std::make_unique<fcl::BVHModel<Volume>>();
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size()));
  model->addSubModel(vertices, triangles);
  model->endModel();
  return model;
}

}  // namespace toccata::bench
