#include "query/pair_search.hpp"

#include <algorithm>
#include <bit>
#include <tuple>
#include <utility>

#include "query/pair_cull.hpp"
#include "query/wide_cull.hpp"
#include "toccata/core/parallel.hpp"
#include "trees/wide_walk.hpp"

namespace toccata {
namespace {

bool comes_before(const Contact& x, const Contact& y) {
  return std::pair(x.triangle_a, x.triangle_b) < std::pair(y.triangle_a, y.triangle_b);
}

void put_local(const TriangleMesh& mesh, Index triangle, std::size_t lane, TrianglePairBlock::Corners& corners) {
  const std::span<const Vec3> vertices = mesh.vertices();
  const auto& corner = mesh.triangles()[triangle];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& v = vertices[corner[i]];
    corners[i][0][lane] = v.x;
    corners[i][1][lane] = v.y;
    corners[i][2][lane] = v.z;
  }
}

/// What the searches below share: the pairs that a walk finds, by places in the item orders of the two trees, are
/// decided in blocks.
class PairVisitor : public WideVisitor {
 public:
  PairVisitor(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch)
      : a_(a), b_(b), mesh_a_(a.model().mesh()), mesh_b_(b.model().mesh()), blocks_(scratch.blocks) {}

 protected:
  ~PairVisitor() = default;

  [[nodiscard]] Contact contact_of(const ItemPair& pair, const Meeting& meeting) const {
    return {pair.first, pair.second, mesh_a_.face_of(pair.first), mesh_b_.face_of(pair.second), meeting};
  }

  /// Decides the pairs, as many at once as there are blocks for, and calls `look(blocks, pairs)` with each such part
  /// until it returns false; says whether it never did. Pair i is in lane i % 8 of block i / 8.
  template <class Look>
  bool decide(std::span<const ItemPair> pairs, const Look& look) {
    constexpr std::size_t at_once = TrianglePairBlock::lanes * std::tuple_size_v<decltype(SearchScratch::blocks)>;
    for (; !pairs.empty(); pairs = pairs.subspan(std::min(at_once, pairs.size()))) {
      const auto part = pairs.first(std::min(at_once, pairs.size()));
      if (!look(classified(part), part)) return false;
    }
    return true;
  }

  const PosedMesh& a_;
  const PosedMesh& b_;

 private:
  std::span<const TrianglePairBlock> classified(std::span<const ItemPair> pairs) {
    constexpr std::size_t lanes = TrianglePairBlock::lanes;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      put_local(mesh_a_, pairs[i].first, i % lanes, blocks_[i / lanes].a);
      put_local(mesh_b_, pairs[i].second, i % lanes, blocks_[i / lanes].b);
    }
    const auto used = blocks_.first((pairs.size() + lanes - 1) / lanes);
    for (TrianglePairBlock& block : used) block.count = lanes;
    used.back().count = pairs.size() - (used.size() - 1) * lanes;
    classify_pairs(a_.pose(), b_.pose(), used);
    return used;
  }

  const TriangleMesh& mesh_a_;
  const TriangleMesh& mesh_b_;
  std::span<TrianglePairBlock> blocks_;
};

/// The lanes of a set of bits, ascending, until `see` returns false; says whether it never did.
template <class See>
bool each_lane(unsigned bits, const See& see) {
  for (; bits != 0; bits &= bits - 1)
    if (!see(static_cast<std::size_t>(std::countr_zero(bits)))) return false;
  return true;
}

bool lane_meets(const TrianglePairBlock& block, std::size_t lane) {
  return (block.meeting >> lane & 1U) != 0 || overlap(triangle_a(block, lane), triangle_b(block, lane));
}

class AnyMeeting final : public PairVisitor {
 public:
  using PairVisitor::PairVisitor;
  bool visit(std::span<const ItemPair> pairs) override {
    found = !decide(pairs, [](std::span<const TrianglePairBlock> blocks, auto) {
      const bool known =
          std::any_of(blocks.begin(), blocks.end(), [](const auto& block) { return block.meeting != 0; });
      return !known && std::all_of(blocks.begin(), blocks.end(), [](const TrianglePairBlock& block) {
        return each_lane(block.unknown, [&](std::size_t lane) { return !lane_meets(block, lane); });
      });
    });
    return !found;
  }

  bool found = false;
};

