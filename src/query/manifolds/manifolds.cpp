#include "toccata/query/manifolds.hpp"

#include <optional>

#include "query/ask.hpp"
#include "query/contacts/part_contacts.hpp"
#include "query/manifolds/limited_manifold.hpp"
#include "query/manifolds/merged_manifolds.hpp"
#include "query/manifolds/model_manifolds.hpp"
#include "query/penetration/solid_penetration.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {
namespace {

bool is_part_without_end(const PosedPart& part) { return std::holds_alternative<PosedHalfSpace>(part.shape); }

std::vector<ModelManifold> as_list(const Manifold& manifold) {
  if (manifold.count == 0) return {};
  return {{manifold}};
}

/// Of two posed models, by their contacts.
class ManifoldsOfContacts {
 public:
  ManifoldsOfContacts(const PosedModel& a, const PosedModel& b, SearchScratch& scratch)
      : a_(a), b_(b), scratch_(scratch) {}

  std::vector<ModelManifold> found() {
    // Manifolds of elements leave the contacts in the scratch alone.
    for (const Contact& contact : contacts_of(a_, b_, scratch_, 1)) add(contact);
    if (merged_.is_empty() && nobody_else_.manifold.count > 0)
      merged_.add(nobody_else_.manifold, nobody_else_.element_a, nobody_else_.element_b);
    return merged_.merged();
  }

 private:
  /// The least deep contact of those that left it to others, where there are none.
  struct Alone {
    Manifold manifold;
    double depth = 0;
    Index element_a = 0;
    Index element_b = 0;
  };

  const ContactElement& element(std::optional<ContactElement>& last, const PosedModel& model, Index number) const {
    if (!last || last->number() != number) last.emplace(model, number);
    return *last;
  }

  void add(const Contact& contact) {
    const ContactElement& a = element(last_a_, a_, contact.triangle_a);
    const ContactElement& b = element(last_b_, b_, contact.triangle_b);
    if (is_part_without_end(a.part()) || is_part_without_end(b.part())) return add_over_half_space(a, b);
    const LimitedManifold limited = limited_manifold(a, b, scratch_);
    if (limited.manifold.count > 0) return merged_.add(limited.manifold, a.number(), b.number());
    if (limited.alone.count == 0 || (nobody_else_.manifold.count > 0 && limited.depth_alone >= nobody_else_.depth))
      return;
    nobody_else_ = {limited.alone, limited.depth_alone, a.number(), b.number()};
  }

  /// Whose normal is that of the contact.
  void add_over_half_space(const ContactElement& a, const ContactElement& b) {
    if (is_part_without_end(a.part()) && is_part_without_end(b.part())) return;
    const Manifold manifold = manifold_of(a.part(), b.part(), scratch_);
    if (manifold.count > 0) merged_.add(manifold, a.number(), b.number());
  }

  const PosedModel& a_;
  const PosedModel& b_;
  SearchScratch& scratch_;
  std::optional<ContactElement> last_a_;
  std::optional<ContactElement> last_b_;
  MergedManifolds merged_;
  Alone nobody_else_;
};

/// Of two models of which one lies wholly within the other.
std::vector<ModelManifold> of_contained(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  const Relation lie = relation(a, b, query, workspace);
  if (lie.kind == RelationKind::apart) return {};
  constexpr double precision = 0.1;
  const auto depth = depth_where_defined(a, b, query, lie, {.precision = precision}, workspace);
  if (!depth || !(depth->penetration.upper > 0)) return {};
  const Penetration& deep = depth->penetration;
  ModelManifold one;
  one.normal = deep.direction;
  one.points[0] = {deep.on_a + 0.5 * (deep.on_b - deep.on_a), deep.upper, {}, {}};
  one.count = 1;
  return {one};
}

}  // namespace

std::vector<ModelManifold> manifolds_of(const Model& a, const Model& b, const PairQuery& query, bool in_contact,
                                        Workspace& workspace) {
  if (is_defined(ShapeQuestion::manifold, a, b)) return as_list(manifold(a, b, query, workspace));
  SearchScratch& scratch = workspace.scratch();
  {
    const PosedModelPair models(a, b, query, scratch);
    if (models.are_single() && is_part_without_end(models.a.parts[0]) && is_part_without_end(models.b.parts[0])) return {};
    std::vector<ModelManifold> found = ManifoldsOfContacts(models.a, models.b, scratch).found();
    if (!found.empty()) return found;
  }
  scratch.convex = {};
  if (!in_contact && !overlap(a, b, query, workspace)) return {};
  return of_contained(a, b, query, workspace);
}

std::vector<ModelManifold> manifolds(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  return manifolds_of(a, b, query, false, workspace);
}

std::vector<ModelManifold> manifolds(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return manifolds(a, b, query, workspace);
}

}  // namespace toccata
