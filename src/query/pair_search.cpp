#include "query/pair_search.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "query/pair_cull.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {
namespace {

constexpr double disjoint_cost = std::numeric_limits<double>::infinity();

bool boxes_meet(const Triangle& a, const Triangle& b) { return overlap(box_of(a), box_of(b)); }

bool triangles_meet(const Triangle& a, const Triangle& b) { return boxes_meet(a, b) && overlap(a, b); }

auto place(const Contact& contact) { return std::pair(contact.triangle_a, contact.triangle_b); }

/// What the searches below share: two posed meshes, and when two nodes are of interest.
class PairSearch {
 public:
  PairSearch(const PosedMesh& a, const PosedMesh& b) : a_(a), b_(b), cull_(a, b) {}

  double bound(const Aabb& a, const Aabb& b) const { return cull_.disjoint(a, b) ? disjoint_cost : 0; }
  bool split_first(const Aabb& a, const Aabb& b) const { return cull_.a_is_larger(a, b); }

 protected:
  Contact contact_of(const ItemPair& pair, const Meeting& meeting) const {
    return {pair.first, pair.second, a_.model().mesh().face_of(pair.first), b_.model().mesh().face_of(pair.second),
            meeting};
  }

  const PosedMesh& a_;
  const PosedMesh& b_;

 private:
  PairCull cull_;
};

class AnyMeeting : public PairSearch {
 public:
  using PairSearch::PairSearch;
  double limit() const { return found ? -1 : 0; }
  void visit(std::span<const ItemPair> pairs) {
    found = std::any_of(pairs.begin(), pairs.end(), [&](const ItemPair& pair) {
      return triangles_meet(a_.triangle(pair.first), b_.triangle(pair.second));
    });
  }

  bool found = false;
};

class LeastMeeting : public PairSearch {
 public:
  using PairSearch::PairSearch;
  double limit() const { return 0; }
  void visit(std::span<const ItemPair> pairs) {
    for (const ItemPair& pair : pairs)
      if ((!least || pair < *least) && triangles_meet(a_.triangle(pair.first), b_.triangle(pair.second))) least = pair;
  }
  std::optional<Contact> contact() const {
    if (!least) return std::nullopt;
    return contact_of(*least, meeting(a_.triangle(least->first), b_.triangle(least->second)));
  }

  std::optional<ItemPair> least;
};

class EachMeeting : public PairSearch {
 public:
  EachMeeting(const PosedMesh& a, const PosedMesh& b, const std::function<bool(const Contact&)>& see)
      : PairSearch(a, b), see_(see) {}
  double limit() const { return ended_ ? -1 : 0; }
  void visit(std::span<const ItemPair> pairs) {
    for (const ItemPair& pair : pairs) {
      const Triangle a = a_.triangle(pair.first), b = b_.triangle(pair.second);
      if (!boxes_meet(a, b)) continue;
      const Meeting common = meeting(a, b);
      if (common.kind == MeetingKind::none) continue;
      ended_ = !see_(contact_of(pair, common));
      if (ended_) return;
    }
  }

 private:
  const std::function<bool(const Contact&)>& see_;
  bool ended_ = false;
};

template <class Search>
void run(Search& question, const PosedMesh& a, const PosedMesh& b) {
  if (overlap(a.box(), b.box())) walk_pair(a.model().tree(), b.model().tree(), question);
}

template <class Search>
Search search(const PosedMesh& a, const PosedMesh& b) {
  Search question(a, b);
  run(question, a, b);
  return question;
}

}  // namespace

bool surfaces_meet(const PosedMesh& a, const PosedMesh& b) { return search<AnyMeeting>(a, b).found; }

void visit_surface_contacts(const PosedMesh& a, const PosedMesh& b, const std::function<bool(const Contact&)>& see) {
  EachMeeting question(a, b, see);
  run(question, a, b);
}

std::vector<Contact> surface_contacts(const PosedMesh& a, const PosedMesh& b) {
  std::vector<Contact> found;
  visit_surface_contacts(a, b, [&](const Contact& contact) {
    found.push_back(contact);
    return true;
  });
  std::sort(found.begin(), found.end(), [](const Contact& x, const Contact& y) { return place(x) < place(y); });
  return found;
}

std::optional<Contact> first_surface_contact(const PosedMesh& a, const PosedMesh& b) {
  return search<LeastMeeting>(a, b).contact();
}

}  // namespace toccata
