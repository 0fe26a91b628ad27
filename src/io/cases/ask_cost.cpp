#include "io/cases/ask_cost.hpp"

#include <fmt/format.h>

#include "toccata/core/error.hpp"

namespace toccata::io {
namespace {

const TriangleMesh& mesh_of(const SceneInstance& posed) {
  if (!posed.model.has_mesh())
    throw Error(fmt::format("'{}' is a {}; costs are measured of meshes", posed.name, name_of(posed.model.shape())));
  return posed.model.mesh();
}

}  // namespace

CostReport ask_cost(std::span<const SceneInstance> models, const CostQuestion& question, const Progress& progress) {
  if (models.size() != 2)
    throw Error(fmt::format("costs are measured of two meshes; here {} {}: name two files of one mesh each",
                            models.size() == 1 ? "is" : "are", models.size()));
  CostOptions options = question.options;
  options.progress = progress;
  return {measure_costs(mesh_of(models[0]), mesh_of(models[1]), question.queries, options), question};
}

}  // namespace toccata::io
