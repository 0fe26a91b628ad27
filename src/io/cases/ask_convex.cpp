#include "io/cases/ask_convex.hpp"

#include <fmt/format.h>

#include <type_traits>

#include "io/cases/asked_of.hpp"
#include "toccata/core/error.hpp"

namespace toccata::io {
namespace {

/// The hull that a mesh stands for.
ConvexHull hull_of(const TriangleMesh& mesh, bool of_any) {
  if (of_any) return ConvexHull(mesh.vertices());
  try {
    return hull_of_convex_mesh(mesh);
  } catch (const Error& error) {
    throw Error(fmt::format("{}; --hull takes its convex hull (MinkowskiQuestion::hulls)", error.what()));
  }
}

/// Keeps the hull that a posed shape refers to.
class Operand {
 public:
  Operand(const SceneInstance& posed, bool hull_of_any)
      : posed_(asked_of(posed.name, [&] { return convex_of(posed, hull_of_any); })) {}
  Operand(const Operand&) = delete;
  Operand& operator=(const Operand&) = delete;
  [[nodiscard]] const PosedPolytope& convex() const { return posed_; }

 private:
  [[nodiscard]] PosedPolytope convex_of(const SceneInstance& posed, bool hull_of_any) {
    if (const auto mesh = mesh_of(posed.model.shape())) {
      hull_ = hull_of(*mesh, hull_of_any);
      return PosedPolytope(*hull_, posed.pose);
    }
    return std::visit(
        [&](const auto& shape) -> PosedPolytope {
          if constexpr (std::is_constructible_v<PosedPolytope, decltype(shape), const Pose&>)
            return PosedPolytope(shape, posed.pose);
          else
            throw Error(fmt::format("a {} has no sum here; give bounded convex shapes, or a mesh",
                                    name_of(posed.model.shape())));
        },
        posed.model.shape());
  }

  std::optional<ConvexHull> hull_;
  PosedPolytope posed_;
};

/// As the pose places it: what is asked and told of it is in the world.
Model model_in_world(const SceneInstance& posed) {
  if (!posed.model.has_mesh() || posed.pose == Pose{}) return posed.model;
  const TriangleMesh& mesh = posed.model.mesh();
  return Model(std::make_shared<const TriangleMesh>(mesh.with_vertices(transform(posed.pose, mesh.vertices()))));
}

const char* is_or_are(std::size_t count) { return count == 1 ? "is" : "are"; }

}  // namespace

DecomposeReport ask_decompose(std::span<const SceneInstance> models, const DecomposeQuestion& question,
                              const AskOptions& options) {
  if (models.size() != 1)
    throw Error(fmt::format("one closed mesh is cut into convex parts; here {} {} objects: name one file, of one mesh",
                            is_or_are(models.size()), models.size()));
  const SceneInstance& posed = models[0];
  return asked_of(posed.name, [&] {
    return DecomposeReport{posed.name, Pose{},
                           decompose(model_in_world(posed), {.max_parts = question.max_parts,
                                                             .concavity = question.concavity,
                                                             .threads = options.threads,
                                                             .progress = options.progress})};
  });
}

MinkowskiReport ask_minkowski(std::span<const SceneInstance> models, const MinkowskiQuestion& question) {
  if (models.size() != 2)
    throw Error(fmt::format("a sum is of two objects, A and B; here {} {}", is_or_are(models.size()), models.size()));
  const Operand a(models[0], question.hulls), b(models[1], question.hulls);
  return {question, models[0].name, models[1].name,
          question.difference ? minkowski_difference(a.convex(), b.convex()) : minkowski_sum(a.convex(), b.convex())};
}

}  // namespace toccata::io
