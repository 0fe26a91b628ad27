#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>

#include "narrow/triangles/triangle_pair_block.hpp"
#include "query/contacts/self_intersection.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "query/search_scratch.hpp"
#include "toccata/bounds/aabb.hpp"
#include "trees/wide_walk.hpp"

// What is done with the pairs of triangles that a walk over two posed meshes finds: they are decided in blocks.

namespace toccata {

/// The lanes of a set of bits, ascending, until `see` returns false; says whether it never did.
template <class See>
bool each_lane(unsigned bits, const See& see) {
  for (; bits != 0; bits &= bits - 1)
    if (!see(static_cast<std::size_t>(std::countr_zero(bits)))) return false;
  return true;
}

/// Comparisons alone tell it. Coordinates near the greatest double overflow wherever they are subtracted: then nothing
/// else is left that tells pairs apart without exact arithmetic, neither in trees nor in blocks.
inline bool boxes_meet(const Triangle& a, const Triangle& b) { return overlap(fit_aabb(a.vertex), fit_aabb(b.vertex)); }

/// How a pair is decided that plain arithmetic leaves open: two triangles of two meshes.
struct OfTwoMeshes {
  static constexpr bool one_mesh = false;
  static bool meet(const Triangle& a, const Triangle& b) { return boxes_meet(a, b) && overlap(a, b); }
  static Intersection intersection_of(const Triangle& a, const Triangle& b) {
    return boxes_meet(a, b) ? intersect(a, b) : Intersection{};
  }
};

/// The same for two triangles of one mesh. What plain arithmetic decides is in general position, or neighbours that
/// have nothing in common but what they share.
struct OfOneMesh {
  static constexpr bool one_mesh = true;
  static bool meet(const Triangle& a, const Triangle& b) { return boxes_meet(a, b) && self_meet(a, b); }
  static Intersection intersection_of(const Triangle& a, const Triangle& b) {
    return boxes_meet(a, b) ? self_intersection(a, b) : Intersection{};
  }
};

template <class Kind>
bool lane_meets(const TrianglePairBlock& block, std::size_t lane) {
  return (block.intersection >> lane & 1U) != 0 || Kind::meet(triangle_a(block, lane), triangle_b(block, lane));
}

/// What the visitors below share.
class PairVisitor : public WideVisitor {
 public:
  PairVisitor(const PosedMesh& a, const PosedMesh& b, SearchPart& part, bool one_mesh)
      : a_(a), b_(b), mesh_a_(a.model().mesh()), mesh_b_(b.model().mesh()), one_mesh_(one_mesh), blocks_(part.blocks) {}

  [[nodiscard]] bool has_regions() const final { return !one_mesh_; }
  [[nodiscard]] WideProbe region_of(std::size_t side, Index triangle) final;

 protected:
  ~PairVisitor() = default;

  using Blocks = std::span<const TrianglePairBlock>;

  /// Decides the pairs, as many at once as there are blocks for, and calls `look(blocks, pairs)` with each such part
  /// until it returns false; says whether it never did. Pair i is in lane i % 8 of block i / 8.
  template <class Look>
  bool decide(std::span<const ItemPair> pairs, const Look& look) {
    constexpr std::size_t at_once = TrianglePairBlock::lanes * std::tuple_size_v<decltype(SearchPart::blocks)>;
    // Triangles and vertices lie anywhere in memory: where there are many, all are asked for before their turn comes.
    if (pairs.size() > at_once) ask_for_triangles(pairs);
    while (!pairs.empty()) {
      const auto part = pairs.first(std::min(at_once, pairs.size()));
      pairs = pairs.subspan(part.size());
      ask_for_vertices(pairs.first(std::min(at_once, pairs.size())));
      if (!look(classified(part), part)) return false;
    }
    return true;
  }

  /// Decides the pairs and calls `see(block, lane, pair)` with those that are not certainly apart until it returns
  /// false; says whether it never did.
  template <class See>
  bool each_not_apart(std::span<const ItemPair> pairs, const See& see) {
    return decide(pairs, [&](Blocks blocks, std::span<const ItemPair> part) {
      for (std::size_t i = 0; i < blocks.size(); ++i) {
        const auto of_block = part.subspan(i * TrianglePairBlock::lanes);
        if (!each_lane(blocks[i].intersection | blocks[i].unknown,
                       [&](std::size_t lane) { return see(blocks[i], lane, of_block[lane]); }))
          return false;
      }
      return true;
    });
  }