class LeastMeeting final : public PairVisitor {
 public:
  using PairVisitor::PairVisitor;
  bool visit(std::span<const ItemPair> pairs) override {
    return decide(pairs, [&](std::span<const TrianglePairBlock> blocks, std::span<const ItemPair> part) {
      for (std::size_t i = 0; i < blocks.size(); ++i)
        each_lane(blocks[i].meeting | blocks[i].unknown, [&](std::size_t lane) {
          const ItemPair& pair = part[i * TrianglePairBlock::lanes + lane];
          if ((!least || pair < *least) && lane_meets(blocks[i], lane)) least = pair;
          return true;
        });
      return true;
    });
  }
  [[nodiscard]] std::optional<Contact> contact() const {
    if (!least) return std::nullopt;
    return contact_of(*least, meeting(a_.triangle(least->first), b_.triangle(least->second)));
  }

  std::optional<ItemPair> least;
};

template <class See>
class EachMeeting final : public PairVisitor {
 public:
  EachMeeting(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch, const See& see)
      : PairVisitor(a, b, scratch), see_(see) {}
  bool visit(std::span<const ItemPair> pairs) override {
    return decide(pairs, [&](std::span<const TrianglePairBlock> blocks, std::span<const ItemPair> part) {
      for (std::size_t i = 0; i < blocks.size(); ++i)
        if (!each_lane(blocks[i].meeting | blocks[i].unknown, [&](std::size_t lane) {
              return see_lane(blocks[i], lane, part[i * TrianglePairBlock::lanes + lane]);
            }))
          return false;
      return true;
    });
  }

 private:
  bool see_lane(const TrianglePairBlock& block, std::size_t lane, const ItemPair& pair) {
    if ((block.meeting >> lane & 1U) != 0) return see_(contact_of(pair, meeting_in(block, lane)));
    const Meeting common = meeting(triangle_a(block, lane), triangle_b(block, lane));
    return common.kind == MeetingKind::none || see_(contact_of(pair, common));
  }

  const See& see_;
};

/// A walk over two posed meshes with its constants.
class MeshWalk {
 public:
  MeshWalk(const PosedMesh& a, const PosedMesh& b)
      : cull_(wide_cull(PairCull(a, b), a, b)), walk_(a.model().wide_tree(), b.model().wide_tree(), cull_) {}

  [[nodiscard]] const WideWalk* operator->() const { return &walk_; }

 private:
  WideCull cull_;
  WideWalk walk_;
};

// A yes or no is often settled by the first pairs that are found.
constexpr std::size_t small_batch = 8;

void run(const PosedMesh& a, const PosedMesh& b, std::size_t first_batch, SearchScratch& scratch,
         WideVisitor& visitor) {
  scratch.counts = {};
  if (!overlap(a.box(), b.box())) return;
  const MeshWalk walk(a, b);
  walk->start(scratch.frontier, first_batch);
  walk->run(scratch.frontier, visitor);
  scratch.counts = scratch.frontier.counts;
}

}  // namespace

bool surfaces_meet(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  AnyMeeting any(a, b, scratch);
  run(a, b, small_batch, scratch, any);
  return any.found;
}

bool surfaces_meet(const PosedMesh& a, const PosedMesh& b) {
  SearchScratch scratch;
  return surfaces_meet(a, b, scratch);
}

void visit_surface_contacts(const PosedMesh& a, const PosedMesh& b, const std::function<bool(const Contact&)>& see) {
  SearchScratch scratch;
  EachMeeting each(a, b, scratch, see);
  run(a, b, small_batch, scratch, each);
}

std::span<const Contact> surface_contacts(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch, int) {
  scratch.contacts.clear();
  const auto keep = [&](const Contact& contact) {
    scratch.contacts.push_back(contact);
    return true;
  };
  EachMeeting each(a, b, scratch, keep);
  run(a, b, WideWalk::largest_batch, scratch, each);
  std::sort(scratch.contacts.begin(), scratch.contacts.end(), comes_before);
  return scratch.contacts;
}

std::vector<Contact> surface_contacts(const PosedMesh& a, const PosedMesh& b) {
  SearchScratch scratch;
  static_cast<void>(surface_contacts(a, b, scratch));
  return std::move(scratch.contacts);
}

std::optional<Contact> first_surface_contact(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  LeastMeeting least(a, b, scratch);
  run(a, b, WideWalk::largest_batch, scratch, least);
  return least.contact();
}

}  // namespace toccata
