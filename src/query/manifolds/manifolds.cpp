#include "toccata/query/manifolds.hpp"

#include <algorithm>
#include <optional>
#include <utility>

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

/// Something may lie within it without touching the surface of a mesh.
bool may_hold(const PosedModel& model) {
  return std::ranges::any_of(model.parts, [](const PosedPart& part) {
    const auto* triangles = std::get_if<PosedTriangles>(&part.shape);
    return triangles && triangles->solid;
  });
}

std::vector<ModelManifold> as_list(const Manifold& manifold) {
  if (manifold.count == 0) return {};
  return {{manifold}};
}

/// The manifolds of two posed models, by their contacts.
class ManifoldsOfContacts {
 public:
  ManifoldsOfContacts(const PosedModel& a, const PosedModel& b, SearchScratch& scratch)
      : a_(a), b_(b), scratch_(scratch) {}

  MetManifolds found() {
    // Manifolds of elements leave the contacts in the scratch alone.
    const std::span<const Contact> contacts = contacts_of(a_, b_, scratch_, 1);
    for (const Contact& contact : contacts) add(contact);
    if (merged_.is_empty()) add_least_deep(contacts);
    return {!contacts.empty(), merged_.merged()};
  }

 private:
  const ContactElement& element(std::optional<ContactElement>& last, const PosedModel& model, Index number) const {
    if (!last || last->number() != number) last.emplace(model, number);
    return *last;
  }

  void add(const Contact& contact) {
    const ContactElement& a = element(last_a_, a_, contact.element_a);
    const ContactElement& b = element(last_b_, b_, contact.element_b);
    if (is_part_without_end(a.part()) || is_part_without_end(b.part())) return add_over_half_space(a, b);
    const Manifold manifold = limited_manifold(a, b, scratch_);
    if (manifold.count > 0) merged_.add(manifold, a.number(), b.number());
  }

  /// All contacts left it to others, and there are none.
  void add_least_deep(std::span<const Contact> contacts) {
    LoneContact least;
    Contact of;
    for (const Contact& contact : contacts) {
      const ContactElement& a = element(last_a_, a_, contact.element_a);
      const ContactElement& b = element(last_b_, b_, contact.element_b);
      if (is_part_without_end(a.part()) && is_part_without_end(b.part())) continue;
      const LoneContact lone = lone_contact(a, b, scratch_);
      if (lone.manifold.count == 0 || (least.manifold.count > 0 && lone.depth >= least.depth)) continue;
      least = lone;
      of = contact;
    }
    if (least.manifold.count > 0) merged_.add(least.manifold, of.element_a, of.element_b);
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
};

/// The manifolds of two models of which one lies wholly within the other.
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

MetManifolds manifolds_where_met(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  if (is_defined(ShapeQuestion::manifold, a, b)) {
    std::vector<ModelManifold> found = as_list(manifold(a, b, query, workspace));
    return {!found.empty(), std::move(found)};
  }
  SearchScratch& scratch = workspace.scratch();
  {
    const PosedModelPair models(a, b, query, scratch);
    MetManifolds found = ManifoldsOfContacts(models.a, models.b, scratch).found();
    if (found.in_contact || (!may_hold(models.a) && !may_hold(models.b))) return found;
  }
  scratch.convex = {};
  if (!overlap(a, b, query, workspace)) return {};
  return {true, of_contained(a, b, query, workspace)};
}

std::vector<ModelManifold> manifolds(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  return manifolds_where_met(a, b, query, workspace).manifolds;
}

std::vector<ModelManifold> manifolds(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return manifolds(a, b, query, workspace);
}

}  // namespace toccata
