#include "toccata/query/self_contacts.hpp"

#include <utility>

#include "query/meshes/pair_search.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "query/scenes/posed_name.hpp"
#include "query/scenes/task_reporter.hpp"
#include "query/workspace_pool.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

std::vector<Contact> contacts_in(const PosedMesh& mesh, Workspace& workspace) {
  const auto found = self_contacts(mesh, workspace.scratch());
  return {found.begin(), found.end()};
}

}  // namespace

std::vector<Contact> self_contacts(const Model& model, const Pose& pose) {
  Workspace workspace;
  static_cast<void>(self_contacts(model, pose, workspace));
  return std::move(workspace.scratch().contacts);
}

std::span<const Contact> self_contacts(const Model& model, const Pose& pose, Workspace& workspace) {
  return self_contacts(PosedMesh(model, pose), workspace.scratch());
}

bool self_overlap(const Model& model, const Pose& pose) {
  Workspace workspace;
  return self_overlap(model, pose, workspace);
}

bool self_overlap(const Model& model, const Pose& pose, Workspace& workspace) {
  return intersects_itself(PosedMesh(model, pose), workspace.scratch());
}

std::vector<std::vector<Contact>> self_contacts_each(std::span<const SceneInstance> models,
                                                     const BatchOptions& options) {
  std::vector<std::vector<Contact>> found(models.size());
  TaskReporter reporter(options.progress, models.size());
  WorkspacePool workspaces;
  parallel_for(models.size(), options.threads, [&](std::size_t i) {
    if (reporter.cancelled()) return;
    if (std::holds_alternative<Compound>(models[i].model.shape()))
      throw Error(name_for_messages(models[i], i) +
                  ": a compound is not asked where it intersects itself; make objects of its parts");
    if (models[i].model.has_mesh())
      found[i] = workspaces.with([&](Workspace& workspace) {
        return contacts_in(PosedMesh(models[i].model, models[i].pose, name_for_messages(models[i], i)), workspace);
      });
    reporter.finished_one();
  });
  return found;
}

}  // namespace toccata
