#include "query/meshes/pair_search.hpp"

#include <algorithm>
#include <utility>

#include "query/contacts/contact_order.hpp"
#include "query/meshes/mesh_walk.hpp"
#include "query/meshes/pair_visitors.hpp"
#include "query/meshes/spread_search.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

// A yes or no is often settled by the first pairs that are found.
constexpr std::size_t small_batch = 8;

/// Whether the turned boxes of the wholes show that the two are apart, as they do for most pairs that are, before
/// anything is made ready for a walk.
bool are_told_apart(const PairCull& cull, const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  if (!cull.disjoint(a.model().wide_bvh().box, b.model().wide_bvh().box)) return false;
  scratch.counts.volume_tests = 1;
  return true;
}

void run(const PosedMesh& a, const PosedMesh& b, std::size_t first_batch, SearchScratch& scratch,
         WideVisitor& visitor) {
  scratch.counts = {};
  if (!overlap(a.box(), b.box())) return;
  const PairCull cull(a, b);
  if (are_told_apart(cull, a, b, scratch)) return;
  const WideCull constants = wide_cull(cull, a, b);
  const WideWalk walk(a.model().wide_bvh(), b.model().wide_bvh(), constants);
  WideFrontier& frontier = scratch.main->frontier;
  walk.start(frontier, first_batch);
  walk.run(frontier, visitor);
  scratch.counts = frontier.counts;
}

void run_self(const PosedMesh& mesh, std::size_t first_batch, SearchScratch& scratch, WideVisitor& visitor) {
  const MeshWalk walk(mesh, mesh);
  walk->run_self(scratch.main->frontier, first_batch, visitor);
  scratch.counts = scratch.main->frontier.counts;
}

/// Shows the contacts of every batch until `see` returns false.
class ContactsSeen final : public WideVisitor {
 public:
  ContactsSeen(const PosedMesh& a, const PosedMesh& b, SearchPart& part, FunctionRef<bool(const Contact&)> see)
      : a_(a), b_(b), found_(part.found), collect_(a, b, part), see_(see) {}
  bool visit(std::span<const ItemPair> pairs) override {
    found_.clear();
    return collect_.visit(pairs) && std::all_of(found_.pairs.begin(), found_.pairs.end(),
                                                [&](const FoundPair& pair) { return see_(contact_of(a_, b_, pair)); });
  }
  [[nodiscard]] bool has_regions() const override { return collect_.has_regions(); }
  [[nodiscard]] WideProbe region_of(std::size_t side, Index triangle) override {
    return collect_.region_of(side, triangle);
  }

 private:
  const PosedMesh& a_;
  const PosedMesh& b_;
  FoundPairs& found_;
  Collector<OfTwoMeshes> collect_;
  FunctionRef<bool(const Contact&)> see_;
};

void forget_found(SearchScratch& scratch) {
  scratch.main->found.clear();
  for (const auto& part : scratch.others) part->found.clear();
}

}  // namespace

bool surfaces_meet(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  AnyIntersection<OfTwoMeshes> any(a, b, *scratch.main);
  run(a, b, small_batch, scratch, any);
  return any.found;
}

void visit_surface_contacts(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch,
                            FunctionRef<bool(const Contact&)> see) {
  ContactsSeen seen(a, b, *scratch.main, see);
  run(a, b, small_batch, scratch, seen);
}

std::span<const Contact> surface_contacts(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch, int threads) {
  forget_found(scratch);
  if (threads == 1) {
    Collector<OfTwoMeshes> collect(a, b, *scratch.main);
    run(a, b, WideWalk::largest_batch, scratch, collect);
    order_contacts(a, b, scratch, threads);
  } else {
    on_threads(threads, [&] {
      scratch.counts = {};
      if (!overlap(a.box(), b.box()) || !are_told_apart(PairCull(a, b), a, b, scratch))
        find_on_threads(a, b, scratch, threads);
      order_contacts(a, b, scratch, threads);
    });
  }
  return scratch.contacts;
}

std::vector<Contact> surface_contacts(const PosedMesh& a, const PosedMesh& b) {
  SearchScratch scratch;
  static_cast<void>(surface_contacts(a, b, scratch));
  return std::move(scratch.contacts);
}

std::optional<ItemPair> some_surface_contact(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  FirstIntersection first(a, b, *scratch.main);
  run(a, b, small_batch, scratch, first);
  return first.found;
}

std::optional<Contact> first_surface_contact(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  LeastIntersection least(a, b, *scratch.main);
  run(a, b, WideWalk::largest_batch, scratch, least);
  if (!least.least) return std::nullopt;
  const auto [first, second] = *least.least;
  const Intersection common = intersect(a.triangle(first), b.triangle(second));
  return contact_of(a, b, {number_of(*least.least), &common});
}

bool intersects_itself(const PosedMesh& mesh, SearchScratch& scratch) {
  AnyIntersection<OfOneMesh> any(mesh, mesh, *scratch.main);
  run_self(mesh, small_batch, scratch, any);
  return any.found;
}

std::span<const Contact> self_contacts(const PosedMesh& mesh, SearchScratch& scratch) {
  forget_found(scratch);
  Collector<OfOneMesh> collect(mesh, mesh, *scratch.main);
  run_self(mesh, WideWalk::largest_batch, scratch, collect);
  order_contacts(mesh, mesh, scratch, 1);
  return scratch.contacts;
}

}  // namespace toccata
