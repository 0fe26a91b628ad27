#include "toccata/query/self_contacts.hpp"

#include <utility>

#include "query/pair_search.hpp"
#include "query/posed_mesh.hpp"
#include "query/posed_name.hpp"
#include "query/task_reporter.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

std::vector<Contact> contacts_in(const PosedMesh& mesh) {
  SearchScratch scratch;
  static_cast<void>(self_contacts(mesh, scratch));
  return std::move(scratch.contacts);
}

}  // namespace

std::vector<Contact> self_contacts(const Model& model, const Pose& pose) { return contacts_in(PosedMesh(model, pose)); }

bool self_overlap(const Model& model, const Pose& pose) {
  SearchScratch scratch;
  return meets_itself(PosedMesh(model, pose), scratch);
}

std::vector<std::vector<Contact>> self_contacts_each(std::span<const Posed> models, const BatchOptions& options) {
  std::vector<std::vector<Contact>> found(models.size());
  TaskReporter reporter(options.progress, models.size());
  parallel_for(models.size(), options.threads, [&](std::size_t i) {
    if (reporter.cancelled()) return;
    if (std::holds_alternative<Compound>(models[i].model.shape()))
      throw Error(name_for_messages(models[i], i) +
                  ": a compound is not asked where it meets itself; make objects of its parts");
    if (models[i].model.has_mesh())
      found[i] = contacts_in(PosedMesh(models[i].model, models[i].pose, name_for_messages(models[i], i)));
    reporter.finished_one();
  });
  return found;
}

}  // namespace toccata