  const PosedMesh& a_;
  const PosedMesh& b_;

 private:
  void ask_for_triangles(std::span<const ItemPair> pairs) const;
  void ask_for_vertices(std::span<const ItemPair> pairs) const;

  /// Writes the pairs into the blocks and decides them.
  Blocks classified(std::span<const ItemPair> pairs);

  const TriangleMesh& mesh_a_;
  const TriangleMesh& mesh_b_;
  bool one_mesh_;

  std::span<TrianglePairBlock> blocks_;
};

/// Does any pair meet? Ends at the first.
template <class Kind>
class AnyIntersection final : public PairVisitor {
 public:
  AnyIntersection(const PosedMesh& a, const PosedMesh& b, SearchPart& part) : PairVisitor(a, b, part, Kind::one_mesh) {}
  bool visit(std::span<const ItemPair> pairs) override {
    found = !decide(pairs, [](Blocks blocks, auto) { return !known_to_meet(blocks) && none_meets(blocks); });
    return !found;
  }

  bool found = false;

 private:
  static bool known_to_meet(Blocks blocks) {
    return std::any_of(blocks.begin(), blocks.end(), [](const auto& block) { return block.intersection != 0; });
  }
  static bool none_meets(Blocks blocks) {
    return std::all_of(blocks.begin(), blocks.end(), [](const TrianglePairBlock& block) {
      return each_lane(block.unknown, [&](std::size_t lane) { return !lane_meets<Kind>(block, lane); });
    });
  }
};

/// The first pair of two meshes that is found to meet. Whether plain arithmetic or exact told so does not show in it.
class FirstIntersection final : public PairVisitor {
 public:
  FirstIntersection(const PosedMesh& a, const PosedMesh& b, SearchPart& part)
      : PairVisitor(a, b, part, OfTwoMeshes::one_mesh) {}
  bool visit(std::span<const ItemPair> pairs) override {
    return each_not_apart(pairs, [&](const TrianglePairBlock& block, std::size_t lane, const ItemPair& pair) {
      if (lane_meets<OfTwoMeshes>(block, lane)) found = pair;
      return !found;
    });
  }

  std::optional<ItemPair> found;
};

/// The least pair of two meshes that meets.
class LeastIntersection final : public PairVisitor {
 public:
  LeastIntersection(const PosedMesh& a, const PosedMesh& b, SearchPart& part)
      : PairVisitor(a, b, part, OfTwoMeshes::one_mesh) {}
  bool visit(std::span<const ItemPair> pairs) override {
    return each_not_apart(pairs, [&](const TrianglePairBlock& block, std::size_t lane, const ItemPair& pair) {
      if ((!least || pair < *least) && lane_meets<OfTwoMeshes>(block, lane)) least = pair;
      return true;
    });
  }

  std::optional<ItemPair> least;
};

/// Adds every pair that meets to what the part found.
template <class Kind>
class Collector final : public PairVisitor {
 public:
  Collector(const PosedMesh& a, const PosedMesh& b, SearchPart& part)
      : PairVisitor(a, b, part, Kind::one_mesh), found_(part.found) {}
  bool visit(std::span<const ItemPair> pairs) override {
    return each_not_apart(pairs, [&](const TrianglePairBlock& block, std::size_t lane, const ItemPair& pair) {
      if ((block.intersection >> lane & 1U) != 0)
        found_.add(pair, &intersection_in(block, lane));
      else
        decide_exactly(block, lane, pair);
      return true;
    });
  }

 private:
  void decide_exactly(const TrianglePairBlock& block, std::size_t lane, const ItemPair& pair) {
    const Intersection common = Kind::intersection_of(triangle_a(block, lane), triangle_b(block, lane));
    if (common.kind != IntersectionKind::none) found_.add(pair, found_.intersections.keep(common));
  }

  FoundPairs& found_;
};

}  // namespace toccata
