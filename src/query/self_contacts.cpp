#include "toccata/query/self_contacts.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "query/pair_cull.hpp"
#include "query/posed_mesh.hpp"
#include "query/posed_name.hpp"
#include "query/self_meeting.hpp"
#include "query/task_reporter.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {
namespace {

bool boxes_meet(const Triangle& a, const Triangle& b) { return overlap(box_of(a), box_of(b)); }

class SelfSearch {
 public:
  explicit SelfSearch(const PosedMesh& mesh) : mesh_(mesh), cull_(mesh, mesh) {}

  double bound(const Aabb& a, const Aabb& b) const {
    return cull_.disjoint(a, b) ? std::numeric_limits<double>::infinity() : 0;
  }

 protected:
  const PosedMesh& mesh_;

 private:
  PairCull cull_;
};

class AnySelfMeeting : public SelfSearch {
 public:
  using SelfSearch::SelfSearch;
  double limit() const { return found ? -1 : 0; }
  void visit(std::span<const ItemPair> pairs) {
    found = std::any_of(pairs.begin(), pairs.end(), [&](const ItemPair& pair) {
      const Triangle a = mesh_.triangle(pair.first), b = mesh_.triangle(pair.second);
      return boxes_meet(a, b) && self_meet(a, b);
    });
  }

  bool found = false;
};

class EachSelfMeeting : public SelfSearch {
 public:
  using SelfSearch::SelfSearch;
  double limit() const { return 0; }
  void visit(std::span<const ItemPair> pairs) {
    const TriangleMesh& shape = mesh_.model().mesh();
    for (const auto& [first, second] : pairs) {
      const Triangle a = mesh_.triangle(first), b = mesh_.triangle(second);
      if (!boxes_meet(a, b)) continue;
      const Meeting common = self_meeting(a, b);
      if (common.kind == MeetingKind::none) continue;
      found.push_back({first, second, shape.face_of(first), shape.face_of(second), common});
    }
  }

  std::vector<Contact> found;
};

/// What the search finds among all two triangles of the mesh that could meet: the lesser number first, each pair once.
template <class Search>
auto found_in(const PosedMesh& mesh) {
  Search search(mesh);
  walk_self(mesh.model().tree(), search);
  return std::move(search.found);
}

std::vector<Contact> contacts_in(const PosedMesh& mesh) {
  std::vector<Contact> found = found_in<EachSelfMeeting>(mesh);
  std::sort(found.begin(), found.end(), [](const Contact& x, const Contact& y) {
    return std::pair(x.triangle_a, x.triangle_b) < std::pair(y.triangle_a, y.triangle_b);
  });
  return found;
}

}  // namespace

std::vector<Contact> self_contacts(const Model& model, const Pose& pose) { return contacts_in(PosedMesh(model, pose)); }

bool self_overlap(const Model& model, const Pose& pose) { return found_in<AnySelfMeeting>(PosedMesh(model, pose)); }

std::vector<std::vector<Contact>> self_contacts_each(std::span<const Posed> models, const BatchOptions& options) {
  std::vector<std::vector<Contact>> found(models.size());
  TaskReporter reporter(options.progress, models.size());
  parallel_for(models.size(), options.threads, [&](std::size_t i) {
    if (reporter.cancelled()) return;
    found[i] = contacts_in(PosedMesh(models[i].model, models[i].pose, name_for_messages(models[i], i)));
    reporter.finished_one();
  });
  return found;
}

}  // namespace toccata
