#include "query/pair_search.hpp"

#include <algorithm>
#include <bit>
#include <tuple>
#include <utility>

#include "query/pair_cull.hpp"
#include "query/self_meeting.hpp"
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

/// What the searches below share: the pairs that a walk finds are decided in blocks.
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

/// How a pair is decided that plain arithmetic leaves open: two triangles of two meshes.
struct OfTwoMeshes {
  static bool meet(const Triangle& a, const Triangle& b) { return overlap(a, b); }
  static Meeting meeting_of(const Triangle& a, const Triangle& b) { return meeting(a, b); }
};

/// The same for two triangles of one mesh. What plain arithmetic decides is in general position: nothing is shared.
struct OfOneMesh {
  static bool meet(const Triangle& a, const Triangle& b) { return self_meet(a, b); }
  static Meeting meeting_of(const Triangle& a, const Triangle& b) { return self_meeting(a, b); }
};

template <class Kind>
bool lane_meets(const TrianglePairBlock& block, std::size_t lane) {
  return (block.meeting >> lane & 1U) != 0 || Kind::meet(triangle_a(block, lane), triangle_b(block, lane));
}

template <class Kind>
class AnyMeeting final : public PairVisitor {
 public:
  using PairVisitor::PairVisitor;
  bool visit(std::span<const ItemPair> pairs) override {
    found = !decide(pairs, [](std::span<const TrianglePairBlock> blocks, auto) {
      const bool known =
          std::any_of(blocks.begin(), blocks.end(), [](const auto& block) { return block.meeting != 0; });
      return !known && std::all_of(blocks.begin(), blocks.end(), [](const TrianglePairBlock& block) {
        return each_lane(block.unknown, [&](std::size_t lane) { return !lane_meets<Kind>(block, lane); });
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
          if ((!least || pair < *least) && lane_meets<OfTwoMeshes>(blocks[i], lane)) least = pair;
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

template <class Kind, class See>
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
    const Meeting common = Kind::meeting_of(triangle_a(block, lane), triangle_b(block, lane));
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

void run_self(const PosedMesh& mesh, std::size_t first_batch, SearchScratch& scratch, WideVisitor& visitor) {
  const MeshWalk walk(mesh, mesh);
  walk->run_self(scratch.frontier, first_batch, visitor);
  scratch.counts = scratch.frontier.counts;
}

/// Keeps contacts in a scratch.
template <class Kind>
class Collector {
 public:
  Collector(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch)
      : keep_{scratch.contacts}, each_(a, b, scratch, keep_) {
    scratch.contacts.clear();
  }
  Collector(const Collector&) = delete;
  Collector& operator=(const Collector&) = delete;

  WideVisitor& visitor() { return each_; }

 private:
  struct Keep {
    std::vector<Contact>& contacts;
    bool operator()(const Contact& contact) const {
      contacts.push_back(contact);
      return true;
    }
  };
  Keep keep_;
  EachMeeting<Kind, Keep> each_;
};

/// A search that is spread over threads begins breadth first with so many entries, which are then shared out. Neither
/// number depends on the threads, nor does what is found.
constexpr std::size_t spread_entries = 1024;
constexpr std::size_t part_count = 32;

/// Entry i of the frontier goes to part i % part_count: neighbours take about as long.
void deal_out(const WideFrontier& from, std::size_t part, WideFrontier& to) {
  to.blocks.clear();
  to.boxes.clear();
  to.blocks.reserve(from.size / part_count + 1);
  to.boxes.reserve(from.size / part_count + 1);
  for (std::size_t i = part; i < from.size; i += part_count) {
    to.blocks.push_back(from.blocks[i]);
    to.boxes.push_back(from.boxes[i]);
  }
  to.size = to.blocks.size();
}

void run_part(const PosedMesh& a, const PosedMesh& b, const MeshWalk& walk, std::size_t part, const WideFrontier& from,
              SearchScratch& scratch) {
  Collector<OfTwoMeshes> collector(a, b, scratch);
  walk->start(scratch.frontier, WideWalk::largest_batch);
  deal_out(from, part, scratch.frontier);
  walk->run(scratch.frontier, collector.visitor());
}

void collect_on_threads(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch, int threads) {
  scratch.counts = {};
  scratch.contacts.clear();
  if (!overlap(a.box(), b.box())) return;
  const MeshWalk walk(a, b);
  Collector<OfTwoMeshes> first(a, b, scratch);
  walk->start(scratch.frontier, WideWalk::largest_batch);
  walk->spread(scratch.frontier, spread_entries, first.visitor());
  scratch.parts.resize(part_count);
  parallel_for(part_count, threads, [&](std::size_t part) {
    if (!scratch.parts[part]) scratch.parts[part] = std::make_unique<SearchScratch>();
    run_part(a, b, walk, part, scratch.frontier, *scratch.parts[part]);
  });
  scratch.counts = scratch.frontier.counts;
  for (const auto& part : scratch.parts) {
    scratch.contacts.insert(scratch.contacts.end(), part->contacts.begin(), part->contacts.end());
    scratch.counts.volume_tests += part->frontier.counts.volume_tests;
    scratch.counts.items += part->frontier.counts.items;
  }
}

}  // namespace

bool surfaces_meet(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  AnyMeeting<OfTwoMeshes> any(a, b, scratch);
  run(a, b, small_batch, scratch, any);
  return any.found;
}

void visit_surface_contacts(const PosedMesh& a, const PosedMesh& b, const std::function<bool(const Contact&)>& see) {
  SearchScratch scratch;
  EachMeeting<OfTwoMeshes, std::function<bool(const Contact&)>> each(a, b, scratch, see);
  run(a, b, small_batch, scratch, each);
}

std::span<const Contact> surface_contacts(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch, int threads) {
  if (threads == 1)
    run(a, b, WideWalk::largest_batch, scratch, Collector<OfTwoMeshes>(a, b, scratch).visitor());
  else
    collect_on_threads(a, b, scratch, threads);
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

bool meets_itself(const PosedMesh& mesh, SearchScratch& scratch) {
  AnyMeeting<OfOneMesh> any(mesh, mesh, scratch);
  run_self(mesh, small_batch, scratch, any);
  return any.found;
}

std::span<const Contact> self_contacts(const PosedMesh& mesh, SearchScratch& scratch) {
  run_self(mesh, WideWalk::largest_batch, scratch, Collector<OfOneMesh>(mesh, mesh, scratch).visitor());
  std::sort(scratch.contacts.begin(), scratch.contacts.end(), comes_before);
  return scratch.contacts;
}

}  // namespace toccata
